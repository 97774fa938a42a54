// SHA-256 of the text below: e6c9cfbc605ab50c06c838710f76cb954bd79071e1adb48a9b86fc955bd2138d
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Missile pitch autopilot with lookup tables at a falling Mach number

pub mod controller;
pub mod lyapunov;
pub mod params;
pub mod plant;
pub mod polynomials;
pub mod simulator;
pub mod tables;

pub use controller::{Controller, Output, State};
pub use params::Params;
pub use simulator::Simulator;

/// SHA-256 of the specification.
pub const SPEC_HASH: &str = "05be5535c7cae8b2a3cd9cf8d24ef194e692cec7b4e1301264df6a109708a2c9";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
