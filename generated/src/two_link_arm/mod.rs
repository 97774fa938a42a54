// SHA-256 of the text below: 5c9c058842e9f2ab903f6d4a27650180c2c264ec84403ecfecad49013dac8bca
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Two-link arm with an unknown load

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
pub const SPEC_HASH: &str = "5b42d1879341422d03eace48ae955f998fb87fd8da8bd740a34c7c485db4fa5a";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
