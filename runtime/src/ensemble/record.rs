//! What one run of a campaign leaves behind.

use std::marker::PhantomData;
use std::vec;
use std::vec::Vec;

use super::Campaign;
use crate::band::Grid;
use crate::closed_loop::{ClosedLoop, Options, Runs};
use crate::lanes::{self, Kernel, Width};
use crate::real::{Mask, Part, Real};
use crate::simulation::{Observer, samples_in, simulate};

/// Counts and sums over the samples of a run.
pub(super) struct Record {
    /// Samples taken.
    pub(super) samples: u64,
    /// Whether the run stopped because something was not finite.
    pub(super) diverged: bool,
    /// Largest `||y - y_r|| / k_1`; `None` without a constraint.
    pub(super) ratio: Option<f64>,
    /// The same from the settling time on; also `None` for a run that did not get so far.
    pub(super) settled_ratio: Option<f64>,
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
    /// Simulates the runs from a place in the campaign on, `count` of them, in the widest lanes there are.
    pub(super) fn of_batch<L: ClosedLoop>(
        campaign: &Campaign,
        width: Width,
        first: u64,
        count: usize,
    ) -> Vec<Self> {
        let batch = Batch::<L> {
            campaign,
            first,
            count,
            closed_loop: PhantomData,
        };
        lanes::run(width, batch).expect("invariant: the width was chosen for this processor")
    }
}

/// Consecutive runs, simulated together.
struct Batch<'a, L> {
    campaign: &'a Campaign,
    /// Place of the first run in the campaign.
    first: u64,
    /// Number of runs; lanes beyond it are simulated and forgotten.
    count: usize,
    closed_loop: PhantomData<L>,
}

impl<L: ClosedLoop> Kernel for Batch<'_, L> {
    type Output = Vec<Record>;

    const WIDTHS: &'static [Width] = L::WIDTHS;

    #[inline(always)]
    fn run<T: Real>(self) -> Vec<Record> {
        let campaign = self.campaign;
        let options = Options {
            seed: campaign.seed,
            run: campaign.first_run.wrapping_add(self.first),
            noise: campaign.noise,
            dispersion: campaign.dispersion,
        };
        let last = samples_in::<L>(campaign.horizon);
        let grid = campaign.band.then(|| Grid::new::<L>(last));
        let mut watch = Watch::<T> {
            settle: samples_in::<L>(campaign.settle),
            sums: Sums::new::<L>(),
            grid,
            row: vec![T::zero(); L::SIGNALS.len()],
            bands: vec![Vec::new(); self.count],
        };
        let alive = simulate::<T, L>(&options, last, &mut watch).to_bits();
        let mut records = Vec::with_capacity(self.count);
        for (lane, values) in watch.bands.into_iter().enumerate() {
            let diverged = alive >> lane & 1 == 0;
            let band = watch.grid.is_some().then_some(values);
            records.push(watch.sums.record(lane, diverged, band));
        }
        records
    }
}

/// What is kept of the runs while they go on.
struct Watch<T: Real> {
    /// Sample from which the tracking error counts.
    settle: u64,
    sums: Sums<T>,
    grid: Option<Grid>,
    /// A row of telemetry.
    row: Vec<T>,
    /// The values of each run on the grid.
    bands: Vec<Vec<f64>>,
}

impl<T: Real, L: ClosedLoop> Observer<T, L> for Watch<T> {
    #[inline(always)]
    fn observes(&self, sample: u64) -> bool {
        match &self.grid {
            Some(grid) => grid.contains(sample),
            None => false,
        }
    }

    #[inline(always)]
    fn sample(&mut self, sample: u64, runs: &L::Runs<T>, alive: T::Mask) {
        self.sums.add(runs, alive, sample >= self.settle);
        if let Some(grid) = &self.grid
            && grid.contains(sample)
        {
            T::outlined(Telemetry(runs, &mut self.row));
            let alive = alive.to_bits();
            for (lane, values) in self.bands.iter_mut().enumerate() {
                if alive >> lane & 1 == 1 {
                    grid.pick(|signal| self.row[signal].lane(lane), values);
                }
            }
        }
    }
}

struct Telemetry<'a, T, R>(&'a R, &'a mut Vec<T>);

impl<T: Real, R: Runs<T>> Part for Telemetry<'_, T, R> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.0.telemetry(self.1);
    }
}

/// Counts and sums over the samples of each lane's run. Counts are numbers like the rest, exact up to 2^53.
struct Sums<T: Real> {
    samples: T,
    /// Minus infinity before the first.
    ratio: T,
    settled_ratio: T,
    settled: T,
    squared_error: Vec<T>,
    saturated: Vec<T>,
    /// Where the loop writes its errors and limits.
    error: Vec<T>,
    at_limit: Vec<T::Mask>,
}

impl<T: Real> Sums<T> {
    fn new<L: ClosedLoop>() -> Self {
        Self {
            samples: T::zero(),
            ratio: T::from_f64(f64::NEG_INFINITY),
            settled_ratio: T::from_f64(f64::NEG_INFINITY),
            settled: T::zero(),
            squared_error: vec![T::zero(); L::OUTPUTS.len()],
            saturated: vec![T::zero(); L::INPUTS.len()],
            error: vec![T::zero(); L::OUTPUTS.len()],
            at_limit: vec![T::Mask::splat(false); L::INPUTS.len()],
        }
    }

    /// Adds a sample of the runs that are alive.
    #[inline(always)]
    fn add(&mut self, runs: &impl Runs<T>, alive: T::Mask, settled: bool) {
        self.samples = self.samples + one_where(alive);
        let ratio = runs.constraint_ratio();
        self.ratio = T::select(alive, ratio, self.ratio).max(self.ratio);
        if settled {
            self.settled_ratio =
                T::select(alive, ratio, self.settled_ratio).max(self.settled_ratio);
            runs.tracking_error(&mut self.error);
            self.settled = self.settled + one_where(alive);
            for i in 0..self.error.len() {
                let square = self.error[i] * self.error[i];
                self.squared_error[i] = self.squared_error[i] + T::select(alive, square, T::zero());
            }
        }
        runs.saturated(&mut self.at_limit);
        for i in 0..self.at_limit.len() {
            self.saturated[i] = self.saturated[i] + one_where(alive.and(self.at_limit[i]));
        }
    }

    fn record(&self, lane: usize, diverged: bool, band: Option<Vec<f64>>) -> Record {
        let largest = |ratio: T| Some(ratio.lane(lane)).filter(|&ratio| ratio != f64::NEG_INFINITY);
        let count = |count: T| count.lane(lane) as u64;
        Record {
            samples: count(self.samples),
            diverged,
            ratio: largest(self.ratio),
            settled_ratio: largest(self.settled_ratio),
            settled: count(self.settled),
            squared_error: self.squared_error.iter().map(|e| e.lane(lane)).collect(),
            saturated: self.saturated.iter().map(|&n| count(n)).collect(),
            band,
        }
    }
}

/// 1 where the mask is true, else 0.
#[inline(always)]
fn one_where<T: Real>(mask: T::Mask) -> T {
    T::select(mask, T::one(), T::zero())
}
