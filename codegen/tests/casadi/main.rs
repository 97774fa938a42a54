//! Partial derivatives: stored exports are decoded, compared with differences of the formula, and every way to fail has its error.
//!
//! No test needs Python. The exports in `partials` are what CasADi answered; with NSV_PYTHON set to an interpreter that has it, the
//! tests ask again and compare byte by byte, and with NSV_UPDATE_EXPORTS set as well they store the answers.

#![expect(
    clippy::unwrap_used,
    reason = "a test fails by panicking, in its helpers as well"
)]

mod decoding;
mod derivatives;
mod exports;
mod failures;
mod requests;

use std::env;
use std::fs;
use std::path::PathBuf;

use nsv_codegen::casadi::store::Store;
use nsv_codegen::casadi::{Environment, Job, Mode, Provider};
use nsv_codegen::ir::Program;

/// A file of this folder.
fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/casadi")
        .join(name)
}

fn rates(order: usize, varying: &[&str]) -> Job {
    Job::Rates {
        order,
        varying: varying.iter().map(ToString::to_string).collect(),
    }
}

fn jacobian(wrt: &[&str]) -> Job {
    Job::Jacobian {
        wrt: wrt.iter().map(ToString::to_string).collect(),
    }
}

fn hessian(wrt: &[&str]) -> Job {
    Job::Hessian {
        wrt: wrt.iter().map(ToString::to_string).collect(),
    }
}

/// A formula in the textual form of the IR.
fn formula(text: &str) -> Program {
    let program: Program = text.parse().unwrap();
    program.assert_sound();
    program
}

/// The derivatives by the committed export.
fn partials(formula: &Program, job: &Job) -> Program {
    if let Some(python) = env::var_os("NSV_PYTHON") {
        ask_again(python.into(), formula, job);
    }
    let mut provider = Provider::new(Environment::offline(path("partials")), |_| {});
    let program = provider
        .partials(formula, job)
        .unwrap_or_else(|error| panic!("{error}"));
    program.assert_sound();
    program
}

fn ask_again(python: PathBuf, formula: &Program, job: &Job) {
    let scratch = tempfile::tempdir().unwrap();
    let environment = Environment {
        python: Some(python),
        mode: Mode::Provision,
        ..Environment::offline(scratch.path())
    };
    let mut provider = Provider::new(environment, |_| {});
    provider
        .partials(formula, job)
        .unwrap_or_else(|error| panic!("{error}"));
    for export in provider.exports() {
        let store = Store::new(path("partials"));
        if env::var_os("NSV_UPDATE_EXPORTS").is_some() {
            store.save(export).unwrap();
        }
        let stored = fs::read_to_string(store.path(&export.key())).unwrap();
        assert_eq!(export.file_text(), stored, "CasADi answers as it did");
    }
}
