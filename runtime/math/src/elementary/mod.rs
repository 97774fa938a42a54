//! Elementary functions, one module for each precision.
//!
//! A function is one sequence of additions, products, at most one quotient or root, comparisons and choices, which is the same for every
//! argument; nothing is fused or reassociated, so it gives the same bits in a scalar and in every lane. Only angles beyond 10^5 rad
//! leave it: [`rare`] replaces their lanes one by one.

pub(crate) mod double;
mod polynomial;
mod rare;
pub(crate) mod single;
