//! Linear equations: adjugate times the reciprocal of the determinant up to three unknowns, else elimination with partial pivoting.

#![expect(
    clippy::needless_range_loop,
    reason = "indices stand as in the formulas"
)]

use super::{Matrix, Vector};
use crate::real::Real;

/// `A^-1 B` by the definition in [`super::Matrix::solve`] for each column of B. The size is known at compile time, so one arm remains.
#[inline(always)]
pub(super) fn solve<T: Real, const N: usize, const K: usize>(
    a: [[T; N]; N],
    b: Matrix<T, N, K>,
) -> Matrix<T, N, K> {
    match N {
        1 => b / a[0][0],
        2 => over_determinant(a, b, adjugate2(&a)),
        3 => over_determinant(a, b, adjugate3(&a)),
        _ => Matrix::rows(eliminate(a, b.to_rows())),
    }
}

/// `x_i = (adj_i . b) (1 / det)`, the determinant by expansion along the first row of `A`.
#[inline(always)]
fn over_determinant<T: Real, const N: usize, const K: usize>(
    a: [[T; N]; N],
    b: Matrix<T, N, K>,
    adjugate: [[T; N]; N],
) -> Matrix<T, N, K> {
    let first_column = Matrix::rows(adjugate).column(0);
    let determinant = Vector(a[0]).dot(first_column);
    Matrix::rows(adjugate) * b * (T::one() / determinant)
}

/// The signs stand on the entries: `a_00 a_11 + a_01 (-a_10)` has the bits of `a_00 a_11 - a_01 a_10`.
#[inline(always)]
fn adjugate2<T: Real, const N: usize>(a: &[[T; N]; N]) -> [[T; N]; N] {
    let mut adjugate = *a;
    adjugate[0][0] = a[1][1];
    adjugate[0][1] = -a[0][1];
    adjugate[1][0] = -a[1][0];
    adjugate[1][1] = a[0][0];
    adjugate
}

/// Entry (i, j) is the 2 x 2 minor of `A` without row j and column i, rows and columns taken cyclically, which absorbs the signs:
/// `a_pq a_rs - a_ps a_rq`. The two products stand in the order written out at [`super::Matrix::solve`].
#[inline(always)]
fn adjugate3<T: Real, const N: usize>(a: &[[T; N]; N]) -> [[T; N]; N] {
    let mut adjugate = *a;
    for i in 0..N {
        let (q, s) = ((i + 1) % N, (i + 2) % N);
        for j in 0..N {
            let (p, r) = ((j + 1) % N, (j + 2) % N);
            adjugate[i][j] = a[p][q] * a[r][s] - a[p][s] * a[r][q];
        }
    }
    adjugate
}

/// Forward elimination with row swaps by select, then back substitution.
#[inline(always)]
fn eliminate<T: Real, const N: usize, const K: usize>(
    mut a: [[T; N]; N],
    mut b: [[T; K]; N],
) -> [[T; K]; N] {
    for k in 0..N {
        move_pivot_to(k, &mut a, &mut b);
        for i in k + 1..N {
            let l = a[i][k] / a[k][k];
            for j in k + 1..N {
                a[i][j] = a[i][j] - l * a[k][j];
            }
            for c in 0..K {
                b[i][c] = b[i][c] - l * b[k][c];
            }
        }
    }
    for i in (0..N).rev() {
        for c in 0..K {
            let mut remainder = b[i][c];
            for j in i + 1..N {
                remainder = remainder - a[i][j] * b[j][c];
            }
            b[i][c] = remainder / a[i][i];
        }
    }
    b
}

/// Swaps row `k` with the row at or below it that has the first largest entry in column `k`. Lanes may choose different rows, so the row
/// number is a value and every swap is masked.
#[inline(always)]
fn move_pivot_to<T: Real, const N: usize, const K: usize>(
    k: usize,
    a: &mut [[T; N]; N],
    b: &mut [[T; K]; N],
) {
    let mut largest = a[k][k].abs();
    let mut pivot = T::from_f64(k as f64);
    for i in k + 1..N {
        let magnitude = a[i][k].abs();
        let larger = magnitude.gt(largest);
        largest = T::select(larger, magnitude, largest);
        pivot = T::select(larger, T::from_f64(i as f64), pivot);
    }
    for i in k + 1..N {
        let chosen = pivot.eq(T::from_f64(i as f64));
        for j in k..N {
            (a[k][j], a[i][j]) = swapped(chosen, a[k][j], a[i][j]);
        }
        for c in 0..K {
            (b[k][c], b[i][c]) = swapped(chosen, b[k][c], b[i][c]);
        }
    }
}

#[inline(always)]
fn swapped<T: Real>(swap: T::Mask, x: T, y: T) -> (T, T) {
    (T::select(swap, y, x), T::select(swap, x, y))
}
