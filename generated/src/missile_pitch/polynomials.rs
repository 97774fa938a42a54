// SHA-256 of the text below: 0ad574198b2a928a0d27d4472bb83f8b538a47ebc9f335a1016f023d83373c9b
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `missile_pitch`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 6 monomials `basis2` of z = (`alpha`, `q`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 2>) -> Vector<T, 6> {
    let one = T::one();
    let alpha = z[0];
    let q = z[1];
    let alpha2 = alpha * alpha;
    let alpha_q = alpha * q;
    let q2 = q * q;
    Vector([one, alpha, q, alpha2, alpha_q, q2])
}

/// Rates of the 6 monomials `basis2` of z = (`alpha`, `q`), along the rate `z_d1` of z.
#[inline(always)]
pub fn basis2_rate<T: Real>(z: Vector<T, 2>, z_d1: Vector<T, 2>) -> Vector<T, 6> {
    let one_d1 = T::zero();
    let alpha = z[0];
    let alpha_d1 = z_d1[0];
    let q = z[1];
    let q_d1 = z_d1[1];
    let alpha2_d1 = alpha_d1 * alpha + alpha * alpha_d1;
    let alpha_q_d1 = alpha_d1 * q + alpha * q_d1;
    let q2_d1 = q_d1 * q + q * q_d1;
    Vector([one_d1, alpha_d1, q_d1, alpha2_d1, alpha_q_d1, q2_d1])
}
