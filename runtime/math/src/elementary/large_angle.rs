//! Reduction of large angles, by the method of Payne and Hanek in integers.
//!
//! `|x| = m 2^e` with an integer m of 53 bits. Bits of 2/pi that give multiples of 4 in `m 2^e 2/pi` do not matter, and of those below, 192
//! are enough: what is left out is below 2^-137, and no double is closer than 2^-62 to a multiple of pi/2.

use super::trigonometric::Angle;

/// 64 zeros and the first 1216 bits of 2/pi.
const TWO_OVER_PI: [u64; 20] = [
    0x0000_0000_0000_0000,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
];

/// pi/2 in units of 2^-63.
const HALF_PI: u64 = 0xc90f_daa2_2168_c234;

/// The angle of x, at least 1 in magnitude; all NaN if it is infinite.
pub(super) fn reduced(x: f64) -> Angle<f64> {
    if !x.is_finite() {
        return Angle {
            r: f64::NAN,
            low: f64::NAN,
            quadrant: 0,
        };
    }
    let [top, middle, bottom] = quarter_turns(x);
    // To the nearest multiple: a fraction above 1/2 is one turn more and the complement, to within the last bit.
    let up = top >> 61 & 1;
    let quadrant = (top >> 62).wrapping_add(up);
    let flip = up.wrapping_neg();
    let fraction = [
        (top ^ flip) << 2 | (middle ^ flip) >> 62,
        (middle ^ flip) << 2 | (bottom ^ flip) >> 62,
    ];
    let (r, low) = times_half_pi(fraction);
    let negative = x.is_sign_negative();
    let sign = |value: f64, negative: bool| if negative { -value } else { value };
    Angle {
        r: sign(r, negative != (up == 1)),
        low: sign(low, negative != (up == 1)),
        quadrant: if negative {
            quadrant.wrapping_neg()
        } else {
            quadrant
        },
    }
}

/// |x| 2/pi modulo 4, in units of 2^-190, highest word first.
fn quarter_turns(x: f64) -> [u64; 3] {
    let bits = x.to_bits();
    let exponent = bits >> 52 & 0x7ff;
    let m = bits & 0x000f_ffff_ffff_ffff | 1 << 52;
    // Bit e - 1 of 2/pi gives 2 m, where e = exponent - 1075; the table begins at bit -63.
    let first = exponent as usize + 62 - 1075;
    let (word, shift) = (first / 64, first % 64);
    let window = |i: usize| {
        let both = u128::from(TWO_OVER_PI[word + i]) << 64 | u128::from(TWO_OVER_PI[word + i + 1]);
        (both << shift >> 64) as u64
    };
    let product = |i: usize| u128::from(m) * u128::from(window(i));
    let low = product(2);
    let middle = product(1) + (low >> 64);
    let high = m
        .wrapping_mul(window(0))
        .wrapping_add((middle >> 64) as u64);
    [high, middle as u64, low as u64]
}

/// `(r, low)` with r - low = fraction pi/2, of a fraction above 2^-63 in units of 2^-128, to a relative 2^-62.
fn times_half_pi(fraction: [u64; 2]) -> (f64, f64) {
    let zeros = fraction[0].leading_zeros();
    let words = u128::from(fraction[0]) << 64 | u128::from(fraction[1]);
    let leading = (words << zeros >> 64) as u64;
    let product = ((u128::from(leading) * u128::from(HALF_PI)) >> 64) as u64;
    let r = product as f64;
    let low = (r as u128 as i128 - i128::from(product)) as f64;
    // leading: 2^-64, HALF_PI: 2^-63, the half of the product dropped: 2^64, and the zeros.
    let unit = f64::from_bits(u64::from(1023 - 63 - zeros) << 52);
    (r * unit, low * unit)
}
