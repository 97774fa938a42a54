//! Small dense vectors and matrices of fixed size, on the stack.
//!
//! Reductions run left to right, starting from the first product: `((a0 b0 + a1 b1) + a2 b2) + ...`, without a leading zero. Elementwise
//! operations are one operation per entry.

mod elimination;
mod matrix;
mod singular;
mod vector;

pub use matrix::Matrix;
pub use vector::Vector;

use crate::real::Real;

/// `term(0) + term(1) + ... + term(N - 1)`, left to right; 0 for `N = 0`.
#[inline]
fn sum<T: Real, const N: usize>(term: impl Fn(usize) -> T) -> T {
    if N == 0 {
        return T::zero();
    }
    let mut sum = term(0);
    for i in 1..N {
        sum = sum + term(i);
    }
    sum
}
