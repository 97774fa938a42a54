// SHA-256 of the text below: 4f75131d7f0020566482dca6acf9b0206fe7e0871307626b5ec130a1de070965
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 427d2bea2c6b43ae65f749fa7cfe60bd4e96b4b1966ea0acf1940e759453d1f2

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
