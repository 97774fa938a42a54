//! Shapes of symbolic expressions.

use super::law::Law;
use super::symbol::{Symbol, Term, uniform};
use crate::ir::{Shape, Type};

impl Law<'_> {
    /// Shape of an expression; `None` for a truth value. A shape that does not fit is a compiler bug and panics.
    pub fn shape_of(&self, symbol: &Symbol) -> Option<Shape> {
        let real = |symbol: &Symbol| self.shape_of(symbol).expect("invariant: a real operand");
        Some(match symbol.term() {
            Term::Name(quantity) => return self.shape(quantity),
            Term::Literal(shape, _) => *shape,
            Term::Diagonal(values) if uniform(values).is_some() => Shape::Scalar,
            Term::Diagonal(values) => Shape::Vector(values.len()),
            Term::Constant(id) => {
                let constant = &self.model.constants[id.0 as usize];
                match (constant.scalar, constant.value.cols) {
                    (true, _) => Shape::Scalar,
                    (false, 1) => Shape::Vector(constant.value.rows),
                    (false, cols) => Shape::Matrix(constant.value.rows, cols),
                }
            }
            Term::Parameter(..) => Shape::Scalar,
            Term::Model(expr, _) => return self.model.exprs.shape(*expr),
            Term::Tape(tape, output) => {
                let program = &self.tapes[tape.0].program;
                let (_, value) = program
                    .outputs
                    .iter()
                    .find(|(name, _)| name == output)
                    .expect("invariant: the tape has this output");
                match program.ty(*value) {
                    Type::Real(shape) => shape,
                    Type::Bool | Type::Ldlt(_) => return None,
                }
            }
            Term::Compare(..) | Term::Or(..) => return None,
            Term::Apply(_, a) | Term::Kernel(_, a) | Term::PowInt(a, _) | Term::Select(_, a, _) => {
                real(a)
            }
            Term::Binary(_, a, b) => match (real(a), real(b)) {
                (Shape::Scalar, other) | (other, Shape::Scalar) => other,
                (a, b) => {
                    assert_eq!(a, b, "invariant: elementwise operands agree in {symbol:?}");
                    a
                }
            },
            Term::Dot(..) | Term::SumSquares(_) | Term::SpectralSquare(_) | Term::Trace(_) => {
                Shape::Scalar
            }
            Term::Column(a, _) => Shape::Vector(rows(real(a))),
            Term::Stack(items) => Shape::Vector(items.iter().map(|item| rows(real(item))).sum()),
            Term::BlockDiagonal(blocks) => {
                let cols =
                    |block: &Option<Symbol>| block.as_ref().map_or(0, |block| columns(real(block)));
                Shape::Matrix(
                    blocks.iter().map(|(rows, _)| rows).sum(),
                    blocks.iter().map(|(_, block)| cols(block)).sum(),
                )
            }
            Term::Slice(_, _, length) => Shape::Vector(*length),
            Term::MatMul(a, b) => match (real(a), real(b)) {
                (Shape::Matrix(r, k), Shape::Vector(l)) if k == l => Shape::Vector(r),
                (Shape::Matrix(r, k), Shape::Matrix(l, c)) if k == l => Shape::Matrix(r, c),
                (a, b) => panic!("invariant: product of {a:?} and {b:?} in {symbol:?}"),
            },
            Term::Transpose(a) => match real(a) {
                Shape::Matrix(r, c) => Shape::Matrix(c, r),
                other => panic!("invariant: transpose of {other:?}"),
            },
            Term::Outer(a, b) => Shape::Matrix(rows(real(a)), rows(real(b))),
            Term::Solve(_, b) => real(b),
            Term::SingularVector(a) => match real(a) {
                Shape::Matrix(_, c) => Shape::Vector(c),
                other => panic!("invariant: singular vector of {other:?}"),
            },
            Term::Basis(block, _) | Term::BasisRate(block, ..) | Term::BasisRate2(block, ..) => {
                Shape::Vector(self.bases[block].exponents.len())
            }
        })
    }
}

/// Number of columns of an array; a vector has one.
pub(crate) fn columns(shape: Shape) -> usize {
    match shape {
        Shape::Matrix(_, cols) => cols,
        Shape::Scalar | Shape::Vector(_) => 1,
    }
}

fn rows(shape: Shape) -> usize {
    match shape {
        Shape::Scalar => 1,
        Shape::Vector(n) | Shape::Matrix(n, _) => n,
    }
}
