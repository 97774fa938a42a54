//! Sine, cosine and tangent.
//!
//! `x = k pi/2 + r - low` with `|r| <= pi/4`, by Cody and Waite's method: pi/2 is a sum of three constants of which the first two have so
//! few digits that their products with `k < 2^16` are exact. The three functions compute the same reduction and the same two polynomials,
//! so a compiler that meets them with one argument computes those once.

use super::large_angle;
use crate::elementary::polynomial::polynomial;
use crate::rare::replaced;
use crate::real::{Bits, Real};

/// Largest |x| of the reduction below, rad; `k` stays below 2^16.
const LIMIT: f64 = 1e5;
/// 2/pi.
const TWO_OVER_PI: f64 = core::f64::consts::FRAC_2_PI;
/// Adding it rounds to an integer, which is then in the low bits of the representation.
const ROUND: f64 = 6755399441055744.0;
/// pi/2 = the first 37 bits + the next 37 bits + the next 53 bits + 6e-40.
const HALF_PI: [f64; 3] = [
    1.5707963267923333,
    2.5633441515839558e-12,
    1.0562999066987428e-23,
];

/// `sin r = r - r z P(z)`, z = r^2, relative error 2^-58.0 (coefficients/elementary.sollya).
const SINE: [f64; 6] = [
    0.16666666666666632,
    -0.008333333333322488,
    0.00019841269829854998,
    -2.755731370559618e-06,
    2.505075996150983e-08,
    -1.5896889927849293e-10,
];

/// `cos r = 1 - z/2 + z^2 P(z)`, absolute error 2^-64.1 (coefficients/elementary.sollya).
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.0013888888888874478,
    2.4801587289675016e-05,
    -2.7557314402010295e-07,
    2.0875729395043368e-09,
    -1.1359938741706802e-11,
];

/// An angle `k pi/2 + r - low`.
pub(super) struct Angle<T: Real> {
    pub(super) r: T,
    pub(super) low: T,
    /// k modulo 4 in the low two bits.
    pub(super) quadrant: T::Bits,
}

/// `sin(r - low) = r - sine_tail` and `cos(r - low) = 1 - half_z + cosine_rest`.
struct Parts<T: Real> {
    sine_tail: T,
    half_z: T,
    cosine_rest: T,
}

impl<T: Real> Angle<T> {
    /// The angle of |x| up to [`LIMIT`].
    #[inline(always)]
    fn reduced(x: T) -> Self {
        let rounded = x * T::from_f64(TWO_OVER_PI) + T::from_f64(ROUND);
        let k = rounded - T::from_f64(ROUND);
        let [high, middle, low] = HALF_PI.map(T::from_f64);
        let a = x - k * high;
        let product = k * middle;
        let b = a - product;
        let error = (a - b) - product;
        // Subtracted, not added, so that the sine of -0 is -0.
        let rest = k * low - error;
        let r = b - rest;
        Self {
            r,
            low: rest - (b - r),
            quadrant: rounded.to_bits(),
        }
    }

    #[inline(always)]
    fn parts(&self) -> Parts<T> {
        let Self { r, low, .. } = *self;
        let z = r * r;
        Parts {
            sine_tail: low + r * z * polynomial(z, SINE),
            half_z: z * T::from_f64(0.5),
            cosine_rest: z * z * polynomial(z, COSINE) + r * low,
        }
    }

    /// Whether k is odd.
    #[inline(always)]
    fn is_odd(&self) -> T::Mask {
        odd::<T>(self.quadrant)
    }

    #[inline(always)]
    pub(super) fn sin(&self) -> T {
        let parts = self.parts();
        let value = T::select(self.is_odd(), parts.cosine(), self.r - parts.sine_tail);
        negated_where::<T>(self.quadrant, value)
    }

    #[inline(always)]
    pub(super) fn cos(&self) -> T {
        let parts = self.parts();
        let value = T::select(self.is_odd(), self.r - parts.sine_tail, parts.cosine());
        negated_where::<T>(self.quadrant.add(T::Bits::splat(1)), value)
    }

    /// With s and c the rounded sine and cosine of r: `r + (s - r c) / c` for even k, where the numerator is made of the tails, and
    /// `-(c / s) (1 + dc / c - ds / s)` for odd k, where dc and ds are what rounding took from c and s.
    #[inline(always)]
    pub(super) fn tan(&self) -> T {
        let r = self.r;
        let parts = self.parts();
        let s = r - parts.sine_tail;
        let ds = (r - s) - parts.sine_tail;
        // More exactly than `Parts::cosine`: the rounding of 1 - z/2 is added again.
        let head = T::one() - parts.half_z;
        let correction = ((T::one() - head) - parts.half_z) + parts.cosine_rest;
        let c = head + correction;
        let dc = (head - c) + correction;
        let product_tail = r * (c - T::one()) + r * dc;
        let odd = self.is_odd();
        let numerator = T::select(odd, c, parts.sine_tail + product_tail);
        let quotient = -(numerator / T::select(odd, s, c));
        // 1/c to 2 %, which is enough for a correction of the last place.
        let secant = T::one() + T::from_f64(1.25) * parts.half_z;
        let cotangent = quotient + quotient * ((dc + ds * quotient) * secant);
        T::select(odd, cotangent, r + quotient)
    }
}

impl<T: Real> Parts<T> {
    #[inline(always)]
    fn cosine(&self) -> T {
        T::one() - (self.half_z - self.cosine_rest)
    }
}

/// Whether the lowest bit is set: shifted to where it makes 2.
#[inline(always)]
fn odd<T: Real>(bits: T::Bits) -> T::Mask {
    T::from_bits(bits.and(T::Bits::splat(1)).shl(62)).gt(T::zero())
}

/// `value` with its sign changed where the second lowest bit is set.
#[inline(always)]
fn negated_where<T: Real>(bits: T::Bits, value: T) -> T {
    let sign = bits.and(T::Bits::splat(2)).shl(62);
    T::from_bits(value.to_bits().xor(sign))
}

#[inline(always)]
fn is_large<T: Real>(x: T) -> T::Mask {
    x.abs().gt(T::from_f64(LIMIT))
}

#[inline(always)]
pub(crate) fn sin<T: Real>(x: T) -> T {
    let usual = Angle::reduced(x).sin();
    replaced(is_large(x), usual, x, |x| large_angle::reduced(x).sin())
}

#[inline(always)]
pub(crate) fn cos<T: Real>(x: T) -> T {
    let usual = Angle::reduced(x).cos();
    replaced(is_large(x), usual, x, |x| large_angle::reduced(x).cos())
}

#[inline(always)]
pub(crate) fn tan<T: Real>(x: T) -> T {
    let usual = Angle::reduced(x).tan();
    replaced(is_large(x), usual, x, |x| large_angle::reduced(x).tan())
}
