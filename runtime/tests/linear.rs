//! Arrays: the order of operations is the documented one, to the bit, and solutions solve.

use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;

/// Numbers without structure, each a function of the place.
fn matrix<const R: usize, const C: usize>(seed: u64) -> Matrix<f64, R, C> {
    let noise = Noise::<f64>::process(seed, 0);
    Matrix::rows(std::array::from_fn(|i| {
        std::array::from_fn(|j| noise.normal(i as u64, j as u32))
    }))
}

fn vector<const N: usize>(seed: u64) -> Vector<f64, N> {
    matrix::<N, 1>(seed).column(0)
}

fn residual<const N: usize>(a: Matrix<f64, N, N>, x: Vector<f64, N>, b: Vector<f64, N>) -> f64 {
    (a * x - b).sum_squares().sqrt()
}

#[test]
fn short_sums_run_left_to_right_from_the_first_term() {
    let (a, b) = (vector::<4>(1), vector::<4>(2));
    let expected = ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]) + a[3] * b[3];
    assert_eq!(a.dot(b), expected);
    // Starting from +0 instead would lose the sign of a negative zero.
    assert!(Vector([-0.0_f64]).dot(Vector([1.0])).is_sign_negative());
    assert_eq!(Vector::<f64, 0>([]).dot(Vector([])), 0.0);
}

#[test]
fn long_sums_have_eight_parts_that_are_added_in_halves() {
    let (a, b) = (vector::<19>(1), vector::<19>(2));
    let product = |k: usize| a[k] * b[k];
    let part = |l: usize| {
        let short = product(l) + product(l + 8);
        if l < 3 {
            short + product(l + 16)
        } else {
            short
        }
    };
    let half = |l: usize| part(l) + part(l + 4);
    assert_eq!(a.dot(b), (half(0) + half(2)) + (half(1) + half(3)));
}

#[test]
fn products_are_rows_times_columns() {
    let (a, b, v) = (matrix::<2, 3>(3), matrix::<3, 4>(4), vector::<3>(5));
    let product = a * b;
    let image = a * v;
    for i in 0..2 {
        let row = Vector(a.to_rows()[i]);
        assert_eq!(image[i], row.dot(v));
        for j in 0..4 {
            assert_eq!(product[(i, j)], row.dot(b.column(j)));
        }
    }
    let (wide, long) = (matrix::<2, 11>(3), vector::<11>(6));
    assert_eq!((wide * long)[1], Vector(wide.to_rows()[1]).dot(long));
    assert_eq!(
        wide.transpose_mul(image),
        wide.transpose() * image,
        "both are the columns' products"
    );
    assert_eq!(v.outer(image)[(2, 1)], v[2] * image[1]);
    assert_eq!(a.transpose()[(2, 1)], a[(1, 2)]);
    let square = |i, j| a[(i, j)] * a[(i, j)];
    let row = |i| (square(i, 0) + square(i, 1)) + square(i, 2);
    assert_eq!(a.sum_squares(), row(0) + row(1));
}

#[test]
fn an_update_in_place_has_the_bits_of_the_sum() {
    let (weights, b, c) = (matrix::<19, 3>(8), vector::<19>(9), vector::<3>(10));
    let mut updated = weights;
    updated.scale_add_outer(0.99, b, c);
    assert_eq!(updated, weights * 0.99 + b.outer(c));
    let mut updated = weights;
    updated.scale_add_outer_fused(0.99, b, c);
    assert_eq!(updated, weights.scale_add(0.99, b.outer(c)));
    assert_eq!(
        updated[(18, 2)],
        weights[(18, 2)].mul_add(0.99, b[18] * c[2])
    );
}

#[test]
fn elementwise_operations_are_one_operation_per_entry() {
    let (a, b) = (vector::<3>(6), vector::<3>(7));
    assert_eq!((a / 3.0)[1], a[1] / 3.0);
    assert_eq!((a * 3.0)[1], a[1] * 3.0);
    assert_eq!(a.add_scalar(3.0)[1], a[1] + 3.0);
    assert_eq!(a.hadamard(b)[2], a[2] * b[2]);
    assert_eq!(a.quotient(b)[2], a[2] / b[2]);
    assert_eq!(Vector::select(true, a, b), a);
    assert!(!Vector([1.0, f64::NAN]).is_finite() && a.is_finite());
    let m = matrix::<2, 2>(8);
    assert_eq!((m / 3.0)[(0, 1)], m[(0, 1)] / 3.0);
    assert_eq!(
        (-m + m * 2.0 - m)[(1, 0)],
        (-m[(1, 0)] + m[(1, 0)] * 2.0) - m[(1, 0)]
    );
    assert!(!Matrix::rows([[f64::INFINITY]]).is_finite() && m.is_finite());
}

