// SHA-256 of the text below: 248be2683da0eb4352a0989a4071d5d3daba4ca29661f05c78a32f1b40c05954
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 50 additions, 63 multiplications, 0 divisions, 0 square roots, 4 elementary functions, 4 comparisons and selections

//! `missile_pitch`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::tables;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `alpha` (dimensionless), `q` (1/s), `mach_now` (dimensionless).
pub const STATES: usize = 3;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 0;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [0.0, 0.0, 3.0];

/// Initial state in each lane's run, drawn from the dispersions of the specification, SI.
#[inline(always)]
pub fn dispersed_state<T: Real>(noise: &Noise<T>) -> Vector<T, STATES> {
    let mut x = Vector::from_f64(INITIAL_STATE);
    x[0] = T::from_f64(0.0) + T::from_f64(0.008726646259971648) * noise.normal(0, 3);
    x[2] = T::from_f64(2.7) + T::from_f64(3.2 - 2.7) * noise.uniform(0, 5);
    x
}

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
    /// Part of `d1`.
    pub d1_1: Vector<T, 2>,
    /// `d_1(t)`
    pub d1: Vector<T, 1>,
}

impl<T: Real> OfTime<T> for Clock<T> {
    #[inline(always)]
    fn at(t: T) -> Self {
        clock(t)
    }

    #[inline(always)]
    fn of_lane(&self, lane: usize) -> Self {
        Self {
            d1_1: self.d1_1.in_every_lane(lane),
            d1: self.d1.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;
    let t1 = real(3.0) * t;
    let t2 = real(5.0) * t;
    let d1_1 = Vector([t1, t2]).sin();

    // -- true dynamics of block 1 (incidence) (11) --
    // d_1(t)
    let d1 = Vector([real(0.02) * d1_1[0]]);
    Clock { d1_1, d1 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 3>,
    /// `d_1(t)`
    pub d1: Vector<T, 1>,
    /// `d_2(t)`
    pub d2: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 50 additions, 60 multiplications, 0 divisions, 0 square roots, 2 elementary
/// functions, 4 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 3>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- true dynamics of block 2 (rate) (11) --
    // d_2(t)
    let d2 = Vector([clock.d1_1[1]]);

    // -- plant model --
    let q = x[1];
    let k_alpha = real(0.020689893591852894);
    let mach_now = x[2];
    let alpha = x[0];
    let at_alpha_mach = tables::at_alpha_mach(alpha, mach_now);
    let normal = params.CN_scale * at_alpha_mach.CN;
    let delta = u_sat[0];
    let fin = params.fin_scale * delta * real(57.29577951308232);
    let k_q = real(1.2319461447637945);

    // -- flown plant, beyond the blocks --
    let t1 = normal + real(-0.034) * fin;
    let t2 = alpha.cos();
    // x_1' of the flown plant: its own rates + d_1
    let x1_flown = Vector([q + k_alpha * mach_now * t1 * t2]) + clock.d1;
    let t3 = mach_now * mach_now;
    // x_2' of the flown plant: its own rates + d_2
    let x2_flown = Vector([
        k_q * t3 * (params.CM_scale * at_alpha_mach.CM + real(-0.206) * fin),
    ]) + d2;

    // -- packed plant state: x_1 .. x_n, further states, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x1_flown[0],
        x2_flown[0],
        k_alpha * t3 * (real(-0.3) * t2 - (t1 * alpha.sin()).abs()),
    ]);
    PlantOutputs {
        drift,
        d1: clock.d1,
        d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 50 additions, 63 multiplications, 0 divisions, 0 square roots, 4 elementary
/// functions, 4 comparisons and selections.
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
