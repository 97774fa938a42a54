//! Powers with real exponents.
//!
//! `x^y = e^(y ln x)`, where the logarithm and the product are sums of two numbers: an error in the logarithm becomes one in the result that
//! is larger by as many bits as the exponent has. Products are exact because their factors are cut to half of the significand.

use super::double::Double;
use super::exponential::{Reduced, clamped};
use super::format::{Format, constants, first_half, is_normal};
use super::logarithm::{NORMALISING, split};
use super::polynomial::polynomial;
use crate::rare::replaced;
use crate::real::{Mask, Real};

/// `ln x - less ln 2` of a positive normal x as a number of half a significand and a rest.
///
/// With `s = (m - 1)/(m + 1)`, cut to S and a rest ds: `ln m = 2/3 s (3 + s^2 + r)`, where `s^2 + r = S^2 + (ds (s + S) + u^2 P(u))`.
#[inline(always)]
fn logarithm<F: Format, T: Real>(x: T, less: T) -> [T; 2] {
    let (k, m) = split::<F, T>(x);
    let k = k - less;
    let (two, half) = (T::from_f64(2.0), T::from_f64(0.5));
    let f = m - T::one();
    let d = two + f;
    let s = f / d;
    let (d_first, s_first) = (first_half::<F, T>(d), first_half::<F, T>(s));
    let d_rest = f - (d_first - two);
    // 1/d = (1 - s)/2
    let s_rest = ((f - s_first * d_first) - s_first * d_rest) * (half - half * s);

    let u = s * s;
    let square = s_first * s_first;
    let r = s_rest * (s_first + s) + u * u * polynomial::<F, T>(u, F::LOGARITHM_OF_POWER);
    let three = T::from_f64(3.0);
    let sum = first_half::<F, T>((three + square) + r);
    let sum_rest = r - ((sum - three) - square);

    let product = s_first * sum;
    let product_rest = s_rest * sum + sum_rest * s;
    let p = first_half::<F, T>(product + product_rest);
    let p_rest = product_rest - (p - product);

    let [two_thirds, two_thirds_rest] = constants::<T, _>(F::TWO_THIRDS);
    let [ln_2, ln_2_rest] = constants::<T, _>(F::LN_2);
    let of_m = two_thirds * p;
    let whole = two_thirds + two_thirds_rest;
    let of_m_rest = (two_thirds_rest * p + p_rest * whole) + k * ln_2_rest;
    let of_power = k * ln_2;
    let ln = first_half::<F, T>(of_power + (of_m + of_m_rest));
    [ln, of_m_rest - ((ln - of_power) - of_m)]
}

/// `(x 2^-less)^y` of a positive normal x and a finite y.
#[inline(always)]
fn of_normal<F: Format, T: Real>(x: T, y: T, less: T) -> T {
    let [ln, ln_rest] = logarithm::<F, T>(x, less);
    let y_first = first_half::<F, T>(y);
    let product = y_first * ln;
    let product_rest = (y - y_first) * ln + y * ln_rest;
    let z = product + product_rest;
    let in_range = clamped::<F, T>(z);
    let rest = T::select(in_range.eq(z), product_rest - (z - product), T::zero());
    Reduced::of_sum::<F>(in_range, rest).exp::<F>()
}

/// x^y where x is not positive and normal in some precision, or y is not finite.
fn of_unusual(x: f64, y: f64) -> f64 {
    let whole = is_whole(y);
    let negative = x.is_sign_negative() && whole && !is_whole(0.5 * y);
    let signed = |magnitude: f64| if negative { -magnitude } else { magnitude };
    let a = x.abs();
    if y == 0.0 || x == 1.0 || (a == 1.0 && y.is_infinite()) {
        1.0
    } else if x.is_nan() || y.is_nan() {
        f64::NAN
    } else if y.is_infinite() || a == 0.0 || a.is_infinite() {
        let infinite = (a > 1.0) == (y > 0.0);
        signed(if infinite { f64::INFINITY } else { 0.0 })
    } else if x < 0.0 && !whole {
        f64::NAN
    } else {
        let subnormal = a < f64::MIN_POSITIVE;
        let (factor, exponent) = if subnormal { NORMALISING } else { (1.0, 0.0) };
        signed(of_normal::<Double, f64>(a * factor, y, exponent))
    }
}

/// Whether a number is an integer; from 2^53 on every number is.
fn is_whole(x: f64) -> bool {
    x.abs() >= 9007199254740992.0 || (x as i64) as f64 == x
}

#[inline(always)]
pub(crate) fn pow<F: Format, T: Real>(x: T, y: T) -> T {
    let usual = of_normal::<F, T>(x, y, T::zero());
    let ordinary = is_normal::<F, T>(x).and(y.is_finite());
    replaced(ordinary.not(), usual, [x, y], |[x, y]| of_unusual(x, y))
}
