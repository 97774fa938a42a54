// SHA-256 of the text below: f716a336afeb306e9358110ce471f6ae1f5cf7dd2372f2b98104e256d2445ef0
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
pub const SPEC_HASH: &str = "b92d27143df893b63a79e1e211084368f134a8214ac3a27e51acad72b8d92c4e";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
