// SHA-256 of the text below: cb7ddc19a9d1c78d5a3310872a3a6e72dfe16692f13e4e507b7de2f2b00bfb8c
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 eaec085705702921007be8e6ce482fe8ff0bdc8ba32b44e358ef4f3b85103df7
// plant: 10 additions, 16 multiplications, 6 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `motor_arm`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `angle` (dimensionless), `rate` (1/s), `amps` (A), then 1 states of
/// the exosystems of block 2.
pub const STATES: usize = 4;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 2;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.1, 0.0, 0.0, 0.0];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 1>,
}

impl<T: Real> Sde<T, STATES, NOISE_CHANNELS> for Plant<T> {
    #[inline(always)]
    fn drift(&self, t: T, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, t, x })
    }

    #[inline(always)]
    fn diffusion(
        &self,
        t: T,
        x: &Vector<T, STATES>,
    ) -> Matrix<T, STATES, NOISE_CHANNELS> {
        T::outlined(Diffusion { plant: self, t, x })
    }

    #[inline(always)]
    fn drift_and_noise(
        &self,
        t: T,
        x: &Vector<T, STATES>,
        dw: &Vector<T, NOISE_CHANNELS>,
    ) -> (Vector<T, STATES>, Vector<T, STATES>) {
        T::outlined(Rates { plant: self, t, x, dw })
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
/// Diffusion.
struct Diffusion<'a, T> {
    plant: &'a Plant<T>,
    t: T,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Diffusion<'_, T> {
    type Output = Matrix<T, STATES, NOISE_CHANNELS>;
    #[inline(always)]
    fn run(self) -> Matrix<T, STATES, NOISE_CHANNELS> {
        plant(self.t, *self.x, self.plant.u_sat, &self.plant.params).diffusion
    }
}
/// Drift, and diffusion times noise.
struct Rates<'a, T> {
    plant: &'a Plant<T>,
    t: T,
    x: &'a Vector<T, STATES>,
    dw: &'a Vector<T, NOISE_CHANNELS>,
}
impl<T: Real> Part for Rates<'_, T> {
    type Output = (Vector<T, STATES>, Vector<T, STATES>);
    #[inline(always)]
    fn run(self) -> (Vector<T, STATES>, Vector<T, STATES>) {
        let rate = plant(self.t, *self.x, self.plant.u_sat, &self.plant.params);
        (rate.drift, diffuse(&rate.diffusion, self.dw))
    }
}

/// Diffusion times noise, without the entries that are always 0.
#[inline(always)]
fn diffuse<T: Real>(
    diffusion: &Matrix<T, STATES, NOISE_CHANNELS>,
    noise: &Vector<T, NOISE_CHANNELS>,
) -> Vector<T, STATES> {
    Vector([
        T::zero(),
        diffusion[(1, 0)] * noise[0],
        T::zero(),
        diffusion[(3, 1)] * noise[1],
    ])
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 4>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 4, 2>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 1>,
    /// `d_3(t)`
    pub d3: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 10 additions, 16 multiplications, 6 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 4>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- disturbance observer of block 2 (20) (49) --
    // L_2
    let L2: Matrix<T, 1, 1> = Matrix::from_f64([[1.0]]);

    // -- true dynamics of block 1 (position) (11) --
    // F_1 with the plant's parameters
    let F1_plant: Vector<T, 1> = Vector::zero();
    // G_1 with the plant's parameters
    let G1_plant: Matrix<T, 1, 1> = Matrix::from_f64([[1.0]]);

    // -- plant model --
    let rate = x[1];
    let weight = (real(0.253) + params.load_mass) * real(0.305) * real(9.81);
    let angle = x[0];
    let inertia = real(0.017315216666666668) + params.load_mass * real(0.093025)
        + real(2.0) * params.load_mass * real(0.000529) / real(5.0);
    let amps = x[2];

    // -- given --
    let x2 = Vector([rate]);
    let w2 = Vector([x[3]]);
    let x3 = Vector([amps]);

    // -- true dynamics of block 1 (position) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + G1_plant * x2;

    // -- true dynamics of block 2 (speed) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([-(real(0.01625) * rate + weight * angle.sin()) / inertia]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix([[real(0.9) / inertia]]);
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    // w_2' = M_2 w_2 (12)
    let w2_flow = Matrix::<T, 1, 1>::from_f64([[-2.0]]) * w2;
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * x3 + d2;

    // -- true dynamics of block 3 (current) (11) --
    // F_3 with the plant's parameters
    let F3_plant = Vector([-(real(5.0) * amps + real(0.9) * rate) / real(0.025)]);
    // G_3 with the plant's parameters
    let G3_plant: Matrix<T, 1, 1> = Matrix::from_f64([[40.0]]);
    // d_3(t)
    let d3 = Vector([real(0.5) * (real(20.0) * t).sin() / real(0.025)]);
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3_plant + G3_plant * u_sat + d3;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([x1_flow[0], x2_flow[0], x3_flow[0], w2_flow[0]]);
    // columns: one per Wiener process
    let diffusion = Matrix([
        [real(0.0), real(0.0)],
        [real(0.01) / inertia, real(0.0)],
        [real(0.0), real(0.0)],
        [real(0.0), real(0.5)],
    ]);
    PlantOutputs {
        drift,
        diffusion,
        d2,
        d3,
    }
}
