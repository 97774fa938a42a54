//! Divisions by one divisor share its reciprocal; that of a literal is known.

use crate::ir::build::size;
use crate::ir::{Op, Operator, Program, Shape};

use super::rewrite::{literal, rewrite};

/// Turns divisions by a scalar that divides at least two entries into products with its reciprocal.
pub(super) fn run(program: Program) -> Program {
    let mut quotients = vec![0; program.instructions.len()];
    for instruction in &program.instructions {
        if let Op::Binary(Operator::Div, a, b) = instruction.op {
            quotients[b.0 as usize] += size(program.shape(a));
        }
    }
    let divisors = program
        .instructions
        .iter()
        .map(|instruction| match instruction.op {
            Op::Binary(Operator::Div, _, b) => quotients[b.0 as usize],
            _ => 0,
        });
    let mut entries_divided = divisors.collect::<Vec<usize>>().into_iter();
    rewrite(program, |program, instruction| {
        let entries = entries_divided
            .next()
            .expect("invariant: one call for each instruction");
        let Op::Binary(Operator::Div, a, b) = instruction.op else {
            return None;
        };
        // x / c == x * (1 / c) for a literal c (two roundings instead of one)
        if let Some(divisors) = literal(program, b) {
            let reciprocals: Vec<f64> = divisors.iter().map(|d| d.recip()).collect();
            let shape = program.shape(b);
            return reciprocals.iter().all(|r| r.is_normal()).then(|| {
                let reciprocals = program.constant(shape, reciprocals);
                program.binary(Operator::Mul, a, reciprocals)
            });
        }
        let is_reciprocal = literal(program, a).is_some_and(|data| data == [1.0]);
        if entries < 2 || is_reciprocal || program.shape(b) != Shape::Scalar {
            return None;
        }
        // a / d == a * (1 / d) (two roundings instead of one)
        let one = program.scalar(1.0);
        let reciprocal = program.binary(Operator::Div, one, b);
        Some(program.binary(Operator::Mul, a, reciprocal))
    })
}
