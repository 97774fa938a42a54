//! Elementary functions, one module for each precision.

pub(crate) mod double;
pub(crate) mod single;
