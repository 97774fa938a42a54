//! The conversation with a runner: arguments in, progress and statistics out, signals in files.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use crate::cli::child;
use crate::cli::failure::{Exit, Failure, reason};
use crate::report::{Outcome, Table};

/// What to simulate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Campaign {
    /// Seed of all noise and dispersion.
    pub seed: u64,
    /// Number of the first run.
    pub first_run: u64,
    /// Number of runs.
    pub runs: u64,
    /// Length of a run, s.
    pub horizon_s: f64,
    /// Start of the rms window, s.
    pub settle_s: f64,
    /// Worker threads; 0 for one per core.
    pub threads: usize,
    /// Whether noise acts.
    pub noise: bool,
    /// Whether plant parameters are dispersed.
    pub dispersion: bool,
}

/// Which signals to record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Recordings {
    /// The run whose signals are recorded.
    pub trajectory_run: Option<u64>,
    /// Whether statistics over the runs are recorded.
    pub band: bool,
}

/// What came of it.
#[derive(Clone, Debug)]
pub(crate) struct Replay {
    /// Statistics.
    pub outcome: Outcome,
    /// Signals of one run.
    pub trajectory: Option<Table>,
    /// Pointwise statistics over the runs.
    pub band: Option<Table>,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Line {
    Progress(u64),
    Result(Outcome),
}

/// Runs `program`; `scratch` takes the files that the signals come in, `on_progress` sees how many runs are done.
pub(crate) fn simulate(
    program: &Path,
    campaign: &Campaign,
    recordings: Recordings,
    scratch: &Path,
    mut on_progress: impl FnMut(u64),
) -> Result<Replay, Failure> {
    let file = |name: &str, wanted: bool| wanted.then(|| scratch.join(name));
    let trajectory = file("trajectory", recordings.trajectory_run.is_some());
    let band = file("band", recordings.band);
    let mut command = Command::new(program);
    command.args(arguments(campaign));
    if let (Some(run), Some(path)) = (recordings.trajectory_run, &trajectory) {
        command
            .arg("--trajectory")
            .arg(path)
            .arg("--trajectory-run")
            .arg(run.to_string());
    }
    if let Some(path) = &band {
        command.arg("--band").arg(path);
    }
    let (mut outcome, mut strange) = (None, None);
    let finished = child::run(&mut command, |line| match serde_json::from_str(line) {
        Ok(Line::Progress(done)) => on_progress(done),
        Ok(Line::Result(result)) => outcome = Some(result),
        Err(_) => strange = Some(line.to_owned()),
    });
    let finished = finished.map_err(|error| {
        Failure::new(
            Exit::Environment,
            format_args!("cannot run the simulator: {}", reason(&error)),
        )
    })?;
    if !finished.status.success() {
        return Err(ended(
            &format!("ended with {}", finished.status),
            &finished.stderr,
        ));
    }
    let outcome = match (outcome, strange) {
        (Some(outcome), None) => outcome,
        (_, Some(line)) => return Err(ended(&format!("said `{line}`"), &finished.stderr)),
        (None, None) => return Err(ended("gave no result", &finished.stderr)),
    };
    Ok(Replay {
        outcome,
        trajectory: trajectory.map(read).transpose()?,
        band: band.map(read).transpose()?,
    })
}

fn arguments(campaign: &Campaign) -> Vec<String> {
    let Campaign {
        seed,
        first_run,
        runs,
        horizon_s,
        settle_s,
        threads,
        noise,
        dispersion,
    } = *campaign;
    let threads = match threads {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    let pairs = [
        ("--seed", seed.to_string()),
        ("--runs", runs.to_string()),
        ("--first-run", first_run.to_string()),
        ("--horizon", format!("{horizon_s:?}")),
        ("--settle", format!("{settle_s:?}")),
        ("--threads", threads.to_string()),
    ];
    let switches = [("--no-noise", !noise), ("--no-dispersion", !dispersion)];
    let switches = switches
        .into_iter()
        .filter(|(_, given)| *given)
        .map(|(name, _)| name.to_owned());
    pairs
        .into_iter()
        .flat_map(|(name, value)| [name.to_owned(), value])
        .chain(switches)
        .collect()
}

fn read(path: PathBuf) -> Result<Table, Failure> {
    let bytes = std::fs::read(&path).map_err(|error| Failure::io("read", &path, &error))?;
    Table::parse(&bytes).map_err(|error| {
        Failure::new(
            Exit::Environment,
            format_args!("cannot read `{}`: {error}", path.display()),
        )
    })
}

fn ended(how: &str, stderr: &str) -> Failure {
    let stderr = stderr.trim_end();
    let words = if stderr.is_empty() {
        String::new()
    } else {
        format!("\n  {}", stderr.replace('\n', "\n  "))
    };
    Failure::new(
        Exit::Environment,
        format_args!("the simulator {how}{words}"),
    )
}

#[cfg(test)]
#[cfg(unix)]
pub(in crate::cli) mod tests {
    use super::*;

    pub(in crate::cli) const RESULT: &str = concat!(
        r#"{"result": {"runs": 2, "samples": 20, "violated": 0.5, "violated_interval95": [0.0126, 0.9874], "#,
        r#""ratio": {"median": 0.4, "p90": 1.2, "p99": 1.3, "max": 1.3}, "rms_tracking": {"y": 0.002}, "#,
        r#""saturated_fraction": {"u": 0.25}, "nonfinite": 0, "wall_s": 0.5, "steps_per_s": 40.0}}"#
    );

    /// A runner made of a shell script. Another process writes it: a file that this one has open for writing, and that a fork in
    /// another test's thread inherits for a moment, could not be started.
    pub(in crate::cli) fn script(folder: &Path, body: &str) -> PathBuf {
        let path = folder.join("runner");
        let writer = r#"printf '#!/bin/sh\n%s\n' "$1" > "$2" && chmod +x "$2""#;
        let status = Command::new("sh")
            .args(["-c", writer, "sh", body])
            .arg(&path)
            .status()
            .unwrap();
        assert!(status.success());
        path
    }

    const CAMPAIGN: Campaign = Campaign {
        seed: 7,
        first_run: 3,
        runs: 2,
        horizon_s: 20.0,
        settle_s: 4.5,
        threads: 2,
        noise: false,
        dispersion: true,
    };

    fn play(body: &str, recordings: Recordings) -> (Result<Replay, Failure>, Vec<u64>) {
        let folder = tempfile::tempdir().unwrap();
        let mut progress = Vec::new();
        let program = script(folder.path(), body);
        let replay = simulate(&program, &CAMPAIGN, recordings, folder.path(), |done| {
            progress.push(done)
        });
        (replay, progress)
    }

    fn message(result: Result<Replay, Failure>) -> String {
        match result {
            Err(Failure::Message {
                exit: Exit::Environment,
                message,
                ..
            }) => message,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn progress_and_statistics_are_read() {
        let (replay, progress) = play(
            &format!("echo '{{\"progress\": 1}}'\necho '{RESULT}'"),
            Recordings::default(),
        );
        let outcome = replay.unwrap().outcome;
        assert_eq!(
            (outcome.runs, outcome.violated, progress),
            (2, Some(0.5), vec![1])
        );
    }

    #[test]
    fn recordings_are_read_from_the_files_named() {
        // `--trajectory FILE --trajectory-run K --band FILE` follow the fixed arguments.
        let body = format!(
            r#"while [ $# -gt 0 ]; do case "$1" in
            --trajectory) printf '{{"columns": ["t"], "rows": 1}}\n\0\0\0\0\0\0\360\077' > "$2";;
            --trajectory-run) [ "$2" = 4 ] || exit 9;;
            --band) printf '{{"columns": ["t"], "rows": 0}}\n' > "$2";;
            esac; shift; done; echo '{RESULT}'"#
        );
        let (replay, _) = play(
            &body,
            Recordings {
                trajectory_run: Some(4),
                band: true,
            },
        );
        let replay = replay.unwrap();
        assert_eq!(replay.trajectory.unwrap().column("t"), Some(&[1.0][..]));
        assert_eq!(replay.band.unwrap().rows(), 0);
    }

    #[test]
    fn arguments_are_those_of_the_protocol() {
        let arguments = arguments(&CAMPAIGN).join(" ");
        assert_eq!(
            arguments,
            "--seed 7 --runs 2 --first-run 3 --horizon 20.0 --settle 4.5 --threads 2 --no-noise"
        );
    }

    #[test]
    fn a_runner_that_fails_is_quoted() {
        let (failed, _) = play("echo out of range >&2; exit 3", Recordings::default());
        let text = message(failed);
        assert!(
            text.contains("exit status: 3") && text.contains("\n  out of range"),
            "{text}"
        );
        assert!(
            message(play("echo nonsense", Recordings::default()).0).contains("said `nonsense`")
        );
        assert!(message(play("true", Recordings::default()).0).contains("gave no result"));
        let (cut, _) = play(
            &format!("echo '{RESULT}'"),
            Recordings {
                trajectory_run: Some(0),
                band: false,
            },
        );
        assert!(message(cut).contains("trajectory"));
    }
}
