// SHA-256 of the text below: 38a7b4b937825384193718484c5474978df4647d82f04057f5f50240f0d0b9f2
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 18 additions, 28 multiplications, 1 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `two_link_arm`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `q1` (dimensionless), `q2` (dimensionless), `v1` (1/s), `v2` (1/s),
/// then 5 states of the exosystems of block 2.
pub const STATES: usize = 9;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 0;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.1, -0.1, 0.0, 0.0, 0.5, -0.2, 1.0, 0.0, 2.0];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
    /// Values of [`prepare`] for these parameters.
    pub prepared: Prepared<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 2>,
}

impl<T: Real> Sde<T, STATES, 0> for Plant<T> {
    type Instant = ();
    #[inline(always)]
    fn drift(&self, _at: &Self::Instant, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, x })
    }

    #[inline(always)]
    fn diffusion(
        &self,
        _at: &Self::Instant,
        _x: &Vector<T, STATES>,
    ) -> Matrix<T, STATES, 0> {
        Matrix::zero()
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

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `a_1`.
    pub a_1: T,
    /// `a_3`.
    pub a_3: T,
    /// Part of `M_11`.
    pub M_11_1: T,
    /// `a_4`.
    pub a_4: T,
    /// Part of `M_11`.
    pub M_11_2: T,
    /// `a_2`.
    pub a_2: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 3 additions, 6 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let t1 = params.m_e * real(0.36);
    let a_1 = real(0.62) + t1 + params.m_e;
    let t2 = params.m_e * real(0.6);
    let a_3 = t2 * real(0.8660254037844386);
    let a_4 = t2 * real(0.5);
    let a_2 = real(0.25) + t1;
    let M_11_1 = real(2.0) * a_3;
    let M_11_2 = real(2.0) * a_4;
    Prepared {
        a_1,
        a_3,
        M_11_1,
        a_4,
        M_11_2,
        a_2,
    }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 9>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 2>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 15 additions, 22 multiplications, 1 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 9>,
    u_sat: Vector<T, 2>,
    prepared: &Prepared<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let v1 = x[2];
    let v2 = x[3];
    let q2 = x[1];
    let t1 = q2.cos();
    let t2 = q2.sin();
    let M_11 = prepared.a_1 + prepared.M_11_1 * t1 + prepared.M_11_2 * t2;
    let M_12 = prepared.a_2 + prepared.a_3 * t1 + prepared.a_4 * t2;
    let coriolis = prepared.a_3 * t2 - prepared.a_4 * t1;
    let torque = Vector([-v2 * v1 - (v1 + v2) * v2, v1 * v1]) * coriolis;

    // -- true dynamics of block 2 (rates) (11) --
    let t3 = real(1.0) / (M_11 * prepared.a_2 - M_12 * M_12);
    let t4 = -M_12 * t3;
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[prepared.a_2 * t3, t4], [t4, M_11 * t3]]);
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([x[4], x[6] + x[7]]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = G2_plant * (u_sat - torque) + d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        v1,
        v2,
        x2_flow[0],
        x2_flow[1],
        x[5],
        real(0.0),
        real(0.0),
        real(3.0) * x[8],
        real(-3.0) * x[7],
    ]);
    PlantOutputs { drift, d2 }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 18 additions, 28 multiplications, 1 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    _t: T,
    x: Vector<T, 9>,
    u_sat: Vector<T, 2>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    dynamics(x, u_sat, &prepared)
}
