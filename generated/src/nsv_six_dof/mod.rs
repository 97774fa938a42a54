// SHA-256 of the text below: d5f3b27370740fb9bfd829da5620ce4580ab517396fff8d6381b8f4eca7bcd6d
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 f1ed1a103e422183001e3307dcbafd51dd8416eb6bf6c3da335ba5b9a83cacd7

//! The attitude controller on a near space vehicle that climbs, turns and accelerates

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
pub const SPEC_HASH: &str = "f1ed1a103e422183001e3307dcbafd51dd8416eb6bf6c3da335ba5b9a83cacd7";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
