// SHA-256 of the text below: bb95269a63d07281893799b4d66f80bd8635a4051512bbc58f5903ffbcbc4114
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 5 additions, 5 multiplications, 0 divisions, 0 square roots, 1 elementary functions, 0 comparisons and selections

//! `chaotic_jerk`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `x` (dimensionless), `v` (1/s), `w` (1/s^2).
pub const STATES: usize = 3;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 0;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.1, 0.1, 0.1];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
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
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.params, self.clock);
        rate.drift
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `d_3(t)`
    pub d3: Vector<T, 1>,
}

impl<T: Real> OfTime<T> for Clock<T> {
    #[inline(always)]
    fn at(t: T) -> Self {
        clock(t)
    }

    #[inline(always)]
    fn of_lane(&self, lane: usize) -> Self {
        Self {
            d3: self.d3.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 0 additions, 1 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 3 (acceleration) (11) --
    // d_3(t)
    let d3 = Vector([real(0.2) * t.sin()]);
    Clock { d3 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 3>,
    /// `d_3(t)`
    pub d3: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 5 additions, 4 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 3>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    // -- plant model --
    let v = x[1];
    let w = x[2];

    // -- true dynamics of block 3 (acceleration) (11) --
    // F_3 with the plant's parameters
    let F3_plant = Vector([
        -params.c * x[0] - params.b * v - params.a * w + x[0] * x[0],
    ]);
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3_plant + u_sat + clock.d3;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([v, w, x3_flow[0]]);
    PlantOutputs {
        drift,
        d3: clock.d3,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 5 additions, 5 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 3>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let clock = clock(t);
    dynamics(x, u_sat, params, &clock)
}
