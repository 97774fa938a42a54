//! Campaigns: many runs of a closed loop on all cores.
//!
//! Every run is a pure function of (seed, run), and what is kept of many runs is a function of their set, so a result depends neither on
//! threads and the machine's load, nor on whether a campaign was interrupted or shared out among machines. Memory does not grow with the
//! number of runs.

mod engine;
mod record;
mod row;
mod shard;
mod state;
mod tally;
#[cfg(test)]
mod tests;

use std::convert::Infallible;
use std::vec::Vec;

use crate::band::Band;
use crate::closed_loop::ClosedLoop;
use crate::lanes::Width;

pub(crate) use engine::{Flight, fly};
pub(crate) use row::Rows;
pub(crate) use shard::{Shard, block_size};
pub(crate) use state::State;

/// What to simulate.
#[derive(Clone, Debug, PartialEq)]
pub struct Campaign {
    /// Seed of all draws.
    pub seed: u64,
    /// Number of the first run.
    pub first_run: u64,
    /// Number of runs.
    pub runs: u64,
    /// Time simulated in each run, s; samples are taken at 0 up to it.
    pub horizon: f64,
    /// Time from which the tracking error counts, s.
    pub settle: f64,
    /// Whether the plant is disturbed by noise.
    pub noise: bool,
    /// Whether parameters, initial states and biases of sensors are drawn for each run.
    pub dispersion: bool,
    /// Lanes to simulate runs in, the widest of the processor if `None`; no result depends on it.
    pub width: Option<Width>,
    /// Threads to use, at least 1.
    pub threads: usize,
    /// Whether to keep the signals' spread over time for [`Summary::band`].
    pub band: bool,
}

/// What came out.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Number of runs.
    pub runs: u64,
    /// Control samples taken in all runs.
    pub samples: u64,
    /// Runs that violated the output constraint, `||y - y_r|| >= k_1`, at some sample, or diverged. `None` without a constraint.
    pub violations: Option<u64>,
    /// Fraction of runs that violated the output constraint.
    pub violated: Option<f64>,
    /// Clopper-Pearson interval of the violation probability, 95 %.
    pub violated_interval95: Option<(f64, f64)>,
    /// The largest ratio `||y - y_r|| / k_1` in each run, over the runs; infinite for a run that diverged. `None` without a constraint.
    pub ratio: Option<RatioQuantiles>,
    /// The same from the settling time on.
    pub settled_ratio: Option<RatioQuantiles>,
    /// The worst runs: those with the largest ratios, diverged ones first, the lowest number among equals; at most ten. Without a constraint,
    /// the first that diverged.
    pub worst: Vec<WorstRun>,
    /// Root mean square of each output's tracking error over runs and samples from the settling time on, SI. NaN if there is no such sample.
    pub rms_tracking: Vec<(&'static str, f64)>,
    /// Fraction of all samples at which each input was at its limit.
    pub saturated_fraction: Vec<(&'static str, f64)>,
    /// Runs stopped because a state or the control was not finite.
    pub nonfinite: u64,
    /// Time spent on the campaign, in all processes that had a part in it, s.
    pub wall_s: f64,
    /// The spread of the signals over time, if it was asked for.
    pub band: Option<Band>,
}

/// Quantiles over runs, by nearest rank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RatioQuantiles {
    /// 50th percentile.
    pub median: f64,
    /// 90th percentile.
    pub p90: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Largest value, always exact.
    pub max: f64,
    /// Largest relative error of the percentiles; 0 if they are exact, as they are up to 4096 runs.
    pub accuracy: f64,
}

/// A run with a large ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstRun {
    /// Its number, which with the seed replays it.
    pub run: u64,
    /// Its largest `||y - y_r|| / k_1`; infinite if it diverged.
    pub ratio: f64,
    /// Whether it stopped because a state or the control was not finite.
    pub diverged: bool,
}

/// Simulates a campaign. `progress` is called with the number of finished runs now and then, on the calling thread, and at the end.
pub fn run<L: ClosedLoop>(campaign: &Campaign, progress: impl Fn(u64)) -> Summary {
    let report = |flight: &Flight<'_>| {
        progress(flight.runs());
        Ok::<(), Infallible>(())
    };
    let start = State::new::<L>(campaign);
    match fly::<L, _>(campaign, Shard::WHOLE, start, |_, _| Ok(()), report) {
        Ok(state) => state.summary::<L>(),
        Err(never) => match never {},
    }
}
