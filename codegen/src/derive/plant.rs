//! The plant as the controller knows it: F_i, G_i, H_i with design parameters (11).

use nsv_spec::model::Disturbance;

use super::law::Law;
use super::symbol::{Side, Symbol, Term};
use super::truth::TRUTH;
use crate::ir::Shape;

impl Law<'_> {
    /// Leaves: time, block states, exosystem states.
    pub(super) fn declare_leaves(&mut self) {
        let width = self.width();
        self.leaves.insert("t".into(), Shape::Scalar);
        if self.truth_states() > 0 {
            (self.leaves).insert(TRUTH.into(), Shape::Vector(self.truth_states()));
        }
        for (i, block) in (1..).zip(&self.model.blocks) {
            self.leaves.insert(format!("x{i}"), Shape::Vector(width));
            if let Disturbance::Exosystem(channels) = &block.disturbance {
                let states = channels.iter().map(|channel| channel.m.rows).sum();
                self.leaves.insert(format!("w{i}"), Shape::Vector(states));
            }
        }
    }

    /// Known drift, gain and noise effectiveness of every block.
    pub(super) fn define_plant(&mut self) {
        for (i, block) in (1..).zip(&self.model.blocks) {
            self.group(format!("known dynamics of block {i} ({}) (11)", block.name));
            let model = |expr| Symbol::from(Term::Model(expr, Side::Design));
            self.define(
                format!("F{i}"),
                format!("F_{i}(x_1 .. x_{i})"),
                model(block.drift),
            );
            self.define(
                format!("G{i}"),
                format!("G_{i}(x_1 .. x_{i})"),
                model(block.gain),
            );
            if let Some(noise) = &block.noise {
                self.define(
                    format!("H{i}"),
                    format!("H_{i}(x_1 .. x_{i})"),
                    model(noise.effectiveness),
                );
            }
        }
    }
}
