//! Polynomials with constant coefficients.

use super::format::Format;
use crate::real::Real;

/// `c_0 + z c_1 + z^2 c_2 + ..`, its even and its odd terms by Horner's scheme in `w = z z` side by side: one product more than Horner's
/// scheme in z, and half as long to wait for.
#[inline(always)]
pub(super) fn polynomial<F: Format, T: Real>(z: T, coefficients: &'static [f64]) -> T {
    let w = z * z;
    let mut sums = [T::zero(), T::zero()];
    for (i, &c) in coefficients.iter().enumerate().rev() {
        let c = T::from_f64(c);
        let highest = i + 2 >= coefficients.len();
        sums[i % 2] = if highest {
            c
        } else {
            F::mul_add(sums[i % 2], w, c)
        };
    }
    F::mul_add(z, sums[1], sums[0])
}
