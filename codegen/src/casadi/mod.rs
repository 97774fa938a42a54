//! Partial derivatives, taken symbolically by CasADi.
//!
//! A formula (an [`ir::Program`](crate::ir::Program)) and a [`Job`] become a [`document::Request`]; a Python process with CasADi answers with
//! a [`document::Tape`], which is decoded into a program. Answers are stored under the hash of their request, so that a build needs
//! Python only for a question that nobody asked before:
//!
//! ```text
//! formula, job -> request -> key -> committed exports -> the user's cache -> export.py -> tape -> decode -> program
//! ```
//!
//! Coefficients of polynomial data never leave the compiler, and neither do names of intermediate values: a request changes only
//! when the mathematics changes.

mod arithmetic;
mod data;
mod decode;
pub mod document;
pub mod environment;
mod error;
mod exporter;
mod hexfloat;
mod job;
mod layout;
pub(crate) mod limits;
mod polynomial;
mod process;
mod provider;
mod request;
pub mod store;

pub use decode::decode;
pub use environment::{Environment, Mode, cache_folder};
pub use error::{Error, TapeError};
pub use exporter::{Versions, versions};
pub use job::Job;
pub use provider::Provider;
pub use request::Question;
