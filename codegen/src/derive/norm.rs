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
                self.define(quantity, text, Term::SpectralSquare(value).into())
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
