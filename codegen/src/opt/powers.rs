//! Small integer powers as products, which share their squares with other powers after value numbering.

use crate::ir::{Op, Operator, Program};

use super::rewrite::rewrite;

/// Largest exponent that is expanded: at most six products.
const LARGEST: u32 = 16;

/// Expands powers up to [`LARGEST`].
pub(super) fn run(program: Program) -> Program {
    rewrite(program, |program, instruction| match instruction.op {
        // x^n == its left-to-right binary powering (exact: that is its definition)
        Op::PowInt(x, n) if n <= LARGEST => Some((0..n.ilog2()).rev().fold(x, |r, bit| {
            let square = program.binary(Operator::Mul, r, r);
            if n >> bit & 1 == 1 {
                program.binary(Operator::Mul, square, x)
            } else {
                square
            }
        })),
        _ => None,
    })
}
