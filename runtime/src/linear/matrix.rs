//! Matrices, stored by columns.

use core::ops::{Index, IndexMut, Mul};

use super::elementwise::{AddProduct, Mul as Times, Plus, elementwise, operators};
use super::{Each, Each2, Each3, Ldlt, PARTIAL, Vector, add_to, dot, elimination, singular, sum};
use crate::real::Real;

/// `R` rows and `C` columns of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix<T, const R: usize, const C: usize>([Vector<T, R>; C]);

impl<T: Real, const R: usize, const C: usize> Matrix<T, R, C> {
    /// The same number in every entry.
    #[inline(always)]
    pub fn splat(value: T) -> Self {
        Self([Vector::splat(value); C])
    }

    /// Entries by rows.
    #[inline(always)]
    pub fn rows(rows: [[T; C]; R]) -> Self {
        let mut matrix = Self::zero();
        let mut i = 0;
        while i < R {
            let mut j = 0;
            while j < C {
                matrix.0[j].0[i] = rows[i][j];
                j += 1;
            }
            i += 1;
        }
        matrix
    }

    /// Entries by columns.
    #[inline(always)]
    pub(super) fn of_columns(columns: [Vector<T, R>; C]) -> Self {
        Self(columns)
    }

    /// Entries from literals, by rows.
    #[inline(always)]
    pub fn from_f64(rows: [[f64; C]; R]) -> Self {
        let mut matrix = Self::zero();
        let mut i = 0;
        while i < R {
            let mut j = 0;
            while j < C {
                matrix.0[j].0[i] = T::from_f64(rows[i][j]);
                j += 1;
            }
            i += 1;
        }
        matrix
    }

    /// Entries by rows.
    #[inline(always)]
    pub fn to_rows(&self) -> [[T; C]; R] {
        let mut rows = [[T::zero(); C]; R];
        let mut i = 0;
        while i < R {
            let mut j = 0;
            while j < C {
                rows[i][j] = self.0[j].0[i];
                j += 1;
            }
            i += 1;
        }
        rows
    }

    /// The entries of one lane in every lane, as [`Real::in_every_lane`].
    #[inline(always)]
    pub fn in_every_lane(&self, lane: usize) -> Self {
        let mut matrix = Self::zero();
        let mut j = 0;
        while j < C {
            matrix.0[j] = self.0[j].in_every_lane(lane);
            j += 1;
        }
        matrix
    }

    elementwise!();

    /// `f` of each entry.
    #[inline(always)]
    pub fn each(mut self, f: impl Each) -> Self {
        let mut j = 0;
        while j < C {
            self.0[j] = self.0[j].each(f);
            j += 1;
        }
        self
    }

    /// `f` of the entries at each place.
    #[inline(always)]
    pub fn each2(mut self, f: impl Each2, other: &Self) -> Self {
        let mut j = 0;
        while j < C {
            self.0[j] = self.0[j].each2(f, &other.0[j]);
            j += 1;
        }
        self
    }

    /// `f` of the entries at each place.
    #[inline(always)]
    pub fn each3(mut self, f: impl Each3, y: &Self, z: &Self) -> Self {
        let mut j = 0;
        while j < C {
            self.0[j] = self.0[j].each3(f, &y.0[j], &z.0[j]);
            j += 1;
        }
        self
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: Self, b: Self) -> Self {
        let mut result = a;
        let mut j = 0;
        while j < C {
            result.0[j] = Vector::select(mask, a.0[j], b.0[j]);
            j += 1;
        }
        result
    }

    /// Rows and columns exchanged.
    #[inline(always)]
    pub fn transpose(self) -> Matrix<T, C, R> {
        let mut transpose = Matrix::zero();
        let mut j = 0;
        while j < C {
            let mut i = 0;
            while i < R {
                transpose.0[i].0[j] = self.0[j].0[i];
                i += 1;
            }
            j += 1;
        }
        transpose
    }

    /// `A^T v`: entry j is column j times the vector.
    #[inline(always)]
    pub fn transpose_mul(&self, vector: Vector<T, R>) -> Vector<T, C> {
        self.columns_times::<false>(vector)
    }

