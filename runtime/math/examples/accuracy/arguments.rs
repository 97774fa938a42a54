//! Arguments that cover the range of doubles, densely where functions are hard.

use std::f64::consts::{FRAC_PI_2, LN_2};
use std::ops::Range;

use nsv_math::real::Real;

/// Where functions have their ends, zeros, breaks and extremes; the last is the double that is nearest to a multiple of pi/2 for its size.
const SPECIAL: [f64; 37] = [
    0.0,
    f64::NAN,
    f64::INFINITY,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    5e-309,
    1e-310,
    1e-289,
    1e289,
    f32::MAX as f64,
    f32::MIN_POSITIVE as f64,
    1e-45,
    2e-8,
    0.25,
    0.4375,
    0.5,
    0.6875,
    1.0,
    1.1875,
    1.5,
    2.0,
    2.4375,
    3.0,
    8.66,
    18.35,
    18.715,
    19.0615,
    88.72283905206835,
    103.97207708399179,
    709.782712893384,
    710.475860073944,
    745.1332191019411,
    1600.0,
    1e5,
    4503599627370497.5,
    5.319372648326541e255,
];

/// Deterministic arguments by their number.
pub struct Arguments(Range<u64>);

impl Arguments {
    /// Those with these numbers.
    pub fn of(range: Range<u64>) -> Self {
        Self(range)
    }

    /// Pairs of arguments; of a power whose result is in range in every second pair.
    pub fn pairs(self, power: bool) -> impl Iterator<Item = [f64; 2]> {
        self.0.map(move |index| pair(index, power))
    }
}

impl Iterator for Arguments {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        self.0.next().map(argument)
    }
}

fn argument(index: u64) -> f64 {
    let (bits, unit) = (hash(index), unit(hash(!index)));
    let sign = if bits >> 63 == 1 { -1.0 } else { 1.0 };
    let magnitude = match index % 8 {
        0 => f64::from_bits(bits).abs(),
        1 => 800.0 * unit,
        2 => 20.0 * unit,
        3 => unit,
        4 => near(FRAC_PI_2 * (bits % 70_000) as f64, bits),
        5 => near(0.5 * LN_2 * (bits % 2200) as f64, bits),
        6 => 1.0 + (unit - 0.5) * f64::from_bits((1023 - bits % 53) << 52),
        _ => near(SPECIAL[(bits >> 8) as usize % SPECIAL.len()], bits),
    };
    // No signalling NaN, of which CORE-MATH says that its power 0 is not 1.
    if magnitude.is_nan() {
        f64::NAN
    } else {
        sign * magnitude
    }
}

fn pair(index: u64, power: bool) -> [f64; 2] {
    let [x, y] = [argument(2 * index), argument(2 * index + 7)];
    match index % 4 {
        0 => [x, y],
        1 if power => [
            x.abs(),
            1490.0 * (unit(hash(index)) - 0.5) / Real::ln(x.abs()),
        ],
        2 if power => [
            x.abs(),
            180.0 * (unit(hash(index)) - 0.5) / Real::ln(x.abs()),
        ],
        1 | 2 => [x, x * 4.0 * unit(hash(index))],
        _ => [unit(hash(index)), y],
    }
}

/// One of the eight numbers around.
fn near(x: f64, bits: u64) -> f64 {
    f64::from_bits(x.to_bits().wrapping_add(bits >> 20 & 7).wrapping_sub(4))
}

/// In [0, 1).
fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// SplitMix64.
fn hash(index: u64) -> u64 {
    let mut z = index.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}
