//! The reduction of a campaign's records.
//!
//! Counts are integers, sums are exact, percentiles are counts in bins, and lists have an order of their own: a tally is a function of the set of
//! runs in it, and its size does not depend on how many they are.

use std::vec;
use std::vec::Vec;

use super::record::Record;
use super::{Campaign, RatioQuantiles, Summary, WorstRun};
use crate::band::{Band, Grid};
use crate::closed_loop::ClosedLoop;
use crate::simulation::samples_in;
use crate::statistics::{Corrupt, Decoder, Encoder, ExactSum, Sketch, clopper_pearson};

/// Bins of the largest ratios: their percentiles are exact up to as many runs.
const RATIO_BINS: usize = 4096;

/// Runs in the list of the worst.
const WORST: usize = 10;

/// What a set of runs adds up to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tally {
    runs: u64,
    samples: u64,
    nonfinite: u64,
    constrained: bool,
    violations: u64,
    /// The largest ratio of each run; infinite if it diverged.
    ratios: Sketch,
    /// The same from the settling time on.
    settled_ratios: Sketch,
    /// The worst runs first.
    worst: Vec<WorstRun>,
    settled: u64,
    squared_error: Vec<ExactSum>,
    saturated: Vec<u64>,
    band: Option<Band>,
}

impl Tally {
    /// Of no runs.
    pub(crate) fn new<L: ClosedLoop>(campaign: &Campaign) -> Self {
        Self {
            runs: 0,
            samples: 0,
            nonfinite: 0,
            constrained: false,
            violations: 0,
            ratios: Sketch::new(RATIO_BINS),
            settled_ratios: Sketch::new(RATIO_BINS),
            worst: Vec::new(),
            settled: 0,
            squared_error: vec![ExactSum::default(); L::OUTPUTS.len()],
            saturated: vec![0; L::INPUTS.len()],
            band: campaign.band.then(|| Band::new::<L>(grid::<L>(campaign))),
        }
    }

    /// Number of runs.
    pub(crate) fn runs(&self) -> u64 {
        self.runs
    }

    /// Adds consecutive runs from a number on.
    pub(crate) fn add(&mut self, first: u64, records: &[Record]) {
        for (index, record) in (0..).zip(records) {
            self.add_run(first.wrapping_add(index), record);
        }
        if let Some(band) = &mut self.band {
            let values = records.iter().filter_map(|record| record.band.as_deref());
            band.push(&values.collect::<Vec<_>>());
        }
    }

    fn add_run(&mut self, run: u64, record: &Record) {
        self.runs += 1;
        self.samples += record.samples;
        self.nonfinite += u64::from(record.diverged);
        self.constrained |= record.ratio.is_some();
        if let Some(ratio) = largest(record, record.settled_ratio) {
            self.settled_ratios.push(ratio);
        }
        if let Some(ratio) = largest(record, record.ratio) {
            self.violations += u64::from(ratio >= 1.0);
            self.ratios.push(ratio);
            self.list(&[WorstRun {
                run,
                ratio,
                diverged: record.diverged,
            }]);
        }
        self.settled += record.settled;
        for (sum, e) in self.squared_error.iter_mut().zip(&record.squared_error) {
            sum.add(*e);
        }
        for (sum, count) in self.saturated.iter_mut().zip(&record.saturated) {
            *sum += count;
        }
    }

    /// Adds the runs of another tally, none of which are in this one.
    pub(crate) fn merge(&mut self, other: Tally) {
        self.runs += other.runs;
        self.samples += other.samples;
        self.nonfinite += other.nonfinite;
        self.constrained |= other.constrained;
        self.violations += other.violations;
        self.ratios.merge(other.ratios);
        self.settled_ratios.merge(other.settled_ratios);
        self.list(&other.worst);
        self.settled += other.settled;
        for (sum, more) in self.squared_error.iter_mut().zip(&other.squared_error) {
            sum.merge(more);
        }
        for (sum, count) in self.saturated.iter_mut().zip(other.saturated) {
            *sum += count;
        }
        if let (Some(band), Some(more)) = (&mut self.band, other.band) {
            band.merge(more);
        }
    }

