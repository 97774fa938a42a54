//! The exponential function, and the reduction that the hyperbolic functions share with it.

use crate::elementary::polynomial::polynomial;
use crate::real::{Bits, Real};

/// Beyond it e^x is infinite.
const HIGHEST: f64 = 710.0;
/// Below it e^x rounds to 0.
const LOWEST: f64 = -746.0;
/// Adding it rounds to an integer, which is then in the low bits of the representation.
const ROUND: f64 = 6755399441055744.0;
/// ln 2 = the first 42 bits, whose products with integers below 2^11 are exact, + the next 53 bits + 2e-31.
pub(super) const LN_2: [f64; 2] = [0.6931471805598903, 5.497923018708371e-14];

/// `cosh r = 1 + z P(z)`, z = r^2, absolute error 2^-57.9 (coefficients/elementary.sollya).
const EVEN: [f64; 5] = [
    0.5000000000000013,
    0.04166666666651151,
    0.0013888888947896215,
    2.4801489128885302e-05,
    2.763154562443482e-07,
];

/// `sinh r = r + r z P(z)`, relative error 2^-61.6 (coefficients/elementary.sollya).
const ODD: [f64; 5] = [
    0.16666666666666677,
    0.008333333333321447,
    0.00019841269886547956,
    2.7557243814715174e-06,
    2.5109166888151153e-08,
];

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
    /// Of |x| below 1000.
    #[inline(always)]
    pub(super) fn of(x: T) -> Self {
        let rounded = x * T::from_f64(core::f64::consts::LOG2_E) + T::from_f64(ROUND);
        let k = rounded - T::from_f64(ROUND);
        let [high, low] = LN_2.map(T::from_f64);
        let exact = x - k * high;
        let product = k * low;
        let r = exact - product;
        let z = r * r;
        Self {
            r,
            low: product - (exact - r),
            even: z * polynomial(z, EVEN),
            odd: r * z * polynomial(z, ODD),
            k,
            k_bits: rounded.to_bits().sub(T::Bits::splat(ROUND.to_bits())),
        }
    }

    /// `e^(r - low) - 1 - r`.
    #[inline(always)]
    pub(super) fn tail(&self) -> T {
        (self.even + self.odd) - self.low
    }
}

/// `value 2^k` for k from -2000 to 2000, rounded once: by two factors, since 2^k itself may be out of range.
#[inline(always)]
pub(super) fn scaled<T: Real>(value: T, k: T::Bits) -> T {
    let both = k.add(T::Bits::splat(2 * 1023));
    let half = both.shr(1);
    let factor = |exponent: T::Bits| T::from_bits(exponent.shl(52));
    value * factor(half) * factor(both.sub(half))
}

/// `2^k` for k from -1022 to 1023.
#[inline(always)]
pub(super) fn power_of_two<T: Real>(k: T::Bits) -> T {
    T::from_bits(k.add(T::Bits::splat(1023)).shl(52))
}

#[inline(always)]
pub(crate) fn exp<T: Real>(x: T) -> T {
    let (highest, lowest) = (T::from_f64(HIGHEST), T::from_f64(LOWEST));
    let x = T::select(x.gt(highest), highest, x);
    let x = T::select(x.lt(lowest), lowest, x);
    let reduced = Reduced::of(x);
    let value = T::one() + (reduced.r + reduced.tail());
    scaled(value, reduced.k_bits)
}
