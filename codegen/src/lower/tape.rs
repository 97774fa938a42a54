//! Imported partials, copied into the program that uses them.

use std::collections::BTreeMap;

use super::expression::{intern, intern_table};
use super::{Context, Lowering};
use crate::derive::symbol::TapeId;
use crate::ir::{Op, ValueId};

impl<C: Context> Lowering<'_, '_, C> {
    /// An output of a tape; the first use copies the tape.
    pub(super) fn tape(&mut self, tape: TapeId, output: &str) -> ValueId {
        if !self.tapes.contains_key(&tape) {
            let outputs = self.copy(tape);
            self.tapes.insert(tape, outputs);
        }
        self.tapes[&tape][output]
    }

    fn copy(&mut self, tape: TapeId) -> BTreeMap<String, ValueId> {
        let law = self.law;
        let tape = &law.tapes[tape.0];
        let mut values: Vec<ValueId> = Vec::with_capacity(tape.program.instructions.len());
        for instruction in &tape.program.instructions {
            let value = match &instruction.op {
                Op::Input(at) => {
                    let input = &tape.program.inputs[*at].name;
                    let binding = tape
                        .bindings
                        .get(input)
                        .unwrap_or_else(|| panic!("invariant: tape input `{input}` is bound"));
                    self.symbol(binding)
                }
                Op::Polynomial(id, _) => {
                    let data = tape.program.polynomials[id.0 as usize].clone();
                    let id = intern(&mut self.program, data);
                    let arguments = instruction
                        .op
                        .operands()
                        .iter()
                        .map(|operand| values[operand.0 as usize])
                        .collect();
                    self.program.push(Op::Polynomial(id, arguments))
                }
                Op::Table(id, orders, _) => {
                    let data = &tape.program.tables[id.0 as usize];
                    let id = intern_table(&mut self.program, data);
                    let arguments = instruction
                        .op
                        .operands()
                        .iter()
                        .map(|operand| values[operand.0 as usize])
                        .collect();
                    self.program.push(Op::Table(id, orders.clone(), arguments))
                }
                op => self.program.push_as(
                    op.map_operands(|operand| values[operand.0 as usize]),
                    instruction.ty,
                ),
            };
            values.push(value);
        }
        tape.program
            .outputs
            .iter()
            .map(|(name, value)| (name.clone(), values[value.0 as usize]))
            .collect()
    }
}
