// SHA-256 of the text below: f743bd7c8845f7cfaf4e354a6f541fb1987db4486eb7fa7156108f5fcd2d3c2f
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 10 additions, 17 multiplications, 0 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `flexible_joint`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
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
    /// Values of [`prepare`] for these parameters.
    pub prepared: Prepared<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 1>,
}

impl<T: Real> Sde<T, STATES, 0> for Plant<T> {
    type Instant = Clock<T>;
    #[inline(always)]
    fn drift(&self, at: &Self::Instant, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, clock: at, x })
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
    clock: &'a Clock<T>,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Drift<'_, T> {
    type Output = Vector<T, STATES>;
    #[inline(always)]
    fn run(self) -> Vector<T, STATES> {
        let rate = dynamics(
            *self.x,
            self.plant.u_sat,
            &self.plant.params,
            &self.plant.prepared,
            self.clock,
        );
        rate.drift
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `G_2 with the plant's parameters`
    pub G2_plant: Matrix<T, 1, 1>,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 1 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- true dynamics of block 2 (link_rate) (11) --
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[params.stiffness * real(32.25806451612903)]]);
    Prepared { G2_plant }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `d_2(t)`
    pub d2: Vector<T, 1>,
}

impl<T: Real> OfTime<T> for Clock<T> {
    #[inline(always)]
    fn at(t: T) -> Self {
        clock(t)
    }

    #[inline(always)]
    fn of_lane(&self, lane: usize) -> Self {
        Self {
            d2: self.d2.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 1 additions, 3 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 2 (link_rate) (11) --
    // d_2(t)
    let d2 = Vector([
        real(0.1) * (real(1.0) + (real(3.0) * t).sin()) * real(32.25806451612903),
    ]);
    Clock { d2 }
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
/// Operations: 9 additions, 13 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 7>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- disturbance observer of block 4 (49) --
    // L_4
    let L4: Matrix<T, 1, 3> = Matrix::from_f64([[1.0, 1.0, 0.0]]);

    // -- plant model --
    let q1 = x[0];
    let q2 = x[2];
    let v2 = x[3];

    // -- true dynamics of block 2 (link_rate) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        -(params.weight * q1.sin() + params.stiffness * q1) * real(32.25806451612903),
    ]);

    // -- given --
    let x3 = Vector([q2]);
    let w4 = Vector([x[4], x[5], x[6]]);

    // -- true dynamics of block 2 (link_rate) (11) --
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + prepared.G2_plant * x3 + clock.d2;

    // -- true dynamics of block 4 (motor_rate) (11) --
    // F_4 with the plant's parameters
    let F4_plant = Vector([
        -(real(0.007) * v2 + params.stiffness * (q2 - q1)) * real(250.0),
    ]);
    // d_4 = L_4 w_4 (12)
    let d4 = L4 * w4;
    // F_4 + G_4 x_5 + d_4
    let x4_flow = F4_plant + u_sat * real(250.0) + d4;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x[1],
        x2_flow[0],
        v2,
        x4_flow[0],
        real(0.0),
        real(20.0) * x[6],
        real(-20.0) * x[5],
    ]);
    PlantOutputs {
        drift,
        d2: clock.d2,
        d4,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 10 additions, 17 multiplications, 0 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 7>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, params, &prepared, &clock)
}
