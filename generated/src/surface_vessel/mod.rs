// SHA-256 of the text below: c370f8e19a25f6b753a574a2cad5228da541c9752464d13186a75b63d95265cb
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Surface vessel in waves and a current

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
pub const SPEC_HASH: &str = "070c6a87874f0fd0a576f8108da86a1435992ca46f999b1dc349b93292bfdfa9";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
