//! How a verb ends when it does not end well.

use std::path::Path;
use std::process::ExitCode;
use std::{fmt, io};

use super::output::note;

/// Exit codes other than 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// The specification has errors.
    Spec = 1,
    /// The command line asks for something impossible.
    Usage = 2,
    /// Something outside is missing or broken: toolchain, Python, disk.
    Environment = 3,
    /// A check that was asked for failed.
    Check = 4,
}

/// The end of a verb that could not do its work.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Everything was said already.
    Reported(Exit),
    /// One message, and the way out if there is one.
    Message {
        /// Exit code.
        exit: Exit,
        /// Lower case, no full stop.
        message: String,
        /// What to do.
        help: Option<String>,
    },
    /// Whoever read standard output has seen enough.
    BrokenPipe,
}

impl Failure {
    /// A failure with one message.
    pub(crate) fn new(exit: Exit, message: impl fmt::Display) -> Failure {
        Failure::Message {
            exit,
            message: message.to_string(),
            help: None,
        }
    }

    /// A file that cannot be read or written.
    pub(crate) fn io(action: &str, path: &Path, error: &io::Error) -> Failure {
        Failure::new(
            Exit::Environment,
            format_args!("cannot {action} `{}`: {}", path.display(), reason(error)),
        )
    }

    /// The same with a way out.
    pub(crate) fn with_help(self, text: impl fmt::Display) -> Failure {
        match self {
            Failure::Message { exit, message, .. } => Failure::Message {
                exit,
                message,
                help: Some(text.to_string()),
            },
            other => other,
        }
    }

    /// Tells the user and gives the exit code.
    pub(crate) fn report(self) -> ExitCode {
        match self {
            Failure::Reported(exit) => ExitCode::from(exit as u8),
            Failure::Message {
                exit,
                message,
                help,
            } => {
                note(format_args!("error: {message}"));
                if let Some(help) = help {
                    note(format_args!("  = help: {help}"));
                }
                ExitCode::from(exit as u8)
            }
            Failure::BrokenPipe => ExitCode::SUCCESS,
        }
    }
}

/// The operating system's words, in the style of our messages.
pub(crate) fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file or directory".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        io::ErrorKind::IsADirectory => "it is a directory".to_owned(),
        _ => error.to_string(),
    }
}
