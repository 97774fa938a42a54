//! The nsv compiler.
pub mod driver;
pub mod ir;
pub mod opt;
pub mod seal;
