// SHA-256 of the text below: f8aad65c1908675878e68e129cb7100dcc89c04e7f9cb5747fb92af5d1952ed8
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `nsv_six_dof`: polynomial data and monomials of the networks.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::linear::Vector;
use nsv_runtime::polynomial::horner;
use nsv_runtime::real::Real;

/// Polynomial data `CL_alpha` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the lift coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn CL_alpha<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(5.99e-7) * mach * mach + real(-0.000152);
    let a1 = real(-0.000473) * mach + real(0.0186);
    let a0 = ((((real(4.12e-7) * mach + real(-2.93e-5)) * mach + real(0.000774)) * mach
        + real(-0.00919)) * mach + real(0.047)) * mach + real(-0.0819);
    ((((real(1.3e-8) * alpha_deg + real(-3.91e-7)) * alpha_deg + real(4.08e-6))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CL_LE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the lift coefficient.
///
/// 8 terms; 7 additions, 7 multiplications.
#[inline(always)]
pub fn CL_LE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(-1.7e-7) * deflection_deg + real(4.7e-6);
    let a1_0 = real(-3.51e-6) * deflection_deg + real(0.000101);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(8.72e-6) * deflection_deg + real(7.1e-6);
    let a0_0 = real(-0.000414) * deflection_deg + real(-1.45e-5);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `CL_RE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the lift coefficient.
///
/// 8 terms; 7 additions, 7 multiplications.
#[inline(always)]
pub fn CL_RE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(-1.7e-7) * deflection_deg + real(4.7e-6);
    let a1_0 = real(-3.51e-6) * deflection_deg + real(0.000101);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(8.72e-6) * deflection_deg + real(7.1e-6);
    let a0_0 = real(-0.000414) * deflection_deg + real(-1.45e-5);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `CD_alpha` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the drag coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn CD_alpha<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(1.405e-7) * mach * mach + real(-0.0011);
    let a1 = real(-0.000125) * mach + real(0.003179);
    let a0 = ((((real(-1.705e-7) * mach + real(1.274e-5)) * mach + real(-0.0003658))
        * mach + real(0.005036)) * mach + real(-0.03307)) * mach + real(0.08717);
    ((((real(9.766e-7) * alpha_deg + real(-2.985e-5)) * alpha_deg + real(0.0003175))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CD_LE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the drag coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn CD_LE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(2.1026e-12) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(3.2187e-6);
    let a1_1 = real(-5.3015e-7) * deflection_deg;
    let a1 = a1_1 * mach + real(2.5411e-5);
    let a0_0 = (real(6.9629e-6) * deflection_deg + real(-3.6417e-5)) * deflection_deg
        + real(0.00045548);
    let a0 = (real(3.014e-6) * mach + real(-0.00011436)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CD_RE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the drag coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn CD_RE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(2.1026e-12) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(3.2187e-6);
    let a1_1 = real(-5.3015e-7) * deflection_deg;
    let a1 = a1_1 * mach + real(2.5411e-5);
    let a0_0 = (real(6.9629e-6) * deflection_deg + real(-3.6417e-5)) * deflection_deg
        + real(0.00045548);
    let a0 = (real(3.014e-6) * mach + real(-0.00011436)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CD_RUD` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the drag coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn CD_RUD<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(-1.7702e-11) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(8.76e-7);
    let a1_1 = real(9.13e-9) * deflection_deg;
    let a1 = a1_1 * mach + real(-2.29e-5);
    let a0_0 = (real(1.9701e-6) * deflection_deg + real(-1.83e-6)) * deflection_deg
        + real(0.00075);
    let a0 = (real(2.7e-6) * mach + real(-9.69e-5)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CY_beta` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the side force coefficient.
///
/// 15 terms; 14 additions, 19 multiplications.
#[inline(always)]
pub fn CY_beta<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a4 = (real(2.6144e-11) * mach * mach + real(-2.0675e-8)) * mach * mach
        + real(2.8183e-5);
    let a2 = (real(-4.649e-9) * mach * mach + real(4.6205e-6)) * mach * mach
        + real(0.00073535);
    let a1 = real(-0.00028943) * mach + real(0.0028803);
    let a0 = ((((real(-2.0829e-6) * mach + real(0.00015495)) * mach + real(-0.0043203))
        * mach + real(0.054822)) * mach + real(-0.29253)) * mach;
    ((((real(-5.2083e-7) * alpha_deg + a4) * alpha_deg + real(-0.00037405)) * alpha_deg
        + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CY_LE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the side force coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn CY_LE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(-4.5e-14) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(-2.82e-9);
    let a1_1 = real(-4.11e-9) * deflection_deg;
    let a1 = a1_1 * mach + real(1.12e-7);
    let a0_0 = (real(5.04e-8) * deflection_deg + real(-2.27e-7)) * deflection_deg
        + real(1.02e-6);
    let a0 = (real(2.36e-8) * mach + real(-4.48e-7)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CY_RE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the side force coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn CY_RE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(4.5e-14) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(2.82e-9);
    let a1_1 = real(4.11e-9) * deflection_deg;
    let a1 = a1_1 * mach + real(-1.12e-7);
    let a0_0 = (real(-5.04e-8) * deflection_deg + real(2.27e-7)) * deflection_deg
        + real(-1.02e-6);
    let a0 = (real(-2.36e-8) * mach + real(4.48e-7)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `CY_RUD` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the side force coefficient.
///
/// 7 terms; 6 additions, 7 multiplications.
#[inline(always)]
pub fn CY_RUD<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(2.6e-7) * deflection_deg;
    let a1_0 = real(-1.17e-5) * deflection_deg + real(4.86e-20);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(-1.07e-5) * deflection_deg + real(1.86e-19);
    let a0_0 = real(0.000384) * deflection_deg + real(-1.43e-18);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `Cl_beta` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the rolling moment coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn Cl_beta<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(-1.044e-8) * mach * mach + real(2.354e-6);
    let a1 = real(8.596e-6) * mach + real(-0.000759);
    let a0 = ((((real(7.419e-8) * mach + real(-6.462e-6)) * mach + real(0.0002219))
        * mach + real(-0.003794)) * mach + real(0.03326)) * mach + real(-0.1402);
    ((((real(-3.353e-21) * alpha_deg + real(3.803e-19)) * alpha_deg + real(-8.964e-18))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cl_LE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the rolling moment coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn Cl_LE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(4.641e-11) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(-4.95e-6);
    let a1_1 = real(-2.794e-8) * deflection_deg;
    let a1 = a1_1 * mach + real(9.569e-5);
    let a0_0 = (real(1.16e-6) * deflection_deg + real(-0.000117)) * deflection_deg
        + real(-0.000357);
    let a0 = (real(-1.411e-6) * mach + real(3.598e-5)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cl_RE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the rolling moment coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn Cl_RE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(-4.641e-11) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(4.95e-6);
    let a1_1 = real(2.794e-8) * deflection_deg;
    let a1 = a1_1 * mach + real(-9.569e-5);
    let a0_0 = (real(-1.16e-6) * deflection_deg + real(0.000117)) * deflection_deg
        + real(0.000357);
    let a0 = (real(1.411e-6) * mach + real(-3.598e-5)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cl_RUD` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the rolling moment coefficient.
///
/// 8 terms; 7 additions, 7 multiplications.
#[inline(always)]
pub fn Cl_RUD<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(5.5547e-8) * deflection_deg + real(-3.4201e-21);
    let a1_0 = real(-2.6824e-6) * deflection_deg + real(6.2723e-20);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(-3.5496e-6) * deflection_deg + real(2.3418e-20);
    let a0_0 = real(0.00011441) * deflection_deg + real(-5.0103e-19);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `Cl_p` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme. Source:
/// AIAA 2005-6257, fit of the rolling moment coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn Cl_p<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(-1.52e-7) * mach * mach + real(-0.000204);
    let a1 = real(-8.78e-5) * mach + real(0.00138);
    let a0 = ((((real(2.2e-7) * mach + real(-1.79e-5)) * mach + real(0.000573)) * mach
        + real(-0.00913)) * mach + real(0.0747)) * mach + real(-0.299);
    ((((real(-1.15e-7) * alpha_deg + real(4.21e-6)) * alpha_deg + real(-3.86e-5))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cl_r` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme. Source:
/// AIAA 2005-6257, fit of the rolling moment coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn Cl_r<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(4.49e-8) * mach * mach + real(-9.76e-6);
    let a1 = real(-8.15e-5) * mach + real(0.00194);
    let a0 = ((((real(-4.81e-7) * mach + real(3.56e-5)) * mach + real(-0.00102)) * mach
        + real(0.0145)) * mach + real(-0.106)) * mach + real(0.382);
    ((((real(-1.06e-9) * alpha_deg + real(3.19e-8)) * alpha_deg + real(-2.7e-7))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cm_alpha` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the pitching moment coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn Cm_alpha<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(-2.88e-7) * mach * mach + real(0.0002616);
    let a1 = real(0.0001808) * mach + real(-0.00226);
    let a0 = ((((real(1.082e-8) * mach + real(-1.143e-6)) * mach + real(4.617e-5)) * mach
        + real(-0.0008849)) * mach + real(0.007739)) * mach + real(-0.02192);
    ((((real(-2.789e-7) * alpha_deg + real(8.288e-6)) * alpha_deg + real(-7.887e-5))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cm_LE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the pitching moment coefficient.
///
/// 8 terms; 7 additions, 7 multiplications.
#[inline(always)]
pub fn Cm_LE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(9.72e-8) * deflection_deg + real(-4.46e-6);
    let a1_0 = real(4.48e-6) * deflection_deg + real(-6.59e-5);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(-5.87e-6) * deflection_deg + real(-1.51e-6);
    let a0_0 = real(0.000289) * deflection_deg + real(-5.67e-5);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `Cm_RE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the pitching moment coefficient.
///
/// 8 terms; 7 additions, 7 multiplications.
#[inline(always)]
pub fn Cm_RE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(9.72e-8) * deflection_deg + real(-4.46e-6);
    let a1_0 = real(4.48e-6) * deflection_deg + real(-6.59e-5);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(-5.87e-6) * deflection_deg + real(-1.51e-6);
    let a0_0 = real(0.000289) * deflection_deg + real(-5.67e-5);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `Cm_RUD` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the pitching moment coefficient.
///
/// 17 terms; 16 additions, 21 multiplications.
#[inline(always)]
pub fn Cm_RUD<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a0_0 = (((real(2.63e-24) * deflection_deg + real(-3.38e-10)) * deflection_deg
        + real(-4.77e-22)) * deflection_deg + real(1.43e-7)) * deflection_deg
        * deflection_deg * deflection_deg * deflection_deg;
    let a0 = (((((real(-3.58e-9) * mach + real(2.7e-7)) * mach + real(-7.74e-6)) * mach
        + real(0.000105)) * mach + real(-0.000669)) * mach + real(0.00158)) * mach * mach
        + a0_0;
    ((((((real(5.74e-12) * alpha_deg + real(-2.18e-10)) * alpha_deg + real(3.14e-9))
        * alpha_deg + real(-2.1e-8)) * alpha_deg + real(6.42e-8)) * alpha_deg
        + real(-5.89e-8)) * alpha_deg + real(-2.79e-5)) * alpha_deg + a0
}

/// Polynomial data `Cm_q` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme. Source:
/// AIAA 2005-6257, fit of the pitching moment coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn Cm_q<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(-1.95e-6) * mach * mach + real(0.00236);
    let a1 = real(0.00014) * mach + real(0.000785);
    let a0 = ((((real(1.71e-6) * mach + real(-0.00013)) * mach + real(0.0038)) * mach
        + real(-0.0542)) * mach + real(0.386)) * mach + real(-1.36);
    ((((real(-5.93e-6) * alpha_deg + real(0.000169)) * alpha_deg + real(-0.00148))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cn_beta` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the yawing moment coefficient.
///
/// 15 terms; 14 additions, 25 multiplications.
#[inline(always)]
pub fn Cn_beta<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a5 = real(8.5863e-14) * mach * mach * mach * mach * mach + real(-2.5953e-7);
    let a4 = real(-5.5472e-11) * mach * mach * mach * mach + real(9.4989e-6);
    let a3 = real(1.0707e-8) * mach * mach * mach + real(-0.00010777);
    let a2 = real(-2.1924e-7) * mach * mach + real(0.0002516);
    let a1 = real(-7.525e-5) * mach + real(0.0006998);
    let a0 = ((((real(6.4284e-7) * mach + real(-4.7098e-5)) * mach + real(0.0012692))
        * mach + real(-0.014824)) * mach + real(0.059115)) * mach;
    ((((a5 * alpha_deg + a4) * alpha_deg + a3) * alpha_deg + a2) * alpha_deg + a1)
        * alpha_deg + a0
}

/// Polynomial data `Cn_LE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the yawing moment coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn Cn_LE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(-1.41e-11) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(6.39e-7);
    let a1_1 = real(8.93e-8) * deflection_deg;
    let a1 = a1_1 * mach + real(-1.83e-5);
    let a0_0 = (real(-1.97e-6) * deflection_deg + real(1.3e-5)) * deflection_deg
        + real(-0.00021);
    let a0 = (real(-8.16e-7) * mach + real(3.56e-5)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cn_RE` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the yawing moment coefficient.
///
/// 9 terms; 8 additions, 12 multiplications.
#[inline(always)]
pub fn Cn_RE<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2_2 = real(1.41e-11) * deflection_deg * deflection_deg;
    let a2 = a2_2 * mach * mach + real(-6.39e-7);
    let a1_1 = real(-8.93e-8) * deflection_deg;
    let a1 = a1_1 * mach + real(1.83e-5);
    let a0_0 = (real(1.97e-6) * deflection_deg + real(-1.3e-5)) * deflection_deg
        + real(0.00021);
    let a0 = (real(8.16e-7) * mach + real(-3.56e-5)) * mach + a0_0;
    (a2 * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data `Cn_RUD` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme.
/// Source: AIAA 2005-6257, fit of the yawing moment coefficient.
///
/// 8 terms; 7 additions, 7 multiplications.
#[inline(always)]
pub fn Cn_RUD<T: Real>(alpha_deg: T, mach: T, deflection_deg: T) -> T {
    let real = T::from_f64;
    let a1_1 = real(-3.13e-7) * deflection_deg + real(1.57e-20);
    let a1_0 = real(1.39e-5) * deflection_deg + real(-3.59e-19);
    let a1 = a1_1 * mach + a1_0;
    let a0_1 = real(1.65e-5) * deflection_deg + real(-1.26e-19);
    let a0_0 = real(-0.000528) * deflection_deg + real(2.85e-18);
    let a0 = a0_1 * mach + a0_0;
    a1 * alpha_deg + a0
}

/// Polynomial data `Cn_p` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme. Source:
/// AIAA 2005-6257, fit of the yawing moment coefficient.
///
/// 11 terms; 10 additions, 10 multiplications.
#[inline(always)]
pub fn Cn_p<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a0 = ((((real(-3.2e-7) * mach + real(2.57e-5)) * mach + real(-0.000805)) * mach
        + real(0.0124)) * mach + real(-0.0979)) * mach + real(0.368);
    ((((real(2.96e-19) * alpha_deg + real(-9.18e-18)) * alpha_deg + real(1.01e-16))
        * alpha_deg + real(-4.64e-16)) * alpha_deg + real(7.61e-16)) * alpha_deg + a0
}

/// Polynomial data `Cn_r` in `alpha_deg`, `mach`, `deflection_deg`, by Horner's scheme. Source:
/// AIAA 2005-6257, fit of the yawing moment coefficient.
///
/// 13 terms; 12 additions, 13 multiplications.
#[inline(always)]
pub fn Cn_r<T: Real>(alpha_deg: T, mach: T, _deflection_deg: T) -> T {
    let real = T::from_f64;
    let a2 = real(-6.53e-8) * mach * mach + real(0.00115);
    let a1 = real(0.000209) * mach + real(-0.00274);
    let a0 = ((((real(1.96e-6) * mach + real(-0.000157)) * mach + real(0.0049)) * mach
        + real(-0.0757)) * mach + real(0.596)) * mach + real(-2.41);
    ((((real(-1.18e-6) * alpha_deg + real(3.6e-5)) * alpha_deg + real(-0.000387))
        * alpha_deg + a2) * alpha_deg + a1) * alpha_deg + a0
}

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg2<T> {
    /// `Cm_RUD`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RUD: T,
    /// `CL_alpha`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha: T,
    /// `CY_beta`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta: T,
    /// `Cl_beta`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_beta: T,
    /// `Cl_p`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_p: T,
    /// `Cl_r`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_r: T,
    /// `Cm_alpha`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_alpha: T,
    /// `Cm_q`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_q: T,
    /// `Cn_beta`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_beta: T,
    /// `Cn_p`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_p: T,
    /// `Cn_r`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_r: T,
    /// `CY_LE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE: T,
    /// `CY_RE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE: T,
    /// `Cl_LE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE: T,
    /// `Cl_RE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE: T,
    /// `Cn_LE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE: T,
    /// `Cn_RE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE: T,
    /// `Cl_LE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE_d3: T,
    /// `Cl_RE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE_d3: T,
    /// `Cn_LE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE_d3: T,
    /// `Cn_RE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE_d3: T,
    /// `CL_LE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_LE: T,
    /// `CL_RE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_RE: T,
    /// `CY_RUD`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RUD: T,
    /// `Cl_RUD`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD: T,
    /// `Cm_LE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE: T,
    /// `Cm_RE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE: T,
    /// `Cn_RUD`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD: T,
    /// `Cl_RUD_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD_d3: T,
    /// `Cm_LE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE_d3: T,
    /// `Cm_RE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE_d3: T,
    /// `Cn_RUD_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD_d3: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 32 polynomials; 88 additions, 88 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg_2<T: Real>(alpha_deg: T) -> AtAlphaDeg2<T> {
    const DEGREE_7: [[f64; 1]; 8] = [
        [5.74e-12],
        [-2.18e-10],
        [3.14e-9],
        [-2.1e-8],
        [6.42e-8],
        [-5.89e-8],
        [-2.79e-5],
        [-0.0006960547200340074],
    ];
    let [Cm_RUD] = horner(&DEGREE_7, alpha_deg);
    const DEGREE_5: [[f64; 10]; 6] = [
        [
            1.3e-8,
            -5.2083e-7,
            -3.353e-21,
            -1.15e-7,
            -1.06e-9,
            -2.789e-7,
            -5.93e-6,
            -2.504059032375198e-7,
            2.96e-19,
            -1.18e-6,
        ],
        [
            -3.91e-7,
            2.6339103531325548e-5,
            3.803e-19,
            4.21e-6,
            3.19e-8,
            8.288e-6,
            0.000169,
            8.91655428592757e-6,
            -9.18e-18,
            3.6e-5,
        ],
        [
            4.08e-6,
            -0.00037405,
            -8.964e-18,
            -3.86e-5,
            -2.7e-7,
            -7.887e-5,
            -0.00148,
            -9.666552330262917e-5,
            1.01e-16,
            -0.000387,
        ],
        [
            -9.062657615458775e-5,
            0.0011599602768678128,
            1.2843196244639332e-6,
            -0.00021957389052504618,
            -5.159554706746226e-6,
            0.00023209157584728094,
            0.0021602033781326314,
            0.0002291367121137426,
            -4.64e-16,
            0.0011433093746625953,
        ],
        [
            0.013812178997103516,
            -4.938083058843431e-5,
            -0.0006719891980107862,
            0.0004912670527392995,
            0.0011150371844903522,
            -0.0004298984411761429,
            0.0022021140389122786,
            -6.18987959153497e-5,
            7.61e-16,
            -0.0006244511847666697,
        ],
        [
            -0.00883815039052084,
            -0.4193602461541422,
            -0.022083557553724334,
            -0.04859140704194431,
            0.05946039898789246,
            0.002783872039364598,
            -0.2480990578146105,
            -0.030296143941408966,
            0.048444529933999336,
            -0.4913589178158497,
        ],
    ];
    let [CL_alpha, CY_beta, Cl_beta, Cl_p, Cl_r, Cm_alpha, Cm_q, Cn_beta, Cn_p, Cn_r] = horner(
        &DEGREE_5,
        alpha_deg,
    );
    const DEGREE_2: [[f64; 10]; 3] = [
        [-2.82e-9, 2.82e-9, -4.95e-6, 4.95e-6, 6.39e-7, -6.39e-7, 0.0, -0.0, -0.0, 0.0],
        [
            1.12e-7,
            -1.12e-7,
            9.569e-5,
            -9.569e-5,
            -1.83e-5,
            1.83e-5,
            -2.8281547319435047e-7,
            2.8281547319435047e-7,
            9.03916311963332e-7,
            -9.03916311963332e-7,
        ],
        [
            -1.0967135008936997e-6,
            1.0967135008936997e-6,
            -0.00013737247838665077,
            0.00013737247838665077,
            6.674465384308486e-5,
            -6.674465384308486e-5,
            -0.000117,
            0.000117,
            1.3e-5,
            -1.3e-5,
        ],
    ];
    let [CY_LE, CY_RE, Cl_LE, Cl_RE, Cn_LE, Cn_RE, Cl_LE_d3, Cl_RE_d3, Cn_LE_d3, Cn_RE_d3,
    ] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 11]; 2] = [
        [
            0.0001485745427349122,
            0.0001485745427349122,
            4.86e-20,
            2.8103916253686545e-20,
            -0.00011104520438249116,
            -0.00011104520438249116,
            -2.0008078277912303e-19,
            -2.1201397605752832e-6,
            5.463882032730525e-6,
            5.463882032730525e-6,
            1.073173789871755e-5,
        ],
        [
            5.73679262591227e-5,
            5.73679262591227e-5,
            4.527372231263129e-19,
            -2.639873102625161e-19,
            -7.198458713398243e-5,
            -7.198458713398243e-5,
            1.5745973649789493e-18,
            7.848008576769269e-5,
            0.00022958243279703517,
            0.00022958243279703517,
            -0.0003609829882710529,
        ],
    ];
    let [CL_LE, CL_RE, CY_RUD, Cl_RUD, Cm_LE, Cm_RE, Cn_RUD, Cl_RUD_d3, Cm_LE_d3,
    Cm_RE_d3, Cn_RUD_d3] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg2 {
        Cm_RUD,
        CL_alpha,
        CY_beta,
        Cl_beta,
        Cl_p,
        Cl_r,
        Cm_alpha,
        Cm_q,
        Cn_beta,
        Cn_p,
        Cn_r,
        CY_LE,
        CY_RE,
        Cl_LE,
        Cl_RE,
        Cn_LE,
        Cn_RE,
        Cl_LE_d3,
        Cl_RE_d3,
        Cn_LE_d3,
        Cn_RE_d3,
        CL_LE,
        CL_RE,
        CY_RUD,
        Cl_RUD,
        Cm_LE,
        Cm_RE,
        Cn_RUD,
        Cl_RUD_d3,
        Cm_LE_d3,
        Cm_RE_d3,
        Cn_RUD_d3,
    }
}

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg22<T> {
    /// `Cl_LE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE_d3: T,
    /// `Cl_RE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE_d3: T,
    /// `Cn_LE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE_d3: T,
    /// `Cn_RE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE_d3: T,
    /// `Cl_RUD_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD_d3: T,
    /// `Cm_LE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE_d3: T,
    /// `Cm_RE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE_d3: T,
    /// `Cn_RUD_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD_d3: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 8 polynomials; 12 additions, 12 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg_2_2<T: Real>(alpha_deg: T) -> AtAlphaDeg22<T> {
    const DEGREE_2: [[f64; 4]; 3] = [
        [0.0, -0.0, -0.0, 0.0],
        [
            -2.8281547319435047e-7,
            2.8281547319435047e-7,
            9.03916311963332e-7,
            -9.03916311963332e-7,
        ],
        [-0.000117, 0.000117, 1.3e-5, -1.3e-5],
    ];
    let [Cl_LE_d3, Cl_RE_d3, Cn_LE_d3, Cn_RE_d3] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 4]; 2] = [
        [
            -2.1201397605752832e-6,
            5.463882032730525e-6,
            5.463882032730525e-6,
            1.073173789871755e-5,
        ],
        [
            7.848008576769269e-5,
            0.00022958243279703517,
            0.00022958243279703517,
            -0.0003609829882710529,
        ],
    ];
    let [Cl_RUD_d3, Cm_LE_d3, Cm_RE_d3, Cn_RUD_d3] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg22 {
        Cl_LE_d3,
        Cl_RE_d3,
        Cn_LE_d3,
        Cn_RE_d3,
        Cl_RUD_d3,
        Cm_LE_d3,
        Cm_RE_d3,
        Cn_RUD_d3,
    }
}

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg<T> {
    /// `CL_alpha`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha: T,
    /// `CY_beta`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta: T,
    /// `CY_LE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE: T,
    /// `CY_RE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE: T,
    /// `CL_LE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_LE: T,
    /// `CL_RE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_RE: T,
    /// `CY_RUD`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RUD: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 7 polynomials; 17 additions, 17 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg<T: Real>(alpha_deg: T) -> AtAlphaDeg<T> {
    const DEGREE_5: [[f64; 2]; 6] = [
        [1.3e-8, -5.2083e-7],
        [-3.91e-7, 2.6339103531325548e-5],
        [4.08e-6, -0.00037405],
        [-9.062657615458775e-5, 0.0011599602768678128],
        [0.013812178997103516, -4.938083058843431e-5],
        [-0.00883815039052084, -0.4193602461541422],
    ];
    let [CL_alpha, CY_beta] = horner(&DEGREE_5, alpha_deg);
    const DEGREE_2: [[f64; 2]; 3] = [
        [-2.82e-9, 2.82e-9],
        [1.12e-7, -1.12e-7],
        [-1.0967135008936997e-6, 1.0967135008936997e-6],
    ];
    let [CY_LE, CY_RE] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 3]; 2] = [
        [0.0001485745427349122, 0.0001485745427349122, 4.86e-20],
        [5.73679262591227e-5, 5.73679262591227e-5, 4.527372231263129e-19],
    ];
    let [CL_LE, CL_RE, CY_RUD] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg {
        CL_alpha,
        CY_beta,
        CY_LE,
        CY_RE,
        CL_LE,
        CL_RE,
        CY_RUD,
    }
}

