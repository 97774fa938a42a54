//! One run, sample by sample.

use crate::closed_loop::{ClosedLoop, Options};

/// A run on its way through the samples 0 to the last, at times 0 to the horizon. It stops before a sample at which the loop is not finite.
pub(crate) struct Simulation<L> {
    closed_loop: L,
    next: u64,
    last: u64,
    diverged: bool,
}

/// Number of sample times in a duration, to the nearest.
pub(crate) fn samples_in<L: ClosedLoop>(seconds: f64) -> u64 {
    (seconds / L::SAMPLE_TIME).round() as u64
}

impl<L: ClosedLoop> Simulation<L> {
    /// A run at its initial state.
    pub(crate) fn new(options: &Options, last: u64) -> Self {
        Self {
            closed_loop: L::new(options),
            next: 0,
            last,
            diverged: false,
        }
    }

    /// Moves to the next sample and computes the control there: its number and the loop, until the run ends.
    pub(crate) fn next_sample(&mut self) -> Option<(u64, &L)> {
        if self.diverged || self.next > self.last {
            return None;
        }
        if self.next > 0 {
            self.closed_loop.advance();
        }
        self.closed_loop.control();
        if !self.closed_loop.is_finite() {
            self.diverged = true;
            return None;
        }
        self.next += 1;
        Some((self.next - 1, &self.closed_loop))
    }

    /// Whether the run stopped because its state was not finite.
    pub(crate) fn diverged(&self) -> bool {
        self.diverged
    }
}
