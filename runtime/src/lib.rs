//! Support library of nsv's generated code.
//!
//! The core is `no_std`, allocates nothing and does not panic: the numeric type [`real::Real`], small dense arrays ([`linear`]), the
//! barrier's smooth functions ([`kernel`]), counter-based noise ([`noise`]), values of time alone ([`ahead`]), one-step integrators
//! ([`sde`]), and the trait that a generated simulator implements ([`closed_loop`]). Generic code has no branch on data, only masks and
//! selects, so that one text serves scalars and vector lanes.
//!
//! The order of floating-point operations of every function is part of its contract: the compiler's own evaluator implements the same
//! definitions independently, and the two are compared bit for bit.
//!
//! The feature `std` adds campaigns of many runs on all cores (`ensemble`), their `statistics` and spread over time (`band`),
//! and the main function of a simulator binary (`runner`).

#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

pub use nsv_math::{entries, lanes, real};

pub mod actuator;
pub mod ahead;
pub mod closed_loop;
pub mod kernel;
pub mod linear;
pub mod noise;
pub mod polynomial;
mod quantum;
pub mod sde;
pub mod sensor;
pub mod status;
pub mod table;

#[cfg(feature = "std")]
pub mod band;
#[cfg(feature = "std")]
pub mod ensemble;
#[cfg(all(test, feature = "std"))]
mod mock;
#[cfg(feature = "std")]
pub mod runner;
#[cfg(feature = "std")]
mod simulation;
#[cfg(feature = "std")]
pub mod statistics;
