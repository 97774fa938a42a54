//! The numeric type that generated code is written over: a scalar, or lanes of scalars that advance together.
//!
//! Comparisons give masks and choices are selects, so the same text runs lane by lane without a branch.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::entries::{Each, Each2, Each3, EachPair, single};

/// Truth value of each lane.
pub trait Mask: Copy + Debug {
    /// The same truth value in every lane.
    fn splat(value: bool) -> Self;
    /// Both.
    fn and(self, other: Self) -> Self;
    /// Either.
    fn or(self, other: Self) -> Self;
    /// Negation.
    fn not(self) -> Self;
    /// The truth values as bits, lane 0 lowest.
    fn to_bits(self) -> u32;
    /// The truth values from bits, lane 0 lowest; bits beyond the last lane are ignored.
    fn from_bits(bits: u32) -> Self;

    /// Whether some lane is true.
    #[inline(always)]
    fn any(self) -> bool {
        self.to_bits() != 0
    }

    /// Whether every lane is true.
    #[inline(always)]
    fn all(self) -> bool {
        !self.not().any()
    }
}

/// The representation of each lane as an unsigned integer of the lane's size, for range reduction and random numbers. Arithmetic wraps.
pub trait Bits: Copy + Debug {
    /// The low bits of `value` in every lane.
    fn splat(value: u64) -> Self;
    /// The low bits of `value(i)` in each lane i.
    fn from_lanes(value: impl FnMut(usize) -> u64) -> Self;
    /// Bitwise and.
    fn and(self, other: Self) -> Self;
    /// Bitwise or.
    fn or(self, other: Self) -> Self;
    /// Bitwise exclusive or.
    fn xor(self, other: Self) -> Self;
    /// Sum.
    fn add(self, other: Self) -> Self;
    /// Difference.
    fn sub(self, other: Self) -> Self;
    /// Shift left by `n` places, `n` less than the size.
    fn shl(self, n: u32) -> Self;
    /// Logical shift right by `n` places, `n` less than the size.
    fn shr(self, n: u32) -> Self;
    /// Low and high half of the 64-bit product of the lanes' low 32 bits, each in the low 32 bits of a lane; the bits above them mean
    /// nothing, and are left so that nothing is spent on them.
    fn mul_wide(self, other: Self) -> (Self, Self);
}

/// A part of a computation that [`Real::outlined`] makes a function of its own, to split large bodies or to share one of them. It is a trait
/// of its own because a closure might be left outside that function, where its instructions are not enabled.
pub trait Part {
    /// What it gives.
    type Output;
    /// The computation; `#[inline(always)]` in every implementation.
    fn run(self) -> Self::Output;
}

/// Functions in arithmetic by [`Real::mul_add`]: they take fewer operations and are as near, but need an instruction to be fast.
macro_rules! fused {
    ($($method:ident: $function:ident),*; $($method2:ident: $function2:ident),*) => {
        $(
            #[doc = concat!("[`Real::", stringify!($function), "`], whose products are fused with sums.")]
            fn $method(self) -> Self;
        )*
        $(
            #[doc = concat!("[`Real::", stringify!($function2), "`], whose products are fused with sums.")]
            fn $method2(self, other: Self) -> Self;
        )*
    };
}

/// As many lanes as the widest type has, 16 numbers of single precision.
pub const MOST_LANES: usize = 16;

