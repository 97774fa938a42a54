//! Every derivative is zero, answered as CasADi would: by a tape, which is decoded.

use nsv_codegen::casadi::document::Tape;
use nsv_codegen::casadi::{Error, Job, Question, decode};
use nsv_codegen::derive::Partials;
use nsv_codegen::ir::Program;
use nsv_codegen::ir::build::size;

pub struct Flat;

impl Partials for Flat {
    fn partials(&mut self, formula: &Program, job: &Job) -> Result<Program, Error> {
        let tape = Tape {
            constants: Vec::new(),
            nodes: Vec::new(),
            outputs: outputs(formula, job),
        };
        decode(&Question::new(formula, job), &tape).map_err(|error| Error::Tape {
            formula: formula.name.clone(),
            error,
        })
    }
}

/// The outputs that the job asks for, without an entry that is not zero.
fn outputs(formula: &Program, job: &Job) -> Vec<(String, Vec<Option<usize>>)> {
    let width = |name: &String| {
        let input = formula.inputs.iter().find(|input| input.name == *name);
        size(input.expect("an input of the formula").shape)
    };
    let mut outputs = Vec::new();
    for (name, id) in &formula.outputs {
        let rows = size(formula.shape(*id));
        let mut zero = |name: String, entries: usize| outputs.push((name, vec![None; entries]));
        match job {
            Job::Rates { order, .. } => {
                (1..=*order).for_each(|order| zero(format!("{name}.rate{order}"), rows));
            }
            Job::Jacobian { wrt } => {
                wrt.iter()
                    .for_each(|x| zero(format!("{name}/{x}"), rows * width(x)));
            }
            Job::Hessian { wrt } => {
                wrt.iter()
                    .for_each(|x| zero(format!("{name}/{x}"), width(x)));
                for (x, y) in wrt.iter().flat_map(|x| wrt.iter().map(move |y| (x, y))) {
                    zero(format!("{name}/{x}/{y}"), width(x) * width(y));
                }
            }
        }
    }
    outputs
}
