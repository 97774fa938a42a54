//! What distinguishes single from double precision: the layout of a number and the tables of constants; and products that are added to
//! something from fused ones.

use core::marker::PhantomData;

use crate::real::{Bits, Real};

/// Constants of a precision. All are exact in it.
pub(crate) trait Format {
    /// Bits of the significand after the point.
    const FRACTION_BITS: u32;
    /// What is added to an exponent.
    const BIAS: u64;
    /// Adding 3/2 of the smallest number without a fraction rounds to an integer, which is then in the low bits of the representation.
    const ROUND: f64;
    /// Zeroes the second half of the significand; the product of two numbers so cut is exact.
    const FIRST_HALF: u64;
    /// Smallest and largest normal number.
    const NORMAL: [f64; 2];

    /// Largest |x| of the usual reduction, rad, and with it the largest multiple k of pi/2.
    const LARGEST_ANGLE: f64;
    /// pi/2 as a sum; but for the last, the products of the numbers with k are exact.
    const HALF_PI: &'static [f64];
    /// `sin r = r - r z P(z)`, z = r^2, |r| up to pi/4.
    const SINE: &'static [f64];
    /// `cos r = 1 - z/2 + z^2 P(z)`, z = r^2, |r| up to pi/4.
    const COSINE: &'static [f64];

    /// Exponents beyond which e^x is 0, or infinite.
    const EXPONENTS: [f64; 2];
    /// ln 2 as a sum; the product of the first with an exponent is exact.
    const LN_2: [f64; 2];
    /// `cosh r = 1 + z P(z)`, z = r^2, |r| up to ln 2 / 2.
    const EVEN: &'static [f64];
    /// `sinh r = r + r z P(z)`, z = r^2, |r| up to ln 2 / 2.
    const ODD: &'static [f64];
    /// |x| beyond which sinh and cosh are infinite.
    const LARGEST_HYPERBOLIC: f64;
    /// k from which 2^-k is negligible beside 2^k.
    const NEGLIGIBLE: f64;
    /// Twice an argument up to which `e^2x - 1` is exact; beyond, tanh is one of the two numbers below 1, or 1.
    const LARGEST_TANH: f64;
    /// Twice the argument from which tanh is nearer to 1 than to the number below the one below it.
    const ONE_TANH: f64;

    /// `ln((1 + s)/(1 - s)) = 2 s + s z P(z)`, z = s^2, |s| up to 3 - sqrt 8.
    const LOGARITHM: &'static [f64];
    /// `3/2 ln((1 + s)/(1 - s)) / s = 3 + z + z^2 P(z)`, z = s^2, |s| up to 3 - sqrt 8.
    const LOGARITHM_OF_POWER: &'static [f64];
    /// 2/3 as a sum, the first with half of the significand.
    const TWO_THIRDS: [f64; 2];

    /// `-2 ln((1 + s)/(1 - s)) = s P(s^2)`, |s| up to 3 - sqrt 8.
    const RAYLEIGH: &'static [f64];
    /// `sin(pi x) = x P(x^2)`, |x| up to 1/2.
    const SINE_PI: &'static [f64];
    /// `cos(pi x) = P(x^2)`, |x| up to 1/2.
    const COSINE_PI: &'static [f64];

    /// Arcus tangent of 1/2, 1, 3/2 and infinity, each as a sum.
    const ANGLES: [[f64; 2]; 4];
    /// pi as a sum.
    const PI: [f64; 2];
    /// `atan y = y + y z P(z)`, z = y^2, |y| up to 7/16.
    const ATAN: &'static [f64];
    /// `asin y = y + y z P(z)`, z = y^2, |y| up to 1/2.
    const ASIN: &'static [f64];
    /// Magnitudes of the larger argument of atan2 between which no product overflows or loses digits.
    const ORDINARY: [f64; 2];

    /// `a b + c`.
    #[inline(always)]
    fn mul_add<T: Real>(a: T, b: T, c: T) -> T {
        a * b + c
    }
}

/// The same precision with products that are not rounded before they are added.
pub(crate) struct Fused<F>(PhantomData<F>);

/// The constants of another precision.
macro_rules! constants_of {
    ($format:ident: $($name:ident: $type:ty,)*) => {
        $(const $name: $type = $format::$name;)*
    };
}

impl<F: Format> Format for Fused<F> {
    constants_of! {
        F:
        FRACTION_BITS: u32,
        BIAS: u64,
        ROUND: f64,
        FIRST_HALF: u64,
        NORMAL: [f64; 2],
        LARGEST_ANGLE: f64,
        HALF_PI: &'static [f64],
        SINE: &'static [f64],
        COSINE: &'static [f64],
        EXPONENTS: [f64; 2],
        LN_2: [f64; 2],
        EVEN: &'static [f64],
        ODD: &'static [f64],
        LARGEST_HYPERBOLIC: f64,
        NEGLIGIBLE: f64,
        LARGEST_TANH: f64,
        ONE_TANH: f64,
        LOGARITHM: &'static [f64],
        LOGARITHM_OF_POWER: &'static [f64],
        TWO_THIRDS: [f64; 2],
        RAYLEIGH: &'static [f64],
        SINE_PI: &'static [f64],
        COSINE_PI: &'static [f64],
        ANGLES: [[f64; 2]; 4],
        PI: [f64; 2],
        ATAN: &'static [f64],
        ASIN: &'static [f64],
        ORDINARY: [f64; 2],
    }

    #[inline(always)]
    fn mul_add<T: Real>(a: T, b: T, c: T) -> T {
        a.mul_add(b, c)
    }
}

/// Constants in every lane. Not by `map`: what is not inlined is not compiled for the lanes' instructions.
#[inline(always)]
pub(super) fn constants<T: Real, const N: usize>(values: [f64; N]) -> [T; N] {
    let mut constants = [T::zero(); N];
    let mut i = 0;
    while i < N {
        constants[i] = T::from_f64(values[i]);
        i += 1;
    }
    constants
}

/// Shifts a bit from the place of 1 to the sign.
pub(super) const fn sign_place<F: Format>() -> u32 {
    match F::FRACTION_BITS {
        23 => 31,
        _ => 63,
    }
}

/// `2^k` for k in the range of exponents.
#[inline(always)]
pub(super) fn power_of_two<F: Format, T: Real>(k: T::Bits) -> T {
    T::from_bits(k.add(T::Bits::splat(F::BIAS)).shl(F::FRACTION_BITS))
}

/// `value 2^k`, rounded once, for k of up to twice the range of exponents: by two factors, since 2^k itself may be out of range.
#[inline(always)]
pub(super) fn scaled<F: Format, T: Real>(value: T, k: T::Bits) -> T {
    let both = k.add(T::Bits::splat(2 * F::BIAS));
    let half = both.shr(1);
    let other = both.sub(half);
    value * T::from_bits(half.shl(F::FRACTION_BITS)) * T::from_bits(other.shl(F::FRACTION_BITS))
}

/// The first half of the significand, with sign and exponent.
#[inline(always)]
pub(super) fn first_half<F: Format, T: Real>(x: T) -> T {
    T::from_bits(x.to_bits().and(T::Bits::splat(F::FIRST_HALF)))
}

/// Whether a number is positive, normal and finite.
#[inline(always)]
pub(super) fn is_normal<F: Format, T: Real>(x: T) -> T::Mask {
    use crate::real::Mask;
    let [smallest, largest] = constants::<T, _>(F::NORMAL);
    x.ge(smallest).and(x.le(largest))
}
