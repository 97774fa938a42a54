// SHA-256 of the text below: 245a5c1e466e6a6ee8cd411fd8b298d2bf558a99efa0af07ab493c17c81f7715
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Statically unstable hypersonic vehicle

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
pub const SPEC_HASH: &str = "f1f3d1e7b46cdf6e7b3e3daf905ee420b532e800616179c1de4ef6683b97442f";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
