//! Products and sums of scalars with one rounding, also where `core` has none.

#[cfg(feature = "std")]
mod instruction {
    #[inline(always)]
    pub(crate) fn fused_f64(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }

    #[inline(always)]
    pub(crate) fn fused_f32(a: f32, b: f32, c: f32) -> f32 {
        a.mul_add(b, c)
    }
}
#[cfg(feature = "std")]
pub(crate) use instruction::{fused_f32, fused_f64};

#[cfg(any(test, not(feature = "std")))]
mod integer {
    /// A finite number other than 0: `(-1)^negative fraction 2^exponent`, the fraction of 53 bits.
    struct Parts {
        negative: bool,
        fraction: u64,
        exponent: i32,
    }

    fn parts(x: f64) -> Parts {
        let bits = x.to_bits();
        let (biased, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & 0x000f_ffff_ffff_ffff);
        let (fraction, exponent) = match biased {
            0 => {
                let shift = fraction.leading_zeros() as i32 - 11;
                (fraction << shift, -1074 - shift)
            }
            _ => (fraction | 1 << 52, biased - 1075),
        };
        Parts {
            negative: bits >> 63 == 1,
            fraction,
            exponent,
        }
    }

    /// By integers of 128 bits: the product of 106 bits and the term meet at the place of the lower one, or if they are too far apart the
    /// lower one is no more than a bit that says whether there is anything.
    pub(crate) fn fused_f64(a: f64, b: f64, c: f64) -> f64 {
        if a == 0.0 || b == 0.0 || !a.is_finite() || !b.is_finite() {
            return a * b + c;
        }
        if !c.is_finite() {
            return c;
        }
        let (x, y) = (parts(a), parts(b));
        let negative = x.negative != y.negative;
        // 20 places below the lowest one leave room for the bit that says whether there is anything.
        let mut high = (u128::from(x.fraction) * u128::from(y.fraction)) << 20;
        let mut exponent = x.exponent + y.exponent - 20;
        if c == 0.0 {
            return rounded(negative, high, exponent);
        }
        let z = parts(c);
        let mut low = u128::from(z.fraction) << 20;
        let mut low_exponent = z.exponent - 20;
        let (mut high_negative, mut low_negative) = (negative, z.negative);
        // The term at the same number of bits as the product.
        low <<= 53;
        low_exponent -= 53;
        if low_exponent > exponent {
            core::mem::swap(&mut high, &mut low);
            core::mem::swap(&mut exponent, &mut low_exponent);
            core::mem::swap(&mut high_negative, &mut low_negative);
        }
        let apart = (exponent - low_exponent) as u32;
        let low = match apart {
            0 => low,
            1..=126 => low >> apart | u128::from(low & ((1 << apart) - 1) != 0),
            _ => 1,
        };
        if high_negative == low_negative {
            return rounded(high_negative, high + low, exponent);
        }
        if high == low {
            return 0.0;
        }
        let (sign, difference) = if high > low {
            (high_negative, high - low)
        } else {
            (low_negative, low - high)
        };
        rounded(sign, difference, exponent)
    }

    /// The nearest number to `(-1)^negative magnitude 2^exponent`, ties to even.
    fn rounded(negative: bool, magnitude: u128, exponent: i32) -> f64 {
        let length = 128 - magnitude.leading_zeros() as i32;
        // Places below the last of a normal number of this size, or below the last of a subnormal one.
        let drop = (length - 53).max(-1074 - exponent);
        let (fraction, exponent) = if drop <= 0 {
            ((magnitude << -drop) as u64, exponent + drop)
        } else if drop > 127 {
            (0, exponent + drop)
        } else {
            let (whole, rest) = (magnitude >> drop, magnitude & ((1 << drop) - 1));
            let half = 1u128 << (drop - 1);
            let up = rest > half || rest == half && whole & 1 == 1;
            (whole as u64 + u64::from(up), exponent + drop)
        };
        // fraction is at most 2^53, and exponent at least -1074.
        let (fraction, exponent) = if fraction == 1 << 53 {
            (1 << 52, exponent + 1)
        } else {
            (fraction, exponent)
        };
        let bits = if exponent > 971 {
            f64::INFINITY.to_bits()
        } else if fraction < 1 << 52 {
            fraction
        } else {
            ((exponent + 1075) as u64) << 52 | fraction & 0x000f_ffff_ffff_ffff
        };
        f64::from_bits(bits | u64::from(negative) << 63)
    }

    /// The product is exact in double precision, and so is the term; their sum is rounded to odd, so that rounding it again is right.
    pub(crate) fn fused_f32(a: f32, b: f32, c: f32) -> f32 {
        let (product, term) = (f64::from(a) * f64::from(b), f64::from(c));
        let sum = product + term;
        if !sum.is_finite() || sum.to_bits() & 1 == 1 {
            return sum as f32;
        }
        // What rounding took from the sum (Knuth, TwoSum).
        let part = sum - product;
        let rest = (product - (sum - part)) + (term - part);
        let bits = sum.to_bits();
        let odd = if rest == 0.0 {
            bits
        } else if (rest > 0.0) == (sum > 0.0) {
            bits + 1
        } else {
            bits - 1
        };
        f64::from_bits(odd) as f32
    }
}
#[cfg(not(feature = "std"))]
pub(crate) use integer::{fused_f32, fused_f64};

#[cfg(test)]
mod tests {
    use super::integer;

    fn same(a: f64, b: f64) -> bool {
        a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
    }

    #[test]
    fn sums_by_integers_are_those_of_the_processor() {
        let mut state = 1_u64;
        let mut next = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            state ^ state >> 29
        };
        for _ in 0..300_000 {
            let [a, b, c] = [next(), next(), next()].map(f64::from_bits);
            // Sizes at which the product and the term meet, and cancel.
            let near = f64::from_bits((-(a * b)).to_bits() ^ next() >> (next() % 64));
            let small = f64::from_bits(next() & 0x801f_ffff_ffff_ffff);
            for (a, b, c) in [
                (a, b, c),
                (a, b, near),
                (a, small, c),
                (small, b, near),
                (a, 1.0 / a, small),
            ] {
                let (found, expected) = (integer::fused_f64(a, b, c), a.mul_add(b, c));
                assert!(
                    same(found, expected),
                    "{a:e} {b:e} {c:e}: {found:e} {expected:e}"
                );
            }
            let [a, b, c] = [next(), next(), next()].map(|bits| f32::from_bits(bits as u32));
            let near = f32::from_bits((-(a * b)).to_bits() ^ (next() as u32 >> (next() % 32)));
            for c in [c, near] {
                let (found, expected) = (integer::fused_f32(a, b, c), a.mul_add(b, c));
                assert!(
                    same(found.into(), expected.into()),
                    "{a:e} {b:e} {c:e}: {found:e} {expected:e}"
                );
            }
        }
        let special = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            5e-324,
            f64::MIN_POSITIVE,
            f64::MAX,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
        ];
        for a in special {
            for b in special {
                for c in special {
                    let (found, expected) = (integer::fused_f64(a, b, c), a.mul_add(b, c));
                    assert!(
                        same(found, expected),
                        "{a:e} {b:e} {c:e}: {found:e} {expected:e}"
                    );
                }
            }
        }
    }
}
