// SHA-256 of the text below: ac15c4f15908c565f5554e5c7fea1296fd1f23f6fa2022d91212183625f0ba89
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 22 additions, 40 multiplications, 4 divisions, 0 square roots, 6 elementary functions, 0 comparisons and selections

//! `quadrotor`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `phi` (dimensionless), `theta` (dimensionless), `psi`
/// (dimensionless), `p` (1/s), `q` (1/s), `r` (1/s), then 8 states of the exosystems of block 2.
pub const STATES: usize = 14;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 8;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [
    0.17453292519943295,
    -0.17453292519943295,
    0.08726646259971647,
    0.0,
    0.0,
    0.0,
    2.0,
    0.0,
    0.0,
    0.0,
    2.0,
    0.0,
    0.5,
    0.0,
];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
    /// Values of [`prepare`] for these parameters.
    pub prepared: Prepared<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 3>,
}

impl<T: Real> Sde<T, STATES, NOISE_CHANNELS> for Plant<T> {
    type Instant = ();
    const STATE_DEPENDENT: [bool; NOISE_CHANNELS] = [
        false, false, false, false, false, false, false, false,
    ];

    #[inline(always)]
    fn drift(&self, _at: &Self::Instant, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, x })
    }

    #[inline(always)]
    fn diffusion(
        &self,
        _at: &Self::Instant,
        x: &Vector<T, STATES>,
    ) -> Matrix<T, STATES, NOISE_CHANNELS> {
        T::outlined(Diffusion { plant: self, x })
    }

    #[inline(always)]
    fn drift_and_noise(
        &self,
        _at: &Self::Instant,
        x: &Vector<T, STATES>,
        dw: &Vector<T, NOISE_CHANNELS>,
    ) -> (Vector<T, STATES>, Vector<T, STATES>) {
        T::outlined(Rates { plant: self, x, dw })
    }
}
/// Drift.
struct Drift<'a, T> {
    plant: &'a Plant<T>,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Drift<'_, T> {
    type Output = Vector<T, STATES>;
    #[inline(always)]
    fn run(self) -> Vector<T, STATES> {
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.prepared);
        rate.drift
    }
}
/// Diffusion.
struct Diffusion<'a, T> {
    plant: &'a Plant<T>,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Diffusion<'_, T> {
    type Output = Matrix<T, STATES, NOISE_CHANNELS>;
    #[inline(always)]
    fn run(self) -> Matrix<T, STATES, NOISE_CHANNELS> {
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.prepared);
        rate.diffusion
    }
}
/// Drift, and diffusion times noise.
struct Rates<'a, T> {
    plant: &'a Plant<T>,
    x: &'a Vector<T, STATES>,
    dw: &'a Vector<T, NOISE_CHANNELS>,
}
impl<T: Real> Part for Rates<'_, T> {
    type Output = (Vector<T, STATES>, Vector<T, STATES>);
    #[inline(always)]
    fn run(self) -> (Vector<T, STATES>, Vector<T, STATES>) {
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.prepared);
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
        T::zero(),
        T::zero(),
        diffusion[(3, 0)] * noise[0],
        diffusion[(4, 1)] * noise[1],
        diffusion[(5, 2)] * noise[2],
        diffusion[(6, 3)] * noise[3],
        T::zero(),
        diffusion[(8, 4)] * noise[4],
        diffusion[(9, 5)] * noise[5],
        T::zero(),
        diffusion[(11, 6)] * noise[6],
        T::zero(),
        diffusion[(13, 7)] * noise[7],
    ])
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `F2_plant`.
    pub F2_plant_1: T,
    /// Part of `F2_plant`.
    pub F2_plant_2: T,
    /// Part of `F2_plant`.
    pub F2_plant_3: T,
    /// Part of `F2_plant`.
    pub F2_plant_4: T,
    /// Part of `F2_plant`.
    pub F2_plant_5: T,
    /// Part of `F2_plant`.
    pub F2_plant_6: T,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 14, 8>,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 3 additions, 6 multiplications, 3 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let J_y = params.pitch_scale * real(0.00368);
    let J_z = params.yaw_scale * real(0.00703);
    let J_x = params.roll_scale * real(0.00365);
    let F2_plant_1 = J_y - J_z;
    let F2_plant_2 = real(1.0) / J_x;
    let F2_plant_3 = J_z - J_x;
    let F2_plant_4 = real(1.0) / J_y;
    let F2_plant_5 = J_x - J_y;
    let F2_plant_6 = real(1.0) / J_z;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // columns: one per Wiener process
    let diffusion = {
        let mut sparse = Matrix::<T, 14, 8>::zero();
        sparse[(3, 0)] = real(0.0001) * F2_plant_2;
        sparse[(4, 1)] = real(0.0001) * F2_plant_4;
        sparse[(5, 2)] = real(0.0001) * F2_plant_6;
        sparse[(6, 3)] = real(1.0);
        sparse[(8, 4)] = real(2.0);
        sparse[(9, 5)] = real(1.0);
        sparse[(11, 6)] = real(2.0);
        sparse[(13, 7)] = real(0.5);
        sparse
    };
    Prepared {
        F2_plant_1,
        F2_plant_2,
        F2_plant_3,
        F2_plant_4,
        F2_plant_5,
        F2_plant_6,
        diffusion,
    }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 14>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 14, 8>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 3>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 19 additions, 34 multiplications, 1 divisions, 0 square roots, 6 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 14>,
    u_sat: Vector<T, 3>,
    prepared: &Prepared<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let phi = x[0];
    let theta = x[1];
    let p = x[3];
    let q = x[4];
    let r = x[5];

    // -- true dynamics of block 1 (attitude) (11) --
    let t1 = Vector([phi, theta]);
    let [sin_phi, _] = t1.sin().0;
    let [_, tan_theta] = t1.tan().0;
    let [cos_phi, cos_theta] = t1.cos().0;
    let t2 = real(1.0) / cos_theta;
    // G_1 with the plant's parameters
    let G1_plant = Matrix::rows([
        [real(1.0), sin_phi * tan_theta, cos_phi * tan_theta],
        [real(0.0), cos_phi, -sin_phi],
        [real(0.0), sin_phi * t2, cos_phi * t2],
    ]);

    // -- given --
    let x2 = Vector([p, q, r]);

    // -- true dynamics of block 1 (attitude) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = G1_plant * x2;

    // -- true dynamics of block 2 (rates) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        prepared.F2_plant_1 * q * r * prepared.F2_plant_2,
        prepared.F2_plant_3 * p * r * prepared.F2_plant_4,
        prepared.F2_plant_5 * p * q * prepared.F2_plant_6,
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([x[6] + x[8], x[9] + x[11], x[12] + x[13]]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant
        + Vector([
            prepared.F2_plant_2 * u_sat[0],
            prepared.F2_plant_4 * u_sat[1],
            prepared.F2_plant_6 * u_sat[2],
        ]) + d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x1_flow[0],
        x1_flow[1],
        x1_flow[2],
        x2_flow[0],
        x2_flow[1],
        x2_flow[2],
        real(-0.2) * x[6] + real(12.0) * x[7],
        real(-12.0) * x[6] + real(-0.2) * x[7],
        -x[8],
        real(-0.2) * x[9] + real(12.0) * x[10],
        real(-12.0) * x[9] + real(-0.2) * x[10],
        -x[11],
        real(0.0),
        real(-3.0) * x[13],
    ]);
    PlantOutputs {
        drift,
        diffusion: prepared.diffusion,
        d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 22 additions, 40 multiplications, 4 divisions, 0 square roots, 6 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    _t: T,
    x: Vector<T, 14>,
    u_sat: Vector<T, 3>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    dynamics(x, u_sat, &prepared)
}
