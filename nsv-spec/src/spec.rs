//! The specification as written: every key in its place with its span, nothing resolved or converted.

use std::collections::BTreeMap;

use crate::diagnostic::{Base, Span};
use crate::interpolation::{Degree, Extrapolation};
use crate::model::{Basis, Integration, NoiseModel, Norm, Scheme, VirtualDerivative};

/// A value with its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Located<T> {
    /// The value.
    pub value: T,
    /// Where it is written.
    pub span: Span,
}

/// A name or a text for people.
pub type Word = Located<String>;

/// One expression, not yet parsed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Code {
    /// Its text.
    pub text: String,
    /// Where the text stands.
    pub base: Base,
}

/// An expression, or an array of them written as a YAML list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// One expression.
    Code(Code),
    /// A list.
    List(Vec<Formula>, Span),
}

impl Formula {
    /// Where it is written.
    pub fn span(&self) -> Span {
        match self {
            Formula::Code(code) => code.base.span,
            Formula::List(_, span) => *span,
        }
    }
}

/// A quantity, or the word `auto`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AutoCode {
    /// `auto`
    Auto(Span),
    /// A quantity.
    Code(Code),
}

/// A name with what is declared under it.
#[derive(Clone, Debug, PartialEq)]
pub struct Named<T> {
    /// The name.
    pub name: Word,
    /// Its declaration.
    pub value: T,
}

/// A whole specification.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// `name`
    pub name: Word,
    /// `title`
    pub title: Option<Word>,
    /// `constants`
    pub constants: Vec<Named<Constant>>,
    /// `parameters`
    pub parameters: Vec<Named<Parameter>>,
    /// `correlations`
    pub correlations: Vec<Correlation>,
    /// `polynomials`
    pub polynomials: Vec<Named<PolynomialGroup>>,
    /// `tables`
    pub tables: Vec<Named<Table>>,
    /// `functions`
    pub functions: Vec<Named<Function>>,
    /// `definitions`
    pub definitions: Vec<Named<Formula>>,
    /// `plant.blocks`
    pub blocks: Vec<Named<PlantBlock>>,
    /// `plant.inputs`
    pub inputs: Vec<Named<Input>>,
    /// `plant.truth`
    pub truth: Option<Located<Truth>>,
    /// `reference`, with the place of its key
    pub reference: Located<Vec<Named<Formula>>>,
    /// `controller`
    pub controller: Controller,
    /// `scenario`
    pub scenario: Scenario,
}

/// A constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// Its value.
    pub value: Formula,
    /// `unit`
    pub unit: Option<Word>,
    /// `source`
    pub source: Option<Word>,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its value.
    pub value: Code,
    /// `unit`
    pub unit: Option<Word>,
    /// `dispersion`
    pub dispersion: Option<Dispersion>,
    /// `source`
    pub source: Option<Word>,
}

/// Distribution of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Dispersion {
    /// Least and largest value.
    Uniform([Code; 2]),
    /// Mean and standard deviation.
    Normal([Code; 2]),
    /// Mean, standard deviation, least and largest value.
    TruncatedNormal([Code; 4]),
    /// Median, and standard deviation of the logarithm.
    Lognormal([Code; 2]),
    /// Values, each with its probability.
    Discrete(Vec<[Code; 2]>),
}

/// Parameters that are drawn together.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    /// `parameters`
    pub parameters: Vec<Word>,
    /// `covariance`
    pub covariance: Formula,
}

/// Coefficient and exponents of each term of a polynomial.
pub type Terms = Vec<(f64, Vec<u32>)>;

/// A function.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// `arguments`
    pub arguments: Vec<Word>,
    /// `value`
    pub value: Code,
}

/// Plain numbers as written.
#[derive(Clone, Debug, PartialEq)]
pub enum Grid {
    /// One number.
    Number(Word),
    /// A list.
    List(Vec<Grid>, Span),
}

impl Grid {
    /// Where it is written.
    pub fn span(&self) -> Span {
        match self {
            Grid::Number(word) => word.span,
            Grid::List(_, span) => *span,
        }
    }
}

/// A lookup table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// `axes`
    pub axes: Vec<Named<Axis>>,
    /// `values`
    pub values: Option<Grid>,
    /// `file`
    pub file: Option<Word>,
    /// `column`
    pub column: Option<Word>,
    /// `unit`
    pub unit: Option<Word>,
    /// `interpolation`
    pub interpolation: Option<Located<Degree>>,
    /// `extrapolation`
    pub extrapolation: Option<Located<Extrapolation>>,
    /// `source`
    pub source: Option<Word>,
}

/// An axis of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// `values`
    pub values: Option<Grid>,
    /// `unit`
    pub unit: Option<Word>,
}

/// A group of polynomial data.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialGroup {
    /// `arguments`
    pub arguments: Vec<Word>,
    /// `source`
    pub source: Option<Word>,
    /// `parts`
    pub parts: Vec<Named<Terms>>,
}

/// A block of the plant.
#[derive(Clone, Debug, PartialEq)]
pub struct PlantBlock {
    /// `states`
    pub states: Vec<Named<State>>,
    /// `drift`
    pub drift: Formula,
    /// `gain`
    pub gain: Formula,
    /// `disturbance`
    pub disturbance: Option<Located<Disturbance>>,
    /// `noise`
    pub noise: Option<Located<Noise>>,
}

