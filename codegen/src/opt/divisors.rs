//! Divisions by what is known earlier than their result become products with reciprocals: by numbers, by what depends on parameters alone,
//! or on time and parameters. The reciprocal is then computed when the program is compiled, once for a run, or once for a sample of all runs.
//! Also part of lowering: a quotient is off by at most 1.5 ulp instead of 0.5, while the reciprocal neither over- nor underflows, and a
//! division takes as long as ten products.

use crate::ir::{Op, Operator, Program, ValueId};

use super::dependence::Dependences;
use super::rewrite::{literal, rewrite};

/// Turns such divisions into products.
pub(super) fn run(program: Program) -> Program {
    let mut dependences = Dependences::default();
    rewrite(program, |program, instruction| {
        let Op::Binary(Operator::Div, a, b) = instruction.op else {
            return None;
        };
        // x / c == x * (1/c) (two roundings instead of one)
        let reciprocals = if literal(program, b).is_some() {
            of_numbers(program, b)?
        } else if dependences.of(program, b) < dependences.of(program, a) {
            let one = program.scalar(1.0);
            program.binary(Operator::Div, one, b)
        } else {
            return None;
        };
        Some(program.binary(Operator::Mul, a, reciprocals))
    })
}

/// The reciprocals of numbers, if neither they nor the numbers have lost digits below the smallest normal number, or are 0 or infinite.
fn of_numbers(program: &mut Program, divisors: ValueId) -> Option<ValueId> {
    let shape = program.shape(divisors);
    let divisors = literal(program, divisors)?;
    let reciprocals: Vec<f64> = divisors.iter().map(|divisor| 1.0 / divisor).collect();
    let normal = divisors.iter().chain(&reciprocals).all(|x| x.is_normal());
    normal.then(|| program.constant(shape, reciprocals))
}
