// SHA-256 of the text below: dcebcd7aa8ea0f15810c234a12b1cc5ec9a2da26e8b06cd3cc1bb16453b71a28
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
pub const SPEC_HASH: &str = "73094b0e39fcc449ce3db655bc0602b8258254e1798e6e6631340a599b7c20a4";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
