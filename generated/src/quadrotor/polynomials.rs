// SHA-256 of the text below: 7a44af6debd693adc7a967761d8da6790d9deeb1cc3c432c8262fe1bfe2def5f
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `quadrotor`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 20 monomials `basis2` of z = (`p`, `q`, `r`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 3>) -> Vector<T, 20> {
    let one = T::one();
    let p = z[0];
    let q = z[1];
    let r = z[2];
    let p2 = p * p;
    let p_q = p * q;
    let p_r = p * r;
    let q2 = q * q;
    let q_r = q * r;
    let r2 = r * r;
    let p3 = p2 * p;
    let p2_q = p2 * q;
    let p2_r = p2 * r;
    let p_q2 = p_q * q;
    let p_q_r = p_q * r;
    let p_r2 = p_r * r;
    let q3 = q2 * q;
    let q2_r = q2 * r;
    let q_r2 = q_r * r;
    let r3 = r2 * r;
    Vector([
        one,
        p,
        q,
        r,
        p2,
        p_q,
        p_r,
        q2,
        q_r,
        r2,
        p3,
        p2_q,
        p2_r,
        p_q2,
        p_q_r,
        p_r2,
        q3,
        q2_r,
        q_r2,
        r3,
    ])
}
