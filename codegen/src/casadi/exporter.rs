//! Asks `export.py`: one Python process for one question.

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use super::document::{Answer, Ask, CASADI_VERSION, Refusal, Request, SCHEMA, Tape};
use super::error::Error;
use super::process::{self, Failure, tail};

/// The exporter, run with `python -c`.
const EXPORTER: &str = include_str!("export.py");
/// Largest answer that is read, in bytes.
pub(super) const MAX_OUTPUT: usize = 64 << 20;

/// Versions that answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Versions {
    /// Of Python.
    pub python: String,
    /// Of CasADi.
    pub casadi: String,
}

/// Whether `python` can differentiate, and with what.
pub fn versions(python: &Path, timeout: Duration) -> Result<Versions, Error> {
    let answer = ask(python, timeout, "", None)?;
    let version = answer.python.ok_or_else(|| garbled(python, "no version"))?;
    Ok(Versions {
        python: version,
        casadi: CASADI_VERSION.to_owned(),
    })
}

/// The tape of a request.
pub(crate) fn tape(
    python: &Path,
    timeout: Duration,
    formula: &str,
    request: &Request,
) -> Result<Tape, Error> {
    ask(python, timeout, formula, Some(request))?
        .tape
        .ok_or_else(|| garbled(python, "no tape"))
}

fn ask(
    python: &Path,
    timeout: Duration,
    formula: &str,
    request: Option<&Request>,
) -> Result<Answer, Error> {
    let document = Ask {
        schema: SCHEMA,
        casadi: CASADI_VERSION,
        request,
    };
    let input = serde_json::to_vec(&document).expect("invariant: a request is JSON");
    let mut command = Command::new(python);
    // -I: neither the environment nor the current directory can put another module in the way; -B: nothing is written.
    command.args(["-I", "-B", "-c", EXPORTER]);
    let output =
        process::run(&mut command, input, MAX_OUTPUT, timeout).map_err(
            |failure| match failure {
                Failure::Start(error) => Error::PythonMissing {
                    program: python.to_owned(),
                    error,
                },
                Failure::Io(error) => Error::Storage {
                    path: python.to_owned(),
                    error,
                },
                Failure::Timeout => Error::Timeout {
                    seconds: timeout.as_secs_f64(),
                },
                Failure::TooLarge => Error::OutputTooLarge { limit: MAX_OUTPUT },
            },
        )?;
    if !output.status.success() {
        return Err(Error::Crashed {
            status: output.status,
            detail: tail(&output.stderr),
        });
    }
    let answer: Answer = serde_json::from_slice(&output.stdout)
        .map_err(|error| garbled(python, &error.to_string()))?;
    if answer.schema != SCHEMA {
        return Err(garbled(
            python,
            &format!("schema `{}`, expected `{SCHEMA}`", answer.schema),
        ));
    }
    match answer.error {
        Some(refusal) => Err(refused(python, formula, refusal)),
        None => Ok(answer),
    }
}

fn refused(python: &Path, formula: &str, refusal: Refusal) -> Error {
    let (python, detail) = (python.to_owned(), refusal.message);
    match refusal.code.as_str() {
        "casadi-missing" => Error::CasadiMissing { python, detail },
        "casadi-version" => Error::WrongVersion {
            python,
            found: detail,
        },
        _ => Error::Refused {
            formula: formula.to_owned(),
            detail,
        },
    }
}

fn garbled(python: &Path, detail: &str) -> Error {
    Error::Garbled {
        python: python.to_owned(),
        detail: detail.to_owned(),
    }
}
