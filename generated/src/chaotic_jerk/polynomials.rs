// SHA-256 of the text below: 541395d260e27a0e9c2627ec4fcaa23c5db68d717434519b859c994b4139c3ec
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 427d2bea2c6b43ae65f749fa7cfe60bd4e96b4b1966ea0acf1940e759453d1f2

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
