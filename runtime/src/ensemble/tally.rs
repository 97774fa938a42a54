//! The reduction of a campaign's records, in the order of its runs.

use std::collections::BTreeMap;
use std::vec;
use std::vec::Vec;

use super::record::Record;
use super::{Campaign, RatioQuantiles, Summary};
use crate::band::{Band, Grid};
use crate::closed_loop::ClosedLoop;
use crate::simulation::samples_in;
use crate::statistics::{clopper_pearson, percentile};

/// Puts records back in the order of runs: those that came early wait.
pub(super) struct InOrder {
    /// What the runs up to the first one missing add up to.
    pub(super) tally: Tally,
    next: u64,
    early: BTreeMap<u64, Record>,
}

impl InOrder {
    pub(super) fn new(tally: Tally) -> Self {
        Self {
            tally,
            next: 0,
            early: BTreeMap::new(),
        }
    }

    pub(super) fn insert(&mut self, index: u64, record: Record) {
        self.early.insert(index, record);
        while let Some(record) = self.early.remove(&self.next) {
            self.tally.add(record);
            self.next += 1;
        }
    }
}

/// Sums over the runs so far.
pub(super) struct Tally {
    runs: u64,
    samples: u64,
    nonfinite: u64,
    constrained: bool,
    /// The largest ratio of each run; infinite if it diverged.
    ratios: Vec<f64>,
    settled: u64,
    squared_error: Vec<f64>,
    saturated: Vec<u64>,
    band: Option<Band>,
}

impl Tally {
    pub(super) fn new<L: ClosedLoop>(campaign: &Campaign) -> Self {
        let band = campaign
            .band
            .then(|| Band::new::<L>(Grid::new::<L>(samples_in::<L>(campaign.horizon))));
        Self {
            runs: 0,
            samples: 0,
            nonfinite: 0,
            constrained: false,
            ratios: Vec::new(),
            settled: 0,
            squared_error: vec![0.0; L::OUTPUTS.len()],
            saturated: vec![0; L::INPUTS.len()],
            band,
        }
    }

    fn add(&mut self, record: Record) {
        self.runs += 1;
        self.samples += record.samples;
        self.nonfinite += u64::from(record.diverged);
        self.constrained |= record.ratio.is_some();
        if record.diverged {
            self.ratios.push(f64::INFINITY);
        } else {
            self.ratios.extend(record.ratio);
        }
        self.settled += record.settled;
        self.squared_error
            .iter_mut()
            .zip(record.squared_error)
            .for_each(|(sum, e)| *sum += e);
        self.saturated
            .iter_mut()
            .zip(record.saturated)
            .for_each(|(sum, count)| *sum += count);
        if let (Some(band), Some(values)) = (&mut self.band, record.band) {
            band.push(values);
        }
    }

    pub(super) fn summary<L: ClosedLoop>(mut self, wall_s: f64) -> Summary {
        self.ratios.sort_by(f64::total_cmp);
        let violations = self.ratios.iter().filter(|&&ratio| ratio >= 1.0).count() as u64;
        let rms = self
            .squared_error
            .iter()
            .map(|sum| (sum / self.settled as f64).sqrt());
        let fractions = self
            .saturated
            .iter()
            .map(|&count| count as f64 / self.samples as f64);
        Summary {
            runs: self.runs,
            samples: self.samples,
            violated: self
                .constrained
                .then(|| violations as f64 / self.runs as f64),
            violated_interval95: self
                .constrained
                .then(|| clopper_pearson(violations, self.runs, 0.95)),
            ratio: if self.constrained {
                quantiles(&self.ratios)
            } else {
                None
            },
            rms_tracking: L::OUTPUTS.iter().copied().zip(rms).collect(),
            saturated_fraction: L::INPUTS.iter().copied().zip(fractions).collect(),
            nonfinite: self.nonfinite,
            wall_s,
            band: self.band,
        }
    }
}

fn quantiles(sorted: &[f64]) -> Option<RatioQuantiles> {
    Some(RatioQuantiles {
        median: percentile(sorted, 50)?,
        p90: percentile(sorted, 90)?,
        p99: percentile(sorted, 99)?,
        max: percentile(sorted, 100)?,
    })
}
