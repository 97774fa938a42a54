//! Sine, cosine and tangent.
//!
//! `x = k pi/2 + r - low` with `|r| <= pi/4`, by Cody and Waite's method: pi/2 is a sum of constants of which all but the last have so few
//! digits that their products with k are exact. The three functions compute the same reduction and the same two polynomials, so a compiler
//! that meets them with one argument computes those once.

use super::double::Double;
use super::format::{Format, sign_place};
use super::large_angle;
use super::polynomial::polynomial;
use crate::rare::replaced;
use crate::real::{Bits, Real};

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
    /// The angle of |x| up to [`Format::LARGEST_ANGLE`].
    #[inline(always)]
    fn reduced<F: Format>(x: T) -> Self {
        let round = T::from_f64(F::ROUND);
        let rounded = x * T::from_f64(core::f64::consts::FRAC_2_PI) + round;
        let k = rounded - round;
        let last = F::HALF_PI.len() - 1;
        let mut r = x - k * T::from_f64(F::HALF_PI[0]);
        // Subtracted, not added, so that the sine of -0 is -0.
        let mut rest = k * T::from_f64(F::HALF_PI[last]);
        let mut i = 1;
        while i < last {
            let (before, part) = (r, k * T::from_f64(F::HALF_PI[i]));
            r = before - part;
            rest = rest - ((before - r) - part);
            i += 1;
        }
        let sum = r;
        let r = sum - rest;
        Self {
            r,
            low: rest - (sum - r),
            quadrant: rounded.to_bits(),
        }
    }

    #[inline(always)]
    fn parts<F: Format>(&self) -> Parts<T> {
        let Self { r, low, .. } = *self;
        let z = r * r;
        Parts {
            sine_tail: low + r * z * polynomial(z, F::SINE),
            half_z: z * T::from_f64(0.5),
            cosine_rest: z * z * polynomial(z, F::COSINE) + r * low,
        }
    }

    /// Whether k is odd: its lowest bit shifted to where it makes 2.
    #[inline(always)]
    fn is_odd<F: Format>(&self) -> T::Mask {
        let lowest = self.quadrant.and(T::Bits::splat(1));
        T::from_bits(lowest.shl(sign_place::<F>() - 1)).gt(T::zero())
    }

    #[inline(always)]
    pub(super) fn sin<F: Format>(&self) -> T {
        let parts = self.parts::<F>();
        let sine = self.r - parts.sine_tail;
        let value = T::select(self.is_odd::<F>(), parts.cosine(), sine);
        negated_where::<F, T>(self.quadrant, value)
    }

    #[inline(always)]
    pub(super) fn cos<F: Format>(&self) -> T {
        let parts = self.parts::<F>();
        let sine = self.r - parts.sine_tail;
        let value = T::select(self.is_odd::<F>(), sine, parts.cosine());
        negated_where::<F, T>(self.quadrant.add(T::Bits::splat(1)), value)
    }

    /// With s and c the rounded sine and cosine of r: `r + (s - r c) / c` for even k, where the numerator is made of the tails, and
    /// `-(c / s) (1 + dc / c - ds / s)` for odd k, where dc and ds are what rounding took from c and s.
    #[inline(always)]
    pub(super) fn tan<F: Format>(&self) -> T {
        let r = self.r;
        let parts = self.parts::<F>();
        let s = r - parts.sine_tail;
        let ds = (r - s) - parts.sine_tail;
        // More exactly than `Parts::cosine`: the rounding of 1 - z/2 is added again.
        let head = T::one() - parts.half_z;
        let correction = ((T::one() - head) - parts.half_z) + parts.cosine_rest;
        let c = head + correction;
        let dc = (head - c) + correction;
        let product_tail = r * (c - T::one()) + r * dc;
        let odd = self.is_odd::<F>();
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

/// `value` with its sign changed where the second lowest bit is set.
#[inline(always)]
fn negated_where<F: Format, T: Real>(bits: T::Bits, value: T) -> T {
    let sign = bits.and(T::Bits::splat(2)).shl(sign_place::<F>() - 1);
    T::from_bits(value.to_bits().xor(sign))
}

#[inline(always)]
fn is_large<F: Format, T: Real>(x: T) -> T::Mask {
    x.abs().gt(T::from_f64(F::LARGEST_ANGLE))
}

#[inline(always)]
pub(crate) fn sin<F: Format, T: Real>(x: T) -> T {
    let usual = Angle::reduced::<F>(x).sin::<F>();
    replaced(is_large::<F, T>(x), usual, [x], |[x]| {
        large_angle::reduced(x).sin::<Double>()
    })
}

#[inline(always)]
pub(crate) fn cos<F: Format, T: Real>(x: T) -> T {
    let usual = Angle::reduced::<F>(x).cos::<F>();
    replaced(is_large::<F, T>(x), usual, [x], |[x]| {
        large_angle::reduced(x).cos::<Double>()
    })
}

#[inline(always)]
pub(crate) fn tan<F: Format, T: Real>(x: T) -> T {
    let usual = Angle::reduced::<F>(x).tan::<F>();
    replaced(is_large::<F, T>(x), usual, [x], |[x]| {
        large_angle::reduced(x).tan::<Double>()
    })
}
