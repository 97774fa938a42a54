// SHA-256 of the text below: ff404548faf0747767cf75a072041c1758875d29ea5500eb582d1c682ae0109c
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 83 additions, 136 multiplications, 5 divisions, 0 square roots, 13 elementary functions, 0 comparisons and selections

//! `underwater_vehicle`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `north` (m), `east` (m), `down` (m), `phi` (dimensionless), `theta`
/// (dimensionless), `psi` (dimensionless), `surge` (m/s), `sway` (m/s), `heave` (m/s), `p`
/// (1/s), `q` (1/s), `r` (1/s), then 12 states of the exosystems of block 2.
pub const STATES: usize = 24;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 12;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [
    0.1,
    -0.1,
    0.1,
    0.05235987755982989,
    -0.05235987755982989,
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
    pub u_sat: Vector<T, 6>,
}

impl<T: Real> Sde<T, STATES, NOISE_CHANNELS> for Plant<T> {
    type Instant = Clock<T>;
    const STATE_DEPENDENT: [bool; NOISE_CHANNELS] = [
        false, false, false, false, false, false, false, false, false, false, false,
        false,
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
        T::zero(),
        T::zero(),
        T::zero(),
        diffusion[(6, 0)] * noise[0] + diffusion[(6, 4)] * noise[4],
        diffusion[(7, 1)] * noise[1] + diffusion[(7, 3)] * noise[3],
        diffusion[(8, 2)] * noise[2],
        diffusion[(9, 1)] * noise[1] + diffusion[(9, 3)] * noise[3],
        diffusion[(10, 0)] * noise[0] + diffusion[(10, 4)] * noise[4],
        diffusion[(11, 5)] * noise[5],
        T::zero(),
        diffusion[(13, 6)] * noise[6],
        T::zero(),
        diffusion[(15, 7)] * noise[7],
        T::zero(),
        diffusion[(17, 8)] * noise[8],
        T::zero(),
        diffusion[(19, 9)] * noise[9],
        T::zero(),
        diffusion[(21, 10)] * noise[10],
        T::zero(),
        diffusion[(23, 11)] * noise[11],
    ])
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `x2_flow`.
    pub x2_flow_1: T,
    /// Part of `x2_flow`.
    pub x2_flow_2: T,
    /// Part of `x2_flow`.
    pub x2_flow_3: T,
    /// Part of `x2_flow`.
    pub x2_flow_4: T,
    /// Part of `x2_flow`.
    pub x2_flow_5: T,
    /// Part of `x2_flow`.
    pub x2_flow_6: T,
    /// Part of `x2_flow`.
    pub x2_flow_7: T,
    /// Part of `x2_flow`.
    pub x2_flow_8: T,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 24, 12>,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 6 additions, 22 multiplications, 4 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let m_x = real(11.5) + params.added_scale * real(5.5);
    let m_y = real(11.5) + params.added_scale * real(12.7);
    let m_z = real(11.5) + params.added_scale * real(14.57);
    let I = real(0.16) + params.added_scale * real(0.12);
    let t1 = real(1.0) / (m_x * I - real(0.0529));
    let x2_flow_1 = I * t1;
    let x2_flow_2 = real(-0.23) * t1;
    let x2_flow_3 = m_x * t1;
    let t2 = real(1.0) / (m_y * I - real(0.0529));
    let x2_flow_4 = I * t2;
    let x2_flow_5 = real(0.23) * t2;
    let x2_flow_6 = m_y * t2;
    let x2_flow_7 = real(1.0) / m_z;
    let x2_flow_8 = real(1.0) / I;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // columns: one per Wiener process
    let diffusion = {
        let mut sparse = Matrix::<T, 24, 12>::zero();
        sparse[(6, 0)] = x2_flow_1 * real(0.1);
        sparse[(6, 4)] = x2_flow_2 * real(0.01);
        sparse[(7, 1)] = x2_flow_4 * real(0.1);
        sparse[(7, 3)] = x2_flow_5 * real(0.01);
        sparse[(8, 2)] = x2_flow_7 * real(0.1);
        sparse[(9, 1)] = x2_flow_5 * real(0.1);
        sparse[(9, 3)] = x2_flow_6 * real(0.01);
        sparse[(10, 0)] = x2_flow_2 * real(0.1);
        sparse[(10, 4)] = x2_flow_3 * real(0.01);
        sparse[(11, 5)] = x2_flow_8 * real(0.01);
        sparse[(13, 6)] = real(0.1);
        sparse[(15, 7)] = real(0.1);
        sparse[(17, 8)] = real(0.1);
        sparse[(19, 9)] = real(0.2);
        sparse[(21, 10)] = real(0.2);
        sparse[(23, 11)] = real(0.2);
        sparse
    };
    Prepared {
        x2_flow_1,
        x2_flow_2,
        x2_flow_3,
        x2_flow_4,
        x2_flow_5,
        x2_flow_6,
        x2_flow_7,
        x2_flow_8,
        diffusion,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// Part of `d1`.
    pub d1_1: T,
    /// Part of `d1`.
    pub d1_2: T,
    /// Part of `d1`.
    pub d1_3: T,
    /// `d_1(t)`
    pub d1: Vector<T, 6>,
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
            d1_2: self.d1_2.in_every_lane(lane),
            d1_3: self.d1_3.in_every_lane(lane),
            d1: self.d1.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 2 additions, 5 multiplications, 0 divisions, 0 square roots, 4 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;
    let t1 = real(0.2) * t;
    let t2 = real(0.1) * t;
    let t3 = Vector([t1, t2]);
    let [sin_t1, sin_t2] = t3.sin().0;
    let d1_1 = real(0.2) + real(0.1) * sin_t1;
    let [cos_t1, _] = t3.cos().0;
    let d1_2 = real(-0.1) + real(0.1) * cos_t1;
    let d1_3 = real(0.05) * sin_t2;

    // -- true dynamics of block 1 (pose) (11) --
    // d_1(t)
    let d1 = Vector([d1_1, d1_2, d1_3, real(0.0), real(0.0), real(0.0)]);
    Clock { d1_1, d1_2, d1_3, d1 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 24>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 24, 12>,
    /// `d_1(t)`
    pub d1: Vector<T, 6>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 6>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 75 additions, 109 multiplications, 1 divisions, 0 square roots, 9 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 24>,
    u_sat: Vector<T, 6>,
    params: &Params<T>,
    clock: &Clock<T>,
    prepared: &Prepared<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let phi = x[3];
    let theta = x[4];
    let psi = x[5];
    let surge = x[6];
    let sway = x[7];
    let heave = x[8];
    let p = x[9];
    let q = x[10];
    let r = x[11];
    let arm = real(0.23);
    let t1 = Vector([phi, theta, psi]);
    let [cos_phi, cos_theta, cos_psi] = t1.cos().0;
    let [sin_phi, sin_theta, sin_psi] = t1.sin().0;
    let t2 = -sin_theta;
    let t3 = cos_theta * sin_phi;
    let t4 = cos_theta * cos_phi;
    let down_axis = Vector([t2, t3, t4]);
    let t5 = q * heave - r * sway;
    let t6 = r * surge - p * heave;
    let carried = Vector([t5, t6, p * sway - q * surge]);
    let added_momentum = Vector([
        real(5.5) * surge,
        real(12.7) * sway,
        real(14.57) * heave,
    ]) * params.added_scale;
    let t7 = Vector([
        (real(4.03) + real(18.18) * surge.abs()) * surge,
        (real(6.22) + real(21.66) * sway.abs()) * sway,
        (real(5.18) + real(36.99) * heave.abs()) * heave,
    ]);
    let drag = t7 * params.drag_scale;
    let t8 = Vector([p * r, q * r, -(p * p) - q * q]) * real(0.02);
    let t9 = Vector([
        q * added_momentum[2] - r * added_momentum[1],
        r * added_momentum[0] - p * added_momentum[2],
        p * added_momentum[1] - q * added_momentum[0],
    ]);
    let force = down_axis * real(-1.9849999999999852) - (carried + t8) * real(11.5) - t9
        - drag;
    let t10 = Vector([
        (real(0.07) + real(1.55) * p.abs()) * p,
        (real(0.07) + real(1.55) * q.abs()) * q,
        (real(0.07) + real(1.55) * r.abs()) * r,
    ]);
    let drag_torque = t10 * params.torque_scale;
    let t11 = Vector([
        sway * added_momentum[2] - heave * added_momentum[1],
        heave * added_momentum[0] - surge * added_momentum[2],
        surge * added_momentum[1] - sway * added_momentum[0],
    ]);
    let moment = Vector([t6 - real(9.81) * t3, real(9.81) * t2 - t5, real(0.0)]) * arm
        - t11 - drag_torque;

    // -- true dynamics of block 2 (velocity) (11) --
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([x[13], x[15], x[17], x[19], x[21], x[23]]);
    let t12 = Vector([force[0], force[1], force[2], moment[0], moment[1], moment[2]])
        + u_sat;
    let t13 = Vector([
        prepared.x2_flow_1 * t12[0] + prepared.x2_flow_2 * t12[4],
        prepared.x2_flow_4 * t12[1] + prepared.x2_flow_5 * t12[3],
        prepared.x2_flow_7 * t12[2],
        prepared.x2_flow_5 * t12[1] + prepared.x2_flow_6 * t12[3],
        prepared.x2_flow_2 * t12[0] + prepared.x2_flow_3 * t12[4],
        prepared.x2_flow_8 * t12[5],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = t13 + d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    let t14 = cos_psi * sin_theta;
    let t15 = sin_psi * sin_theta;
    let [_, tan_theta, _] = t1.tan().0;
    let t16 = real(1.0) / cos_theta;
    let t17 = cos_psi * cos_theta * surge + (t14 * sin_phi - sin_psi * cos_phi) * sway;
    let t18 = sin_psi * cos_theta * surge + (t15 * sin_phi + cos_psi * cos_phi) * sway;
    // dx/dt without noise
    let drift = Vector([
        t17 + (t14 * cos_phi + sin_psi * sin_phi) * heave + clock.d1_1,
        t18 + (t15 * cos_phi - cos_psi * sin_phi) * heave + clock.d1_2,
        t3 * sway - sin_theta * surge + t4 * heave + clock.d1_3,
        p + sin_phi * tan_theta * q + cos_phi * tan_theta * r,
        cos_phi * q - sin_phi * r,
        sin_phi * t16 * q + cos_phi * t16 * r,
        x2_flow[0],
        x2_flow[1],
        x2_flow[2],
        x2_flow[3],
        x2_flow[4],
        x2_flow[5],
        x[13],
        real(-0.2) * x[13] - x[12],
        x[15],
        real(-0.2) * x[15] - x[14],
        x[17],
        real(-0.2) * x[17] - x[16],
        x[19],
        real(-0.2) * x[19] - x[18],
        x[21],
        real(-0.2) * x[21] - x[20],
        x[23],
        real(-0.2) * x[23] - x[22],
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
/// Operations: 83 additions, 136 multiplications, 5 divisions, 0 square roots, 13 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 24>,
    u_sat: Vector<T, 6>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, params, &clock, &prepared)
}
