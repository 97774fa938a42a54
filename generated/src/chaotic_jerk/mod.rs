// SHA-256 of the text below: 51b6c9545d411b839cf1ec56c7cf5a117d9005ddadfb1cf619def4f54f0195fd
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Chaotic system of Genesio and Tesi following a sine

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
pub const SPEC_HASH: &str = "427d2bea2c6b43ae65f749fa7cfe60bd4e96b4b1966ea0acf1940e759453d1f2";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
