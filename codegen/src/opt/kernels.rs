//! Kernels that are a quotient in elementary functions, so that these are shared with others and gathered with their like.

use crate::ir::{Comparison, Function, Kernel, Op, Operator, Program, Shape, ValueId};

use super::rewrite::{literal, rewrite};

/// Expands them.
pub(super) fn run(program: Program) -> Program {
    // The functions of a fused program are fused, a kernel is not: its bits would change. A law is expanded before it is fused.
    if program.fused {
        return program;
    }
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

/// Where E is clamped the kernel stands beside the factor that undoes the clamp in its divisor, and both are one quotient.
pub(super) fn run_clamped(program: Program) -> Program {
    rewrite(program, |program, instruction| {
        let Op::Binary(Operator::Mul, a, b) = instruction.op else {
            return None;
        };
        let (free, e) = clamped(program, a, b).or_else(|| clamped(program, b, a))?;
        // sin(E) cos(E) / E min(1, l / x) == sin(E) cos(E) (1 / x) for E = min(x, l), x >= 0 (one rounding fewer), and 1 to the last bit
        // where x is small
        let small = program.scalar(SMALL);
        let one = program.scalar(1.0);
        let at_zero = program.push(Op::Compare(Comparison::Lt, free, small));
        let [sine, cosine] =
            [Function::Sin, Function::Cos].map(|function| program.push(Op::Apply(function, e)));
        let product = program.binary(Operator::Mul, sine, cosine);
        let reciprocal = program.binary(Operator::Div, one, free);
        let quotient = program.binary(Operator::Mul, product, reciprocal);
        Some(program.push(Op::Select(at_zero, one, quotient)))
    })
}

/// Below this 1 / x might overflow.
const SMALL: f64 = 1e-300;

/// x and E of `sin_cos_over(E)` and `min(1, l / x)`, if E is `min(x, l)`.
fn clamped(program: &Program, kernel: ValueId, factor: ValueId) -> Option<(ValueId, ValueId)> {
    let op = |id: ValueId| &program.instruction(id).op;
    let (&Op::Kernel(Kernel::SinCosOver, e), &Op::Binary(Operator::Min, one, ratio)) =
        (op(kernel), op(factor))
    else {
        return None;
    };
    let (&Op::Binary(Operator::Min, free, limit), &Op::Binary(Operator::Div, over, under)) =
        (op(e), op(ratio))
    else {
        return None;
    };
    let same = literal(program, limit)? == literal(program, over)?;
    (free == under && same && literal(program, one)? == [1.0]).then_some((free, e))
}

/// `value / e`, 1 where e is 0.
fn over(program: &mut Program, value: ValueId, e: ValueId) -> ValueId {
    let [zero, one] = [0.0, 1.0].map(|number| program.constant(Shape::Scalar, vec![number]));
    let at_zero = program.push(Op::Compare(Comparison::Eq, e, zero));
    let quotient = program.binary(Operator::Div, value, e);
    program.push(Op::Select(at_zero, one, quotient))
}
