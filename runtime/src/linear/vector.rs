//! Column vectors.

use core::ops::{Add, Div, Index, IndexMut, Mul, Neg, Sub};

use super::{Matrix, array, rows, sum};
use crate::real::{Mask, Real};

/// A column of `N` numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<T, const N: usize>(pub [T; N]);

impl<T: Real, const N: usize> Vector<T, N> {
    /// The same number in every entry.
    #[inline(always)]
    pub fn splat(value: T) -> Self {
        Self([value; N])
    }

    /// Zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        Self::splat(T::zero())
    }

    /// Entries from literals.
    #[inline(always)]
    pub fn from_f64(entries: [f64; N]) -> Self {
        Self(array(|i| T::from_f64(entries[i])))
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: Self, b: Self) -> Self {
        a.zip(b, |a, b| T::select(mask, a, b))
    }

    /// `f` of each entry.
    #[inline(always)]
    pub fn map(self, f: impl Fn(T) -> T) -> Self {
        Self(array(|i| f(self.0[i])))
    }

    /// `f` of the entries at each place.
    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        Self(array(|i| f(self.0[i], other.0[i])))
    }

    /// `v_i s`.
    #[inline(always)]
    pub fn scale(self, factor: T) -> Self {
        self.map(|x| x * factor)
    }

    /// `v_i + s`.
    #[inline(always)]
    pub fn add_scalar(self, term: T) -> Self {
        self.map(|x| x + term)
    }

    /// Elementwise product `a_i b_i`.
    #[inline(always)]
    pub fn hadamard(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }

    /// Elementwise quotient `a_i / b_i`.
    #[inline(always)]
    pub fn quotient(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }

    /// Inner product `a_0 b_0 + a_1 b_1 + ...`, left to right.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        sum::<T, N>(|i| self.0[i] * other.0[i])
    }

    /// `v_0 v_0 + v_1 v_1 + ...`, left to right.
    #[inline(always)]
    pub fn sum_squares(self) -> T {
        self.dot(self)
    }

    /// `a b^T`: entry (i, j) is `a_i b_j`.
    #[inline(always)]
    pub fn outer<const C: usize>(self, other: Vector<T, C>) -> Matrix<T, N, C> {
        Matrix(rows(|i, j| self.0[i] * other.0[j]))
    }

    /// Whether every entry is finite.
    #[inline(always)]
    pub fn is_finite(self) -> T::Mask {
        let mut all = T::Mask::splat(true);
        for i in 0..N {
            all = all.and(self.0[i].is_finite());
        }
        all
    }
}

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

impl<T: Real, const N: usize> Add for Vector<T, N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl<T: Real, const N: usize> Sub for Vector<T, N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl<T: Real, const N: usize> Neg for Vector<T, N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<T: Real, const N: usize> Mul<T> for Vector<T, N> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        self.scale(factor)
    }
}

impl<T: Real, const N: usize> Div<T> for Vector<T, N> {
    type Output = Self;

    /// `v_i / s`, a division for each entry.
    #[inline(always)]
    fn div(self, divisor: T) -> Self {
        self.map(|x| x / divisor)
    }
}
