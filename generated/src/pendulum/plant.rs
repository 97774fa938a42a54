// SHA-256 of the text below: faf445f9ae527653d0edb72a029e31cd5fb7cd42589bfaf85b5a2c4fc9e376c8
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 4 additions, 7 multiplications, 1 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `pendulum`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
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
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.prepared, self.clock);
        rate.drift
    }
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

    // -- plant model --
    let inertia = params.mass * real(0.25);
    let F2_plant_1 = real(1.0) / inertia;

    // -- true dynamics of block 2 (speed) (11) --
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[F2_plant_1]]);
    Prepared { F2_plant_1, G2_plant }
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
/// Operations: 1 additions, 2 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 2 (speed) (11) --
    // d_2(t)
    let d2 = Vector([real(1.0) + real(2.0) * (real(3.0) * t).sin()]);
    Clock { d2 }
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
/// Operations: 3 additions, 4 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 2>,
    u_sat: Vector<T, 1>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let omega = x[1];
    let theta = x[0];

    // -- true dynamics of block 2 (speed) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        real(-19.62) * theta.sin() - real(0.1) * omega * prepared.F2_plant_1,
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + prepared.G2_plant * u_sat + clock.d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([omega, x2_flow[0]]);
    PlantOutputs {
        drift,
        d2: clock.d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 4 additions, 7 multiplications, 1 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 2>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, &prepared, &clock)
}
