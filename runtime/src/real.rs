//! The numeric type that generated code is written over: a scalar, or lanes of scalars that advance together.
//!
//! Comparisons give masks and choices are selects, so the same text runs lane by lane without a branch. Elementary functions come from
//! `libm` on every target, because the host's library differs from it in the last bit.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Truth value of each lane.
pub trait Mask: Copy {
    /// The same truth value in every lane.
    fn splat(value: bool) -> Self;
    /// Both.
    fn and(self, other: Self) -> Self;
    /// Either.
    fn or(self, other: Self) -> Self;
    /// Negation.
    fn not(self) -> Self;
    /// Whether some lane is true.
    fn any(self) -> bool;
    /// Whether every lane is true.
    fn all(self) -> bool;
}

/// Real numbers in floating point. Arithmetic is IEEE 754, rounded to nearest, never fused.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Truth values of comparisons.
    type Mask: Mask;

    /// The nearest value to `value`, in every lane.
    fn from_f64(value: f64) -> Self;
    /// The value of the first lane.
    fn to_f64(self) -> f64;
    /// `a` where the mask is true, else `b`; the arm not taken may be NaN.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;

    /// Less; false for NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// Less or equal; false for NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// Greater; false for NaN.
    fn gt(self, other: Self) -> Self::Mask;
    /// Greater or equal; false for NaN.
    fn ge(self, other: Self) -> Self::Mask;
    /// Equal; false for NaN.
    fn eq(self, other: Self) -> Self::Mask;
    /// Not equal; true for NaN.
    fn ne(self, other: Self) -> Self::Mask;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> Self::Mask;

    /// Absolute value.
    fn abs(self) -> Self;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// e^x.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Sine of an angle in rad.
    fn sin(self) -> Self;
    /// Cosine of an angle in rad.
    fn cos(self) -> Self;
    /// Tangent of an angle in rad.
    fn tan(self) -> Self;
    /// Inverse sine, rad.
    fn asin(self) -> Self;
    /// Inverse cosine, rad.
    fn acos(self) -> Self;
    /// Inverse tangent, rad.
    fn atan(self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Angle in rad of the point (x = `other`, y = `self`).
    fn atan2(self, other: Self) -> Self;
    /// `self` to the power `exponent`.
    fn pow(self, exponent: Self) -> Self;

    /// 0.
    #[inline]
    fn zero() -> Self {
        Self::from_f64(0.0)
    }

    /// 1.
    #[inline]
    fn one() -> Self {
        Self::from_f64(1.0)
    }

    /// The `f64` nearest to pi.
    #[inline]
    fn pi() -> Self {
        Self::from_f64(core::f64::consts::PI)
    }

    /// `self` if `self < other`, else `other`: with a NaN on either side, `other`.
    #[inline]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }

    /// `self` if `self > other`, else `other`: with a NaN on either side, `other`.
    #[inline]
    fn max(self, other: Self) -> Self {
        Self::select(self.gt(other), self, other)
    }

    /// -1 or 1; zero (of either sign) and NaN are returned as they are.
    #[inline]
    fn sign(self) -> Self {
        let negative = Self::select(self.lt(Self::zero()), -Self::one(), self);
        Self::select(self.gt(Self::zero()), Self::one(), negative)
    }

    /// `self^n` by left-to-right binary powering, products only: starting from `r = x`, each bit of `n` below its highest set bit squares
    /// `r` and, if it is set, multiplies it by `x`. 1 for `n = 0`.
    #[inline]
    fn powi(self, n: u32) -> Self {
        let Some(highest) = n.checked_ilog2() else {
            return Self::one();
        };
        let mut power = self;
        for bit in (0..highest).rev() {
            power = power * power;
            if n >> bit & 1 == 1 {
                power = power * self;
            }
        }
        power
    }
}

impl Mask for bool {
    #[inline]
    fn splat(value: bool) -> Self {
        value
    }

    #[inline]
    fn and(self, other: Self) -> Self {
        self & other
    }

