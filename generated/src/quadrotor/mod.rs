// SHA-256 of the text below: 6d3cf30fa8c0d525fcc33f4b49d03d20ba9183011873afd1f5ebcaa85efdf054
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Quadrotor attitude in gusts

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
pub const SPEC_HASH: &str = "3cd74c6a44d9432abc24d8808c619aec204d90e97927d612360bef1bbe8706df";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
