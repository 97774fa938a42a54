//! Value numbering: equal operations on equal operands are computed once.

use std::collections::HashMap;

use crate::ir::{Comparison, Op, Operator, Program, Type, ValueId};

use super::rewrite::{is_leaf, rewrite};

/// Merges equal values. A named literal or input stays apart: other readers of the same number do not mean that quantity.
pub(super) fn run(program: Program) -> Program {
    let mut first: HashMap<(Type, String), ValueId> = HashMap::new(); // looked up only, never iterated
    rewrite(program, |program, instruction| {
        if instruction.name.is_some() && is_leaf(&instruction.op) {
            return None;
        }
        let next = ValueId(
            u32::try_from(program.instructions.len())
                .expect("invariant: fewer than 2^32 instructions"),
        );
        let key = (instruction.ty, program.text_of(&canonical(&instruction.op)));
        let value = *first.entry(key).or_insert(next);
        (value != next).then_some(value)
    })
}

/// The representative of operations that are equal by commutativity. `min` and `max` are not among them: with NaN, or with zeros of
/// both signs, they give their second operand.
fn canonical(op: &Op) -> Op {
    match *op {
        // a + b == b + a, a * b == b * a (exact)
        Op::Binary(operator @ (Operator::Add | Operator::Mul), a, b) => {
            Op::Binary(operator, a.min(b), a.max(b))
        }
        // a . b == b . a (exact: each product commutes, their order stays)
        Op::Dot(a, b) => Op::Dot(a.min(b), a.max(b)),
        // a & b == b & a, a | b == b | a (exact)
        Op::And(a, b) => Op::And(a.min(b), a.max(b)),
        Op::Or(a, b) => Op::Or(a.min(b), a.max(b)),
        // a > b == b < a, a >= b == b <= a (exact)
        Op::Compare(Comparison::Gt, a, b) => Op::Compare(Comparison::Lt, b, a),
        Op::Compare(Comparison::Ge, a, b) => Op::Compare(Comparison::Le, b, a),
        // (a == b) == (b == a), (a != b) == (b != a) (exact)
        Op::Compare(relation @ (Comparison::Eq | Comparison::Ne), a, b) => {
            Op::Compare(relation, a.min(b), a.max(b))
        }
        _ => op.clone(),
    }
}
