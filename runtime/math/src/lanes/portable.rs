//! Lanes as arrays of scalars, for processors without a module of their own.

use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::{Bits, Mask, Part, Real};

/// `N` things of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Array<S, const N: usize>([S; N]);

/// Two numbers in double precision.
pub type F64x2 = Array<f64, 2>;
/// Four numbers in single precision.
pub type F32x4 = Array<f32, 4>;

impl<S: Copy, const N: usize> Array<S, N> {
    #[inline(always)]
    fn each<R>(self, f: impl Fn(S) -> R) -> Array<R, N> {
        Array(from_fn(|i| f(self.0[i])))
    }

    #[inline(always)]
    fn both<R>(self, other: Self, f: impl Fn(S, S) -> R) -> Array<R, N> {
        Array(from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl<const N: usize> Mask for Array<bool, N> {
    #[inline(always)]
    fn splat(value: bool) -> Self {
        Array([value; N])
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.both(other, |a, b| a & b)
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self.both(other, |a, b| a | b)
    }

    #[inline(always)]
    fn not(self) -> Self {
        self.each(|a| !a)
    }

    #[inline(always)]
    fn to_bits(self) -> u32 {
        (0..N).fold(0, |bits, i| bits | u32::from(self.0[i]) << i)
    }

    #[inline(always)]
    fn from_bits(bits: u32) -> Self {
        Array(from_fn(|i| bits >> i & 1 == 1))
    }
}

impl<S: Bits, const N: usize> Bits for Array<S, N> {
    #[inline(always)]
    fn splat(value: u64) -> Self {
        Array([S::splat(value); N])
    }

    #[inline(always)]
    fn from_lanes(mut value: impl FnMut(usize) -> u64) -> Self {
        Array(from_fn(|i| S::splat(value(i))))
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.both(other, S::and)
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self.both(other, S::or)
    }

    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        self.both(other, S::xor)
    }

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.both(other, S::add)
    }

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.both(other, S::sub)
    }

    #[inline(always)]
    fn shl(self, n: u32) -> Self {
        self.each(|a| a.shl(n))
    }

    #[inline(always)]
    fn shr(self, n: u32) -> Self {
        self.each(|a| a.shr(n))
    }

    #[inline(always)]
    fn mul_wide(self, other: Self) -> (Self, Self) {
        (
            self.both(other, |a, b| a.mul_wide(b).0),
            self.both(other, |a, b| a.mul_wide(b).1),
        )
    }
}

/// An operator, entry by entry.
macro_rules! operator {
    ($($trait:ident $method:ident),*) => {$(
        impl<S: Real, const N: usize> $trait for Array<S, N> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.both(other, S::$method)
            }
        }
    )*};
}

operator!(Add add, Sub sub, Mul mul, Div div);

impl<S: Real, const N: usize> Neg for Array<S, N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.each(S::neg)
    }
}

/// Methods of one argument, of two, or with two results, entry by entry.
macro_rules! entry_by_entry {
    ($($method:ident),*; $($method2:ident),*; $($pair:ident),*; $($comparison:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                self.each(S::$method)
            }
        )*
        $(
            #[inline(always)]
            fn $method2(self, other: Self) -> Self {
                self.both(other, S::$method2)
            }
        )*
        $(
            #[inline(always)]
            fn $pair(self) -> (Self, Self) {
                (self.each(|x| x.$pair().0), self.each(|x| x.$pair().1))
            }
        )*
        $(
            #[inline(always)]
            fn $comparison(self, other: Self) -> Self::Mask {
                self.both(other, S::$comparison)
            }
        )*
    };
}

impl<S: Real<Mask = bool, Scalar = S>, const N: usize> Real for Array<S, N> {
    type Mask = Array<bool, N>;
    type Bits = Array<S::Bits, N>;
    type Scalar = S;

    const LANES: usize = N;
    const MANTISSA_DIGITS: u32 = S::MANTISSA_DIGITS;

    #[inline(always)]
    fn splat(value: S) -> Self {
        Array([value; N])
    }

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::splat(S::from_f64(value))
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.0[0].to_f64()
    }

    #[inline(always)]
    fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
        Array(from_fn(|i| S::from_f64(value(i))))
    }

    #[inline(always)]
    fn lane(self, i: usize) -> f64 {
        self.0[i].to_f64()
    }

    #[inline(always)]
    fn in_every_lane(&self, i: usize) -> Self {
        Self::splat(self.0[i % N])
    }

    #[inline(always)]
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self {
        Array(from_fn(|i| if mask.0[i] { a.0[i] } else { b.0[i] }))
    }

    #[inline(always)]
    fn from_bits(bits: Self::Bits) -> Self {
        bits.each(S::from_bits)
    }

    #[inline(always)]
    fn to_bits(self) -> Self::Bits {
        self.each(S::to_bits)
    }

    #[inline(never)]
    fn outlined<P: Part>(part: P) -> P::Output {
        part.run()
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Array(from_fn(|i| self.0[i].mul_add(factor.0[i], term.0[i])))
    }

    #[inline(always)]
    fn is_finite(self) -> Self::Mask {
        self.each(S::is_finite)
    }

    #[inline(always)]
    fn is_large_angle(self) -> Self::Mask {
        self.each(S::is_large_angle)
    }

    entry_by_entry!(
        abs, sqrt, exp, ln, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, rayleigh, usual_sin, usual_cos, usual_tan,
        exp_fused, ln_fused, sin_fused, cos_fused, tan_fused, asin_fused, acos_fused, atan_fused, sinh_fused, cosh_fused, tanh_fused,
        rayleigh_fused, usual_sin_fused, usual_cos_fused, usual_tan_fused;
        atan2, pow, atan2_fused, pow_fused;
        sin_cos, sin_cos_pi, sin_cos_pi_fused;
        lt, le, gt, ge, eq, ne
    );
}
