//! Linear equations `A X = B` of numbers, row-major, in the order of operations of the emitted code. Each column of B is solved for by itself.

/// `X` in the place of `B`, which has `columns`: adjugate times the reciprocal of the determinant up to three rows, else elimination with
/// partial pivoting. Not finite if A is singular.
pub fn solve(a: &[f64], columns: usize, b: &mut [f64]) {
    each_column(columns, b, |b| solve_one(a, b));
}

/// `X` in the place of `B` for a symmetric A, of which the lower triangle is read: by `A = L D L^T` where all pivots are positive, else as
/// [`solve`].
pub fn solve_symmetric(a: &[f64], columns: usize, b: &mut [f64]) {
    each_column(columns, b, |b| {
        let right = b.to_vec();
        if !eliminate_symmetric(a.to_vec(), b) {
            b.copy_from_slice(&right);
            solve_one(a, b);
        }
    });
}

fn each_column(columns: usize, b: &mut [f64], mut solve: impl FnMut(&mut [f64])) {
    for column in 0..columns {
        let mut x: Vec<f64> = b.iter().skip(column).step_by(columns).copied().collect();
        solve(&mut x);
        for (entry, x) in b.iter_mut().skip(column).step_by(columns).zip(x) {
            *entry = x;
        }
    }
}

fn solve_one(a: &[f64], b: &mut [f64]) {
    match (a, &mut *b) {
        (&[a00], [b0]) => *b0 /= a00,
        (&[a00, a01, a10, a11], &mut [b0, b1]) => {
            let scale = 1.0 / (a00 * a11 - a01 * a10);
            b[0] = (a11 * b0 - a01 * b1) * scale;
            b[1] = (a00 * b1 - a10 * b0) * scale;
        }
        (&[a00, a01, a02, a10, a11, a12, a20, a21, a22], &mut [b0, b1, b2]) => {
            let adjugate = [
                [
                    a11 * a22 - a12 * a21,
                    a02 * a21 - a01 * a22,
                    a01 * a12 - a02 * a11,
                ],
                [
                    a12 * a20 - a10 * a22,
                    a00 * a22 - a02 * a20,
                    a02 * a10 - a00 * a12,
                ],
                [
                    a10 * a21 - a11 * a20,
                    a01 * a20 - a00 * a21,
                    a00 * a11 - a01 * a10,
                ],
            ];
            let scale = 1.0 / (a00 * adjugate[0][0] + a01 * adjugate[1][0] + a02 * adjugate[2][0]);
            for (entry, row) in b.iter_mut().zip(adjugate) {
                *entry = (row[0] * b0 + row[1] * b1 + row[2] * b2) * scale;
            }
        }
        _ => eliminate(a.to_vec(), b),
    }
}

/// Gaussian elimination; the pivot of a column is its first entry of largest magnitude.
fn eliminate(mut a: Vec<f64>, b: &mut [f64]) {
    let n = b.len();
    for k in 0..n {
        let pivot = (k + 1..n).fold(k, |best, i| {
            if a[i * n + k].abs() > a[best * n + k].abs() {
                i
            } else {
                best
            }
        });
        for j in 0..n {
            a.swap(k * n + j, pivot * n + j);
        }
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i * n + k] / a[k * n + k];
            for j in k + 1..n {
                a[i * n + j] -= factor * a[k * n + j];
            }
            b[i] -= factor * b[k];
        }
    }
    for i in (0..n).rev() {
        let rest = (i + 1..n).fold(b[i], |rest, j| rest - a[i * n + j] * b[j]);
        b[i] = rest / a[i * n + i];
    }
}

/// Elimination of the lower triangle without swaps; whether every pivot was positive, so that b is the solution.
fn eliminate_symmetric(mut a: Vec<f64>, b: &mut [f64]) -> bool {
    let n = b.len();
    let mut reciprocals = vec![0.0; n];
    for k in 0..n {
        let pivot = a[k * n + k];
        if pivot <= 0.0 || pivot.is_nan() {
            return false;
        }
        reciprocals[k] = 1.0 / pivot;
        let column: Vec<f64> = (0..n).map(|i| a[i * n + k]).collect();
        for i in k + 1..n {
            let factor = column[i] * reciprocals[k];
            for j in k + 1..=i {
                a[i * n + j] -= factor * column[j];
            }
            b[i] -= factor * b[k];
            a[i * n + k] = factor;
        }
    }
    for i in (0..n).rev() {
        let first = b[i] * reciprocals[i];
        b[i] = (i + 1..n).fold(first, |x, j| x - a[j * n + i] * b[j]);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The matrix with entries 1/(i + j + 1), whose inverse is of whole numbers.
    fn hilbert(n: usize) -> Vec<f64> {
        (0..n * n)
            .map(|at| 1.0 / (at / n + at % n + 1) as f64)
            .collect()
    }

    #[test]
    fn the_inverse_of_hilberts_matrix_is_that_of_whole_numbers() {
        let exact = [
            16.0, -120.0, 240.0, -140.0, -120.0, 1200.0, -2700.0, 1680.0, 240.0, -2700.0, 6480.0,
            -4200.0, -140.0, 1680.0, -4200.0, 2800.0,
        ];
        for solve in [solve, solve_symmetric] {
            let mut x: Vec<f64> = (0..16).map(|at| f64::from(at / 4 == at % 4)).collect();
            solve(&hilbert(4), 4, &mut x);
            for (found, exact) in x.iter().zip(exact) {
                // Its condition is 1.6e4.
                assert!((found - exact).abs() < 1e-11 * exact.abs() * 16.0);
            }
        }
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_is_solved_with_pivoting() {
        let a = [
            0.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, -4.0, 0.0, 0.0, 0.0, 0.0, 1.0,
        ];
        let mut x = [2.0, 6.0, 8.0, 5.0];
        solve_symmetric(&a, 1, &mut x);
        assert_eq!(x, [3.0, 1.0, -2.0, 5.0]);
    }
}
