//! The natural logarithm.

use super::double::Double;
use super::format::{Format, constants, is_normal};
use super::polynomial::polynomial;
use crate::rare::replaced;
use crate::real::{Bits, Mask, Real};

/// 2^54, which makes subnormal numbers normal, and its logarithm to the base 2.
pub(super) const NORMALISING: (f64, f64) = (18014398509481984.0, 54.0);

/// A positive normal number as `2^k m` with m from sqrt(1/2) to sqrt 2; `(k, m)`.
#[inline(always)]
pub(super) fn split<F: Format, T: Real>(x: T) -> (T, T) {
    let lowest = T::from_f64(core::f64::consts::FRAC_1_SQRT_2).to_bits();
    let shifted = x.to_bits().add(T::one().to_bits().sub(lowest));
    // The exponent as the fraction of a number whose last place is 1.
    let unit = (1_u64 << F::FRACTION_BITS) as f64;
    let exponent = shifted
        .shr(F::FRACTION_BITS)
        .or(T::from_f64(unit).to_bits());
    let k = T::from_bits(exponent) - T::from_f64(unit + F::BIAS as f64);
    let fraction = shifted.and(T::Bits::splat((1 << F::FRACTION_BITS) - 1));
    (k, T::from_bits(fraction.add(lowest)))
}

/// `ln x - less ln 2` = `k ln 2 + f - (f^2/2 - s (f^2/2 + z P(z)))` with `f = m - 1`, `s = f / (2 + f)`, `z = s^2`.
#[inline(always)]
fn of_normal<F: Format, T: Real>(x: T, less: T) -> T {
    let (k, m) = split::<F, T>(x);
    let k = k - less;
    let [high, low] = constants::<T, _>(F::LN_2);
    let f = m - T::one();
    let s = f / (T::from_f64(2.0) + f);
    let z = s * s;
    let half_square = T::from_f64(0.5) * f * f;
    let rest = s * (half_square + z * polynomial::<F, T>(z, F::LOGARITHM)) + k * low;
    k * high - ((half_square - rest) - f)
}

/// ln of a number that is not positive and normal in some precision.
fn of_unusual(x: f64) -> f64 {
    if x == 0.0 {
        f64::NEG_INFINITY
    } else if x < 0.0 {
        f64::NAN
    } else if x.is_infinite() || x.is_nan() {
        x
    } else {
        let subnormal = x < f64::MIN_POSITIVE;
        let (factor, exponent) = if subnormal { NORMALISING } else { (1.0, 0.0) };
        of_normal::<Double, f64>(x * factor, exponent)
    }
}

#[inline(always)]
pub(crate) fn ln<F: Format, T: Real>(x: T) -> T {
    let usual = of_normal::<F, T>(x, T::zero());
    replaced(is_normal::<F, T>(x).not(), usual, [x], |[x]| of_unusual(x))
}
