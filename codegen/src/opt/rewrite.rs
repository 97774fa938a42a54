//! The one traversal behind the passes: it rebuilds a program from front to back and asks a rule about each instruction.

use super::dead_code::live;
use crate::ir::{Function, Instruction, Op, Operator, Program, Type, ValueId};

/// Rebuilds `program`. The rule sees each instruction with its operands already replaced, and the program so far; it gives the value to
/// use instead, an earlier or an appended one of the same type, or `None` to keep the instruction.
///
/// Outputs follow their values. A named value that is replaced passes its name and origin on to the value in its place, or to a copy of
/// it if that is a literal or an input, which others read as what it is. If that value has a name already it keeps it; the lost name
/// lives on where it is the name of an output.
pub(super) fn rewrite(
    program: Program,
    mut rule: impl FnMut(&mut Program, &Instruction) -> Option<ValueId>,
) -> Program {
    rewrite_counting(program, |program, instruction, _| {
        rule(program, instruction)
    })
}

/// How often values are used by what outputs need: each operand that refers to one counts, and each output.
pub(super) struct Uses(Vec<u32>);

impl Uses {
    /// Whether a value has no user but the instruction that is looked at, so that it goes if that is replaced.
    pub(super) fn single(&self, value: ValueId) -> bool {
        self.0[value.0 as usize] <= 1
    }
}

/// As [`rewrite`]; the rule is also told how often each value so far is used.
pub(super) fn rewrite_counting(
    mut program: Program,
    mut rule: impl FnMut(&mut Program, &Instruction, &Uses) -> Option<ValueId>,
) -> Program {
    let of_source = count(&program);
    let source = std::mem::take(&mut program.instructions);
    let mut replaced: Vec<ValueId> = Vec::with_capacity(source.len());
    let mut uses = Uses(Vec::with_capacity(source.len()));
    for (mut instruction, users) in source.into_iter().zip(of_source) {
        instruction.op = instruction
            .op
            .map_operands(|operand| replaced[operand.0 as usize]);
        let value = match rule(&mut program, &instruction, &uses) {
            Some(value) => rename(&mut program, value, instruction),
            None => append(&mut program, instruction),
        };
        // What the rule appended on the way is used by what it appended then.
        let known = uses.0.len();
        uses.0.resize(program.instructions.len(), 1);
        let index = value.0 as usize;
        uses.0[index] = users + if index < known { uses.0[index] } else { 0 };
        replaced.push(value);
    }
    for (_, value) in &mut program.outputs {
        *value = replaced[value.0 as usize];
    }
    program
}

fn count(program: &Program) -> Vec<u32> {
    let mut uses = vec![0; program.instructions.len()];
    let users = program.instructions.iter().zip(live(program));
    let operands = users
        .filter(|(_, live)| *live)
        .flat_map(|(user, _)| user.op.operands());
    for value in operands.chain(program.outputs.iter().map(|(_, value)| *value)) {
        uses[value.0 as usize] += 1;
    }
    uses
}

/// The value that stands for the replaced instruction.
fn rename(program: &mut Program, value: ValueId, replaced: Instruction) -> ValueId {
    if replaced.name.is_none() {
        return value;
    }
    let kept = &mut program.instructions[value.0 as usize];
    if is_leaf(&kept.op) {
        let op = kept.op.clone();
        return append(program, Instruction { op, ..replaced });
    }
    if kept.name.is_none() {
        kept.name = replaced.name;
        kept.origin = replaced.origin;
    }
    value
}

fn append(program: &mut Program, instruction: Instruction) -> ValueId {
    let id = ValueId(
        u32::try_from(program.instructions.len()).expect("invariant: fewer than 2^32 instructions"),
    );
    program.instructions.push(instruction);
    id
}

/// Literals and inputs.
pub(super) fn is_leaf(op: &Op) -> bool {
    matches!(op, Op::Const(_) | Op::Input(_))
}

/// The entries of a literal.
pub(super) fn literal(program: &Program, id: ValueId) -> Option<&[f64]> {
    match &program.instruction(id).op {
        Op::Const(data) => Some(data),
        _ => None,
    }
}

/// Whether every entry of a literal is `value`, to the sign of zero.
pub(super) fn is_all(program: &Program, id: ValueId, value: f64) -> bool {
    literal(program, id)
        .is_some_and(|data| data.iter().all(|entry| entry.to_bits() == value.to_bits()))
}

/// Whether one of two terms is limited or chosen: their sum must not be taken apart, so that the difference of a number and its limited
/// self stays 0 inside the limits.
pub(super) fn limited(program: &Program, terms: [ValueId; 2]) -> bool {
    terms.iter().any(|&id| {
        let op = &program.instruction(id).op;
        matches!(
            op,
            Op::Binary(Operator::Min | Operator::Max, ..) | Op::Select(..)
        )
    })
}

/// a, for the value -a.
pub(super) fn negated(program: &Program, id: ValueId) -> Option<ValueId> {
    match program.instruction(id).op {
        Op::Apply(Function::Neg, a) => Some(a),
        _ => None,
    }
}

/// `value`, if its type is `ty`: a scalar operand that was broadcast cannot stand for the result.
pub(super) fn of_type(program: &Program, value: ValueId, ty: Type) -> Option<ValueId> {
    (program.ty(value) == ty).then_some(value)
}
