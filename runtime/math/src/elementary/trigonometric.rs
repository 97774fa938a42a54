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
use crate::real::{Bits, Mask, Real};

/// An angle `k pi/2 + r - low`.
pub(super) struct Angle<T: Real> {
    pub(super) r: T,
    pub(super) low: T,
    /// k modulo 4 in the low two bits.
    pub(super) quadrant: T::Bits,
}

impl<T: Real> Angle<T> {
    /// The angle of |x| up to [`Format::LARGEST_ANGLE`].
    #[inline(always)]
    fn reduced<F: Format>(x: T) -> Self {
        let round = T::from_f64(F::ROUND);
        let rounded = F::mul_add(x, T::from_f64(core::f64::consts::FRAC_2_PI), round);
        let k = rounded - round;
        let last = F::HALF_PI.len() - 1;
        let mut r = F::mul_add(k, T::from_f64(-F::HALF_PI[0]), x);
        // Subtracted, not added, so that the sine of -0 is -0.
        let mut rest = k * T::from_f64(F::HALF_PI[last]);
        let mut i = 1;
        while i < last {
            let (before, part) = (r, T::from_f64(-F::HALF_PI[i]));
            r = F::mul_add(k, part, before);
            rest = rest - F::mul_add(k, part, before - r);
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

    /// What is taken from r to make `sin(r - low)`.
    #[inline(always)]
    fn sine_tail<F: Format>(&self) -> T {
        let z = self.r * self.r;
        F::mul_add(self.r * z, polynomial::<F, T>(z, F::SINE), self.low)
    }

    /// `r^2 / 2` and what is added to `1 - r^2 / 2` to make `cos(r - low)`.
    #[inline(always)]
    fn cosine_parts<F: Format>(&self) -> [T; 2] {
        let z = self.r * self.r;
        let rest = F::mul_add(z * z, polynomial::<F, T>(z, F::COSINE), self.r * self.low);
        [z * T::from_f64(0.5), rest]
    }

    #[inline(always)]
    fn sine<F: Format>(&self) -> T {
        self.r - self.sine_tail::<F>()
    }

    #[inline(always)]
    fn cosine<F: Format>(&self) -> T {
        let [half_z, rest] = self.cosine_parts::<F>();
        T::one() - (half_z - rest)
    }

    /// Whether k is odd: its lowest bit shifted to where it makes 2.
    #[inline(always)]
    fn is_odd<F: Format>(&self) -> T::Mask {
        let lowest = self.quadrant.and(T::Bits::splat(1));
        T::from_bits(lowest.shl(sign_place::<F>() - 1)).gt(T::zero())
    }

    /// The cosine of r - low where the mask is true, else the sine. A scalar computes the one that it takes: a branch, but a controller's
    /// angle stays in its quadrant for many steps.
    #[inline(always)]
    fn either<F: Format>(&self, take_cosine: T::Mask) -> T {
        if !T::IS_SCALAR {
            return T::select(take_cosine, self.cosine::<F>(), self.sine::<F>());
        }
        if take_cosine.any() {
            self.cosine::<F>()
        } else {
            self.sine::<F>()
        }
    }

    #[inline(always)]
    pub(super) fn sin<F: Format>(&self) -> T {
        let value = self.either::<F>(self.is_odd::<F>());
        negated_where::<F, T>(self.quadrant, value)
    }

    #[inline(always)]
    pub(super) fn cos<F: Format>(&self) -> T {
        let value = self.either::<F>(self.is_odd::<F>().not());
        negated_where::<F, T>(self.quadrant.add(T::Bits::splat(1)), value)
    }

    #[inline(always)]
    fn sin_cos<F: Format>(&self) -> (T, T) {
        let (sine, cosine) = (self.sine::<F>(), self.cosine::<F>());
        let odd = self.is_odd::<F>();
        let next = self.quadrant.add(T::Bits::splat(1));
        (
            negated_where::<F, T>(self.quadrant, T::select(odd, cosine, sine)),
            negated_where::<F, T>(next, T::select(odd, sine, cosine)),
        )
    }

    /// With s and c the rounded sine and cosine of r: `r + (s - r c) / c` for even k, where the numerator is made of the tails, and
    /// `-(c / s) (1 + dc / c - ds / s)` for odd k, where dc and ds are what rounding took from c and s.
    #[inline(always)]
    pub(super) fn tan<F: Format>(&self) -> T {
        let r = self.r;
        let sine_tail = self.sine_tail::<F>();
        let s = r - sine_tail;
        let ds = (r - s) - sine_tail;
        let [half_z, cosine_rest] = self.cosine_parts::<F>();
        // More exactly than `Angle::cosine`: the rounding of 1 - z/2 is added again.
        let head = T::one() - half_z;
        let correction = ((T::one() - head) - half_z) + cosine_rest;
        let c = head + correction;
        let dc = (head - c) + correction;
        let product_tail = F::mul_add(r, c - T::one(), r * dc);
        let odd = self.is_odd::<F>();
        let numerator = T::select(odd, c, sine_tail + product_tail);
        let quotient = -(numerator / T::select(odd, s, c));
        // 1/c to 2 %, which is enough for a correction of the last place.
        let secant = F::mul_add(T::from_f64(1.25), half_z, T::one());
        let cotangent = F::mul_add(quotient, F::mul_add(ds, quotient, dc) * secant, quotient);
        T::select(odd, cotangent, r + quotient)
    }
}

/// `value` with its sign changed where the second lowest bit is set.
#[inline(always)]
fn negated_where<F: Format, T: Real>(bits: T::Bits, value: T) -> T {
    let sign = bits.and(T::Bits::splat(2)).shl(sign_place::<F>() - 1);
    T::from_bits(value.to_bits().xor(sign))
}

#[inline(always)]
pub(crate) fn is_large_angle<F: Format, T: Real>(x: T) -> T::Mask {
    x.abs().gt(T::from_f64(F::LARGEST_ANGLE))
}

#[inline(always)]
pub(crate) fn usual_sin<F: Format, T: Real>(x: T) -> T {
    Angle::reduced::<F>(x).sin::<F>()
}

#[inline(always)]
pub(crate) fn usual_cos<F: Format, T: Real>(x: T) -> T {
    Angle::reduced::<F>(x).cos::<F>()
}

#[inline(always)]
pub(crate) fn usual_tan<F: Format, T: Real>(x: T) -> T {
    Angle::reduced::<F>(x).tan::<F>()
}

#[inline(always)]
pub(crate) fn sin<F: Format, T: Real>(x: T) -> T {
    let usual = usual_sin::<F, T>(x);
    replaced(is_large_angle::<F, T>(x), usual, [x], |[x]| {
        large_angle::reduced(x).sin::<Double>()
    })
}

#[inline(always)]
pub(crate) fn cos<F: Format, T: Real>(x: T) -> T {
    let usual = usual_cos::<F, T>(x);
    replaced(is_large_angle::<F, T>(x), usual, [x], |[x]| {
        large_angle::reduced(x).cos::<Double>()
    })
}

/// Both by one reduction.
#[inline(always)]
pub(crate) fn sin_cos<F: Format, T: Real>(x: T) -> (T, T) {
    let (sine, cosine) = Angle::reduced::<F>(x).sin_cos::<F>();
    let large = is_large_angle::<F, T>(x);
    (
        replaced(large, sine, [x], |[x]| {
            large_angle::reduced(x).sin::<Double>()
        }),
        replaced(large, cosine, [x], |[x]| {
            large_angle::reduced(x).cos::<Double>()
        }),
    )
}

#[inline(always)]
pub(crate) fn tan<F: Format, T: Real>(x: T) -> T {
    let usual = usual_tan::<F, T>(x);
    replaced(is_large_angle::<F, T>(x), usual, [x], |[x]| {
        large_angle::reduced(x).tan::<Double>()
    })
}
