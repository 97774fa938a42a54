//! Divisions by numbers become products with their reciprocals. Part of lowering: a quotient is off by at most 1.5 ulp instead of 0.5, and a
//! division takes as long as ten products.

use crate::ir::{Op, Operator, Program};

use super::rewrite::{literal, rewrite};

/// Turns divisions by literals into products.
pub(super) fn run(program: Program) -> Program {
    rewrite(program, |program, instruction| {
        let Op::Binary(Operator::Div, a, b) = instruction.op else {
            return None;
        };
        let divisors = literal(program, b)?.to_vec();
        let reciprocals: Vec<f64> = divisors.iter().map(|divisor| 1.0 / divisor).collect();
        // Neither the divisor nor its reciprocal may have lost digits below the smallest normal number, or be 0 or infinite.
        if divisors.iter().chain(&reciprocals).any(|x| !x.is_normal()) {
            return None;
        }
        let shape = program.shape(b);
        let reciprocals = program.constant(shape, reciprocals);
        // x / c == x * (1/c) (two roundings instead of one)
        Some(program.binary(Operator::Mul, a, reciprocals))
    })
}
