// SHA-256 of the text below: 0f6646da0b0495da8757777dfa8f7aa5257fa93e49509d9bcfcd406e99493dbd
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 e7e26501eabebcc551c5a20f6cf6291dc3f98ec9ff94704b5eb6dcf9470130fd

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
