//! Command-line arguments.

use std::ffi::{OsStr, OsString};
use std::fmt;
use std::format;
use std::path::PathBuf;
use std::str::FromStr;
use std::string::{String, ToString};
use std::thread;

use crate::ensemble::Campaign;

/// What the arguments ask for.
#[derive(Debug, PartialEq)]
pub(super) enum Command {
    Help,
    Simulate(Request),
}

/// A campaign, and the files to write with it.
#[derive(Debug, PartialEq)]
pub(super) struct Request {
    pub(super) campaign: Campaign,
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
    WithoutTrajectory,
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
            Self::WithoutTrajectory => write!(f, "`--trajectory-run` needs `--trajectory`"),
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
  --no-dispersion      nominal parameters
  --trajectory FILE    write the telemetry of one run
  --trajectory-run K   its number (default: the first run)
  --band FILE          write percentiles over the runs against time"
    )
}

/// Reads arguments. The last of repeated options holds.
pub(super) fn parse(mut arguments: impl Iterator<Item = OsString>) -> Result<Command, UsageError> {
    let mut campaign = Campaign {
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
    };
    let (mut trajectory, mut trajectory_run, mut band) = (None, None, None);
    while let Some(argument) = arguments.next() {
        let option = argument.to_string_lossy();
        let mut value = || {
            arguments
                .next()
                .ok_or_else(|| UsageError::NoValue(option.to_string()))
        };
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
            "--trajectory" => trajectory = Some(PathBuf::from(value()?)),
            "--trajectory-run" => trajectory_run = Some(count(&option, &value()?, 0)?),
            "--band" => band = Some(PathBuf::from(value()?)),
            _ => return Err(UsageError::Unknown(option.to_string())),
        }
    }
    if campaign.horizon.is_nan() {
        return Err(UsageError::Missing("--horizon"));
    }
    if trajectory.is_none() && trajectory_run.is_some() {
        return Err(UsageError::WithoutTrajectory);
    }
    campaign.band = band.is_some();
    let trajectory = trajectory.map(|path| (path, trajectory_run.unwrap_or(campaign.first_run)));
    Ok(Command::Simulate(Request {
        campaign,
        trajectory,
        band,
    }))
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

    use super::{Command, Request, parse};

    fn request(line: &str) -> Request {
        match parse(line.split_whitespace().map(Into::into)) {
            Ok(Command::Simulate(request)) => request,
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
        let Request {
            campaign,
            trajectory,
            band,
        } = request(
            "--seed 18446744073709551615 --runs 20 --first-run 7 --horizon 2.5 --settle 1e-1 --threads 3 --no-noise --no-dispersion \
             --trajectory a.bin --trajectory-run 9 --band b.bin",
        );
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
            (trajectory, band),
            (Some(("a.bin".into(), 9)), Some(PathBuf::from("b.bin")))
        );
    }

    #[test]
    fn the_horizon_alone_is_enough() {
        let Request {
            campaign,
            trajectory,
            band,
        } = request("--horizon 20");
        assert_eq!(
            (
                campaign.seed,
                campaign.runs,
                campaign.first_run,
                campaign.settle
            ),
            (1, 1, 0, 0.0)
        );
        assert!(campaign.noise && campaign.dispersion && !campaign.band && campaign.threads >= 1);
        assert_eq!((trajectory, band), (None, None));
        assert_eq!(
            request("--horizon 1 --first-run 4 --trajectory t").trajectory,
            Some(("t".into(), 4))
        );
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
        assert_eq!(error("--horizon 1 verbose"), "unknown argument `verbose`");
        assert_eq!(
            error("--horizon 1 --trajectory-run 2"),
            "`--trajectory-run` needs `--trajectory`"
        );
    }
}
