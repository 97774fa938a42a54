//! Polynomials of one degree at one argument, side by side as the entries of a vector.

use crate::linear::Vector;
use crate::real::Real;

/// The values at `z` of `K` polynomials by Horner's scheme: `r = c_n`, then `r = r*z + c` for each lower power. A row holds the
/// coefficients of one power, the highest first; a power that a polynomial does not have is `-0.0`, which adds nothing to any number.
///
/// Error bound, with n rows: `1.01 * 2 (n - 1) * 2^-53 * sum |c_i| |z|^i` (Higham, Accuracy and Stability of Numerical Algorithms, (5.3)).
#[inline(always)]
pub fn horner<T: Real, const K: usize, const ROWS: usize>(rows: &[[f64; K]; ROWS], z: T) -> [T; K] {
    scheme::<T, K, ROWS, false>(rows, z)
}

/// As [`horner`] with one rounding for each power: the error is half as large.
#[inline(always)]
pub fn horner_fused<T: Real, const K: usize, const ROWS: usize>(
    rows: &[[f64; K]; ROWS],
    z: T,
) -> [T; K] {
    scheme::<T, K, ROWS, true>(rows, z)
}

#[inline(always)]
fn scheme<T: Real, const K: usize, const ROWS: usize, const FUSED: bool>(
    rows: &[[f64; K]; ROWS],
    z: T,
) -> [T; K] {
    if ROWS == 0 {
        return [T::zero(); K];
    }
    let mut values = Vector::from_f64(rows[0]);
    let mut power = 1;
    while power < ROWS {
        let coefficients = Vector::from_f64(rows[power]);
        values = if FUSED {
            values.scale_add(z, coefficients)
        } else {
            values * z + coefficients
        };
        power += 1;
    }
    values.0
}

#[cfg(test)]
mod tests {
    use super::horner;

    #[test]
    fn each_column_is_a_polynomial() {
        let rows = [[2.0, -1.0], [3.0, -0.0], [0.5, 4.0]];
        assert_eq!(
            horner(&rows, 3.0),
            [(2.0 * 3.0 + 3.0) * 3.0 + 0.5, -9.0 + 4.0]
        );
    }

    #[test]
    fn a_power_without_a_term_keeps_the_sign_of_zero() {
        let [value] = horner(&[[1.0], [-0.0]], -0.0);
        assert!(value == 0.0 && f64::is_sign_negative(value));
    }

    #[test]
    fn a_constant_is_one_at_infinity() {
        assert_eq!(horner(&[[7.0]], f64::INFINITY), [7.0]);
    }
}
