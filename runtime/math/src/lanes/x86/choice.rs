//! Comparisons that have no intrinsic of their own, and choices by mask and by place.

use core::arch::x86_64::*;

/// Comparisons that have no intrinsic of their own, and choices by mask.
macro_rules! comparisons {
    ($register:ty, $mask:ty, $compare:ident: $($name:ident $predicate:ident),*) => {$(
        #[inline(always)]
        pub(super) unsafe fn $name(a: $register, b: $register) -> $mask {
            unsafe { $compare::<$predicate>(a, b) }
        }
    )*};
}

comparisons!(__m256d, __m256d, _mm256_cmp_pd: lt_pd256 _CMP_LT_OQ, le_pd256 _CMP_LE_OQ, eq_pd256 _CMP_EQ_OQ, ne_pd256 _CMP_NEQ_UQ);
comparisons!(__m256, __m256, _mm256_cmp_ps: lt_ps256 _CMP_LT_OQ, le_ps256 _CMP_LE_OQ, eq_ps256 _CMP_EQ_OQ, ne_ps256 _CMP_NEQ_UQ);
comparisons!(__m512d, __mmask8, _mm512_cmp_pd_mask: lt_pd512 _CMP_LT_OQ, le_pd512 _CMP_LE_OQ, eq_pd512 _CMP_EQ_OQ, ne_pd512 _CMP_NEQ_UQ);
comparisons!(__m512, __mmask16, _mm512_cmp_ps_mask: lt_ps512 _CMP_LT_OQ, le_ps512 _CMP_LE_OQ, eq_ps512 _CMP_EQ_OQ, ne_ps512 _CMP_NEQ_UQ);

/// `a` where the mask is all ones, else `b`.
macro_rules! choice {
    ($name:ident, $register:ty, $mask:ty, |$m:ident, $a:ident, $b:ident| $choice:expr) => {
        #[inline(always)]
        pub(super) unsafe fn $name($m: $mask, $a: $register, $b: $register) -> $register {
            unsafe { $choice }
        }
    };
}

choice!(select_pd128, __m128d, __m128d, |m, a, b| _mm_or_pd(
    _mm_and_pd(m, a),
    _mm_andnot_pd(m, b)
));
choice!(select_ps128, __m128, __m128, |m, a, b| _mm_or_ps(
    _mm_and_ps(m, a),
    _mm_andnot_ps(m, b)
));
choice!(select_pd256, __m256d, __m256d, |m, a, b| _mm256_blendv_pd(
    b, a, m
));
choice!(select_ps256, __m256, __m256, |m, a, b| _mm256_blendv_ps(
    b, a, m
));
choice!(select_pd512, __m512d, __mmask8, |m, a, b| {
    _mm512_mask_blend_pd(m, b, a)
});
choice!(select_ps512, __m512, __mmask16, |m, a, b| {
    _mm512_mask_blend_ps(m, b, a)
});

/// Of 64-bit integers at the even and at the odd places, one half of each.
macro_rules! halves {
    ($name:ident, $register:ty, |$even:ident, $odd:ident| $halves:expr) => {
        #[inline(always)]
        pub(super) unsafe fn $name($even: $register, $odd: $register) -> $register {
            unsafe { $halves }
        }
    };
}

halves!(low_halves128, __m128i, |even, odd| {
    let (even, odd) = (_mm_castsi128_ps(even), _mm_castsi128_ps(odd));
    _mm_shuffle_epi32::<0b11_01_10_00>(_mm_castps_si128(_mm_shuffle_ps::<0b10_00_10_00>(even, odd)))
});
halves!(high_halves128, __m128i, |even, odd| {
    let (even, odd) = (_mm_castsi128_ps(even), _mm_castsi128_ps(odd));
    _mm_shuffle_epi32::<0b11_01_10_00>(_mm_castps_si128(_mm_shuffle_ps::<0b11_01_11_01>(even, odd)))
});
halves!(low_halves256, __m256i, |even, odd| {
    _mm256_blend_epi32::<0b10101010>(even, _mm256_slli_epi64::<32>(odd))
});
halves!(high_halves256, __m256i, |even, odd| {
    _mm256_blend_epi32::<0b10101010>(_mm256_srli_epi64::<32>(even), odd)
});
halves!(low_halves512, __m512i, |even, odd| {
    _mm512_mask_blend_epi32(0xaaaa, even, _mm512_slli_epi64::<32>(odd))
});
halves!(high_halves512, __m512i, |even, odd| {
    _mm512_mask_blend_epi32(0xaaaa, _mm512_srli_epi64::<32>(even), odd)
});

/// `a b + c` of each number, rounded once: by the instruction if the program is compiled for it, else one number after the other, since it
/// came after SSE2.
macro_rules! fused {
    ($name:ident, $register:ty, $instruction:ident, [$element:ty; $count:literal], $load:ident, $store:ident, $one:path) => {
        #[inline(always)]
        pub(super) unsafe fn $name(a: $register, b: $register, c: $register) -> $register {
            #[cfg(target_feature = "fma")]
            unsafe {
                $instruction(a, b, c)
            }
            #[cfg(not(target_feature = "fma"))]
            unsafe {
                let mut numbers: [[$element; $count]; 3] = [[0.0; $count]; 3];
                $store(numbers[0].as_mut_ptr(), a);
                $store(numbers[1].as_mut_ptr(), b);
                $store(numbers[2].as_mut_ptr(), c);
                let [mut a, b, c] = numbers;
                let mut i = 0;
                while i < $count {
                    a[i] = $one(a[i], b[i], c[i]);
                    i += 1;
                }
                $load(a.as_ptr())
            }
        }
    };
}

fused!(
    fused_pd128,
    __m128d,
    _mm_fmadd_pd,
    [f64; 2],
    _mm_loadu_pd,
    _mm_storeu_pd,
    crate::fused::fused_f64
);
fused!(
    fused_ps128,
    __m128,
    _mm_fmadd_ps,
    [f32; 4],
    _mm_loadu_ps,
    _mm_storeu_ps,
    crate::fused::fused_f32
);