/// Polynomial data at one `alpha_deg`.
#[derive(Clone, Copy, Debug)]
pub struct AtAlphaDeg23<T> {
    /// `Cm_RUD`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RUD: T,
    /// `CL_alpha`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha: T,
    /// `CY_beta`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta: T,
    /// `Cl_beta`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_beta: T,
    /// `Cl_p`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_p: T,
    /// `Cl_r`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_r: T,
    /// `Cm_alpha`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_alpha: T,
    /// `Cm_q`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_q: T,
    /// `Cn_beta`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_beta: T,
    /// `Cn_p`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_p: T,
    /// `Cn_r`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_r: T,
    /// `CL_alpha_d1`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_alpha_d1: T,
    /// `CY_beta_d1`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_beta_d1: T,
    /// `CY_LE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE: T,
    /// `CY_RE`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE: T,
    /// `Cl_LE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE: T,
    /// `Cl_RE`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE: T,
    /// `Cn_LE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE: T,
    /// `Cn_RE`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE: T,
    /// `Cl_LE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_LE_d3: T,
    /// `Cl_RE_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RE_d3: T,
    /// `Cn_LE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_LE_d3: T,
    /// `Cn_RE_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RE_d3: T,
    /// `CL_LE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_LE: T,
    /// `CL_RE`, source: AIAA 2005-6257, fit of the lift coefficient.
    pub CL_RE: T,
    /// `CY_RUD`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RUD: T,
    /// `Cl_RUD`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD: T,
    /// `Cm_LE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE: T,
    /// `Cm_RE`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE: T,
    /// `Cn_RUD`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD: T,
    /// `Cl_RUD_d3`, source: AIAA 2005-6257, fit of the rolling moment coefficient.
    pub Cl_RUD_d3: T,
    /// `Cm_LE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_LE_d3: T,
    /// `Cm_RE_d3`, source: AIAA 2005-6257, fit of the pitching moment coefficient.
    pub Cm_RE_d3: T,
    /// `Cn_RUD_d3`, source: AIAA 2005-6257, fit of the yawing moment coefficient.
    pub Cn_RUD_d3: T,
    /// `CY_LE_d1`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_LE_d1: T,
    /// `CY_RE_d1`, source: AIAA 2005-6257, fit of the side force coefficient.
    pub CY_RE_d1: T,
}

