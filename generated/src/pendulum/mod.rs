// SHA-256 of the text below: 471d3b9e73aa258ad67e91356306b45965aa68c0a84330698cf2291e3d869001
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! Single-link arm in a gusty wind

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
pub const SPEC_HASH: &str = "1a4dc31c8b8f80dd213e6bd36beee0e688e8525cc62b205874fb23a2869e509d";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
