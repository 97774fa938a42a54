//! The interface of a generated simulator: one run of controller and plant.

use crate::status::Status;

/// What sets one run apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Seed of the campaign.
    pub seed: u64,
    /// Number of the run; with the seed it fixes every draw.
    pub run: u64,
    /// Whether the plant is disturbed by noise.
    pub noise: bool,
    /// Whether the plant's parameters are dispersed; if not, they take their nominal values.
    pub dispersion: bool,
}

/// A plant under sampled control. A run is `new`, then `control` and `advance` in turn.
pub trait ClosedLoop: Sized {
    /// Name of the specification.
    const NAME: &'static str;
    /// Time between control samples, s.
    const SAMPLE_TIME: f64;
    /// Names of the outputs y = x_1.
    const OUTPUTS: &'static [&'static str];
    /// Names of the inputs.
    const INPUTS: &'static [&'static str];
    /// Telemetry columns, SI: `t`, `x1.CHANNEL`, `e1.CHANNEL`, `ratio1`, `d1.CHANNEL`, `u_sat.INPUT`, ...
    const SIGNALS: &'static [&'static str];

    /// The initial state of a run.
    fn new(options: &Options) -> Self;

    /// Control sample k: computes the law and updates the controller's states. The other queries are valid afterwards.
    fn control(&mut self) -> Status;

    /// Moves the plant over one sample time.
    fn advance(&mut self);

    /// Writes one value for each of [`ClosedLoop::SIGNALS`].
    fn telemetry(&self, row: &mut [f64]);

    /// `||e_1|| / k_1`; NaN without a constraint on the output.
    fn constraint_ratio(&self) -> f64;

    /// Writes the tracking error `y - y_r` of each output, SI.
    fn tracking_error(&self, error: &mut [f64]);

    /// Writes whether each input is at its limit.
    fn saturated(&self, saturated: &mut [bool]);

    /// Whether plant state, controller state and control are all finite.
    fn is_finite(&self) -> bool;
}
