//! The nsv compiler.
pub mod ir;
pub mod opt;
