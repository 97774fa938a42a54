//! What lies between the controller and the plant.

use super::Dispersion;

/// What happens to a state on its way to the controller.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Constant error, or its value where nothing is dispersed.
    pub bias: f64,
    /// How the constant error is drawn in each run.
    pub drawn_bias: Option<Dispersion>,
    /// Standard deviation of the normal error of each sample.
    pub noise: f64,
    /// Measurements are multiples of it; 0 for none.
    pub quantum: f64,
    /// Probability that a sample is lost.
    pub dropout: f64,
}

/// What happens to a command on its way to the plant.
#[derive(Clone, Debug, PartialEq)]
pub struct Actuator {
    /// Dead time, s: a whole number of plant steps.
    pub delay: f64,
    /// Commands are rounded to multiples of it; 0 for none.
    pub quantum: f64,
    /// Time constant of the first-order lag, s; 0 for none.
    pub lag: f64,
    /// Fastest change for each second.
    pub rate_limit: Option<f64>,
    /// What fails, in order of time.
    pub faults: Vec<Fault>,
}

/// A fault of an actuator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fault {
    /// When it happens, s.
    pub at: f64,
    /// What it does.
    pub effect: Effect,
}

/// What a fault does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Effect {
    /// Leaves this share of the effect.
    Effectiveness(f64),
    /// Stops the actuator at a value, or where it stands.
    Stuck(Option<f64>),
}
