//! Child processes with a deadline and a bound on their output: run to their end, or asked line by line.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, Sender};
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

/// Runs `command` without input until it ends; at the deadline the child and its process group are killed.
pub(crate) fn run(
    command: &mut Command,
    limit: usize,
    timeout: Duration,
) -> Result<Output, Failure> {
    let deadline = Instant::now() + timeout;
    let mut tended = spawn(command.stdin(Stdio::null()))?;
    let child = &mut tended.child;
    let stdout = child.stdout.take().expect("invariant: it is piped");
    let stdout = reader(stdout, limit + 1);
    let stderr = errors(child);
    let result = receive(&stdout, deadline).and_then(|stdout| match stdout.len() > limit {
        true => Err(Failure::TooLarge),
        false => ended(child, stdout, &stderr, deadline),
    });
    if result.is_err() {
        kill(child);
    }
    result
}

fn spawn(command: &mut Command) -> Result<Tended, Failure> {
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    Tended::spawn(command).map_err(Failure::Start)
}

fn errors(child: &mut Child) -> Receiver<io::Result<Vec<u8>>> {
    let stderr = child.stderr.take().expect("invariant: it is piped");
    reader(stderr, STDERR_BYTES)
}

fn receive(
    receiver: &Receiver<io::Result<Vec<u8>>>,
    deadline: Instant,
) -> Result<Vec<u8>, Failure> {
    let left = deadline.saturating_duration_since(Instant::now());
    receiver
        .recv_timeout(left)
        .map_err(|_| Failure::Timeout)?
        .map_err(Failure::Io)
}

/// What a child left that has closed its output.
fn ended(
    child: &mut Child,
    stdout: Vec<u8>,
    stderr: &Receiver<io::Result<Vec<u8>>>,
    deadline: Instant,
) -> Result<Output, Failure> {
    let stderr = String::from_utf8_lossy(&receive(stderr, deadline)?).into_owned();
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

/// A child that answers each line with a line. Reading and writing go on in threads of their own, so that no full pipe can stop both
/// sides; it is killed with its process group when dropped.
pub(crate) struct Session {
    tended: Tended,
    questions: Sender<Vec<u8>>,
    answers: Receiver<io::Result<Vec<u8>>>,
    stderr: Receiver<io::Result<Vec<u8>>>,
    limit: usize,
}

/// What a child makes of a question.
#[derive(Debug)]
pub(crate) enum Reply {
    /// Its answer.
    Line(Vec<u8>),
    /// It ended instead.
    Ended(Output),
}

impl Session {
    /// Starts `command`; a line of its output has at most `limit` bytes.
    pub(crate) fn start(command: &mut Command, limit: usize) -> Result<Session, Failure> {
        let mut tended = spawn(command.stdin(Stdio::piped()))?;
        let child = &mut tended.child;
        let mut stdin = child.stdin.take().expect("invariant: it is piped");
        let stdout = child.stdout.take().expect("invariant: it is piped");
        let stderr = errors(child);
        let (questions, asked) = mpsc::channel::<Vec<u8>>();
        thread::spawn(move || {
            // A child that ended has closed the pipe; its status tells more than the failed write.
            while let Ok(question) = asked.recv() {
                let _ = stdin.write_all(&question).and_then(|()| stdin.flush());
            }
        });
        Ok(Session {
            answers: lines(stdout, limit),
            tended,
            questions,
            stderr,
            limit,
        })
    }

    /// The answer to a line.
    pub(crate) fn ask(
        &mut self,
        mut question: Vec<u8>,
        timeout: Duration,
    ) -> Result<Reply, Failure> {
        let deadline = Instant::now() + timeout;
        question.push(b'\n');
        // The thread ends with the session only.
        let _ = self.questions.send(question);
        let answer = receive(&self.answers, deadline)?;
        if answer.len() > self.limit {
            return Err(Failure::TooLarge);
        }
        match answer.ends_with(b"\n") {
            true => Ok(Reply::Line(answer)),
            false => {
                ended(&mut self.tended.child, answer, &self.stderr, deadline).map(Reply::Ended)
            }
        }
    }
}

/// Reads lines with their ends until one is longer than `limit`; what stands behind the last end, perhaps nothing, is the last.
fn lines(pipe: impl Read + Send + 'static, limit: usize) -> Receiver<io::Result<Vec<u8>>> {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || {
        let mut pipe = BufReader::new(pipe);
        loop {
            let mut line = Vec::new();
            let most = u64::try_from(limit).unwrap_or(u64::MAX).saturating_add(1);
            let read = (&mut pipe).take(most).read_until(b'\n', &mut line);
            let last = read.is_err() || !line.ends_with(b"\n");
            // The other side is gone after a failure.
            if sender.send(read.map(|_| line)).is_err() || last {
                return;
            }
        }
    });
    receiver
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
