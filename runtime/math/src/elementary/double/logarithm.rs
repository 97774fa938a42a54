//! The natural logarithm.

use super::exponential::LN_2;
use crate::elementary::polynomial::polynomial;
use crate::real::{Bits, Real};

/// sqrt(1/2), from where the significand is counted: m in [sqrt(1/2), sqrt 2).
const LOWEST_SIGNIFICAND: u64 = 0x3fe6_a09e_667f_3bcd;
/// 1.
const ONE: u64 = 0x3ff0_0000_0000_0000;
/// Bits of the significand.
const SIGNIFICAND: u64 = 0x000f_ffff_ffff_ffff;
/// 2^52, whose low bits take an integer.
const INTEGER: u64 = 0x4330_0000_0000_0000;
/// 2^54, which makes subnormal numbers normal.
const NORMALISING: f64 = 18014398509481984.0;

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

/// A positive finite number as `2^k m`; `(k, m)`.
#[inline(always)]
pub(super) fn split<T: Real>(x: T) -> (T, T) {
    let subnormal = x.lt(T::from_f64(f64::MIN_POSITIVE));
    let x = T::select(subnormal, x * T::from_f64(NORMALISING), x);
    let shifted = x.to_bits().add(T::Bits::splat(ONE - LOWEST_SIGNIFICAND));
    let exponent = T::from_bits(shifted.shr(52).or(T::Bits::splat(INTEGER)));
    let bias = f64::from_bits(INTEGER) + 1023.0;
    let bias = T::select(subnormal, T::from_f64(bias + 54.0), T::from_f64(bias));
    let m = shifted
        .and(T::Bits::splat(SIGNIFICAND))
        .add(T::Bits::splat(LOWEST_SIGNIFICAND));
    (exponent - bias, T::from_bits(m))
}

/// `k ln 2 + f - (f^2/2 - s (f^2/2 + s z P(z)))` with `f = m - 1`, `s = f / (2 + f)`.
#[inline(always)]
pub(crate) fn ln<T: Real>(x: T) -> T {
    let (k, m) = split(x);
    let [high, low] = LN_2.map(T::from_f64);
    let f = m - T::one();
    let s = f / (T::from_f64(2.0) + f);
    let z = s * s;
    let half_square = T::from_f64(0.5) * f * f;
    let rest = s * (half_square + z * polynomial(z, SERIES)) + k * low;
    let value = k * high - ((half_square - rest) - f);
    let infinity = T::from_f64(f64::INFINITY);
    let at_zero = T::select(x.eq(T::zero()), -infinity, T::from_f64(f64::NAN));
    T::select(
        x.gt(T::zero()),
        T::select(x.lt(infinity), value, x),
        at_zero,
    )
}
