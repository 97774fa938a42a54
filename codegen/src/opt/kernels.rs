//! Kernels that are a quotient in elementary functions, so that these are shared with others and gathered with their like.

use crate::ir::{Comparison, Function, Kernel, Op, Operator, Program, Shape, ValueId};

use super::rewrite::rewrite;

/// Expands them.
pub(super) fn run(program: Program) -> Program {
    rewrite(program, |program, instruction| match instruction.op {
        // sin(E) cos(E) / E, 1 at 0 (exact: that is its definition)
        Op::Kernel(Kernel::SinCosOver, e) => {
            let [sine, cosine] =
                [Function::Sin, Function::Cos].map(|function| program.push(Op::Apply(function, e)));
            let product = program.binary(Operator::Mul, sine, cosine);
            Some(over(program, product, e))
        }
        // tan(E) / E, 1 at 0 (exact: that is its definition)
        Op::Kernel(Kernel::TanOver, e) => {
            let tangent = program.push(Op::Apply(Function::Tan, e));
            Some(over(program, tangent, e))
        }
        _ => None,
    })
}

/// `value / e`, 1 where e is 0.
fn over(program: &mut Program, value: ValueId, e: ValueId) -> ValueId {
    let [zero, one] = [0.0, 1.0].map(|number| program.constant(Shape::Scalar, vec![number]));
    let at_zero = program.push(Op::Compare(Comparison::Eq, e, zero));
    let quotient = program.binary(Operator::Div, value, e);
    program.push(Op::Select(at_zero, one, quotient))
}
