// SHA-256 of the text below: a0ae259af6220d8454e9f29ca309583a8f0a0f0feee1815ca20110b5d02abe76
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `two_link_arm`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 20 monomials `basis2` of z = (`v1`, `v2`, `q2`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 3>) -> Vector<T, 20> {
    let one = T::one();
    let v1 = z[0];
    let v2 = z[1];
    let q2 = z[2];
    let v12 = v1 * v1;
    let v1_v2 = v1 * v2;
    let v1_q2 = v1 * q2;
    let v22 = v2 * v2;
    let v2_q2 = v2 * q2;
    let q22 = q2 * q2;
    let v13 = v12 * v1;
    let v12_v2 = v12 * v2;
    let v12_q2 = v12 * q2;
    let v1_v22 = v1_v2 * v2;
    let v1_v2_q2 = v1_v2 * q2;
    let v1_q22 = v1_q2 * q2;
    let v23 = v22 * v2;
    let v22_q2 = v22 * q2;
    let v2_q22 = v2_q2 * q2;
    let q23 = q22 * q2;
    Vector([
        one,
        v1,
        v2,
        q2,
        v12,
        v1_v2,
        v1_q2,
        v22,
        v2_q2,
        q22,
        v13,
        v12_v2,
        v12_q2,
        v1_v22,
        v1_v2_q2,
        v1_q22,
        v23,
        v22_q2,
        v2_q22,
        q23,
    ])
}
