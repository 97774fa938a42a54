//! Column vectors.

use core::ops::{Add, Div, Index, IndexMut, Mul, Neg, Sub};

use super::{Matrix, all_finite, dot};
use crate::real::Real;

/// A column of `N` numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<T, const N: usize>(pub [T; N]);

impl<T: Real, const N: usize> Vector<T, N> {
    /// The same number in every entry.
    #[inline(always)]
    pub fn splat(value: T) -> Self {
        Self([value; N])
    }

    /// Entries from literals.
    #[inline(always)]
    pub fn from_f64(entries: [f64; N]) -> Self {
        let mut vector = Self::zero();
        for (entry, value) in vector.0.iter_mut().zip(entries) {
            *entry = T::from_f64(value);
        }
        vector
    }

    entries!();

    /// `f` of the entries at each place.
    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        let mut result = self;
        for (entry, other) in result.0.iter_mut().zip(other.0) {
            *entry = f(*entry, other);
        }
        result
    }

    /// Inner product `a_0 b_0 + a_1 b_1 + ...`, left to right.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        dot(&self.0, &other.0)
    }

    /// `a b^T`: entry (i, j) is `a_i b_j`.
    #[inline(always)]
    pub fn outer<const C: usize>(self, other: Vector<T, C>) -> Matrix<T, N, C> {
        let mut product = Matrix::zero();
        for (row, a) in product.0.iter_mut().zip(self.0) {
            for (entry, b) in row.iter_mut().zip(other.0) {
                *entry = a * b;
            }
        }
        product
    }

    #[inline(always)]
    fn entries(&self) -> &[T] {
        &self.0
    }

    #[inline(always)]
    fn entries_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

operators!(Vector<T, N>, const N: usize);

impl<T, const N: usize> Index<usize> for Vector<T, N> {
    type Output = T;

    #[inline(always)]
    fn index(&self, i: usize) -> &T {
        &self.0[i]
    }
}

impl<T, const N: usize> IndexMut<usize> for Vector<T, N> {
    #[inline(always)]
    fn index_mut(&mut self, i: usize) -> &mut T {
        &mut self.0[i]
    }
}
