//! Elementary functions, one module for each precision.
//!
//! A function is one sequence of additions, products, at most one quotient or root, comparisons and choices, which is the same for every
//! argument; nothing is fused or reassociated, so it gives the same bits in a scalar and in every lane. Only angles beyond 10^5 rad
//! and logarithms of subnormal numbers leave it: [`crate::rare`] replaces their lanes one by one.

pub(crate) mod double;
mod polynomial;
pub(crate) mod single;