#[test]
fn small_systems_follow_the_written_cofactors() {
    let (a, b) = (matrix::<2, 2>(9), vector::<2>(10));
    let det = a[(0, 0)] * a[(1, 1)] - a[(0, 1)] * a[(1, 0)];
    assert_eq!(
        a.solve(b)[0],
        (a[(1, 1)] * b[0] - a[(0, 1)] * b[1]) * (1.0 / det)
    );
    assert_eq!(
        a.solve(b)[1],
        (a[(0, 0)] * b[1] - a[(1, 0)] * b[0]) * (1.0 / det)
    );

    let (a, b) = (matrix::<3, 3>(11), vector::<3>(12));
    let [[a00, a01, a02], [a10, a11, a12], [a20, a21, a22]] = a.to_rows();
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
    let det = (a00 * adjugate[0][0] + a01 * adjugate[1][0]) + a02 * adjugate[2][0];
    let x = matrix::<3, 3>(11).solve(b);
    for i in 0..3 {
        assert_eq!(
            x[i],
            ((adjugate[i][0] * b[0] + adjugate[i][1] * b[1]) + adjugate[i][2] * b[2]) * (1.0 / det)
        );
    }
    assert_eq!(Matrix::rows([[4.0]]).solve(Vector([1.0])), Vector([0.25]));
}

/// The definition with a plain pivot search and plain swaps, as the compiler's evaluator has it.
#[expect(
    clippy::needless_range_loop,
    reason = "indices stand as in the definition"
)]
fn eliminate<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for k in 0..N {
        let mut pivot = k;
        for i in k + 1..N {
            if a[i][k].abs() > a[pivot][k].abs() {
                pivot = i;
            }
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..N {
            let l = a[i][k] / a[k][k];
            for j in k + 1..N {
                a[i][j] -= l * a[k][j];
            }
            b[i] -= l * b[k];
        }
    }
    let mut x = [0.0; N];
    for i in (0..N).rev() {
        let mut s = b[i];
        for j in i + 1..N {
            s -= a[i][j] * x[j];
        }
        x[i] = s / a[i][i];
    }
    x
}

#[test]
fn masked_pivoting_is_plain_pivoting() {
    for seed in 0..50 {
        let (a, b) = (matrix::<5, 5>(20 + seed), vector::<5>(80 + seed));
        // Ties among pivot candidates, and zeros on the diagonal.
        let a = Matrix::rows(a.to_rows().map(|row| row.map(|x| (x * 2.0).round())));
        assert_eq!(
            a.solve(b).0.map(f64::to_bits),
            eliminate(a.to_rows(), b.0).map(f64::to_bits)
        );
    }
}

