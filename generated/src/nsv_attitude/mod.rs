// SHA-256 of the text below: db29e306e043282f21e0b587faf8d9b00f9a963c1b77ae3ccf1c0697047a3ebf
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Attitude control of a near space vehicle with multi-source disturbances

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
pub const SPEC_HASH: &str = "5a5627d7f5dffbfaa3bac926c02b717cc03494fc320eda475a0e871229403151";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
