// SHA-256 of the text below: d528e090a4a4eea04dafd87adc2485bb61697bcab2e7fe8ca993e88266800aa9
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d9c4134bcbe0b312f0aa158f031e4efb6f9e95bfa5b8cb48d579689484a3195c

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
