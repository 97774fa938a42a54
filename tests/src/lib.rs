//! What the cross-crate tests in `tests/` share: specifications with their programs, the committed code by names, points of the
//! reference implementation, and a closed loop that interprets programs.
//!
//! The README's Rust is compiled and run as a doc test of this crate.
#![doc = include_str!("../../README.md")]

pub mod compiled;
pub mod flights;
pub mod interpreted;
pub mod points;
pub mod specification;
