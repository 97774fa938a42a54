//! Elementary functions in double precision.

mod exponential;
mod hyperbolic;
mod large_angle;
mod logarithm;
mod trigonometric;

pub(crate) use exponential::exp;
pub(crate) use hyperbolic::{cosh, sinh, tanh};
pub(crate) use logarithm::ln;
pub(crate) use trigonometric::{cos, sin, tan};

use crate::real::Real;

pub(crate) fn asin<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::asin(x.lane(i)))
}

pub(crate) fn acos<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::acos(x.lane(i)))
}

pub(crate) fn atan<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::atan(x.lane(i)))
}

pub(crate) fn atan2<T: Real>(x: T, y: T) -> T {
    T::from_lanes(|i| libm::atan2(x.lane(i), y.lane(i)))
}

pub(crate) fn pow<T: Real>(x: T, y: T) -> T {
    T::from_lanes(|i| libm::pow(x.lane(i), y.lane(i)))
}
