//! Counter-based noise: every draw is a pure function of (seed, purpose, run, step, channel).
//!
//! There is no generator state. Any run, step or channel can be drawn alone, in any order, on any thread, in any lane, with the same bits.
//! The generator is [`philox4x32_10`]. Its key is the seed, low word first; its counter is
//!
//! | word | bits |
//! |---|---|
//! | 0 | step, low 32 |
//! | 1 | run, low 32 |
//! | 2 | purpose in the top 8, cell in the low 24 |
//! | 3 | run, bits 32..48, in the top 16; step, bits 32..48, in the low 16 |
//!
//! so step and run count to 2^48 and cell to 2^24; higher bits are ignored. Uniform draws take a cell for each channel, normal draws,
//! with 128 added to the purpose, one for two channels, and one for four in single precision.

mod distribution;
mod philox;
mod quantile;
#[cfg(test)]
mod tests;

use crate::entries::EachPair;
use crate::linear::Vector;
use crate::real::{Bits, Real};
use distribution::{BoxMuller, is_double, joined, open_unit};
use philox::{Keys, encrypt, encrypted, round_keys};
use quantile::normal_quantile;

pub use philox::philox4x32_10;

/// Runs that noise tells apart: a larger number of a run draws what a smaller one does.
pub const RUNS: u64 = 1 << 48;

/// Draws of one purpose in consecutive runs of a campaign, one in each lane.
#[derive(Clone, Copy, Debug)]
pub struct Noise<T: Real = f64> {
    keys: Keys,
    purpose: Purpose,
    /// Bits 0..32 of each run's number, below bits that mean nothing.
    run_low: T::Bits,
    /// Bits 32..48 of it, in the place where the counter has them, below bits that mean nothing.
    run_high: T::Bits,
}

/// Separates streams that share seed and run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    /// Disturbances while the plant runs: step counts the plant's steps, channel its noise channels.
    Process = 0,
    /// What is drawn before the run: step 0, channel counts parameters, then initial states, then biases of sensors.
    Dispersion = 1,
    /// Errors of sensors: step counts the controller's samples, channel the sensors.
    Sensor = 2,
}

/// Added to the purpose of normal draws.
const NORMAL: u32 = 128;

impl<T: Real> Noise<T> {
    /// The process noise of the runs from `first_run` on.
    #[inline(always)]
    pub fn process(seed: u64, first_run: u64) -> Self {
        Self::new(seed, Purpose::Process, first_run)
    }

    /// The dispersions of the runs from `first_run` on.
    #[inline(always)]
    pub fn dispersion(seed: u64, first_run: u64) -> Self {
        Self::new(seed, Purpose::Dispersion, first_run)
    }

    /// The sensor errors of the runs from `first_run` on.
    #[inline(always)]
    pub fn sensor(seed: u64, first_run: u64) -> Self {
        Self::new(seed, Purpose::Sensor, first_run)
    }

    #[inline(always)]
    fn new(seed: u64, purpose: Purpose, first_run: u64) -> Self {
        let run = |lane: usize| first_run.wrapping_add(lane as u64);
        Self {
            keys: round_keys([seed as u32, (seed >> 32) as u32]),
            purpose,
            run_low: T::Bits::from_lanes(run),
            run_high: T::Bits::from_lanes(|lane| run(lane) >> 32 << 16),
        }
    }

    /// Uniform in the open interval (0, 1): `(b + 1/2) 2^-52` with b the top 52 of the cell's first 64 bits. In single precision
    /// `(b + 1/2) 2^-23` with b the top 23 bits of the cell's second word.
    #[inline(always)]
    pub fn uniform(&self, step: u64, channel: u32) -> T {
        let [low, high, _, _] = self.words(self.purpose as u32, step, channel);
        open_unit(if is_double::<T>() {
            joined(high, low)
        } else {
            high
        })
    }

    /// Standard normal. Channels 2k and 2k + 1 are a pair by Box and Muller: `±sqrt(-2 ln u) cos(pi h)` and `sqrt(-2 ln u) sin(pi h)` with
    ///
    /// | | u | h | sign |
    /// |---|---|---|---|
    /// | double | `(b + 1/2) 2^-52`, b the top 52 of the pair's first 64 bits | `(b + 1/2) 2^-51 - 1/2`, b the bits 1..52 of the other 64 | bit 63 |
    /// | single | `(b + 1/2) 2^-23`, b the top 23 of the pair's first 32 bits | `(b + 1/2) 2^-22 - 1/2`, b the bits 1..23 of the other 32 | bit 31 |
    ///
    /// Magnitudes end at 8.57 (5.77 in single precision), beyond which lies 1e-17 (8e-9) of the distribution.
    #[inline(always)]
    pub fn normal(&self, step: u64, channel: u32) -> T {
        let (pair, pairs) = (channel / 2, Self::PAIRS as u32);
        let block = self.words(self.purpose as u32 + NORMAL, step, pair / pairs);
        let [first, second] = Self::bits_of_pair(&[block], (pair % pairs) as usize);
        BoxMuller::<false>.of(first, second)[channel as usize % 2]
    }

