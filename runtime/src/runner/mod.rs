//! The whole program of a simulator binary: arguments in, JSON lines and binary tables out.
//!
//! Standard output carries lines `{"resumed": runs_done}` if a checkpoint is gone on from, `{"progress": [runs_done, runs]}`, at most 20 a second, and at the
//! end one line `{"result": {..}}`, or `{"refused": [REASON, REMEDY]}` if a checkpoint does not fit; numbers that are not finite are `null`. A reader that
//! goes away ends the campaign quietly. Files appear under their names only when they are complete, but for that of `--run-table`.
//! Exit codes: 0 done, 1 a file or the output could not be written, 2 wrong arguments or a checkpoint that does not fit.

mod arguments;
mod campaign;
mod checkpoint;
mod json;
mod runs;
mod table;
#[cfg(test)]
mod tests;

use std::fmt;
use std::format;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, writeln};

use crate::band::Band;
use crate::closed_loop::{ClosedLoop, Options};
use crate::ensemble::Campaign;
use crate::simulation::{samples_in, telemetry};
use arguments::{Command, Request, UsageError};
use checkpoint::Refusal;
use table::Table;

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
    Refused(PathBuf, Refusal),
    /// The parts to merge have so many of the campaign's runs.
    Parts(u64, u64),
}

impl Failure {
    fn exit_code(&self) -> u8 {
        match self {
            Failure::Usage(_) | Failure::Refused(..) | Failure::Parts(..) => 2,
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
            Failure::File(path, error) => write!(f, "cannot use `{}`: {error}", path.display()),
            Failure::Refused(path, refusal) => write!(f, "`{}` {refusal}", path.display()),
            Failure::Parts(found, runs) => {
                write!(f, "the parts have {found} runs, the campaign has {runs}")
            }
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
    let state = if request.merge.is_empty() {
        campaign::simulate::<L>(&request, output)
    } else {
        campaign::merge::<L>(&request)
    };
    if let Err(refused @ Failure::Refused(_, refusal)) = &state {
        let words = [
            &format!("{refused}"),
            refusal.remedy(!request.merge.is_empty()),
        ];
        let words = json::array(words.into_iter().map(json::string));
        writeln!(output, "{{\"refused\": {words}}}").map_err(Failure::Output)?;
    }
    let summary = state?.summary::<L>();
    write_files::<L>(&request, summary.band.as_ref())?;
    writeln!(output, "{{\"result\": {}}}", json::summary(&summary))
        .and_then(|()| output.flush())
        .map_err(Failure::Output)
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
