//! Functions of one angle share what they have in common.

use std::collections::BTreeSet;

use crate::ir::{Function, Op, Operator, Program, ValueId};

use super::rewrite::rewrite;

/// Writes the tangent of an angle whose sine or cosine is computed anyway as their quotient.
pub(super) fn run(program: Program) -> Program {
    let angles: BTreeSet<ValueId> = program
        .instructions
        .iter()
        .filter_map(|instruction| match instruction.op {
            Op::Apply(Function::Sin | Function::Cos, angle) => Some(angle),
            _ => None,
        })
        .collect();
    let tangents: Vec<bool> = program
        .instructions
        .iter()
        .map(|instruction| {
            matches!(instruction.op, Op::Apply(Function::Tan, angle) if angles.contains(&angle))
        })
        .collect();
    let mut tangents = tangents.into_iter();
    rewrite(program, |program, instruction| {
        let shared = tangents
            .next()
            .expect("invariant: one call for each instruction");
        let &Op::Apply(_, angle) = &instruction.op else {
            return None;
        };
        // tan x == sin x / cos x (three roundings instead of one)
        shared.then(|| {
            let sine = program.push(Op::Apply(Function::Sin, angle));
            let cosine = program.push(Op::Apply(Function::Cos, angle));
            program.binary(Operator::Div, sine, cosine)
        })
    })
}