    /// Standard normal between its quantiles of the probabilities `low` and `high`.
    #[inline(always)]
    pub fn normal_between(&self, step: u64, channel: u32, low: f64, high: f64) -> T {
        let share = self.uniform(step, channel) * T::from_f64(high - low);
        normal_quantile(T::from_f64(low) + share)
    }

    /// [`Noise::normal`] of the channels 0 to N - 1.
    #[inline(always)]
    pub fn normals<const N: usize>(&self, step: u64) -> Vector<T, N> {
        self.all_normals::<false, N>(step)
    }

    /// [`Noise::normals`], whose products are fused with sums.
    #[inline(always)]
    pub fn normals_fused<const N: usize>(&self, step: u64) -> Vector<T, N> {
        self.all_normals::<true, N>(step)
    }

    #[inline(always)]
    fn all_normals<const FUSED: bool, const N: usize>(&self, step: u64) -> Vector<T, N> {
        let mut blocks = [[T::Bits::splat(0); 4]; N];
        let mut cell = 0;
        while cell < N.div_ceil(2).div_ceil(Self::PAIRS) {
            blocks[cell] = self.counter(self.purpose as u32 + NORMAL, step, cell as u32);
            cell += 1;
        }
        encrypt(&mut blocks, cell, &self.keys);
        if T::IS_SCALAR {
            Self::packed_normals::<FUSED, N>(&blocks)
        } else {
            Self::normals_of_each::<FUSED, N>(&blocks)
        }
    }

    /// Pair after pair.
    #[inline(always)]
    fn normals_of_each<const FUSED: bool, const N: usize>(
        blocks: &[[T::Bits; 4]; N],
    ) -> Vector<T, N> {
        let mut draws = Vector::zero();
        let mut channel = 0;
        while channel < N {
            let [first, second] = Self::bits_of_pair(blocks, channel / 2);
            let [even, odd] = BoxMuller::<FUSED>.of(first, second);
            draws[channel] = even;
            if channel + 1 < N {
                draws[channel + 1] = odd;
            }
            channel += 2;
        }
        draws
    }

    /// Several pairs in a register.
    #[inline(always)]
    fn packed_normals<const FUSED: bool, const N: usize>(
        blocks: &[[T::Bits; 4]; N],
    ) -> Vector<T, N> {
        let (mut even, mut odd) = ([T::zero(); N], [T::zero(); N]);
        let mut pair = 0;
        while pair < N.div_ceil(2) {
            [even[pair], odd[pair]] = Self::bits_of_pair(blocks, pair);
            pair += 1;
        }
        T::each_pair(BoxMuller::<FUSED>, &mut even[..pair], &mut odd[..pair]);
        let mut draws = Vector::zero();
        let mut channel = 0;
        while channel < N {
            let half = if channel % 2 == 0 { &even } else { &odd };
            draws[channel] = half[channel / 2];
            channel += 1;
        }
        draws
    }

    /// Pairs of normal draws that the words of a cell make.
    const PAIRS: usize = if is_double::<T>() { 1 } else { 2 };

    /// The random bits of a pair, as representations.
    #[inline(always)]
    fn bits_of_pair(blocks: &[[T::Bits; 4]], pair: usize) -> [T; 2] {
        let [w0, w1, w2, w3] = blocks[pair / Self::PAIRS];
        let [first, second] = if is_double::<T>() {
            [joined(w0, w1), joined(w2, w3)]
        } else if pair.is_multiple_of(2) {
            [w0, w1]
        } else {
            [w2, w3]
        };
        [T::from_bits(first), T::from_bits(second)]
    }

    #[inline(always)]
    fn words(&self, purpose: u32, step: u64, cell: u32) -> [T::Bits; 4] {
        encrypted(self.counter(purpose, step, cell), &self.keys)
    }

    #[inline(always)]
    fn counter(&self, purpose: u32, step: u64, cell: u32) -> [T::Bits; 4] {
        let step_high = T::Bits::splat(step >> 32 & 0xffff);
        [
            T::Bits::splat(step),
            self.run_low,
            T::Bits::splat(u64::from(purpose << 24 | cell & 0x00ff_ffff)),
            self.run_high.or(step_high),
        ]
    }
}
