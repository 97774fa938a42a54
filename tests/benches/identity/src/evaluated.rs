//! A program evaluated at points.

use std::ops::Range;

use nsv_codegen::ir::eval::Evaluator;
use nsv_codegen::ir::{Program, ValueId, Values};

use crate::layout::Layout;

/// A program with its evaluator.
pub struct Evaluated<'p> {
    evaluator: Evaluator<'p>,
    /// Its inputs and where they stand in a point.
    inputs: Vec<(String, Range<usize>)>,
    values: Values,
    /// The results and where each is to stand.
    outputs: Vec<(ValueId, Range<usize>)>,
}

impl<'p> Evaluated<'p> {
    /// The program's results at these places.
    pub fn new(program: &'p Program, layout: &Layout, places: &[(String, Range<usize>)]) -> Self {
        let output = |(name, place): &(String, Range<usize>)| {
            let (_, value) = program.outputs.iter().find(|(output, _)| output == name).expect("the program gives it");
            (*value, place.clone())
        };
        let inputs: Vec<(String, Range<usize>)> = program
            .inputs
            .iter()
            .map(|input| {
                let place = layout.input(&input.name).unwrap_or_else(|| panic!("a point has the input {}", input.name));
                (input.name.clone(), place)
            })
            .collect();
        let values = inputs.iter().map(|(name, place)| (name.clone(), vec![0.0; place.len()])).collect();
        Evaluated { evaluator: Evaluator::new(program), values, inputs, outputs: places.iter().map(output).collect() }
    }

    /// Writes the results of a point.
    pub fn run(&mut self, point: &[f64], results: &mut [f64]) {
        for (name, place) in &self.inputs {
            self.values.get_mut(name).expect("made with the inputs").copy_from_slice(&point[place.clone()]);
        }
        self.evaluator.run(&self.values).expect("inputs have the shapes of the program");
        for (value, place) in &self.outputs {
            results[place.clone()].copy_from_slice(self.evaluator.value(*value));
        }
    }
}
