//! Elementary functions.
//!
//! A function is one sequence of additions, products, at most one quotient and one root, comparisons and choices, which is the same for
//! every argument; nothing is reassociated, so it gives the same bits in a scalar and in every lane. Products are fused with the sums they
//! are added to in the precision [`Fused`], of which the functions that end in `_fused` are, and nowhere else. Where the sides of a choice are
//! long (sin, cos, asin, acos) a scalar computes only the one that it takes. Only what a controller hardly meets leaves the sequence (angles beyond 1600 rad in single, 10^5 rad in double precision, logarithms of subnormal numbers, powers of negative
//! ones): [`crate::rare`] replaces such lanes one by one. The text is written once for both precisions, whose constants are [`double`] and
//! [`single`].

mod double;
mod exponential;
mod format;
mod hyperbolic;
mod inverse;
mod large_angle;
mod logarithm;
mod normal;
mod polynomial;
mod power;
mod sign;
mod single;
mod trigonometric;

pub(crate) use double::Double;
pub(crate) use exponential::exp;
pub(crate) use format::Fused;
pub(crate) use hyperbolic::{cosh, sinh, tanh};
pub(crate) use inverse::{acos, asin, atan, atan2};
pub(crate) use logarithm::ln;
pub(crate) use normal::{rayleigh, sin_cos_pi};
pub(crate) use power::pow;
pub(crate) use single::Single;
pub(crate) use trigonometric::{
    cos, is_large_angle, sin, sin_cos, tan, usual_cos, usual_sin, usual_tan,
};
