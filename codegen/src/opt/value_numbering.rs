//! Value numbering: equal operations on equal operands are computed once.

use std::collections::HashMap;
use std::hash::{Hash, Hasher};

use crate::ir::{Comparison, Op, Operator, Program, Type, ValueId};

use super::rewrite::{is_leaf, rewrite};

/// Merges equal values. A named literal or input stays apart: other readers of the same number do not mean that quantity.
pub(super) fn run(program: Program) -> Program {
    let mut first: HashMap<(Type, Structure), ValueId> = HashMap::new(); // looked up only, never iterated
    rewrite(program, |program, instruction| {
        if instruction.name.is_some() && is_leaf(&instruction.op) {
            return None;
        }
        let next = ValueId(
            u32::try_from(program.instructions.len())
                .expect("invariant: fewer than 2^32 instructions"),
        );
        let key = (instruction.ty, Structure(canonical(&instruction.op)));
        let value = *first.entry(key).or_insert(next);
        (value != next).then_some(value)
    })
}

/// An operation, equal to another if both compute the same bits from the same operands: literals are compared by their bits.
struct Structure(Op);

impl PartialEq for Structure {
    fn eq(&self, other: &Structure) -> bool {
        match (&self.0, &other.0) {
            (Op::Const(a), Op::Const(b)) => {
                let bits = |data: &[f64]| data.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
                bits(a) == bits(b)
            }
            (a, b) => a == b,
        }
    }
}

impl Eq for Structure {}

impl Hash for Structure {
    fn hash<H: Hasher>(&self, state: &mut H) {
        std::mem::discriminant(&self.0).hash(state);
        match &self.0 {
            Op::Const(data) => data.iter().for_each(|entry| entry.to_bits().hash(state)),
            Op::Input(position) => position.hash(state),
            Op::Element(array, row, column) => (array, row, column).hash(state),
            Op::Apply(function, a) => (function, a).hash(state),
            Op::Binary(operator, a, b) => (operator, a, b).hash(state),
            // What else tells operations apart does so among few of the same operands.
            op => op.operands().hash(state),
        }
    }
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
