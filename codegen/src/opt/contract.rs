//! Products that are added to something are not rounded, in elementary functions neither: one operation in place of two. The last pass, since the others look for sums and
//! products.

use crate::ir::{Function, Op, Operator, Program, Shape, ValueId};

use super::rewrite::{limited, literal, rewrite_counting};

/// Contracts sums, and inside operations on arrays too.
pub(super) fn run(program: Program) -> Program {
    let mut program = rewrite_counting(program, |program, instruction, uses| {
        let Op::Binary(operator @ (Operator::Add | Operator::Sub), a, b) = instruction.op else {
            return None;
        };
        if program.ty(a) != instruction.ty || program.ty(b) != instruction.ty {
            return None;
        }
        if limited(program, [a, b]) {
            return None;
        }
        let product = |id: ValueId| uses.single(id).then(|| factors(program, id)).flatten();
        let (left, right) = (product(a), product(b));
        match (operator, left, right) {
            // a + x y == mul_add(x, y, a) (one rounding instead of two)
            (Operator::Add, _, Some((x, y))) => Some(program.push(Op::MulAdd(x, y, a))),
            (Operator::Add, Some((x, y)), None) => Some(program.push(Op::MulAdd(x, y, b))),
            // a - x y == mul_add(x, -y, a) (one rounding instead of two)
            (_, _, Some((x, y))) => {
                let y = negative(program, y);
                Some(program.push(Op::MulAdd(x, y, a)))
            }
            // x y - b == mul_add(x, y, -b) (one rounding instead of two)
            (_, Some((x, y)), None) => {
                let b = negative(program, b);
                Some(program.push(Op::MulAdd(x, y, b)))
            }
            _ => None,
        }
    });
    program.fused = true;
    program
}

/// The factors of a product, one of its type first.
fn factors(program: &Program, id: ValueId) -> Option<(ValueId, ValueId)> {
    match program.instruction(id).op {
        Op::Binary(Operator::Mul, a, b) if program.ty(a) == program.ty(id) => Some((a, b)),
        Op::Binary(Operator::Mul, a, b) if program.ty(b) == program.ty(id) => Some((b, a)),
        _ => None,
    }
}

/// -a, a literal if a is one.
fn negative(program: &mut Program, a: ValueId) -> ValueId {
    match literal(program, a) {
        Some(data) if program.shape(a) == Shape::Scalar => {
            let negative = -data[0];
            program.scalar(negative)
        }
        _ => program.push(Op::Apply(Function::Neg, a)),
    }
}
