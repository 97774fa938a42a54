//! Inverse trigonometric functions.

use super::double::Double;
use super::format::{Format, constants};
use super::polynomial::polynomial;
use super::sign::{is_minus, with_sign};
use crate::rare::replaced;
use crate::real::{Mask, Real};

/// Ratios from which the tangent of the next angle in [`Format::ANGLES`] is taken off.
const RATIOS: [f64; 4] = [0.4375, 0.6875, 1.1875, 2.4375];
/// Tangents of the finite angles.
const TANGENTS: [f64; 3] = [0.5, 1.0, 1.5];
/// 2^600.
const SCALE: f64 = 4.149515568880993e180;

/// Angle of the point (x, y) of the first quadrant as a sum of two numbers: `angle + atan((y - c x) / (x + c y))` where c is the tangent of
/// the angle.
#[inline(always)]
fn first_quadrant<F: Format, T: Real>(y: T, x: T) -> [T; 2] {
    let mut steep = T::Mask::splat(false);
    let [mut c, mut angle, mut angle_rest] = [T::zero(); 3];
    let mut i = 0;
    while i < RATIOS.len() {
        steep = y.ge(x * T::from_f64(RATIOS[i]));
        let [chosen, chosen_rest] = F::ANGLES[i];
        angle = T::select(steep, T::from_f64(chosen), angle);
        angle_rest = T::select(steep, T::from_f64(chosen_rest), angle_rest);
        if i < TANGENTS.len() {
            c = T::select(steep, T::from_f64(TANGENTS[i]), c);
        }
        i += 1;
    }
    let numerator = T::select(steep, -x, y - c * x);
    let q = numerator / T::select(steep, y, x + c * y);
    let z = q * q;
    let tail = q * z * polynomial::<F, T>(z, F::ATAN);
    [angle, q + (angle_rest + tail)]
}

#[inline(always)]
pub(crate) fn atan<F: Format, T: Real>(x: T) -> T {
    let [angle, rest] = first_quadrant::<F, T>(x.abs(), T::one());
    with_sign(angle + rest, x)
}

#[inline(always)]
pub(crate) fn atan2<F: Format, T: Real>(y: T, x: T) -> T {
    let usual = ordinary_atan2::<F, T>(y, x);
    let [smallest, largest] = constants::<T, _>(F::ORDINARY);
    let size = y.abs().max(x.abs());
    let ordinary = size.ge(smallest).and(size.le(largest));
    replaced(ordinary.not(), usual, [y, x], |[y, x]| unusual_atan2(y, x))
}

#[inline(always)]
fn ordinary_atan2<F: Format, T: Real>(y: T, x: T) -> T {
    let [angle, rest] = first_quadrant::<F, T>(y.abs(), x.abs());
    let [pi, pi_rest] = constants::<T, _>(F::PI);
    let obtuse = (pi - angle) + (pi_rest - rest);
    with_sign(T::select(is_minus(x), obtuse, angle + rest), y)
}

/// atan2 of two zeros, infinities, NaN, or where the larger argument is near the ends of the range.
fn unusual_atan2(y: f64, x: f64) -> f64 {
    let to_unit = |v: f64| with_sign(if v.is_infinite() { 1.0 } else { 0.0 }, v);
    let (y, x) = if x.is_nan() || y.is_nan() {
        return f64::NAN;
    } else if x == 0.0 && y == 0.0 {
        (y, with_sign(1.0, x))
    } else if x.is_infinite() || y.is_infinite() {
        (to_unit(y), to_unit(x))
    } else if f64::max(y.abs(), x.abs()) > 1.0 {
        (y / SCALE, x / SCALE)
    } else {
        (y * SCALE, x * SCALE)
    };
    ordinary_atan2::<Double, f64>(y, x)
}

/// `asin |x| = y + rest` for |x| up to 1/2 with y = |x|; beyond, `asin |x| = pi/2 - 2 (y + rest)` with y the sine of half the complement.
struct Arcsine<T: Real> {
    y: T,
    rest: T,
}

impl<T: Real> Arcsine<T> {
    #[inline(always)]
    fn of<F: Format>(x: T, beyond: T::Mask) -> Self {
        let (a, half) = (x.abs(), T::from_f64(0.5));
        let z = T::select(beyond, (T::one() - a) * half, a * a);
        let y = T::select(beyond, z.sqrt(), a);
        Self {
            y,
            rest: y * z * polynomial::<F, T>(z, F::ASIN),
        }
    }
}

#[inline(always)]
fn is_beyond<T: Real>(x: T) -> T::Mask {
    x.abs().gt(T::from_f64(0.5))
}

#[inline(always)]
pub(crate) fn asin<F: Format, T: Real>(x: T) -> T {
    let beyond = is_beyond(x);
    if !T::IS_SCALAR {
        asin_where::<F, T>(x, beyond)
    } else if beyond.any() {
        asin_where::<F, T>(x, T::Mask::splat(true))
    } else {
        asin_where::<F, T>(x, T::Mask::splat(false))
    }
}

/// The choices follow the mask, which is constant for a scalar.
#[inline(always)]
fn asin_where<F: Format, T: Real>(x: T, beyond: T::Mask) -> T {
    let Arcsine { y, rest } = Arcsine::of::<F>(x, beyond);
    let [right_angle, right_angle_rest] = constants::<T, _>(F::ANGLES[3]);
    let twice = y + y;
    let complement = right_angle - twice;
    let lost = (right_angle - complement) - twice;
    let complement = complement + (lost + (right_angle_rest - (rest + rest)));
    with_sign(T::select(beyond, complement, y + rest), x)
}

#[inline(always)]
pub(crate) fn acos<F: Format, T: Real>(x: T) -> T {
    let beyond = is_beyond(x);
    if !T::IS_SCALAR {
        acos_where::<F, T>(x, beyond)
    } else if beyond.any() {
        acos_where::<F, T>(x, T::Mask::splat(true))
    } else {
        acos_where::<F, T>(x, T::Mask::splat(false))
    }
}

/// The choices follow the mask, which is constant for a scalar.
#[inline(always)]
fn acos_where<F: Format, T: Real>(x: T, beyond: T::Mask) -> T {
    let Arcsine { y, rest } = Arcsine::of::<F>(x, beyond);
    let [pi, pi_rest] = constants::<T, _>(F::PI);
    let [right_angle, right_angle_rest] = constants::<T, _>(F::ANGLES[3]);
    let (twice, twice_rest) = (y + y, rest + rest);
    let obtuse = (pi - twice) + (pi_rest - twice_rest);
    let far = T::select(x.lt(T::zero()), obtuse, twice + twice_rest);
    let near = right_angle - (x - (right_angle_rest - with_sign(rest, x)));
    T::select(beyond, far, near)
}
