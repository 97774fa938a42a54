//! Eigenvalues and singular values of compile-time matrices, by nalgebra. Entries are finite.

use nalgebra::{DMatrix, Schur, SymmetricEigen};

use crate::model::Matrix;

/// Iterations after which an eigenvalue computation is given up; a few per row is usual.
const MAX_ITERATIONS: usize = 10_000;

fn dense(matrix: &Matrix) -> DMatrix<f64> {
    DMatrix::from_row_slice(matrix.rows, matrix.cols, &matrix.data)
}

/// Smallest eigenvalue of (A + A^T)/2; `None` if it cannot be computed.
pub(super) fn least_symmetric_eigenvalue(matrix: &Matrix) -> Option<f64> {
    let a = dense(matrix);
    let symmetric = (&a + a.transpose()) * 0.5;
    let eigen = SymmetricEigen::try_new(symmetric, f64::EPSILON, MAX_ITERATIONS)?;
    eigen
        .eigenvalues
        .iter()
        .copied()
        .reduce(f64::min)
        .filter(|value| value.is_finite())
}

/// Largest real part of the eigenvalues, with the imaginary part that goes with it; `None` if they cannot be computed.
pub(super) fn rightmost_eigenvalue(matrix: &Matrix) -> Option<(f64, f64)> {
    let schur = Schur::try_new(dense(matrix), f64::EPSILON, MAX_ITERATIONS)?;
    let eigenvalues = schur.complex_eigenvalues();
    let rightmost = eigenvalues
        .iter()
        .map(|value| (value.re, value.im.abs()))
        .max_by(|a, b| a.0.total_cmp(&b.0))?;
    rightmost.0.is_finite().then_some(rightmost)
}

/// Ratio of the smallest to the largest singular value once rows and then columns are scaled to a largest entry of 1, so that
/// units do not matter; 0 for a matrix with a row or column of zeros.
pub(super) fn reciprocal_condition(matrix: &Matrix) -> f64 {
    let mut scaled = dense(matrix);
    for mut row in scaled.row_iter_mut() {
        let largest = row.amax();
        if largest == 0.0 {
            return 0.0;
        }
        row /= largest;
    }
    for mut column in scaled.column_iter_mut() {
        let largest = column.amax();
        if largest == 0.0 {
            return 0.0;
        }
        column /= largest;
    }
    let values = scaled.singular_values();
    values.min() / values.max()
}

/// A - B C.
pub(super) fn minus_product(a: &Matrix, b: &Matrix, c: &Matrix) -> Matrix {
    let difference = dense(a) - dense(b) * dense(c);
    Matrix {
        rows: a.rows,
        cols: a.cols,
        data: difference.transpose().as_slice().to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: usize, cols: usize, data: &[f64]) -> Matrix {
        Matrix {
            rows,
            cols,
            data: data.to_vec(),
        }
    }

    #[test]
    fn eigenvalues_of_known_matrices() {
        let rotation = matrix(2, 2, &[-0.5, 3.0, -3.0, -0.5]);
        let (re, im) = rightmost_eigenvalue(&rotation).unwrap();
        assert!((re + 0.5).abs() < 1e-12 && (im - 3.0).abs() < 1e-12);
        let skewed = matrix(2, 2, &[1.0, 4.0, 0.0, 1.0]);
        assert!((least_symmetric_eigenvalue(&skewed).unwrap() + 1.0).abs() < 1e-12);
    }

    #[test]
    fn units_do_not_make_a_matrix_singular() {
        assert!(reciprocal_condition(&matrix(2, 2, &[1e-7, 0.0, 0.0, 1e9])) > 0.99);
        assert!(reciprocal_condition(&matrix(2, 2, &[1.0, 2.0, 2.0, 4.0])) < 1e-12);
        assert_eq!(
            reciprocal_condition(&matrix(2, 2, &[0.0, 0.0, 1.0, 1.0])),
            0.0
        );
    }

    #[test]
    fn overflow_has_no_eigenvalues() {
        let huge = matrix(2, 2, &[1e308, 1e308, 1e308, -1e308]);
        assert_eq!(
            least_symmetric_eigenvalue(&minus_product(&huge, &huge, &huge)),
            None
        );
        assert_eq!(
            rightmost_eigenvalue(&minus_product(&huge, &huge, &huge)),
            None
        );
        assert!(least_symmetric_eigenvalue(&huge).is_none_or(f64::is_finite));
        assert!(rightmost_eigenvalue(&huge).is_none_or(|(re, _)| re.is_finite()));
    }

    #[test]
    fn the_observer_matrix_is_row_major() {
        let m = matrix(2, 2, &[0.0, 3.0, -3.0, 0.0]);
        let product = minus_product(&m, &matrix(2, 1, &[-1.5, 1.5]), &matrix(1, 2, &[0.0, 2.0]));
        assert_eq!(product.data, [0.0, 6.0, -3.0, -3.0]);
    }
}
