//! What can go wrong on the way to a partial derivative. None of it is the fault of the specification.

use std::fmt;
use std::io;
use std::path::PathBuf;
use std::process::ExitStatus;

use super::document::CASADI_VERSION;
use super::store::Key;

/// Why partial derivatives could not be had. The message says what to do.
#[derive(Debug)]
#[expect(missing_docs, reason = "fields are the values of the message")]
pub enum Error {
    /// Nobody asked this before, and Python may not be run.
    ExportMissing { formula: String, key: Key },
    /// A stored export does not hold what its name says.
    ExportInvalid { path: PathBuf, reason: String },
    /// A file could not be read or written.
    Storage { path: PathBuf, error: io::Error },
    /// An environment variable says what cannot be used.
    Variable {
        name: &'static str,
        value: String,
        expected: &'static str,
    },
    /// There is no place for the managed Python environment.
    CacheMissing,
    /// No Python interpreter.
    PythonMissing { program: PathBuf, error: io::Error },
    /// `python3 -m venv` failed.
    VenvFailed { program: PathBuf, detail: String },
    /// pip could not install the requirements: no network, or a platform without wheels.
    InstallFailed { detail: String },
    /// The interpreter has no casadi.
    CasadiMissing { python: PathBuf, detail: String },
    /// The interpreter has another version of casadi.
    WrongVersion { python: PathBuf, found: String },
    /// The exporter did not end in time.
    Timeout { seconds: f64 },
    /// The exporter ended by a signal or with an error status.
    Crashed { status: ExitStatus, detail: String },
    /// The exporter wrote more than is read.
    OutputTooLarge { limit: usize },
    /// The exporter's output is not an answer.
    Garbled { python: PathBuf, detail: String },
    /// The exporter could not differentiate the formula.
    Refused { formula: String, detail: String },
    /// The answer is not one to the question.
    Tape { formula: String, error: TapeError },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let by_hand = format!(
            "by hand: `python3 -m venv nsv-python` and `nsv-python/bin/python -m pip install casadi=={CASADI_VERSION} numpy`, \
             then set NSV_PYTHON to nsv-python/bin/python"
        );
        match self {
            Error::ExportMissing { formula, key } => {
                write!(
                    f,
                    "the partial derivatives of `{formula}` are not stored (key {key}); run `nsv generate` once with Python"
                )
            }
            Error::ExportInvalid { path, reason } => {
                write!(
                    f,
                    "{} is not a valid export: {reason}; delete it and run `nsv generate`",
                    path.display()
                )
            }
            Error::Storage { path, error } => write!(f, "cannot use {}: {error}", path.display()),
            Error::Variable {
                name,
                value,
                expected,
            } => write!(
                f,
                "{name} is `{}`, expected {expected}",
                value.escape_debug()
            ),
            Error::CacheMissing => {
                write!(
                    f,
                    "no place for the Python environment: set NSV_CACHE_DIR to a directory, or NSV_PYTHON to an interpreter with casadi {CASADI_VERSION}"
                )
            }
            Error::PythonMissing { program, error } => write!(
                f,
                "cannot run `{}` ({error}): let NSV_PYTHON name an interpreter with casadi {CASADI_VERSION}, or unset it and install Python 3.9 or newer with its venv module",
                program.display()
            ),
            Error::VenvFailed { program, detail } => {
                write!(
                    f,
                    "`{} -m venv` failed ({detail}): install the venv module of Python (python3-venv), or {by_hand}",
                    program.display()
                )
            }
            Error::InstallFailed { detail } => {
                write!(
                    f,
                    "pip could not install casadi {CASADI_VERSION} ({detail}): connect to the network and try again, or {by_hand}"
                )
            }
            Error::CasadiMissing { python, detail } => write!(
                f,
                "{python} cannot import casadi ({detail}): run `{python} -m pip install casadi=={CASADI_VERSION} numpy`, \
                 or unset NSV_PYTHON to let nsv install it for itself",
                python = python.display()
            ),
            Error::WrongVersion { python, found } => write!(
                f,
                "{python} has casadi {found}, expected {CASADI_VERSION}: run `{python} -m pip install casadi=={CASADI_VERSION}`, \
                 or unset NSV_PYTHON to let nsv install it for itself",
                python = python.display()
            ),
            Error::Timeout { seconds } => {
                write!(
                    f,
                    "casadi did not answer within {seconds} s; set NSV_CASADI_TIMEOUT to more seconds for a large formula"
                )
            }
            Error::Crashed { status, detail } => {
                write!(
                    f,
                    "casadi ended with {status} ({detail}); `nsv doctor` shows the interpreter used"
                )
            }
            Error::OutputTooLarge { limit } => write!(
                f,
                "casadi wrote more than {limit} bytes; the formula is too large"
            ),
            Error::Garbled { python, detail } => write!(
                f,
                "{} did not answer as a Python interpreter with casadi {CASADI_VERSION} does ({detail}); check NSV_PYTHON",
                python.display()
            ),
            Error::Refused { formula, detail } => {
                write!(f, "casadi cannot differentiate `{formula}`: {detail}")
            }
            Error::Tape { formula, error } => {
                write!(f, "casadi's answer for `{formula}` does not fit: {error}")
            }
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Error::Storage { error, .. } | Error::PythonMissing { error, .. } => Some(error),
            Error::Tape { error, .. } => Some(error),
            _ => None,
        }
    }
}

/// Why a tape is not the answer to its question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TapeError {
    /// More nodes than are read.
    TooLarge {
        /// Number of nodes.
        nodes: usize,
    },
    /// A constant that is not finite hexadecimal floating point.
    Constant {
        /// As written.
        text: String,
    },
    /// Operands or integers that do not fit the operation.
    Malformed {
        /// Node.
        node: usize,
        /// Its operation.
        operation: String,
    },
    /// An operation that the compiler does not have.
    Unsupported {
        /// Node.
        node: usize,
        /// Its operation.
        operation: String,
    },
    /// Outputs other than those asked for.
    Outputs {
        /// Name of the first one that differs.
        name: String,
    },
}

impl fmt::Display for TapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TapeError::TooLarge { nodes } => write!(f, "{nodes} instructions, more than are read"),
            TapeError::Constant { text } => write!(f, "`{text}` is not a finite constant"),
            TapeError::Malformed { node, operation } => {
                write!(f, "instruction {node} (`{operation}`) has wrong operands")
            }
            TapeError::Unsupported { node, operation } => {
                write!(
                    f,
                    "instruction {node} is `{operation}`, an operation that nsv does not have"
                )
            }
            TapeError::Outputs { name } => write!(f, "output `{name}` is not the one asked for"),
        }
    }
}

impl std::error::Error for TapeError {}
