//! Matrix norms of the law, squared: Frobenius or spectral as the specification chooses.

use nsv_spec::model::{self, Norm};

use super::law::Law;
use super::symbol::{Symbol, Term, matrix};
use crate::ir::Shape;

impl Law<'_> {
    /// ||A||^2 of a matrix quantity, defined under a name.
    pub(super) fn define_norm_squared(
        &mut self,
        quantity: String,
        text: String,
        value: Symbol,
    ) -> Symbol {
        let shape = self.shape_of(&value);
        let one_column = matches!(shape, Some(Shape::Matrix(_, 1) | Shape::Matrix(1, _)));
        match self.model.controller.norm {
            Norm::Spectral if !one_column => {
                let direction = Symbol::from(Term::SingularVector(value.clone()));
                let direction = self.define(
                    format!("{quantity}_direction"),
                    format!("{text}: direction of largest gain"),
                    direction,
                );
                let image = self.define(
                    format!("{quantity}_image"),
                    format!("{text}: image of that direction"),
                    value.times(direction),
                );
                self.define(quantity, text, image.clone().dot(image))
            }
            _ => self.define(quantity, text, value.sum_squares()),
        }
    }

    /// ||A||^2 of a constant matrix.
    pub(super) fn constant_norm_squared(
        &mut self,
        quantity: String,
        text: String,
        value: &model::Matrix,
    ) -> Symbol {
        self.define_norm_squared(quantity, text, matrix(value))
    }
}
