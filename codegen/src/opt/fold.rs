//! Constant folding: an operation on literals becomes the literal that [`crate::ir::eval`] gives, so that folding cannot change a bit.

use crate::ir::eval::{Tables, entries};
use crate::ir::{Program, Type};

use super::rewrite::{is_leaf, literal, rewrite};

/// Folds operations on literals, except those whose result is not finite (such a value shows where it arises, at run time) or a truth
/// value (which has no literal; see [`super::select`]).
pub(super) fn run(program: Program) -> Program {
    let tables = Tables::of(&program);
    rewrite(program, |program, instruction| {
        let Type::Real(shape) = instruction.ty else {
            return None;
        };
        let operands = instruction.op.operands();
        if is_leaf(&instruction.op)
            || operands
                .iter()
                .any(|&operand| literal(program, operand).is_none())
        {
            return None;
        }
        // f(literals) == eval(f(literals)) (exact)
        let mut folded = vec![0.0; entries(instruction.ty)];
        let value = |id| literal(program, id).expect("invariant: every operand is a literal");
        tables.apply(program, &instruction.op, value, &mut folded);
        folded
            .iter()
            .all(|entry| entry.is_finite())
            .then(|| program.constant(shape, folded))
    })
}
