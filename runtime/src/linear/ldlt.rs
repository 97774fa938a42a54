//! Linear equations in a symmetric matrix: `A = L D L^T`, Cholesky's method without square roots.

#![expect(
    clippy::needless_range_loop,
    reason = "indices stand as in the formulas"
)]

use super::{Matrix, Vector, elimination};
use crate::real::{Mask, Real};

/// A symmetric matrix with its factors, made by [`Matrix::ldlt`].
#[derive(Clone, Copy, Debug)]
pub struct Ldlt<T: Real, const N: usize> {
    matrix: Matrix<T, N, N>,
    /// L below its diagonal of ones.
    lower: [[T; N]; N],
    /// Reciprocals of the entries of D.
    reciprocals: [T; N],
    /// Where every entry of D is positive.
    positive: T::Mask,
}

impl<T: Real, const N: usize> Ldlt<T, N> {
    /// See [`Matrix::ldlt`].
    #[inline(always)]
    pub(super) fn of(matrix: Matrix<T, N, N>) -> Self {
        let mut a = matrix.to_rows();
        let mut reciprocals = [T::zero(); N];
        let mut positive = T::Mask::splat(true);
        for k in 0..N {
            positive = positive.and(a[k][k].gt(T::zero()));
            reciprocals[k] = T::one() / a[k][k];
            for i in k + 1..N {
                // The upper triangle keeps l_ik d_k, which the rows below need.
                a[k][i] = a[i][k];
                a[i][k] = a[i][k] * reciprocals[k];
                for j in k + 1..i + 1 {
                    a[i][j] = a[i][j] - a[i][k] * a[k][j];
                }
            }
        }
        Self {
            matrix,
            lower: a,
            reciprocals,
            positive,
        }
    }

    /// `A^-1 b`: `y_i = ((b_i - l_i0 y_0) - l_i1 y_1) - ...` from the first row down, then from the last row up
    /// `x_i = ((y_i r_i - l_i+1,i x_i+1) - l_i+2,i x_i+2) - ...`. [`Matrix::solve`] where an entry of D is not positive.
    #[inline(always)]
    pub fn solve(&self, b: Vector<T, N>) -> Vector<T, N> {
        self.solve_columns(Matrix::of_columns([b])).column(0)
    }

    /// `A^-1 B`: [`Ldlt::solve`] for each column.
    #[inline(always)]
    pub fn solve_columns<const K: usize>(&self, b: Matrix<T, N, K>) -> Matrix<T, N, K> {
        let mut x = b.to_rows();
        for i in 0..N {
            for c in 0..K {
                for k in 0..i {
                    x[i][c] = x[i][c] - self.lower[i][k] * x[k][c];
                }
            }
        }
        for i in (0..N).rev() {
            for c in 0..K {
                x[i][c] = x[i][c] * self.reciprocals[i];
                for j in i + 1..N {
                    x[i][c] = x[i][c] - self.lower[j][i] * x[j][c];
                }
            }
        }
        let x = Matrix::rows(x);
        if self.positive.all() {
            return x;
        }
        let pivoted = elimination::solve(self.matrix.to_rows(), b);
        Matrix::select(self.positive, x, pivoted)
    }
}
