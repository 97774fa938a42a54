//! Elementary functions in double precision.

mod exponential;
mod hyperbolic;
mod inverse;
mod large_angle;
mod logarithm;
mod power;
mod trigonometric;

pub(crate) use exponential::exp;
pub(crate) use hyperbolic::{cosh, sinh, tanh};
pub(crate) use inverse::{acos, asin, atan, atan2};
pub(crate) use logarithm::ln;
pub(crate) use power::pow;
pub(crate) use trigonometric::{cos, sin, tan};
