//! Counter-based noise: every draw is a pure function of (seed, purpose, run, step, channel).
//!
//! There is no generator state. Any run, step or channel can be drawn alone, in any order, on any thread, in any lane, with the same bits.
//! The generator is Philox4x32-10 (Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11). Its key is the seed,
//! low word first; its counter is
//!
//! | word | bits |
//! |---|---|
//! | 0 | step, low 32 |
//! | 1 | run, low 32 |
//! | 2 | purpose in the top 8, cell in the low 24 |
//! | 3 | run, bits 32..48, in the top 16; step, bits 32..48, in the low 16 |
//!
//! so step and run count to 2^48 and cell to 2^24; higher bits are ignored. Uniform draws take a cell for each channel, normal draws one for
//! each pair of channels, with 128 added to the purpose.

use crate::linear::Vector;
use crate::real::{Bits, Real};

/// Draws of one purpose in consecutive runs of a campaign, one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Noise<T: Real = f64> {
    seed: u64,
    purpose: Purpose,
    /// Bits 0..32 of each run's number.
    run_low: T::Bits,
    /// Bits 32..48 of it, in the place where the counter has them.
    run_high: T::Bits,
}

/// Separates streams that share seed and run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    /// Disturbances while the plant runs: step counts the plant's steps, channel its noise channels.
    Process = 0,
    /// Parameters drawn before the run: step 0, channel counts the parameters.
    Dispersion = 1,
}

/// Added to the purpose of normal draws.
const NORMAL: u32 = 128;

impl<T: Real> Noise<T> {
    /// The process noise of the runs from `first_run` on.
    #[inline(always)]
    pub fn process(seed: u64, first_run: u64) -> Self {
        Self::new(seed, Purpose::Process, first_run)
    }

    /// The parameter dispersions of the runs from `first_run` on.
    #[inline(always)]
    pub fn dispersion(seed: u64, first_run: u64) -> Self {
        Self::new(seed, Purpose::Dispersion, first_run)
    }

    #[inline(always)]
    fn new(seed: u64, purpose: Purpose, first_run: u64) -> Self {
        let run = |lane: usize| first_run.wrapping_add(lane as u64);
        Self {
            seed,
            purpose,
            run_low: T::Bits::from_lanes(|lane| run(lane) & 0xffff_ffff),
            run_high: T::Bits::from_lanes(|lane| (run(lane) >> 32 & 0xffff) << 16),
        }
    }

    /// Uniform in the open interval (0, 1): `(b + 1/2) 2^-52` with b the top 52 of the cell's first 64 bits. In single precision
    /// `(b + 1/2) 2^-23` with b the top 23 bits of the cell's second word.
    #[inline(always)]
    pub fn uniform(&self, step: u64, channel: u32) -> T {
        let [w0, w1, _, _] = self.words(self.purpose as u32, step, channel);
        open_unit(w0, w1)
    }

    /// Standard normal. Channels 2k and 2k + 1 are a pair by Box and Muller: `sqrt(-2 ln u1)` times `cos(2 pi u2)` and `sin(2 pi u2)`,
    /// with u1 from the pair's first and u2 from its last 64 bits. Magnitudes end at 8.57 (5.77 in single precision), beyond which lies
    /// 1e-17 (8e-9) of the distribution.
    #[inline(always)]
    pub fn normal(&self, step: u64, channel: u32) -> T {
        self.normal_pair(step, channel / 2)[channel as usize % 2]
    }

    /// [`Noise::normal`] of the channels 0 to N - 1.
    #[inline(always)]
    pub fn normals<const N: usize>(&self, step: u64) -> Vector<T, N> {
        let mut draws = Vector::zero();
        let mut channel = 0;
        while channel < N {
            let [even, odd] = self.normal_pair(step, channel as u32 / 2);
            draws[channel] = even;
            if channel + 1 < N {
                draws[channel + 1] = odd;
            }
            channel += 2;
        }
        draws
    }

