//! What values depend on, as far as it decides how often they are computed: for all runs, for each run, for each sample of all runs, or
//! for each sample of each run.

use crate::ir::{Op, Program};

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
    let mut dependences: Vec<Dependence> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let operands = instruction.op.operands().into_iter();
        let dependence = match instruction.op {
            Op::Input(position) => Dependence::of_input(&program.inputs[position].name),
            _ => operands
                .map(|operand| dependences[operand.0 as usize])
                .max()
                .unwrap_or(Dependence::Nothing),
        };
        dependences.push(dependence);
    }
    dependences
}
