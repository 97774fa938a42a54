// SHA-256 of the text below: 51030f7a90df6cd6bfbc1331add3c1258269722daf13cb3a8ee1f7b9e34f1bdc
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c

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
pub const SPEC_HASH: &str = "d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
