// SHA-256 of the text below: f868a2c2893784e4f31a9963d2b4b26557a308a8b995b7b59e9be6a51731f3ac
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 77 additions, 139 multiplications, 1 divisions, 0 square roots, 23 elementary functions, 0 comparisons and selections

//! `six_joint_arm`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `q1` (dimensionless), `q2` (dimensionless), `q3` (dimensionless),
/// `q4` (dimensionless), `q5` (dimensionless), `q6` (dimensionless), `v1` (1/s), `v2` (1/s),
/// `v3` (1/s), `v4` (1/s), `v5` (1/s), `v6` (1/s).
pub const STATES: usize = 12;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 0;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [
    0.08726646259971647,
    -0.4363323129985824,
    0.08726646259971647,
    0.08726646259971647,
    -0.08726646259971647,
    0.08726646259971647,
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
    /// `k_1`.
    pub k_1: T,
    /// `k_2`.
    pub k_2: T,
    /// `k_3`.
    pub k_3: T,
    /// `k_4`.
    pub k_4: T,
    /// `k_5`.
    pub k_5: T,
    /// `k_7`.
    pub k_7: T,
    /// Part of `M_13`.
    pub M_13_1: T,
    /// `k_8`.
    pub k_8: T,
    /// `k_9`.
    pub k_9: T,
    /// Part of `M_23`.
    pub M_23_1: T,
    /// `M_33`.
    pub M_33: T,
    /// Part of `M_11_2`.
    pub M_11_2_1: T,
    /// Part of `M_11_2`.
    pub M_11_2_2: T,
    /// Part of `F2_plant`.
    pub F2_plant_1: T,
    /// `pull_2`.
    pub pull_2: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 11 additions, 16 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let k_1 = real(2.57) + params.load * real(0.022530010000000003);
    let k_2 = real(1.38) + params.load * real(0.18645124000000002);
    let t1 = params.load * real(0.18757560999999998);
    let k_3 = real(0.3) + t1;
    let k_4 = real(0.744) + real(2.0) * params.load * real(0.4318) * real(0.4331);
    let t2 = params.load * real(0.1501);
    let k_5 = real(0.69) + t2 * real(0.4318);
    let k_7 = real(0.134) + t2 * real(0.4331);
    let k_8 = real(6.79) + params.load * real(0.37402685);
    let k_9 = real(0.333) + t1;
    let M_33 = real(1.16) + t1;
    let t3 = params.load * real(9.81);
    let pull_2 = real(8.4) + t3 * real(0.4331);
    let M_13_1 = -k_7;
    let M_23_1 = real(0.5) * k_4;
    let M_11_2_1 = real(-2.0) * k_2;
    let M_11_2_2 = real(2.0) * k_3;
    let F2_plant_1 = -(real(37.2) + t3 * real(0.4318));
    Prepared {
        k_1,
        k_2,
        k_3,
        k_4,
        k_5,
        k_7,
        M_13_1,
        k_8,
        k_9,
        M_23_1,
        M_33,
        M_11_2_1,
        M_11_2_2,
        F2_plant_1,
        pull_2,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `d_2(t)`
    pub d2: Vector<T, 6>,
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
/// Operations: 1 additions, 9 multiplications, 0 divisions, 0 square roots, 6 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 2 (rates) (11) --
    let t1 = real(4.0) * t;
    let t2 = real(6.0) * t;
    let t3 = real(5.0) * t;
    let t4 = Vector([t1, t3, t2]);
    let [sin_t1, sin_t3, sin_t2] = t4.sin().0;
    let [cos_t1, _, cos_t2] = t4.cos().0;
    // d_2(t)
    let d2 = Vector([
        real(0.2) * sin_t1,
        real(0.2) * cos_t1,
        real(0.5) * sin_t3,
        real(3.0) * (real(1.0) + sin_t2),
        real(3.0) * sin_t2,
        real(3.0) * cos_t2,
    ]);
    Clock { d2 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 12>,
    /// `d_2(t)`
    pub d2: Vector<T, 6>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 65 additions, 114 multiplications, 1 divisions, 0 square roots, 17 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 12>,
    u_sat: Vector<T, 6>,
    params: &Params<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let v1 = x[6];
    let v2 = x[7];
    let v3 = x[8];
    let v4 = x[9];
    let v5 = x[10];
    let v6 = x[11];
    let q2 = x[1];
    let q3 = x[2];
    let q4 = x[3];
    let q5 = x[4];
    let t1 = q2 + q3;
    let t2 = Vector([t1, q2, q3, q4, q5]);
    let [cos_t1, cos_q2, cos_q3, cos_q4, cos_q5] = t2.cos().0;
    let c_2 = cos_q2;
    let c_23 = cos_t1;
    let [sin_t1, sin_q2, sin_q3, sin_q4, sin_q5] = t2.sin().0;
    let s_23 = sin_t1;
    let s_2 = sin_q2;
    let t3 = prepared.k_4 * c_2;
    let M_11 = prepared.k_1 + prepared.k_2 * (c_2 * c_2) + prepared.k_3 * (s_23 * s_23)
        + t3 * s_23;
    let k_6 = real(0.0238);
    let M_12 = prepared.k_5 * s_2 + k_6 * c_2 - prepared.k_7 * c_23;
    let M_13 = prepared.M_13_1 * c_23;
    let M_22 = prepared.k_8 + prepared.k_4 * sin_q3;
    let M_23 = prepared.k_9 + prepared.M_23_1 * sin_q3;
    let t4 = prepared.M_11_2_2 * s_23 * c_23;
    let M_11_2 = prepared.M_11_2_1 * s_2 * c_2 + t4
        + prepared.k_4 * (real(2.0) * q2 + q3).cos();
    let M_11_3 = t4 + t3 * c_23;
    let t5 = prepared.k_7 * s_23;
    let M_12_2 = prepared.k_5 * c_2 - k_6 * s_2 + t5;
    let t6 = v1 * real(10.0);
    let t7 = v6 * real(10.0);
    let t8 = v5 * real(10.0);
    let t9 = v4 * real(10.0);
    let t10 = v3 * real(10.0);
    let t11 = v2 * real(10.0);
    let [tanh_t6, tanh_t11, tanh_t10, tanh_t9, tanh_t8, tanh_t7] = Vector([
            t6,
            t11,
            t10,
            t9,
            t8,
            t7,
        ])
        .tanh()
        .0;
    let t12 = Vector([
        real(6.3) * tanh_t6,
        real(5.5) * tanh_t11,
        real(2.6) * tanh_t10,
        real(1.3) * tanh_t9,
        tanh_t8,
        real(1.2) * tanh_t7,
    ]);
    let dry = t12 * params.dry_scale;

    // -- true dynamics of block 2 (rates) (11) --
    let t13 = M_22 * prepared.M_33 - M_23 * M_23;
    let t14 = M_23 * M_13 - prepared.M_33 * M_12;
    let t15 = M_12 * M_23 - M_13 * M_22;
    let t16 = real(1.0) / (M_11 * t13 + M_12 * t14 + M_13 * t15);
    let t17 = t13 * t16;
    let t18 = t14 * t16;
    let t19 = t15 * t16;
    let t20 = (prepared.M_33 * M_11 - M_13 * M_13) * t16;
    let t21 = (M_13 * M_12 - M_11 * M_23) * t16;
    let t22 = (M_11 * M_22 - M_12 * M_12) * t16;
    let t23 = v2 * v2;
    let t24 = (M_11_2 * v2 + M_11_3 * v3) * v1 + M_12_2 * t23;
    let t25 = v1 * v1;
    let t26 = prepared.k_4 * cos_q3 * (v2 + real(0.5) * v3) * v3
        - real(0.5) * M_11_2 * t25;
    let t27 = prepared.pull_2 * s_23;
    let t28 = Vector([
        t24 + t5 * (real(2.0) * v2 + v3) * v3,
        t26 + (prepared.F2_plant_1 * c_2 - t27 + real(1.02) * s_2),
        real(-0.5) * M_11_3 * t25 - prepared.M_23_1 * cos_q3 * t23
            + (real(0.25) * c_23 - t27),
        real(0.028) * s_23 * sin_q4 * sin_q5,
        real(-0.028) * (c_23 * sin_q5 + s_23 * cos_q4 * cos_q5),
        real(0.0),
    ]);
    let t29 = t28 + dry;
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        -t17 * t29[0] - t18 * t29[1] - t19 * t29[2],
        -t18 * t29[0] - t20 * t29[1] - t21 * t29[2],
        -t19 * t29[0] - t21 * t29[1] - t22 * t29[2],
        real(-5.0) * t29[3],
        real(-5.555555555555555) * t29[4],
        real(-5.2631578947368425) * t29[5],
    ]);
    let t30 = Vector([
        t17 * u_sat[0] + t18 * u_sat[1] + t19 * u_sat[2],
        t18 * u_sat[0] + t20 * u_sat[1] + t21 * u_sat[2],
        t19 * u_sat[0] + t21 * u_sat[1] + t22 * u_sat[2],
        real(5.0) * u_sat[3],
        real(5.555555555555555) * u_sat[4],
        real(5.2631578947368425) * u_sat[5],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + t30 + clock.d2;

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        v1,
        v2,
        v3,
        v4,
        v5,
        v6,
        x2_flow[0],
        x2_flow[1],
        x2_flow[2],
        x2_flow[3],
        x2_flow[4],
        x2_flow[5],
    ]);
    PlantOutputs {
        drift,
        d2: clock.d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 77 additions, 139 multiplications, 1 divisions, 0 square roots, 23 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 12>,
    u_sat: Vector<T, 6>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, params, &prepared, &clock)
}
