//! One text for scalars and lanes: a two-lane number gives in each lane the bits that the scalar gives.

use std::array;
use std::ops::{Add, Div, Mul, Neg, Sub};

use nsv_runtime::kernel;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Mask, Real};

#[derive(Clone, Copy, Debug)]
struct Pair([f64; 2]);

#[derive(Clone, Copy, Debug)]
struct PairMask([bool; 2]);

impl Pair {
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(array::from_fn(|i| f(self.0[i], other.0[i])))
    }

    fn compare(self, other: Self, f: impl Fn(f64, f64) -> bool) -> PairMask {
        PairMask(array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl Mask for PairMask {
    fn splat(value: bool) -> Self {
        Self([value; 2])
    }
    fn and(self, other: Self) -> Self {
        Self(array::from_fn(|i| self.0[i] & other.0[i]))
    }
    fn or(self, other: Self) -> Self {
        Self(array::from_fn(|i| self.0[i] | other.0[i]))
    }
    fn not(self) -> Self {
        Self(self.0.map(|x| !x))
    }
    fn any(self) -> bool {
        self.0[0] | self.0[1]
    }
    fn all(self) -> bool {
        self.0[0] & self.0[1]
    }
}

impl Add for Pair {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Pair {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Pair {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl Div for Pair {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }
}

impl Neg for Pair {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl Real for Pair {
    type Mask = PairMask;

    fn from_f64(value: f64) -> Self {
        Self([value; 2])
    }
    fn to_f64(self) -> f64 {
        self.0[0]
    }
    fn select(mask: PairMask, a: Self, b: Self) -> Self {
        Self(array::from_fn(|i| if mask.0[i] { a.0[i] } else { b.0[i] }))
    }
    fn lt(self, other: Self) -> PairMask {
        self.compare(other, |a, b| a < b)
    }
    fn le(self, other: Self) -> PairMask {
        self.compare(other, |a, b| a <= b)
    }
    fn gt(self, other: Self) -> PairMask {
        self.compare(other, |a, b| a > b)
    }
    fn ge(self, other: Self) -> PairMask {
        self.compare(other, |a, b| a >= b)
    }
    fn eq(self, other: Self) -> PairMask {
        self.compare(other, |a, b| a == b)
    }
    fn ne(self, other: Self) -> PairMask {
        self.compare(other, |a, b| a != b)
    }
    fn is_finite(self) -> PairMask {
        PairMask(self.0.map(f64::is_finite))
    }
    fn abs(self) -> Self {
        self.map(Real::abs)
    }
    fn sqrt(self) -> Self {
        self.map(Real::sqrt)
    }
    fn exp(self) -> Self {
        self.map(Real::exp)
    }
    fn ln(self) -> Self {
        self.map(Real::ln)
    }
    fn sin(self) -> Self {
        self.map(Real::sin)
    }
    fn cos(self) -> Self {
        self.map(Real::cos)
    }
    fn tan(self) -> Self {
        self.map(Real::tan)
    }
    fn asin(self) -> Self {
        self.map(Real::asin)
    }
    fn acos(self) -> Self {
        self.map(Real::acos)
    }
    fn atan(self) -> Self {
        self.map(Real::atan)
    }
    fn sinh(self) -> Self {
        self.map(Real::sinh)
    }
    fn cosh(self) -> Self {
        self.map(Real::cosh)
    }
    fn tanh(self) -> Self {
        self.map(Real::tanh)
    }
    fn atan2(self, other: Self) -> Self {
        self.zip(other, Real::atan2)
    }
    fn pow(self, exponent: Self) -> Self {
        self.zip(exponent, Real::pow)
    }
}

fn check<const N: usize>(found: [Pair; N], lanes: [[f64; N]; 2]) {
    for (lane, expected) in lanes.into_iter().enumerate() {
        assert_eq!(
            found.map(|x| x.0[lane].to_bits()),
            expected.map(f64::to_bits),
            "lane {lane}"
        );
    }
}

fn entries<const N: usize>(seed: u64) -> [[f64; N]; N] {
    let noise = Noise::process(seed, 1);
    // Rounded, so that lanes meet ties, zeros and different pivots.
    array::from_fn(|i| array::from_fn(|j| (noise.normal(i as u64, j as u32) * 3.0).round()))
}

fn pair<const N: usize>(a: [[f64; N]; N], b: [[f64; N]; N]) -> Matrix<Pair, N, N> {
    Matrix(array::from_fn(|i| {
        array::from_fn(|j| Pair([a[i][j], b[i][j]]))
    }))
}

#[test]
fn solutions_and_singular_vectors_agree_lane_by_lane() {
    fn solve<const N: usize>(seed: u64) {
        let (a, b) = (entries::<N>(seed), entries::<N>(seed + 1000));
        let together = pair(a, b);
        check(
            together.solve(together.column(0)).0,
            [a, b].map(|m| Matrix(m).solve(Matrix(m).column(0)).0),
        );
        check(
            together.singular_vector().0,
            [a, b].map(|m| Matrix(m).singular_vector().0),
        );
    }
    // A singular matrix gives NaN or infinity in its own lane only; the seeds here are regular, bits of NaN are not compared.
    for seed in [1, 2, 4, 5] {
        solve::<1>(seed);
        solve::<2>(seed);
        solve::<3>(seed);
        solve::<5>(seed);
    }
}

#[test]
fn kernels_agree_lane_by_lane_on_both_sides_of_their_threshold() {
    for (near, far) in [(0.0, 1.2), (0.3, 1.5), (0.99, 1.0)] {
        let both = Pair([near, far]);
        check(
            [kernel::sin_cos_over(both)],
            [near, far].map(|e| [kernel::sin_cos_over(e)]),
        );
        check(
            [kernel::sin_cos_over_d1(both)],
            [near, far].map(|e| [kernel::sin_cos_over_d1(e)]),
        );
        check(
            [kernel::sin_cos_over_d2(both)],
            [near, far].map(|e| [kernel::sin_cos_over_d2(e)]),
        );
        check(
            [kernel::sin_cos_over_d3(both)],
            [near, far].map(|e| [kernel::sin_cos_over_d3(e)]),
        );
        check(
            [kernel::tan_over(both)],
            [near, far].map(|e| [kernel::tan_over(e)]),
        );
    }
}

#[test]
fn one_bad_lane_does_not_touch_the_other() {
    let v = Vector([Pair([1.0, f64::NAN]), Pair([2.0, 3.0])]);
    let finite = v.is_finite();
    assert!(finite.any() && !finite.all() && finite.0[0]);
    let safe = Vector::select(finite, v, Vector::zero());
    check(safe.0, [[1.0, 2.0], [0.0, 0.0]]);
    check(
        [v[0].sign(), v[0].max(v[1]), v[1].powi(5)],
        [[1.0, 2.0, 32.0], [f64::NAN, 3.0, 243.0]],
    );
}
