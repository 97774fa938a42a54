// SHA-256 of the text below: 22ce8d966789432646af237969bacf42a129ff3e7b2d22365a98516321db0de9
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Single-link arm in a gusty wind

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
pub const SPEC_HASH: &str = "fb2d020148181bf3fb2770fbb7275bde2b3e95348412c72b237f739a7f05fe40";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
