//! Signs of numbers.

use crate::real::{Bits, Real};

/// A number that is not negative, with the sign of `x`.
#[inline(always)]
pub(super) fn with_sign<T: Real>(magnitude: T, x: T) -> T {
    let sign = x.to_bits().and(T::from_f64(-0.0).to_bits());
    T::from_bits(magnitude.to_bits().or(sign))
}

/// Whether the sign is minus, also that of a zero.
#[inline(always)]
pub(super) fn is_minus<T: Real>(x: T) -> T::Mask {
    with_sign(T::one(), x).lt(T::zero())
}
