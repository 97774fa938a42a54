//! One text for scalars and lanes: every lane of every width gives the bits that the scalar gives.

use std::array;
use std::marker::PhantomData;

use nsv_runtime::kernel;
use nsv_runtime::lanes::{self, Kernel, Width};
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Mask, Real};
use nsv_runtime::table::{Axis, Table};

/// Results of one text from some inputs.
trait Text {
    fn results<T: Real>(inputs: &[T]) -> Vec<T>;
}

/// A text on many cases, lane after lane.
struct InLanes<'a, X>(&'a [Vec<f64>], PhantomData<X>);

impl<X: Text> Kernel for InLanes<'_, X> {
    type Output = Vec<Vec<u64>>;

    #[inline(always)]
    fn run<T: Real>(self) -> Self::Output {
        let mut bits = Vec::new();
        for cases in self.0.chunks(T::LANES) {
            let case = |lane: usize| &cases[lane.min(cases.len() - 1)];
            let inputs: Vec<T> = (0..cases[0].len())
                .map(|k| T::from_lanes(|lane| case(lane)[k]))
                .collect();
            let results = X::results(&inputs);
            bits.extend((0..cases.len()).map(|lane| {
                let of_lane = results.iter().map(|result| result.lane(lane));
                // A NaN's sign and payload mean nothing and differ between instructions.
                of_lane
                    .map(|x| if x.is_nan() { f64::NAN } else { x }.to_bits())
                    .collect()
            }));
        }
        bits
    }
}

fn check<X: Text>(cases: &[Vec<f64>]) {
    let kernel = || InLanes(cases, PhantomData::<X>);
    let expected = lanes::run(Width::Scalar, kernel()).expect("a scalar everywhere");
    assert_eq!(lanes::run_portable(kernel()), expected, "portable");
    for width in Width::ALL {
        if let Some(found) = lanes::run(width, kernel()) {
            assert_eq!(found, expected, "{width:?}");
        }
    }
    let expected = lanes::run_single(Width::Scalar, kernel()).expect("a scalar everywhere");
    assert_eq!(lanes::run_portable_single(kernel()), expected, "portable");
    for width in Width::ALL {
        if let Some(found) = lanes::run_single(width, kernel()) {
            assert_eq!(found, expected, "{width:?}, single precision");
        }
    }
}

/// Cases of rounded random numbers, so that lanes meet ties, zeros and different pivots.
fn cases(count: usize, length: usize) -> Vec<Vec<f64>> {
    let case = |k: usize| {
        let noise = Noise::<f64>::process(k as u64, 1);
        (0..length)
            .map(|i| (noise.normal(0, i as u32) * 3.0).round())
            .collect()
    };
    (0..count).map(case).collect()
}

fn matrix<T: Real, const N: usize>(entries: &[T]) -> Matrix<T, N, N> {
    Matrix::rows(array::from_fn(|i| array::from_fn(|j| entries[i * N + j])))
}

struct LinearAlgebra<const N: usize>;

impl<const N: usize> Text for LinearAlgebra<N> {
    fn results<T: Real>(inputs: &[T]) -> Vec<T> {
        let a = matrix::<T, N>(inputs);
        let x = a.solve(a.column(0));
        let singular = a.singular_vector();
        // Some lanes are positive definite, some are not.
        let mut symmetric = a + a.transpose();
        for i in 0..N {
            symmetric[(i, i)] = symmetric[(i, i)] + T::from_f64(3.0 * N as f64);
        }
        [
            x,
            symmetric.ldlt().solve(x),
            a.solve_columns(symmetric).column(N - 1),
            symmetric.ldlt().solve_columns(a).column(N - 1),
            singular,
            a * x,
            a.transpose_mul(singular),
            x.sin(),
            x.tanh(),
            a.mul_fused(x),
            a.transpose_mul_fused(singular),
            x.scale_add(singular[0], singular).mul_add(x, singular),
        ]
        .iter()
        .flat_map(|vector| vector.0)
        .chain([a.sum_squares(), x.dot(singular)])
        .chain([a.sum_squares_fused(), x.dot_fused(singular)])
        .collect()
    }
}

#[test]
fn linear_algebra_agrees_lane_by_lane() {
    check::<LinearAlgebra<1>>(&cases(40, 1));
    check::<LinearAlgebra<2>>(&cases(40, 4));
    check::<LinearAlgebra<3>>(&cases(40, 9));
    check::<LinearAlgebra<5>>(&cases(40, 25));
    check::<LinearAlgebra<9>>(&cases(10, 81));
}

struct Angles;

impl Text for Angles {
    fn results<T: Real>(inputs: &[T]) -> Vec<T> {
        let angles = Vector::<T, 3>(array::from_fn(|i| inputs[i]));
        let results = [
            angles.sin(),
            angles.cos(),
            angles.tan(),
            angles.sin_fused(),
            angles.cos_fused(),
            angles.tan_fused(),
        ];
        let alone = Vector([inputs[0]]);
        let others = [alone.sin(), alone.cos_fused()];
        let values = results.iter().flat_map(|vector| vector.0);
        values.chain(others.map(|vector| vector[0])).collect()
    }
}

