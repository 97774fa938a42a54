//! The frame of an emitted program: which quantities are inputs, which are replaced, which are results.

use std::collections::{BTreeMap, BTreeSet};

use nsv_spec::expr::arena::{ConstantId, ParameterId};

use super::{Context, Lowering};
use crate::derive::law::Law;
use crate::derive::symbol::{Side, Symbol, Term, uniform};
use crate::ir::{Input, Op, Program, Shape, ValueId};

/// What a program is given and what it returns.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// Inputs in order: quantity, name of the input, shape.
    pub inputs: Vec<(String, String, Shape)>,
    /// Quantities computed by another expression than the law's.
    pub replaced: BTreeMap<String, Symbol>,
    /// Results in order: name of the output, quantity.
    pub outputs: Vec<(String, String)>,
    /// Prefix of the inputs that hold the plant's parameters; the design's are `params.`.
    pub plant_prefix: &'static str,
}

/// Context of an emitted program: numbers are literals.
struct Literal<'l, 'm> {
    law: &'l Law<'m>,
    at: BTreeMap<String, usize>,
    plant_prefix: &'static str,
}

/// Lowers what the outputs of a frame need.
pub fn program(law: &Law, name: &str, frame: &Frame) -> Program {
    let at = frame
        .inputs
        .iter()
        .enumerate()
        .map(|(at, (quantity, _, _))| (quantity.clone(), at))
        .collect();
    let mut lowering = Lowering::new(
        law,
        Literal {
            law,
            at,
            plant_prefix: frame.plant_prefix,
        },
    );
    lowering.program.name = name.to_string();
    let input = |(_, name, shape): &(String, String, Shape)| Input {
        name: name.clone(),
        shape: *shape,
    };
    lowering.program.inputs = frame.inputs.iter().map(input).collect();
    lowering.replaced = frame.replaced.clone();
    // In the order of the law, so that the program reads from the reference to the control as the equations do.
    let needed = needed(law, frame);
    for equation in law
        .equations()
        .iter()
        .filter(|equation| needed.contains(&equation.name))
    {
        lowering.quantity(&equation.name);
    }
    let outputs = frame
        .outputs
        .iter()
        .map(|(output, quantity)| (output.clone(), lowering.quantity(quantity)))
        .collect();
    let (mut program, _) = lowering.finish();
    program.outputs = outputs;
    program
}

/// Quantities that the outputs of a frame depend on.
pub(super) fn needed(law: &Law, frame: &Frame) -> BTreeSet<String> {
    let mut needed: BTreeSet<String> = BTreeSet::new();
    let mut pending: Vec<String> = frame
        .outputs
        .iter()
        .map(|(_, quantity)| quantity.clone())
        .collect();
    while let Some(quantity) = pending.pop() {
        let given = frame.inputs.iter().any(|(input, _, _)| *input == quantity);
        if given || !needed.insert(quantity.clone()) {
            continue;
        }
        let own = law.equation(&quantity).map(|equation| &equation.rhs);
        if let Some(rhs) = frame.replaced.get(&quantity).or(own) {
            law.names_in(rhs, &mut pending);
        }
    }
    needed
}

impl Context for Literal<'_, '_> {
    fn quantity(&mut self, program: &mut Program, quantity: &str) -> Option<ValueId> {
        self.at.get(quantity).map(|&at| program.push(Op::Input(at)))
    }

    fn literal(&mut self, program: &mut Program, shape: Shape, data: &[f64]) -> ValueId {
        program.constant(shape, data.to_vec())
    }

    fn diagonal(&mut self, program: &mut Program, values: &[f64]) -> ValueId {
        match uniform(values) {
            Some(value) => program.scalar(value),
            None => program.constant(Shape::Vector(values.len()), values.to_vec()),
        }
    }

    fn spec_number(&mut self, program: &mut Program, value: f64) -> ValueId {
        program.scalar(value)
    }

    fn constant(&mut self, program: &mut Program, id: ConstantId) -> ValueId {
        let shape = self
            .law
            .shape_of(&Term::Constant(id).into())
            .expect("invariant: constants are real");
        program.constant(
            shape,
            self.law.model.constants[id.0 as usize].value.data.clone(),
        )
    }

    fn parameter(&mut self, program: &mut Program, id: ParameterId, side: Side) -> ValueId {
        let prefix = if side == Side::Plant {
            self.plant_prefix
        } else {
            "params."
        };
        let name = format!("{prefix}{}", self.law.model.parameters[id.0 as usize].name);
        let at = program
            .inputs
            .iter()
            .position(|input| input.name == name)
            .unwrap_or_else(|| {
                program.inputs.push(Input {
                    name,
                    shape: Shape::Scalar,
                });
                program.inputs.len() - 1
            });
        program.push(Op::Input(at))
    }
}
