// SHA-256 of the text below: ebb0a46af3cfb293610cff2e101009c6894a5ef6a072f907f64a3e13bb0e1bc7
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 815a362bdb92a6e94d76c944d9bf05798035f9eac628f3e686a37ce952ce66e8

//! The attitude controller on a near space vehicle that climbs, turns and accelerates

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
pub const SPEC_HASH: &str = "815a362bdb92a6e94d76c944d9bf05798035f9eac628f3e686a37ce952ce66e8";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