    /// Counts what waits to be counted, so that little is left to do when tallies are merged.
    pub(crate) fn settle(&mut self) {
        self.ratios.settle();
        self.settled_ratios.settle();
        if let Some(band) = &mut self.band {
            band.settle();
        }
    }

    /// Enters runs into the list of the worst: the largest ratio first, the lowest number among equals.
    fn list(&mut self, more: &[WorstRun]) {
        let before = |one: &WorstRun, other: &WorstRun| {
            let order = other.ratio.total_cmp(&one.ratio);
            order.then(one.run.cmp(&other.run)).is_lt()
        };
        for run in more {
            let place = self.worst.partition_point(|listed| before(listed, run));
            if place < WORST {
                self.worst.truncate(WORST - 1);
                self.worst.insert(place, *run);
            }
        }
    }

    /// The statistics.
    pub(crate) fn summary<L: ClosedLoop>(mut self, wall_s: f64) -> Summary {
        self.settle();
        let rms = self
            .squared_error
            .iter()
            .map(|sum| (sum.value() / self.settled as f64).sqrt());
        let fractions = self
            .saturated
            .iter()
            .map(|&count| count as f64 / self.samples as f64);
        let if_constrained = self.constrained.then_some(());
        Summary {
            runs: self.runs,
            samples: self.samples,
            violations: if_constrained.map(|()| self.violations),
            violated: if_constrained.map(|()| self.violations as f64 / self.runs as f64),
            violated_interval95: if_constrained
                .map(|()| clopper_pearson(self.violations, self.runs, 0.95)),
            ratio: if_constrained.and_then(|()| quantiles(&self.ratios)),
            settled_ratio: if_constrained.and_then(|()| quantiles(&self.settled_ratios)),
            worst: self.worst,
            rms_tracking: L::OUTPUTS.iter().copied().zip(rms).collect(),
            saturated_fraction: L::INPUTS.iter().copied().zip(fractions).collect(),
            nonfinite: self.nonfinite,
            wall_s,
            band: self.band,
        }
    }

    /// Writes the tally, which is settled.
    pub(crate) fn encode(&self, encoder: &mut Encoder) {
        for count in [
            self.runs,
            self.samples,
            self.nonfinite,
            u64::from(self.constrained),
            self.violations,
            self.settled,
            self.worst.len() as u64,
        ] {
            encoder.count(count);
        }
        for worst in &self.worst {
            encoder.count(worst.run);
            encoder.count(u64::from(worst.diverged));
            encoder.float(worst.ratio);
        }
        self.ratios.encode(encoder);
        self.settled_ratios.encode(encoder);
        encoder.count(self.squared_error.len() as u64);
        for sum in &self.squared_error {
            sum.encode(encoder);
        }
        encoder.count(self.saturated.len() as u64);
        for &count in &self.saturated {
            encoder.count(count);
        }
        if let Some(band) = &self.band {
            band.encode(encoder);
        }
    }

