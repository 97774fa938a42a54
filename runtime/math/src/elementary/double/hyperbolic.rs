//! Hyperbolic functions.

use super::exponential::{Reduced, power_of_two, scaled};
use crate::real::{Bits, Real};

/// The sign of a number.
const SIGN: u64 = 1 << 63;
/// Beyond it sinh and cosh are infinite.
const HIGHEST: f64 = 711.0;
/// Twice an argument up to which e^2a is below 2^53, so that `e^2a - 1` is exact; beyond it tanh is at least 1 - 2^-52.
const SATURATED: f64 = 36.7;
/// Twice the argument from which tanh is nearer to 1 than to 1 - 2^-52: 54 ln 2.
const ONE: f64 = 37.43;
/// Powers from which e^-x is below half of the last place of e^x.
const NEGLIGIBLE: f64 = 64.0;

/// The magnitude of `value` with the sign of `x`.
#[inline(always)]
fn with_sign<T: Real>(value: T, x: T) -> T {
    let sign = x.to_bits().and(T::Bits::splat(SIGN));
    T::from_bits(value.to_bits().or(sign))
}

/// `(e^2a - 1) / (e^2a + 1)` with a = |x|. The exponential, the numerator and the denominator are sums of two numbers; the quotient q of the
/// leading ones is corrected by `(rest - q rest) / d`, and `1/d = (1 - q) / 2`.
#[inline(always)]
pub(crate) fn tanh<T: Real>(x: T) -> T {
    let twice = x.abs() + x.abs();
    let saturated = T::from_f64(SATURATED);
    let reduced = Reduced::of(T::select(twice.gt(saturated), saturated, twice));
    let tail = reduced.tail();
    let head = reduced.r + tail;
    let scale = power_of_two::<T>(reduced.k_bits);
    let growth = scale * head;
    let e = scale + growth;
    let rest = ((scale - e) + growth) + scale * ((reduced.r - head) + tail);
    let (numerator, denominator) = (e - T::one(), e + T::one());
    let denominator_rest = ((e - denominator) + T::one()) + rest;
    let q = numerator / denominator;
    let half = T::from_f64(0.5);
    let correction = (rest - q * denominator_rest) * (half - half * q);
    let value = T::select(twice.gt(T::from_f64(ONE)), T::one(), q + correction);
    with_sign(value, x)
}

/// `e^a 2^-k` and `e^-a 2^-k` for a = |x|, each a sum of two numbers.
struct Exponentials<T: Real> {
    growing: [T; 2],
    falling: [T; 2],
    k_bits: T::Bits,
}

impl<T: Real> Exponentials<T> {
    #[inline(always)]
    fn of(x: T) -> Self {
        let (a, highest) = (x.abs(), T::from_f64(HIGHEST));
        let reduced = Reduced::of(T::select(a.gt(highest), highest, a));
        let Reduced {
            r, low, even, odd, ..
        } = reduced;
        let growing = T::one() + r;
        let growing_rest = (r - (growing - T::one())) + ((even + odd) - low);
        let falling = T::one() - r;
        let falling_rest = ((T::one() - falling) - r) + ((even - odd) + low);
        let twice = reduced.k_bits.add(reduced.k_bits);
        let scale = power_of_two::<T>(T::Bits::splat(0).sub(twice));
        let scale = T::select(reduced.k.lt(T::from_f64(NEGLIGIBLE)), scale, T::zero());
        Self {
            growing: [growing, growing_rest],
            falling: [scale * falling, scale * falling_rest],
            k_bits: reduced.k_bits,
        }
    }

    /// `value 2^(k - 1)`.
    #[inline(always)]
    fn half_scaled(&self, value: T) -> T {
        scaled(value, self.k_bits.sub(T::Bits::splat(1)))
    }
}

#[inline(always)]
pub(crate) fn sinh<T: Real>(x: T) -> T {
    let both = Exponentials::of(x);
    let ([a, da], [b, db]) = (both.growing, both.falling);
    let difference = a - b;
    let rest = ((a - difference) - b) + (da - db);
    with_sign(both.half_scaled(difference + rest), x)
}

#[inline(always)]
pub(crate) fn cosh<T: Real>(x: T) -> T {
    let both = Exponentials::of(x);
    let ([a, da], [b, db]) = (both.growing, both.falling);
    let sum = a + b;
    let rest = ((a - sum) + b) + (da + db);
    both.half_scaled(sum + rest)
}
