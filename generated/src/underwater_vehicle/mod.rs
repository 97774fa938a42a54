// SHA-256 of the text below: f35029202235050770b28fe036fe5d313b66b9803bca77e2fabf126e060f1607
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

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
pub const SPEC_HASH: &str = "d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
