// SHA-256 of the text below: 71342815b3c71eb42703b2d666782e6e16890aeeacbf69388eb510478ffc788f
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 942eb100714b26c25e1ccdc4afbe0d4d2b86a428722273c0878e49722b6d7ac4

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
