//! Every phase between a checked model and the text of its code.

use std::collections::BTreeMap;
use std::fmt;

use nsv_spec::model::Model;

use crate::derive::Partials;
use crate::derive::error::DeriveError;
use crate::ir::Program;

/// What a model compiles to.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Text of each file by its path inside the module's folder (`mod.rs`, `controller.rs`, ..), under its [seal](crate::seal).
    pub files: BTreeMap<String, String>,
    /// Every named quantity of the law as a program, for `nsv eval`.
    pub eval: Program,
}

/// Why a checked model has no code.
#[derive(Debug)]
pub enum CompileError {
    /// The law could not be derived.
    Derive(DeriveError),
    /// The phases are not linked into this build.
    NoPhases,
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CompileError::Derive(error) => error.fmt(f),
            CompileError::NoPhases => {
                f.write_str("the phases behind the check are not linked into this build of nsv")
            }
        }
    }
}

impl std::error::Error for CompileError {}

/// Derives, optimises and emits.
pub fn compile(_model: &Model, _partials: &mut dyn Partials) -> Result<Compiled, CompileError> {
    Err(CompileError::NoPhases)
}
