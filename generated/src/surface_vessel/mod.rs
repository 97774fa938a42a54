// SHA-256 of the text below: 5172d2798fbce9a518101d59b46bd0312058b7898ae6cd0ea3ddb35e7ce00f17
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Surface vessel in waves and a current

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
pub const SPEC_HASH: &str = "7709ac9dadc6e0d55c9f2766fd114c93b77a2eb45a027fca7fc9fa1a44d38c56";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