/// Real numbers in floating point. Arithmetic is IEEE 754, rounded to nearest, and fused by [`Real::mul_add`] alone.
pub trait Real:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Truth values of comparisons.
    type Mask: Mask;
    /// Representations.
    type Bits: Bits;
    /// The number of one lane.
    type Scalar: Real<Scalar = Self::Scalar>;

    /// Number of lanes; 1 for a scalar.
    const LANES: usize;
    /// Whether it is a scalar.
    const IS_SCALAR: bool = Self::LANES == 1;
    /// Binary digits of the significand: 53 in double precision, 24 in single.
    const MANTISSA_DIGITS: u32;

    /// The same number in every lane.
    fn splat(value: Self::Scalar) -> Self;
    /// The nearest value to `value`, in every lane.
    fn from_f64(value: f64) -> Self;
    /// The value of the first lane.
    fn to_f64(self) -> f64;
    /// The nearest value to `value(i)` in each lane i.
    fn from_lanes(value: impl FnMut(usize) -> f64) -> Self;
    /// The value of lane `i`, less than [`Real::LANES`].
    fn lane(self, i: usize) -> f64;
    /// The value of lane `i`, modulo [`Real::LANES`], in every lane. By reference, since it is one load from memory.
    fn in_every_lane(&self, i: usize) -> Self;
    /// `a` where the mask is true, else `b`; the arm not taken may be NaN.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// The number with this representation.
    fn from_bits(bits: Self::Bits) -> Self;
    /// The representation.
    fn to_bits(self) -> Self::Bits;
    /// The result of a part, in a function of its own that is compiled for the instruction set of this type.
    fn outlined<P: Part>(part: P) -> P::Output;

    /// Writes `f` of each entry to the results, of which there are as many.
    #[inline(always)]
    fn each(f: impl Each, entries: &[Self], results: &mut [Self]) {
        single::each(f, entries, results);
    }

    /// `f` of each entry and the other at the same place; there are as many others.
    #[inline(always)]
    fn each2(f: impl Each2, entries: &mut [Self], others: &[Self]) {
        single::each2(f, entries, others);
    }

    /// `f` of each entry and two others at the same place; there are as many others.
    #[inline(always)]
    fn each3(f: impl Each3, entries: &mut [Self], others: [&[Self]; 2]) {
        single::each3(f, entries, others);
    }

    /// Replaces the entries at each place by the two results of `f`; there are as many others.
    #[inline(always)]
    fn each_pair(f: impl EachPair, entries: &mut [Self], others: &mut [Self]) {
        single::each_pair(f, entries, others);
    }

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

    /// `self factor + term`, rounded once. Where the program is compiled for no such instruction it is a call of a function.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// e^x.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Whether sine, cosine and tangent of this angle need more than the usual reduction.
    fn is_large_angle(self) -> Self::Mask;
    /// Sine of an angle that is not large, without a branch.
    fn usual_sin(self) -> Self;
    /// Cosine of an angle that is not large, without a branch.
    fn usual_cos(self) -> Self;
    /// Tangent of an angle that is not large, without a branch.
    fn usual_tan(self) -> Self;
    /// Sine of an angle in rad.
    fn sin(self) -> Self;
    /// Cosine of an angle in rad.
    fn cos(self) -> Self;
    /// [`Real::sin`] and [`Real::cos`], bit by bit, by one reduction of the angle.
    fn sin_cos(self) -> (Self, Self);
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
    /// `sqrt(-2 ln x)` of a normal x between 0 and 1, the ends excluded, to a relative error of 2 epsilon: what a number of the Rayleigh
    /// distribution exceeds with probability x.
    fn rayleigh(self) -> Self;
    /// Sine and cosine of pi x for |x| up to 1/2, to an absolute error of 2.5 epsilon.
    fn sin_cos_pi(self) -> (Self, Self);

    fused! {
        exp_fused: exp, ln_fused: ln, usual_sin_fused: usual_sin, usual_cos_fused: usual_cos, usual_tan_fused: usual_tan, sin_fused: sin,
        cos_fused: cos, tan_fused: tan, asin_fused: asin, acos_fused: acos, atan_fused: atan, sinh_fused: sinh, cosh_fused: cosh,
        tanh_fused: tanh, rayleigh_fused: rayleigh;
        atan2_fused: atan2, pow_fused: pow
    }
    /// [`Real::sin_cos_pi`], whose products are fused with sums.
    fn sin_cos_pi_fused(self) -> (Self, Self);

    /// 0.
    #[inline(always)]
    fn zero() -> Self {
        Self::from_f64(0.0)
    }

    /// 1.
    #[inline(always)]
    fn one() -> Self {
        Self::from_f64(1.0)
    }

    /// The `f64` nearest to pi.
    #[inline(always)]
    fn pi() -> Self {
        Self::from_f64(core::f64::consts::PI)
    }

    /// `self` if `self < other`, else `other`: with a NaN on either side, `other`.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }

    /// `self` if `self > other`, else `other`: with a NaN on either side, `other`.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(self.gt(other), self, other)
    }

    /// -1 or 1; zero (of either sign) and NaN are returned as they are.
    #[inline(always)]
    fn sign(self) -> Self {
        let negative = Self::select(self.lt(Self::zero()), -Self::one(), self);
        Self::select(self.gt(Self::zero()), Self::one(), negative)
    }

    /// `self^n` by left-to-right binary powering, products only: starting from `r = x`, each bit of `n` below its highest set bit squares
    /// `r` and, if it is set, multiplies it by `x`. 1 for `n = 0`.
    #[inline(always)]
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
