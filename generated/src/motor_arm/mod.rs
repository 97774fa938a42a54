// SHA-256 of the text below: 7f70081fd5bbbfdac124589f1ae7fda9d15460e4dc1ab6a4b4329afcb6a971ca
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
pub const SPEC_HASH: &str = "9b566d21e10b4a5e1287aa6d56b2ef282dc67247857e73edb28387ed4150de95";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
