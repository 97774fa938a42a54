//! Statistics of a campaign, as the runner reports them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// The `result` line of a runner.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub(crate) struct Outcome {
    /// Number of runs.
    pub runs: u64,
    /// Controller samples over all runs.
    pub samples: u64,
    /// Runs that left the constraint or diverged; `None` if there is no constraint.
    pub violations: Option<u64>,
    /// Fraction of runs that left the constraint; `None` if there is no constraint.
    pub violated: Option<f64>,
    /// Clopper-Pearson interval of `violated`.
    pub violated_interval95: Option<[f64; 2]>,
    /// Distribution over the runs of the largest ||y - y_r||/k_1.
    pub ratio: Option<Quantiles>,
    /// The same from the settling time on.
    pub settled_ratio: Option<Quantiles>,
    /// The worst runs first.
    pub worst: Vec<WorstRun>,
    /// Root mean square of y - y_r by output, SI, after settling.
    pub rms_tracking: BTreeMap<String, Option<f64>>,
    /// Fraction of samples at the limit, by input.
    pub saturated_fraction: BTreeMap<String, Option<f64>>,
    /// Runs that stopped at a non-finite state.
    pub nonfinite: u64,
    /// Time spent on the campaign, in all processes that had a part in it, s.
    pub wall_s: f64,
    /// Controller samples per second.
    pub steps_per_s: f64,
}

/// Quantiles over the runs; `None` stands for a number that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Quantiles {
    /// 50 %.
    pub median: Option<f64>,
    /// 90 %.
    pub p90: Option<f64>,
    /// 99 %.
    pub p99: Option<f64>,
    /// Largest, always exact.
    pub max: Option<f64>,
    /// Largest relative error of the others; 0 if they are exact.
    pub accuracy: Option<f64>,
}

/// A run with a large ||y - y_r||/k_1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct WorstRun {
    /// Its number.
    pub run: u64,
    /// The largest ratio; `None` if the run diverged.
    pub ratio: Option<f64>,
    /// Whether it stopped at a non-finite state.
    pub diverged: bool,
}
