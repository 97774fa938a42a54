//! How a state is replaced by its next value: `place = formula;`, or for the weights of a network a call that makes no other matrix.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::expression::{Level, Names};
use crate::ir::{Op, Operator, Shape, ValueId};

/// A matrix as `A s + b c^T`.
struct ScaledPlusOuter {
    matrix: ValueId,
    factor: ValueId,
    column: ValueId,
    row: ValueId,
}

impl Names<'_> {
    /// The statement that gives a place the value.
    pub(crate) fn replacement(&self, place: &TokenStream, id: ValueId) -> TokenStream {
        match self.scaled_plus_outer(id) {
            Some(sum) if self.is_at(sum.matrix, place) => {
                let [factor, column, row] = [sum.factor, sum.column, sum.row]
                    .map(|operand| self.operand(operand).at(Level::Sum));
                if self.program.fused {
                    quote!(#place.scale_add_outer_fused(#factor, #column, #row);)
                } else {
                    quote!(#place.scale_add_outer(#factor, #column, #row);)
                }
            }
            _ => {
                let formula = self.formula(id).tokens;
                quote!(#place = #formula;)
            }
        }
    }

    /// Whether a value is the input that is kept at that place.
    fn is_at(&self, id: ValueId, place: &TokenStream) -> bool {
        match self.program.instruction(id).op {
            Op::Input(index) => self.inputs[index].to_string() == place.to_string(),
            _ => false,
        }
    }

    /// The parts of such a sum, if neither the scaled matrix nor the product has a variable.
    fn scaled_plus_outer(&self, id: ValueId) -> Option<ScaledPlusOuter> {
        let (matrix, factor, product) = match self.program.instruction(id).op {
            Op::Binary(Operator::Add, scaled, product) => match self.unnamed(scaled)? {
                Op::Binary(Operator::Mul, a, b) => (*a, *b, product),
                _ => return None,
            },
            Op::MulAdd(a, b, product) => (a, b, product),
            _ => return None,
        };
        let (matrix, factor) = match self.program.shape(matrix) {
            Shape::Scalar => (factor, matrix),
            _ => (matrix, factor),
        };
        let scaled = self.program.shape(factor) == Shape::Scalar;
        match self.unnamed(product)? {
            Op::Outer(column, row) if scaled => Some(ScaledPlusOuter {
                matrix,
                factor,
                column: *column,
                row: *row,
            }),
            _ => None,
        }
    }

    /// The operation of a value without a variable.
    fn unnamed(&self, id: ValueId) -> Option<&Op> {
        let bound = self.variables[id.0 as usize].is_some();
        (!bound).then(|| &self.program.instruction(id).op)
    }
}
