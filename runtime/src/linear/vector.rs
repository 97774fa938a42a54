//! Column vectors.

use core::ops::{Index, IndexMut};

use super::elementwise::{elementwise, operators};
use super::{Each, Each2, Each3, Matrix, dot, sum};
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
        let mut i = 0;
        while i < N {
            vector.0[i] = T::from_f64(entries[i]);
            i += 1;
        }
        vector
    }

    /// The entries of one lane in every lane, as [`Real::in_every_lane`].
    #[inline(always)]
    pub fn in_every_lane(&self, lane: usize) -> Self {
        let mut vector = Self::zero();
        let mut i = 0;
        while i < N {
            vector.0[i] = self.0[i].in_every_lane(lane);
            i += 1;
        }
        vector
    }

    elementwise!();

    /// `f` of each entry.
    #[inline(always)]
    pub fn each(self, f: impl Each) -> Self {
        let mut results = Self::zero();
        T::each(f, &self.0, &mut results.0);
        results
    }

    /// `f` of the entries at each place.
    #[inline(always)]
    pub fn each2(mut self, f: impl Each2, other: &Self) -> Self {
        T::each2(f, &mut self.0, &other.0);
        self
    }

    /// `f` of the entries at each place.
    #[inline(always)]
    pub fn each3(mut self, f: impl Each3, y: &Self, z: &Self) -> Self {
        T::each3(f, &mut self.0, [&y.0, &z.0]);
        self
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: Self, b: Self) -> Self {
        let mut result = a;
        let mut i = 0;
        while i < N {
            result.0[i] = T::select(mask, a.0[i], b.0[i]);
            i += 1;
        }
        result
    }

    /// Inner product `a_0 b_0 + a_1 b_1 + ...`, by the rule of [sums](super).
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        dot::<T, false>(&self.0, &other.0)
    }

    /// As [`Vector::dot`], fused.
    #[inline(always)]
    pub fn dot_fused(self, other: Self) -> T {
        dot::<T, true>(&self.0, &other.0)
    }

    /// `v_0 v_0 + v_1 v_1 + ...`, by the rule of [sums](super).
    #[inline(always)]
    pub fn sum_squares(self) -> T {
        self.dot(self)
    }

    /// As [`Vector::sum_squares`], fused.
    #[inline(always)]
    pub fn sum_squares_fused(self) -> T {
        self.dot_fused(self)
    }

    /// `a b^T`: entry (i, j) is `a_i b_j`.
    #[inline(always)]
    pub fn outer<const C: usize>(self, other: Vector<T, C>) -> Matrix<T, N, C> {
        let mut product = Matrix::zero();
        let mut j = 0;
        while j < C {
            *product.column_mut(j) = self * other.0[j];
            j += 1;
        }
        product
    }

    /// Whether every entry is finite, and so are sums of them: entries whose sums overflow, beyond 1e307 or so, count as not finite.
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        sum(&self.0).is_finite()
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
