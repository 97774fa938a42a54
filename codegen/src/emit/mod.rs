//! Emission: from programs to Rust text that reads beside the equations.
//!
//! A program becomes one function over `T: Real`. Values keep the names they have in the equations, each under a comment with its
//! equation; nothing of the specification reaches the text except as checked identifiers, literals and cleaned comments. The same
//! programs give the same bytes.

mod basis;
mod comment;
mod controller;
mod dispersion;
mod equation;
mod expression;
mod family;
mod function;
mod gains;
mod interface;
mod literal;
mod lyapunov;
mod methods;
mod module;
mod names;
mod pack;
mod params;
mod parts;
mod pieces;
mod plan;
mod plant;
mod polynomial;
mod quantity;
mod record;
mod replacement;
mod simulator;
mod source;
mod standalone;
mod state;
mod statements;
mod table;
mod types;

pub use module::{Artifact, library, module};
pub use standalone::standalone;

#[cfg(test)]
mod tests;
