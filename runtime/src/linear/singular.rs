//! Leading right singular vector by the cyclic Jacobi method on `A^T A`, with a fixed number of sweeps.

#![expect(
    clippy::needless_range_loop,
    reason = "indices stand as in the formulas"
)]

use super::{Matrix, Vector};
use crate::real::Real;

/// Jacobi converges quadratically: with eight sweeps the off-diagonal part of a matrix of the sizes at hand is zero to rounding.
const SWEEPS: usize = 8;

/// The definition is at [`Matrix::singular_vector`].
#[inline(always)]
pub(super) fn leading_right_vector<T: Real, const R: usize, const C: usize>(
    a: &Matrix<T, R, C>,
) -> Vector<T, C> {
    let mut s = (a.transpose() * *a).to_rows();
    let mut v = [[T::zero(); C]; C];
    for i in 0..C {
        v[i][i] = T::one();
    }
    for _ in 0..SWEEPS {
        for p in 0..C {
            for q in p + 1..C {
                rotate(&mut s, &mut v, p, q);
            }
        }
    }
    oriented(column_of_largest(&s, &v))
}

/// One rotation in the plane (p, q) that makes `s_pq` zero; `V` takes the same rotation.
#[inline(always)]
fn rotate<T: Real, const C: usize>(s: &mut [[T; C]; C], v: &mut [[T; C]; C], p: usize, q: usize) {
    let s_pq = s[p][q];
    let theta = (s[q][q] - s[p][p]) / (s_pq + s_pq);
    let small = T::one() / (theta.abs() + (theta * theta + T::one()).sqrt());
    let signed = T::select(theta.lt(T::zero()), -small, small);
    let tangent = T::select(s_pq.eq(T::zero()), T::zero(), signed);
    let cosine = T::one() / (tangent * tangent + T::one()).sqrt();
    let sine = tangent * cosine;

    let shift = tangent * s_pq;
    s[p][p] = s[p][p] - shift;
    s[q][q] = s[q][q] + shift;
    s[p][q] = T::zero();
    s[q][p] = T::zero();
    for k in 0..C {
        if k != p && k != q {
            (s[k][p], s[k][q]) = turned([cosine, sine], s[k][p], s[k][q]);
            s[p][k] = s[k][p];
            s[q][k] = s[k][q];
        }
    }
    for k in 0..C {
        (v[k][p], v[k][q]) = turned([cosine, sine], v[k][p], v[k][q]);
    }
}

/// A point of the plane after a rotation.
#[inline(always)]
fn turned<T: Real>([cosine, sine]: [T; 2], x: T, y: T) -> (T, T) {
    (cosine * x - sine * y, sine * x + cosine * y)
}

/// The column of `V` of the first largest diagonal entry of `S`.
#[inline(always)]
fn column_of_largest<T: Real, const C: usize>(s: &[[T; C]; C], v: &[[T; C]; C]) -> Vector<T, C> {
    let mut largest = s[0][0];
    let mut chosen = Matrix::rows(*v).column(0);
    for j in 1..C {
        let larger = s[j][j].gt(largest);
        largest = T::select(larger, s[j][j], largest);
        chosen = Vector::select(larger, Matrix::rows(*v).column(j), chosen);
    }
    chosen
}

/// The vector or its negative, such that its first entry of largest magnitude is not negative.
#[inline(always)]
fn oriented<T: Real, const C: usize>(vector: Vector<T, C>) -> Vector<T, C> {
    let mut lead = vector[0];
    for i in 1..C {
        lead = T::select(vector[i].abs().gt(lead.abs()), vector[i], lead);
    }
    Vector::select(lead.lt(T::zero()), -vector, vector)
}
