//! Elementary functions lane by lane.

use crate::real::Real;

pub(crate) fn exp<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::exp(x.lane(i)))
}

pub(crate) fn ln<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::log(x.lane(i)))
}

pub(crate) fn sin<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::sin(x.lane(i)))
}

pub(crate) fn cos<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::cos(x.lane(i)))
}

pub(crate) fn tan<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::tan(x.lane(i)))
}

pub(crate) fn asin<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::asin(x.lane(i)))
}

pub(crate) fn acos<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::acos(x.lane(i)))
}

pub(crate) fn atan<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::atan(x.lane(i)))
}

pub(crate) fn sinh<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::sinh(x.lane(i)))
}

pub(crate) fn cosh<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::cosh(x.lane(i)))
}

pub(crate) fn tanh<T: Real>(x: T) -> T {
    T::from_lanes(|i| libm::tanh(x.lane(i)))
}

pub(crate) fn atan2<T: Real>(x: T, y: T) -> T {
    T::from_lanes(|i| libm::atan2(x.lane(i), y.lane(i)))
}

pub(crate) fn pow<T: Real>(x: T, y: T) -> T {
    T::from_lanes(|i| libm::pow(x.lane(i), y.lane(i)))
}
