//! How the signals of many runs spread over time: percentiles at each time of a grid.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::closed_loop::ClosedLoop;
use crate::statistics::percentile;

/// Runs that enter a band, at most: it holds all their values at once.
pub(crate) const RUNS: u64 = 1000;

/// Intervals of the time grid, at most.
const INTERVALS: u64 = 1000;

/// Where a band looks: every `stride`-th sample, at some of the signals.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Grid {
    stride: u64,
    times: usize,
    signals: Vec<usize>,
}

impl Grid {
    /// A grid over samples 0 to `last`.
    pub(crate) fn new<L: ClosedLoop>(last: u64) -> Self {
        let stride = last.div_ceil(INTERVALS).max(1);
        let signals = (0..L::SIGNALS.len())
            .filter(|&i| has_band(L::SIGNALS[i]))
            .collect();
        Self {
            stride,
            times: (last / stride) as usize + 1,
            signals,
        }
    }

    /// Whether a sample is on the grid.
    pub(crate) fn contains(&self, sample: u64) -> bool {
        sample.is_multiple_of(self.stride)
    }

    /// Appends the grid's signals, given by their position in a row of telemetry.
    pub(crate) fn pick(&self, signal: impl Fn(usize) -> f64, picked: &mut Vec<f64>) {
        picked.extend(self.signals.iter().map(|&i| signal(i)));
    }
}

/// Outputs, errors, constraint ratio, disturbances and limited inputs have bands.
fn has_band(signal: &str) -> bool {
    let group = signal.split('.').next().unwrap_or(signal);
    let disturbance = group
        .strip_prefix('d')
        .is_some_and(|block| block.parse::<u32>().is_ok());
    matches!(group, "x1" | "e1" | "ratio1" | "u_sat") || disturbance
}

/// The values of the first runs of a campaign on a time grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    grid: Grid,
    signals: &'static [&'static str],
    sample_time: f64,
    /// For each run, time after time, the grid's signals; shorter if the run diverged.
    runs: Vec<Vec<f64>>,
}

impl Band {
    pub(crate) fn new<L: ClosedLoop>(grid: Grid) -> Self {
        Self {
            grid,
            signals: L::SIGNALS,
            sample_time: L::SAMPLE_TIME,
            runs: Vec::new(),
        }
    }

    /// Adds the values of the next run.
    pub(crate) fn push(&mut self, run: Vec<f64>) {
        self.runs.push(run);
    }

    /// `t`, then `NAME:min,:p05,:p50,:p95,:max,:mean` of each signal.
    pub fn columns(&self) -> Vec<String> {
        let names = self.grid.signals.iter().map(|&i| self.signals[i]);
        let summaries = names.flat_map(|name| {
            ["min", "p05", "p50", "p95", "max", "mean"].map(|of| format!("{name}:{of}"))
        });
        std::iter::once("t".to_string()).chain(summaries).collect()
    }

    /// Number of times.
    pub fn rows(&self) -> usize {
        self.grid.times
    }

    /// The columns at one time: percentiles by nearest rank and the mean, over the runs that got there with a value that is a number; NaN if
    /// none did.
    pub fn row(&self, index: usize) -> Vec<f64> {
        let mut row = Vec::with_capacity(1 + 6 * self.grid.signals.len());
        row.push((index as u64 * self.grid.stride) as f64 * self.sample_time);
        for signal in 0..self.grid.signals.len() {
            let place = index * self.grid.signals.len() + signal;
            let values = self.runs.iter().filter_map(|run| run.get(place)).copied();
            row.extend(spread(values.filter(|value| !value.is_nan()).collect()));
        }
        row
    }
}

/// Minimum, 5th, 50th and 95th percentile, maximum, mean. The mean is summed in the order given.
fn spread(mut values: Vec<f64>) -> [f64; 6] {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.sort_by(f64::total_cmp);
    let at = |percent| percentile(&values, percent).unwrap_or(f64::NAN);
    [at(0), at(5), at(50), at(95), at(100), mean]
}

#[cfg(test)]
mod tests {
    use super::{has_band, spread};

    #[test]
    fn bands_are_drawn_of_the_signals_that_show_robustness() {
        for signal in [
            "x1.alpha",
            "e1.beta",
            "ratio1",
            "d1.alpha",
            "d12.p",
            "u_sat.M_x",
        ] {
            assert!(has_band(signal), "{signal}");
        }
        for signal in [
            "t",
            "x2.p",
            "D_hat1.alpha",
            "u.M_x",
            "V",
            "d",
            "d1_hat.p",
            "ratio2",
        ] {
            assert!(!has_band(signal), "{signal}");
        }
    }

    #[test]
    fn spread_of_nothing_is_not_a_number() {
        assert!(spread([].into()).iter().all(|x| x.is_nan()));
        assert_eq!(
            spread([3.0, 1.0, 2.0].into()),
            [1.0, 1.0, 2.0, 3.0, 3.0, 2.0]
        );
    }
}
