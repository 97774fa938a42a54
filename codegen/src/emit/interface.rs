//! What the emitted module shows of the model: names, values and sizes. The only place where emission reads the [`Model`].

pub(crate) use nsv_spec::model::{Actuator, Dispersion, Sensor};
use nsv_spec::model::{Disturbance, Model, NoiseModel, Scheme};
use nsv_spec::unit::Dimension;

use crate::emit::gains::gains;
use crate::opt::Arithmetic;

/// The model as far as emission is concerned.
#[derive(Clone, Debug)]
pub(crate) struct Interface {
    /// Module name.
    pub(crate) name: String,
    /// One line for people.
    pub(crate) title: String,
    /// SHA-256 of the specification.
    pub(crate) hash: String,
    /// Version of the generator.
    pub(crate) version: String,
    /// What the optimiser was allowed to change.
    pub(crate) arithmetic: Arithmetic,
    /// Run-time parameters.
    pub(crate) parameters: Vec<Parameter>,
    /// Blocks, outermost first.
    pub(crate) blocks: Vec<Block>,
    /// Further states of the flown plant, `None` if that is the blocks'.
    pub(crate) truth: Option<Vec<State>>,
    /// Control inputs.
    pub(crate) inputs: Vec<Input>,
    /// Sample time, s.
    pub(crate) sample_time: f64,
    /// Length of a run, s.
    pub(crate) horizon: f64,
    /// Plant steps per sample.
    pub(crate) substeps: u32,
    /// Scheme of the plant's steps.
    pub(crate) scheme: Scheme,
    /// How noise enters.
    pub(crate) noise: NoiseModel,
    /// Sources of polynomial data, by its name.
    pub(crate) sources: Vec<(String, String)>,
}

/// A run-time parameter.
#[derive(Clone, Debug)]
pub(crate) struct Parameter {
    /// Name in the specification.
    pub(crate) name: String,
    /// SI unit.
    pub(crate) unit: String,
    /// Source or description.
    pub(crate) doc: String,
    /// Value in the plant.
    pub(crate) plant: f64,
    /// Value that the controller is designed with.
    pub(crate) design: f64,
    /// How the plant's value is drawn.
    pub(crate) dispersion: Option<Dispersion>,
}

/// A block of the plant.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    /// Name.
    pub(crate) name: String,
    /// State channels: name, initial value, unit.
    pub(crate) states: Vec<State>,
    /// Initial states of its exosystems, one after another.
    pub(crate) exosystem: Vec<f64>,
    /// Its gains, in words.
    pub(crate) gains: Vec<String>,
}

/// A state channel.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// Name.
    pub(crate) name: String,
    /// Initial value, SI.
    pub(crate) initial: f64,
    /// SI unit.
    pub(crate) unit: String,
    /// How the initial value is drawn.
    pub(crate) dispersion: Option<Dispersion>,
    /// How it is measured.
    pub(crate) sensor: Option<Sensor>,
}

/// A control input.
#[derive(Clone, Debug)]
pub(crate) struct Input {
    /// Name.
    pub(crate) name: String,
    /// SI unit.
    pub(crate) unit: String,
    /// Largest magnitude.
    pub(crate) limit: f64,
    /// Output for non-finite input.
    pub(crate) safe: f64,
    /// How the command reaches the plant.
    pub(crate) actuator: Option<Actuator>,
}

impl Interface {
    /// The interface of a model.
    pub(crate) fn of(model: &Model, version: &str, arithmetic: Arithmetic) -> Interface {
        Interface {
            name: model.name.clone(),
            title: model.title.clone(),
            hash: model.hash.clone(),
            version: version.to_owned(),
            arithmetic,
            parameters: model.parameters.iter().map(parameter).collect(),
            blocks: (1..)
                .zip(&model.blocks)
                .map(|(i, own)| block(i, model.blocks.len(), own))
                .collect(),
            truth: (model.truth.as_ref()).map(|truth| truth.states.iter().map(state).collect()),
            inputs: model.inputs.iter().map(input).collect(),
            sample_time: model.controller.sample_time,
            horizon: model.scenario.horizon,
            substeps: model.scenario.substeps,
            scheme: model.scenario.scheme,
            noise: model.scenario.noise,
            sources: sources(model),
        }
    }

    /// Further states of the flown plant.
    pub(crate) fn further(&self) -> &[State] {
        self.truth.as_deref().unwrap_or_default()
    }

    /// All states without those of the exosystems, in the order of the packed plant state.
    pub(crate) fn states(&self) -> impl Iterator<Item = &State> {
        let own = self.blocks.iter().flat_map(|block| &block.states);
        own.chain(self.further())
    }

    /// Number of plant states, exosystem states included.
    pub(crate) fn plant_states(&self) -> usize {
        let blocks = self.blocks.iter();
        let own = blocks.map(|block| block.states.len() + block.exosystem.len());
        own.sum::<usize>() + self.further().len()
    }
}

fn sources(model: &Model) -> Vec<(String, String)> {
    let polynomials = model.polynomials.iter();
    let polynomials = polynomials.map(|data| (data.name.clone(), data.doc.clone()));
    let tables = model.tables.iter();
    polynomials
        .chain(tables.map(|data| (data.name.clone(), data.doc.clone())))
        .collect()
}

fn parameter(parameter: &nsv_spec::model::Parameter) -> Parameter {
    Parameter {
        name: parameter.name.clone(),
        unit: unit(parameter.dimension),
        doc: parameter.doc.clone(),
        plant: parameter.value,
        design: parameter.design_value,
        dispersion: parameter.dispersion.clone(),
    }
}

fn block(i: usize, order: usize, block: &nsv_spec::model::Block) -> Block {
    let exosystem = match &block.disturbance {
        Disturbance::Exosystem(systems) => systems
            .iter()
            .flat_map(|system| system.initial.iter().copied())
            .collect(),
        Disturbance::None | Disturbance::Bounded(_) => Vec::new(),
    };
    Block {
        name: block.name.clone(),
        states: block.states.iter().map(state).collect(),
        exosystem,
        gains: gains(i, order, block),
    }
}

fn state(state: &nsv_spec::model::State) -> State {
    State {
        name: state.name.clone(),
        initial: state.initial,
        unit: unit(state.dimension),
        dispersion: state.dispersion.clone(),
        sensor: state.sensor.clone(),
    }
}

fn input(input: &nsv_spec::model::Input) -> Input {
    Input {
        name: input.name.clone(),
        unit: unit(input.dimension),
        limit: input.limit,
        safe: input.safe,
        actuator: input.actuator.clone(),
    }
}

/// The SI unit of a dimension, in the language's own notation.
fn unit(dimension: Dimension) -> String {
    if dimension == Dimension::default() {
        "dimensionless".to_owned()
    } else {
        dimension.to_string()
    }
}
