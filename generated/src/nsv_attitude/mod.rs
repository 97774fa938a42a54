// SHA-256 of the text below: a487226cda19caf40d0a57503dacacf101d105202caba161db0fca1f8e7439f3
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 05232bb1e4d2b87c7bb300548a857e3c96008a6f6467540428e4dc35d68eaef0

//! Attitude control of a near space vehicle with multi-source disturbances

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
pub const SPEC_HASH: &str = "05232bb1e4d2b87c7bb300548a857e3c96008a6f6467540428e4dc35d68eaef0";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
