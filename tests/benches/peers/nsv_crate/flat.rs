//! Values as their numbers, row by row.

use std::slice::{Iter, IterMut};

use nsv_runtime::linear::{Matrix, Vector};

/// A value that is read from and written to a flat array.
pub trait Flat {
    fn load(&mut self, from: &mut Iter<'_, f64>);
    fn store(&self, to: &mut IterMut<'_, f64>);
}

impl Flat for f64 {
    fn load(&mut self, from: &mut Iter<'_, f64>) {
        *self = *from.next().unwrap();
    }
    fn store(&self, to: &mut IterMut<'_, f64>) {
        *to.next().unwrap() = *self;
    }
}

impl<const N: usize> Flat for Vector<f64, N> {
    fn load(&mut self, from: &mut Iter<'_, f64>) {
        (0..N).for_each(|i| self[i].load(from));
    }
    fn store(&self, to: &mut IterMut<'_, f64>) {
        (0..N).for_each(|i| self[i].store(to));
    }
}

impl<const R: usize, const C: usize> Flat for Matrix<f64, R, C> {
    fn load(&mut self, from: &mut Iter<'_, f64>) {
        (0..R).for_each(|i| (0..C).for_each(|j| self[(i, j)].load(from)));
    }
    fn store(&self, to: &mut IterMut<'_, f64>) {
        (0..R).for_each(|i| (0..C).for_each(|j| self[(i, j)].store(to)));
    }
}
