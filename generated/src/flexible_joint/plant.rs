// SHA-256 of the text below: 954bf27079e0381a0b8d064eb7c07f78dbc3e115be8c67bc290b07b30620fc87
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 4291bb3902fdc079d1e752f7589df333a1602f816fcc1424487d9d6fe0aaca25
// plant: 18 additions, 22 multiplications, 4 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `flexible_joint`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `q1` (dimensionless), `v1` (1/s), `q2` (dimensionless), `v2` (1/s),
/// then 3 states of the exosystems of block 4.
pub const STATES: usize = 7;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 0;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.1, 0.0, 0.1, 0.0, 10.0, 0.0, 20.0];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 1>,
}

impl<T: Real> Sde<T, STATES, 0> for Plant<T> {
    #[inline(always)]
    fn drift(&self, t: T, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, t, x })
    }

    #[inline(always)]
    fn diffusion(&self, _t: T, _x: &Vector<T, STATES>) -> Matrix<T, STATES, 0> {
        Matrix::zero()
    }
}
/// Drift.
struct Drift<'a, T> {
    plant: &'a Plant<T>,
    t: T,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Drift<'_, T> {
    type Output = Vector<T, STATES>;
    #[inline(always)]
    fn run(self) -> Vector<T, STATES> {
        plant(self.t, *self.x, self.plant.u_sat, &self.plant.params).drift
    }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 7>,
    /// `d_2(t)`
    pub d2: Vector<T, 1>,
    /// `d_4 = L_4 w_4 (12)`
    pub d4: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 18 additions, 22 multiplications, 4 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 7>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- disturbance observer of block 4 (20) (49) --
    // L_4
    let L4: Matrix<T, 1, 3> = Matrix::from_f64([[1.0, 1.0, 0.0]]);

    // -- true dynamics of block 1 (link_angle) (11) --
    // F_1 with the plant's parameters
    let F1_plant: Vector<T, 1> = Vector::zero();
    // G_1 with the plant's parameters
    let G1_plant: Matrix<T, 1, 1> = Matrix::from_f64([[1.0]]);

    // -- given --
    let x2 = Vector([x[1]]);
    let w4 = Vector([x[4], x[5], x[6]]);

    // -- true dynamics of block 1 (link_angle) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + G1_plant * x2;

    // -- plant model --
    let q1 = x[0];
    let q2 = x[2];
    let v2 = x[3];

    // -- true dynamics of block 2 (link_rate) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        -(params.weight * q1.sin() + params.stiffness * q1) / real(0.031),
    ]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix([[params.stiffness / real(0.031)]]);
    // d_2(t)
    let d2 = Vector([real(0.1) * (real(1.0) + (real(3.0) * t).sin()) / real(0.031)]);

    // -- given --
    let x3 = Vector([q2]);
    let x4 = Vector([v2]);

    // -- true dynamics of block 2 (link_rate) (11) --
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * x3 + d2;

    // -- true dynamics of block 3 (motor_angle) (11) --
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F1_plant + G1_plant * x4;

    // -- true dynamics of block 4 (motor_rate) (11) --
    // F_4 with the plant's parameters
    let F4_plant = Vector([
        -(real(0.007) * v2 + params.stiffness * (q2 - q1)) / real(0.004),
    ]);
    // G_4 with the plant's parameters
    let G4_plant: Matrix<T, 1, 1> = Matrix::from_f64([[250.0]]);
    // d_4 = L_4 w_4 (12)
    let d4 = L4 * w4;
    // w_4' = M_4 w_4 (12)
    let w4_flow = Matrix::<
        T,
        3,
        3,
    >::from_f64([[0.0, 0.0, 0.0], [0.0, 0.0, 20.0], [0.0, -20.0, 0.0]]) * w4;
    // F_4 + G_4 x_5 + d_4
    let x4_flow = F4_plant + G4_plant * u_sat + d4;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x1_flow[0],
        x2_flow[0],
        x3_flow[0],
        x4_flow[0],
        w4_flow[0],
        w4_flow[1],
        w4_flow[2],
    ]);
    PlantOutputs { drift, d2, d4 }
}
