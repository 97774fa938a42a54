// SHA-256 of the text below: 0a85a228572a531d298af7411941764ea58713a64b46cf46fe2c9a35317de9a0
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 3cd74c6a44d9432abc24d8808c619aec204d90e97927d612360bef1bbe8706df

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
