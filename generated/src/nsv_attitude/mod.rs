// SHA-256 of the text below: 590b86c2137edafef4162be5a575d9a5818e42c4d0d097edb198d5188b5d0776
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d616899bc333dd62e7916c99ac2aacc0cc0a8839653532fb0d461fa45f484071

//! Attitude control of a near space vehicle with multi-source disturbances

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
pub const SPEC_HASH: &str = "d616899bc333dd62e7916c99ac2aacc0cc0a8839653532fb0d461fa45f484071";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
