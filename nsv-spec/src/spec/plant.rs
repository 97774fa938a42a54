//! The plant, what it is flown with, and its hardware.

use std::collections::BTreeMap;

use super::{Code, Declared, Dispersion, Formula, Located, Read, Word};
use crate::diagnostic::Span;

/// A block of the plant.
#[derive(Clone, Debug, PartialEq)]
pub struct PlantBlock {
    /// Places of the keys that are given.
    pub keys: BTreeMap<&'static str, Span>,
    /// Whether there are no others with a map.
    pub complete: bool,
    /// `states`
    pub states: Declared<State>,
    /// `drift`
    pub drift: Formula,
    /// `gain`
    pub gain: Formula,
    /// `disturbance`
    pub disturbance: Option<Located<Read<Disturbance>>>,
    /// `noise`
    pub noise: Option<Located<Noise>>,
}

/// A state channel.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Initial value.
    pub initial: Code,
    /// `unit`
    pub unit: Option<Read<Word>>,
    /// `dispersion`
    pub dispersion: Option<Read<Dispersion>>,
    /// `sensor`
    pub sensor: Option<Sensor>,
}

/// How a state is measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensor {
    /// `bias`
    pub bias: Option<Read<Bias>>,
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
    pub states: Declared<State>,
    /// `rates`
    pub rates: Declared<Formula>,
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
