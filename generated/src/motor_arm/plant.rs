// SHA-256 of the text below: 0756319d7d93349bda5de79720bffaf954d644bebb78b585d07777bfa60c68ab
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 9 additions, 20 multiplications, 1 divisions, 0 square roots, 2 elementary functions, 0 comparisons and selections

//! `motor_arm`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
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
    /// Values of [`prepare`] for these parameters.
    pub prepared: Prepared<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 1>,
}

impl<T: Real> Sde<T, STATES, NOISE_CHANNELS> for Plant<T> {
    type Instant = Clock<T>;
    const STATE_DEPENDENT: [bool; NOISE_CHANNELS] = [false, false];

    #[inline(always)]
    fn drift(&self, at: &Self::Instant, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, clock: at, x })
    }

    #[inline(always)]
    fn diffusion(
        &self,
        at: &Self::Instant,
        x: &Vector<T, STATES>,
    ) -> Matrix<T, STATES, NOISE_CHANNELS> {
        T::outlined(Diffusion {
            plant: self,
            clock: at,
            x,
        })
    }

    #[inline(always)]
    fn drift_and_noise(
        &self,
        at: &Self::Instant,
        x: &Vector<T, STATES>,
        dw: &Vector<T, NOISE_CHANNELS>,
    ) -> (Vector<T, STATES>, Vector<T, STATES>) {
        T::outlined(Rates {
            plant: self,
            clock: at,
            x,
            dw,
        })
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
/// Diffusion.
struct Diffusion<'a, T> {
    plant: &'a Plant<T>,
    clock: &'a Clock<T>,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Diffusion<'_, T> {
    type Output = Matrix<T, STATES, NOISE_CHANNELS>;
    #[inline(always)]
    fn run(self) -> Matrix<T, STATES, NOISE_CHANNELS> {
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.prepared, self.clock);
        rate.diffusion
    }
}
/// Drift, and diffusion times noise.
struct Rates<'a, T> {
    plant: &'a Plant<T>,
    clock: &'a Clock<T>,
    x: &'a Vector<T, STATES>,
    dw: &'a Vector<T, NOISE_CHANNELS>,
}
impl<T: Real> Part for Rates<'_, T> {
    type Output = (Vector<T, STATES>, Vector<T, STATES>);
    #[inline(always)]
    fn run(self) -> (Vector<T, STATES>, Vector<T, STATES>) {
        let rate = dynamics(*self.x, self.plant.u_sat, &self.plant.prepared, self.clock);
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

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `weight`.
    pub weight: T,
    /// Part of `F2_plant`.
    pub F2_plant_1: T,
    /// `G_2 with the plant's parameters`
    pub G2_plant: Matrix<T, 1, 1>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 4, 2>,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 3 additions, 8 multiplications, 1 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let weight = (real(0.253) + params.load_mass) * real(0.305) * real(9.81);
    let inertia = real(0.017315216666666668) + params.load_mass * real(0.093025)
        + real(2.0) * params.load_mass * real(0.000529) * real(0.2);
    let F2_plant_1 = real(1.0) / inertia;

    // -- true dynamics of block 2 (speed) (11) --
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[real(0.9) * F2_plant_1]]);

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // columns: one per Wiener process
    let diffusion = Matrix::rows([
        [real(0.0), real(0.0)],
        [real(0.01) * F2_plant_1, real(0.0)],
        [real(0.0), real(0.0)],
        [real(0.0), real(0.5)],
    ]);
    Prepared {
        weight,
        F2_plant_1,
        G2_plant,
        diffusion,
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
/// Operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 3 (current) (11) --
    // d_3(t)
    let d3 = Vector([real(0.5) * (real(20.0) * t).sin() * real(40.0)]);
    Clock { d3 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 4>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 4, 2>,
    /// `d2`.
    pub d2: Vector<T, 1>,
    /// `d_3(t)`
    pub d3: Vector<T, 1>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 6 additions, 9 multiplications, 0 divisions, 0 square roots, 1 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 4>,
    u_sat: Vector<T, 1>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let rate = x[1];
    let angle = x[0];
    let amps = x[2];

    // -- true dynamics of block 2 (speed) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        -(real(0.01625) * rate + prepared.weight * angle.sin()) * prepared.F2_plant_1,
    ]);

    // -- given --
    let w2 = Vector([x[3]]);
    let x3 = Vector([amps]);

    // -- true dynamics of block 2 (speed) (11) --
    // w_2' = M_2 w_2 (12)
    let w2_flow = w2 * real(-2.0);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + prepared.G2_plant * x3 + w2;

    // -- true dynamics of block 3 (current) (11) --
    // F_3 with the plant's parameters
    let F3_plant = Vector([-(real(5.0) * amps + real(0.9) * rate) * real(40.0)]);
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3_plant + u_sat * real(40.0) + clock.d3;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([rate, x2_flow[0], x3_flow[0], w2_flow[0]]);
    PlantOutputs {
        drift,
        diffusion: prepared.diffusion,
        d2: w2,
        d3: clock.d3,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 9 additions, 20 multiplications, 1 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 4>,
    u_sat: Vector<T, 1>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, &prepared, &clock)
}
