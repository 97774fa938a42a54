//! The exponential function, and the reduction that the hyperbolic functions and powers share with it.

use super::format::{Format, constants, scaled};
use super::polynomial::polynomial;
use crate::real::{Bits, Real};

/// `x = k ln 2 + r - low` with |r| <= ln 2 / 2, and `cosh r = 1 + even`, `sinh r = r + odd`.
pub(super) struct Reduced<T: Real> {
    pub(super) r: T,
    pub(super) low: T,
    pub(super) even: T,
    pub(super) odd: T,
    pub(super) k: T,
    /// k as an integer in two's complement.
    pub(super) k_bits: T::Bits,
}

impl<T: Real> Reduced<T> {
    /// Of an x whose exponential is in range, or nearly.
    #[inline(always)]
    pub(super) fn of<F: Format>(x: T) -> Self {
        Self::of_sum::<F>(x, T::zero())
    }

    /// Of x + rest.
    #[inline(always)]
    pub(super) fn of_sum<F: Format>(x: T, rest: T) -> Self {
        let round = T::from_f64(F::ROUND);
        let rounded = F::mul_add(x, T::from_f64(core::f64::consts::LOG2_E), round);
        let k = rounded - round;
        let [high, low] = constants::<T, _>(F::LN_2);
        let exact = F::mul_add(k, -high, x);
        let product = k * low - rest;
        let r = exact - product;
        let z = r * r;
        Self {
            r,
            low: product - (exact - r),
            even: z * polynomial::<F, T>(z, F::EVEN),
            odd: r * z * polynomial::<F, T>(z, F::ODD),
            k,
            k_bits: rounded.to_bits().sub(round.to_bits()),
        }
    }

    /// `e^(r - low) - 1 - r`.
    #[inline(always)]
    pub(super) fn tail(&self) -> T {
        (self.even + self.odd) - self.low
    }

    /// `e^x`.
    #[inline(always)]
    pub(super) fn exp<F: Format>(&self) -> T {
        scaled::<F, T>(T::one() + (self.r + self.tail()), self.k_bits)
    }
}

/// `x` between the exponents beyond which e^x is 0, or infinite; NaN stays.
#[inline(always)]
pub(super) fn clamped<F: Format, T: Real>(x: T) -> T {
    let [lowest, highest] = constants::<T, _>(F::EXPONENTS);
    let x = T::select(x.gt(highest), highest, x);
    T::select(x.lt(lowest), lowest, x)
}

#[inline(always)]
pub(crate) fn exp<F: Format, T: Real>(x: T) -> T {
    Reduced::of::<F>(clamped::<F, T>(x)).exp::<F>()
}
