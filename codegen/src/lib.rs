//! The nsv compiler.
pub mod ir;
