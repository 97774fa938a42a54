// SHA-256 of the text below: 50f69c1ef4b5fa794a4053109af94c9dff95454e1b8836235b6441978b04ba1d
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 7709ac9dadc6e0d55c9f2766fd114c93b77a2eb45a027fca7fc9fa1a44d38c56

//! `surface_vessel`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 10 monomials `basis2` of z = (`surge`, `sway`, `r`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 3>) -> Vector<T, 10> {
    let one = T::one();
    let surge = z[0];
    let sway = z[1];
    let r = z[2];
    let surge2 = surge * surge;
    let surge_sway = surge * sway;
    let surge_r = surge * r;
    let sway2 = sway * sway;
    let sway_r = sway * r;
    let r2 = r * r;
    Vector([one, surge, sway, r, surge2, surge_sway, surge_r, sway2, sway_r, r2])
}
