//! A program in pieces that are run as often as needed: what depends on parameters alone once for a run, what depends on time too once for
//! a sample of all runs, and the rest for each sample of each run. Exact: every operation is done once, on the same operands.

use std::collections::{BTreeMap, BTreeSet};

use super::cost::{self, Cost};
use super::dependence::{Dependence, dependences};
use crate::ir::{Input, Op, Program, Type, ValueId};

/// The pieces of a program. Values that cross from one to another are outputs there and inputs `prepared.*` and `clock.*` here.
#[derive(Clone, Debug, PartialEq)]
pub struct Pieces {
    /// What depends on parameters, if anything is worth it.
    pub prepare: Option<Program>,
    /// What depends on time and parameters, if anything is worth it.
    pub clock: Option<Program>,
    /// The rest: every output.
    pub rest: Program,
}

/// Splits a program.
pub fn hoist(program: &Program) -> Pieces {
    let mut splitter = Splitter::new(program);
    let roots: Vec<(String, ValueId)> = program.outputs.clone();
    let rest = splitter.piece(Dependence::States, &roots);
    let clock = splitter.crossing(Dependence::Time);
    let clock = (!clock.is_empty()).then(|| splitter.piece(Dependence::Time, &clock));
    let prepare = splitter.crossing(Dependence::Parameters);
    let prepare = (!prepare.is_empty()).then(|| splitter.piece(Dependence::Parameters, &prepare));
    let named = |program: Program, name: &str| Program {
        name: name.to_owned(),
        ..program
    };
    Pieces {
        prepare: prepare.map(|program| named(program, "prepare")),
        clock: clock.map(|program| named(program, "clock")),
        rest,
    }
}

/// A program of what one output needs, with the inputs that it needs.
pub fn part(program: &Program, output: &str) -> Program {
    let outputs = program.outputs.iter().filter(|(name, _)| name == output);
    let outputs: Vec<(String, ValueId)> = outputs.cloned().collect();
    let part = Splitter::new(program).piece(Dependence::Nothing, &outputs);
    Program {
        name: output.to_owned(),
        ..part
    }
}

struct Splitter<'p> {
    program: &'p Program,
    dependences: Vec<Dependence>,
    /// Whether the value is computed where it is used instead of crossing.
    local: Vec<bool>,
    /// The quantity that each value is computed for first.
    purpose: Vec<String>,
    /// Names of values that cross.
    names: BTreeMap<ValueId, String>,
    taken: BTreeSet<String>,
}

impl<'p> Splitter<'p> {
    fn new(program: &'p Program) -> Self {
        let dependences = dependences(program);
        Splitter {
            program,
            local: local(program, &dependences),
            dependences,
            purpose: purposes(program),
            names: BTreeMap::new(),
            taken: program
                .instructions
                .iter()
                .filter_map(|instruction| instruction.name.clone())
                .collect(),
        }
    }

    /// The values of a dependence that cross to pieces made so far, by their names there.
    fn crossing(&self, dependence: Dependence) -> Vec<(String, ValueId)> {
        let of = |id: ValueId| self.dependences[id.0 as usize];
        let found = self.names.iter().filter(|(id, _)| of(**id) == dependence);
        found.map(|(id, name)| (name.clone(), *id)).collect()
    }

    fn crosses(&self, id: ValueId, to: Dependence) -> bool {
        self.dependences[id.0 as usize] < to && !self.local[id.0 as usize]
    }

