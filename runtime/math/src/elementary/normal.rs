//! The two factors of Box and Muller's normal numbers, of arguments so restricted that none needs a case of its own.

use super::format::Format;
use super::logarithm::split;
use super::polynomial::polynomial;
use crate::real::Real;

/// `-2 ln x = s P(s^2) - 2 k ln 2` with `x = 2^k m`, `s = (m - 1)/(m + 1)`; neither term is negative enough to make the sum so.
#[inline(always)]
pub(crate) fn rayleigh<F: Format, T: Real>(x: T) -> T {
    let (k, m) = split::<F, T>(x);
    let s = (m - T::one()) / (m + T::one());
    let of_m = s * polynomial::<F, T>(s * s, F::RAYLEIGH);
    F::mul_add(k, T::from_f64(-2.0 * core::f64::consts::LN_2), of_m).sqrt()
}

#[inline(always)]
pub(crate) fn sin_cos_pi<F: Format, T: Real>(x: T) -> (T, T) {
    let z = x * x;
    (
        x * polynomial::<F, T>(z, F::SINE_PI),
        polynomial::<F, T>(z, F::COSINE_PI),
    )
}
