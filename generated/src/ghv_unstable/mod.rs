// SHA-256 of the text below: 190528293eb7db64139d398de5292ba501815275ad0f16710051fc545602487c
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 133ae3f0312b7831c9ddba2dc983f02998784ec4e084658743b26df4ccf9e0cc

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
pub const SPEC_HASH: &str = "133ae3f0312b7831c9ddba2dc983f02998784ec4e084658743b26df4ccf9e0cc";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
