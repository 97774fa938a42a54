// SHA-256 of the text below: 6e7c65efd5cfbe9ab84ca5a520a75e65f3fe8917911292933a7db7de835cd7e2
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 f70c25e1cbb23d7ad870996c7841812cb5fb39433bd2cc647b3a6463e631db02

//! `active_suspension`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 10 monomials `basis2` of z = (`z`, `v`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 2>) -> Vector<T, 10> {
    let one = T::one();
    let z_2 = z[0];
    let v = z[1];
    let z2 = z_2 * z_2;
    let z_v = z_2 * v;
    let v2 = v * v;
    let z3 = z2 * z_2;
    let z2_v = z2 * v;
    let z_v2 = z_v * v;
    let v3 = v2 * v;
    Vector([one, z_2, v, z2, z_v, v2, z3, z2_v, z_v2, v3])
}

/// Rates of the 10 monomials `basis2` of z = (`z`, `v`), along the rate `z_d1` of z.
#[inline(always)]
pub fn basis2_rate<T: Real>(z: Vector<T, 2>, z_d1: Vector<T, 2>) -> Vector<T, 10> {
    let one_d1 = T::zero();
    let z_2 = z[0];
    let z_d1_2 = z_d1[0];
    let v = z[1];
    let v_d1 = z_d1[1];
    let z2 = z_2 * z_2;
    let z2_d1 = z_d1_2 * z_2 + z_2 * z_d1_2;
    let z_v = z_2 * v;
    let z_v_d1 = z_d1_2 * v + z_2 * v_d1;
    let v2 = v * v;
    let v2_d1 = v_d1 * v + v * v_d1;
    let z3_d1 = z2_d1 * z_2 + z2 * z_d1_2;
    let z2_v_d1 = z2_d1 * v + z2 * v_d1;
    let z_v2_d1 = z_v_d1 * v + z_v * v_d1;
    let v3_d1 = v2_d1 * v + v2 * v_d1;
    Vector([one_d1, z_d1_2, v_d1, z2_d1, z_v_d1, v2_d1, z3_d1, z2_v_d1, z_v2_d1, v3_d1])
}