    /// The piece that computes `roots`, values of at most this dependence.
    fn piece(&mut self, dependence: Dependence, roots: &[(String, ValueId)]) -> Program {
        let program = self.program;
        let mut needed = vec![false; program.instructions.len()];
        for (_, id) in roots {
            needed[id.0 as usize] = true;
        }
        let mut piece = Program {
            instructions: Vec::new(),
            outputs: Vec::new(),
            inputs: Vec::new(),
            ..program.clone()
        };
        for index in (0..needed.len()).rev() {
            let id =
                ValueId(u32::try_from(index).expect("invariant: fewer than 2^32 instructions"));
            if needed[index] && !self.crosses(id, dependence) {
                for operand in program.instruction(id).op.operands() {
                    needed[operand.0 as usize] = true;
                }
            }
        }
        piece.inputs = self.own_inputs(&needed);
        let positions: BTreeMap<String, usize> = piece
            .inputs
            .iter()
            .map(|input| input.name.clone())
            .zip(0..)
            .collect();
        let mut moved = vec![ValueId(0); needed.len()];
        for (id, instruction) in (0..).map(ValueId).zip(&program.instructions) {
            if !needed[id.0 as usize] {
                continue;
            }
            let mut instruction = instruction.clone();
            instruction.op = if self.crosses(id, dependence) {
                instruction.name = None;
                instruction.origin = None;
                self.import(&mut piece, id)
            } else if let Op::Input(position) = instruction.op {
                Op::Input(positions[&program.inputs[position].name])
            } else {
                instruction
                    .op
                    .map_operands(|operand| moved[operand.0 as usize])
            };
            moved[id.0 as usize] = ValueId(
                u32::try_from(piece.instructions.len())
                    .expect("invariant: fewer than 2^32 instructions"),
            );
            piece.instructions.push(instruction);
        }
        piece.outputs = roots
            .iter()
            .map(|(name, id)| (name.clone(), moved[id.0 as usize]))
            .collect();
        super::dead_code::run(piece)
    }

    /// The inputs of the program that are needed, in their order.
    fn own_inputs(&self, needed: &[bool]) -> Vec<Input> {
        let mut used = vec![false; self.program.inputs.len()];
        for (instruction, needed) in self.program.instructions.iter().zip(needed) {
            if let Op::Input(position) = instruction.op {
                used[position] |= needed;
            }
        }
        let inputs = self.program.inputs.iter().zip(used);
        inputs
            .filter(|(_, used)| *used)
            .map(|(input, _)| input.clone())
            .collect()
    }

    /// The input that stands for a value of an earlier piece.
    fn import(&mut self, piece: &mut Program, id: ValueId) -> Op {
        let record = match self.dependences[id.0 as usize] {
            Dependence::Time => "clock",
            _ => "prepared",
        };
        let name = self.name(id);
        piece.inputs.push(Input {
            name: format!("{record}.{name}"),
            shape: self.program.shape(id),
        });
        Op::Input(piece.inputs.len() - 1)
    }

    /// The name under which a value crosses: its own, or that of the quantity it is computed for with a number.
    fn name(&mut self, id: ValueId) -> String {
        if let Some(name) = self.names.get(&id) {
            return name.clone();
        }
        let purpose = self.purpose[id.0 as usize].clone();
        let name = match self.program.instruction(id).name {
            Some(_) => purpose,
            None => (1..)
                .map(|number| format!("{purpose}_{number}"))
                .find(|name| !self.taken.contains(name))
                .expect("invariant: the candidates do not end"),
        };
        self.taken.insert(name.clone());
        self.names.insert(id, name.clone());
        name
    }
}

/// Values that are computed where they are used: leaves, truth values, entries, and what costs nothing on the way from them.
fn local(program: &Program, dependences: &[Dependence]) -> Vec<bool> {
    let mut local: Vec<bool> = Vec::with_capacity(dependences.len());
    for (instruction, dependence) in program.instructions.iter().zip(dependences) {
        let free = cost::of(program, instruction) == Cost::default();
        let operands = instruction.op.operands();
        let family = |id: ValueId| program.instruction(id).op.is_family();
        local.push(match instruction.op {
            Op::Const(_) | Op::Input(_) => true,
            Op::Element(array, ..) => !family(array) || *dependence == Dependence::Nothing,
            _ if instruction.ty == Type::Bool => true,
            // Entries of a family have names, the values as a whole have not; factors stay with what they solve.
            Op::Ldlt(_) => true,
            ref op if op.is_family() => true,
            _ => {
                *dependence == Dependence::Nothing
                    || free && operands.iter().all(|operand| local[operand.0 as usize])
            }
        });
    }
    local
}

