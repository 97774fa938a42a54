// SHA-256 of the text below: c82fc1ca074e90d6ad91b0acb79bead631ffa536b10b3792c137a0b3b22be4f0
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 8 additions, 16 multiplications, 1 divisions, 0 square roots, 0 elementary functions, 0 comparisons and selections

//! `active_suspension`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `z` (m), `v` (m/s), `f` (dimensionless), then 3 states of the
/// exosystems of block 2.
pub const STATES: usize = 6;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 3;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.02, 0.0, 0.0, 0.0, 0.0, 0.0];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
    /// Values of [`prepare`] for these parameters.
    pub prepared: Prepared<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 1>,
}

impl<T: Real> Sde<T, STATES, NOISE_CHANNELS> for Plant<T> {
    type Instant = ();
    const STATE_DEPENDENT: [bool; NOISE_CHANNELS] = [false, false, false];

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
        diffusion[(2, 0)] * noise[0],
        diffusion[(3, 1)] * noise[1],
        T::zero(),
        diffusion[(5, 2)] * noise[2],
    ])
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `F2_plant`.
    pub F2_plant_1: T,
    /// `G_2 with the plant's parameters`
    pub G2_plant: Matrix<T, 1, 1>,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 1 multiplications, 1 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;
    let F2_plant_1 = real(1.0) / params.body_mass;

    // -- true dynamics of block 2 (speed) (11) --
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[real(1000.0) * F2_plant_1]]);
    Prepared { F2_plant_1, G2_plant }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 6>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 6, 3>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 8 additions, 15 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 6>,
    u_sat: Vector<T, 1>,
    prepared: &Prepared<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- disturbance observer of block 2 (49) --
    // L_2
    let L2: Matrix<T, 1, 3> = Matrix::from_f64([[53.3, 53.3, 3.33]]);

    // -- plant model --
    let v = x[1];
    let z = x[0];
    let f = x[2];

    // -- true dynamics of block 2 (speed) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        -(real(16000.0) * z + real(400000.0) * (z * z * z) + real(1000.0) * v)
            * prepared.F2_plant_1,
    ]);

    // -- given --
    let w2 = Vector([x[3], x[4], x[5]]);
    let x3 = Vector([f]);

    // -- true dynamics of block 2 (speed) (11) --
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + prepared.G2_plant * x3 + d2;

    // -- true dynamics of block 3 (actuator) (11) --
    // F_3 with the plant's parameters
    let F3_plant = Vector([real(-60.0) * f]);
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3_plant + u_sat * real(60.0);

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        v,
        x2_flow[0],
        x3_flow[0],
        real(-0.5) * x[3],
        x[5],
        real(-3167.0) * x[4] + real(-5.6) * x[5],
    ]);
    // columns: one per Wiener process
    let diffusion: Matrix<T, 6, 3> = Matrix::from_f64([
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [1.2, 0.0, 0.0],
        [0.0, 0.02, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 0.4],
    ]);
    PlantOutputs {
        drift,
        diffusion,
        d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 8 additions, 16 multiplications, 1 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    _t: T,
    x: Vector<T, 6>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    dynamics(x, u_sat, &prepared)
}