/// Polynomial data in `alpha_deg` by Horner's scheme, with its other arguments, which are
/// constants, in the coefficients.
///
/// 36 polynomials; 98 additions, 98 multiplications. A row of a table holds the coefficients of
/// one power, the highest first.
#[inline(always)]
pub fn at_alpha_deg_2_3<T: Real>(alpha_deg: T) -> AtAlphaDeg23<T> {
    const DEGREE_7: [[f64; 1]; 8] = [
        [5.74e-12],
        [-2.18e-10],
        [3.14e-9],
        [-2.1e-8],
        [6.42e-8],
        [-5.89e-8],
        [-2.79e-5],
        [-0.0006960547200340074],
    ];
    let [Cm_RUD] = horner(&DEGREE_7, alpha_deg);
    const DEGREE_5: [[f64; 10]; 6] = [
        [
            1.3e-8,
            -5.2083e-7,
            -3.353e-21,
            -1.15e-7,
            -1.06e-9,
            -2.789e-7,
            -5.93e-6,
            -2.504059032375198e-7,
            2.96e-19,
            -1.18e-6,
        ],
        [
            -3.91e-7,
            2.6339103531325548e-5,
            3.803e-19,
            4.21e-6,
            3.19e-8,
            8.288e-6,
            0.000169,
            8.91655428592757e-6,
            -9.18e-18,
            3.6e-5,
        ],
        [
            4.08e-6,
            -0.00037405,
            -8.964e-18,
            -3.86e-5,
            -2.7e-7,
            -7.887e-5,
            -0.00148,
            -9.666552330262917e-5,
            1.01e-16,
            -0.000387,
        ],
        [
            -9.062657615458775e-5,
            0.0011599602768678128,
            1.2843196244639332e-6,
            -0.00021957389052504618,
            -5.159554706746226e-6,
            0.00023209157584728094,
            0.0021602033781326314,
            0.0002291367121137426,
            -4.64e-16,
            0.0011433093746625953,
        ],
        [
            0.013812178997103516,
            -4.938083058843431e-5,
            -0.0006719891980107862,
            0.0004912670527392995,
            0.0011150371844903522,
            -0.0004298984411761429,
            0.0022021140389122786,
            -6.18987959153497e-5,
            7.61e-16,
            -0.0006244511847666697,
        ],
        [
            -0.00883815039052084,
            -0.4193602461541422,
            -0.022083557553724334,
            -0.04859140704194431,
            0.05946039898789246,
            0.002783872039364598,
            -0.2480990578146105,
            -0.030296143941408966,
            0.048444529933999336,
            -0.4913589178158497,
        ],
    ];
    let [CL_alpha, CY_beta, Cl_beta, Cl_p, Cl_r, Cm_alpha, Cm_q, Cn_beta, Cn_p, Cn_r] = horner(
        &DEGREE_5,
        alpha_deg,
    );
    const DEGREE_4: [[f64; 2]; 5] = [
        [6.5e-8, -2.6041500000000003e-6],
        [-1.564e-6, 0.00010535641412530219],
        [1.224e-5, -0.0011221500000000001],
        [-0.0001812531523091755, 0.0023199205537356255],
        [0.013812178997103516, -4.938083058843431e-5],
    ];
    let [CL_alpha_d1, CY_beta_d1] = horner(&DEGREE_4, alpha_deg);
    const DEGREE_2: [[f64; 10]; 3] = [
        [-2.82e-9, 2.82e-9, -4.95e-6, 4.95e-6, 6.39e-7, -6.39e-7, 0.0, -0.0, -0.0, 0.0],
        [
            1.12e-7,
            -1.12e-7,
            9.569e-5,
            -9.569e-5,
            -1.83e-5,
            1.83e-5,
            -2.8281547319435047e-7,
            2.8281547319435047e-7,
            9.03916311963332e-7,
            -9.03916311963332e-7,
        ],
        [
            -1.0967135008936997e-6,
            1.0967135008936997e-6,
            -0.00013737247838665077,
            0.00013737247838665077,
            6.674465384308486e-5,
            -6.674465384308486e-5,
            -0.000117,
            0.000117,
            1.3e-5,
            -1.3e-5,
        ],
    ];
    let [CY_LE, CY_RE, Cl_LE, Cl_RE, Cn_LE, Cn_RE, Cl_LE_d3, Cl_RE_d3, Cn_LE_d3, Cn_RE_d3,
    ] = horner(&DEGREE_2, alpha_deg);
    const DEGREE_1: [[f64; 13]; 2] = [
        [
            0.0001485745427349122,
            0.0001485745427349122,
            4.86e-20,
            2.8103916253686545e-20,
            -0.00011104520438249116,
            -0.00011104520438249116,
            -2.0008078277912303e-19,
            -2.1201397605752832e-6,
            5.463882032730525e-6,
            5.463882032730525e-6,
            1.073173789871755e-5,
            -5.64e-9,
            5.64e-9,
        ],
        [
            5.73679262591227e-5,
            5.73679262591227e-5,
            4.527372231263129e-19,
            -2.639873102625161e-19,
            -7.198458713398243e-5,
            -7.198458713398243e-5,
            1.5745973649789493e-18,
            7.848008576769269e-5,
            0.00022958243279703517,
            0.00022958243279703517,
            -0.0003609829882710529,
            1.12e-7,
            -1.12e-7,
        ],
    ];
    let [CL_LE, CL_RE, CY_RUD, Cl_RUD, Cm_LE, Cm_RE, Cn_RUD, Cl_RUD_d3, Cm_LE_d3,
    Cm_RE_d3, Cn_RUD_d3, CY_LE_d1, CY_RE_d1] = horner(&DEGREE_1, alpha_deg);
    AtAlphaDeg23 {
        Cm_RUD,
        CL_alpha,
        CY_beta,
        Cl_beta,
        Cl_p,
        Cl_r,
        Cm_alpha,
        Cm_q,
        Cn_beta,
        Cn_p,
        Cn_r,
        CL_alpha_d1,
        CY_beta_d1,
        CY_LE,
        CY_RE,
        Cl_LE,
        Cl_RE,
        Cn_LE,
        Cn_RE,
        Cl_LE_d3,
        Cl_RE_d3,
        Cn_LE_d3,
        Cn_RE_d3,
        CL_LE,
        CL_RE,
        CY_RUD,
        Cl_RUD,
        Cm_LE,
        Cm_RE,
        Cn_RUD,
        Cl_RUD_d3,
        Cm_LE_d3,
        Cm_RE_d3,
        Cn_RUD_d3,
        CY_LE_d1,
        CY_RE_d1,
    }
}

