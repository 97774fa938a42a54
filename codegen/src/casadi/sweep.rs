//! Removal of instructions that no output needs.

use crate::ir::{Op, Program, ValueId};

/// Drops dead instructions and renumbers the rest.
pub(crate) fn sweep(program: &mut Program) {
    let mut live = vec![false; program.instructions.len()];
    program.outputs.iter().for_each(|(_, id)| live[id.0 as usize] = true);
    for position in (0..live.len()).rev() {
        if live[position] {
            program.instructions[position].op.operands().iter().for_each(|id| live[id.0 as usize] = true);
        }
    }
    let mut next = 0;
    let renumbered: Vec<ValueId> = live
        .iter()
        .map(|live| {
            let id = ValueId(next);
            next += u32::from(*live);
            id
        })
        .collect();
    let mut keep = live.iter();
    program.instructions.retain(|_| *keep.next().expect("invariant: one flag per instruction"));
    for instruction in &mut program.instructions {
        scalar_operands(&mut instruction.op).into_iter().for_each(|id| *id = renumbered[id.0 as usize]);
    }
    program.outputs.iter_mut().for_each(|(_, id)| *id = renumbered[id.0 as usize]);
}

/// Operands of the operations that a tape decodes to.
fn scalar_operands(op: &mut Op) -> Vec<&mut ValueId> {
    match op {
        Op::Const(_) | Op::Input(_) => Vec::new(),
        Op::Apply(_, a) | Op::Kernel(_, a) | Op::PowInt(a, _) | Op::Not(a) | Op::Element(a, _, _) => vec![a],
        Op::Binary(_, a, b) | Op::Compare(_, a, b) | Op::And(a, b) | Op::Or(a, b) => vec![a, b],
        Op::Select(a, b, c) => vec![a, b, c],
        Op::Array(items) | Op::Polynomial(_, items) => items.iter_mut().collect(),
        other => panic!("invariant: a tape holds no {other:?}"),
    }
}
