//! Uniform and normal numbers of random words.

use crate::entries::EachPair;
use crate::real::{Bits, Real};

/// Whether the numbers have 64 bits, so that two words make one.
pub(super) const fn is_double<T: Real>() -> bool {
    T::MANTISSA_DIGITS == f64::MANTISSA_DIGITS
}

/// Bits of a significand after the point.
const fn digits<T: Real>() -> u32 {
    T::MANTISSA_DIGITS - 1
}

/// One number of 64 bits in each lane.
#[inline(always)]
pub(super) fn joined<B: Bits>(high: B, low: B) -> B {
    high.shl(32).or(low.and(B::splat(0xffff_ffff)))
}

/// `(b + 1/2) 2^-n`, exact, with b the top n of 64 bits; n is 52. In single precision the top 23 of 32 bits. The bits b below the exponent
/// of 1 are the number `1 + b 2^-n`.
#[inline(always)]
pub(super) fn open_unit<T: Real>(bits: T::Bits) -> T {
    let exponent = T::one().to_bits();
    let unused = if is_double::<T>() { 12 } else { 9 };
    let half = 0.5 / (1_u64 << digits::<T>()) as f64;
    T::from_bits(bits.shr(unused).or(exponent)) - T::from_f64(1.0 - half)
}

/// `(b + 1/2) 2^(1 - n) - 1/2`, exact, with b the low n bits without the last.
#[inline(always)]
fn half_turns<T: Real>(bits: T::Bits) -> T {
    let b = bits.and(T::Bits::splat((1 << digits::<T>()) - 2));
    let exponent_and_half = T::one().to_bits().or(T::Bits::splat(1));
    T::from_bits(b.or(exponent_and_half)) - T::from_f64(1.5)
}

/// A pair of standard normal numbers by Box and Muller: `±sqrt(-2 ln u) cos(pi h)` and `sqrt(-2 ln u) sin(pi h)` with u of the first bits, h
/// between -1/2 and 1/2 and the sign of the second; with products fused with sums if it is `FUSED`.
#[derive(Clone, Copy)]
pub(super) struct BoxMuller<const FUSED: bool>;

impl<const FUSED: bool> EachPair for BoxMuller<FUSED> {
    /// Of representations, results are numbers.
    #[inline(always)]
    fn of<T: Real>(self, first: T, second: T) -> [T; 2] {
        let (u, h) = (
            open_unit::<T>(first.to_bits()),
            half_turns::<T>(second.to_bits()),
        );
        let (radius, (sine, cosine)) = if FUSED {
            (u.rayleigh_fused(), h.sin_cos_pi_fused())
        } else {
            (u.rayleigh(), h.sin_cos_pi())
        };
        let sign = second.to_bits().and(T::from_f64(-0.0).to_bits());
        let signed = (radius * cosine).to_bits().xor(sign);
        [T::from_bits(signed), radius * sine]
    }
}

#[cfg(test)]
mod tests {
    use super::{half_turns, open_unit};

    #[test]
    fn uniform_never_reaches_its_ends() {
        assert_eq!(open_unit::<f64>(0), 0.5_f64.powi(53));
        assert_eq!(open_unit::<f64>(u64::MAX), 1.0 - 0.5_f64.powi(53));
        assert_eq!(open_unit::<f32>(0), 0.5_f32.powi(24));
        assert_eq!(open_unit::<f32>(u32::MAX), 1.0 - 0.5_f32.powi(24));
    }

    #[test]
    fn half_turns_are_symmetric_and_never_reach_their_ends() {
        let end = 0.5 - 0.5_f64.powi(52);
        assert_eq!(half_turns::<f64>(0), -end);
        assert_eq!(half_turns::<f64>(u64::MAX), end);
        let end = 0.5 - 0.5_f32.powi(23);
        assert_eq!(half_turns::<f32>(0), -end);
        assert_eq!(half_turns::<f32>(u32::MAX), end);
    }
}
