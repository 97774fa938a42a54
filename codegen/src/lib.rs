//! The nsv compiler.
pub mod emit;
pub mod ir;
