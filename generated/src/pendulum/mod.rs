// SHA-256 of the text below: bb6783ae59c262028b80c1a221e0a05e97839d0da7c749944f662a9a1005578f
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
pub const SPEC_HASH: &str = "ef009c4dc4c097e98df4c7b1dbc83f570137fcd24da6278418adb20f485f0b05";

/// Version of the generator.
pub const GENERATOR: &str = "0.1.0";
