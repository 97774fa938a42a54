//! Standard output for data, standard error for everything else.

use std::fmt;
use std::io::{self, IsTerminal as _, Write as _};

use super::failure::{Exit, Failure, reason};

/// Writes data. A reader that went away ends the verb quietly.
pub(crate) fn data(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    let written = stdout
        .write_all(text.as_bytes())
        .and_then(|()| stdout.flush());
    written.map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::BrokenPipe,
        _ => Failure::new(
            Exit::Environment,
            format_args!("cannot write to standard output: {}", reason(&error)),
        ),
    })
}

/// Writes a JSON document for programs.
pub(crate) fn json(document: &impl serde::Serialize) -> Result<(), Failure> {
    let text =
        serde_json::to_string_pretty(document).expect("invariant: documents have string keys");
    data(&(text + "\n"))
}

/// Tells the user something; there is nobody to tell if that fails.
pub(crate) fn note(text: impl fmt::Display) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Whether standard error is a terminal that shows progress.
pub(crate) fn interactive() -> bool {
    io::stderr().is_terminal()
}

/// Whether messages may be coloured: on a terminal, and not against the user's wish (<https://no-color.org>).
pub(crate) fn colour() -> bool {
    let plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    interactive() && !plain && std::env::var_os("TERM").is_none_or(|term| term != "dumb")
}
