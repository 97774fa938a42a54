//! Runs a child process with input, a deadline and a bound on its output.

use std::io::{self, Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

use crate::interrupt::Tended;

/// How much of standard error is kept.
const STDERR_BYTES: usize = 64 << 10;
/// How often a child that closed its output is looked at.
const POLL: Duration = Duration::from_millis(2);

/// What a child left.
#[derive(Debug)]
pub(crate) struct Output {
    pub status: ExitStatus,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

/// Why there is no output.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The child could not be started.
    Start(io::Error),
    /// The child, or its pipes, failed while it ran.
    Io(io::Error),
    /// It did not end in time, and was killed.
    Timeout,
    /// It wrote more than the limit, and was killed.
    TooLarge,
}

/// Runs `command` with `input` on standard input until it ends. Reading and writing go on in parallel, so that no full pipe can stop
/// both sides; at the deadline the child and its process group are killed.
pub(crate) fn run(
    command: &mut Command,
    input: Vec<u8>,
    limit: usize,
    timeout: Duration,
) -> Result<Output, Failure> {
    let deadline = Instant::now() + timeout;
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut tended = Tended::spawn(command).map_err(Failure::Start)?;
    let child = &mut tended.child;
    let mut stdin = child
        .stdin
        .take()
        .expect("invariant: standard input is piped");
    let stdout = reader(
        child
            .stdout
            .take()
            .expect("invariant: standard output is piped"),
        limit + 1,
    );
    let stderr = reader(
        child
            .stderr
            .take()
            .expect("invariant: standard error is piped"),
        STDERR_BYTES,
    );
    // A child that ends early closes the pipe; its status tells more than the failed write.
    thread::spawn(move || {
        let _ = stdin.write_all(&input);
    });
    let result = collect(child, &stdout, &stderr, limit, deadline);
    if result.is_err() {
        kill(child);
    }
    result
}

fn collect(
    child: &mut Child,
    stdout: &Receiver<io::Result<Vec<u8>>>,
    stderr: &Receiver<io::Result<Vec<u8>>>,
    limit: usize,
    deadline: Instant,
) -> Result<Output, Failure> {
    let receive = |receiver: &Receiver<io::Result<Vec<u8>>>| {
        let left = deadline.saturating_duration_since(Instant::now());
        receiver
            .recv_timeout(left)
            .map_err(|_| Failure::Timeout)?
            .map_err(Failure::Io)
    };
    let stdout = receive(stdout)?;
    if stdout.len() > limit {
        return Err(Failure::TooLarge);
    }
    let stderr = String::from_utf8_lossy(&receive(stderr)?).into_owned();
    loop {
        if let Some(status) = child.try_wait().map_err(Failure::Io)? {
            return Ok(Output {
                status,
                stdout,
                stderr,
            });
        }
        if Instant::now() >= deadline {
            return Err(Failure::Timeout);
        }
        thread::sleep(POLL);
    }
}

/// Reads at most `limit` bytes, then closes the pipe. The thread is not joined: a process that outlives its group may hold the pipe.
fn reader(pipe: impl Read + Send + 'static, limit: usize) -> Receiver<io::Result<Vec<u8>>> {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        let read = pipe
            .take(limit as u64)
            .read_to_end(&mut bytes)
            .map(|_| bytes);
        // The other side is gone after a timeout.
        let _ = sender.send(read);
    });
    receiver
}

fn kill(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id())
        .ok()
        .and_then(rustix::process::Pid::from_raw)
    {
        // An error means that the group has ended.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

/// The last lines of a report that say something: no traceback, no source lines.
pub(crate) fn tail(stderr: &str) -> String {
    const LINES: usize = 3;
    let telling = |line: &&str| {
        !line.trim().is_empty() && !line.starts_with([' ', '\t']) && !line.starts_with("Traceback")
    };
    let mut lines: Vec<&str> = stderr
        .lines()
        .rev()
        .filter(telling)
        .take(LINES)
        .map(str::trim_end)
        .collect();
    lines.reverse();
    if lines.is_empty() {
        "no message".to_owned()
    } else {
        // What a program writes must not reach the terminal as anything but text.
        lines.join("; ").replace(char::is_control, " ")
    }
}