/// The name of each value, or of the first named value or output that uses it.
fn purposes(program: &Program) -> Vec<String> {
    let mut purposes = vec![String::new(); program.instructions.len()];
    for (name, id) in program.outputs.iter().rev() {
        purposes[id.0 as usize] = name.rsplit('.').next().unwrap_or(name).to_owned();
    }
    for index in (0..purposes.len()).rev() {
        let instruction = &program.instructions[index];
        if let Some(name) = &instruction.name {
            purposes[index].clone_from(name);
        }
        for operand in instruction.op.operands() {
            purposes[operand.0 as usize] = purposes[index].clone();
        }
    }
    purposes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Values, eval, random};
    use crate::opt::optimise;

    /// A random program of time, parameters and states.
    fn mixed(seed: u64) -> Program {
        let mut program = random::program(seed, 200);
        for (input, name) in program.inputs.iter_mut().zip(["t", "params.a", "params.b"]) {
            input.name = name.to_owned();
        }
        optimise(program)
    }

    /// Runs the pieces one after another.
    fn run(pieces: &Pieces, inputs: &Values) -> Values {
        let mut values = inputs.clone();
        for (piece, record) in [(&pieces.prepare, "prepared"), (&pieces.clock, "clock")] {
            if let Some(piece) = piece {
                let results = eval::eval(piece, &values).expect("values");
                values.extend(
                    results
                        .into_iter()
                        .map(|(name, data)| (format!("{record}.{name}"), data)),
                );
            }
        }
        eval::eval(&pieces.rest, &values).expect("values")
    }

    fn bits(values: &Values) -> Vec<(&String, Vec<u64>)> {
        let one_nan = |value: &f64| if value.is_nan() { f64::NAN } else { *value }.to_bits();
        let entries = values.iter();
        entries
            .map(|(name, data)| (name, data.iter().map(one_nan).collect()))
            .collect()
    }

    #[test]
    fn pieces_give_the_bits_of_the_program() {
        let (mut prepared, mut clocked) = (0, 0);
        for seed in 0..100 {
            let program = mixed(seed);
            let pieces = hoist(&program);
            for piece in [&pieces.prepare, &pieces.clock].into_iter().flatten() {
                piece.assert_sound();
            }
            pieces.rest.assert_sound();
            prepared += usize::from(pieces.prepare.is_some());
            clocked += usize::from(pieces.clock.is_some());
            for draw in 0..8 {
                let inputs = random::inputs(&program, draw);
                let expected = eval::eval(&program, &inputs).expect("values");
                assert_eq!(
                    bits(&run(&pieces, &inputs)),
                    bits(&expected),
                    "program {seed}\n{program}"
                );
            }
        }
        assert!(prepared > 40 && clocked > 20, "{prepared} {clocked}");
    }

    #[test]
    fn the_rest_repeats_no_operation_of_time_and_parameters() {
        let text = "input t: real\ninput x: vec2\ninput params.m: real\n%0: real = input t\n%1: vec2 = input x\n%2: real = input params.m\n\
                    %3: real = sin %0\n%4 y_r: real = mul %3, %2\n%5: real = exp %2\n%6: vec2 = mul %1, %5\n%7 u: vec2 = mul %6, %4\n\
                    output u = %7\noutput y_r = %4";
        let program: Program = text.parse().expect("a program");
        let pieces = hoist(&program);
        let names = |program: &Option<Program>| -> Vec<String> {
            program
                .iter()
                .flat_map(|p| p.outputs.iter().map(|(name, _)| name.clone()))
                .collect()
        };
        assert_eq!(names(&pieces.prepare), ["u_1"]);
        assert_eq!(names(&pieces.clock), ["y_r"]);
        let inputs: Vec<&str> = pieces
            .rest
            .inputs
            .iter()
            .map(|input| input.name.as_str())
            .collect();
        assert_eq!(inputs, ["x", "clock.y_r", "prepared.u_1"]);
        let count = |program: &Program| cost::count(program);
        let parts = pieces
            .prepare
            .iter()
            .chain(&pieces.clock)
            .chain([&pieces.rest]);
        assert_eq!(parts.map(count).sum::<Cost>(), count(&program));
    }

    #[test]
    fn a_part_needs_no_more_than_its_output() {
        let text = "input x: vec2\ninput params.m: real\n%0: vec2 = input x\n%1: real = input params.m\n%2: vec2 = sin %0\n%3: real = exp %1\n\
                    %4: vec2 = mul %2, %3\noutput drift = %4\noutput diffusion = %2";
        let part = part(&text.parse().expect("a program"), "diffusion");
        part.assert_sound();
        let expected = "program diffusion\ninput x: vec2\n%0: vec2 = input x\n%1: vec2 = sin %0\noutput diffusion = %1\n";
        assert_eq!(part.to_string(), expected);
    }

    #[test]
    fn a_program_of_states_alone_is_not_split() {
        let program = optimise(random::program(1, 150));
        let pieces = hoist(&program);
        assert_eq!((pieces.prepare, pieces.clock), (None, None));
        assert_eq!(cost::count(&pieces.rest), cost::count(&program));
    }
}
