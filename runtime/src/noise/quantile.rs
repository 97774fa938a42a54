//! Quantiles of the standard normal distribution.

use crate::real::{Mask, Real};

/// The number that a standard normal draw stays below with probability `p`, relative error about 1e-16; infinite at 0 and 1.
///
/// Algorithm AS 241 (PPND16): M. J. Wichura, *The percentage points of the normal distribution*, Applied Statistics 37 (1988), 477-484.
#[inline(always)]
pub(super) fn normal_quantile<T: Real>(p: T) -> T {
    let real = T::from_f64;
    let q = p - real(0.5);
    let r = real(0.180_625) - q * q;
    let central = q * ratio(&CENTRAL, r);
    let tail = (-p.min(T::one() - p).ln()).sqrt();
    let near = ratio(&NEAR, tail - real(1.6));
    let far = ratio(&FAR, tail - real(5.0));
    let outside = T::select(tail.le(real(5.0)), near, far);
    let signed = T::select(q.lt(T::zero()), -outside, outside);
    let inside = q.abs().le(real(0.425));
    let finite = inside.or(p.gt(T::zero()).and(p.lt(T::one())));
    let ends = q * real(f64::INFINITY);
    T::select(inside, central, T::select(finite, signed, ends))
}

/// Quotient of two polynomials.
#[inline(always)]
fn ratio<T: Real>([above, below]: &[[f64; 8]; 2], r: T) -> T {
    polynomial(above, r) / polynomial(below, r)
}

/// A polynomial by Horner's scheme, coefficients from the constant on.
#[inline(always)]
fn polynomial<T: Real>(coefficients: &[f64; 8], r: T) -> T {
    let mut sum = T::from_f64(coefficients[7]);
    let mut power = 7;
    while power > 0 {
        power -= 1;
        sum = sum * r + T::from_f64(coefficients[power]);
    }
    sum
}

const CENTRAL: [[f64; 8]; 2] = [
    [
        3.387_132_872_796_366_5,
        133.141_667_891_784_38,
        1_971.590_950_306_551_3,
        13_731.693_765_509_46,
        45_921.953_931_549_87,
        67_265.770_927_008_7,
        33_430.575_583_588_13,
        2_509.080_928_730_122_7,
    ],
    [
        1.0,
        42.313_330_701_600_91,
        687.187_007_492_057_9,
        5_394.196_021_424_751,
        21_213.794_301_586_597,
        39_307.895_800_092_71,
        28_729.085_735_721_943,
        5_226.495_278_852_854,
    ],
];

const NEAR: [[f64; 8]; 2] = [
    [
        1.423_437_110_749_683_5,
        4.630_337_846_156_546,
        5.769_497_221_460_691,
        3.647_848_324_763_204_5,
        1.270_458_252_452_368_4,
        0.241_780_725_177_450_6,
        0.022_723_844_989_269_184,
        7.745_450_142_783_414e-4,
    ],
    [
        1.0,
        2.053_191_626_637_759,
        1.676_384_830_183_803_8,
        0.689_767_334_985_1,
        0.148_103_976_427_480_08,
        0.015_198_666_563_616_457,
        5.475_938_084_995_345e-4,
        1.050_750_071_644_416_8e-9,
    ],
];

const FAR: [[f64; 8]; 2] = [
    [
        6.657_904_643_501_103,
        5.463_784_911_164_114,
        1.784_826_539_917_291_3,
        0.296_560_571_828_504_87,
        0.026_532_189_526_576_124,
        0.001_242_660_947_388_078_4,
        2.711_555_568_743_487_6e-5,
        2.010_334_399_292_288_1e-7,
    ],
    [
        1.0,
        0.599_832_206_555_888,
        0.136_929_880_922_735_8,
        0.014_875_361_290_850_615,
        7.868_691_311_456_133e-4,
        1.846_318_317_510_054_8e-5,
        1.421_511_758_316_446e-7,
        2.044_263_103_389_939_8e-15,
    ],
];

#[cfg(test)]
mod tests {
    use super::normal_quantile;

    /// Percentage points to sixteen digits, from 50-digit arithmetic (mpmath: the root of erfc(-x/sqrt 2)/2 - p).
    const POINTS: [(f64, f64); 7] = [
        (0.5, 0.0),
        (0.6, 0.253_347_103_135_799_8),
        (0.9, 1.281_551_565_544_600_4),
        (0.975, 1.959_963_984_540_054),
        (0.999, 3.090_232_306_167_813_5),
        (1e-10, -6.361_340_902_404_056),
        (1e-100, -21.273_453_560_965_324),
    ];

    #[test]
    fn quantiles_agree_with_high_precision() {
        for (p, expected) in POINTS {
            let found = normal_quantile(p);
            assert!(
                (found - expected).abs() <= 1e-15 * expected.abs().max(1.0),
                "{p}: {found}"
            );
        }
    }

    #[test]
    fn quantiles_are_odd_about_one_half_and_infinite_at_the_ends() {
        for p in [0.25, 0.125, 0.0625, 0.5_f64.powi(10)] {
            assert_eq!(normal_quantile(p), -normal_quantile(1.0 - p));
        }
        assert_eq!(normal_quantile(0.0), f64::NEG_INFINITY);
        assert_eq!(normal_quantile(1.0), f64::INFINITY);
        assert!(normal_quantile(f64::NAN).is_nan());
    }
}
