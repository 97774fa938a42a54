//! Calls of one elementary function that do not depend on each other become one call on an array of their arguments, which the emitted
//! code evaluates with vector instructions. Exact: the bits of a function's value do not depend on what stands beside its argument.

use std::collections::{BTreeMap, BTreeSet};

use super::dependence::{Dependence, dependences};
use crate::ir::mnemonic::{FUNCTIONS, word};
use crate::ir::{Function, Instruction, Op, Program, Shape, Type, ValueId};

/// Which calls go together: of one function, needed equally often, behind equally many other calls and a path of equally many operations
/// from those or the inputs; others would wait for each other, and so would the equations that read them.
type Key = (Dependence, usize, usize, &'static str);

/// Paths of up to this many operations count as equal.
const CLOSE: usize = 3;

/// Calls that go together, and their arguments in order.
#[derive(Default)]
struct Pack {
    function: Option<Function>,
    calls: Vec<ValueId>,
    arguments: Vec<ValueId>,
}

/// Gathers calls.
pub(super) fn run(program: Program) -> Program {
    let packs = packs(&program);
    if packs.is_empty() {
        return program;
    }
    let mut pack_of: Vec<Option<usize>> = vec![None; program.instructions.len()];
    for (index, pack) in packs.iter().enumerate() {
        for call in &pack.calls {
            pack_of[call.0 as usize] = Some(index);
        }
    }
    let source = program;
    let mut mover = Mover {
        source: &source,
        packs: &packs,
        pack_of,
        moved: vec![None; source.instructions.len()],
        program: Program {
            instructions: Vec::with_capacity(source.instructions.len()),
            ..source.clone()
        },
    };
    let count = u32::try_from(source.instructions.len());
    for id in (0..count.expect("invariant: fewer than 2^32 instructions")).map(ValueId) {
        mover.place(id);
    }
    let Mover {
        moved, mut program, ..
    } = mover;
    for (_, value) in &mut program.outputs {
        *value = moved[value.0 as usize].expect("invariant: every value is placed");
    }
    program
}

/// The function of a scalar call that is worth gathering.
fn call(instruction: &Instruction) -> Option<(Function, ValueId)> {
    match instruction.op {
        Op::Apply(Function::Neg | Function::Abs | Function::Sign, _) => None,
        Op::Apply(function, a) if instruction.ty == Type::Real(Shape::Scalar) => {
            Some((function, a))
        }
        _ => None,
    }
}

/// At least two calls each.
fn packs(program: &Program) -> Vec<Pack> {
    let dependences = dependences(program);
    let mut packs: BTreeMap<Key, Pack> = BTreeMap::new();
    // Calls, and operations since the last one, on the longest path among values of the same dependence: others are known before.
    let mut paths: Vec<(usize, usize)> = Vec::with_capacity(dependences.len());
    for (id, instruction) in (0..).map(ValueId).zip(&program.instructions) {
        let dependence = dependences[id.0 as usize];
        let operands = instruction.op.operands().into_iter();
        let (calls, operations) = operands
            .filter(|operand| dependences[operand.0 as usize] == dependence)
            .map(|operand| paths[operand.0 as usize])
            .max()
            .unwrap_or((0, 0));
        let call = call(instruction).filter(|_| dependence > Dependence::Nothing);
        paths.push(match call {
            Some(_) => (calls + 1, 0),
            None => (calls, operations + 1),
        });
        if let Some((function, _)) = call {
            let path = operations.max(CLOSE);
            let key = (dependence, calls, path, word(&FUNCTIONS, function));
            let pack = packs.entry(key).or_default();
            pack.function = Some(function);
            pack.calls.push(id);
        }
    }
    let argument = |call: &ValueId| program.instruction(*call).op.operands()[0];
    // Sine, cosine and tangent of one array share its reduction, so each takes the arguments of all three.
    let mut angles: BTreeMap<(Dependence, usize, usize), BTreeSet<ValueId>> = BTreeMap::new();
    for (&(dependence, calls, path, _), pack) in packs.iter().filter(|(_, pack)| pack.is_angular())
    {
        let shared = angles.entry((dependence, calls, path)).or_default();
        shared.extend(pack.calls.iter().map(argument));
    }
    for (&(dependence, calls, path, _), pack) in &mut packs {
        let own = || pack.calls.iter().map(argument).collect::<BTreeSet<_>>();
        let arguments = match pack.is_angular() {
            true => angles[&(dependence, calls, path)].clone(),
            false => own(),
        };
        pack.arguments = arguments.into_iter().collect();
        pack.arguments
            .sort_by_key(|&argument| (place(program, argument), argument));
    }
    packs.retain(|_, pack| pack.arguments.len() > 1);
    packs.into_values().collect()
}

impl Pack {
    fn is_angular(&self) -> bool {
        matches!(
            self.function,
            Some(Function::Sin | Function::Cos | Function::Tan)
        )
    }
}

/// The place of an entry in its input: in this order entries stand in the functions of a controller and its plant alike, so that where
/// both are inlined a compiler finds the same calls in them.
fn place(program: &Program, argument: ValueId) -> Option<(usize, usize)> {
    match program.instruction(argument).op {
        Op::Element(array, row, column)
            if matches!(program.instruction(array).op, Op::Input(_)) =>
        {
            Some((row, column))
        }
        _ => None,
    }
}

/// Rebuilds a program in an order in which the arguments of a pack come before it.
struct Mover<'p> {
    source: &'p Program,
    packs: &'p [Pack],
    pack_of: Vec<Option<usize>>,
    moved: Vec<Option<ValueId>>,
    program: Program,
}

