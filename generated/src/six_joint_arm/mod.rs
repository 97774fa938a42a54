// SHA-256 of the text below: d699298c50df69607ea1de130860f64ea8813e00b81c2e90d3a92e7b08852b16
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Six-joint arm with an unknown load

pub mod controller;
pub mod lyapunov;
pub mod params;
pub mod plant;
pub mod simulator;

pub use controller::{Controller, Output, State};
pub use params::Params;
pub use simulator::Simulator;

/// SHA-256 of the specification.
pub const SPEC_HASH: &str = "723b6f2dd2fabbb7d760940b291b7ebad4b28ec0ea538934ff49cd2f90911cc4";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
