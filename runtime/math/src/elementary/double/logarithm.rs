//! The natural logarithm.

use super::exponential::LN_2;
use crate::elementary::polynomial::polynomial;
use crate::rare::replaced;
use crate::real::{Bits, Mask, Real};

/// sqrt(1/2), from where the significand is counted: m in [sqrt(1/2), sqrt 2).
const LOWEST_SIGNIFICAND: u64 = 0x3fe6_a09e_667f_3bcd;
/// 1.
const ONE: u64 = 0x3ff0_0000_0000_0000;
/// Bits of the significand.
const SIGNIFICAND: u64 = 0x000f_ffff_ffff_ffff;
/// 2^52, whose low bits take an integer.
const INTEGER: u64 = 0x4330_0000_0000_0000;
/// 2^54, which makes subnormal numbers normal, and its logarithm.
const NORMALISING: (f64, f64) = (18014398509481984.0, 54.0);

/// `ln((1 + s)/(1 - s)) = 2 s + s z P(z)`, z = s^2, relative error 2^-59.4 (coefficients/elementary.sollya).
const SERIES: [f64; 7] = [
    0.6666666666666735,
    0.3999999999940935,
    0.2857142874368671,
    0.22222198428936554,
    0.18183572357834565,
    0.15313832074479214,
    0.14798259832999008,
];

/// A positive normal number as `2^k m`; `(k, m)`.
#[inline(always)]
fn split<T: Real>(x: T) -> (T, T) {
    let shifted = x.to_bits().add(T::Bits::splat(ONE - LOWEST_SIGNIFICAND));
    let exponent = T::from_bits(shifted.shr(52).or(T::Bits::splat(INTEGER)));
    let k = exponent - T::from_f64(f64::from_bits(INTEGER) + 1023.0);
    let significand = shifted.and(T::Bits::splat(SIGNIFICAND));
    let m = T::from_bits(significand.add(T::Bits::splat(LOWEST_SIGNIFICAND)));
    (k, m)
}

/// `ln x - less ln 2` = `k ln 2 + f - (f^2/2 - s (f^2/2 + z P(z)))` with `f = m - 1`, `s = f / (2 + f)`.
#[inline(always)]
fn of_normal<T: Real>(x: T, less: T) -> T {
    let (k, m) = split(x);
    let k = k - less;
    let [high, low] = LN_2.map(T::from_f64);
    let f = m - T::one();
    let s = f / (T::from_f64(2.0) + f);
    let z = s * s;
    let half_square = T::from_f64(0.5) * f * f;
    let rest = s * (half_square + z * polynomial(z, SERIES)) + k * low;
    k * high - ((half_square - rest) - f)
}

/// ln of zero, a subnormal or negative number, infinity or NaN.
fn of_unusual(x: f64) -> f64 {
    if x == 0.0 {
        f64::NEG_INFINITY
    } else if x < 0.0 {
        f64::NAN
    } else if x < f64::MIN_POSITIVE {
        let (factor, logarithm) = NORMALISING;
        of_normal(x * factor, logarithm)
    } else {
        x
    }
}

#[inline(always)]
pub(crate) fn ln<T: Real>(x: T) -> T {
    let normal = x
        .ge(T::from_f64(f64::MIN_POSITIVE))
        .and(x.le(T::from_f64(f64::MAX)));
    replaced(normal.not(), of_normal(x, T::zero()), x, of_unusual)
}
