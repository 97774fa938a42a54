//! Matrices, stored by rows.

use core::ops::{Add, Div, Index, IndexMut, Mul, Neg, Sub};

use super::{Vector, all_finite, dot, elimination, singular};
use crate::real::Real;

/// `R` rows of `C` numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix<T, const R: usize, const C: usize>(pub [[T; C]; R]);

impl<T: Real, const R: usize, const C: usize> Matrix<T, R, C> {
    /// The same number in every entry.
    #[inline(always)]
    pub fn splat(value: T) -> Self {
        Self([[value; C]; R])
    }

    /// Entries from literals, by rows.
    #[inline(always)]
    pub fn from_f64(rows: [[f64; C]; R]) -> Self {
        let mut matrix = Self::zero();
        for (row, values) in matrix.0.iter_mut().zip(rows) {
            *row = Vector::from_f64(values).0;
        }
        matrix
    }

    entries!();

    /// Rows and columns exchanged.
    #[inline(always)]
    pub fn transpose(self) -> Matrix<T, C, R> {
        let mut transpose = Matrix::zero();
        for (i, row) in self.0.into_iter().enumerate() {
            for (j, entry) in row.into_iter().enumerate() {
                transpose.0[j][i] = entry;
            }
        }
        transpose
    }

    /// Column `j`.
    #[inline(always)]
    pub fn column(&self, j: usize) -> Vector<T, R> {
        let mut column = Vector::zero();
        for (entry, row) in column.0.iter_mut().zip(&self.0) {
            *entry = row[j];
        }
        column
    }

    #[inline(always)]
    fn entries(&self) -> &[T] {
        self.0.as_flattened()
    }

    #[inline(always)]
    fn entries_mut(&mut self) -> &mut [T] {
        self.0.as_flattened_mut()
    }

    /// Unit right singular vector `v` of the largest singular value, so that `||A v||` is the spectral norm of `A`.
    ///
    /// 1. `S = A^T A`, `s_ij = a_0i a_0j + a_1i a_1j + ...` down the rows, for `i <= j`, mirrored; `V = I`.
    /// 2. Eight sweeps of cyclic Jacobi, each `for p in 0..C, for q in p+1..C`:
    ///    `theta = (s_qq - s_pp) / (s_pq + s_pq)`, `r = 1 / (|theta| + sqrt(theta theta + 1))`, `t = -r` if `theta < 0` else `r`, but 0 if
    ///    `s_pq = 0`; `c = 1 / sqrt(t t + 1)`, `s = t c`, `d = t s_pq`; then `s_pp -= d`, `s_qq += d`, `s_pq = s_qp = 0`; for every `k`
    ///    but p and q `(s_kp, s_kq) = (c s_kp - s s_kq, s s_kp + c s_kq)`, mirrored; and the same combination of the columns p and q of V.
    /// 3. The column of V of the first largest `s_jj`, negated if its first entry of largest magnitude is negative.
    ///
    /// A zero matrix gives the first unit vector. Entries beyond about 1e77 overflow the rotation formulas.
    #[inline(always)]
    pub fn singular_vector(self) -> Vector<T, C> {
        singular::leading_right_vector(&self)
    }
}

impl<T: Real, const N: usize> Matrix<T, N, N> {
    /// `A^-1 b`. Not finite if `A` is singular.
    ///
    /// - `n = 1`: `b_0 / a_00`.
    /// - `n = 2`: `det = a_00 a_11 - a_01 a_10`; `x_0 = (a_11 b_0 - a_01 b_1) / det`, `x_1 = (a_00 b_1 - a_10 b_0) / det`.
    /// - `n = 3`: with the adjugate
    ///
    ///   ```text
    ///   a_11 a_22 - a_12 a_21    a_02 a_21 - a_01 a_22    a_01 a_12 - a_02 a_11
    ///   a_12 a_20 - a_10 a_22    a_00 a_22 - a_02 a_20    a_02 a_10 - a_00 a_12
    ///   a_10 a_21 - a_11 a_20    a_01 a_20 - a_00 a_21    a_00 a_11 - a_01 a_10
    ///   ```
    ///
    ///   `det = (a_00 adj_00 + a_01 adj_10) + a_02 adj_20` and `x_i = ((adj_i0 b_0 + adj_i1 b_1) + adj_i2 b_2) / det`.
    /// - `n >= 4`: elimination with partial pivoting. For each `k`, row k and the row of the first largest `|a_ik|`, `i >= k`, are swapped;
    ///   for each `i > k`, `l = a_ik / a_kk`, `a_ij = a_ij - l a_kj` for `j > k`, `b_i = b_i - l b_k`. Then from the last row up
    ///   `x_i = (((b_i - a_i,i+1 x_i+1) - a_i,i+2 x_i+2) - ...) / a_ii`.
    #[inline(always)]
    pub fn solve(self, b: Vector<T, N>) -> Vector<T, N> {
        elimination::solve(self.0, b.0)
    }
}

impl<T, const R: usize, const C: usize> Index<(usize, usize)> for Matrix<T, R, C> {
    type Output = T;

    #[inline(always)]
    fn index(&self, (i, j): (usize, usize)) -> &T {
        &self.0[i][j]
    }
}

impl<T, const R: usize, const C: usize> IndexMut<(usize, usize)> for Matrix<T, R, C> {
    #[inline(always)]
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut T {
        &mut self.0[i][j]
    }
}

operators!(Matrix<T, R, C>, const R: usize, const C: usize);

impl<T: Real, const R: usize, const C: usize> Mul<Vector<T, C>> for Matrix<T, R, C> {
    type Output = Vector<T, R>;

    /// Entry i is row i times the vector, summed over columns left to right.
    #[inline(always)]
    fn mul(self, vector: Vector<T, C>) -> Vector<T, R> {
        let mut product = Vector::zero();
        for (entry, row) in product.0.iter_mut().zip(&self.0) {
            *entry = dot(row, &vector.0);
        }
        product
    }
}

impl<T: Real, const R: usize, const K: usize, const C: usize> Mul<Matrix<T, K, C>>
    for Matrix<T, R, K>
{
    type Output = Matrix<T, R, C>;

    /// Entry (i, j) is `a_i0 b_0j + a_i1 b_1j + ...`, left to right.
    #[inline(always)]
    fn mul(self, other: Matrix<T, K, C>) -> Matrix<T, R, C> {
        let columns = other.transpose();
        let mut product = Matrix::zero();
        for (row, a) in product.0.iter_mut().zip(&self.0) {
            for (entry, b) in row.iter_mut().zip(&columns.0) {
                *entry = dot(a, b);
            }
        }
        product
    }
}
