//! Inverse trigonometric functions.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::elementary::polynomial::polynomial;
use crate::elementary::sign::{is_minus, with_sign};
use crate::rare::replaced;
use crate::real::{Mask, Real};

/// Ratios from which the tangent of the next angle in [`ANGLES`] is taken off.
const RATIOS: [f64; 4] = [0.4375, 0.6875, 1.1875, 2.4375];
/// Arcus tangent of 1/2, 1, 3/2 and infinity, and what rounding took from it.
const ANGLES: [[f64; 2]; 4] = [
    [0.4636476090008061, 2.2698777452961687e-17],
    [FRAC_PI_4, 3.061616997868383e-17],
    [0.982793723247329, 1.3903311031230998e-17],
    [FRAC_PI_2, 6.123233995736766e-17],
];
/// What rounding took from pi.
const PI_REST: f64 = 1.2246467991473532e-16;
/// Magnitudes of the larger argument of atan2 between which no product overflows or loses digits.
const ORDINARY: [f64; 2] = [1e-289, 1e289];
/// 2^600.
const SCALE: f64 = 4.149515568880993e180;

/// `atan y = y + y z P(z)`, z = y^2, relative error 2^-57.7 (coefficients/elementary.sollya).
const ATAN: [f64; 11] = [
    -0.33333333333332926,
    0.1999999999987527,
    -0.14285714272404235,
    0.11111110401279878,
    -0.0909088702986288,
    0.07691874597337096,
    -0.0666105705148023,
    0.058334664969768836,
    -0.04976462786355863,
    0.036522164454061375,
    -0.01627661072423104,
];

/// `asin y = y + y z P(z)`, z = y^2, relative error 2^-59.8 (coefficients/elementary.sollya).
const ASIN: [f64; 13] = [
    0.16666666666666763,
    0.07499999999970168,
    0.04464285717519419,
    0.030381942680599038,
    0.022372215735387165,
    0.0173515988763912,
    0.01398097478014411,
    0.011397675072919054,
    0.010787057252689122,
    0.0036811649632253673,
    0.021767822118303592,
    -0.02108311275764443,
    0.03268036794109888,
];

/// Angle of the point (x, y) of the first quadrant as a sum of two numbers: `angle + atan((y - c x) / (x + c y))` where c is the tangent of
/// the angle.
#[inline(always)]
fn first_quadrant<T: Real>(y: T, x: T) -> [T; 2] {
    let beyond = RATIOS.map(|ratio| y.ge(x * T::from_f64(ratio)));
    let chosen = |values: [f64; 4]| {
        let mut chosen = T::zero();
        for (mask, value) in beyond.into_iter().zip(values) {
            chosen = T::select(mask, T::from_f64(value), chosen);
        }
        chosen
    };
    let mut c = T::zero();
    for (mask, tangent) in beyond.into_iter().zip([0.5, 1.0, 1.5]) {
        c = T::select(mask, T::from_f64(tangent), c);
    }
    let steep = beyond[3];
    let numerator = T::select(steep, -x, y - c * x);
    let q = numerator / T::select(steep, y, x + c * y);
    let z = q * q;
    let tail = q * z * polynomial(z, ATAN);
    let rest = q + (chosen(ANGLES.map(|[_, rest]| rest)) + tail);
    [chosen(ANGLES.map(|[angle, _]| angle)), rest]
}

#[inline(always)]
pub(crate) fn atan<T: Real>(x: T) -> T {
    let [angle, rest] = first_quadrant(x.abs(), T::one());
    with_sign(angle + rest, x)
}

#[inline(always)]
pub(crate) fn atan2<T: Real>(y: T, x: T) -> T {
    let usual = ordinary_atan2(y, x);
    let [smallest, largest] = ORDINARY.map(T::from_f64);
    let size = y.abs().max(x.abs());
    let ordinary = size.ge(smallest).and(size.le(largest));
    replaced(ordinary.not(), usual, [y, x], |[y, x]| unusual_atan2(y, x))
}

#[inline(always)]
fn ordinary_atan2<T: Real>(y: T, x: T) -> T {
    let [angle, rest] = first_quadrant(y.abs(), x.abs());
    let obtuse = (T::from_f64(PI) - angle) + (T::from_f64(PI_REST) - rest);
    with_sign(T::select(is_minus(x), obtuse, angle + rest), y)
}

/// atan2 of two zeros, infinities, NaN, or where the larger argument is near the ends of the range.
fn unusual_atan2(y: f64, x: f64) -> f64 {
    let to_unit = |v: f64| with_sign(if v.is_infinite() { 1.0 } else { 0.0 }, v);
    if x.is_nan() || y.is_nan() {
        f64::NAN
    } else if x == 0.0 && y == 0.0 {
        ordinary_atan2(y, with_sign(1.0, x))
    } else if x.is_infinite() || y.is_infinite() {
        ordinary_atan2(to_unit(y), to_unit(x))
    } else if f64::max(y.abs(), x.abs()) > 1.0 {
        ordinary_atan2(y / SCALE, x / SCALE)
    } else {
        ordinary_atan2(y * SCALE, x * SCALE)
    }
}

/// `asin |x| = y + rest` for |x| up to 1/2 with y = |x|; beyond, `asin |x| = pi/2 - 2 (y + rest)` with y the sine of half the complement.
struct Arcsine<T: Real> {
    y: T,
    rest: T,
    beyond: T::Mask,
}

impl<T: Real> Arcsine<T> {
    #[inline(always)]
    fn of(x: T) -> Self {
        let (a, half) = (x.abs(), T::from_f64(0.5));
        let beyond = a.gt(half);
        let z = T::select(beyond, (T::one() - a) * half, a * a);
        let y = T::select(beyond, z.sqrt(), a);
        Self {
            y,
            rest: y * z * polynomial(z, ASIN),
            beyond,
        }
    }
}

#[inline(always)]
pub(crate) fn asin<T: Real>(x: T) -> T {
    let Arcsine { y, rest, beyond } = Arcsine::of(x);
    let [right_angle, right_angle_rest] = ANGLES[3].map(T::from_f64);
    let twice = y + y;
    let complement = right_angle - twice;
    let complement_rest = ((right_angle - complement) - twice) + (right_angle_rest - (rest + rest));
    let complement = complement + complement_rest;
    with_sign(T::select(beyond, complement, y + rest), x)
}

#[inline(always)]
pub(crate) fn acos<T: Real>(x: T) -> T {
    let Arcsine { y, rest, beyond } = Arcsine::of(x);
    let (twice, twice_rest) = (y + y, rest + rest);
    let obtuse = (T::from_f64(PI) - twice) + (T::from_f64(PI_REST) - twice_rest);
    let far = T::select(x.lt(T::zero()), obtuse, twice + twice_rest);
    let [right_angle, right_angle_rest] = ANGLES[3].map(T::from_f64);
    let near = right_angle - (x - (right_angle_rest - with_sign(rest, x)));
    T::select(beyond, far, near)
}
