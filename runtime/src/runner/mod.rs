//! The whole program of a simulator binary: arguments in, JSON lines and binary tables out.
//!
//! Standard output carries lines `{"progress": runs_done}`, at most 20 a second, and at the end one line `{"result": {..}}`; numbers that are not
//! finite are `null`. A reader that goes away ends the campaign quietly. Files appear under their names only when they are complete.
//! Exit codes: 0 done, 1 the output could not be written, 2 wrong arguments.

mod arguments;
mod json;
mod table;
#[cfg(test)]
mod tests;

use std::cell::Cell;
use std::fmt;
use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};
use std::{env, writeln};

use crate::band::Band;
use crate::closed_loop::{ClosedLoop, Options};
use crate::ensemble::{Campaign, Summary, run_while};
use crate::simulation::{samples_in, telemetry};
use arguments::{Command, Request, UsageError};
use table::Table;

/// Time between progress lines.
const PROGRESS_INTERVAL: Duration = Duration::from_millis(50);

/// Runs the program with the arguments of the process.
pub fn main<L: ClosedLoop>() -> ExitCode {
    let outcome = run::<L>(env::args_os().skip(1), &mut io::stdout().lock());
    if let Err(failure) = &outcome
        && !failure.is_closed_pipe()
    {
        // Nothing is left to do if standard error is gone too.
        let _ = writeln!(io::stderr(), "{}: {failure}", L::NAME);
    }
    ExitCode::from(outcome.map_or_else(|failure| failure.exit_code(), |()| 0))
}

/// Why the program failed.
#[derive(Debug)]
enum Failure {
    Usage(UsageError),
    Output(io::Error),
    File(PathBuf, io::Error),
}

impl Failure {
    fn exit_code(&self) -> u8 {
        match self {
            Failure::Usage(_) => 2,
            Failure::Output(_) | Failure::File(..) => 1,
        }
    }

    /// Whether the reader of standard output went away, which is nobody's mistake.
    fn is_closed_pipe(&self) -> bool {
        matches!(self, Failure::Output(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Usage(error) => write!(f, "{error}; --help lists the options"),
            Failure::Output(error) => write!(f, "cannot write to standard output: {error}"),
            Failure::File(path, error) => write!(f, "cannot write `{}`: {error}", path.display()),
        }
    }
}

/// Runs the program with the given arguments (without its name).
fn run<L: ClosedLoop>(
    arguments: impl Iterator<Item = std::ffi::OsString>,
    output: &mut impl Write,
) -> Result<(), Failure> {
    let request = match arguments::parse(arguments).map_err(Failure::Usage)? {
        Command::Help => {
            return writeln!(output, "{}", arguments::help(L::NAME)).map_err(Failure::Output);
        }
        Command::Simulate(request) => request,
    };
    let summary = simulate::<L>(&request.campaign, output)?;
    write_files::<L>(&request, summary.band.as_ref())?;
    writeln!(output, "{{\"result\": {}}}", json::summary(&summary))
        .and_then(|()| output.flush())
        .map_err(Failure::Output)
}

/// The campaign with its progress lines; the first line that cannot be written breaks it off.
fn simulate<L: ClosedLoop>(
    campaign: &Campaign,
    output: &mut impl Write,
) -> Result<Summary, Failure> {
    let last_line = Cell::new(Instant::now());
    let mut failure = None;
    let report = |done: u64| {
        if last_line.get().elapsed() < PROGRESS_INTERVAL {
            return ControlFlow::Continue(());
        }
        last_line.set(Instant::now());
        match writeln!(output, "{{\"progress\": {done}}}").and_then(|()| output.flush()) {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                failure = Some(error);
                ControlFlow::Break(())
            }
        }
    };
    let summary = run_while::<L>(campaign, report);
    match failure {
        Some(error) => Err(Failure::Output(error)),
        None => Ok(summary.expect("invariant: only a failed line breaks a campaign off")),
    }
}

fn write_files<L: ClosedLoop>(request: &Request, band: Option<&Band>) -> Result<(), Failure> {
    if let Some((path, run)) = &request.trajectory {
        write_trajectory::<L>(&request.campaign, path, *run)
            .map_err(|error| Failure::File(path.clone(), error))?;
    }
    if let (Some(path), Some(band)) = (&request.band, band) {
        write_band(band, path).map_err(|error| Failure::File(path.clone(), error))?;
    }
    Ok(())
}

/// Simulates one run again and writes its telemetry, a row for each sample.
fn write_trajectory<L: ClosedLoop>(campaign: &Campaign, path: &Path, run: u64) -> io::Result<()> {
    let options = Options {
        seed: campaign.seed,
        run,
        noise: campaign.noise,
        dispersion: campaign.dispersion,
    };
    let mut table = Table::create(path, L::SIGNALS)?;
    let last = samples_in::<L>(campaign.horizon);
    telemetry::<L, _>(&options, last, |row| table.push(row))?;
    table.finish()
}

fn write_band(band: &Band, path: &Path) -> io::Result<()> {
    let mut table = Table::create(path, &band.columns())?;
    for index in 0..band.rows() {
        table.push(&band.row(index))?;
    }
    table.finish()
}
