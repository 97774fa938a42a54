//! Truth values of each lane.

use core::arch::x86_64::*;

use crate::real::Mask;

/// Masks that are vectors of all ones or all zeros.
macro_rules! vector_mask {
    ($mask:ident($register:ty), [$integer:ty; $lanes:literal], $load:ident, $and:ident, $or:ident, $xor:ident, $movemask:ident) => {
        #[derive(Clone, Copy, Debug)]
        pub struct $mask(pub(super) $register);

        impl Mask for $mask {
            #[inline(always)]
            fn splat(value: bool) -> Self {
                Self::from_bits(if value { u32::MAX } else { 0 })
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
            fn not(self) -> Self {
                Self(unsafe { $xor(self.0, Self::splat(true).0) })
            }

            #[inline(always)]
            fn to_bits(self) -> u32 {
                unsafe { $movemask(self.0) as u32 }
            }

            #[inline(always)]
            fn from_bits(bits: u32) -> Self {
                let mut lanes = [0 as $integer; $lanes];
                let mut i = 0;
                while i < $lanes {
                    lanes[i] = (0 as $integer).wrapping_sub((bits >> i & 1) as $integer);
                    i += 1;
                }
                Self(unsafe { $load(lanes.as_ptr().cast()) })
            }
        }
    };
}

vector_mask!(
    M64x2(__m128d),
    [u64; 2],
    _mm_loadu_pd,
    _mm_and_pd,
    _mm_or_pd,
    _mm_xor_pd,
    _mm_movemask_pd
);
vector_mask!(
    M32x4(__m128),
    [u32; 4],
    _mm_loadu_ps,
    _mm_and_ps,
    _mm_or_ps,
    _mm_xor_ps,
    _mm_movemask_ps
);
vector_mask!(
    M64x4(__m256d),
    [u64; 4],
    _mm256_loadu_pd,
    _mm256_and_pd,
    _mm256_or_pd,
    _mm256_xor_pd,
    _mm256_movemask_pd
);
vector_mask!(
    M32x8(__m256),
    [u32; 8],
    _mm256_loadu_ps,
    _mm256_and_ps,
    _mm256_or_ps,
    _mm256_xor_ps,
    _mm256_movemask_ps
);

/// Masks of one bit for each lane.
macro_rules! bit_mask {
    ($mask:ident($integer:ty)) => {
        #[derive(Clone, Copy, Debug)]
        pub struct $mask(pub(super) $integer);

        impl Mask for $mask {
            #[inline(always)]
            fn splat(value: bool) -> Self {
                Self(if value { <$integer>::MAX } else { 0 })
            }

            #[inline(always)]
            fn and(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }

            #[inline(always)]
            fn or(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }

            #[inline(always)]
            fn not(self) -> Self {
                Self(!self.0)
            }

            #[inline(always)]
            fn to_bits(self) -> u32 {
                u32::from(self.0)
            }

            #[inline(always)]
            fn from_bits(bits: u32) -> Self {
                Self(bits as $integer)
            }
        }
    };
}

bit_mask!(M64x8(__mmask8));
bit_mask!(M32x16(__mmask16));
