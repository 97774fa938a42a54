//! Constants of single precision. Polynomials are minimax, by coefficients/elementary.sollya; their errors stand beside them.

use super::format::Format;

/// Single precision.
pub(crate) struct Single;

impl Format for Single {
    const FRACTION_BITS: u32 = 23;
    const BIAS: u64 = 127;
    const ROUND: f64 = 12582912.0;
    const FIRST_HALF: u64 = 0xffff_f000;
    const NORMAL: [f64; 2] = [f32::MIN_POSITIVE as f64, f32::MAX as f64];

    // k is below 2^10; no single below 2^10 pi/2 is closer than 2^-28 to a multiple of pi/2.
    const LARGEST_ANGLE: f64 = 1600.0;
    // 14 + 14 + 14 + 24 bits, short of pi/2 by 2e-21.
    const HALF_PI: &'static [f64] = &[
        1.5706787109375,
        0.00011761486530303955,
        9.920313459588215e-10,
        6.223371969669989e-14,
    ];
    // Relative 2^-28.0.
    const SINE: &'static [f64] = &[0.16666655, -0.008332192, 0.00019518785];
    // Absolute 2^-33.0.
    const COSINE: &'static [f64] = &[0.041666646, -0.0013887314, 2.443317e-5];

    const EXPONENTS: [f64; 2] = [-104.0, 89.0];
    // 16 + 24 bits.
    const LN_2: [f64; 2] = [0.693145751953125, 1.428606765330187e-6];
    // Absolute 2^-33.1.
    const EVEN: &'static [f64] = &[0.5, 0.041666456, 0.0013935765];
    // Relative 2^-26.1.
    const ODD: &'static [f64] = &[0.16666543, 0.008366543];
    const LARGEST_HYPERBOLIC: f64 = 90.0;
    const NEGLIGIBLE: f64 = 32.0;
    // Below 24 ln 2, and 25 ln 2.
    const LARGEST_TANH: f64 = 16.6;
    const ONE_TANH: f64 = 17.33;

    // Relative 2^-34.9.
    const LOGARITHM: &'static [f64] = &[0.6666666, 0.40000847, 0.28510404, 0.24023627];
    // Relative 2^-36.7.
    const LOGARITHM_OF_POWER: &'static [f64] = &[0.6000023, 0.42820626, 0.35129845];
    const TWO_THIRDS: [f64; 2] = [0.66650390625, 0.00016276042];

    // Relative 2^-30.1.
    const RAYLEIGH: &'static [f64] = &[-4.0, -1.3333356, -0.79953974, -0.5976941];
    // Of the quotient sin(pi x) / x, absolute 2^-23.4.
    const SINE_PI: &'static [f64] = &[
        core::f32::consts::PI as f64,
        -5.1677155,
        2.5501568,
        -0.5987162,
        0.078415394,
    ];
    // Absolute 2^-29.7.
    const COSINE_PI: &'static [f64] = &[
        1.0,
        -4.934802,
        4.0587063,
        -1.33518,
        0.23479436,
        -0.024172619,
    ];

    const ANGLES: [[f64; 2]; 4] = [
        [0.4636476, 5.0121587e-9],
        [core::f32::consts::FRAC_PI_4 as f64, -2.1855694e-8],
        [0.98279375, -2.5131424e-8],
        [core::f32::consts::FRAC_PI_2 as f64, -4.371139e-8],
    ];
    const PI: [f64; 2] = [core::f32::consts::PI as f64, -8.742278e-8];
    // Relative 2^-29.6.
    const ATAN: &'static [f64] = &[
        -0.33333305,
        0.19997787,
        -0.14230311,
        0.10495117,
        -0.058279738,
    ];
    // Relative 2^-31.6.
    const ASIN: &'static [f64] = &[
        0.1666666,
        0.07500518,
        0.044514578,
        0.031825874,
        0.0143747525,
        0.037600752,
    ];
    const ORDINARY: [f64; 2] = [1e-30, 1e37];
}