    #[inline(always)]
    fn normal_pair(&self, step: u64, pair: u32) -> [T; 2] {
        let [w0, w1, w2, w3] = self.words(self.purpose as u32 + NORMAL, step, pair);
        let radius = (T::from_f64(-2.0) * open_unit::<T>(w0, w1).ln()).sqrt();
        let angle = T::from_f64(core::f64::consts::TAU) * open_unit(w2, w3);
        [radius * angle.cos(), radius * angle.sin()]
    }

    #[inline(always)]
    fn words(&self, purpose: u32, step: u64, cell: u32) -> [T::Bits; 4] {
        let step_high = T::Bits::splat(step >> 32 & 0xffff);
        let counter = [
            T::Bits::splat(step & 0xffff_ffff),
            self.run_low,
            T::Bits::splat(u64::from(purpose << 24 | cell & 0x00ff_ffff)),
            self.run_high.or(step_high),
        ];
        philox4x32_10(counter, [self.seed as u32, (self.seed >> 32) as u32])
    }
}

/// `(b + 1/2) 2^-52`, exact, with b the top 52 bits of the words as one number, `high` above `low`; `(b + 1/2) 2^-23` with the top 23 bits
/// of `high` for single precision. The bits b under the exponent of 2^52 are the number 2^52 + b.
#[inline(always)]
fn open_unit<T: Real>(low: T::Bits, high: T::Bits) -> T {
    let (bits, exponent, digits) = if T::MANTISSA_DIGITS == f64::MANTISSA_DIGITS {
        (high.shl(20).or(low.shr(12)), 0x433_u64 << 52, 52)
    } else {
        (high.shr(9), 0x4b00_0000, 23)
    };
    let one = T::from_f64((1_u64 << digits) as f64);
    let whole = T::from_bits(bits.or(T::Bits::splat(exponent))) - one;
    (whole + T::from_f64(0.5)) * T::from_f64(1.0 / (1_u64 << digits) as f64)
}

