//! The conversation with a runner: arguments in, progress and statistics out, signals in files.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde::Deserialize;

use super::job::Job;
use crate::cli::child;
use crate::cli::failure::{Exit, Failure, reason};
use crate::report::{Outcome, Table};

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

/// What a runner says while it works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Event {
    /// So many runs were done before.
    Resumed(u64),
    /// So many runs are done, of so many.
    Progress(u64, u64),
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Line {
    Resumed(u64),
    Progress(u64, u64),
    Result(Box<Outcome>),
    /// Why, and what the user can do.
    Refused(String, String),
}

/// Runs the program; `scratch` takes the files that the signals come in.
pub(crate) fn perform(
    job: &Job<'_>,
    scratch: &Path,
    mut on_event: impl FnMut(Event),
) -> Result<Replay, Failure> {
    let file = |name: &str, wanted: bool| wanted.then(|| scratch.join(name));
    let trajectory = file("trajectory", job.recordings.trajectory_run.is_some());
    let band = file("band", job.recordings.band);
    let mut command = Command::new(&job.program.path);
    command.args(job.arguments());
    if let (Some(run), Some(path)) = (job.recordings.trajectory_run, &trajectory) {
        command.arg("--trajectory").arg(path);
        command.arg("--trajectory-run").arg(run.to_string());
    }
    if let Some(path) = &band {
        command.arg("--band").arg(path);
    }
    let outcome = conversation(&mut command, &mut on_event)?;
    Ok(Replay {
        outcome,
        trajectory: trajectory.map(read).transpose()?,
        band: band.map(read).transpose()?,
    })
}

/// Runs the command to its result.
fn conversation(
    command: &mut Command,
    on_event: &mut impl FnMut(Event),
) -> Result<Outcome, Failure> {
    let (mut outcome, mut refused, mut strange) = (None, None, None);
    let finished = child::run(command, |line| match serde_json::from_str(line) {
        Ok(Line::Resumed(runs)) => on_event(Event::Resumed(runs)),
        Ok(Line::Progress(done, runs)) => on_event(Event::Progress(done, runs)),
        Ok(Line::Result(result)) => outcome = Some(*result),
        Ok(Line::Refused(reason, remedy)) => refused = Some((reason, remedy)),
        Err(_) => strange = Some(line.to_owned()),
    });
    let finished = finished.map_err(|error| {
        Failure::new(
            Exit::Environment,
            format_args!("cannot run the simulator: {}", reason(&error)),
        )
    })?;
    if let Some((reason, remedy)) = refused {
        return Err(Failure::new(Exit::Usage, reason).with_help(remedy));
    }
    if !finished.status.success() {
        return Err(ended(
            &format!("ended with {}", finished.status),
            &finished.stderr,
        ));
    }
    match (outcome, strange) {
        (Some(outcome), None) => Ok(outcome),
        (_, Some(line)) => Err(ended(&format!("said `{line}`"), &finished.stderr)),
        (None, None) => Err(ended("gave no result", &finished.stderr)),
    }
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
    use super::super::job::tests::CAMPAIGN;
    use super::super::{Program, Recordings, Work};
    use super::*;

    pub(in crate::cli) const RESULT: &str = concat!(
        r#"{"result": {"runs": 2, "samples": 20, "violations": 1, "violated": 0.5, "violated_interval95": [0.0126, 0.9874], "#,
        r#""ratio": {"median": 0.4, "p90": 1.2, "p99": 1.3, "max": 1.3, "accuracy": 0.0}, "worst": [{"run": 4, "ratio": 1.3, "diverged": false}], "rms_tracking": {"y": 0.002}, "#,
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

    const FLY: Work<'_> = Work::Fly {
        part: None,
        checkpoint: None,
    };

    fn play(body: &str, recordings: Recordings<'_>) -> (Result<Replay, Failure>, Vec<Event>) {
        let folder = tempfile::tempdir().unwrap();
        let mut events = Vec::new();
        let program = Program {
            path: script(folder.path(), body),
            key: "k".into(),
        };
        let job = Job {
            program: &program,
            specification: Path::new("/spec.yaml"),
            campaign: &CAMPAIGN,
            work: FLY,
            recordings,
        };
        let replay = perform(&job, folder.path(), |event| events.push(event));
        (replay, events)
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
        let (replay, events) = play(
            &format!("echo '{{\"resumed\": 0}}'\necho '{{\"progress\": [1, 2]}}'\necho '{RESULT}'"),
            Recordings::default(),
        );
        let outcome = replay.unwrap().outcome;
        assert_eq!((outcome.runs, outcome.violated), (2, Some(0.5)));
        assert_eq!(events, [Event::Resumed(0), Event::Progress(1, 2)]);
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
                ..Recordings::default()
            },
        );
        let replay = replay.unwrap();
        assert_eq!(replay.trajectory.unwrap().column("t"), Some(&[1.0][..]));
        assert_eq!(replay.band.unwrap().rows(), 0);
    }

    #[test]
    fn a_refusal_is_a_matter_of_usage() {
        let (refused, _) = play(
            r#"echo '{"refused": ["`c` is damaged", "start anew"]}'; exit 2"#,
            Recordings::default(),
        );
        let Err(Failure::Message {
            exit: Exit::Usage,
            message,
            ..
        }) = refused
        else {
            panic!("{refused:?}")
        };
        assert_eq!(message, "`c` is damaged");
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
                ..Recordings::default()
            },
        );
        assert!(message(cut).contains("trajectory"));
    }
}
