// SHA-256 of the text below: bd05840728127989e4440814ca1e9a062f50f340e572a7dd0e0a288a197869d7
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Underwater vehicle in waves and a current

pub mod controller;
pub mod lyapunov;
pub mod params;
pub mod plant;
pub mod polynomials;
pub mod simulator;

pub use controller::{Controller, Output, State};
pub use params::Params;
pub use simulator::Simulator;

/// SHA-256 of the specification.
pub const SPEC_HASH: &str = "a5d8a52b8dc0ce0bf099655425bb9ff59ac9de749fb4c06032e0ffe82095a2e4";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
