// SHA-256 of the text below: 33e4446bddbd912c3d0d8e65766a2586678cc689de7eaf8319b9af63849cb428
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `flexible_joint`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 6 monomials `basis2` of z = (`z1`, `v1`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 2>) -> Vector<T, 6> {
    let one = T::one();
    let z1 = z[0];
    let v1 = z[1];
    let z12 = z1 * z1;
    let z1_v1 = z1 * v1;
    let v12 = v1 * v1;
    Vector([one, z1, v1, z12, z1_v1, v12])
}

/// Rates of the 6 monomials `basis2` of z = (`z1`, `v1`), along the rate `z_d1` of z.
#[inline(always)]
pub fn basis2_rate<T: Real>(z: Vector<T, 2>, z_d1: Vector<T, 2>) -> Vector<T, 6> {
    let one_d1 = T::zero();
    let z1 = z[0];
    let z1_d1 = z_d1[0];
    let v1 = z[1];
    let v1_d1 = z_d1[1];
    let z12_d1 = z1_d1 * z1 + z1 * z1_d1;
    let z1_v1_d1 = z1_d1 * v1 + z1 * v1_d1;
    let v12_d1 = v1_d1 * v1 + v1 * v1_d1;
    Vector([one_d1, z1_d1, v1_d1, z12_d1, z1_v1_d1, v12_d1])
}
