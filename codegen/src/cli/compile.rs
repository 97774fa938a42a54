//! From a path to a model and its code, with every fault shown.

use std::path::{Path, PathBuf};

use nsv_codegen::casadi::{Environment, Mode, Provider};
use nsv_codegen::derive::error::DeriveError;
use nsv_codegen::driver::{self, Compiled};
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::Arithmetic;
use nsv_spec::compose::Composition;
use nsv_spec::diagnostic::{Diagnostic, Diagnostics};
use nsv_spec::model::Model;

use super::failure::{Exit, Failure};
use super::output::{colour, note};
use super::render::{human, more};
use super::settings::Settings;

/// Reads and checks a specification with values set in it; shows its faults.
pub(crate) fn load(path: &Path, settings: &Settings) -> Result<Model, Failure> {
    shown(compose(path, settings)?.base())
}

/// Reads a specification and puts it together; shows what goes wrong.
pub(crate) fn compose(path: &Path, settings: &Settings) -> Result<Composition, Failure> {
    Composition::read(path, &settings.values).map_err(|faults| refused(&faults))
}

/// A checked model, its faults shown.
pub(crate) fn shown(
    checked: Result<(Model, Vec<Diagnostic>), Diagnostics>,
) -> Result<Model, Failure> {
    match checked {
        Ok((model, warnings)) => {
            show(&Diagnostics {
                sources: model.sources.clone(),
                items: warnings,
            });
            Ok(model)
        }
        Err(faults) => Err(refused(&faults)),
    }
}

fn refused(faults: &Diagnostics) -> Failure {
    show(faults);
    if let Some(line) = more(&faults.items) {
        note(line);
    }
    Failure::Reported(Exit::Spec)
}

/// Writes the faults to standard error as pictures.
pub(crate) fn show(diagnostics: &Diagnostics) {
    if !diagnostics.items.is_empty() {
        note(human(diagnostics, colour()).trim_end_matches('\n'));
        note("");
    }
}

/// Where partial derivatives may come from and go to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Partials {
    /// Stored ones only; Python is not run.
    Stored,
    /// New ones are taken by CasADi and kept in the user's cache.
    Cached,
    /// New ones are also kept beside the specification, to be committed.
    Committed,
}

/// What optimisation may change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Math {
    /// Nothing: results keep every bit of the equations as they are evaluated
    #[default]
    Strict,
    /// Roundings: fewer operations, results differ by a few units in the last place
    Fast,
}

impl From<Math> for Arithmetic {
    fn from(math: Math) -> Arithmetic {
        match math {
            Math::Strict => Arithmetic::Strict,
            Math::Fast => Arithmetic::Fast,
        }
    }
}

/// The code of a model.
pub(crate) fn compile(
    spec: &Path,
    model: &Model,
    partials: Partials,
    math: Math,
) -> Result<Compiled, Failure> {
    provided(spec, partials, |provider| {
        driver::compile(model, provider, math.into())
    })
}

/// The programs of a model before optimisation.
pub(crate) fn lower(spec: &Path, model: &Model, partials: Partials) -> Result<Programs, Failure> {
    provided(spec, partials, |provider| driver::lower(model, provider))
}

/// Does what needs partial derivatives and keeps the new ones where they belong.
fn provided<T>(
    spec: &Path,
    partials: Partials,
    work: impl FnOnce(&mut Provider<'_>) -> Result<T, DeriveError>,
) -> Result<T, Failure> {
    let mode = match partials {
        Partials::Stored => Mode::Offline,
        Partials::Cached | Partials::Committed => Mode::Provision,
    };
    let mut said = String::new();
    let progress = |text: &str| {
        // One formula may need several derivatives.
        if said != text {
            note(text);
            text.clone_into(&mut said);
        }
    };
    let environment = Environment::from_variables(exports(spec), mode)
        .map_err(|error| Failure::new(Exit::Environment, error))?;
    let mut provider = Provider::new(environment, progress);
    let done = work(&mut provider).map_err(|error| Failure::new(exit(&error), &error))?;
    if partials == Partials::Committed {
        provider
            .commit()
            .map_err(|error| Failure::new(Exit::Environment, error))?;
    }
    Ok(done)
}

/// The folder of stored derivatives: `partials` beside the specification.
fn exports(spec: &Path) -> PathBuf {
    spec.with_file_name("partials")
}

/// A law that cannot be derived is the specification's fault; derivatives that cannot be had are not.
fn exit(error: &DeriveError) -> Exit {
    match error {
        DeriveError::NetworkOrder => Exit::Spec,
        DeriveError::Partials(_) => Exit::Environment,
    }
}
