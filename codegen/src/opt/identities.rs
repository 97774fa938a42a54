//! Algebraic identities that hold for every IEEE 754 operand, zeros of either sign, infinities and NaN included. What is missing is
//! missing on purpose: `x + 0` turns -0 into 0, and `x * 0`, `x - x`, `x / x` and `-(a - b)` have exceptions too.

use crate::ir::{Function, Instruction, Op, Operator, Program, Shape, ValueId};

use super::rewrite::{Uses, is_all, literal, negated, of_type, rewrite_counting};

/// Applies each identity once, operands first.
pub(super) fn run(program: Program) -> Program {
    rewrite_counting(program, |program, instruction, uses| {
        uniform(program, instruction)
            .or_else(|| identity(program, instruction))
            .or_else(|| negative_term(program, instruction, uses))
    })
}

/// x + (-a) b == x - a b, (-a) b + x == x - a b, x - (-a) b == x + a b (exact: signs do not change roundings), unless the product is needed.
fn negative_term(program: &mut Program, instruction: &Instruction, uses: &Uses) -> Option<ValueId> {
    let negative = |program: &Program, product: ValueId| {
        let Op::Binary(Operator::Mul, a, b) = program.instruction(product).op else {
            return None;
        };
        let positive = match (negated(program, a), negated(program, b)) {
            (Some(a), None) => Some((a, b)),
            (None, Some(b)) => Some((a, b)),
            _ => None,
        };
        positive.filter(|_| uses.single(product) && program.instruction(product).name.is_none())
    };
    let (operator, x, (a, b)) = match instruction.op {
        Op::Binary(Operator::Add, x, y) => match negative(program, y) {
            Some(product) => (Operator::Sub, x, product),
            None => (Operator::Sub, y, negative(program, x)?),
        },
        Op::Binary(Operator::Sub, x, y) => (Operator::Add, x, negative(program, y)?),
        _ => return None,
    };
    let product = program.binary(Operator::Mul, a, b);
    Some(program.binary(operator, x, product))
}

fn identity(program: &mut Program, instruction: &Instruction) -> Option<ValueId> {
    match instruction.op {
        Op::Binary(Operator::Add, a, b) => sum(program, instruction, a, b),
        Op::Binary(Operator::Sub, a, b) => difference(program, instruction, a, b),
        Op::Binary(Operator::Mul, a, b) => product(program, instruction, a, b),
        Op::Binary(Operator::Div, a, b) => quotient(program, instruction, a, b),
        // min(x, x) == x, max(x, x) == x (exact)
        Op::Binary(Operator::Min | Operator::Max, a, b) if a == b => Some(a),
        Op::Apply(function, a) => apply(program, function, a),
        Op::PowInt(a, n) if n % 2 == 0 => {
            even_power(program, a).map(|a| program.push(Op::PowInt(a, n)))
        }
        Op::SumSquares(a) => even_power(program, a).map(|a| program.push(Op::SumSquares(a))),
        // a . a == |a|^2 (exact: the same products in the same order)
        Op::Dot(a, b) if a == b => Some(program.push(Op::SumSquares(a))),
        // -a . -b == a . b (exact)
        Op::Dot(a, b) => {
            let (a, b) = (negated(program, a)?, negated(program, b)?);
            Some(program.push(Op::Dot(a, b)))
        }
        _ => None,
    }
}

/// [x, x, ..] op a == x op a, a op [x, x, ..] == a op x, elementwise (exact)
fn uniform(program: &mut Program, instruction: &Instruction) -> Option<ValueId> {
    let Op::Binary(operator, a, b) = instruction.op else {
        return None;
    };
    let same = program.ty(a) == program.ty(b) && program.shape(a) != Shape::Scalar;
    let value = |program: &Program, id: ValueId| {
        let first = *literal(program, id)?.first()?;
        is_all(program, id, first).then_some(first)
    };
    match (value(program, a), value(program, b)) {
        (Some(x), None) if same => {
            let x = program.scalar(x);
            Some(program.binary(operator, x, b))
        }
        (None, Some(x)) if same => {
            let x = program.scalar(x);
            Some(program.binary(operator, a, x))
        }
        _ => None,
    }
}

fn sum(
    program: &mut Program,
    instruction: &Instruction,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    // x + -0 == x, -0 + x == x (exact)
    if is_all(program, b, -0.0)
        && let Some(a) = of_type(program, a, instruction.ty)
    {
        return Some(a);
    }
    if is_all(program, a, -0.0)
        && let Some(b) = of_type(program, b, instruction.ty)
    {
        return Some(b);
    }
    // a + -b == a - b (exact)
    if let Some(b) = negated(program, b) {
        return Some(program.binary(Operator::Sub, a, b));
    }
    // -a + b == b - a (exact)
    negated(program, a).map(|a| program.binary(Operator::Sub, b, a))
}

