// SHA-256 of the text below: 73531fa172560862ed3ddecc15786ef071e013049b1e3da6515484164f8ab4cb
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 5b3fe84c46bdc7cb80e48e918824f187a9526dc5249f0e1431e753f4c1fbe57f

//! Robot link with an elastic joint

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
pub const SPEC_HASH: &str = "5b3fe84c46bdc7cb80e48e918824f187a9526dc5249f0e1431e753f4c1fbe57f";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
