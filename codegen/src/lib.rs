//! The nsv compiler.
pub mod casadi;
pub mod ir;