/// A state channel.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Initial value.
    pub initial: Code,
    /// `unit`
    pub unit: Option<Word>,
    /// `dispersion`
    pub dispersion: Option<Dispersion>,
    /// `sensor`
    pub sensor: Option<Sensor>,
}

/// How a state is measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensor {
    /// `bias`
    pub bias: Option<Bias>,
    /// `noise`
    pub noise: Option<Code>,
    /// `quantum`
    pub quantum: Option<Code>,
    /// `dropout`
    pub dropout: Option<Code>,
}

/// Constant error of a sensor.
#[derive(Clone, Debug, PartialEq)]
pub enum Bias {
    /// The same in every run.
    Fixed(Code),
    /// Drawn in each run.
    Drawn(Dispersion),
}

/// What is flown beyond the design.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// `states`
    pub states: Vec<Named<State>>,
    /// `rates`
    pub rates: Vec<Named<Formula>>,
}

/// A disturbance.
#[derive(Clone, Debug, PartialEq)]
pub enum Disturbance {
    /// `bounded`
    Bounded(Formula),
    /// `exosystem`
    Exosystem(Vec<Exosystem>),
}

/// The exosystem of a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Exosystem {
    /// `M`
    pub m: Formula,
    /// `N`
    pub n: Option<Formula>,
    /// `L`
    pub l: Formula,
    /// `initial`
    pub initial: Option<Formula>,
    /// The whole.
    pub span: Span,
}

/// The noise of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// `effectiveness`
    pub effectiveness: Formula,
    /// `intensity`
    pub intensity: Formula,
}

/// A control input.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// `limit`
    pub limit: Code,
    /// `safe`
    pub safe: Option<Code>,
    /// `actuator`
    pub actuator: Option<Actuator>,
}

/// How a command reaches the plant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Actuator {
    /// `delay`
    pub delay: Option<Code>,
    /// `quantum`
    pub quantum: Option<Code>,
    /// `lag`
    pub lag: Option<Code>,
    /// `rate_limit`
    pub rate_limit: Option<Code>,
    /// `faults`
    pub faults: Vec<Fault>,
}

/// A fault of an actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// `at`
    pub at: Code,
    /// What happens.
    pub effect: Effect,
}

/// What a fault does.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// `effectiveness`
    Effectiveness(Code),
    /// `stuck`, at a value or where it stands
    Stuck(Option<Code>),
}

/// The controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Controller {
    /// `sample_time`
    pub sample_time: Code,
    /// `virtual_derivative`
    pub virtual_derivative: Option<Located<VirtualDerivative>>,
    /// `norm`
    pub norm: Option<Located<Norm>>,
    /// `integration`
    pub integration: Option<Located<Integration>>,
    /// `barrier_margin`
    pub barrier_margin: Option<Code>,
    /// `parameters`
    pub parameters: Vec<Named<Code>>,
    /// `blocks`, with the place of its key
    pub blocks: Located<Vec<Named<ControllerBlock>>>,
}

/// The gains of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct ControllerBlock {
    /// Places of the keys that are given.
    pub keys: BTreeMap<&'static str, Span>,
    /// `K`
    pub k: Formula,
    /// `kbar`
    pub kbar: AutoCode,
    /// `C`
    pub c: Formula,
    /// `filter`
    pub filter: Option<Formula>,
    /// `eta_1`
    pub eta_1: Option<Code>,
    /// `eta_2`
    pub eta_2: Option<Code>,
    /// `eta_3`
    pub eta_3: Option<Code>,
    /// `eta_noise`
    pub eta_noise: Option<Code>,
    /// `observer`
    pub observer: Option<Formula>,
    /// `constraint`
    pub constraint: Option<Formula>,
    /// `network`
    pub network: Option<Located<Network>>,
    /// `error_bound`
    pub error_bound: Option<Located<ErrorBound>>,
    /// `noise_bound`
    pub noise_bound: Option<Located<NoiseBound>>,
}

/// A network.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    /// `order`
    pub order: Located<u64>,
    /// `basis`
    pub basis: Option<Located<Basis>>,
    /// `inputs`
    pub inputs: Vec<Formula>,
    /// `scale`
    pub scale: Option<Formula>,
    /// `iota`
    pub iota: Formula,
    /// `Gamma`
    pub gamma: Code,
    /// `lambda`
    pub lambda: Code,
}

/// The law of eps_hat.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorBound {
    /// `iota`
    pub iota: Code,
    /// `b`
    pub b: Formula,
}

/// The laws of sigma_hat and phi.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseBound {
    /// `tau`
    pub tau: Code,
    /// `lambda`
    pub lambda: Code,
    /// `varsigma`
    pub varsigma: Code,
    /// `phi.initial`
    pub phi_initial: Code,
    /// `phi.kappa`
    pub phi_kappa: Code,
    /// `phi.threshold`
    pub phi_threshold: Code,
    /// `phi.min`
    pub phi_min: Option<AutoCode>,
}

/// The scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// `horizon`
    pub horizon: Code,
    /// `substeps`
    pub substeps: Option<Located<u64>>,
    /// `scheme`
    pub scheme: Option<Located<Scheme>>,
    /// `noise`
    pub noise: Option<Located<NoiseModel>>,
    /// `seed`
    pub seed: Option<Located<u64>>,
    /// `runs`
    pub runs: Option<Located<u64>>,
    /// `settle`
    pub settle: Option<Code>,
}
