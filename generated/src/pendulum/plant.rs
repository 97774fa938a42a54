// SHA-256 of the text below: c86bdc06f9449876013b607bd0b999ccde97007ae83220ee3fb14f2521cf284a
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 ef009c4dc4c097e98df4c7b1dbc83f570137fcd24da6278418adb20f485f0b05
// plant: 5 additions, 7 multiplications, 2 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `pendulum`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `theta` (dimensionless), `omega` (1/s).
pub const STATES: usize = 2;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 0;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.08726646259971647, 0.0];

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
    pub drift: Vector<T, 2>,
    /// `d_2(t)`
    pub d2: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 5 additions, 7 multiplications, 2 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 2>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- true dynamics of block 1 (position) (11) --
    // F_1 with the plant's parameters
    let F1_plant: Vector<T, 1> = Vector::zero();
    // G_1 with the plant's parameters
    let G1_plant: Matrix<T, 1, 1> = Matrix::from_f64([[1.0]]);

    // -- plant model --
    let omega = x[1];
    let theta = x[0];
    let inertia = params.mass * real(0.25);

    // -- given --
    let x2 = Vector([omega]);

    // -- true dynamics of block 1 (position) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + G1_plant * x2;

    // -- true dynamics of block 2 (speed) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([real(-19.62) * theta.sin() - real(0.1) * omega / inertia]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix([[real(1.0) / inertia]]);
    // d_2(t)
    let d2 = Vector([real(1.0) + real(2.0) * (real(3.0) * t).sin()]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([x1_flow[0], x2_flow[0]]);
    PlantOutputs { drift, d2 }
}
