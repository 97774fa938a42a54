//! The nsv specification language.
//!
//! [`load`] reads a YAML specification with its included model files, checks names, units, shapes and ranges, and returns the
//! [`model::Model`]: everything in SI, every expression typed, nothing left to go wrong for the phases behind it.

pub mod diagnostic;
pub mod expr;
pub mod model;
mod suggest;
pub mod unit;