/// Philox with four 32-bit words and ten rounds, one counter in each lane. A round multiplies words 0 and 2 by two constants, exchanges high
/// and low halves and mixes in the key, which then advances by two Weyl constants.
#[inline(always)]
pub fn philox4x32_10<B: Bits>(counter: [B; 4], key: [u32; 2]) -> [B; 4] {
    let [mut c0, mut c1, mut c2, mut c3] = counter;
    let [mut k0, mut k1] = key;
    let mut round = 0;
    while round < 10 {
        let (low0, high0) = c0.mul_wide(B::splat(0xd251_1f53));
        let (low1, high1) = c2.mul_wide(B::splat(0xcd9e_8d57));
        c0 = high1.xor(c1).xor(B::splat(u64::from(k0)));
        c2 = high0.xor(c3).xor(B::splat(u64::from(k1)));
        (c1, c3) = (low1, low0);
        k0 = k0.wrapping_add(0x9e37_79b9);
        k1 = k1.wrapping_add(0xbb67_ae85);
        round += 1;
    }
    [c0, c1, c2, c3]
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::vec::Vec;

    use super::{NORMAL, Noise, open_unit, philox4x32_10};
    use crate::lanes::{Kernel, Width, run};
    use crate::linear::Vector;
    use crate::real::Real;

    #[test]
    fn philox_gives_the_known_answers_of_random123() {
        let check = |counter: [u32; 4], key, expected: [u32; 4]| {
            assert_eq!(philox4x32_10(counter, key), expected);
            assert_eq!(
                philox4x32_10(counter.map(u64::from), key),
                expected.map(u64::from)
            );
        };
        check(
            [0; 4],
            [0; 2],
            [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8],
        );
        check(
            [u32::MAX; 4],
            [u32::MAX; 2],
            [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd],
        );
        check(
            [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
            [0xa409_3822, 0x299f_31d0],
            [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
        );
    }

    #[test]
    fn uniform_never_reaches_its_ends() {
        let most = u64::from(u32::MAX);
        assert_eq!(open_unit::<f64>(0, 0), 0.5_f64.powi(53));
        assert_eq!(open_unit::<f64>(most, most), 1.0 - 0.5_f64.powi(53));
        assert_eq!(open_unit::<f32>(0, 0), 0.5_f32.powi(24));
        assert_eq!(open_unit::<f32>(u32::MAX, u32::MAX), 1.0 - 0.5_f32.powi(24));
    }

    #[test]
    fn every_coordinate_of_a_cell_matters() {
        let far = 1 << 40;
        let words = |noise: Noise<f64>, step, cell| noise.words(noise.purpose as u32, step, cell);
        let draws = [
            words(Noise::process(1, 2), 3, 4),
            words(Noise::dispersion(1, 2), 3, 4),
            words(Noise::process(1 + far, 2), 3, 4),
            words(Noise::process(1, 2 + far), 3, 4),
            words(Noise::process(1, 2), 3 + far, 4),
            words(Noise::process(1, 2), 3, 5),
            words(Noise::process(1, 3), 2, 4),
            Noise::<f64>::process(1, 2).words(NORMAL, 3, 4),
        ];
        assert_eq!(draws.iter().collect::<BTreeSet<_>>().len(), draws.len());
    }

    #[test]
    fn normals_have_the_moments_of_the_normal_distribution() {
        let count = 200_000_u32;
        let noise = Noise::<f64>::process(7, 3);
        let mut moments = [0.0; 4];
        for step in 0..u64::from(count) / 4 {
            for channel in 0..4 {
                let x = noise.normal(step, channel);
                for (power, moment) in moments.iter_mut().enumerate() {
                    *moment += x.powi(power as i32 + 1) / f64::from(count);
                }
            }
        }
        // Five standard errors: Var x^k is 1, 2, 15, 96 for k = 1..4.
        for (moment, (exact, variance)) in
            moments
                .into_iter()
                .zip([(0.0, 1.0), (1.0, 2.0), (0.0, 15.0), (3.0, 96.0_f64)])
        {
            assert!(
                (moment - exact).abs() < 5.0 * (variance / f64::from(count)).sqrt(),
                "{moment} for {exact}"
            );
        }
    }

    #[test]
    fn channels_and_steps_are_uncorrelated() {
        let noise = Noise::<f64>::process(11, 0);
        let count = 100_000_u64;
        let (mut across_channels, mut across_pairs, mut across_steps) = (0.0, 0.0, 0.0);
        for step in 0..count {
            across_pairs += noise.normal(step, 1) * noise.normal(step, 2);
            across_channels += noise.normal(step, 0) * noise.normal(step, 1);
            across_steps += noise.normal(step, 0) * noise.normal(step + 1, 0);
        }
        let bound = 5.0 * (count as f64).sqrt();
        for sum in [across_channels, across_pairs, across_steps] {
            assert!(f64::abs(sum) < bound);
        }
    }

    #[test]
    fn lanes_draw_consecutive_runs() {
        struct Draws;
        impl Kernel for Draws {
            type Output = Vec<[f64; 4]>;
            #[inline(always)]
            fn run<T: Real>(self) -> Self::Output {
                let first = (1 << 32) - 3;
                let noise = Noise::<T>::process(5, first);
                let Vector([a, b, c]) = noise.normals::<3>(9);
                let draws = [a, b, c, noise.uniform(9, 1)];
                (0..T::LANES).map(|i| draws.map(|x| x.lane(i))).collect()
            }
        }
        let of_run = |lane: u64| {
            let noise = Noise::<f64>::process(5, (1 << 32) - 3 + lane);
            let normal = |channel| noise.normal(9, channel);
            [normal(0), normal(1), normal(2), noise.uniform(9, 1)]
        };
        for draws in Width::ALL.iter().filter_map(|&width| run(width, Draws)) {
            assert_eq!(
                draws,
                (0..draws.len() as u64).map(of_run).collect::<Vec<_>>()
            );
        }
    }
}
