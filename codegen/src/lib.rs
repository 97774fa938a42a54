//! The nsv compiler.
pub mod casadi;
pub mod derive;
pub mod driver;
pub mod emit;
pub mod interrupt;
pub mod ir;
pub mod limits;
pub mod lower;
pub mod opt;
pub mod seal;
pub mod whole;
