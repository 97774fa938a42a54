// SHA-256 of the text below: d25b9922e24f122a289f787368fd9eb35b41cb45210b0133b4dfc3d507dcc217
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 077b62a34bf25cfd7f27896760362d630dc92177b20450c0f5c3a27433a8e2c2

//! Underwater vehicle in waves and a current

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
pub const SPEC_HASH: &str = "077b62a34bf25cfd7f27896760362d630dc92177b20450c0f5c3a27433a8e2c2";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
