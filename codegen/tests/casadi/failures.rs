//! Interpreters that are missing, wrong, slow or broken, played by shell scripts in `fake_python`.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use nsv_codegen::casadi::{Environment, Error, Mode, Provider};
use nsv_codegen::ir::Program;

use super::{formula, path, rates};

fn square() -> Program {
    formula(
        "program square\n input x: real\n %0: real = input x\n %1: real = mul %0, %0\n output q = %1",
    )
}

/// The error of a fake interpreter.
fn failure(python: &str) -> Error {
    failure_within(python, Duration::from_secs(60))
}

fn failure_within(python: &str, timeout: Duration) -> Error {
    let empty = tempfile::tempdir().unwrap();
    let environment = Environment {
        python: Some(path("fake_python").join(python)),
        mode: Mode::Provision,
        timeout,
        ..Environment::offline(empty.path())
    };
    ask(environment)
}

fn ask(environment: Environment) -> Error {
    Provider::new(environment, |_| {})
        .partials(&square(), &rates(1, &["x"]))
        .unwrap_err()
}

/// The message, with the place of this checkout left out.
fn message(error: &Error) -> String {
    error
        .to_string()
        .replace(&path("").display().to_string(), "")
}

#[test]
fn each_broken_interpreter_has_its_message() {
    let names = [
        "no_such_file",
        "no_casadi",
        "old_casadi",
        "crash",
        "signal",
        "garbage",
        "other_schema",
        "no_tape",
        "wrong_tape",
        "refuse",
    ];
    let messages: Vec<String> = names
        .iter()
        .map(|name| format!("{name}: {}", message(&failure(name))))
        .collect();
    insta::assert_snapshot!(messages.join("\n"));
}

#[test]
fn a_hanging_interpreter_is_killed_with_its_children() {
    let start = Instant::now();
    let error = failure_within("hang", Duration::from_millis(300));
    assert!(matches!(error, Error::Timeout { .. }), "{error:?}");
    assert!(
        start.elapsed() < Duration::from_secs(20),
        "the pipe that the child's child holds is not waited for"
    );
}

#[test]
fn a_closed_output_is_not_the_end() {
    let error = failure_within("closed", Duration::from_millis(300));
    assert!(matches!(error, Error::Timeout { .. }), "{error:?}");
}

#[test]
fn endless_output_is_cut() {
    let error = failure("flood");
    assert!(matches!(error, Error::OutputTooLarge { .. }), "{error:?}");
}

/// A cache directory and a base interpreter that plays `python3`.
fn provision(base: &str, cache: &Path) -> Error {
    let environment = Environment {
        cache: Some(cache.to_owned()),
        base_python: path("fake_python").join(base),
        mode: Mode::Provision,
        ..Environment::offline(cache.join("none"))
    };
    ask(environment)
}

#[test]
fn each_failed_installation_has_its_message() {
    let cache = tempfile::tempdir().unwrap();
    let names = ["no_such_file", "no_venv", "no_pip", "offline"];
    let messages: Vec<String> = names
        .iter()
        .map(|name| format!("{name}: {}", message(&provision(name, cache.path()))))
        .collect();
    insta::assert_snapshot!(messages.join("\n"));
    let left: Vec<_> = fs::read_dir(cache.path().join("python"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    assert_eq!(left, ["lock"], "a failed installation leaves nothing");
}

#[test]
fn an_installation_is_used_and_kept() {
    let cache = tempfile::tempdir().unwrap();
    // The installed interpreter has no casadi, but it is found and asked.
    let error = provision("installs", cache.path());
    assert!(
        matches!(&error, Error::CasadiMissing { python, .. } if python.starts_with(cache.path())),
        "{error:?}"
    );
    // Nothing is installed again: the base interpreter is gone.
    let error = provision("no_such_file", cache.path());
    assert!(matches!(error, Error::CasadiMissing { .. }), "{error:?}");
}

#[test]
fn an_environment_needs_a_place() {
    let empty = tempfile::tempdir().unwrap();
    let error = ask(Environment {
        mode: Mode::Provision,
        ..Environment::offline(empty.path())
    });
    assert!(matches!(error, Error::CacheMissing), "{error:?}");
}
