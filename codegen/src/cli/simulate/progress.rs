//! What a person at a terminal sees while it takes longer than a second.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::cli::output::interactive;
use crate::report::number::{count, short};

const PATIENCE: Duration = Duration::from_secs(1);

/// A bar that appears when the work takes a while, and only on a terminal.
pub(super) struct Progress {
    bar: ProgressBar,
    since: Instant,
    /// Runs that were done when they were first counted, and when that was.
    first: Option<(u64, Instant)>,
    interactive: bool,
}

impl Progress {
    /// Nothing to see yet.
    pub(super) fn new() -> Progress {
        Progress {
            bar: ProgressBar::hidden(),
            since: Instant::now(),
            first: None,
            interactive: interactive(),
        }
    }

    /// The simulator is being built.
    pub(super) fn building(&self) {
        self.bar.set_style(style("{spinner} {msg}"));
        self.bar
            .set_message("building the simulator (once for each version of the code)");
        self.show();
        self.bar.enable_steady_tick(Duration::from_millis(120));
    }

    /// So many runs are done.
    pub(super) fn runs(&mut self, done: u64, all: u64) {
        let (first, began) = *self.first.get_or_insert_with(|| (done, Instant::now()));
        if self.bar.length() != Some(all) {
            self.bar.disable_steady_tick();
            self.bar.set_style(style("{wide_bar} {msg}"));
            self.bar.set_length(all);
        }
        self.bar.set_position(done);
        self.bar
            .set_message(message(done, all, done - first, began.elapsed()));
        if self.since.elapsed() > PATIENCE && self.bar.is_hidden() {
            self.show();
        }
    }

    /// The end.
    pub(super) fn done(&self) {
        self.bar.finish_and_clear();
    }

    fn show(&self) {
        if self.interactive {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

/// How far it is, how fast it goes, and how long it will take, from the runs done in the time measured.
fn message(done: u64, all: u64, measured: u64, time: Duration) -> String {
    let runs = format!("{} of {} runs", count(done), count(all));
    let rate = measured as f64 / time.as_secs_f64();
    if measured == 0 || rate <= 0.0 || !rate.is_finite() {
        return runs;
    }
    let left = (all.saturating_sub(done) as f64 / rate).ceil() as u64;
    let left = match left {
        0..120 => format!("{left} s"),
        120..7200 => format!("{} min", left.div_ceil(60)),
        _ => format!("{} h", left.div_ceil(3600)),
    };
    let rate = if rate < 10.0 {
        short(rate)
    } else {
        count(rate as u64)
    };
    format!("{runs}, {rate} per second, {left} left")
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rate_and_remaining_time_are_those_of_this_process() {
        // 100 000 runs were done before.
        let after = |seconds| message(120_000, 1_000_000, 20_000, Duration::from_secs(seconds));
        assert_eq!(
            after(10),
            "120 000 of 1 000 000 runs, 2 000 per second, 8 min left"
        );
        assert_eq!(
            after(4000),
            "120 000 of 1 000 000 runs, 5 per second, 49 h left"
        );
        assert_eq!(
            message(990, 1000, 90, Duration::from_secs(9)),
            "990 of 1 000 runs, 10 per second, 1 s left"
        );
        assert_eq!(message(0, 8, 0, Duration::ZERO), "0 of 8 runs");
    }
}
