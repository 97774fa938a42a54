//! The specification as written: every key in its place with its span, nothing resolved or converted.
//!
//! What could not be read is marked [`Unreadable`], so that the checks go on with the rest and say nothing of it.

mod controller;
mod data;
mod plant;
mod written;

pub use controller::{Controller, ControllerBlock, ErrorBound, Network, NoiseBound};
pub use data::{
    Axis, Constant, Correlation, Dispersion, Function, Grid, Parameter, PolynomialGroup, Table,
    Terms,
};
pub use plant::{
    Actuator, Bias, Disturbance, Effect, Exosystem, Fault, Input, Noise, PlantBlock, Sensor, State,
    Truth,
};
pub use written::{
    AutoCode, Choice, Code, Declared, Formula, Located, Named, Read, Unreadable, Word,
};

use crate::model::{NoiseModel, Scheme};

/// A whole specification.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// Whether everything that declares names could be read.
    pub complete: bool,
    /// `name`
    pub name: Read<Word>,
    /// `title`
    pub title: Option<Word>,
    /// `constants`
    pub constants: Declared<Constant>,
    /// `parameters`
    pub parameters: Declared<Parameter>,
    /// `correlations`
    pub correlations: Vec<Correlation>,
    /// `polynomials`
    pub polynomials: Declared<PolynomialGroup>,
    /// `tables`
    pub tables: Declared<Table>,
    /// `functions`
    pub functions: Declared<Function>,
    /// `definitions`
    pub definitions: Declared<Formula>,
    /// `plant.blocks`
    pub blocks: Declared<PlantBlock>,
    /// `plant.inputs`
    pub inputs: Declared<Input>,
    /// `plant.truth`
    pub truth: Option<Located<Truth>>,
    /// `reference`
    pub reference: Declared<Formula>,
    /// `controller`
    pub controller: Controller,
    /// `scenario`
    pub scenario: Scenario,
}

/// The scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// `horizon`
    pub horizon: Code,
    /// `substeps`
    pub substeps: Option<Located<u64>>,
    /// `scheme`
    pub scheme: Choice<Scheme>,
    /// `noise`
    pub noise: Choice<NoiseModel>,
    /// `seed`
    pub seed: Option<Located<u64>>,
    /// `runs`
    pub runs: Option<Located<u64>>,
    /// `settle`
    pub settle: Option<Code>,
}
