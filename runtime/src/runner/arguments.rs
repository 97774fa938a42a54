//! Command-line arguments.

use std::boxed::Box;
use std::ffi::{OsStr, OsString};
use std::fmt;
use std::format;
use std::path::PathBuf;
use std::str::FromStr;
use std::string::{String, ToString};
use std::thread;
use std::vec::Vec;

use crate::ensemble::{Campaign, Shard};
use crate::noise;

/// What the arguments ask for.
#[derive(Debug, PartialEq)]
pub(super) enum Command {
    Help,
    Simulate(Box<Request>),
}

/// A campaign, and the files that go with it.
#[derive(Debug, PartialEq)]
pub(super) struct Request {
    pub(super) campaign: Campaign,
    /// The part to simulate.
    pub(super) shard: Shard,
    /// File of the state, read if it is there and written now and then.
    pub(super) checkpoint: Option<PathBuf>,
    /// Complete states to merge instead of simulating.
    pub(super) merge: Vec<PathBuf>,
    /// What this program was built from.
    pub(super) key: String,
    /// Where the specification is.
    pub(super) specification: String,
    /// File of a row for each run.
    pub(super) run_table: Option<PathBuf>,
    /// File and run of a trajectory.
    pub(super) trajectory: Option<(PathBuf, u64)>,
    /// File of a band.
    pub(super) band: Option<PathBuf>,
}

/// Why arguments cannot be used.
#[derive(Debug, PartialEq)]
pub(super) enum UsageError {
    Unknown(String),
    NoValue(String),
    Invalid {
        option: String,
        found: String,
        expected: &'static str,
    },
    Missing(&'static str),
    Needs(&'static str, &'static str),
    MergeWithParts,
    TooManyRuns(&'static str),
}

impl fmt::Display for UsageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(argument) => write!(f, "unknown argument `{argument}`"),
            Self::NoValue(option) => write!(f, "`{option}` needs a value"),
            Self::Invalid {
                option,
                found,
                expected,
            } => write!(f, "`{option}` is `{found}`, expected {expected}"),
            Self::Missing(option) => write!(f, "`{option}` is required"),
            Self::Needs(option, other) => write!(f, "`{option}` needs `{other}`"),
            Self::MergeWithParts => write!(
                f,
                "`--merge` goes with none of `--shard`, `--checkpoint` and `--run-table`"
            ),
            Self::TooManyRuns(options) => write!(
                f,
                "{options} is more than {}, the runs that noise tells apart",
                noise::RUNS
            ),
        }
    }
}

/// The text of `--help`.
pub(super) fn help(name: &str) -> String {
    format!(
        "Simulates {name}.

  --horizon H          time of each run, s (required)
  --seed S             seed of all draws (default 1)
  --runs N             number of runs (default 1)
  --first-run K        number of the first run (default 0)
  --settle S           time from which the tracking error counts, s (default 0)
  --threads T          threads (default: all cores)
  --no-noise           leave out the noise
  --no-dispersion      nominal parameters, initial states and biases of sensors
  --trajectory FILE    write the telemetry of one run
  --trajectory-run K   its number (default: the first run)
  --band FILE          write percentiles over the runs against time
  --keep-band          keep what `--band` needs in the checkpoint
  --run-table FILE     write a row for each run
  --checkpoint FILE    keep the state in FILE, and go on from there
  --shard K/N          simulate the K-th of N parts; needs --checkpoint
  --merge FILE         merge this complete checkpoint instead of simulating; once for each part
  --key KEY            what this program was built from, for checkpoints
  --specification PATH where the specification is, for checkpoints"
    )
}

