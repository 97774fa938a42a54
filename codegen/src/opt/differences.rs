//! `x - x == 0` and, after x - y, `y - x == -(x - y)`: for finite values, up to the sign of a zero. Part of lowering: angles between the links of
//! a mechanism come in both directions, and their cosines are the same.

use std::collections::HashMap;

use crate::ir::build::size;
use crate::ir::{Function, Op, Operator, Program, ValueId};

use super::rewrite::rewrite;

/// Writes a difference that is known in the other direction by that one.
pub(super) fn run(program: Program) -> Program {
    let mut known: HashMap<(ValueId, ValueId), ValueId> = HashMap::new(); // looked up only, never iterated
    rewrite(program, |program, instruction| {
        let Op::Binary(Operator::Sub, x, y) = instruction.op else {
            return None;
        };
        if x == y {
            let shape = program.shape(x);
            return Some(program.constant(shape, vec![0.0; size(shape)]));
        }
        if let Some(&reverse) = known.get(&(y, x)) {
            return Some(program.push(Op::Apply(Function::Neg, reverse)));
        }
        let difference = program.binary(Operator::Sub, x, y);
        known.insert((x, y), difference);
        Some(difference)
    })
}
