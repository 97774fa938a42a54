//! Ctrl-C at any moment: children end, scratch folders go, no file is left half-written.
//!
//! A handler thread ends the process itself, so no code has to ask whether it should go on. What must not be cut in two, such as
//! renaming a set of files, runs under [`shielded`], for which the handler waits.

use std::collections::BTreeSet;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::sync::{Mutex, MutexGuard, PoisonError};

const INTERRUPTED: i32 = 130;

struct Live {
    children: BTreeSet<u32>,
    scratch: BTreeSet<PathBuf>,
}

static LIVE: Mutex<Live> = Mutex::new(Live {
    children: BTreeSet::new(),
    scratch: BTreeSet::new(),
});

fn live() -> MutexGuard<'static, Live> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Takes over Ctrl-C and requests to terminate.
pub fn install() {
    let handler = || {
        // The guard is never released: nobody may start anything new while the process ends.
        let live = live();
        for &child in &live.children {
            end(child);
        }
        for folder in &live.scratch {
            let _ = std::fs::remove_dir_all(folder);
        }
        // On a line of its own, behind what may tell the progress.
        let _ = writeln!(
            io::stderr(),
            "\ninterrupted: each file that was asked for is whole or as it was before"
        );
        std::process::exit(INTERRUPTED);
    };
    // Without a handler Ctrl-C still ends the process; only scratch folders would stay.
    let _ = ctrlc::set_handler(handler);
}

/// Runs `work` as a whole: an interrupt waits for its end. It must be short and must not call this module.
pub fn shielded<T>(work: impl FnOnce() -> T) -> T {
    let _live = live();
    work()
}

/// A child process in a group of its own, ended with us.
pub struct Tended {
    /// The process.
    pub child: Child,
}

impl Tended {
    /// Starts `command`.
    pub fn spawn(command: &mut Command) -> io::Result<Tended> {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        let mut live = live();
        let child = command.spawn()?;
        live.children.insert(child.id());
        Ok(Tended { child })
    }
}

impl Drop for Tended {
    fn drop(&mut self) {
        // Ours to end if we stop caring before it did.
        if matches!(self.child.try_wait(), Ok(None)) {
            end(self.child.id());
            let _ = self.child.wait();
        }
        live().children.remove(&self.child.id());
    }
}

#[cfg(unix)]
fn end(child: u32) {
    if let Some(group) = i32::try_from(child)
        .ok()
        .and_then(rustix::process::Pid::from_raw)
    {
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
}

#[cfg(not(unix))]
fn end(_child: u32) {
    // The console sends Ctrl-C to every process attached to it.
}

/// A folder that is removed when dropped, and when the process is interrupted.
pub struct Scratch {
    folder: PathBuf,
}

impl Scratch {
    /// A new folder inside `parent`, which exists.
    pub fn new_in(parent: &Path) -> io::Result<Scratch> {
        let mut live = live();
        let folder = tempfile::Builder::new()
            .prefix(".nsv-")
            .tempdir_in(parent)?
            .keep();
        live.scratch.insert(folder.clone());
        Ok(Scratch { folder })
    }

    /// A new folder where the system keeps temporary files.
    pub fn new() -> io::Result<Scratch> {
        Scratch::new_in(&std::env::temp_dir())
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.folder
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let mut live = live();
        let _ = std::fs::remove_dir_all(&self.folder);
        live.scratch.remove(&self.folder);
    }
}
