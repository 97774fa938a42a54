//! Small dense vectors and matrices of fixed size, on the stack.
//!
//! Reductions run left to right, starting from the first product: `((a0 b0 + a1 b1) + a2 b2) + ...`, without a leading zero. Elementwise
//! operations are one operation per entry.
//!
//! Everything is inlined into its caller, which may be compiled for an instruction set that this crate is not; so arrays are built by
//! [`array`], whose loop is, and not by the functions of `core`, which are not.

mod elimination;
mod matrix;
mod singular;
mod vector;

pub use matrix::Matrix;
pub use vector::Vector;

use crate::real::Real;

/// `[entry(0), entry(1), .., entry(N - 1)]`.
#[inline(always)]
fn array<T: Real, const N: usize>(mut entry: impl FnMut(usize) -> T) -> [T; N] {
    let mut array = [T::zero(); N];
    let mut i = 0;
    while i < N {
        array[i] = entry(i);
        i += 1;
    }
    array
}

/// Rows of entries `(i, j)`.
#[inline(always)]
fn rows<T: Real, const R: usize, const C: usize>(
    mut entry: impl FnMut(usize, usize) -> T,
) -> [[T; C]; R] {
    let mut rows = [[T::zero(); C]; R];
    let mut i = 0;
    while i < R {
        rows[i] = array(|j| entry(i, j));
        i += 1;
    }
    rows
}

/// `term(0) + term(1) + ... + term(N - 1)`, left to right; 0 for `N = 0`.
#[inline(always)]
fn sum<T: Real, const N: usize>(term: impl Fn(usize) -> T) -> T {
    if N == 0 {
        return T::zero();
    }
    let mut sum = term(0);
    let mut i = 1;
    while i < N {
        sum = sum + term(i);
        i += 1;
    }
    sum
}
