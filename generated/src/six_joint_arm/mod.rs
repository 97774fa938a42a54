// SHA-256 of the text below: 45127e0b44f9bfc537e45dc67a095e70623de2a4a8f4870ceacb71957253e6e3
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
pub const SPEC_HASH: &str = "e7e26501eabebcc551c5a20f6cf6291dc3f98ec9ff94704b5eb6dcf9470130fd";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
