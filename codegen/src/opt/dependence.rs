//! What values depend on, as far as it decides how often they are computed: for all runs, for each run, for each sample of all runs, or
//! for each sample of each run.

use crate::ir::{Op, Program, ValueId};

/// What a value depends on, each including those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Dependence {
    /// Literals.
    Nothing,
    /// Parameters: inputs `params.*` and `plant.*`.
    Parameters,
    /// Time: the input `t`.
    Time,
    /// States: any other input.
    States,
}

impl Dependence {
    /// Of an input.
    fn of_input(name: &str) -> Dependence {
        match name {
            "t" => Dependence::Time,
            _ if name.starts_with("params.") || name.starts_with("plant.") => {
                Dependence::Parameters
            }
            _ => Dependence::States,
        }
    }
}

/// The dependence of each value.
pub fn dependences(program: &Program) -> Vec<Dependence> {
    let mut dependences = Dependences::default();
    dependences.extend(program);
    dependences.known
}

/// The dependences of a program that grows.
#[derive(Debug, Default)]
pub(super) struct Dependences {
    known: Vec<Dependence>,
}

impl Dependences {
    /// Of a value of the program, which is the one of the calls before or what it has grown to.
    pub(super) fn of(&mut self, program: &Program, id: ValueId) -> Dependence {
        self.extend(program);
        self.known[id.0 as usize]
    }

    fn extend(&mut self, program: &Program) {
        for instruction in &program.instructions[self.known.len()..] {
            let operands = instruction.op.operands().into_iter();
            let dependence = match instruction.op {
                Op::Input(position) => Dependence::of_input(&program.inputs[position].name),
                _ => operands
                    .map(|operand| self.known[operand.0 as usize])
                    .max()
                    .unwrap_or(Dependence::Nothing),
            };
            self.known.push(dependence);
        }
    }
}

/// Whether the output of a name, if there is one, uses an input.
pub fn uses(program: &Program, output: &str, input: &str) -> bool {
    let mut reached = vec![false; program.instructions.len()];
    for (name, id) in &program.outputs {
        reached[id.0 as usize] |= name == output;
    }
    for (index, instruction) in program.instructions.iter().enumerate().rev() {
        if !reached[index] {
            continue;
        }
        if let Op::Input(position) = instruction.op
            && program.inputs[position].name == input
        {
            return true;
        }
        for operand in instruction.op.operands() {
            reached[operand.0 as usize] = true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_output_uses_the_inputs_on_its_way() {
        let text = "input x: real\ninput params.m: real\n%0: real = input x\n%1: real = input params.m\n%2: real = exp %1\n\
                    %3: real = mul %2, %0\noutput drift = %3\noutput diffusion = %2";
        let program: Program = text.parse().expect("a program");
        assert!(uses(&program, "drift", "x") && uses(&program, "drift", "params.m"));
        assert!(!uses(&program, "diffusion", "x") && uses(&program, "diffusion", "params.m"));
        assert!(!uses(&program, "none", "x"));
    }
}
