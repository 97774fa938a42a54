// SHA-256 of the text below: 9799eaef0653a4edd43de2eebddc6fa23f635d1de3b716a2a4cfd63a264320de
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 47 additions, 64 multiplications, 2 divisions, 0 square roots, 4 elementary functions, 0 comparisons and selections

//! `surface_vessel`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `north` (m), `east` (m), `psi` (dimensionless), `surge` (m/s),
/// `sway` (m/s), `r` (1/s), then 6 states of the exosystems of block 2.
pub const STATES: usize = 12;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 6;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [
    0.1,
    -0.1,
    0.08726646259971647,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
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
    type Instant = Clock<T>;
    const STATE_DEPENDENT: [bool; NOISE_CHANNELS] = [
        false, false, false, false, false, false,
    ];

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
        let rate = dynamics(
            *self.x,
            self.plant.u_sat,
            &self.plant.params,
            self.clock,
            &self.plant.prepared,
        );
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
        let rate = dynamics(
            *self.x,
            self.plant.u_sat,
            &self.plant.params,
            self.clock,
            &self.plant.prepared,
        );
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
        let rate = dynamics(
            *self.x,
            self.plant.u_sat,
            &self.plant.params,
            self.clock,
            &self.plant.prepared,
        );
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
        diffusion[(4, 1)] * noise[1] + diffusion[(4, 2)] * noise[2],
        diffusion[(5, 1)] * noise[1] + diffusion[(5, 2)] * noise[2],
        T::zero(),
        diffusion[(7, 3)] * noise[3],
        T::zero(),
        diffusion[(9, 4)] * noise[4],
        T::zero(),
        diffusion[(11, 5)] * noise[5],
    ])
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `m_11`.
    pub m_11: T,
    /// `m_22`.
    pub m_22: T,
    /// `G_2 with the plant's parameters`
    pub G2_plant: Matrix<T, 3, 3>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 12, 6>,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 4 additions, 11 multiplications, 2 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let m_11 = real(23.8) + params.added_scale * real(2.0);
    let m_22 = real(23.8) + params.added_scale * real(10.0);
    let m_33 = real(1.76) + params.added_scale;

    // -- true dynamics of block 2 (velocity) (11) --
    let t1 = real(1.0) / m_11;
    let t2 = real(1.0) / (m_22 * m_33 - real(1.19858704));
    let t3 = m_33 * t2;
    let t4 = real(-1.0948) * t2;
    let t5 = m_22 * t2;
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([
        [t1, real(0.0), real(0.0)],
        [real(0.0), t3, t4],
        [real(0.0), t4, t5],
    ]);

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // columns: one per Wiener process
    let diffusion = {
        let mut sparse = Matrix::<T, 12, 6>::zero();
        sparse[(3, 0)] = t1 * real(0.02);
        sparse[(4, 1)] = t3 * real(0.02);
        sparse[(4, 2)] = t4 * real(0.005);
        sparse[(5, 1)] = t4 * real(0.02);
        sparse[(5, 2)] = t5 * real(0.005);
        sparse[(7, 3)] = real(0.04);
        sparse[(9, 4)] = real(0.04);
        sparse[(11, 5)] = real(0.08);
        sparse
    };
    Prepared {
        m_11,
        m_22,
        G2_plant,
        diffusion,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `d_1(t)`
    pub d1: Vector<T, 3>,
}

impl<T: Real> OfTime<T> for Clock<T> {
    #[inline(always)]
    fn at(t: T) -> Self {
        clock(t)
    }

    #[inline(always)]
    fn of_lane(&self, lane: usize) -> Self {
        Self {
            d1: self.d1.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 2 additions, 3 multiplications, 0 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 1 (pose) (11) --
    let t1 = real(0.1) * t;
    // d_1(t)
    let d1 = Vector([
        real(0.03) + real(0.01) * t1.sin(),
        real(-0.02) + real(0.01) * t1.cos(),
        real(0.0),
    ]);
    Clock { d1 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 12>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 12, 6>,
    /// `d_1(t)`
    pub d1: Vector<T, 3>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 3>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 41 additions, 50 multiplications, 0 divisions, 0 square roots, 2 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 12>,
    u_sat: Vector<T, 3>,
    params: &Params<T>,
    clock: &Clock<T>,
    prepared: &Prepared<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let psi = x[2];
    let surge = x[3];
    let sway = x[4];
    let r = x[5];
    let m_23 = real(1.0948);
    let sway_momentum = prepared.m_22 * sway + m_23 * r;
    let d_11 = real(0.72253) - real(-1.32742) * surge.abs()
        - real(-5.86643) * (surge * surge);
    let t1 = sway.abs();
    let t2 = r.abs();
    let d_22 = real(0.88965) - real(-36.47287) * t1 - real(-0.805) * t2;
    let d_23 = real(7.25) - real(-0.845) * t1 - real(-3.45) * t2;
    let d_32 = real(-0.0313) - real(3.95645) * t1 - real(0.13) * t2;
    let d_33 = real(1.9) - real(0.08) * t1 - real(-0.75) * t2;
    let t3 = prepared.m_11 * surge;
    let resistance = Vector([
        params.damping_scale * d_11 * surge - sway_momentum * r,
        t3 * r + params.damping_scale * (d_22 * sway + d_23 * r),
        sway_momentum * surge - t3 * sway
            + params.damping_scale * (d_32 * sway + d_33 * r),
    ]);

    // -- true dynamics of block 1 (pose) (11) --
    let t4 = psi.cos();
    let t5 = psi.sin();
    // G_1 with the plant's parameters
    let G1_plant = Matrix::rows([
        [t4, -t5, real(0.0)],
        [t5, t4, real(0.0)],
        [real(0.0), real(0.0), real(1.0)],
    ]);

    // -- given --
    let x2 = Vector([surge, sway, r]);

    // -- true dynamics of block 1 (pose) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = G1_plant * x2 + clock.d1;

    // -- true dynamics of block 2 (velocity) (11) --
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([x[7], x[9], x[11]]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = prepared.G2_plant * (u_sat - resistance) + d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x1_flow[0],
        x1_flow[1],
        x1_flow[2],
        x2_flow[0],
        x2_flow[1],
        x2_flow[2],
        x[7],
        real(-36.0) * x[6] + real(-1.2) * x[7],
        x[9],
        real(-36.0) * x[8] + real(-1.2) * x[9],
        x[11],
        real(-36.0) * x[10] + real(-1.2) * x[11],
    ]);
    PlantOutputs {
        drift,
        diffusion: prepared.diffusion,
        d1: clock.d1,
        d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 47 additions, 64 multiplications, 2 divisions, 0 square roots, 4 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 12>,
    u_sat: Vector<T, 3>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, params, &clock, &prepared)
}