    #[inline]
    fn or(self, other: Self) -> Self {
        self | other
    }

    #[inline]
    fn not(self) -> Self {
        !self
    }

    #[inline]
    fn any(self) -> bool {
        self
    }

    #[inline]
    fn all(self) -> bool {
        self
    }
}

impl Real for f64 {
    type Mask = bool;

    #[inline]
    fn from_f64(value: f64) -> Self {
        value
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline]
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }

    #[inline]
    fn lt(self, other: Self) -> bool {
        self < other
    }

    #[inline]
    fn le(self, other: Self) -> bool {
        self <= other
    }

    #[inline]
    fn gt(self, other: Self) -> bool {
        self > other
    }

    #[inline]
    fn ge(self, other: Self) -> bool {
        self >= other
    }

    #[inline]
    fn eq(self, other: Self) -> bool {
        self == other
    }

    #[inline]
    fn ne(self, other: Self) -> bool {
        self != other
    }

    #[inline]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }

    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline]
    fn sqrt(self) -> Self {
        libm::sqrt(self)
    }

    #[inline]
    fn exp(self) -> Self {
        libm::exp(self)
    }

    #[inline]
    fn ln(self) -> Self {
        libm::log(self)
    }

    #[inline]
    fn sin(self) -> Self {
        libm::sin(self)
    }

    #[inline]
    fn cos(self) -> Self {
        libm::cos(self)
    }

    #[inline]
    fn tan(self) -> Self {
        libm::tan(self)
    }

    #[inline]
    fn asin(self) -> Self {
        libm::asin(self)
    }

    #[inline]
    fn acos(self) -> Self {
        libm::acos(self)
    }

    #[inline]
    fn atan(self) -> Self {
        libm::atan(self)
    }

    #[inline]
    fn sinh(self) -> Self {
        libm::sinh(self)
    }

    #[inline]
    fn cosh(self) -> Self {
        libm::cosh(self)
    }

    #[inline]
    fn tanh(self) -> Self {
        libm::tanh(self)
    }

    #[inline]
    fn atan2(self, other: Self) -> Self {
        libm::atan2(self, other)
    }

    #[inline]
    fn pow(self, exponent: Self) -> Self {
        libm::pow(self, exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::Real;

    fn same(found: f64, expected: f64) {
        assert_eq!(
            found.to_bits(),
            expected.to_bits(),
            "{found:e} is not {expected:e}"
        );
    }

    #[test]
    fn powi_multiplies_from_the_highest_bit_down() {
        let x = 1.1_f64;
        same(Real::powi(x, 0), 1.0);
        same(Real::powi(x, 1), x);
        same(Real::powi(x, 5), ((x * x) * (x * x)) * x);
        same(Real::powi(x, 6), ((x * x) * x) * ((x * x) * x));
        same(Real::powi(-0.5_f64, 3), -0.125);
    }

    #[test]
    fn sign_keeps_zeros_and_nan() {
        same(Real::sign(-3.0), -1.0);
        same(Real::sign(f64::INFINITY), 1.0);
        same(Real::sign(-0.0), -0.0);
        same(Real::sign(0.0), 0.0);
        assert!(Real::sign(f64::NAN).is_nan());
    }

    #[test]
    fn min_and_max_give_the_second_operand_unless_the_first_is_beyond() {
        same(Real::min(1.0, 2.0), 1.0);
        same(Real::max(1.0, 2.0), 2.0);
        same(Real::min(f64::NAN, 2.0), 2.0);
        assert!(Real::min(2.0, f64::NAN).is_nan());
        same(Real::max(0.0, -0.0), -0.0);
    }

    #[test]
    fn only_not_equal_holds_for_nan() {
        let nan = f64::NAN;
        assert!(Real::ne(nan, nan));
        assert!(
            !Real::eq(nan, nan)
                && !Real::le(nan, 0.0)
                && !Real::ge(nan, 0.0)
                && !Real::is_finite(nan)
        );
    }
}
