// SHA-256 of the text below: 5ca1beec3b5c3369c93f216b84d70832085e1128fa656bb446b2f488e41cb914
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
pub const SPEC_HASH: &str = "83ac46a1097a4fead644d1139c0ade2d73976a55b7d4dd44f2944e9cc16dc73f";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
