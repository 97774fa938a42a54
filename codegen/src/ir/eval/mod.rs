//! The meaning of a program: every operation evaluated in `f64` with a fixed order of roundings, elementary functions by `nsv-math`.
//! The runtime implements the same definitions independently, and tests compare the two to the last bit.

mod kernel;
mod linear;
mod operation;
mod scalar;

use std::fmt::{self, Display, Formatter};

pub(crate) use linear::SWEEPS;
pub(crate) use operation::Tables;
pub(crate) use scalar::comparison;

use super::build::size;
use super::{Op, Program, Type, ValueId, Values};

/// Inputs that do not fit the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EvalError {
    /// An input of the program is not given.
    MissingInput {
        /// Its name.
        name: String,
    },
    /// An input has the wrong number of entries.
    InputSize {
        /// Its name.
        name: String,
        /// Entries of its shape.
        expected: usize,
        /// Entries given.
        found: usize,
    },
}

impl Display for EvalError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            EvalError::MissingInput { name } => write!(f, "input `{name}` is missing"),
            EvalError::InputSize {
                name,
                expected,
                found,
            } => write!(f, "input `{name}` has {found} entries, expected {expected}"),
        }
    }
}

impl std::error::Error for EvalError {}

/// The outputs of a verified program. Further entries of `inputs` are ignored; a truth value is 1 or 0.
pub fn eval(program: &Program, inputs: &Values) -> Result<Values, EvalError> {
    let mut evaluator = Evaluator::new(program);
    evaluator.run(inputs)?;
    Ok(evaluator.outputs())
}

/// The outputs and every named value of a verified program, as [`eval`].
pub fn eval_named(program: &Program, inputs: &Values) -> Result<Values, EvalError> {
    let mut evaluator = Evaluator::new(program);
    evaluator.run(inputs)?;
    let mut values = evaluator.named();
    values.append(&mut evaluator.outputs());
    Ok(values)
}

/// A verified program with memory for its values, to evaluate it many times.
pub struct Evaluator<'p> {
    program: &'p Program,
    tables: Tables,
    /// Where the entries of each value start in `memory`, and one more for the end.
    starts: Vec<usize>,
    memory: Vec<f64>,
}

impl<'p> Evaluator<'p> {
    /// Memory for the values of `program`.
    pub fn new(program: &'p Program) -> Self {
        let mut starts = vec![0];
        let mut end = 0;
        for instruction in &program.instructions {
            end += entries(instruction.ty);
            starts.push(end);
        }
        Evaluator {
            program,
            tables: Tables::of(program),
            starts,
            memory: vec![0.0; end],
        }
    }

    /// Computes every value. Further entries of `inputs` are ignored.
    pub fn run(&mut self, inputs: &Values) -> Result<(), EvalError> {
        let given = self.program.inputs.iter().map(|input| {
            let data = inputs
                .get(&input.name)
                .ok_or_else(|| EvalError::MissingInput {
                    name: input.name.clone(),
                })?;
            let (expected, found) = (size(input.shape), data.len());
            if expected == found {
                Ok(data)
            } else {
                Err(EvalError::InputSize {
                    name: input.name.clone(),
                    expected,
                    found,
                })
            }
        });
        let given = given.collect::<Result<Vec<&Vec<f64>>, EvalError>>()?;
        for (instruction, range) in self.program.instructions.iter().zip(self.starts.windows(2)) {
            let (earlier, rest) = self.memory.split_at_mut(range[0]);
            let out = &mut rest[..range[1] - range[0]];
            if let Op::Input(index) = instruction.op {
                out.copy_from_slice(given[index]);
            } else {
                let starts = &self.starts;
                let value =
                    |id: ValueId| &earlier[starts[id.0 as usize]..starts[id.0 as usize + 1]];
                self.tables.apply(self.program, &instruction.op, value, out);
            }
        }
        Ok(())
    }

    /// The entries of a value in the last run.
    pub fn value(&self, id: ValueId) -> &[f64] {
        let index = id.0 as usize;
        &self.memory[self.starts[index]..self.starts[index + 1]]
    }

    /// The outputs of the last run.
    pub fn outputs(&self) -> Values {
        self.program
            .outputs
            .iter()
            .map(|(name, id)| (name.clone(), self.value(*id).to_vec()))
            .collect()
    }

    /// Every named value of the last run.
    pub fn named(&self) -> Values {
        let values = self.program.instructions.iter().zip(self.starts.windows(2));
        values
            .filter_map(|(instruction, range)| {
                Some((
                    instruction.name.clone()?,
                    self.memory[range[0]..range[1]].to_vec(),
                ))
            })
            .collect()
    }
}

/// Number of entries that hold a value; a truth value is one entry, 1 or 0.
pub(crate) fn entries(ty: Type) -> usize {
    match ty {
        Type::Bool => 1,
        Type::Real(shape) => size(shape),
        Type::Ldlt(rows) => rows * rows,
    }
}

#[cfg(test)]
mod tests;
