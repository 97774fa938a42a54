//! Rounding to the multiples that actuators and sensors know.

use crate::real::Real;

/// The multiple of `quantum` nearest to a number, of two the even one; the number itself beyond 2^51 quanta (2^22 in single precision).
#[inline(always)]
pub(crate) fn to_multiple<T: Real>(x: T, quantum: f64) -> T {
    // Adding 1.5 2^(p - 1) leaves no room for a fraction in p digits.
    let largest = (1_u64 << (T::MANTISSA_DIGITS - 2)) as f64;
    let shift = T::from_f64(3.0 * largest);
    let quanta = x / T::from_f64(quantum);
    let rounded = (quanta + shift) - shift;
    let whole = quanta.abs().lt(T::from_f64(largest));
    T::select(whole, rounded * T::from_f64(quantum), x)
}

#[cfg(test)]
mod tests {
    use super::to_multiple;

    #[test]
    fn the_nearest_multiple_is_taken_and_ties_go_to_even() {
        for (x, expected) in [
            (0.7, 0.5),
            (-0.8, -1.0),
            (0.25, 0.0),
            (0.75, 1.0),
            (0.0, 0.0),
        ] {
            assert_eq!(to_multiple(x, 0.5), expected);
            assert_eq!(f64::from(to_multiple(x as f32, 0.5)), expected);
        }
        assert_eq!(to_multiple(1e300, 0.5), 1e300);
        assert!(to_multiple(f64::NAN, 0.5).is_nan());
    }
}
