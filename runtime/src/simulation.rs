//! Runs, sample by sample.

use std::vec::Vec;

use crate::closed_loop::{ClosedLoop, Options, Runs};
use crate::real::{Mask, Real};

/// Number of sample times in a duration, to the nearest.
pub(crate) fn samples_in<L: ClosedLoop>(seconds: f64) -> u64 {
    (seconds / L::SAMPLE_TIME).round() as u64
}

/// Simulates the runs in the lanes of `T` over the samples 0 to `last`, until each run has ended: a run ends before a sample at which its
/// loop is not finite. `visit` gets the sample's number, the loops after their control, and the runs that have got there; telemetry is
/// valid at the samples that are `observed`. Tells which runs came to the last sample.
#[inline(always)]
pub(crate) fn simulate<T: Real, L: ClosedLoop>(
    options: &Options,
    last: u64,
    observed: impl Fn(u64) -> bool,
    mut visit: impl FnMut(u64, &L::Runs<T>, T::Mask),
) -> T::Mask {
    let mut runs = L::Runs::<T>::new(options);
    let mut alive = T::Mask::splat(true);
    let mut sample = 0;
    while sample <= last {
        if sample > 0 {
            T::outlined(|| runs.advance());
        }
        T::outlined(|| runs.control(observed(sample)));
        alive = alive.and(runs.is_finite());
        if !alive.any() {
            break;
        }
        visit(sample, &runs, alive);
        sample += 1;
    }
    alive
}

/// Simulates one run and hands the telemetry of each sample to `row`, until that fails.
pub(crate) fn telemetry<L: ClosedLoop, E>(
    options: &Options,
    last: u64,
    mut row: impl FnMut(&[f64]) -> Result<(), E>,
) -> Result<(), E> {
    let mut values: Vec<f64> = std::vec![0.0; L::SIGNALS.len()];
    let mut outcome = Ok(());
    simulate::<f64, L>(
        options,
        last,
        |_| true,
        |_, run, _| {
            if outcome.is_ok() {
                run.telemetry(&mut values);
                outcome = row(&values);
            }
        },
    );
    outcome
}
