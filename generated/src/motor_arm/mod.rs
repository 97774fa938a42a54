// SHA-256 of the text below: 9410d27fa5e515247b3e8ef6dff3f6844a505a94df91968ac4a0af61d306747d
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 9b566d21e10b4a5e1287aa6d56b2ef282dc67247857e73edb28387ed4150de95

//! Arm driven by a DC motor with current dynamics

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
pub const SPEC_HASH: &str = "9b566d21e10b4a5e1287aa6d56b2ef282dc67247857e73edb28387ed4150de95";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
