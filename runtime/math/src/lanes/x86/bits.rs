//! Integers of each lane.

use core::arch::x86_64::*;

use super::choice::*;
use crate::real::Bits;

/// Vectors of unsigned integers.
macro_rules! bits {
    ($bits:ident($register:ty), [$integer:ty; $count:literal], $and:ident, $or:ident, $xor:ident, $add:ident, $sub:ident, $shl:ident, $shr:ident,
     |$value:ident| $splat:expr, |$a:ident, $b:ident| $mul_wide:expr) => {
        #[derive(Clone, Copy, Debug)]
        pub struct $bits(pub(super) $register);

        impl Bits for $bits {
            #[inline(always)]
            fn splat($value: u64) -> Self {
                Self(unsafe { $splat })
            }

            #[inline(always)]
            fn from_lanes(mut value: impl FnMut(usize) -> u64) -> Self {
                let mut lanes = [0; $count];
                let mut i = 0;
                while i < $count {
                    lanes[i] = value(i) as $integer;
                    i += 1;
                }
                Self(unsafe { core::mem::transmute::<[$integer; $count], $register>(lanes) })
            }

            #[inline(always)]
            fn and(self, other: Self) -> Self {
                Self(unsafe { $and(self.0, other.0) })
            }

            #[inline(always)]
            fn or(self, other: Self) -> Self {
                Self(unsafe { $or(self.0, other.0) })
            }

            #[inline(always)]
            fn xor(self, other: Self) -> Self {
                Self(unsafe { $xor(self.0, other.0) })
            }

            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(unsafe { $add(self.0, other.0) })
            }

            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(unsafe { $sub(self.0, other.0) })
            }

            #[inline(always)]
            fn shl(self, n: u32) -> Self {
                Self(unsafe { $shl(self.0, _mm_cvtsi32_si128(n as i32)) })
            }

            #[inline(always)]
            fn shr(self, n: u32) -> Self {
                Self(unsafe { $shr(self.0, _mm_cvtsi32_si128(n as i32)) })
            }

            #[inline(always)]
            fn mul_wide(self, other: Self) -> (Self, Self) {
                let ($a, $b) = (self.0, other.0);
                let (low, high) = unsafe { $mul_wide };
                (Self(low), Self(high))
            }
        }
    };
}

/// Integers of 64 bits: one product of low halves in each lane.
macro_rules! bits64 {
    ($bits:ident($register:ty), [$integer:ty; $count:literal], $and:ident, $or:ident, $xor:ident, $add:ident, $sub:ident, $shl:ident, $shr:ident, $splat:ident, $mul:ident) => {
        bits!(
            $bits($register),
            [$integer; $count],
            $and,
            $or,
            $xor,
            $add,
            $sub,
            $shl,
            $shr,
            |value| $splat(value as i64),
            |a, b| {
                let product = $mul(a, b);
                (product, $shr(product, _mm_cvtsi32_si128(32)))
            }
        );
    };
}

/// Integers of 32 bits: products of the even and of the odd lanes, put together again.
macro_rules! bits32 {
    ($bits:ident($register:ty), [$integer:ty; $count:literal], $and:ident, $or:ident, $xor:ident, $add:ident, $sub:ident, $shl:ident, $shr:ident, $splat:ident,
     $mul:ident, $shr64:ident, $low_halves:ident, $high_halves:ident) => {
        bits!(
            $bits($register),
            [$integer; $count],
            $and,
            $or,
            $xor,
            $add,
            $sub,
            $shl,
            $shr,
            |value| $splat(value as i32),
            |a, b| {
                let half = _mm_cvtsi32_si128(32);
                let even = $mul(a, b);
                let odd = $mul($shr64(a, half), $shr64(b, half));
                ($low_halves(even, odd), $high_halves(even, odd))
            }
        );
    };
}

bits64!(
    B64x2(__m128i),
    [u64; 2],
    _mm_and_si128,
    _mm_or_si128,
    _mm_xor_si128,
    _mm_add_epi64,
    _mm_sub_epi64,
    _mm_sll_epi64,
    _mm_srl_epi64,
    _mm_set1_epi64x,
    _mm_mul_epu32
);
bits64!(
    B64x4(__m256i),
    [u64; 4],
    _mm256_and_si256,
    _mm256_or_si256,
    _mm256_xor_si256,
    _mm256_add_epi64,
    _mm256_sub_epi64,
    _mm256_sll_epi64,
    _mm256_srl_epi64,
    _mm256_set1_epi64x,
    _mm256_mul_epu32
);
bits64!(
    B64x8(__m512i),
    [u64; 8],
    _mm512_and_si512,
    _mm512_or_si512,
    _mm512_xor_si512,
    _mm512_add_epi64,
    _mm512_sub_epi64,
    _mm512_sll_epi64,
    _mm512_srl_epi64,
    _mm512_set1_epi64,
    _mm512_mul_epu32
);
bits32!(
    B32x4(__m128i),
    [u32; 4],
    _mm_and_si128,
    _mm_or_si128,
    _mm_xor_si128,
    _mm_add_epi32,
    _mm_sub_epi32,
    _mm_sll_epi32,
    _mm_srl_epi32,
    _mm_set1_epi32,
    _mm_mul_epu32,
    _mm_srl_epi64,
    low_halves128,
    high_halves128
);
bits32!(
    B32x8(__m256i),
    [u32; 8],
    _mm256_and_si256,
    _mm256_or_si256,
    _mm256_xor_si256,
    _mm256_add_epi32,
    _mm256_sub_epi32,
    _mm256_sll_epi32,
    _mm256_srl_epi32,
    _mm256_set1_epi32,
    _mm256_mul_epu32,
    _mm256_srl_epi64,
    low_halves256,
    high_halves256
);
bits32!(
    B32x16(__m512i),
    [u32; 16],
    _mm512_and_si512,
    _mm512_or_si512,
    _mm512_xor_si512,
    _mm512_add_epi32,
    _mm512_sub_epi32,
    _mm512_sll_epi32,
    _mm512_srl_epi32,
    _mm512_set1_epi32,
    _mm512_mul_epu32,
    _mm512_srl_epi64,
    low_halves512,
    high_halves512
);
