//! Time per number of what emitted code calls, in every width of lanes: `cargo bench --package nsv-runtime --features std`.
//!
//! Throughput: the calls of a loop do not depend on each other except by the sum of their results.

use std::marker::PhantomData;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use nsv_runtime::kernel;
use nsv_runtime::lanes::{self, Kernel, Width};
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;
use nsv_runtime::real::Real;

const CALLS: usize = 256;

fn main() {
    divan::main();
}

/// A function of one number.
trait Work {
    fn of<T: Real>(x: T) -> T;
}

/// A function of one number of the type `T`.
macro_rules! work {
    ($name:ident, |$x:ident| $value:expr) => {
        struct $name;

        impl Work for $name {
            #[inline(always)]
            fn of<T: Real>($x: T) -> T {
                $value
            }
        }
    };
}

/// Calls of a function with arguments that move up from 0.1.
struct Calls<W>(PhantomData<W>);

impl<W: Work> Kernel for Calls<W> {
    type Output = f64;

    #[inline(always)]
    fn run<T: Real>(self) -> f64 {
        let (mut x, increment) = (T::from_f64(black_box(0.1)), T::from_f64(black_box(1e-3)));
        let mut sum = T::zero();
        for _ in 0..CALLS {
            sum = sum + W::of(x);
            x = x + increment;
        }
        sum.to_f64()
    }
}

fn bench<W: Work>(bencher: Bencher<'_, '_>, width: Width) {
    bencher
        .counter(ItemsCount::new(CALLS * width.lanes()))
        .bench(|| lanes::run(width, Calls::<W>(PhantomData)));
}

work!(Sqrt, |x| x.sqrt());
work!(Exp, |x| x.exp());
work!(Ln, |x| x.ln());
work!(Sin, |x| x.sin());
work!(SinAndCos, |x| x.sin() + x.cos());
work!(Tan, |x| x.tan());
work!(Tanh, |x| x.tanh());
work!(Atan2, |x| x.atan2(T::one()));

#[divan::bench(types = [Sqrt, Exp, Ln, Sin, SinAndCos, Tan, Tanh, Atan2], args = Width::ALL)]
fn elementary<W: Work>(bencher: Bencher<'_, '_>, width: Width) {
    bench::<W>(bencher, width);
}

work!(SinCosOver, |x| kernel::sin_cos_over(x));
work!(SinCosOverD1, |x| kernel::sin_cos_over_d1(x));
work!(TanOver, |x| kernel::tan_over(x));

#[divan::bench(types = [SinCosOver, SinCosOverD1, TanOver], args = Width::ALL)]
fn barrier<W: Work>(bencher: Bencher<'_, '_>, width: Width) {
    bench::<W>(bencher, width);
}

/// A matrix whose diagonal dominates, with `x` in each entry.
#[inline(always)]
fn matrix<T: Real, const N: usize>(x: T) -> Matrix<T, N, N> {
    let mut matrix = Matrix::splat(x);
    for i in 0..N {
        matrix[(i, i)] = T::from_f64((N + i) as f64);
    }
    matrix
}

work!(Solve1, |x| matrix::<T, 1>(x).solve(Vector::splat(T::one()))
    [0]);
work!(Solve2, |x| matrix::<T, 2>(x).solve(Vector::splat(T::one()))
    [0]);
work!(Solve3, |x| matrix::<T, 3>(x).solve(Vector::splat(T::one()))
    [0]);
work!(Solve6, |x| matrix::<T, 6>(x).solve(Vector::splat(T::one()))
    [0]);
work!(Ldlt6, |x| matrix::<T, 6>(x)
    .ldlt()
    .solve(Vector::splat(T::one()))[0]);
work!(SingularVector, |x| matrix::<T, 3>(x).singular_vector()[0]);
work!(Product, |x| (matrix::<T, 6>(x) * Vector::splat(x))
    .sum_squares());

#[divan::bench(types = [Solve1, Solve2, Solve3, Solve6, Ldlt6, SingularVector, Product], args = Width::ALL)]
fn linear<W: Work>(bencher: Bencher<'_, '_>, width: Width) {
    bench::<W>(bencher, width);
}

/// Draws of `N` channels.
struct Normals<const N: usize>;

impl<const N: usize> Kernel for Normals<N> {
    type Output = f64;

    #[inline(always)]
    fn run<T: Real>(self) -> f64 {
        let noise = Noise::<T>::process(black_box(1), 0);
        let mut sum = T::zero();
        for step in 0..CALLS {
            sum = sum + noise.normals::<N>(step as u64).sum_squares();
        }
        sum.to_f64()
    }
}

/// Time per normal draw.
#[divan::bench(consts = [1, 2, 9], args = Width::ALL)]
fn noise<const N: usize>(bencher: Bencher<'_, '_>, width: Width) {
    bencher
        .counter(ItemsCount::new(CALLS * width.lanes() * N))
        .bench(|| lanes::run(width, Normals::<N>));
}
