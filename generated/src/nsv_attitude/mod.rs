// SHA-256 of the text below: 73984757eac26cae2f2bae034dcd7ae14b748c5ceb313e6ecb210a27bb78ba20
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

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
pub const SPEC_HASH: &str = "942eb100714b26c25e1ccdc4afbe0d4d2b86a428722273c0878e49722b6d7ac4";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
