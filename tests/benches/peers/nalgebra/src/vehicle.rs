//! Known dynamics of the vehicle at 3000 m/s and 22 km, with aerodynamic coefficients off by given factors.

use nalgebra::{matrix, vector};

use crate::aero::{self, horner};
use crate::{Matrix3, Vector3};

const MASS: f64 = 136820.0;
const SPEED: f64 = 3000.0;
const MOMENTUM: f64 = MASS * SPEED;
const WEIGHT: f64 = MASS * 9.739121;
const SPAN: f64 = 18.288;
const CHORD: f64 = 24.384;
const PRESSURE_AREA: f64 = 0.5 * 0.0645098327 * SPEED * SPEED * 334.73;
pub const INERTIA: Vector3 = vector![1355818.0, 13558180.0, 13558180.0];
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// Factors of the coefficients; drag acts on nothing here, since the centre of mass is at the reference centre.
#[derive(Clone, Copy)]
pub struct Scales {
    pub lift: f64,
    pub side: f64,
    pub roll: f64,
    pub pitch: f64,
    pub yaw: f64,
}

/// What the equations of motion need: `x_1' = f1 + g1 x_2`, `x_2' = f2 + u / INERTIA`, noise by `h2`.
pub struct Dynamics {
    pub f1: Vector3,
    pub g1: Matrix3,
    pub f2: Vector3,
    pub h2: Matrix3,
}

/// The dynamics at an attitude (alpha, beta, mu) and body rates (p, q, r).
#[inline]
pub fn dynamics(attitude: &Vector3, rates: &Vector3, scales: &Scales) -> Dynamics {
    let a = attitude.x * DEGREES;
    let (sin_alpha, cos_alpha) = attitude.x.sin_cos();
    let (sin_beta, cos_beta) = attitude.y.sin_cos();
    let (sin_mu, cos_mu) = attitude.z.sin_cos();
    let (secant, tan_beta) = (1.0 / cos_beta, sin_beta / cos_beta);
    let lift = PRESSURE_AREA * scales.lift * horner(&aero::LIFT, a);
    let side = PRESSURE_AREA * scales.side * (horner(&aero::SIDE_BETA, a) * attitude.y + horner(&aero::SIDE, a));
    let f1 = vector![(WEIGHT * cos_mu - lift) * secant, side + WEIGHT * sin_mu, (lift - WEIGHT * cos_mu) * tan_beta] / MOMENTUM;
    let g1 = matrix![
        -tan_beta * cos_alpha, 1.0, -tan_beta * sin_alpha;
        sin_alpha, 0.0, -cos_alpha;
        cos_alpha * secant, 0.0, sin_alpha * secant
    ];
    let factors = PRESSURE_AREA * vector![SPAN * scales.roll, CHORD * scales.pitch, SPAN * scales.yaw].component_div(&INERTIA);
    Dynamics { f1, g1, f2: gyroscopic(rates) + factors.component_mul(&moments(a, attitude.y, rates)), h2: slopes(a, &factors) }
}

fn gyroscopic(rates: &Vector3) -> Vector3 {
    let (p, q, r) = (rates.x, rates.y, rates.z);
    let [i, j, k] = INERTIA.into();
    vector![(j - k) / i * q * r, (k - i) / j * p * r, (i - j) / k * p * q]
}

/// Coefficients of roll, pitch and yaw at zero deflection.
fn moments(a: f64, beta: f64, rates: &Vector3) -> Vector3 {
    let (p, q, r) = (rates.x, rates.y, rates.z);
    let (span, chord) = (SPAN / (2.0 * SPEED), CHORD / (2.0 * SPEED));
    vector![
        horner(&aero::ROLL_BETA, a) * beta + horner(&aero::ROLL, a) + (horner(&aero::ROLL_P, a) * p + horner(&aero::ROLL_R, a) * r) * span,
        horner(&aero::PITCH, a) + horner(&aero::PITCH_Q, a) * q * chord,
        horner(&aero::YAW_BETA, a) * beta + horner(&aero::YAW, a) + (horner(&aero::YAW_P, a) * p + horner(&aero::YAW_R, a) * r) * span
    ]
}

/// Angular acceleration per degree of left elevon, right elevon and rudder.
fn slopes(a: f64, factors: &Vector3) -> Matrix3 {
    Matrix3::from_fn(|axis, surface| factors[axis] * horner(&aero::SLOPES[axis][surface], a))
}
