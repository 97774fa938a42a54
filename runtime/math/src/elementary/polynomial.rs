//! Polynomials with constant coefficients.

use crate::real::Real;

/// `c_0 + z c_1 + z^2 c_2 + ..`, its even and its odd terms by Horner's scheme in `w = z z` side by side: one product more than Horner's
/// scheme in z, and half as long to wait for.
#[inline(always)]
pub(super) fn polynomial<T: Real, const N: usize>(z: T, coefficients: [f64; N]) -> T {
    let w = z * z;
    let mut sums = [T::zero(), T::zero()];
    for i in (0..N).rev() {
        let c = T::from_f64(coefficients[i]);
        sums[i % 2] = if i + 2 < N { sums[i % 2] * w + c } else { c };
    }
    sums[0] + z * sums[1]
}
