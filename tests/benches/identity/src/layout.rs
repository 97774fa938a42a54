//! A specification, what it compiles to, and where each input stands in a point.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use nsv_codegen::casadi::{Environment, Provider};
use nsv_codegen::driver::lower;
use nsv_codegen::ir::build::size;
use nsv_codegen::ir::{Program, Type};
use nsv_codegen::lower::Programs;
use nsv_spec::model::Model;

use crate::emitted::{Function, Module};

/// Model and lowered programs of a committed specification.
pub fn compiled(name: &str) -> (Model, Programs) {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../../specs/{name}.yaml"));
    let (model, _) = nsv_spec::load(&path).unwrap_or_else(|faults| panic!("{}: {:?}", path.display(), faults.items));
    let mut provider = Provider::new(Environment::offline(path.with_file_name("partials")), |_| {});
    let programs = lower(&model, &mut provider).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    (model, programs)
}

/// Where the inputs of all functions stand in a point: time, plant state, controller states, parameters of design and plant, control.
pub struct Layout {
    /// Plant state: measured states of all blocks, further states of a flown plant, exosystems.
    pub x: Range<usize>,
    /// States of the exosystems.
    pub exosystems: Range<usize>,
    /// Controller states.
    pub state: Range<usize>,
    /// Parameters of the controller's design, and of the plant for its own function.
    pub params: Range<usize>,
    /// Parameters of the plant where those of the design are given too.
    pub plant: Range<usize>,
    /// Control within its limits.
    pub u_sat: Range<usize>,
    /// The inputs of the programs by name.
    pub inputs: Vec<(String, Range<usize>)>,
}

impl Layout {
    /// The layout of a module.
    pub fn new<M: Module>(model: &Model, programs: &Programs) -> Self {
        let sizes = results(&programs.initial, &M::Initial::results());
        let states: usize = sizes.iter().map(|(_, entries)| entries.len()).sum();
        let channels = model.inputs.len();
        let x = 1..1 + M::INITIAL_STATE.len();
        let state = x.end..x.end + states;
        let params = state.end..state.end + M::PARAMS.len();
        let plant = params.end..params.end + M::PARAMS.len();
        let u_sat = plant.end..plant.end + channels;
        let moved = |entries: &Range<usize>, by: usize| entries.start + by..entries.end + by;
        let mut inputs = vec![("t".to_owned(), 0..1), ("x".to_owned(), x.clone()), ("u_sat".to_owned(), u_sat.clone())];
        inputs.extend((0..model.blocks.len()).map(|i| (format!("x{}", i + 1), moved(&(i * channels..(i + 1) * channels), x.start))));
        inputs.extend(sizes.iter().map(|(name, entries)| (format!("state.{name}"), moved(entries, state.start))));
        for (prefix, range) in [("params", &params), ("plant", &plant)] {
            inputs.extend(M::PARAMS.iter().zip(range.clone()).map(|(name, at)| (format!("{prefix}.{name}"), at..at + 1)));
        }
        let waves = programs.lyapunov.inputs.iter().filter(|input| input.name.starts_with('w'));
        let exosystems = x.end - waves.clone().map(|input| size(input.shape)).sum::<usize>()..x.end;
        let mut start = exosystems.start;
        for input in waves {
            inputs.push((input.name.clone(), start..start + size(input.shape)));
            start += size(input.shape);
        }
        Layout { x, exosystems, state, params, plant, u_sat, inputs }
    }

    /// Number of entries of a point.
    pub fn size(&self) -> usize {
        self.u_sat.end
    }

    /// Where an input stands.
    pub fn input(&self, name: &str) -> Option<Range<usize>> {
        self.inputs.iter().find(|(known, _)| known == name).map(|(_, range)| range.clone())
    }
}

/// Where each result stands among all of them, by the names in this order.
pub fn results(program: &Program, names: &[String]) -> Vec<(String, Range<usize>)> {
    let values: BTreeMap<&str, usize> = program
        .outputs
        .iter()
        .map(|(name, value)| {
            let entries = match program.instructions[value.0 as usize].ty {
                Type::Bool => 1,
                Type::Real(shape) => size(shape),
                Type::Ldlt(_) => unreachable!("invariant: factors are no output"),
            };
            (name.as_str(), entries)
        })
        .collect();
    assert!(values.len() == names.len(), "{}: emitted and evaluated results are the same", program.name);
    let mut end = 0;
    let place = |name: &String| {
        let start = end;
        end += values[name.as_str()];
        (name.clone(), start..end)
    };
    names.iter().map(place).collect()
}