#[test]
fn solutions_solve() {
    fn check<const N: usize>() {
        for seed in 0..50 {
            let (a, b) = (matrix::<N, N>(200 + seed), vector::<N>(300 + seed));
            let x = a.solve(b);
            assert!(
                residual(a, x, b) < 1e-12 * (1.0 + x.sum_squares().sqrt()),
                "n = {N}, seed {seed}"
            );
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
    check::<4>();
    check::<6>();
    assert!(
        !Matrix::rows([[1.0_f64, 2.0], [2.0, 4.0]])
            .solve(Vector([1.0, 1.0]))
            .is_finite()
    );
}

/// `A^T A + shift I`.
fn symmetric<const N: usize>(seed: u64, shift: f64) -> Matrix<f64, N, N> {
    let a = matrix::<N, N>(seed);
    let mut a = a.transpose() * a;
    for i in 0..N {
        a[(i, i)] += shift;
    }
    a
}

#[test]
fn symmetric_systems_follow_the_written_elimination() {
    let (a, b) = (symmetric::<2>(500, 0.0), vector::<2>(501));
    let r = 1.0 / a[(0, 0)];
    let l = a[(1, 0)] * r;
    let rest = 1.0 / (a[(1, 1)] - l * a[(1, 0)]);
    let last = (b[1] - l * b[0]) * rest;
    assert_eq!(a.ldlt().solve(b), Vector([b[0] * r - l * last, last]));
    // The upper triangle is not read.
    let mut lower = a;
    lower[(0, 1)] = f64::NAN;
    assert_eq!(lower.ldlt().solve(b), a.ldlt().solve(b));
}

#[test]
fn symmetric_solutions_solve() {
    fn check<const N: usize>() {
        for seed in 0..50 {
            let (a, b) = (symmetric::<N>(600 + seed, 0.0), vector::<N>(700 + seed));
            let x = a.ldlt().solve(b);
            // Backward stable (Higham, theorem 10.4): within 8 n (n + 1) 2^-53 ||A|| ||x||.
            let bound = (8 * N * (N + 1)) as f64 * f64::EPSILON / 2.0;
            let size = a.sum_squares().sqrt() * x.sum_squares().sqrt();
            assert!(residual(a, x, b) <= bound * size, "n = {N}, seed {seed}");
        }
    }
    check::<1>();
    check::<4>();
    check::<6>();
    check::<16>();
    // Hilbert's matrix has a known inverse of integers; its condition is 1.5e7.
    let hilbert = Matrix::rows(std::array::from_fn::<[f64; 6], 6, _>(|i| {
        std::array::from_fn(|j| 1.0 / (i + j + 1) as f64)
    }));
    let unit = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    let inverse = hilbert
        .ldlt()
        .solve_columns(Matrix::<f64, 6, 6>::rows(unit));
    let exact = [36.0, -630.0, 3360.0, -7560.0, 7560.0, -2772.0];
    for (j, exact) in exact.into_iter().enumerate() {
        assert!((inverse[(0, j)] / exact - 1.0).abs() < 1e-9, "entry {j}");
    }
}

#[test]
fn symmetric_matrices_that_are_not_positive_definite_are_solved_with_pivoting() {
    let swap = Matrix::rows([
        [0.0, 1.0, 0.0, 0.0],
        [1.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -2.0, 0.0],
        [0.0, 0.0, 0.0, 4.0],
    ]);
    let b = Vector([1.0, 2.0, 3.0, 4.0]);
    assert_eq!(swap.ldlt().solve(b), Vector([2.0, 1.0, -1.5, 1.0]));
    // One entry of the diagonal decides at which pivot it shows.
    for pivot in 0..5 {
        let (mut a, b) = (symmetric::<5>(800, 0.5), vector::<5>(900));
        a[(pivot, pivot)] = -a[(pivot, pivot)];
        assert_eq!(a.ldlt().solve(b), a.solve(b), "pivot {pivot}");
        assert!(residual(a, a.ldlt().solve(b), b) < 1e-13);
    }
    assert!(!Matrix::<f64, 4, 4>::zero().ldlt().solve(b).is_finite());
    let mut broken = symmetric::<4>(1000, 0.0);
    broken[(2, 0)] = f64::NAN;
    assert!(!broken.ldlt().solve(b).is_finite());
}

#[test]
fn columns_are_solved_as_each_alone() {
    fn check<const N: usize>() {
        let (a, b) = (symmetric::<N>(1100, 0.0), matrix::<N, 3>(1101));
        for j in 0..3 {
            let column = b.column(j);
            assert_eq!(a.solve_columns(b).column(j), a.solve(column));
            let symmetric = a.ldlt().solve_columns(b).column(j);
            assert_eq!(symmetric, a.ldlt().solve(column));
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
    check::<5>();
}

#[test]
fn singular_vector_attains_the_spectral_norm() {
    for seed in 0..50 {
        let a = matrix::<4, 3>(400 + seed);
        let v = a.singular_vector();
        let norm = (a * v).sum_squares().sqrt();
        assert!((v.sum_squares() - 1.0).abs() < 1e-14);
        // Stationary: A^T A v = norm^2 v.
        let stationary = a.transpose() * (a * v) - v * (norm * norm);
        assert!(
            stationary.sum_squares().sqrt() < 1e-13 * norm * norm,
            "seed {seed}"
        );
        for other in 0..100 {
            let w = vector::<3>(1000 + other);
            assert!((a * w).sum_squares() <= norm * norm * w.sum_squares() * (1.0 + 1e-13));
        }
    }
}

#[test]
fn singular_vector_has_its_convention() {
    assert_eq!(
        Matrix::<f64, 2, 2>::zero().singular_vector(),
        Vector([1.0, 0.0])
    );
    assert_eq!(
        Matrix::rows([[2.0, 0.0], [0.0, 2.0]]).singular_vector(),
        Vector([1.0, 0.0])
    );
    assert_eq!(
        Matrix::rows([[1.0, 0.0], [0.0, -3.0]]).singular_vector(),
        Vector([0.0, 1.0])
    );
    // The larger entry is the positive one, whichever the rotation angle.
    let v = Matrix::rows([[1.0, -2.0]]).singular_vector();
    assert!((v[0] + 0.2_f64.sqrt()).abs() < 1e-15 && (v[1] - 0.8_f64.sqrt()).abs() < 1e-15);
    assert_eq!(Matrix::rows([[-5.0]]).singular_vector(), Vector([1.0]));
}
