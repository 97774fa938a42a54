// SHA-256 of the text below: c1029d752501aac4222410365b112fbdc93e139118e5e192c2692d8549441579
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

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