#[test]
fn arrays_of_angles_agree_where_one_of_them_is_large() {
    let angles = [
        0.3,
        -2.0,
        1e4,
        1e5,
        1e6,
        -1e22,
        f64::INFINITY,
        f64::NAN,
        -0.0,
    ];
    let cases = (0..200).map(|k| {
        [k, k * 5 + k / 9, k * 7 + k / 3]
            .map(|at| angles[at % 9])
            .to_vec()
    });
    check::<Angles>(&cases.collect::<Vec<_>>());
}

struct Kernels;

impl Text for Kernels {
    fn results<T: Real>(inputs: &[T]) -> Vec<T> {
        let e = inputs[0];
        vec![
            kernel::sin_cos_over(e),
            kernel::sin_cos_over_d1(e),
            kernel::sin_cos_over_d2(e),
            kernel::sin_cos_over_d3(e),
            kernel::tan_over(e),
        ]
    }
}

#[test]
fn kernels_agree_lane_by_lane_on_both_sides_of_their_threshold() {
    let arguments = [0.0, 1.2, 0.3, 1.5, 0.99, 1.0, -0.5, -1.57, 1e-300];
    check::<Kernels>(&arguments.map(|e| vec![e]));
}

struct Choices;

impl Text for Choices {
    fn results<T: Real>(inputs: &[T]) -> Vec<T> {
        let (a, b) = (inputs[0], inputs[1]);
        let number = |mask| T::select(mask, T::one(), T::zero());
        let relations = [
            a.lt(b),
            a.le(b),
            a.gt(b),
            a.ge(b),
            a.eq(b),
            a.ne(b),
            a.is_finite(),
            a.lt(b).or(b.is_finite().not()),
            T::Mask::from_bits(a.le(b).to_bits()),
        ];
        let mut results: Vec<T> = relations.map(number).to_vec();
        results.extend([
            a.min(b),
            a.max(b),
            a.sign(),
            a.abs(),
            -a,
            a.powi(5),
            a.sqrt(),
        ]);
        results.extend([a + b, a - b, a * b, a / b]);
        results.push(T::from_bits(a.to_bits()));
        results
    }
}

#[test]
fn comparisons_and_choices_agree_lane_by_lane() {
    let special = [
        0.0,
        -0.0,
        1.0,
        -2.5,
        1e-310,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    let pairs = special
        .iter()
        .flat_map(|&a| special.map(|b| vec![a, b]))
        .collect::<Vec<_>>();
    check::<Choices>(&pairs);
}

struct OneBadLane;

impl Kernel for OneBadLane {
    type Output = ();

    #[inline(always)]
    fn run<T: Real>(self) {
        let v: Vector<T, 2> = Vector([
            T::from_lanes(|lane| if lane == 1 { f64::NAN } else { 1.0 }),
            T::from_f64(2.0),
        ]);
        let safe = Vector::select(v.is_finite(), v, Vector::zero());
        for lane in 0..T::LANES {
            let expected = if lane == 1 { [0.0; 2] } else { [1.0, 2.0] };
            assert_eq!(safe.0.map(|x| x.lane(lane)), expected);
        }
    }
}

#[test]
fn one_bad_lane_does_not_touch_the_others() {
    for width in Width::ALL {
        lanes::run(width, OneBadLane);
        lanes::run_single(width, OneBadLane);
    }
}

/// A line and a cube of splines that no spline solver made: any numbers do.
struct Tables;

const LINE: Axis<2> = Axis {
    breaks: &[-2.0, 0.5, 1.0, 3.0],
    splines: &[
        [[1.0, -0.4], [0.0, 0.4]],
        [[1.0, -2.0], [0.0, 2.0]],
        [[1.0, -0.5], [0.0, 0.5]],
    ],
};
const CURVE: Axis<4> = Axis {
    breaks: &[-3.0, 0.0, 4.0],
    splines: &[
        [
            [1.0, -1.1, 0.3, -0.05],
            [0.1, 1.3, -0.6, 0.08],
            [0.0, 0.1, 0.2, -0.05],
            [0.0, 0.0, 0.0, 0.01],
        ],
        [
            [0.2, -0.3, 0.1, -0.02],
            [0.5, -0.1, -0.2, 0.07],
            [0.3, 0.3, 0.1, -0.1],
            [0.0, 0.0, 0.0, 0.08],
        ],
    ],
};

impl Text for Tables {
    fn results<T: Real>(inputs: &[T]) -> Vec<T> {
        let line = Table {
            axes: [LINE],
            curves: &[[0.3, -2.0], [-1.7, 4.2], [2.5, -1.2]],
            held: true,
        };
        let power = |at: usize| (at * 37 % 101) as f64 / 7.0 - 6.0;
        let curves: &'static [[f64; 4]; 50] = Box::leak(Box::new(array::from_fn(|at| {
            array::from_fn(|m| power(4 * at + m))
        })));
        let cube = Table {
            axes: [CURVE; 3],
            curves,
            held: false,
        };
        let [x, y, z] = [inputs[0], inputs[1], inputs[2]];
        vec![
            line.value([0], [x]),
            line.value([1], [y]),
            cube.value([0, 0, 0], [x, y, z]),
            cube.value([1, 2, 0], [z, x, y]),
        ]
    }
}

#[test]
fn tables_are_the_same_in_every_width() {
    let mut cases = cases(200, 3);
    for special in [f64::NAN, f64::INFINITY, -0.0, 1e300, 0.5, 4.0] {
        cases.push(vec![special, 0.25, special]);
    }
    check::<Tables>(&cases);
}