    /// As [`Matrix::transpose_mul`], fused.
    #[inline(always)]
    pub fn transpose_mul_fused(&self, vector: Vector<T, R>) -> Vector<T, C> {
        self.columns_times::<true>(vector)
    }

    #[inline(always)]
    fn columns_times<const FUSED: bool>(&self, vector: Vector<T, R>) -> Vector<T, C> {
        let mut product = Vector::zero();
        let mut j = 0;
        while j < C {
            product.0[j] = dot::<T, FUSED>(&self.0[j].0, &vector.0);
            j += 1;
        }
        product
    }

    /// Replaces `A` by `A s + b c^T`: entry (i, j) becomes `a_ij s + b_i c_j`. Column by column in place, because a large matrix of lanes is
    /// many times the registers: as an expression its scaled copy and the outer product would be written to memory and read again.
    #[inline(always)]
    pub fn scale_add_outer(&mut self, factor: T, b: Vector<T, R>, c: Vector<T, C>) {
        let mut j = 0;
        while j < C {
            self.0[j] = self.0[j] * factor + b * c.0[j];
            j += 1;
        }
    }

    /// As [`Matrix::scale_add_outer`], the product of A not rounded.
    #[inline(always)]
    pub fn scale_add_outer_fused(&mut self, factor: T, b: Vector<T, R>, c: Vector<T, C>) {
        let mut j = 0;
        while j < C {
            self.0[j] = self.0[j].scale_add(factor, b * c.0[j]);
            j += 1;
        }
    }

    /// The sum over the columns, each times its entry of the vector, all entries at once.
    #[inline(always)]
    fn rows_times<const FUSED: bool>(self, vector: Vector<T, C>) -> Vector<T, R> {
        if C >= PARTIAL {
            return self.transpose().columns_times::<FUSED>(vector);
        }
        let mut product = Vector::zero();
        let mut j = 0;
        while j < C {
            let factor = [vector.0[j]; R];
            if FUSED && j > 0 {
                T::each3(AddProduct, &mut product.0, [&self.0[j].0, &factor]);
            } else {
                let mut term = self.0[j].0;
                T::each2(Times, &mut term, &factor);
                if j == 0 {
                    product.0 = term;
                } else {
                    T::each2(Plus, &mut product.0, &term);
                }
            }
            j += 1;
        }
        product
    }

    /// `A v`, fused.
    #[inline(always)]
    pub fn mul_fused(self, vector: Vector<T, C>) -> Vector<T, R> {
        self.rows_times::<true>(vector)
    }

    /// `A B`, fused.
    #[inline(always)]
    pub fn matmul_fused<const D: usize>(self, other: Matrix<T, C, D>) -> Matrix<T, R, D> {
        let mut product = Matrix::zero();
        let mut j = 0;
        while j < D {
            product.0[j] = self.rows_times::<true>(other.0[j]);
            j += 1;
        }
        product
    }

    /// Column `j`.
    #[inline(always)]
    pub fn column(&self, j: usize) -> Vector<T, R> {
        self.0[j]
    }

    /// Column `j`, to be written.
    #[inline(always)]
    pub fn column_mut(&mut self, j: usize) -> &mut Vector<T, R> {
        &mut self.0[j]
    }

    /// Sum of the squares of all entries: first along each row, left to right, then of the rows' sums by the rule of [sums](super).
    #[inline(always)]
    pub fn sum_squares(self) -> T {
        if R == 0 || C == 0 {
            return T::zero();
        }
        let mut rows = self.0[0].hadamard(self.0[0]);
        let mut j = 1;
        while j < C {
            rows = rows + self.0[j].hadamard(self.0[j]);
            j += 1;
        }
        sum(&rows.0)
    }

    /// As [`Matrix::sum_squares`], fused along each row.
    #[inline(always)]
    pub fn sum_squares_fused(self) -> T {
        if R == 0 || C == 0 {
            return T::zero();
        }
        let mut rows = self.0[0].hadamard(self.0[0]);
        let mut j = 1;
        while j < C {
            rows = self.0[j].mul_add(self.0[j], rows);
            j += 1;
        }
        sum(&rows.0)
    }

