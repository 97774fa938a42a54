// SHA-256 of the text below: 4afa2fae5786d066eff33c7f5f4b45bef7e7c83c440061418c264a63a1d49113
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `underwater_vehicle`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 28 monomials `basis2` of z = (`surge`, `sway`, `heave`, `p`, `q`, `r`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 6>) -> Vector<T, 28> {
    let one = T::one();
    let surge = z[0];
    let sway = z[1];
    let heave = z[2];
    let p = z[3];
    let q = z[4];
    let r = z[5];
    let surge2 = surge * surge;
    let surge_sway = surge * sway;
    let surge_heave = surge * heave;
    let surge_p = surge * p;
    let surge_q = surge * q;
    let surge_r = surge * r;
    let sway2 = sway * sway;
    let sway_heave = sway * heave;
    let sway_p = sway * p;
    let sway_q = sway * q;
    let sway_r = sway * r;
    let heave2 = heave * heave;
    let heave_p = heave * p;
    let heave_q = heave * q;
    let heave_r = heave * r;
    let p2 = p * p;
    let p_q = p * q;
    let p_r = p * r;
    let q2 = q * q;
    let q_r = q * r;
    let r2 = r * r;
    Vector([
        one,
        surge,
        sway,
        heave,
        p,
        q,
        r,
        surge2,
        surge_sway,
        surge_heave,
        surge_p,
        surge_q,
        surge_r,
        sway2,
        sway_heave,
        sway_p,
        sway_q,
        sway_r,
        heave2,
        heave_p,
        heave_q,
        heave_r,
        p2,
        p_q,
        p_r,
        q2,
        q_r,
        r2,
    ])
}
