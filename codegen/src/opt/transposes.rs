//! Transposes that cancel or move outwards until they do.

use crate::ir::{Op, Program, ValueId};

use super::rewrite::rewrite_counting;

/// Removes transposes.
pub(super) fn run(program: Program) -> Program {
    rewrite_counting(program, |program, instruction, uses| match instruction.op {
        Op::Transpose(a) => match program.instruction(a).op {
            // (A^T)^T == A (exact)
            Op::Transpose(original) => Some(original),
            // (a b^T)^T == b a^T (exact: products commute), unless a b^T is computed anyway
            Op::Outer(left, right) if uses.single(a) => Some(program.push(Op::Outer(right, left))),
            _ => None,
        },
        // A^T B^T == (B A)^T (exact: the same products in the same order)
        Op::MatMul(a, b) => {
            let (a, b) = (transposed(program, a)?, transposed(program, b)?);
            let product = program.push(Op::MatMul(b, a));
            Some(program.push(Op::Transpose(product)))
        }
        // A^T + B^T == (A + B)^T, and every elementwise operator (exact)
        Op::Binary(operator, a, b) => {
            let (a, b) = (transposed(program, a)?, transposed(program, b)?);
            let result = program.binary(operator, a, b);
            Some(program.push(Op::Transpose(result)))
        }
        // f(A^T) == f(A)^T, elementwise (exact)
        Op::Apply(function, a) => {
            let a = transposed(program, a)?;
            let result = program.push(Op::Apply(function, a));
            Some(program.push(Op::Transpose(result)))
        }
        _ => None,
    })
}

/// A, for the value A^T.
fn transposed(program: &Program, id: ValueId) -> Option<ValueId> {
    match program.instruction(id).op {
        Op::Transpose(a) => Some(a),
        _ => None,
    }
}
