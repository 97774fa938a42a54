//! `nsv doctor`: what is installed, what is missing, how to mend it.

use std::path::Path;

use nsv_codegen::casadi::{Environment, Mode, versions};
use nsv_codegen::interrupt::Scratch;

use super::child;
use super::failure::{Exit, Failure};
use super::output;
use super::runner::{Cache, Toolchain};

/// Say what is installed, what is missing, and how to mend it
#[derive(clap::Args)]
pub(crate) struct Args {}

/// One thing that was looked at.
struct Finding {
    state: State,
    what: &'static str,
    found: String,
    remedy: Option<String>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Good,
    /// Needed for specifications whose derivatives are not stored.
    Optional,
    /// Needed by every simulation.
    Missing,
}

/// Runs the verb.
pub(crate) fn run(_args: &Args) -> Result<(), Failure> {
    let mut findings = Vec::new();
    match Cache::open() {
        Ok(cache) => {
            findings.push(good(
                "cache",
                format!(
                    "{}, {} built simulators",
                    cache.root().display(),
                    cache.built()
                ),
            ));
            findings.extend(toolchain(&cache));
        }
        Err(failure) => findings.push(failed("cache", failure)),
    }
    findings.push(python());
    output::data(&findings.iter().map(line).collect::<String>())?;
    match findings
        .iter()
        .any(|finding| finding.state == State::Missing)
    {
        true => Err(Failure::Reported(Exit::Environment)),
        false => Ok(()),
    }
}

fn line(finding: &Finding) -> String {
    let mark = match finding.state {
        State::Good => "ok     ",
        State::Optional => "note   ",
        State::Missing => "MISSING",
    };
    let remedy = finding
        .remedy
        .as_ref()
        .map(|remedy| format!("{:21}{remedy}\n", ""))
        .unwrap_or_default();
    format!("{mark}  {:10}  {}\n{remedy}", finding.what, finding.found)
}

fn good(what: &'static str, found: impl Into<String>) -> Finding {
    Finding {
        state: State::Good,
        what,
        found: found.into(),
        remedy: None,
    }
}

fn failed(what: &'static str, failure: Failure) -> Finding {
    let (found, remedy) = match failure {
        Failure::Message { message, help, .. } => (message, help),
        other => (format!("{other:?}"), None),
    };
    Finding {
        state: State::Missing,
        what,
        found,
        remedy,
    }
}

/// rustc with a linker, cargo, and the one package that runners need.
fn toolchain(cache: &Cache) -> Vec<Finding> {
    let toolchain = match Toolchain::find(&cache.simulators()) {
        Ok(toolchain) => toolchain,
        Err(failure) => return vec![failed("rustc", failure)],
    };
    let scratch = match Scratch::new_in(&cache.simulators()) {
        Ok(scratch) => scratch,
        Err(error) => {
            return vec![failed(
                "cache",
                Failure::io("write in", &cache.simulators(), &error),
            )];
        }
    };
    vec![
        linker(&toolchain, scratch.path()),
        cargo(&toolchain, scratch.path()),
    ]
}

/// Links an empty program: rustc alone does not make one.
fn linker(toolchain: &Toolchain, folder: &Path) -> Finding {
    let source = folder.join("empty.rs");
    let linked = std::fs::write(&source, "fn main() {}\n")
        .ok()
        .and_then(|()| {
            let mut command = toolchain.rustc(folder);
            child::run(
                command.arg(&source).arg("-o").arg(folder.join("empty")),
                |_| {},
            )
            .ok()
        });
    match linked {
        Some(finished) if finished.status.success() => good("rustc", toolchain.name()),
        finished => Finding {
            state: State::Missing,
            what: "rustc",
            found: format!("{} cannot link a program", toolchain.name()),
            remedy: Some(match finished {
                Some(finished) if !finished.stderr.contains("linker `cc` not found") => {
                    finished.stderr.trim().replace('\n', " ")
                }
                _ => "install a C linker, such as the package gcc or build-essential".to_owned(),
            }),
        },
    }
}

fn cargo(toolchain: &Toolchain, folder: &Path) -> Finding {
    match child::answer(toolchain.cargo(folder).arg("--version")) {
        Some(version) => good("cargo", version.trim()),
        None => Finding {
            state: State::Missing,
            what: "cargo",
            found: format!("cannot run `{}`", toolchain.cargo_program()),
            remedy: Some(super::runner::INSTALL.to_owned()),
        },
    }
}

/// CasADi, which takes derivatives that are not stored yet.
fn python() -> Finding {
    let environment = match Environment::from_variables("specs/partials", Mode::Offline) {
        Ok(environment) => environment,
        Err(error) => return failed("casadi", Failure::new(Exit::Environment, error)),
    };
    let optional = |found: String, remedy: String| Finding {
        state: State::Optional,
        what: "casadi",
        found,
        remedy: Some(remedy),
    };
    let Some(python) = environment.installed_python() else {
        let base =
            child::answer(std::process::Command::new(&environment.base_python).arg("--version"));
        return match base {
            Some(version) => optional(
                "not installed; derivatives of specifications with committed partials need none".to_owned(),
                format!("nsv installs it with {} when a specification needs it, or set NSV_PYTHON", version.trim()),
            ),
            None => optional(
                format!("not installed, and `{}` cannot be run", environment.base_python.display()),
                "install Python 3.9 or newer with its venv module, or set NSV_PYTHON to an interpreter with casadi".to_owned(),
            ),
        };
    };
    match versions(&python, environment.timeout) {
        Ok(found) => good(
            "casadi",
            format!(
                "{} in {} (Python {})",
                found.casadi,
                python.display(),
                found.python
            ),
        ),
        Err(error) => optional(
            error.to_string(),
            "specifications with committed partials work without it".to_owned(),
        ),
    }
}
