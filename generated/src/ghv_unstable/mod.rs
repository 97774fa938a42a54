// SHA-256 of the text below: 2a8c06a4815415da7b882304b657db9ae697a4e48d4e254e295da52b4add4306
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 b23eab313adca11ff6697092fe02a65357bd8a58e2c4bc06f2d6929851209653

//! Statically unstable hypersonic vehicle

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
pub const SPEC_HASH: &str = "b23eab313adca11ff6697092fe02a65357bd8a58e2c4bc06f2d6929851209653";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
