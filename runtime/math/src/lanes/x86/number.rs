//! Numbers of each lane.

use core::arch::x86_64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::bits::*;
use super::choice::*;
use super::mask::*;
use crate::entries::packed::Register;
use crate::real::{Part, Real};
use crate::scalar::elementary;

/// An operator as one instruction.
macro_rules! operator {
    ($lanes:ident: $($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for $lanes {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}

/// Vectors of numbers.
macro_rules! lanes {
    ($lanes:ident($register:ty), $mask:ident, $bits:ident, [$element:ty; $count:literal], $feature:literal, $format:ident,
     $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $fused:ident, $splat:ident, $load:ident, $store:ident,
     $xor:ident, $andnot:ident, $lt:ident, $le:ident, $eq:ident, $ne:ident, $select:ident, $to_bits:ident, $from_bits:ident) => {
        #[derive(Clone, Copy, Debug)]
        pub struct $lanes($register);

        operator!($lanes: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for $lanes {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(unsafe { $xor(self.0, $splat(-0.0)) })
            }
        }

        impl Register<$element, $count> for $lanes {
            #[inline(always)]
            fn load(entries: &[$element; $count]) -> Self {
                Self(unsafe { $load(entries.as_ptr()) })
            }

            #[inline(always)]
            fn store(self, entries: &mut [$element; $count]) {
                unsafe { $store(entries.as_mut_ptr(), self.0) };
            }
        }

        impl Real for $lanes {
            type Mask = $mask;
            type Bits = $bits;
            type Scalar = $element;

            const LANES: usize = $count;
            const MANTISSA_DIGITS: u32 = <$element>::MANTISSA_DIGITS;

            #[inline(always)]
            fn splat(value: $element) -> Self {
                Self(unsafe { $splat(value) })
            }

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self::splat(value as $element)
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.lane(0)
            }

            #[inline(always)]
            fn from_lanes(mut value: impl FnMut(usize) -> f64) -> Self {
                let mut lanes = [0.0; $count];
                let mut i = 0;
                while i < $count {
                    lanes[i] = value(i) as $element;
                    i += 1;
                }
                Self(unsafe { $load(lanes.as_ptr()) })
            }

            #[inline(always)]
            fn lane(self, i: usize) -> f64 {
                let mut lanes = [0.0; $count];
                unsafe { $store(lanes.as_mut_ptr(), self.0) };
                f64::from(lanes[i])
            }

            #[inline(always)]
            fn in_every_lane(&self, i: usize) -> Self {
                let lanes: &[$element; $count] = unsafe { &*(&raw const self.0).cast() };
                Self::splat(lanes[i % $count])
            }

            #[inline(always)]
            fn select(mask: $mask, a: Self, b: Self) -> Self {
                Self(unsafe { $select(mask.0, a.0, b.0) })
            }

            #[inline(always)]
            fn from_bits(bits: $bits) -> Self {
                Self(unsafe { $from_bits(bits.0) })
            }

            #[inline(always)]
            fn to_bits(self) -> $bits {
                $bits(unsafe { $to_bits(self.0) })
            }

            #[inline(always)]
            fn outlined<P: Part>(part: P) -> P::Output {
                #[inline(never)]
                #[target_feature(enable = $feature)]
                fn compiled<P: Part>(part: P) -> P::Output {
                    part.run()
                }
                unsafe { compiled(part) }
            }

            #[inline(always)]
            fn lt(self, other: Self) -> $mask {
                $mask(unsafe { $lt(self.0, other.0) })
            }

            #[inline(always)]
            fn le(self, other: Self) -> $mask {
                $mask(unsafe { $le(self.0, other.0) })
            }

            #[inline(always)]
            fn gt(self, other: Self) -> $mask {
                other.lt(self)
            }

            #[inline(always)]
            fn ge(self, other: Self) -> $mask {
                other.le(self)
            }

            #[inline(always)]
            fn eq(self, other: Self) -> $mask {
                $mask(unsafe { $eq(self.0, other.0) })
            }

            #[inline(always)]
            fn ne(self, other: Self) -> $mask {
                $mask(unsafe { $ne(self.0, other.0) })
            }

            #[inline(always)]
            fn is_finite(self) -> $mask {
                self.abs().lt(Self::from_f64(f64::INFINITY))
            }

            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                Self(unsafe { $fused(self.0, factor.0, term.0) })
            }

            #[inline(always)]
            fn abs(self) -> Self {
                Self(unsafe { $andnot($splat(-0.0), self.0) })
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }

            elementary!($format);
        }
    };
}

lanes!(
    F64x2(__m128d),
    M64x2,
    B64x2,
    [f64; 2],
    "sse2",
    Double,
    _mm_add_pd,
    _mm_sub_pd,
    _mm_mul_pd,
    _mm_div_pd,
    _mm_sqrt_pd,
    fused_pd128,
    _mm_set1_pd,
    _mm_loadu_pd,
    _mm_storeu_pd,
    _mm_xor_pd,
    _mm_andnot_pd,
    _mm_cmplt_pd,
    _mm_cmple_pd,
    _mm_cmpeq_pd,
    _mm_cmpneq_pd,
    select_pd128,
    _mm_castpd_si128,
    _mm_castsi128_pd
);
lanes!(
    F64x4(__m256d),
    M64x4,
    B64x4,
    [f64; 4],
    "avx2,fma",
    Double,
    _mm256_add_pd,
    _mm256_sub_pd,
    _mm256_mul_pd,
    _mm256_div_pd,
    _mm256_sqrt_pd,
    _mm256_fmadd_pd,
    _mm256_set1_pd,
    _mm256_loadu_pd,
    _mm256_storeu_pd,
    _mm256_xor_pd,
    _mm256_andnot_pd,
    lt_pd256,
    le_pd256,
    eq_pd256,
    ne_pd256,
    select_pd256,
    _mm256_castpd_si256,
    _mm256_castsi256_pd
);
lanes!(
    F64x8(__m512d),
    M64x8,
    B64x8,
    [f64; 8],
    "avx512f,avx512dq",
    Double,
    _mm512_add_pd,
    _mm512_sub_pd,
    _mm512_mul_pd,
    _mm512_div_pd,
    _mm512_sqrt_pd,
    _mm512_fmadd_pd,
    _mm512_set1_pd,
    _mm512_loadu_pd,
    _mm512_storeu_pd,
    _mm512_xor_pd,
    _mm512_andnot_pd,
    lt_pd512,
    le_pd512,
    eq_pd512,
    ne_pd512,
    select_pd512,
    _mm512_castpd_si512,
    _mm512_castsi512_pd
);
lanes!(
    F32x4(__m128),
    M32x4,
    B32x4,
    [f32; 4],
    "sse2",
    Single,
    _mm_add_ps,
    _mm_sub_ps,
    _mm_mul_ps,
    _mm_div_ps,
    _mm_sqrt_ps,
    fused_ps128,
    _mm_set1_ps,
    _mm_loadu_ps,
    _mm_storeu_ps,
    _mm_xor_ps,
    _mm_andnot_ps,
    _mm_cmplt_ps,
    _mm_cmple_ps,
    _mm_cmpeq_ps,
    _mm_cmpneq_ps,
    select_ps128,
    _mm_castps_si128,
    _mm_castsi128_ps
);
lanes!(
    F32x8(__m256),
    M32x8,
    B32x8,
    [f32; 8],
    "avx2,fma",
    Single,
    _mm256_add_ps,
    _mm256_sub_ps,
    _mm256_mul_ps,
    _mm256_div_ps,
    _mm256_sqrt_ps,
    _mm256_fmadd_ps,
    _mm256_set1_ps,
    _mm256_loadu_ps,
    _mm256_storeu_ps,
    _mm256_xor_ps,
    _mm256_andnot_ps,
    lt_ps256,
    le_ps256,
    eq_ps256,
    ne_ps256,
    select_ps256,
    _mm256_castps_si256,
    _mm256_castsi256_ps
);
lanes!(
    F32x16(__m512),
    M32x16,
    B32x16,
    [f32; 16],
    "avx512f,avx512dq",
    Single,
    _mm512_add_ps,
    _mm512_sub_ps,
    _mm512_mul_ps,
    _mm512_div_ps,
    _mm512_sqrt_ps,
    _mm512_fmadd_ps,
    _mm512_set1_ps,
    _mm512_loadu_ps,
    _mm512_storeu_ps,
    _mm512_xor_ps,
    _mm512_andnot_ps,
    lt_ps512,
    le_ps512,
    eq_ps512,
    ne_ps512,
    select_ps512,
    _mm512_castps_si512,
    _mm512_castsi512_ps
);
