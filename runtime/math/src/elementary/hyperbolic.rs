//! Hyperbolic functions.

use super::exponential::Reduced;
use super::format::{Format, power_of_two, scaled};
use super::sign::with_sign;
use crate::real::{Bits, Real};

/// `(e^2a - 1) / (e^2a + 1)` with a = |x|. The exponential, the numerator and the denominator are sums of two numbers; the quotient q of the
/// leading ones is corrected by `(rest - q rest) / d`, and `1/d = (1 - q) / 2`.
#[inline(always)]
pub(crate) fn tanh<F: Format, T: Real>(x: T) -> T {
    let twice = x.abs() + x.abs();
    let largest = T::from_f64(F::LARGEST_TANH);
    let reduced = Reduced::of::<F>(T::select(twice.gt(largest), largest, twice));
    let tail = reduced.tail();
    let head = reduced.r + tail;
    let scale = power_of_two::<F, T>(reduced.k_bits);
    let e = F::mul_add(scale, head, scale);
    let rest = F::mul_add(scale, head, scale - e);
    let rest = F::mul_add(scale, (reduced.r - head) + tail, rest);
    let (numerator, denominator) = (e - T::one(), e + T::one());
    let denominator_rest = ((e - denominator) + T::one()) + rest;
    let q = numerator / denominator;
    let half = T::from_f64(0.5);
    let correction = F::mul_add(q, -denominator_rest, rest);
    let corrected = F::mul_add(correction, F::mul_add(-half, q, half), q);
    let value = T::select(twice.gt(T::from_f64(F::ONE_TANH)), T::one(), corrected);
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
    fn of<F: Format>(x: T) -> Self {
        let (a, largest) = (x.abs(), T::from_f64(F::LARGEST_HYPERBOLIC));
        let reduced = Reduced::of::<F>(T::select(a.gt(largest), largest, a));
        let Reduced {
            r, low, even, odd, ..
        } = reduced;
        let growing = T::one() + r;
        let growing_rest = (r - (growing - T::one())) + ((even + odd) - low);
        let falling = T::one() - r;
        let falling_rest = ((T::one() - falling) - r) + ((even - odd) + low);
        let twice = reduced.k_bits.add(reduced.k_bits);
        let scale = power_of_two::<F, T>(T::Bits::splat(0).sub(twice));
        let negligible = T::from_f64(F::NEGLIGIBLE);
        let scale = T::select(reduced.k.lt(negligible), scale, T::zero());
        Self {
            growing: [growing, growing_rest],
            falling: [scale * falling, scale * falling_rest],
            k_bits: reduced.k_bits,
        }
    }

    /// `value 2^(k - 1)`.
    #[inline(always)]
    fn half_scaled<F: Format>(&self, value: T) -> T {
        scaled::<F, T>(value, self.k_bits.sub(T::Bits::splat(1)))
    }
}

#[inline(always)]
pub(crate) fn sinh<F: Format, T: Real>(x: T) -> T {
    let both = Exponentials::of::<F>(x);
    let ([a, da], [b, db]) = (both.growing, both.falling);
    let difference = a - b;
    let rest = ((a - difference) - b) + (da - db);
    with_sign(both.half_scaled::<F>(difference + rest), x)
}

#[inline(always)]
pub(crate) fn cosh<F: Format, T: Real>(x: T) -> T {
    let both = Exponentials::of::<F>(x);
    let ([a, da], [b, db]) = (both.growing, both.falling);
    let sum = a + b;
    let rest = ((a - sum) + b) + (da + db);
    both.half_scaled::<F>(sum + rest)
}
