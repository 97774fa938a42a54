//! What one run of a campaign leaves behind.

use std::vec;
use std::vec::Vec;

use super::Campaign;
use crate::band::Grid;
use crate::closed_loop::{ClosedLoop, Options};
use crate::simulation::{Simulation, samples_in};

/// Counts and sums over the samples of a run.
pub(super) struct Record {
    /// Samples taken.
    pub(super) samples: u64,
    /// Whether the run stopped because something was not finite.
    pub(super) diverged: bool,
    /// Largest `||e_1|| / k_1`; `None` without a constraint.
    pub(super) ratio: Option<f64>,
    /// Samples from the settling time on.
    pub(super) settled: u64,
    /// Sum over those of each output's squared tracking error.
    pub(super) squared_error: Vec<f64>,
    /// Samples at which each input was at its limit.
    pub(super) saturated: Vec<u64>,
    /// Values for the band, time after time.
    pub(super) band: Option<Vec<f64>>,
}

impl Record {
    /// Simulates consecutive runs from a place in the campaign on.
    pub(super) fn of_batch<L: ClosedLoop>(
        campaign: &Campaign,
        first: u64,
        count: u64,
    ) -> Vec<Self> {
        (first..first + count)
            .map(|index| Self::of_run::<L>(campaign, index))
            .collect()
    }

    /// Simulates the run at a place in the campaign.
    fn of_run<L: ClosedLoop>(campaign: &Campaign, index: u64) -> Self {
        let options = Options {
            seed: campaign.seed,
            run: campaign.first_run.wrapping_add(index),
            noise: campaign.noise,
            dispersion: campaign.dispersion,
        };
        let last = samples_in::<L>(campaign.horizon);
        let settle = samples_in::<L>(campaign.settle);
        let grid = campaign.band.then(|| Grid::new::<L>(last));
        let mut record = Self::new::<L>(grid.is_some());
        let mut scratch = Scratch::new::<L>();
        let mut simulation = Simulation::<L>::new(&options, last);
        while let Some((sample, closed_loop)) = simulation.next_sample() {
            record.add_sample(closed_loop, sample >= settle, &mut scratch);
            if let (Some(grid), Some(values)) = (&grid, &mut record.band)
                && grid.contains(sample)
            {
                closed_loop.telemetry(&mut scratch.row);
                grid.pick(&scratch.row, values);
            }
        }
        record.diverged = simulation.diverged();
        record
    }

    fn new<L: ClosedLoop>(band: bool) -> Self {
        Self {
            samples: 0,
            diverged: false,
            ratio: None,
            settled: 0,
            squared_error: vec![0.0; L::OUTPUTS.len()],
            saturated: vec![0; L::INPUTS.len()],
            band: band.then(Vec::new),
        }
    }

    fn add_sample<L: ClosedLoop>(&mut self, closed_loop: &L, settled: bool, scratch: &mut Scratch) {
        self.samples += 1;
        let ratio = closed_loop.constraint_ratio();
        if !ratio.is_nan() {
            self.ratio = Some(self.ratio.map_or(ratio, |largest| largest.max(ratio)));
        }
        if settled {
            closed_loop.tracking_error(&mut scratch.error);
            self.settled += 1;
            for (sum, e) in self.squared_error.iter_mut().zip(&scratch.error) {
                *sum += e * e;
            }
        }
        closed_loop.saturated(&mut scratch.saturated);
        for (count, &at_limit) in self.saturated.iter_mut().zip(&scratch.saturated) {
            *count += u64::from(at_limit);
        }
    }
}

/// Where the loop writes what it is asked for, allocated once a run.
struct Scratch {
    row: Vec<f64>,
    error: Vec<f64>,
    saturated: Vec<bool>,
}

impl Scratch {
    fn new<L: ClosedLoop>() -> Self {
        Self {
            row: vec![0.0; L::SIGNALS.len()],
            error: vec![0.0; L::OUTPUTS.len()],
            saturated: vec![false; L::INPUTS.len()],
        }
    }
}
