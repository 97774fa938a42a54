//! What a person at a terminal sees while it takes longer than a second.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::cli::output::interactive;

const PATIENCE: Duration = Duration::from_secs(1);

/// A bar that appears when the work takes a while, and only on a terminal.
pub(super) struct Progress {
    bar: ProgressBar,
    since: Instant,
    interactive: bool,
}

impl Progress {
    /// Nothing to see yet.
    pub(super) fn new() -> Progress {
        Progress {
            bar: ProgressBar::hidden(),
            since: Instant::now(),
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
    pub(super) fn runs(&self, done: u64, all: u64) {
        if self.bar.length() != Some(all) {
            self.bar.disable_steady_tick();
            self.bar.set_style(style("{wide_bar} {msg} {eta}"));
            self.bar.set_length(all);
        }
        self.bar.set_position(done);
        self.bar.set_message(format!("{done} of {all} runs"));
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

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