/// Values of the 19 monomials `basis1` of z = (`alpha`, `beta`, `mu`).
#[inline(always)]
pub fn basis1<T: Real>(z: Vector<T, 3>) -> Vector<T, 19> {
    let one = T::one();
    let alpha = z[0];
    let beta = z[1];
    let mu = z[2];
    let alpha2 = alpha * alpha;
    let alpha_beta = alpha * beta;
    let alpha_mu = alpha * mu;
    let beta2 = beta * beta;
    let beta_mu = beta * mu;
    let mu2 = mu * mu;
    let alpha3 = alpha2 * alpha;
    let alpha2_beta = alpha2 * beta;
    let alpha2_mu = alpha2 * mu;
    let alpha_beta2 = alpha_beta * beta;
    let alpha_mu2 = alpha_mu * mu;
    let beta3 = beta2 * beta;
    let beta2_mu = beta2 * mu;
    let beta_mu2 = beta_mu * mu;
    let mu3 = mu2 * mu;
    Vector([
        one,
        alpha,
        beta,
        mu,
        alpha2,
        alpha_beta,
        alpha_mu,
        beta2,
        beta_mu,
        mu2,
        alpha3,
        alpha2_beta,
        alpha2_mu,
        alpha_beta2,
        alpha_mu2,
        beta3,
        beta2_mu,
        beta_mu2,
        mu3,
    ])
}

