//! Derivation: from the checked model to its control law, equation by equation (equations.md sections 2 to 4).
//!
//! [`derive`] fills the table of a [`Law`] in the order of the recursion: the plant, the reference, then block by block
//! from the output inwards error, barrier, network, observer, damping and virtual control; last the sampled controller states, the
//! true plant and the Lyapunov function. Each file holds one part of equations.md.

pub mod error;
pub mod law;
pub mod symbol;

mod adaptation;
mod auxiliary;
mod backstepping;
mod barrier;
mod discretise;
mod exact;
mod formula;
mod lyapunov;
mod network;
mod norm;
mod observer;
mod plant;
mod rates;
mod shape;
pub(crate) mod truth;

use nsv_spec::model::Model;

use crate::casadi::Job;
use crate::ir::Program;
use error::DeriveError;
use law::Law;
use rates::{Direction, Rates};
use symbol::{Side, Symbol, Term, name, number};

/// Where partial derivatives of formulas come from.
pub trait Partials {
    /// Partials of a formula for a job, as [`crate::casadi`] describes.
    fn partials(&mut self, formula: &Program, job: &Job) -> Result<Program, crate::casadi::Error>;
}

impl Partials for crate::casadi::Provider<'_> {
    fn partials(&mut self, formula: &Program, job: &Job) -> Result<Program, crate::casadi::Error> {
        Self::partials(self, formula, job)
    }
}

/// Derives the control law of a model.
pub fn derive<'m>(model: &'m Model, partials: &mut dyn Partials) -> Result<Law<'m>, DeriveError> {
    let mut law = Law::new(model);
    law.declare_leaves();
    law.define_plant();
    law.declare_auxiliary();
    let mut rates = Rates::new(law, partials);
    rates.define_reference()?;
    for i in 1..=model.blocks.len() {
        rates.define_block(i)?;
    }
    rates.law.define_next_states();
    rates.law.define_truth();
    rates.define_generator()?;
    Ok(rates.law)
}

impl Rates<'_, '_> {
    /// y_r, k_i and their rates.
    fn define_reference(&mut self) -> Result<(), DeriveError> {
        let model = self.law.model;
        self.law.group("reference and constraints");
        self.law.define("one", "t'", number(1.0));
        let reference = Symbol::from(Term::Model(model.reference, Side::Design));
        self.law.define("y_r", "y_r(t)", reference);
        self.define_time_rate("y_r")?;
        for (i, block) in (1..).zip(&model.blocks) {
            let Some(constraint) = block.constraint else {
                continue;
            };
            let constraint = Symbol::from(Term::Model(constraint, Side::Design));
            self.law
                .define(format!("k{i}"), format!("k_{i}(t)"), constraint);
            self.define_time_rate(&format!("k{i}"))?;
        }
        Ok(())
    }

    /// `<quantity>_dot`, also where it is zero.
    fn define_time_rate(&mut self, quantity: &str) -> Result<(), DeriveError> {
        if self.rate(quantity, &Direction::time(), 1)?.is_none() {
            let shape = self
                .law
                .shape(quantity)
                .expect("invariant: signals of time are real");
            self.law.define(
                format!("{quantity}_dot"),
                format!("{quantity}'"),
                symbol::zeros(shape),
            );
        }
        Ok(())
    }

    /// Everything of block i, given the blocks outside it.
    fn define_block(&mut self, i: usize) -> Result<(), DeriveError> {
        let block = &self.law.model.blocks[i - 1];
        let law = &mut self.law;
        law.define_error(i);
        law.define_barrier(i);
        if let Some(network) = &block.network {
            law.define_network(i, network);
        }
        law.define_estimate(i, block);
        law.declare_adaptation(i, block);
        law.define_norms(i, block);
        law.define_damping(i, block);
        law.define_control(i, block);
        law.define_auxiliary_rate(i, block);
        if let Some(network) = &block.network {
            law.define_weight_rate(i, network);
        }
        law.define_observer_rate(i, block);
        law.define_adaptation_rates(i, block);
        if i < law.order() {
            law.declare_filter(i);
            law.define_filter(i, block);
            self.define_exact_command(i)?;
        } else {
            law.define_violation();
        }
        Ok(())
    }
}

impl Law<'_> {
    /// `violated`: some block's error is outside its constraint.
    fn define_violation(&mut self) {
        self.group("status");
        let blocks = (1..=self.order())
            .map(|i| format!("violated{i}"))
            .filter(|quantity| self.contains(quantity));
        let any = blocks.map(name).reduce(|a, b| Term::Or(a, b).into());
        if let Some(any) = any {
            self.define("violated", "some E_i >= pi/2 - delta", any);
        }
    }
}
