//! Square roots of scalars, correctly rounded, also where `core` has none.

#[cfg(target_arch = "x86_64")]
pub(crate) use crate::lanes::x86::{sqrt_f32, sqrt_f64};

#[cfg(all(not(target_arch = "x86_64"), feature = "std"))]
mod instruction {
    #[inline(always)]
    pub(crate) fn sqrt_f64(x: f64) -> f64 {
        x.sqrt()
    }

    #[inline(always)]
    pub(crate) fn sqrt_f32(x: f32) -> f32 {
        x.sqrt()
    }
}
#[cfg(all(not(target_arch = "x86_64"), feature = "std"))]
pub(crate) use instruction::{sqrt_f32, sqrt_f64};

#[cfg(any(test, all(not(target_arch = "x86_64"), not(feature = "std"))))]
mod integer {
    /// 2^54, which makes subnormal numbers normal.
    const NORMALISING: f64 = 18014398509481984.0;

    /// By the root of an integer: `x = m 2^e` with e even and an m of 108 or 109 bits has the root `sqrt(m) 2^(e/2)`, whose last place
    /// decides the rounding together with whether anything follows it.
    pub(crate) fn sqrt_f64(x: f64) -> f64 {
        if x < 0.0 {
            return f64::NAN;
        }
        if x == 0.0 || !x.is_finite() {
            return x;
        }
        let subnormal = x < f64::MIN_POSITIVE;
        let bits = if subnormal { x * NORMALISING } else { x }.to_bits();
        let fraction = bits & 0x000f_ffff_ffff_ffff | 1 << 52;
        let exponent = (bits >> 52) as i64 - if subnormal { 54 } else { 0 };
        // x = fraction 2^(exponent - 1075), and 1075 + 55 is even.
        let odd = exponent & 1;
        let m = u128::from(fraction) << (55 + odd);
        let root = m.isqrt();
        let inexact = root * root != m;
        let doubled = (root << 1 | u128::from(inexact)) as f64;
        let half = (exponent - odd - 1130) / 2 - 1;
        doubled * f64::from_bits(((half + 1023) as u64) << 52)
    }

    /// By the root in double precision, which has so many more digits that rounding twice is rounding once.
    pub(crate) fn sqrt_f32(x: f32) -> f32 {
        sqrt_f64(f64::from(x)) as f32
    }
}
#[cfg(all(not(target_arch = "x86_64"), not(feature = "std")))]
pub(crate) use integer::{sqrt_f32, sqrt_f64};

#[cfg(test)]
mod tests {
    use super::integer;

    #[test]
    fn roots_by_integers_are_those_of_the_processor() {
        let mut bits = 1_u64;
        for _ in 0..200_000 {
            bits = bits
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            let x = f64::from_bits(bits ^ bits >> 29);
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
            assert!(same(integer::sqrt_f64(x), x.sqrt()), "{x:e}");
            let square = f64::from_bits(bits >> 12 | 1 << 52) * 2.0;
            assert!(same(integer::sqrt_f64(square), square.sqrt()), "{square:e}");
            let narrow = f32::from_bits(bits as u32);
            assert!(
                same(integer::sqrt_f32(narrow).into(), narrow.sqrt().into()),
                "{narrow:e}"
            );
        }
        for x in [
            0.0,
            -0.0,
            1.0,
            4.0,
            2.25,
            5e-324,
            f64::MIN_POSITIVE,
            f64::MAX,
            f64::INFINITY,
        ] {
            assert_eq!(integer::sqrt_f64(x).to_bits(), x.sqrt().to_bits(), "{x:e}");
        }
    }
}