/// Rates of the 19 monomials `basis1` of z = (`alpha`, `beta`, `mu`), along the rate `z_d1` of
/// z.
#[inline(always)]
pub fn basis1_rate<T: Real>(z: Vector<T, 3>, z_d1: Vector<T, 3>) -> Vector<T, 19> {
    let one_d1 = T::zero();
    let alpha = z[0];
    let alpha_d1 = z_d1[0];
    let beta = z[1];
    let beta_d1 = z_d1[1];
    let mu = z[2];
    let mu_d1 = z_d1[2];
    let alpha2 = alpha * alpha;
    let alpha2_d1 = alpha_d1 * alpha + alpha * alpha_d1;
    let alpha_beta = alpha * beta;
    let alpha_beta_d1 = alpha_d1 * beta + alpha * beta_d1;
    let alpha_mu = alpha * mu;
    let alpha_mu_d1 = alpha_d1 * mu + alpha * mu_d1;
    let beta2 = beta * beta;
    let beta2_d1 = beta_d1 * beta + beta * beta_d1;
    let beta_mu = beta * mu;
    let beta_mu_d1 = beta_d1 * mu + beta * mu_d1;
    let mu2 = mu * mu;
    let mu2_d1 = mu_d1 * mu + mu * mu_d1;
    let alpha3_d1 = alpha2_d1 * alpha + alpha2 * alpha_d1;
    let alpha2_beta_d1 = alpha2_d1 * beta + alpha2 * beta_d1;
    let alpha2_mu_d1 = alpha2_d1 * mu + alpha2 * mu_d1;
    let alpha_beta2_d1 = alpha_beta_d1 * beta + alpha_beta * beta_d1;
    let alpha_mu2_d1 = alpha_mu_d1 * mu + alpha_mu * mu_d1;
    let beta3_d1 = beta2_d1 * beta + beta2 * beta_d1;
    let beta2_mu_d1 = beta2_d1 * mu + beta2 * mu_d1;
    let beta_mu2_d1 = beta_mu_d1 * mu + beta_mu * mu_d1;
    let mu3_d1 = mu2_d1 * mu + mu2 * mu_d1;
    Vector([
        one_d1,
        alpha_d1,
        beta_d1,
        mu_d1,
        alpha2_d1,
        alpha_beta_d1,
        alpha_mu_d1,
        beta2_d1,
        beta_mu_d1,
        mu2_d1,
        alpha3_d1,
        alpha2_beta_d1,
        alpha2_mu_d1,
        alpha_beta2_d1,
        alpha_mu2_d1,
        beta3_d1,
        beta2_mu_d1,
        beta_mu2_d1,
        mu3_d1,
    ])
}

/// Values of the 19 monomials `basis2` of z = (`p`, `q`, `r`).
#[inline(always)]
pub fn basis2<T: Real>(z: Vector<T, 3>) -> Vector<T, 19> {
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
        p_r2,
        q3,
        q2_r,
        q_r2,
        r3,
    ])
}
