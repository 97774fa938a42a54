// SHA-256 of the text below: 8c8fb0ec9059cc6037dc55ef7c62cae0669aa5fa0b5392b09c440845415cbd30
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Active suspension on a rough road

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
pub const SPEC_HASH: &str = "f70c25e1cbb23d7ad870996c7841812cb5fb39433bd2cc647b3a6463e631db02";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
