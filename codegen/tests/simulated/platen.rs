//! Platen's scheme in the emitted simulator, on a plant where some noise depends on states and some does not, against the scheme written
//! out once more in plain numbers: equations of `tests/specs/mixed_noise.yaml`, draws of Philox by Box and Muller, and
//!
//! `x' = x + f h + sum_j g_j dw_j + sum_j (g_j(x + f h + g_j sqrt(h)) - g_j(x)) (dw_j^2 - h) / (2 sqrt(h))`
//!
//! for every column j (Kloeden and Platen, 1992, (11.1.7) with the diagonal of its double integrals), dependent on states or not.

use super::program::{Columns, check_campaign, flown};

const NAME: &str = "mixed_noise";
/// Seed of the specification.
const SEED: u64 = 11;
/// Length of a plant step, s, and plant steps of a sample.
const STEP: f64 = 0.001;
const SUBSTEPS: usize = 2;
/// Steps after which the plant has forgotten a rounding: its poles lie left of -0.4 1/s.
const FORGOTTEN: f64 = 1.0 / (0.4 * STEP);
/// Roundings of the size of a state in a step: those of the additions of its increments. Others come in times the step or its root.
const ROUNDINGS: f64 = 8.0;

/// a_1, a_2, b_1, b_2, then the exosystems.
type State = [f64; 7];
const START: State = [0.4, -0.3, 0.2, 0.5, 0.3, 0.0, 0.0];
const NAMES: [&str; 4] = ["x1.a1", "x1.a2", "x2.b1", "x2.b2"];
const CHANNELS: usize = 5;

fn drift([a1, a2, b1, b2, w1, w2, w3]: &State, u: [f64; 2]) -> State {
    [
        -0.5 * a1 + 0.3 * a2.sin() + 2.0 * b1,
        0.2 * a1 - 0.6 * a2 + 0.3 * b1 + 1.5 * b2,
        0.2 * a1 - b1 + 3.0 * u[0] + w1,
        0.1 * a2 * b1 - 2.0 * b2 + 0.4 * a1.cos() * u[0] + 4.0 * u[1] + (w2 + 0.5 * w3),
        -0.5 * w1,
        2.0 * w3,
        -2.0 * w2 - 0.4 * w3,
    ]
}

/// State that a channel drives, and by how much.
fn diffusion([a1, a2, _, b2, ..]: &State, channel: usize) -> (usize, f64) {
    match channel {
        0 => (0, (0.3 + 0.2 * a1.sin() + 0.1 * a2) * 0.5),
        1 => (2, 0.2 * 0.6),
        2 => (3, 0.5 * (1.0 + a2 * a2) * (1.0 + b2 * b2).sqrt() * 0.8),
        3 => (4, 0.4),
        _ => (6, 0.3),
    }
}

/// Philox4x32-10 (Salmon and others, 2011).
fn philox(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    for _ in 0..10 {
        let first = u64::from(counter[0]) * 0xd251_1f53;
        let second = u64::from(counter[2]) * 0xcd9e_8d57;
        counter = [
            (second >> 32) as u32 ^ counter[1] ^ key[0],
            second as u32,
            (first >> 32) as u32 ^ counter[3] ^ key[1],
            first as u32,
        ];
        key = [
            key[0].wrapping_add(0x9e37_79b9),
            key[1].wrapping_add(0xbb67_ae85),
        ];
    }
    counter
}

/// Standard normal draws of a step by Box and Muller, two of each counter: purpose 128 is normal process noise.
fn normals(run: u64, step: u64) -> [f64; CHANNELS] {
    let pair = |pair: u32| {
        let counter = [step as u32, run as u32, 128 << 24 | pair, 0];
        let words = philox(counter, [SEED as u32, 0]).map(u64::from);
        let [first, second] = [0, 2].map(|at| words[at] << 32 | words[at + 1]);
        let uniform = ((first >> 12) as f64 + 0.5) * 0.5_f64.powi(52);
        let turns = (((second & ((1 << 52) - 1)) >> 1) as f64 + 0.5) * 0.5_f64.powi(51) - 0.5;
        let radius = (-2.0 * uniform.ln()).sqrt();
        let (sine, cosine) = (std::f64::consts::PI * turns).sin_cos();
        let sign = if second >> 63 == 1 { -1.0 } else { 1.0 };
        [sign * radius * cosine, radius * sine]
    };
    let pairs = [pair(0), pair(1), pair(2)];
    std::array::from_fn(|channel| pairs[channel / 2][channel % 2])
}

/// A step of Platen's scheme, or of Euler and Maruyama's without its correction.
fn advance(x: &State, f: &State, dw: [f64; CHANNELS], corrected: bool) -> State {
    let root = STEP.sqrt();
    let drifted: State = std::array::from_fn(|i| x[i] + f[i] * STEP);
    let mut next = drifted;
    for (channel, dw) in dw.into_iter().enumerate() {
        let (at, here) = diffusion(x, channel);
        let mut support = drifted;
        support[at] += here * root;
        let (_, there) = diffusion(&support, channel);
        next[at] += here * dw;
        if corrected {
            next[at] += (there - here) * (dw * dw - STEP) / (2.0 * root);
        }
    }
    next
}

/// Largest difference of each state from the run's, over its samples; the first with the scheme's correction, the second without; and
/// the largest state.
fn differences(run: &Columns, number: u64) -> ([f64; 2], f64) {
    let (mut largest, mut worst) = (0.0_f64, [0.0_f64; 2]);
    let states = |sample: usize| NAMES.map(|name| run[name][sample]);
    let control = |sample: usize| ["u_sat.first", "u_sat.last"].map(|name| run[name][sample]);
    for (corrected, worst) in [true, false].into_iter().zip(&mut worst) {
        let mut x = START;
        for sample in 0..run["t"].len() {
            for (expected, found) in states(sample).iter().zip(&x) {
                *worst = worst.max((found - expected).abs());
                largest = largest.max(expected.abs());
            }
            for substep in 0..SUBSTEPS {
                let dw = normals(number, (sample * SUBSTEPS + substep) as u64);
                let dw = dw.map(|draw| draw * STEP.sqrt());
                x = advance(&x, &drift(&x, control(sample)), dw, corrected);
            }
        }
    }
    (worst, largest)
}

#[test]
fn a_plant_with_mixed_noise_flies_by_platens_scheme() {
    for number in [0, 5] {
        let run = flown(NAME, number, &["--no-dispersion"]);
        let ([platen, euler], largest) = differences(&run, number);
        let allowed = ROUNDINGS * FORGOTTEN * f64::EPSILON * largest;
        assert!(platen <= allowed, "off by {platen}, allowed {allowed}");
        assert!(
            euler > 1e6 * allowed,
            "without its correction off by {euler}"
        );
    }
}

#[test]
fn lanes_fly_platens_scheme_alike() {
    check_campaign(NAME, &[]);
}
