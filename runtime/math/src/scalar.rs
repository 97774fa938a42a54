//! `f32` and `f64` as numbers of one lane.

#[cfg(target_arch = "x86_64")]
use crate::entries::{Each, Each2, Each3, EachPair, packed};
use crate::fused::{fused_f32, fused_f64};
#[cfg(target_arch = "x86_64")]
use crate::lanes::x86;
use crate::real::{Bits, Mask, Part, Real};
use crate::sqrt::{sqrt_f32, sqrt_f64};

impl Mask for bool {
    #[inline(always)]
    fn splat(value: bool) -> Self {
        value
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self & other
    }

    #[inline(always)]
    fn or(self, other: Self) -> Self {
        self | other
    }

    #[inline(always)]
    fn not(self) -> Self {
        !self
    }

    #[inline(always)]
    fn to_bits(self) -> u32 {
        u32::from(self)
    }

    #[inline(always)]
    fn from_bits(bits: u32) -> Self {
        bits & 1 == 1
    }
}

/// Implements [`Bits`] for an unsigned integer.
macro_rules! bits {
    ($integer:ty) => {
        impl Bits for $integer {
            #[inline(always)]
            fn splat(value: u64) -> Self {
                value as $integer
            }

            #[inline(always)]
            fn from_lanes(mut value: impl FnMut(usize) -> u64) -> Self {
                value(0) as $integer
            }

            #[inline(always)]
            fn and(self, other: Self) -> Self {
                self & other
            }

            #[inline(always)]
            fn or(self, other: Self) -> Self {
                self | other
            }

            #[inline(always)]
            fn xor(self, other: Self) -> Self {
                self ^ other
            }

            #[inline(always)]
            fn add(self, other: Self) -> Self {
                self.wrapping_add(other)
            }

            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }

            #[inline(always)]
            fn shl(self, n: u32) -> Self {
                self << n
            }

            #[inline(always)]
            fn shr(self, n: u32) -> Self {
                self >> n
            }

            #[inline(always)]
            fn mul_wide(self, other: Self) -> (Self, Self) {
                let product = u64::from(self as u32) * u64::from(other as u32);
                (product as $integer, (product >> 32) as $integer)
            }
        }
    };
}

bits!(u64);
bits!(u32);

/// The elementary functions of a type with the constants of a precision.
macro_rules! elementary {
    ($format:ident) => {
        crate::scalar::elementary!(
            crate::elementary::$format:
            exp = exp, ln = ln, sin = sin, cos = cos, tan = tan, asin = asin, acos = acos, atan = atan, sinh = sinh, cosh = cosh,
            tanh = tanh, rayleigh = rayleigh, usual_sin = usual_sin, usual_cos = usual_cos, usual_tan = usual_tan;
            atan2 = atan2, pow = pow;
            sin_cos = sin_cos, sin_cos_pi = sin_cos_pi
        );
        crate::scalar::elementary!(
            crate::elementary::Fused<crate::elementary::$format>:
            exp_fused = exp, ln_fused = ln, sin_fused = sin, cos_fused = cos, tan_fused = tan, asin_fused = asin, acos_fused = acos,
            atan_fused = atan, sinh_fused = sinh, cosh_fused = cosh, tanh_fused = tanh, rayleigh_fused = rayleigh,
            usual_sin_fused = usual_sin, usual_cos_fused = usual_cos, usual_tan_fused = usual_tan;
            atan2_fused = atan2, pow_fused = pow;
            sin_cos_pi_fused = sin_cos_pi
        );

        #[inline(always)]
        fn is_large_angle(self) -> Self::Mask {
            crate::elementary::is_large_angle::<crate::elementary::$format, Self>(self)
        }
    };
    ($format:ty: $($method:ident = $function:ident),*; $($method2:ident = $function2:ident),*; $($pair:ident = $of:ident),*) => {
        $(
            #[inline(always)]
            fn $method(self) -> Self {
                crate::elementary::$function::<$format, Self>(self)
            }
        )*
        $(
            #[inline(always)]
            fn $method2(self, other: Self) -> Self {
                crate::elementary::$function2::<$format, Self>(self, other)
            }
        )*
        $(
            #[inline(always)]
            fn $pair(self) -> (Self, Self) {
                crate::elementary::$of::<$format, Self>(self)
            }
        )*
    };
}
pub(crate) use elementary;

/// Implements [`Real`] for a scalar.
macro_rules! scalar {
    ($float:ident, $bits:ty, $format:ident, $sqrt:path, $fused:path,
     $wide:ident[$w:literal], $middle:ident[$m:literal], $narrow:ident[$n:literal]) => {
        impl Real for $float {
            type Mask = bool;
            type Bits = $bits;
            type Scalar = Self;

            const LANES: usize = 1;
            const MANTISSA_DIGITS: u32 = $float::MANTISSA_DIGITS;

            #[inline(always)]
            fn splat(value: Self) -> Self {
                value
            }

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                value as $float
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
                value(0) as $float
            }

            #[inline(always)]
            fn lane(self, _: usize) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn in_every_lane(&self, _: usize) -> Self {
                *self
            }

            #[inline(always)]
            fn select(mask: bool, a: Self, b: Self) -> Self {
                if mask { a } else { b }
            }

            #[inline(always)]
            fn from_bits(bits: $bits) -> Self {
                $float::from_bits(bits)
            }

            #[inline(always)]
            fn to_bits(self) -> $bits {
                $float::to_bits(self)
            }

            #[inline(never)]
            fn outlined<P: Part>(part: P) -> P::Output {
                part.run()
            }

            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn each(f: impl Each, entries: &[Self], results: &mut [Self]) {
                packed::each::<Self, x86::$wide, x86::$middle, x86::$narrow, $w, $m, $n>(
                    f, entries, results,
                );
            }

            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn each2(f: impl Each2, entries: &mut [Self], others: &[Self]) {
                packed::each2::<Self, x86::$wide, x86::$middle, x86::$narrow, $w, $m, $n>(
                    f, entries, others,
                );
            }

            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn each_pair(f: impl EachPair, entries: &mut [Self], others: &mut [Self]) {
                packed::each_pair::<Self, x86::$wide, x86::$middle, x86::$narrow, $w, $m, $n>(
                    f, entries, others,
                );
            }

            #[cfg(target_arch = "x86_64")]
            #[inline(always)]
            fn each3(f: impl Each3, entries: &mut [Self], others: [&[Self]; 2]) {
                packed::each3::<Self, x86::$wide, x86::$middle, x86::$narrow, $w, $m, $n>(
                    f, entries, others,
                );
            }

            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                $fused(self, factor, term)
            }

            #[inline(always)]
            fn lt(self, other: Self) -> bool {
                self < other
            }

            #[inline(always)]
            fn le(self, other: Self) -> bool {
                self <= other
            }

            #[inline(always)]
            fn gt(self, other: Self) -> bool {
                self > other
            }

            #[inline(always)]
            fn ge(self, other: Self) -> bool {
                self >= other
            }

            #[inline(always)]
            fn eq(self, other: Self) -> bool {
                self == other
            }

            #[inline(always)]
            fn ne(self, other: Self) -> bool {
                self != other
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            elementary!($format);
        }
    };
}

scalar!(
    f64, u64, Double, sqrt_f64, fused_f64, F64x8[8], F64x4[4], F64x2[2]
);
scalar!(
    f32, u32, Single, sqrt_f32, fused_f32, F32x16[16], F32x8[8], F32x4[4]
);

#[cfg(test)]
mod tests {
    use crate::real::Real;

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
