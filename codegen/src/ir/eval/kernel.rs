//! The smooth kernels of the barrier Lyapunov function: f(E) = sin E cos E / E, its derivatives, and tan E / E. Inside the barrier, where
//! |E| < pi/2, a derivative is a polynomial in E^2; outside it comes from S(z) = sin z / z, since f(E) = S(2E).

use nsv_math::real::Real;

use crate::ir::Kernel;

/// |E| up to which the derivatives are polynomials, a little more than pi/2.
const LIMIT: f64 = 1.571;

/// f'(E)/E in powers of E^2 - 5/2.
const FIRST: [f64; 11] = [
    -0.3972981463641549,
    0.24361145339364426,
    -0.042346097423987726,
    0.0035207485716311484,
    -0.0001728002764066365,
    5.61715022099797e-6,
    -1.3009471791040576e-7,
    2.25822048969255e-9,
    -3.0495103330421104e-11,
    3.287070442428272e-13,
    -3.1569745725704106e-15,
];

/// f''(E) in powers of E^2 - 5/4.
const SECOND: [f64; 11] = [
    0.14320882342978897,
    0.8157860142157198,
    -0.2528341616146013,
    0.029233423515949323,
    -0.0018166664737930638,
    7.110571368895169e-5,
    -1.9209780925772513e-6,
    3.80477235726973e-8,
    -5.767709294757579e-10,
    6.913962051050824e-12,
    -6.714499386240045e-14,
];

/// f'''(E)/E in powers of E^2 - 5/2.
const THIRD: [f64; 11] = [
    0.6147467718820442,
    -0.6356770341826482,
    0.12713540683652755,
    -0.01131818986361654,
    0.0005788581017905622,
    -1.9346327179404064e-5,
    4.5714889431588463e-7,
    -8.057022137311558e-9,
    1.1012833668371847e-10,
    -1.1956984027087386e-12,
    1.18134534028678e-14,
];

/// A kernel at E.
pub(super) fn kernel(kernel: Kernel, e: f64) -> f64 {
    let outside = e.abs() > LIMIT;
    match kernel {
        Kernel::SinCosOver | Kernel::TanOver if e == 0.0 => 1.0,
        Kernel::SinCosOver => Real::sin(e) * Real::cos(e) / e,
        Kernel::TanOver => Real::tan(e) / e,
        Kernel::SinCosOverD1 if outside => 2.0 * first(e + e),
        Kernel::SinCosOverD1 => e * polynomial(&FIRST, e * e - 2.5),
        Kernel::SinCosOverD2 if outside => 4.0 * second(e + e),
        Kernel::SinCosOverD2 => polynomial(&SECOND, e * e - 1.25),
        Kernel::SinCosOverD3 if outside => 8.0 * third(e + e),
        Kernel::SinCosOverD3 => e * polynomial(&THIRD, e * e - 2.5),
    }
}

/// S'(z) by the recurrence S^(k) = (d^k sin z - k S^(k-1)) / z.
fn first(z: f64) -> f64 {
    (Real::cos(z) - Real::sin(z) / z) / z
}

/// S''(z)
fn second(z: f64) -> f64 {
    let s1 = first(z);
    -(Real::sin(z) / z + (s1 + s1) / z)
}

/// S'''(z)
fn third(z: f64) -> f64 {
    let s1 = first(z);
    let g = second(z) - s1 / z;
    -(s1 + (g + g) / z)
}

/// The polynomial in t, its even and its odd powers by Horner's scheme in w = t^2.
fn polynomial(coefficients: &[f64; 11], t: f64) -> f64 {
    let w = t * t;
    let every_second = |from: usize| {
        let chain = coefficients[from..].iter().step_by(2);
        chain.rev().copied().reduce(|r, c| r * w + c)
    };
    let [even, odd] =
        [0, 1].map(|from| every_second(from).expect("invariant: eleven coefficients"));
    even + t * odd
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_difference_quotients_of_the_kernel_below() {
        use Kernel::{SinCosOver, SinCosOverD1, SinCosOverD2, SinCosOverD3};
        let h = 1e-5;
        for (lower, upper) in [
            (SinCosOver, SinCosOverD1),
            (SinCosOverD1, SinCosOverD2),
            (SinCosOverD2, SinCosOverD3),
        ] {
            for e in [-1.5, -0.9, -0.3, 0.0, 1e-3, 0.5, 0.99, 1.4, 1.55, 1.6] {
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
