//! Removal of instructions that no output needs.

use crate::ir::{Program, ValueId};

/// Drops dead instructions and renumbers the rest.
pub(crate) fn sweep(program: &mut Program) {
    let mut live = vec![false; program.instructions.len()];
    program
        .outputs
        .iter()
        .for_each(|(_, id)| live[id.0 as usize] = true);
    for position in (0..live.len()).rev() {
        if live[position] {
            program.instructions[position]
                .op
                .operands()
                .iter()
                .for_each(|id| live[id.0 as usize] = true);
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
    program
        .instructions
        .retain(|_| *keep.next().expect("invariant: one flag per instruction"));
    for instruction in &mut program.instructions {
        instruction.op = instruction.op.map_operands(|id| renumbered[id.0 as usize]);
    }
    program
        .outputs
        .iter_mut()
        .for_each(|(_, id)| *id = renumbered[id.0 as usize]);
}
