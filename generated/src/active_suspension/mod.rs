// SHA-256 of the text below: f56f8eb41bd6599c4e740cc0db6da78fd5f2a9081ebd6c7ec5e38c1033764ba2
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 f70c25e1cbb23d7ad870996c7841812cb5fb39433bd2cc647b3a6463e631db02

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
