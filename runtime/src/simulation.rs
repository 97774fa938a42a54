//! Runs, sample by sample.

use std::marker::PhantomData;
use std::vec::Vec;

use crate::closed_loop::{ClosedLoop, Options, Runs};
use crate::real::{Mask, Part, Real};

/// Number of sample times in a duration, to the nearest.
pub(crate) fn samples_in<L: ClosedLoop>(seconds: f64) -> u64 {
    (seconds / L::SAMPLE_TIME).round() as u64
}

/// What follows runs on their way.
pub(crate) trait Observer<T: Real, L: ClosedLoop> {
    /// Whether the telemetry of this sample is wanted.
    fn observes(&self, sample: u64) -> bool;

    /// A sample: its number, the loops after their control, and the runs that have got there. Telemetry is valid if it was wanted.
    fn sample(&mut self, sample: u64, runs: &L::Runs<T>, alive: T::Mask);
}

/// Simulates the runs in the lanes of `T` over the samples 0 to `last`, until each run has ended: a run ends before a sample at which its
/// loop is not finite. Tells which runs came to the last sample.
#[inline(always)]
pub(crate) fn simulate<T: Real, L: ClosedLoop>(
    options: &Options,
    last: u64,
    observer: &mut impl Observer<T, L>,
) -> T::Mask {
    let mut runs = T::outlined(New::<T, L::Runs<T>>(options, PhantomData));
    let mut alive = T::Mask::splat(true);
    let mut sample = 0;
    while sample <= last {
        if sample > 0 {
            T::outlined(Advance(&mut runs, PhantomData::<T>));
        }
        if observer.observes(sample) {
            runs.observe();
        }
        T::outlined(Control(&mut runs, PhantomData::<T>));
        alive = alive.and(runs.is_finite());
        if !alive.any() {
            break;
        }
        observer.sample(sample, &runs, alive);
        sample += 1;
    }
    alive
}

struct New<'a, T, R>(&'a Options, PhantomData<(T, R)>);

impl<T: Real, R: Runs<T>> Part for New<'_, T, R> {
    type Output = R;

    #[inline(always)]
    fn run(self) -> R {
        R::new(self.0)
    }
}

struct Advance<'a, T, R>(&'a mut R, PhantomData<T>);

impl<T: Real, R: Runs<T>> Part for Advance<'_, T, R> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.0.advance();
    }
}

struct Control<'a, T, R>(&'a mut R, PhantomData<T>);

impl<T: Real, R: Runs<T>> Part for Control<'_, T, R> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.0.control();
    }
}

/// Simulates one run and hands the telemetry of each sample to `row`, until that fails.
pub(crate) fn telemetry<L: ClosedLoop, E>(
    options: &Options,
    last: u64,
    row: impl FnMut(&[f64]) -> Result<(), E>,
) -> Result<(), E> {
    let mut rows = Rows {
        values: std::vec![0.0; L::SIGNALS.len()],
        row,
        outcome: Ok(()),
    };
    simulate::<f64, L>(options, last, &mut rows);
    rows.outcome
}

/// Hands on the telemetry of every sample.
struct Rows<F, E> {
    values: Vec<f64>,
    row: F,
    outcome: Result<(), E>,
}

impl<L: ClosedLoop, E, F: FnMut(&[f64]) -> Result<(), E>> Observer<f64, L> for Rows<F, E> {
    fn observes(&self, _sample: u64) -> bool {
        true
    }

    fn sample(&mut self, _sample: u64, run: &L::Runs<f64>, _alive: bool) {
        if self.outcome.is_ok() {
            run.telemetry(&mut self.values);
            self.outcome = (self.row)(&self.values);
        }
    }
}
