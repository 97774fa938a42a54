// SHA-256 of the text below: b34d05f5d31afff62e1819a26c62e6380fb9ece2bf9a409f5efc0903ce1b173b
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `chaotic_jerk`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 10 monomials `basis3` of z = (`x`, `v`, `w`).
#[inline(always)]
pub fn basis3<T: Real>(z: Vector<T, 3>) -> Vector<T, 10> {
    let one = T::one();
    let x = z[0];
    let v = z[1];
    let w = z[2];
    let x2 = x * x;
    let x_v = x * v;
    let x_w = x * w;
    let v2 = v * v;
    let v_w = v * w;
    let w2 = w * w;
    Vector([one, x, v, w, x2, x_v, x_w, v2, v_w, w2])
}
