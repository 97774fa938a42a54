//! The nsv specification language.
//!
//! [`load`] reads a YAML specification with its included model files, checks names, units, shapes and ranges, and returns the
//! [`model::Model`]: everything in SI, every expression typed, nothing left to go wrong for the phases behind it.
//!
//! ```text
//! files -- compose --> yaml::Node -- parse --> spec::Spec -- check --> model::Model
//! ```

mod check;
pub mod compose;
pub mod diagnostic;
pub mod expr;
mod hash;
mod include;
pub mod interpolation;
pub mod limits;
pub mod linear;
pub mod model;
mod parse;
pub mod reference;
pub mod schema;
pub mod spec;
mod suggest;
pub mod unit;
mod vocabulary;
pub mod yaml;

use std::path::Path;

pub use check::{RUST_WORDS, is_of_the_law};
use compose::Composition;
use diagnostic::{Diagnostic, Diagnostics};
use model::Model;
pub use schema::json_schema;

/// Reads, checks and joins a specification and all that it includes. Gives the model with its warnings, or every fault. The
/// files named in `include` lie below the specification's directory; nothing else is read.
pub fn load(path: &Path) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
    Composition::read(path, &[])?.base()
}

/// The same for a text that is not in a file and includes none; `name` is what messages call it.
pub fn load_str(name: &str, text: &str) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
    load_bytes(name, text.as_bytes())
}

/// The same for bytes that may not even be text.
pub fn load_bytes(name: &str, bytes: &[u8]) -> Result<(Model, Vec<Diagnostic>), Diagnostics> {
    Composition::read_bytes(name, bytes)?.base()
}
