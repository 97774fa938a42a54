//! Where exports and Python are found, and the Python environment that nsv makes for itself.

use std::env;
use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use sha2::{Digest, Sha256};

use super::error::Error;
use super::process::{self, Failure, Output, tail};
use super::store::Key;
use crate::interrupt::Scratch;

/// What the environment holds, pinned by hash for CPython 3.9 to 3.14.
const REQUIREMENTS: &str = include_str!("requirements.txt");
/// Time that making the environment may take: a download over a slow line.
const INSTALLATION: Duration = Duration::from_secs(60 * 60);
/// How much output of an installation is read.
const INSTALLATION_OUTPUT: usize = 16 << 20;
/// Says how long the exporter may take, s.
const TIMEOUT_VARIABLE: &str = "NSV_CASADI_TIMEOUT";
/// Longest time that it may say: a day.
const LONGEST: Duration = Duration::from_secs(24 * 60 * 60);
/// Time that the exporter may take, unless the variable says otherwise.
pub(super) const TIMEOUT: Duration = Duration::from_secs(60);

/// Whether Python may be run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Stored exports only.
    Offline,
    /// What is not stored is asked from CasADi; Python's packages are installed if they are missing.
    Provision,
}

/// Where to look, and how long to wait.
#[derive(Clone, Debug)]
pub struct Environment {
    /// Committed exports, such as `specs/partials`.
    pub exports: PathBuf,
    /// The user's cache: further exports, and the Python environment.
    pub cache: Option<PathBuf>,
    /// Interpreter with casadi that the user chose.
    pub python: Option<PathBuf>,
    /// Interpreter that the environment is made from.
    pub base_python: PathBuf,
    /// Whether Python may be run.
    pub mode: Mode,
    /// Time that the exporter may take.
    pub timeout: Duration,
}

impl Environment {
    /// Committed exports only: no cache, no Python.
    pub fn offline(exports: impl Into<PathBuf>) -> Self {
        Self {
            exports: exports.into(),
            cache: None,
            python: None,
            base_python: PathBuf::from("python3"),
            mode: Mode::Offline,
            timeout: TIMEOUT,
        }
    }

    /// As the user's variables have it: `NSV_PYTHON`, [`cache_folder`] and `NSV_CASADI_TIMEOUT` in seconds.
    pub fn from_variables(exports: impl Into<PathBuf>, mode: Mode) -> Result<Self, Error> {
        let given = env::var_os(TIMEOUT_VARIABLE).filter(|text| !text.is_empty());
        let timeout = given.map_or(Ok(TIMEOUT), |text| {
            seconds(&text).ok_or_else(|| Error::Variable {
                name: TIMEOUT_VARIABLE,
                value: text.to_string_lossy().into_owned(),
                expected: "seconds, more than 0 and at most 86400",
            })
        })?;
        Ok(Self {
            cache: cache_folder(),
            python: variable("NSV_PYTHON"),
            mode,
            timeout,
            ..Self::offline(exports)
        })
    }

    /// The user's stored exports.
    pub(crate) fn cached_exports(&self) -> Option<PathBuf> {
        Some(self.cache.as_ref()?.join("partials"))
    }

    /// Directory of the managed environment: another one for other requirements.
    fn managed(&self) -> Option<PathBuf> {
        let hash = Key::from_digest(&Sha256::digest(REQUIREMENTS)[..8]);
        Some(self.cache.as_ref()?.join("python").join(hash.to_string()))
    }

    /// The interpreter that is used at present: the user's, or the managed one if it is installed.
    pub fn installed_python(&self) -> Option<PathBuf> {
        let managed = || {
            self.managed()
                .map(|directory| interpreter(&directory))
                .filter(|python| python.is_file())
        };
        self.python.clone().or_else(managed)
    }

    /// The interpreter, installed now if need be; `progress` is told what takes time.
    pub fn provision(&self, progress: &mut dyn FnMut(&str)) -> Result<PathBuf, Error> {
        if let Some(python) = self.installed_python() {
            return Ok(python);
        }
        let directory = self.managed().ok_or(Error::CacheMissing)?;
        let parent = directory
            .parent()
            .expect("invariant: a joined path has a parent");
        fs::create_dir_all(parent).map_err(|error| storage(parent, error))?;
        let lock = parent.join("lock");
        let _held = hold(&lock, progress).map_err(|error| storage(&lock, error))?;
        // Another process may have installed it while this one waited.
        match self.installed_python() {
            Some(python) => Ok(python),
            None => self.install(parent, &directory, progress),
        }
    }

