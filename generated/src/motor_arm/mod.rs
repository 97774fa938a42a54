// SHA-256 of the text below: 7721f27135295886f2f311e10a7b944e5b632a104006c97b76dd56c60a86d7d5
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

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
pub const SPEC_HASH: &str = "eaec085705702921007be8e6ce482fe8ff0bdc8ba32b44e358ef4f3b85103df7";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