/// Reads arguments. The last of repeated options holds.
pub(super) fn parse(mut arguments: impl Iterator<Item = OsString>) -> Result<Command, UsageError> {
    let mut request = Request::new();
    let mut trajectory_run = None;
    while let Some(argument) = arguments.next() {
        let option = argument.to_string_lossy();
        let mut value = || {
            arguments
                .next()
                .ok_or_else(|| UsageError::NoValue(option.to_string()))
        };
        let campaign = &mut request.campaign;
        match option.as_ref() {
            "--help" | "-h" => return Ok(Command::Help),
            "--seed" => campaign.seed = count(&option, &value()?, 0)?,
            "--runs" => campaign.runs = count(&option, &value()?, 1)?,
            "--first-run" => campaign.first_run = count(&option, &value()?, 0)?,
            "--threads" => campaign.threads = count(&option, &value()?, 1)?,
            "--horizon" => campaign.horizon = seconds(&option, &value()?)?,
            "--settle" => campaign.settle = seconds(&option, &value()?)?,
            "--no-noise" => campaign.noise = false,
            "--no-dispersion" => campaign.dispersion = false,
            "--keep-band" => campaign.band = true,
            "--trajectory" => request.trajectory = Some((value()?.into(), 0)),
            "--trajectory-run" => trajectory_run = Some(count(&option, &value()?, 0)?),
            "--band" => request.band = Some(value()?.into()),
            "--run-table" => request.run_table = Some(value()?.into()),
            "--checkpoint" => request.checkpoint = Some(value()?.into()),
            "--shard" => request.shard = shard(&option, &value()?)?,
            "--merge" => request.merge.push(value()?.into()),
            "--key" => request.key = value()?.to_string_lossy().into_owned(),
            "--specification" => request.specification = value()?.to_string_lossy().into_owned(),
            _ => return Err(UsageError::Unknown(option.to_string())),
        }
    }
    let request = request.complete(trajectory_run)?;
    Ok(Command::Simulate(Box::new(request)))
}

impl Request {
    fn new() -> Self {
        Self {
            campaign: Campaign {
                seed: 1,
                first_run: 0,
                runs: 1,
                horizon: f64::NAN,
                settle: 0.0,
                noise: true,
                dispersion: true,
                width: None,
                threads: thread::available_parallelism().map_or(1, usize::from),
                band: false,
            },
            shard: Shard::WHOLE,
            checkpoint: None,
            merge: Vec::new(),
            key: String::new(),
            specification: String::new(),
            run_table: None,
            trajectory: None,
            band: None,
        }
    }

    /// Options that need or exclude each other.
    fn complete(mut self, trajectory_run: Option<u64>) -> Result<Self, UsageError> {
        if self.campaign.horizon.is_nan() {
            return Err(UsageError::Missing("--horizon"));
        }
        let Campaign {
            first_run, runs, ..
        } = self.campaign;
        if runs > noise::RUNS {
            return Err(UsageError::TooManyRuns("`--runs`"));
        }
        if first_run > noise::RUNS - runs {
            return Err(UsageError::TooManyRuns(
                "the sum of `--first-run` and `--runs`",
            ));
        }
        match &mut self.trajectory {
            Some((_, run)) => *run = trajectory_run.unwrap_or(self.campaign.first_run),
            None if trajectory_run.is_some() => {
                return Err(UsageError::Needs("--trajectory-run", "--trajectory"));
            }
            None => {}
        }
        let part = self.shard != Shard::WHOLE;
        if part && self.checkpoint.is_none() {
            return Err(UsageError::Needs("--shard", "--checkpoint"));
        }
        let simulates = part || self.checkpoint.is_some() || self.run_table.is_some();
        if simulates && !self.merge.is_empty() {
            return Err(UsageError::MergeWithParts);
        }
        self.campaign.band |= self.band.is_some();
        Ok(self)
    }
}

/// `K/N`, the K-th of N parts, counted from 1.
fn shard(option: &str, value: &OsStr) -> Result<Shard, UsageError> {
    let numbers = value.to_str().and_then(|text| text.split_once('/'));
    let numbers = numbers.and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((k, of)) if (1..=of).contains(&k) => Ok(Shard { index: k - 1, of }),
        _ => Err(invalid(option, value, "K/N with K from 1 to N")),
    }
}

/// A whole number that is at least `least`.
fn count<N: FromStr + PartialOrd + From<u8>>(
    option: &str,
    value: &OsStr,
    least: u8,
) -> Result<N, UsageError> {
    let expected = if least == 0 {
        "a whole number"
    } else {
        "a whole number of at least 1"
    };
    let number = value.to_str().and_then(|text| text.parse().ok());
    number
        .filter(|number| *number >= N::from(least))
        .ok_or_else(|| invalid(option, value, expected))
}

/// A finite time that is not negative.
fn seconds(option: &str, value: &OsStr) -> Result<f64, UsageError> {
    let number = value.to_str().and_then(|text| text.parse().ok());
    let expected = "a time in seconds, finite and not negative";
    number
        .filter(|s: &f64| s.is_finite() && *s >= 0.0)
        .ok_or_else(|| invalid(option, value, expected))
}

