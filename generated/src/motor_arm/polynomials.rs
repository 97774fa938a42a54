// SHA-256 of the text below: d3dbcd3e7828c2822eb3f16fdb2fd8f737706586096436f6d5094be02878bad6
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 9b566d21e10b4a5e1287aa6d56b2ef282dc67247857e73edb28387ed4150de95

//! `motor_arm`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 6 monomials `basis2` of z = (`z1`, `rate`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 2>) -> Vector<T, 6> {
    let one = T::one();
    let z1 = z[0];
    let rate = z[1];
    let z12 = z1 * z1;
    let z1_rate = z1 * rate;
    let rate2 = rate * rate;
    Vector([one, z1, rate, z12, z1_rate, rate2])
}

/// Rates of the 6 monomials `basis2` of z = (`z1`, `rate`), along the rate `z_d1` of z.
#[inline(always)]
pub fn basis2_rate<T: Real>(z: Vector<T, 2>, z_d1: Vector<T, 2>) -> Vector<T, 6> {
    let one_d1 = T::zero();
    let z1 = z[0];
    let z1_d1 = z_d1[0];
    let rate = z[1];
    let rate_d1 = z_d1[1];
    let z12_d1 = z1_d1 * z1 + z1 * z1_d1;
    let z1_rate_d1 = z1_d1 * rate + z1 * rate_d1;
    let rate2_d1 = rate_d1 * rate + rate * rate_d1;
    Vector([one_d1, z1_d1, rate_d1, z12_d1, z1_rate_d1, rate2_d1])
}

/// Second rates of the 6 monomials `basis2` of z = (`z1`, `rate`), along the rates `z_d1` and
/// `z_d2` of z.
#[inline(always)]
pub fn basis2_rate2<T: Real>(
    z: Vector<T, 2>,
    z_d1: Vector<T, 2>,
    z_d2: Vector<T, 2>,
) -> Vector<T, 6> {
    let real = T::from_f64;
    let one_d2 = T::zero();
    let z1 = z[0];
    let z1_d1 = z_d1[0];
    let z1_d2 = z_d2[0];
    let rate = z[1];
    let rate_d1 = z_d1[1];
    let rate_d2 = z_d2[1];
    let z12_d2 = z1_d2 * z1 + real(2.0) * z1_d1 * z1_d1 + z1 * z1_d2;
    let z1_rate_d2 = z1_d2 * rate + real(2.0) * z1_d1 * rate_d1 + z1 * rate_d2;
    let rate2_d2 = rate_d2 * rate + real(2.0) * rate_d1 * rate_d1 + rate * rate_d2;
    Vector([one_d2, z1_d2, rate_d2, z12_d2, z1_rate_d2, rate2_d2])
}
