//! Asks `export.py`, a Python process that answers questions about derivatives.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use super::document::{Answer, Ask, CASADI_VERSION, Refusal, Request, SCHEMA, Tape};
use super::error::Error;
use super::process::{Failure, Reply, Session, tail};

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
    let answer = Exporter::start(python, timeout)?.ask("", None)?;
    let version = answer.python.ok_or_else(|| garbled(python, "no version"))?;
    Ok(Versions {
        python: version,
        casadi: CASADI_VERSION.to_owned(),
    })
}

/// A Python process that takes derivatives, one question after another: importing casadi takes longer than most answers. After an error
/// it is not to be asked again.
pub(crate) struct Exporter {
    python: PathBuf,
    timeout: Duration,
    session: Session,
}

impl Exporter {
    /// Starts it; each answer may take `timeout`.
    pub(crate) fn start(python: &Path, timeout: Duration) -> Result<Exporter, Error> {
        let mut command = Command::new(python);
        // -I: neither the environment nor the current directory can put another module in the way; -B: nothing is written.
        command.args(["-I", "-B", "-c", EXPORTER]);
        let session = Session::start(&mut command, MAX_OUTPUT);
        Ok(Exporter {
            session: session.map_err(|failure| failed(python, timeout, failure))?,
            python: python.to_owned(),
            timeout,
        })
    }

    /// The tape of a request.
    pub(crate) fn tape(&mut self, formula: &str, request: &Request) -> Result<Tape, Error> {
        self.ask(formula, Some(request))?
            .tape
            .ok_or_else(|| garbled(&self.python, "no tape"))
    }

    fn ask(&mut self, formula: &str, request: Option<&Request>) -> Result<Answer, Error> {
        let document = Ask {
            schema: SCHEMA,
            casadi: CASADI_VERSION,
            request,
        };
        let question = serde_json::to_vec(&document).expect("invariant: a request is JSON");
        let (python, timeout) = (self.python.as_path(), self.timeout);
        let reply = self.session.ask(question, timeout);
        let answer = match reply.map_err(|failure| failed(python, timeout, failure))? {
            Reply::Line(answer) => answer,
            Reply::Ended(output) if output.status.success() => output.stdout,
            Reply::Ended(output) => {
                return Err(Error::Crashed {
                    status: output.status,
                    detail: tail(&output.stderr),
                });
            }
        };
        let answer: Answer =
            serde_json::from_slice(&answer).map_err(|error| garbled(python, &error.to_string()))?;
        if answer.schema != SCHEMA {
            let detail = format!("schema `{}`, expected `{SCHEMA}`", answer.schema);
            return Err(garbled(python, &detail));
        }
        match answer.error {
            Some(refusal) => Err(refused(python, formula, refusal)),
            None => Ok(answer),
        }
    }
}

fn failed(python: &Path, timeout: Duration, failure: Failure) -> Error {
    match failure {
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