    /// Makes the environment under another name and moves it into place when it is complete.
    fn install(
        &self,
        parent: &Path,
        directory: &Path,
        progress: &mut dyn FnMut(&str),
    ) -> Result<PathBuf, Error> {
        let draft = Scratch::new_in(parent).map_err(|error| storage(parent, error))?;
        progress(&format!(
            "creating a Python environment in {}",
            directory.display()
        ));
        let program = &self.base_python;
        let mut create = Command::new(program);
        create.args(["-I", "-m", "venv"]).arg(draft.path());
        let created = installed(&mut create).map_err(|failure| match failure {
            Failure::Start(error) => Error::PythonMissing {
                program: program.clone(),
                error,
            },
            failure => Error::VenvFailed {
                program: program.clone(),
                detail: why(&failure),
            },
        })?;
        if !created.status.success() {
            return Err(Error::VenvFailed {
                program: program.clone(),
                detail: report(&created),
            });
        }
        progress("installing casadi and numpy from PyPI (about 110 MB, once)");
        let requirements = draft.path().join("requirements.txt");
        fs::write(&requirements, REQUIREMENTS).map_err(|error| storage(&requirements, error))?;
        let mut install = Command::new(interpreter(draft.path()));
        install
            .args([
                "-m",
                "pip",
                "install",
                "--quiet",
                "--no-input",
                "--disable-pip-version-check",
            ])
            .args([
                "--require-hashes",
                "--only-binary",
                ":all:",
                "--requirement",
            ])
            .arg(&requirements);
        let installed = installed(&mut install).map_err(|failure| match failure {
            Failure::Start(error) => Error::VenvFailed {
                program: program.clone(),
                detail: format!("its python: {error}"),
            },
            failure => Error::InstallFailed {
                detail: why(&failure),
            },
        })?;
        if !installed.status.success() {
            return Err(Error::InstallFailed {
                detail: report(&installed),
            });
        }
        replace(&draft, directory).map_err(|error| storage(directory, error))?;
        Ok(interpreter(directory))
    }
}

/// The user's cache: `$NSV_CACHE_DIR`, else `$XDG_CACHE_HOME/nsv`, else `~/.cache/nsv`.
pub fn cache_folder() -> Option<PathBuf> {
    variable("NSV_CACHE_DIR")
        .or_else(|| variable("XDG_CACHE_HOME").map(|cache| cache.join("nsv")))
        .or_else(|| variable("HOME").map(|home| home.join(".cache/nsv")))
}

/// A path that a variable names.
fn variable(name: &str) -> Option<PathBuf> {
    env::var_os(name)
        .filter(|value| !value.is_empty())
        .map(PathBuf::from)
}

/// A time to wait, s.
fn seconds(text: &OsStr) -> Option<Duration> {
    let seconds = text.to_str()?.parse().ok()?;
    let time = Duration::try_from_secs_f64(seconds).ok()?;
    (!time.is_zero() && time <= LONGEST).then_some(time)
}

/// Moves a complete draft to `directory`. One that is there already has no interpreter: its base Python has been removed.
fn replace(draft: &Scratch, directory: &Path) -> io::Result<()> {
    match fs::remove_dir_all(directory) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        _ => {}
    }
    fs::rename(draft.path(), directory)
}

/// Locks a file until the result is dropped, so that one process at a time installs.
fn hold(path: &Path, progress: &mut dyn FnMut(&str)) -> io::Result<File> {
    let file = File::options()
        .create(true)
        .truncate(false)
        .write(true)
        .open(path)?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            progress("waiting for another nsv to install casadi");
            file.lock()?;
        }
        Err(TryLockError::Error(error)) => return Err(error),
    }
    Ok(file)
}

fn interpreter(environment: &Path) -> PathBuf {
    if cfg!(windows) {
        environment.join("Scripts/python.exe")
    } else {
        environment.join("bin/python")
    }
}

/// What a failed command said; `venv` writes its reason to standard output.
fn report(output: &Output) -> String {
    if output.stderr.is_empty() {
        tail(&String::from_utf8_lossy(&output.stdout))
    } else {
        tail(&output.stderr)
    }
}

/// Runs a step of the installation, without input.
fn installed(command: &mut Command) -> Result<Output, Failure> {
    process::run(command, INSTALLATION_OUTPUT, INSTALLATION)
}

fn why(failure: &Failure) -> String {
    match failure {
        Failure::Start(error) | Failure::Io(error) => error.to_string(),
        Failure::Timeout => format!("it did not end within {} s", INSTALLATION.as_secs()),
        Failure::TooLarge => "it wrote too much".to_owned(),
    }
}

fn storage(path: &Path, error: io::Error) -> Error {
    Error::Storage {
        path: path.to_owned(),
        error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_to_wait_is_positive_and_at_most_a_day() {
        let accepted = |text: &str| seconds(OsStr::new(text)).map(|time| time.as_secs_f64());
        assert_eq!(accepted("0.5"), Some(0.5));
        assert_eq!(accepted("86400"), Some(86400.0));
        for wrong in [
            "", "0", "1e-10", "-1", "86401", "1e19", "inf", "nan", "2min",
        ] {
            assert_eq!(accepted(wrong), None, "{wrong}");
        }
    }
}
