//! One text for all: scalar, lanes of every width, every instruction set, every way to compile give the same bits.

#[path = "../examples/accuracy/arguments.rs"]
mod arguments;

use std::ops::Range;

use arguments::Arguments;
use nsv_math::lanes::{self, Kernel, Width};
use nsv_math::real::Real;

/// Results of the functions, those without fused products first.
const COUNT: usize = UNFUSED + 16;
const UNFUSED: usize = 18;

/// Every function at pairs of arguments, lane after lane; those of one argument take the first.
struct Everything<'a>(&'a [[f64; 2]]);

impl Kernel for Everything<'_> {
    type Output = Vec<[u64; COUNT]>;

    #[inline(always)]
    fn run<T: Real>(self) -> Self::Output {
        let mut bits = Vec::new();
        for pairs in self.0.chunks(T::LANES) {
            // Lanes beyond the last pair repeat it.
            let argument =
                |which: usize| T::from_lanes(|lane| pairs[lane.min(pairs.len() - 1)][which]);
            let results = every_function(argument(0), argument(1));
            for lane in 0..pairs.len() {
                bits.push(results.map(|result| canonical(result.lane(lane))));
            }
        }
        bits
    }
}

#[inline(always)]
fn every_function<T: Real>(x: T, y: T) -> [T; COUNT] {
    let ((sin, cos), (sin_pi, cos_pi)) = (x.sin_cos(), x.sin_cos_pi());
    let (sin_pi_fused, cos_pi_fused) = x.sin_cos_pi_fused();
    [
        x.sin(),
        x.cos(),
        x.tan(),
        x.exp(),
        x.ln(),
        x.sinh(),
        x.cosh(),
        x.tanh(),
        x.asin(),
        x.acos(),
        x.atan(),
        x.atan2(y),
        x.pow(y),
        x.rayleigh(),
        sin_pi,
        cos_pi,
        sin,
        cos,
        x.sin_fused(),
        x.cos_fused(),
        x.tan_fused(),
        x.exp_fused(),
        x.ln_fused(),
        x.sinh_fused(),
        x.cosh_fused(),
        x.tanh_fused(),
        x.asin_fused(),
        x.acos_fused(),
        x.atan_fused(),
        x.atan2_fused(y),
        x.pow_fused(y),
        x.rayleigh_fused(),
        sin_pi_fused,
        cos_pi_fused,
    ]
}

/// The representation; the sign and payload of a NaN mean nothing and differ between instructions.
fn canonical(x: f64) -> u64 {
    // Not a choice of numbers: a compiler may take any NaN for any other.
    if x.is_nan() {
        f64::NAN.to_bits()
    } else {
        x.to_bits()
    }
}

/// Random representations, special values beside ordinary ones, and pairs of special values.
fn pairs(count: u64) -> Vec<[f64; 2]> {
    let specials = [0.0, 1.0, 1e-310, 1e-40, 1e4, 1e300, f64::INFINITY, f64::NAN];
    let signed = || specials.into_iter().flat_map(|x| [x, -x]);
    let special_pairs = signed().flat_map(|x| signed().map(move |y| [x, y]));
    Arguments::of(0..count)
        .pairs(true)
        .chain(special_pairs)
        .collect()
}

#[test]
fn every_width_gives_the_bits_of_the_scalar() {
    let pairs = pairs(20_000);
    let expected = lanes::run(Width::Scalar, Everything(&pairs));
    assert_eq!(Some(lanes::run_portable(Everything(&pairs))), expected);
    for width in Width::ALL.into_iter().filter(|width| width.is_available()) {
        assert_eq!(lanes::run(width, Everything(&pairs)), expected, "{width:?}");
    }
    let expected = lanes::run_single(Width::Scalar, Everything(&pairs));
    assert_eq!(
        Some(lanes::run_portable_single(Everything(&pairs))),
        expected
    );
    for width in Width::ALL.into_iter().filter(|width| width.is_available()) {
        let found = lanes::run_single(width, Everything(&pairs));
        assert_eq!(found, expected, "{width:?}, single precision");
    }
}

/// FNV-1a over the words of some of the functions.
fn hash(results: &[[u64; COUNT]], functions: Range<usize>) -> u64 {
    let words = results.iter().flat_map(|words| &words[functions.clone()]);
    words.fold(0xcbf2_9ce4_8422_2325, |hash, word| {
        (hash ^ word).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// Two million results in all. The hashes hold on every processor and for every optimisation; a change of an algorithm changes them.
#[test]
fn results_are_those_of_every_other_machine() {
    let pairs = pairs(38_500);
    let double = lanes::run(Width::Scalar, Everything(&pairs)).expect("a scalar everywhere");
    let single = lanes::run_single(Width::Scalar, Everything(&pairs)).expect("a scalar everywhere");
    let hashes = [
        hash(&double, 0..UNFUSED),
        hash(&single, 0..UNFUSED),
        hash(&double, UNFUSED..COUNT),
        hash(&single, UNFUSED..COUNT),
    ];
    assert_eq!(
        hashes.map(|hash| format!("{hash:016x}")),
        [
            "3f1985cc9c41c200",
            "6dd7c07665e31dc5",
            "676c724e74897f8f",
            "6105d8af5c834025"
        ]
    );
}

#[test]
fn sine_and_cosine_together_are_those_alone() {
    for [x, _] in pairs(20_000) {
        let results = every_function(x, x).map(canonical);
        assert_eq!(results[16..UNFUSED], results[..2], "{x:e}");
        let results = every_function(x as f32, x as f32).map(|y| canonical(y.into()));
        assert_eq!(
            results[16..UNFUSED],
            results[..2],
            "{x:e}, single precision"
        );
    }
}