fn invalid(option: &str, found: &OsStr, expected: &'static str) -> UsageError {
    UsageError::Invalid {
        option: option.to_string(),
        found: found.to_string_lossy().into_owned(),
        expected,
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;
    use std::string::{String, ToString};

    use super::{Command, Request, Shard, parse};

    fn request(line: &str) -> Request {
        match parse(line.split_whitespace().map(Into::into)) {
            Ok(Command::Simulate(request)) => *request,
            other => panic!("{other:?}"),
        }
    }

    fn error(line: &str) -> String {
        parse(line.split_whitespace().map(Into::into))
            .expect_err("arguments are wrong")
            .to_string()
    }

    #[test]
    fn every_option_is_read() {
        let request = request(
            "--seed 18446744073709551615 --runs 20 --first-run 7 --horizon 2.5 --settle 1e-1 --threads 3 --no-noise --no-dispersion \
             --trajectory a.bin --trajectory-run 9 --band b.bin --run-table r.bin --checkpoint c --shard 2/5 --key abc --specification s.yaml",
        );
        let campaign = &request.campaign;
        assert_eq!(
            (campaign.seed, campaign.runs, campaign.first_run),
            (u64::MAX, 20, 7)
        );
        assert_eq!(
            (campaign.horizon, campaign.settle, campaign.threads),
            (2.5, 0.1, 3)
        );
        assert!(!campaign.noise && !campaign.dispersion && campaign.band);
        assert_eq!(
            (request.trajectory, request.band, request.run_table),
            (
                Some(("a.bin".into(), 9)),
                Some(PathBuf::from("b.bin")),
                Some(PathBuf::from("r.bin"))
            )
        );
        assert_eq!(
            (request.checkpoint, request.shard),
            (Some(PathBuf::from("c")), Shard { index: 1, of: 5 })
        );
        assert_eq!(
            (request.key.as_str(), request.specification.as_str()),
            ("abc", "s.yaml")
        );
    }

    #[test]
    fn the_horizon_alone_is_enough() {
        let found = request("--horizon 20");
        let mut expected = Request::new();
        expected.campaign.horizon = 20.0;
        assert!(found.campaign.threads >= 1);
        assert_eq!(found, expected);
        let last = request("--horizon 1 --first-run 281474976710655");
        assert_eq!(last.campaign.first_run, (1 << 48) - 1);
        assert_eq!(
            request("--horizon 1 --first-run 4 --trajectory t").trajectory,
            Some(("t".into(), 4))
        );
        let merged = request("--horizon 1 --merge a --merge b --keep-band");
        assert_eq!(merged.merge, [PathBuf::from("a"), PathBuf::from("b")]);
        assert!(merged.campaign.band);
    }

    #[test]
    fn wrong_arguments_are_explained() {
        assert_eq!(error("--runs 3"), "`--horizon` is required");
        assert_eq!(error("--horizon"), "`--horizon` needs a value");
        assert_eq!(
            error("--horizon inf"),
            "`--horizon` is `inf`, expected a time in seconds, finite and not negative"
        );
        assert_eq!(
            error("--horizon 1 --runs 0"),
            "`--runs` is `0`, expected a whole number of at least 1"
        );
        assert_eq!(
            error("--horizon 1 --seed -1"),
            "`--seed` is `-1`, expected a whole number"
        );
        for (runs, what) in [
            ("--runs 281474976710657", "`--runs`"),
            ("--runs 18446744073709551615", "`--runs`"),
            (
                "--runs 2 --first-run 281474976710655",
                "the sum of `--first-run` and `--runs`",
            ),
        ] {
            assert_eq!(
                error(&std::format!("--horizon 1 {runs}")),
                std::format!(
                    "{what} is more than 281474976710656, the runs that noise tells apart"
                )
            );
        }
        assert_eq!(error("--horizon 1 verbose"), "unknown argument `verbose`");
        assert_eq!(
            error("--horizon 1 --trajectory-run 2"),
            "`--trajectory-run` needs `--trajectory`"
        );
        assert_eq!(
            error("--horizon 1 --shard 1/2"),
            "`--shard` needs `--checkpoint`"
        );
        assert!(error("--horizon 1 --merge a --checkpoint b").starts_with("`--merge` goes with"));
        for wrong in ["0/2", "3/2", "1/0", "1", "a/b"] {
            assert_eq!(
                error(&std::format!("--horizon 1 --shard {wrong}")),
                std::format!("`--shard` is `{wrong}`, expected K/N with K from 1 to N")
            );
        }
    }
}
