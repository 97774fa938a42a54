//! Powers with real exponents.
//!
//! `x^y = e^(y ln x)`, where the logarithm and the product are sums of two numbers: an error of 2^-65 in the logarithm becomes one of
//! 2^-55 in the result when the result is near the ends of the range. Products are exact because their factors are cut to 26 bits.

use super::exponential::{LN_2, Reduced, scaled};
use super::logarithm::{NORMALISING, split};
use crate::elementary::polynomial::polynomial;
use crate::rare::replaced;
use crate::real::{Bits, Mask, Real};

/// The first 26 bits of the significand, with sign and exponent.
const HALF: u64 = 0xffff_ffff_f800_0000;
/// 2/3, its first 26 bits, and the rest.
const TWO_THIRDS: [f64; 3] = [2.0 / 3.0, 0.6666666567325592, 9.934107462565104e-09];
/// Beyond them e^x is infinite, or 0.
const EXPONENTS: [f64; 2] = [-746.0, 710.0];

/// `(3/2) ln((1 + s)/(1 - s)) / s = 3 + u + u^2 P(u)`, u = s^2, absolute error 2^-71.8 (coefficients/elementary.sollya).
const SERIES: [f64; 8] = [
    0.5999999999999996,
    0.42857142857168623,
    0.3333333332610125,
    0.272727283279083,
    0.23076833904706723,
    0.2000452621553725,
    0.17511273239284514,
    0.17991046750715045,
];

#[inline(always)]
fn first_half<T: Real>(x: T) -> T {
    T::from_bits(x.to_bits().and(T::Bits::splat(HALF)))
}

/// `ln x - less ln 2` of a positive normal x as a number of 26 bits and a rest.
///
/// With `s = (m - 1)/(m + 1)`, cut to S and a rest ds: `ln m = 2/3 s (3 + s^2 + r)`, where `s^2 + r = S^2 + (ds (s + S) + u^2 P(u))`.
#[inline(always)]
fn logarithm<T: Real>(x: T, less: T) -> [T; 2] {
    let (k, m) = split(x);
    let k = k - less;
    let f = m - T::one();
    let d = T::from_f64(2.0) + f;
    let s = f / d;
    let (d_first, s_first) = (first_half(d), first_half(s));
    let d_rest = f - (d_first - T::from_f64(2.0));
    // 1/d = (1 - s)/2
    let half = T::from_f64(0.5);
    let s_rest = ((f - s_first * d_first) - s_first * d_rest) * (half - half * s);

    let u = s * s;
    let square = s_first * s_first;
    let r = s_rest * (s_first + s) + u * u * polynomial(u, SERIES);
    let three = T::from_f64(3.0);
    let sum = first_half((three + square) + r);
    let sum_rest = r - ((sum - three) - square);

    let product = s_first * sum;
    let product_rest = s_rest * sum + sum_rest * s;
    let p = first_half(product + product_rest);
    let p_rest = product_rest - (p - product);

    let [two_thirds, first, rest] = TWO_THIRDS.map(T::from_f64);
    let [ln_2, ln_2_rest] = LN_2.map(T::from_f64);
    let of_m = first * p;
    let of_m_rest = (rest * p + p_rest * two_thirds) + k * ln_2_rest;
    let of_power = k * ln_2;
    let ln = first_half(of_power + (of_m + of_m_rest));
    [ln, of_m_rest - ((ln - of_power) - of_m)]
}

/// `(x 2^-less)^y` of a positive normal x and a finite y.
#[inline(always)]
fn of_normal<T: Real>(x: T, y: T, less: T) -> T {
    let [ln, ln_rest] = logarithm(x, less);
    let y_first = first_half(y);
    let product = y_first * ln;
    let product_rest = (y - y_first) * ln + y * ln_rest;
    let z = product + product_rest;
    let [lowest, highest] = EXPONENTS.map(T::from_f64);
    let z_clamped = T::select(z.gt(highest), highest, z);
    let z_clamped = T::select(z.lt(lowest), lowest, z_clamped);
    let z_rest = T::select(z_clamped.eq(z), product_rest - (z - product), T::zero());
    let reduced = Reduced::of_sum(z_clamped, z_rest);
    let value = T::one() + (reduced.r + reduced.tail());
    scaled(value, reduced.k_bits)
}

/// x^y where x is not positive and normal, or y is not finite.
fn of_unusual(x: f64, y: f64) -> f64 {
    let whole = is_whole(y);
    let odd = whole && !is_whole(0.5 * y);
    let negative = odd && x.is_sign_negative();
    let signed = |magnitude: f64| if negative { -magnitude } else { magnitude };
    let a = x.abs();
    if y == 0.0 || x == 1.0 {
        1.0
    } else if x.is_nan() || y.is_nan() {
        f64::NAN
    } else if y.is_infinite() && a == 1.0 {
        1.0
    } else if y.is_infinite() || a == 0.0 || a.is_infinite() {
        signed(if (a > 1.0) == (y > 0.0) {
            f64::INFINITY
        } else {
            0.0
        })
    } else if x < 0.0 && !whole {
        f64::NAN
    } else if a < f64::MIN_POSITIVE {
        let (factor, exponent) = NORMALISING;
        signed(of_normal(a * factor, y, exponent))
    } else {
        signed(of_normal(a, y, 0.0))
    }
}

/// Whether a number is an integer; above 2^53 every number is.
fn is_whole(x: f64) -> bool {
    x.abs() >= 9007199254740992.0 || (x as i64) as f64 == x
}

#[inline(always)]
pub(crate) fn pow<T: Real>(x: T, y: T) -> T {
    let usual = of_normal(x, y, T::zero());
    let normal = x
        .ge(T::from_f64(f64::MIN_POSITIVE))
        .and(x.le(T::from_f64(f64::MAX)));
    replaced(normal.and(y.is_finite()).not(), usual, [x, y], |[x, y]| {
        of_unusual(x, y)
    })
}
