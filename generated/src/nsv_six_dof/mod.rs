// SHA-256 of the text below: d6bda7b3a1919779f32daa6f574d923c7a75baaaded345c2d26fc4d7295a6e2b
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! The attitude controller on a near space vehicle that climbs and accelerates

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
pub const SPEC_HASH: &str = "d9c4134bcbe0b312f0aa158f031e4efb6f9e95bfa5b8cb48d579689484a3195c";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
