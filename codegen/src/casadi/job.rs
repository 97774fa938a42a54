//! What is differentiated by what, and the inputs and outputs of the answer.

use serde::{Deserialize, Serialize};

use crate::ir::build::size;
use crate::ir::{Input, Program, Shape};

/// Highest order of rates.
pub(crate) const MAX_ORDER: usize = 4;

/// Which derivatives of a formula are asked for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Job {
    /// Total derivatives of every output `q` along the jets of the varying inputs `x`: outputs `q.rate1 ..`, further inputs
    /// `x.rate1 ..`; the other inputs are constant.
    Rates {
        /// Highest derivative, from 1.
        order: usize,
        /// Inputs that vary with time.
        varying: Vec<String>,
    },
    /// Partial derivatives `q/x` of every output by each of these inputs: size(q) x size(x), entries in row-major order.
    Jacobian {
        /// Inputs to differentiate by.
        wrt: Vec<String>,
    },
    /// Gradients `q/x` and second partial derivatives `q/x/y` of scalar outputs.
    Hessian {
        /// Inputs to differentiate by.
        wrt: Vec<String>,
    },
}

impl Job {
    /// Inputs of the answer: those of the formula, then the rates of each varying input.
    pub(crate) fn inputs(&self, formula: &Program) -> Vec<Input> {
        let mut inputs = formula.inputs.clone();
        if let Job::Rates { order, varying } = self {
            for name in varying {
                let shape = shape_of(formula, name);
                inputs.extend((1..=*order).map(|k| Input {
                    name: format!("{name}.rate{k}"),
                    shape,
                }));
            }
        }
        inputs
    }

    /// Names and shapes of the answer's outputs, in order.
    pub(crate) fn outputs(&self, formula: &Program) -> Vec<(String, Shape)> {
        let mut outputs = Vec::new();
        for (q, id) in &formula.outputs {
            let shape = formula.shape(*id);
            match self {
                Job::Rates { order, .. } => {
                    outputs.extend((1..=*order).map(|k| (format!("{q}.rate{k}"), shape)))
                }
                Job::Jacobian { wrt } => {
                    outputs.extend(wrt.iter().map(|x| {
                        (
                            format!("{q}/{x}"),
                            Shape::Matrix(size(shape), width(formula, x)),
                        )
                    }));
                }
                Job::Hessian { wrt } => {
                    assert_eq!(shape, Shape::Scalar, "invariant: a Hessian is of a scalar");
                    outputs.extend(
                        wrt.iter()
                            .map(|x| (format!("{q}/{x}"), Shape::Vector(width(formula, x)))),
                    );
                    for (x, y) in wrt.iter().flat_map(|x| wrt.iter().map(move |y| (x, y))) {
                        outputs.push((
                            format!("{q}/{x}/{y}"),
                            Shape::Matrix(width(formula, x), width(formula, y)),
                        ));
                    }
                }
            }
        }
        outputs
    }

    /// What is added to the formula's name.
    pub(crate) fn suffix(&self) -> &'static str {
        match self {
            Job::Rates { .. } => "rates",
            Job::Jacobian { .. } => "jacobian",
            Job::Hessian { .. } => "hessian",
        }
    }

    /// Panics unless the job fits the formula.
    pub(crate) fn assert_fits(&self, formula: &Program) {
        if let Job::Rates { order, .. } = self {
            assert!(
                (1..=MAX_ORDER).contains(order),
                "invariant: rates up to order {MAX_ORDER}, not {order}"
            );
        }
        let (Job::Rates { varying: names, .. }
        | Job::Jacobian { wrt: names }
        | Job::Hessian { wrt: names }) = self;
        for (position, name) in names.iter().enumerate() {
            shape_of(formula, name);
            assert!(
                !names[..position].contains(name),
                "invariant: `{name}` is named once"
            );
        }
    }
}

fn shape_of(formula: &Program, name: &str) -> Shape {
    let input = formula.inputs.iter().find(|input| input.name == name);
    input
        .unwrap_or_else(|| panic!("invariant: `{name}` is an input of `{}`", formula.name))
        .shape
}

fn width(formula: &Program, name: &str) -> usize {
    size(shape_of(formula, name))
}
