//! Exact derivative of a virtual control along the known dynamics (34), in place of the filter.

use std::collections::BTreeMap;

use nsv_spec::model::{Disturbance, VirtualDerivative};

use super::error::DeriveError;
use super::law::Law;
use super::observer::assemble;
use super::rates::{Direction, Rates};
use super::symbol::{matrix, name};

impl Law<'_> {
    /// `x<i>_known`: what the controller takes as the dynamics of block i < n; and `w_hat<i>_known`.
    fn define_known_flow(&mut self, i: usize) {
        let block = &self.model.blocks[i - 1];
        self.group(format!(
            "known dynamics of block {i} for the exact derivative (34)"
        ));
        let mut flow =
            name(format!("F{i}")) + name(format!("G{i}")).times(name(format!("x{}", i + 1)));
        for estimate in [format!("A_hat{i}"), format!("D_hat{i}")] {
            if self.contains(&estimate) {
                flow = flow + name(estimate);
            }
        }
        self.define(
            format!("x{i}_known"),
            format!("F_{i} + G_{i} x_{} + A_hat_{i} + D_hat_{i}", i + 1),
            flow,
        );
        if let Disturbance::Exosystem(channels) = &block.disturbance {
            let rate = matrix(&assemble(channels).m).times(name(format!("w_hat{i}")));
            self.define(format!("w_hat{i}_known"), format!("M_{i} w_hat_{i}"), rate);
        }
    }
}

impl Rates<'_, '_> {
    /// h_i = alpha_i and h_i' = alpha_i'.
    pub(super) fn define_exact_command(&mut self, i: usize) -> Result<(), DeriveError> {
        if self.law.model.controller.virtual_derivative != VirtualDerivative::Exact {
            return Ok(());
        }
        self.law.define_known_flow(i);
        let flow = self.known_flow(i);
        self.law.group(format!(
            "exact derivative of the virtual control of block {i} (34)"
        ));
        let rate = self
            .rate(&format!("alpha{i}"), &flow, 1)?
            .expect("invariant: a virtual control moves");
        self.law.define(
            format!("h{i}"),
            format!("h_{i} = alpha_{i}"),
            name(format!("alpha{i}")),
        );
        self.law.define(
            format!("h{i}_dot"),
            format!("h_{i}' = alpha_{i}', total derivative  (34)"),
            name(rate),
        );
        Ok(())
    }

    /// Along the known dynamics of blocks 1 to i. There the estimate of a compound disturbance stands still, since
    /// D_hat' = th' + S x' = 0, and that of an exosystem follows w_hat' = M w_hat.
    fn known_flow(&self, i: usize) -> Direction {
        let mut starts = BTreeMap::from([("t".to_string(), Some("one".to_string()))]);
        for (j, block) in (1..=i).zip(&self.law.model.blocks) {
            starts.insert(format!("x{j}"), Some(format!("x{j}_known")));
            match block.disturbance {
                Disturbance::None => {}
                Disturbance::Bounded(_) => drop(starts.insert(format!("D_hat{j}"), None)),
                Disturbance::Exosystem(_) => {
                    drop(starts.insert(format!("w_hat{j}"), Some(format!("w_hat{j}_known"))))
                }
            }
        }
        for state in &self.law.states {
            let rate = format!("{}_dot", state.name);
            if self.law.contains(&rate) {
                starts.insert(state.name.clone(), Some(rate));
            }
        }
        Direction {
            tag: "dot".into(),
            starts,
            straight: false,
        }
    }
}
