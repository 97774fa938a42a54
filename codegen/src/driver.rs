//! Every phase between a checked model and the text of its code.

use std::collections::BTreeMap;

use nsv_spec::model::Model;

use crate::derive::error::DeriveError;
use crate::derive::{Partials, derive};
use crate::emit::{Artifact, module};
use crate::ir::Program;
use crate::lower::Programs;
use crate::opt::{Arithmetic, optimise_with};
use crate::seal::seal;

/// What a model compiles to.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Text of each file by its path inside the module's folder (`mod.rs`, `controller.rs`, ..), under its [seal](crate::seal).
    pub files: BTreeMap<String, String>,
    /// Every quantity of the law as a program, for `nsv eval`.
    pub eval: Program,
}

/// Derives and lowers: the programs before any optimisation.
pub fn lower(model: &Model, partials: &mut dyn Partials) -> Result<Programs, DeriveError> {
    let programs = Programs::new(&derive(model, partials)?);
    // The literals of a law are finite: the check admits no gain whose powers overflow, and numbers of formulas as they are written.
    for program in programs.all() {
        program.assert_sound();
    }
    Ok(programs)
}

/// Derives, lowers, optimises and emits: every phase behind the check.
pub fn compile(
    model: &Model,
    partials: &mut dyn Partials,
    arithmetic: Arithmetic,
) -> Result<Compiled, DeriveError> {
    let programs = lower(model, partials)?;
    let optimise = |program| optimise_with(program, arithmetic);
    let artifact = Artifact {
        model,
        version: env!("CARGO_PKG_VERSION"),
        arithmetic,
        initial: optimise(programs.initial),
        control: optimise(programs.control),
        plant: optimise(programs.plant),
        lyapunov: optimise(programs.lyapunov),
    };
    let files = module(&artifact)
        .into_iter()
        .map(|(file, text)| (file, seal(&text)))
        .collect();
    Ok(Compiled {
        files,
        eval: optimise(programs.quantities),
    })
}

/// The text of the library that declares the given modules, name and title of each, under its [seal](crate::seal).
pub fn library(modules: &BTreeMap<String, String>) -> String {
    let modules: Vec<(&str, &str)> = modules
        .iter()
        .map(|(name, title)| (name.as_str(), title.as_str()))
        .collect();
    seal(&crate::emit::library(&modules))
}