impl Mover<'_> {
    /// Places a value behind all that it needs, which may be far behind it in the source.
    fn place(&mut self, id: ValueId) {
        let mut pending = vec![id];
        while let Some(&id) = pending.last() {
            if self.moved[id.0 as usize].is_some() {
                pending.pop();
                continue;
            }
            let before = pending.len();
            let pack = self.pack_of[id.0 as usize].map(|pack| &self.packs[pack]);
            let arguments = pack.map(|pack| pack.arguments.clone());
            let operands = arguments.unwrap_or_else(|| self.source.instruction(id).op.operands());
            pending.extend(
                operands
                    .into_iter()
                    .filter(|operand| self.moved[operand.0 as usize].is_none()),
            );
            if pending.len() == before {
                match pack {
                    Some(pack) => self.append_pack(pack),
                    None => self.append(id),
                }
            }
        }
    }

    fn append(&mut self, id: ValueId) {
        let mut instruction = self.source.instruction(id).clone();
        instruction.op = instruction.op.map_operands(|operand| self.at(operand));
        self.push(id, instruction);
    }

    /// [f(a), f(b), ..] == f([a, b, ..]) (exact)
    fn append_pack(&mut self, pack: &Pack) {
        let arguments: Vec<ValueId> = pack.arguments.iter().map(|&id| self.at(id)).collect();
        let shape = Shape::Vector(arguments.len());
        let arguments = self.program.array(shape, arguments);
        let function = pack.function.expect("invariant: a pack has a function");
        let values = self.program.push(Op::Apply(function, arguments));
        for &call in &pack.calls {
            let argument = self.source.instruction(call).op.operands()[0];
            let row = pack.arguments.iter().position(|&known| known == argument);
            let row = row.expect("invariant: a pack has the arguments of its calls");
            let op = Op::Element(values, row, 0);
            let instruction = self.source.instruction(call).clone();
            self.push(call, Instruction { op, ..instruction });
        }
    }

    fn at(&self, id: ValueId) -> ValueId {
        self.moved[id.0 as usize].expect("invariant: operands are placed before")
    }

    fn push(&mut self, id: ValueId, instruction: Instruction) {
        let next = u32::try_from(self.program.instructions.len());
        let next = ValueId(next.expect("invariant: fewer than 2^32 instructions"));
        self.program.instructions.push(instruction);
        self.moved[id.0 as usize] = Some(next);
    }
}