    /// Reads what `encode` wrote of the same campaign.
    pub(crate) fn decode<L: ClosedLoop>(
        campaign: &Campaign,
        decoder: &mut Decoder<'_>,
    ) -> Result<Self, Corrupt> {
        let mut tally = Self::new::<L>(&Campaign {
            band: false,
            ..campaign.clone()
        });
        tally.runs = decoder.count()?;
        tally.samples = decoder.count()?;
        tally.nonfinite = decoder.count()?;
        tally.constrained = flag(decoder)?;
        tally.violations = decoder.count()?;
        tally.settled = decoder.count()?;
        let worst = decoder.count()?;
        if worst > WORST as u64 {
            return Err(Corrupt);
        }
        for _ in 0..worst {
            tally.worst.push(WorstRun {
                run: decoder.count()?,
                diverged: flag(decoder)?,
                ratio: decoder.float()?,
            });
        }
        tally.ratios = Sketch::decode(RATIO_BINS, decoder)?;
        tally.settled_ratios = Sketch::decode(RATIO_BINS, decoder)?;
        decoder.expect(tally.squared_error.len())?;
        for sum in &mut tally.squared_error {
            *sum = ExactSum::decode(decoder)?;
        }
        decoder.expect(tally.saturated.len())?;
        for count in &mut tally.saturated {
            *count = decoder.count()?;
        }
        if campaign.band {
            tally.band = Some(Band::decode::<L>(grid::<L>(campaign), tally.runs, decoder)?);
        }
        tally.expect_counts(samples_in::<L>(campaign.horizon))?;
        Ok(tally)
    }

    /// Counts of runs of so many samples behind the first: none is of more than there are, so that no sum of parts overflows.
    fn expect_counts(&self, samples: u64) -> Result<(), Corrupt> {
        let most = samples
            .checked_add(1)
            .and_then(|samples| samples.checked_mul(self.runs))
            .ok_or(Corrupt)?;
        let (worst, ratios) = (self.worst.len() as u64, &self.ratios);
        let of_runs = [
            self.nonfinite,
            self.violations,
            worst,
            ratios.count(),
            self.settled_ratios.count(),
        ];
        let of_samples = [self.samples, self.settled];
        let saturated = self.saturated.iter().all(|&count| count <= self.samples);
        if of_runs.into_iter().all(|count| count <= self.runs)
            && of_samples.into_iter().all(|count| count <= most)
            && saturated
        {
            Ok(())
        } else {
            Err(Corrupt)
        }
    }
}

/// A largest `||y - y_r|| / k_1` of a run, infinite if it diverged; `None` without a constraint.
pub(super) fn largest(record: &Record, ratio: Option<f64>) -> Option<f64> {
    match record.diverged {
        true => Some(f64::INFINITY),
        false => ratio,
    }
}

fn grid<L: ClosedLoop>(campaign: &Campaign) -> Grid {
    Grid::new::<L>(samples_in::<L>(campaign.horizon))
}

fn flag(decoder: &mut Decoder<'_>) -> Result<bool, Corrupt> {
    match decoder.count()? {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(Corrupt),
    }
}

fn quantiles(ratios: &Sketch) -> Option<RatioQuantiles> {
    Some(RatioQuantiles {
        median: ratios.percentile(50)?,
        p90: ratios.percentile(90)?,
        p99: ratios.percentile(99)?,
        max: ratios.percentile(100)?,
        accuracy: ratios.accuracy(),
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::campaign;
    use super::{Decoder, Encoder, Tally};
    use crate::mock::MockLoop;

    #[test]
    fn counts_of_more_than_the_runs_are_refused() {
        let campaign = campaign();
        let read = |change: fn(&mut Tally)| {
            let mut tally = Tally::new::<MockLoop<true>>(&campaign);
            (tally.runs, tally.samples) = (2, 20);
            change(&mut tally);
            let mut encoder = Encoder::default();
            tally.encode(&mut encoder);
            let bytes = encoder.bytes();
            Tally::decode::<MockLoop<true>>(&campaign, &mut Decoder::new(&bytes)).is_ok()
        };
        assert!(read(|_| ()));
        assert!(!read(|tally| tally.runs = u64::MAX));
        assert!(!read(|tally| tally.samples = u64::MAX));
        assert!(!read(|tally| tally.settled = u64::MAX));
        assert!(!read(|tally| tally.nonfinite = 3));
        assert!(!read(|tally| tally.violations = 3));
        assert!(!read(|tally| tally.saturated[0] = 21));
        assert!(!read(|tally| {
            (0..3).for_each(|_| tally.ratios.push(1.0));
            tally.settle();
        }));
    }
}
