//! Running another program to its end.

use std::io::{self, BufRead as _, BufReader, Read as _};
use std::process::{Command, ExitStatus, Stdio};

use nsv_codegen::interrupt::Tended;

/// How a program ended, and what it said on standard error.
#[derive(Debug)]
pub(crate) struct Finished {
    /// Exit status.
    pub status: ExitStatus,
    /// Standard error, as text.
    pub stderr: String,
}

/// Runs `command` without input; `on_line` sees each line of its standard output as it comes.
pub(crate) fn run(command: &mut Command, mut on_line: impl FnMut(&str)) -> io::Result<Finished> {
    command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut tended = Tended::spawn(command)?;
    let stdout = tended
        .child
        .stdout
        .take()
        .expect("invariant: standard output is piped");
    let mut stderr = tended
        .child
        .stderr
        .take()
        .expect("invariant: standard error is piped");
    // Both pipes are drained at once, else a program that fills one while we read the other would wait for ever.
    let complaints = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        let _ = stderr.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    });
    for line in BufReader::new(stdout).split(b'\n') {
        on_line(&String::from_utf8_lossy(&line?));
    }
    let status = tended.child.wait()?;
    Ok(Finished {
        status,
        stderr: complaints.join().unwrap_or_default(),
    })
}

/// Standard output of a short program; `None` if it cannot be started or fails.
pub(crate) fn answer(command: &mut Command) -> Option<String> {
    let mut text = String::new();
    let finished = run(command, |line| text.extend([line, "\n"])).ok()?;
    finished.status.success().then_some(text)
}

#[cfg(test)]
#[cfg(unix)]
mod tests {
    use super::*;

    #[test]
    fn both_streams_are_read() {
        let mut lines = Vec::new();
        let script = "i=0; while [ $i -lt 3000 ]; do echo line $i; echo complaint $i >&2; i=$((i+1)); done; exit 7";
        let finished = run(Command::new("sh").args(["-c", script]), |line| {
            lines.push(line.to_owned())
        })
        .unwrap();
        assert_eq!(
            (
                lines.len(),
                finished.stderr.lines().count(),
                finished.status.code()
            ),
            (3000, 3000, Some(7))
        );
    }

    #[test]
    fn a_missing_program_is_an_error() {
        assert_eq!(
            run(&mut Command::new("/no/such/program"), |_| {})
                .unwrap_err()
                .kind(),
            io::ErrorKind::NotFound
        );
        assert_eq!(answer(Command::new("sh").args(["-c", "exit 1"])), None);
    }
}
