//! How the signals of many runs spread over time: extremes, percentiles and mean at each time of a grid.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::closed_loop::ClosedLoop;
use crate::statistics::{Corrupt, Decoder, Encoder, ExactSum, Sketch};

/// Intervals of the time grid, at most.
const INTERVALS: u64 = 400;

/// Bins of the percentiles of one signal at one time: they are exact up to as many runs, and take 4 KB.
const BINS: usize = 256;

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
    matches!(group, "x1" | "error" | "ratio1" | "u_sat") || disturbance
}

/// The spread over runs of signals on a time grid. It takes at most 5 KB for each signal at each time, however many the runs: 32 MB for
/// 16 signals.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    grid: Grid,
    signals: &'static [&'static str],
    sample_time: f64,
    /// Time after time, the grid's signals.
    cells: Vec<Cell>,
}

impl Band {
    pub(crate) fn new<L: ClosedLoop>(grid: Grid) -> Self {
        let cells = grid.times * grid.signals.len();
        Self {
            grid,
            signals: L::SIGNALS,
            sample_time: L::SAMPLE_TIME,
            cells: (0..cells).map(|_| Cell::new()).collect(),
        }
    }

    /// Adds the values of runs, time after time the grid's signals; fewer if a run diverged.
    pub(crate) fn push(&mut self, runs: &[&[f64]]) {
        // Cells take far more memory than values: each is visited once.
        for (index, cell) in self.cells.iter_mut().enumerate() {
            cell.values.reserve(runs.len());
            for &value in runs.iter().filter_map(|run| run.get(index)) {
                cell.push(value);
            }
        }
    }

    /// Adds the runs of another band on the same grid.
    pub(crate) fn merge(&mut self, other: Band) {
        for (cell, more) in self.cells.iter_mut().zip(other.cells) {
            cell.sum.merge(&more.sum);
            cell.values.merge(more.values);
        }
    }

    /// Counts what waits to be counted; needed before a row is asked for.
    pub(crate) fn settle(&mut self) {
        for cell in &mut self.cells {
            cell.values.settle();
        }
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

    /// The columns at one time, over the runs that got there with a value that is a number; NaN if none did. Extremes are exact, the mean is
    /// rounded once, percentiles are those of a [`Sketch`].
    pub fn row(&self, index: usize) -> Vec<f64> {
        let signals = self.grid.signals.len();
        let mut row = Vec::with_capacity(1 + 6 * signals);
        row.push((index as u64 * self.grid.stride) as f64 * self.sample_time);
        for cell in &self.cells[index * signals..(index + 1) * signals] {
            row.extend(cell.spread());
        }
        row
    }

    pub(crate) fn encode(&self, encoder: &mut Encoder) {
        encoder.count(self.cells.len() as u64);
        for cell in &self.cells {
            cell.sum.encode(encoder);
            cell.values.encode(encoder);
        }
    }

    /// Reads what `encode` wrote of so many runs.
    pub(crate) fn decode<L: ClosedLoop>(
        grid: Grid,
        runs: u64,
        decoder: &mut Decoder<'_>,
    ) -> Result<Self, Corrupt> {
        let mut band = Self::new::<L>(grid);
        decoder.expect(band.cells.len())?;
        for cell in &mut band.cells {
            cell.sum = ExactSum::decode(decoder)?;
            cell.values = Sketch::decode(BINS, decoder)?;
            if cell.values.count() > runs {
                return Err(Corrupt);
            }
        }
        Ok(band)
    }
}

/// The values of one signal at one time.
#[derive(Clone, Debug, PartialEq)]
struct Cell {
    sum: ExactSum,
    values: Sketch,
}

impl Cell {
    fn new() -> Self {
        Self {
            sum: ExactSum::default(),
            values: Sketch::new(BINS),
        }
    }

    fn push(&mut self, value: f64) {
        if !value.is_nan() {
            self.sum.add(value);
            self.values.push(value);
        }
    }

    /// Minimum, 5th, 50th and 95th percentile, maximum, mean.
    fn spread(&self) -> [f64; 6] {
        let at = |percent| self.values.percentile(percent).unwrap_or(f64::NAN);
        let mean = self.sum.value() / self.values.count() as f64;
        [at(0), at(5), at(50), at(95), at(100), mean]
    }
}

#[cfg(test)]
mod tests {
    use super::{Cell, has_band};

    #[test]
    fn bands_are_drawn_of_the_signals_that_show_robustness() {
        for signal in [
            "x1.alpha",
            "error.beta",
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
        let spread = |values: &[f64]| {
            let mut cell = Cell::new();
            values.iter().for_each(|value| cell.push(*value));
            cell.values.settle();
            cell.spread()
        };
        assert!(spread(&[f64::NAN]).iter().all(|x| x.is_nan()));
        assert_eq!(
            spread(&[3.0, 1.0, f64::NAN, 2.0]),
            [1.0, 1.0, 2.0, 3.0, 3.0, 2.0]
        );
    }
}
