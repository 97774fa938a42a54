//! Small dense vectors and matrices of fixed size, on the stack.
//!
//! Sums follow one rule: up to seven terms are added left to right, `((t0 + t1) + t2) + ...`. From eight on there are eight partial sums,
//! term k in sum k mod 8, which are then added in halves: `u_l = s_l + s_l+4`, `v_l = u_l + u_l+2`, `v_0 + v_1`. So a sum waits less for
//! itself, loses fewer digits, and fits vector registers of every width. Elementwise operations are one operation per entry.
//!
//! Methods whose name ends in `_fused` do not round a product before they add it to a sum; the first product of a sum is rounded.
//!
//! Matrices are stored by columns, which are what products and outer products combine. Everything is inlined into its caller, which may be
//! compiled for an instruction set that this crate is not; what is done with each entry is an [`Each`] or [`Each2`], because a closure
//! might be left outside.

mod elementwise;
mod elimination;
mod ldlt;
mod matrix;
mod singular;
mod vector;

pub use ldlt::Ldlt;
pub use matrix::Matrix;
pub use vector::Vector;

use crate::entries::{Each, Each2, Each3};
use crate::real::Real;
use elementwise::{AddProduct, Mul, Plus};

/// Number of partial sums of a long sum.
const PARTIAL: usize = 8;

/// `a_0 b_0 + a_1 b_1 + ...` by the rule of sums; 0 without terms. With `FUSED`, a product that is added to a sum is not rounded.
#[inline(always)]
fn dot<T: Real, const FUSED: bool>(a: &[T], b: &[T]) -> T {
    if FUSED && a.len() < PARTIAL {
        return left_to_right_fused(a, b);
    }
    let mut sums = [T::zero(); PARTIAL];
    let mut done = 0;
    while done < a.len() {
        let count = (a.len() - done).min(PARTIAL);
        let (a, b) = (&a[done..done + count], &b[done..done + count]);
        if FUSED && done > 0 {
            T::each3(AddProduct, &mut sums[..count], [a, b]);
        } else {
            let mut products = [T::zero(); PARTIAL];
            products[..count].copy_from_slice(a);
            T::each2(Mul, &mut products[..count], b);
            if done == 0 {
                sums = products;
            } else {
                T::each2(Plus, &mut sums[..count], &products[..count]);
            }
        }
        done += count;
    }
    total(sums, a.len())
}

#[inline(always)]
fn left_to_right_fused<T: Real>(a: &[T], b: &[T]) -> T {
    if a.is_empty() {
        return T::zero();
    }
    let mut total = a[0] * b[0];
    let mut i = 1;
    while i < a.len() {
        total = a[i].mul_add(b[i], total);
        i += 1;
    }
    total
}

/// `a_0 + a_1 + ...` by the rule of sums; 0 without terms.
#[inline(always)]
fn sum<T: Real>(terms: &[T]) -> T {
    let mut sums = [T::zero(); PARTIAL];
    let mut done = 0;
    while done < terms.len() {
        let count = (terms.len() - done).min(PARTIAL);
        let next = &terms[done..done + count];
        if done == 0 {
            sums[..count].copy_from_slice(next);
        } else {
            T::each2(Plus, &mut sums[..count], next);
        }
        done += count;
    }
    total(sums, terms.len())
}

/// The total of the partial sums of `count` terms.
#[inline(always)]
fn total<T: Real>(sums: [T; PARTIAL], count: usize) -> T {
    if count < PARTIAL {
        let mut total = sums[0];
        let mut i = 1;
        while i < count {
            total = total + sums[i];
            i += 1;
        }
        return total;
    }
    let [a, b, c, d, e, f, g, h] = sums;
    let mut half = [a, b, c, d];
    T::each2(Plus, &mut half, &[e, f, g, h]);
    let [a, b, c, d] = half;
    let mut quarter = [a, b];
    T::each2(Plus, &mut quarter, &[c, d]);
    quarter[0] + quarter[1]
}

/// Adds numbers to partial sums.
#[inline(always)]
fn add_to<T: Real>(sums: &mut [T; PARTIAL], numbers: &[T]) {
    let mut done = 0;
    while done < numbers.len() {
        let count = (numbers.len() - done).min(PARTIAL);
        T::each2(Plus, &mut sums[..count], &numbers[done..done + count]);
        done += count;
    }
}
