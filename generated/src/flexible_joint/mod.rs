// SHA-256 of the text below: d3a6aaa8d0abf4ad33c272c15ff64810f1c2063c791a4f274ecb4c7ff250cc60
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

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
pub const SPEC_HASH: &str = "4291bb3902fdc079d1e752f7589df333a1602f816fcc1424487d9d6fe0aaca25";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
