//! Counter-based noise: every draw is a pure function of (seed, purpose, run, step, channel).
//!
//! There is no generator state. Any run, step or channel can be drawn alone, in any order, on any thread, with the same bits. The generator
//! is Philox4x32-10 (Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11). Its key is the seed, low word first;
//! its counter is
//!
//! | word | bits |
//! |---|---|
//! | 0 | step, low 32 |
//! | 1 | run, low 32 |
//! | 2 | purpose in the top 8, channel in the low 24 |
//! | 3 | run, bits 32..48, in the top 16; step, bits 32..48, in the low 16 |
//!
//! so step and run count to 2^48 and channel to 2^24; higher bits are ignored.

use crate::real::Real;

/// Draws of one purpose in one run of a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noise {
    /// Seed of the campaign.
    pub seed: u64,
    /// Number of the run.
    pub run: u64,
    /// What the draws are for.
    pub purpose: Purpose,
}

/// Separates streams that share seed and run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Disturbances while the plant runs: step counts the plant's steps, channel its noise channels.
    Process = 0,
    /// Parameters drawn before the run: step 0, channel counts the parameters.
    Dispersion = 1,
}

impl Noise {
    /// The process noise of a run.
    #[inline]
    pub fn process(seed: u64, run: u64) -> Self {
        Self {
            seed,
            run,
            purpose: Purpose::Process,
        }
    }

    /// The parameter dispersions of a run.
    #[inline]
    pub fn dispersion(seed: u64, run: u64) -> Self {
        Self {
            seed,
            run,
            purpose: Purpose::Dispersion,
        }
    }

    /// Uniform in the open interval (0, 1): `(b + 1/2) 2^-52` with b the top 52 of the cell's first 64 bits. Uses the same bits as
    /// [`Noise::normal`], so a cell (step, channel) should serve one of the two.
    #[inline]
    pub fn uniform(&self, step: u64, channel: u32) -> f64 {
        let [w0, w1, _, _] = self.words(step, channel);
        open_unit(w0, w1)
    }

    /// Standard normal by Box and Muller: `sqrt(-2 ln u1) cos(2 pi u2)`, with u1 from the cell's first and u2 from its last 64 bits. The
    /// sine of the pair is not used, so that no draw depends on another. Magnitudes end at 8.57, where the tail holds 1e-17.
    #[inline]
    pub fn normal(&self, step: u64, channel: u32) -> f64 {
        let [w0, w1, w2, w3] = self.words(step, channel);
        let radius = Real::sqrt(-2.0 * Real::ln(open_unit(w0, w1)));
        radius * Real::cos(core::f64::consts::TAU * open_unit(w2, w3))
    }

    #[inline]
    fn words(&self, step: u64, channel: u32) -> [u32; 4] {
        let purpose = (self.purpose as u32) << 24;
        let high = (((self.run >> 32) as u32) << 16) | (step >> 32) as u32 & 0xffff;
        let counter = [
            step as u32,
            self.run as u32,
            purpose | channel & 0x00ff_ffff,
            high,
        ];
        philox4x32_10(counter, [self.seed as u32, (self.seed >> 32) as u32])
    }
}

/// `(b + 1/2) 2^-52`, exact, with b the top 52 bits of the words as one number, `high` above `low`.
#[inline]
fn open_unit(low: u32, high: u32) -> f64 {
    let bits = (u64::from(high) << 32 | u64::from(low)) >> 12;
    (bits as f64 + 0.5) / (1_u64 << 52) as f64
}

/// Philox with four 32-bit words and ten rounds. A round multiplies words 0 and 2 by two constants, exchanges high and low halves and
/// mixes in the key, which then advances by two Weyl constants.
#[inline]
pub fn philox4x32_10(counter: [u32; 4], key: [u32; 2]) -> [u32; 4] {
    let [mut c0, mut c1, mut c2, mut c3] = counter;
    let [mut k0, mut k1] = key;
    for _ in 0..10 {
        let p0 = u64::from(c0) * 0xd251_1f53;
        let p1 = u64::from(c2) * 0xcd9e_8d57;
        (c0, c1, c2, c3) = (
            (p1 >> 32) as u32 ^ c1 ^ k0,
            p1 as u32,
            (p0 >> 32) as u32 ^ c3 ^ k1,
            p0 as u32,
        );
        k0 = k0.wrapping_add(0x9e37_79b9);
        k1 = k1.wrapping_add(0xbb67_ae85);
    }
    [c0, c1, c2, c3]
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{Noise, open_unit, philox4x32_10};

    #[test]
    fn philox_gives_the_known_answers_of_random123() {
        let check = |counter, key, expected| assert_eq!(philox4x32_10(counter, key), expected);
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
        assert_eq!(open_unit(0, 0), 0.5_f64.powi(53));
        assert_eq!(open_unit(u32::MAX, u32::MAX), 1.0 - 0.5_f64.powi(53));
    }

    #[test]
    fn every_coordinate_of_a_cell_matters() {
        let far = 1 << 40;
        let draws = [
            Noise::process(1, 2).words(3, 4),
            Noise::dispersion(1, 2).words(3, 4),
            Noise::process(1 + far, 2).words(3, 4),
            Noise::process(1, 2 + far).words(3, 4),
            Noise::process(1, 2).words(3 + far, 4),
            Noise::process(1, 2).words(3, 5),
            Noise::process(1, 3).words(2, 4),
        ];
        assert_eq!(draws.iter().collect::<BTreeSet<_>>().len(), draws.len());
    }

    #[test]
    fn normals_have_the_moments_of_the_normal_distribution() {
        let count = 200_000_u32;
        let noise = Noise::process(7, 3);
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
        let noise = Noise::process(11, 0);
        let count = 100_000_u64;
        let (mut across_channels, mut across_steps) = (0.0, 0.0);
        for step in 0..count {
            across_channels += noise.normal(step, 0) * noise.normal(step, 1);
            across_steps += noise.normal(step, 0) * noise.normal(step + 1, 0);
        }
        let bound = 5.0 * (count as f64).sqrt();
        assert!(f64::abs(across_channels) < bound && f64::abs(across_steps) < bound);
    }
}
