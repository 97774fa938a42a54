//! The smooth kernels of the barrier Lyapunov function. With S(z) = sin z / z and z = 2E: sin E cos E / E = S(2E), and its k-th derivative
//! by E is 2^k S^(k)(2E). Below |z| = 2 the quotients cancel, so Taylor series take over; they are exact to the last place there.

use nsv_math::real::Real;

use crate::ir::Kernel;

/// Argument |z| below which the derivatives are evaluated by their series.
const SERIES_BELOW: f64 = 2.0;

/// S'(z)/z in powers of z^2: c_j = (-1)^(j+1) (2j + 2)/(2j + 3)!
const FIRST: [f64; 12] = [
    -0.3333333333333333,
    0.03333333333333333,
    -0.0011904761904761906,
    2.2045855379188714e-5,
    -2.505210838544172e-7,
    1.9270852604185937e-9,
    -1.0706029224547743e-11,
    4.498331606952833e-14,
    -1.4797143443923793e-16,
    3.9145882126782523e-19,
    -8.509974375387505e-22,
    1.5472680682522736e-24,
];

/// S''(z) in powers of z^2: c_j = (-1)^(j+1) (2j + 2)(2j + 1)/(2j + 3)!
const SECOND: [f64; 12] = [
    -0.3333333333333333,
    0.1,
    -0.005952380952380952,
    0.00015432098765432098,
    -2.2546897546897547e-6,
    2.1197937864604532e-8,
    -1.3917837991912066e-10,
    6.74749741042925e-13,
    -2.515514385467045e-15,
    7.437717604088679e-18,
    -1.787094618831376e-20,
    3.5587165569802293e-23,
];

/// S'''(z)/z in powers of z^2: c_j = (-1)^j (2j + 4)(2j + 3)(2j + 2)/(2j + 5)!
const THIRD: [f64; 12] = [
    0.2,
    -0.023809523809523808,
    0.000925925925925926,
    -1.8037518037518038e-5,
    2.119793786460453e-7,
    -1.6701405590294479e-9,
    9.44649637460095e-12,
    -4.024823016747272e-14,
    1.3387891687359624e-16,
    -3.574189237662752e-19,
    7.829176425356505e-22,
    -1.4326556187521052e-24,
];

/// A kernel at E.
pub(super) fn kernel(kernel: Kernel, e: f64) -> f64 {
    let z = e + e;
    match kernel {
        Kernel::SinCosOver if z == 0.0 => 1.0,
        Kernel::SinCosOver => Real::sin(z) / z,
        Kernel::SinCosOverD1 => 2.0 * first(z),
        Kernel::SinCosOverD2 => 4.0 * second(z),
        Kernel::SinCosOverD3 => 8.0 * third(z),
        Kernel::TanOver if e == 0.0 => 1.0,
        Kernel::TanOver => Real::tan(e) / e,
    }
}

/// S'(z)
fn first(z: f64) -> f64 {
    if z.abs() < SERIES_BELOW {
        z * series(&FIRST, z * z)
    } else {
        quotients(z).0
    }
}

/// S''(z)
fn second(z: f64) -> f64 {
    if z.abs() < SERIES_BELOW {
        series(&SECOND, z * z)
    } else {
        quotients(z).1
    }
}

/// S'''(z)
fn third(z: f64) -> f64 {
    if z.abs() < SERIES_BELOW {
        return z * series(&THIRD, z * z);
    }
    let (first, second) = quotients(z);
    let g = second - first / z;
    -(first + (g + g) / z)
}

/// S'(z) and S''(z) by the recurrence S^(k) = (d^k sin z - k S^(k-1)) / z, away from 0.
fn quotients(z: f64) -> (f64, f64) {
    let s0 = Real::sin(z) / z;
    let s1 = (Real::cos(z) - s0) / z;
    (s1, -(s0 + (s1 + s1) / z))
}

/// Horner's scheme in w.
fn series(coefficients: &[f64; 12], w: f64) -> f64 {
    let [lower @ .., last] = coefficients;
    lower.iter().rev().fold(*last, |r, c| r * w + c)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(coefficients: &[f64; 12], exact: impl Fn(i32) -> f64) {
        for (j, c) in (0..).zip(coefficients) {
            let expected = exact(j);
            assert!(
                (c - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
                "coefficient {j}: {c}, expected {expected}"
            );
        }
    }

    #[test]
    fn coefficients_are_those_of_the_taylor_series() {
        let factorial = |n: i32| (2..=n).fold(1.0, |product, k| product * f64::from(k));
        let sign = |j: i32| if j % 2 == 0 { 1.0 } else { -1.0 };
        check(&FIRST, |j| {
            -sign(j) * f64::from(2 * j + 2) / factorial(2 * j + 3)
        });
        check(&SECOND, |j| {
            -sign(j) * f64::from((2 * j + 2) * (2 * j + 1)) / factorial(2 * j + 3)
        });
        check(&THIRD, |j| {
            sign(j) * f64::from((2 * j + 4) * (2 * j + 3) * (2 * j + 2)) / factorial(2 * j + 5)
        });
    }

    #[test]
    fn derivatives_are_difference_quotients_of_the_kernel_below() {
        use Kernel::{SinCosOver, SinCosOverD1, SinCosOverD2, SinCosOverD3};
        let h = 1e-5;
        for (lower, upper) in [
            (SinCosOver, SinCosOverD1),
            (SinCosOverD1, SinCosOverD2),
            (SinCosOverD2, SinCosOverD3),
        ] {
            for e in [-1.5, -0.9, -0.3, 0.0, 1e-3, 0.5, 0.99, 1.01, 1.4] {
                let difference = (kernel(lower, e + h) - kernel(lower, e - h)) / (2.0 * h);
                assert!(
                    (kernel(upper, e) - difference).abs() < 1e-8,
                    "{upper:?} at {e}"
                );
            }
        }
    }

    #[test]
    fn kernels_are_one_at_zero() {
        for e in [0.0, -0.0, 5e-324] {
            assert_eq!(
                (kernel(Kernel::SinCosOver, e), kernel(Kernel::TanOver, e)),
                (1.0, 1.0)
            );
        }
    }
}
