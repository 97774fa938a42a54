//! The interface of a generated simulator: runs of controller and plant, one in each lane.

use core::marker::PhantomData;

use crate::lanes::Width;
use crate::real::Real;

/// What sets runs apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Seed of the campaign.
    pub seed: u64,
    /// Number of the run in the first lane, the next ones in the lanes after it; with the seed it fixes every draw.
    pub run: u64,
    /// Whether the plant is disturbed by noise.
    pub noise: bool,
    /// Whether parameters, initial states and biases of sensors are drawn for each run; if not, they take their nominal values.
    pub dispersion: bool,
}

/// A compiled specification.
pub trait ClosedLoop {
    /// Name of the specification.
    const NAME: &'static str;
    /// Time between control samples, s.
    const SAMPLE_TIME: f64;
    /// Names of the outputs y = x_1.
    const OUTPUTS: &'static [&'static str];
    /// Names of the inputs.
    const INPUTS: &'static [&'static str];
    /// Telemetry columns, SI: `t`, `x1.CHANNEL`, `error.CHANNEL`, `e1.CHANNEL`, `ratio1`, `d1.CHANNEL`, `u_sat.INPUT`, ...
    const SIGNALS: &'static [&'static str];

    /// The widths of lanes that campaigns are compiled for; as for [`crate::lanes::Kernel::WIDTHS`].
    const WIDTHS: &'static [Width] = &Width::ALL;

    /// Its simulator in numbers of any type.
    type Runs<T: Real>: Runs<T>;
}

/// A specification whose campaigns are compiled for scalars and for lanes of `LANES` numbers alone: results are the same, and the compiler
/// has less to do.
pub struct InLanes<L, const LANES: usize>(PhantomData<L>);

impl<L: ClosedLoop, const LANES: usize> ClosedLoop for InLanes<L, LANES> {
    const NAME: &'static str = L::NAME;
    const SAMPLE_TIME: f64 = L::SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = L::OUTPUTS;
    const INPUTS: &'static [&'static str] = L::INPUTS;
    const SIGNALS: &'static [&'static str] = L::SIGNALS;
    const WIDTHS: &'static [Width] = match LANES {
        1 => &[Width::Scalar],
        2 => &[Width::Scalar, Width::Bits128],
        4 => &[Width::Scalar, Width::Bits256],
        8 => &[Width::Scalar, Width::Bits512],
        _ => panic!("lanes of 1, 2, 4 or 8 numbers"),
    };

    type Runs<T: Real> = L::Runs<T>;
}

/// A plant under sampled control; each lane is a run of its own. A run is `new`, then `control` and `advance` in turn.
/// Implementations are `#[inline(always)]`, as [`crate::lanes`] asks.
pub trait Runs<T: Real> {
    /// The initial state of the runs.
    fn new(options: &Options) -> Self;

    /// Prepares for telemetry of the next control sample.
    fn observe(&mut self);

    /// Control sample k: computes the law and updates the controller's states. The other queries are valid afterwards, telemetry after
    /// [`Runs::observe`] only.
    fn control(&mut self);

    /// Moves the plant over one sample time.
    fn advance(&mut self);

    /// Writes one value for each of [`ClosedLoop::SIGNALS`]. `V` and `LV` take more operations than all the rest, so they are computed for
    /// scalars, and NaN in lanes.
    fn telemetry(&self, row: &mut [T]);

    /// `||y - y_r|| / k_1`, of the true outputs; NaN without a constraint on them.
    fn constraint_ratio(&self) -> T;

    /// Writes the tracking error `y - y_r` of each output, SI.
    fn tracking_error(&self, error: &mut [T]);

    /// Writes whether each input is at its limit.
    fn saturated(&self, saturated: &mut [T::Mask]);

    /// Whether plant state, controller state and control are all finite.
    fn is_finite(&self) -> T::Mask;
}