    /// As [`Vector::is_finite`].
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        let mut sums = [T::zero(); PARTIAL];
        let mut j = 0;
        while j < C {
            add_to(&mut sums, &self.0[j].0);
            j += 1;
        }
        sum(&sums).is_finite()
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
    /// - `n = 2`: `det = a_00 a_11 - a_01 a_10`; `x_0 = (a_11 b_0 - a_01 b_1) (1 / det)`, `x_1 = (a_00 b_1 - a_10 b_0) (1 / det)`.
    /// - `n = 3`: with the adjugate
    ///
    ///   ```text
    ///   a_11 a_22 - a_12 a_21    a_02 a_21 - a_01 a_22    a_01 a_12 - a_02 a_11
    ///   a_12 a_20 - a_10 a_22    a_00 a_22 - a_02 a_20    a_02 a_10 - a_00 a_12
    ///   a_10 a_21 - a_11 a_20    a_01 a_20 - a_00 a_21    a_00 a_11 - a_01 a_10
    ///   ```
    ///
    ///   `det = (a_00 adj_00 + a_01 adj_10) + a_02 adj_20` and `x_i = ((adj_i0 b_0 + adj_i1 b_1) + adj_i2 b_2) (1 / det)`.
    /// - `n >= 4`: elimination with partial pivoting. For each `k`, row k and the row of the first largest `|a_ik|`, `i >= k`, are swapped;
    ///   for each `i > k`, `l = a_ik / a_kk`, `a_ij = a_ij - l a_kj` for `j > k`, `b_i = b_i - l b_k`. Then from the last row up
    ///   `x_i = (((b_i - a_i,i+1 x_i+1) - a_i,i+2 x_i+2) - ...) / a_ii`.
    #[inline(always)]
    pub fn solve(self, b: Vector<T, N>) -> Vector<T, N> {
        self.solve_columns(Matrix([b])).0[0]
    }

    /// `A^-1 B`: [`Matrix::solve`] for each column.
    #[inline(always)]
    pub fn solve_columns<const K: usize>(self, b: Matrix<T, N, K>) -> Matrix<T, N, K> {
        elimination::solve(self.to_rows(), b)
    }

    /// The factors of a symmetric matrix, `A = L D L^T` with `l_ii = 1`, of which the lower triangle is read.
    ///
    /// For each `k`, `r_k = 1 / a_kk`; for each `i > k`, `l_ik = a_ik r_k` and `a_ij = a_ij - l_ik a_jk` for `k < j <= i`. Half of the products
    /// of an elimination of the whole matrix, and as exact as that with pivoting where the matrix is positive definite (Higham, "Accuracy
    /// and Stability of Numerical Algorithms", 2002, section 10.1); elsewhere the factors are not used.
    #[inline(always)]
    pub fn ldlt(self) -> Ldlt<T, N> {
        Ldlt::of(self)
    }
}

impl<T, const R: usize, const C: usize> Index<(usize, usize)> for Matrix<T, R, C> {
    type Output = T;

    #[inline(always)]
    fn index(&self, (i, j): (usize, usize)) -> &T {
        &self.0[j].0[i]
    }
}

impl<T, const R: usize, const C: usize> IndexMut<(usize, usize)> for Matrix<T, R, C> {
    #[inline(always)]
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut T {
        &mut self.0[j].0[i]
    }
}

operators!(Matrix<T, R, C>, const R: usize, const C: usize);

impl<T: Real, const R: usize, const C: usize> Mul<Vector<T, C>> for Matrix<T, R, C> {
    type Output = Vector<T, R>;

    /// Entry i is the inner product of row i and the vector.
    #[inline(always)]
    fn mul(self, vector: Vector<T, C>) -> Vector<T, R> {
        self.rows_times::<false>(vector)
    }
}

impl<T: Real, const R: usize, const K: usize, const C: usize> Mul<Matrix<T, K, C>>
    for Matrix<T, R, K>
{
    type Output = Matrix<T, R, C>;

    /// Column j is the matrix times column j of the other.
    #[inline(always)]
    fn mul(self, other: Matrix<T, K, C>) -> Matrix<T, R, C> {
        let mut product = Matrix::zero();
        let mut j = 0;
        while j < C {
            product.0[j] = self * other.0[j];
            j += 1;
        }
        product
    }
}
