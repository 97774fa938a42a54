//! Campaigns: many runs of a closed loop on all cores.
//!
//! Every run is a pure function of (seed, run), and runs are reduced in their order, so a result depends on neither the number of threads
//! nor the machine's load. A run leaves a small record behind; what a campaign keeps for each run is one number.

mod record;
mod tally;
#[cfg(test)]
mod tests;

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::Instant;
use std::vec::Vec;

use crate::band::Band;
use crate::closed_loop::ClosedLoop;
use crate::lanes::Width;
use record::Record;
use tally::{InOrder, Tally};

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
    /// Whether the plant's parameters are dispersed.
    pub dispersion: bool,
    /// Lanes to simulate runs in, the widest of the processor if `None`; no result depends on it.
    pub width: Option<Width>,
    /// Threads to use, at least 1.
    pub threads: usize,
    /// Whether to keep the first 1000 runs' values for [`Summary::band`].
    pub band: bool,
}

/// What came out.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Number of runs.
    pub runs: u64,
    /// Control samples taken in all runs.
    pub samples: u64,
    /// Fraction of runs that violated the output constraint, `||e_1|| >= k_1`, at some sample, or diverged. `None` without a constraint.
    pub violated: Option<f64>,
    /// Clopper-Pearson interval of the violation probability, 95 %.
    pub violated_interval95: Option<(f64, f64)>,
    /// The largest ratio `||e_1|| / k_1` in each run, over the runs; infinite for a run that diverged. `None` without a constraint.
    pub ratio: Option<RatioQuantiles>,
    /// Root mean square of each output's tracking error over runs and samples from the settling time on, SI. NaN if there is no such sample.
    pub rms_tracking: Vec<(&'static str, f64)>,
    /// Fraction of all samples at which each input was at its limit.
    pub saturated_fraction: Vec<(&'static str, f64)>,
    /// Runs stopped because a state or the control was not finite.
    pub nonfinite: u64,
    /// Duration of the campaign, s.
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
    /// Largest value.
    pub max: f64,
}

/// Simulates a campaign. `progress` is called with the number of finished runs, on the calling thread.
pub fn run<L: ClosedLoop>(campaign: &Campaign, progress: impl Fn(u64)) -> Summary {
    let keep_on = |done| {
        progress(done);
        ControlFlow::Continue(())
    };
    run_while::<L>(campaign, keep_on).expect("invariant: a campaign ends unless it is cancelled")
}

/// Simulates a campaign until `progress` breaks it off; `None` if it did.
pub(crate) fn run_while<L: ClosedLoop>(
    campaign: &Campaign,
    mut progress: impl FnMut(u64) -> ControlFlow<()>,
) -> Option<Summary> {
    let started = Instant::now();
    let next = AtomicU64::new(0);
    let threads = campaign.runs.min(campaign.threads.max(1) as u64);
    let tally = thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        for _ in 0..threads {
            let sender = sender.clone();
            let next = &next;
            scope.spawn(move || work::<L>(campaign, next, &sender));
        }
        drop(sender);
        // Leaving the scope drops the receiver, and workers stop when they cannot send.
        let mut in_order = InOrder::new(Tally::new::<L>(campaign));
        for (done, (index, record)) in (1..).zip(receiver) {
            in_order.insert(index, record);
            if progress(done).is_break() {
                return None;
            }
        }
        Some(in_order.tally)
    })?;
    Some(tally.summary::<L>(started.elapsed().as_secs_f64()))
}

/// Takes batches of runs off the counter until none is left.
fn work<L: ClosedLoop>(
    campaign: &Campaign,
    next: &AtomicU64,
    sender: &mpsc::Sender<(u64, Record)>,
) {
    let width = campaign.width.unwrap_or_else(Width::widest);
    loop {
        let first = next.fetch_add(width.lanes() as u64, Ordering::Relaxed);
        if first >= campaign.runs {
            return;
        }
        let count = (width.lanes() as u64).min(campaign.runs - first) as usize;
        for (index, record) in (first..).zip(Record::of_batch::<L>(campaign, width, first, count)) {
            if sender.send((index, record)).is_err() {
                return;
            }
        }
    }
}
