// SHA-256 of the text below: 36005685cf822c6d9ab987e76aa5b833453077d6ad077e562ddd9c2c71bbadc2
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 1a4dc31c8b8f80dd213e6bd36beee0e688e8525cc62b205874fb23a2869e509d

//! `pendulum`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::real::Real;

/// Values of the 6 monomials `basis2` of z = (`z1`, `omega`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 2>) -> Vector<T, 6> {
    let one = T::one();
    let z1 = z[0];
    let omega = z[1];
    let z12 = z1 * z1;
    let z1_omega = z1 * omega;
    let omega2 = omega * omega;
    Vector([one, z1, omega, z12, z1_omega, omega2])
}

/// Rates of the 6 monomials `basis2` of z = (`z1`, `omega`), along the rate `z_d1` of z.
#[inline(always)]
pub fn basis2_rate<T: Real>(z: Vector<T, 2>, z_d1: Vector<T, 2>) -> Vector<T, 6> {
    let one_d1 = T::zero();
    let z1 = z[0];
    let z1_d1 = z_d1[0];
    let omega = z[1];
    let omega_d1 = z_d1[1];
    let z12_d1 = z1_d1 * z1 + z1 * z1_d1;
    let z1_omega_d1 = z1_d1 * omega + z1 * omega_d1;
    let omega2_d1 = omega_d1 * omega + omega * omega_d1;
    Vector([one_d1, z1_d1, omega_d1, z12_d1, z1_omega_d1, omega2_d1])
}