fn difference(
    program: &mut Program,
    instruction: &Instruction,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    // x - 0 == x (exact)
    if is_all(program, b, 0.0)
        && let Some(a) = of_type(program, a, instruction.ty)
    {
        return Some(a);
    }
    // a - -b == a + b (exact)
    if let Some(b) = negated(program, b) {
        return Some(program.binary(Operator::Add, a, b));
    }
    // -0 - x == -x (exact)
    let b = of_type(program, b, instruction.ty).filter(|_| is_all(program, a, -0.0))?;
    Some(program.push(Op::Apply(Function::Neg, b)))
}

fn product(
    program: &mut Program,
    instruction: &Instruction,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    for (x, factor) in [(a, b), (b, a)] {
        if program.ty(x) != instruction.ty {
            continue;
        }
        // x * 1 == x, 1 * x == x (exact)
        if is_all(program, factor, 1.0) {
            return Some(x);
        }
        // x * -1 == -x, -1 * x == -x (exact)
        if is_all(program, factor, -1.0) {
            return Some(program.push(Op::Apply(Function::Neg, x)));
        }
    }
    // -a * -b == a * b (exact)
    let (a, b) = (negated(program, a)?, negated(program, b)?);
    Some(program.binary(Operator::Mul, a, b))
}

fn quotient(
    program: &mut Program,
    instruction: &Instruction,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    if program.ty(a) == instruction.ty {
        // x / 1 == x (exact)
        if is_all(program, b, 1.0) {
            return Some(a);
        }
        // x / -1 == -x (exact)
        if is_all(program, b, -1.0) {
            return Some(program.push(Op::Apply(Function::Neg, a)));
        }
    }
    // -a / -b == a / b (exact)
    if let (Some(a), Some(b)) = (negated(program, a), negated(program, b)) {
        return Some(program.binary(Operator::Div, a, b));
    }
    // x / 2^k == x * 2^-k (exact: both round the same real number)
    let divisors = literal(program, b)?;
    let reciprocals = divisors
        .iter()
        .all(|&d| is_power_of_two(d))
        .then(|| divisors.iter().map(|d| 1.0 / d).collect())?;
    let reciprocals = program.constant(program.shape(b), reciprocals);
    Some(program.binary(Operator::Mul, a, reciprocals))
}

/// Whether `x` is a power of two, of either sign, whose reciprocal is one too and normal.
fn is_power_of_two(x: f64) -> bool {
    const FRACTION: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    x.is_normal() && x.recip().is_normal() && x.to_bits() & FRACTION == 0
}

fn apply(program: &mut Program, function: Function, a: ValueId) -> Option<ValueId> {
    match (function, &program.instruction(a).op) {
        // -(-x) == x (exact)
        (Function::Neg, &Op::Apply(Function::Neg, x)) => Some(x),
        // ||x|| == |x| (exact)
        (Function::Abs, &Op::Apply(Function::Abs, _)) => Some(a),
        // |-x| == |x| (exact)
        (Function::Abs, &Op::Apply(Function::Neg, x)) => {
            Some(program.push(Op::Apply(Function::Abs, x)))
        }
        // cos(-x) == cos x, cos |x| == cos x, and the same of cosh (exact: the functions are even to the bit)
        (Function::Cos | Function::Cosh, &Op::Apply(Function::Neg | Function::Abs, x)) => {
            Some(program.push(Op::Apply(function, x)))
        }
        // sin(-x) == -sin x and its like (exact: the functions are odd to the bit)
        (
            Function::Sin
            | Function::Tan
            | Function::Asin
            | Function::Atan
            | Function::Sinh
            | Function::Tanh,
            &Op::Apply(Function::Neg, x),
        ) => {
            let value = program.push(Op::Apply(function, x));
            Some(program.push(Op::Apply(Function::Neg, value)))
        }
        _ => None,
    }
}

/// x, for -x or |x|: (-x)^2k == x^2k, |x|^2k == x^2k (exact: signs cancel in every product)
fn even_power(program: &Program, a: ValueId) -> Option<ValueId> {
    match program.instruction(a).op {
        Op::Apply(Function::Neg | Function::Abs, x) => Some(x),
        _ => None,
    }
}
