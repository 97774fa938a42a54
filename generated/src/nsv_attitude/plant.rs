// SHA-256 of the text below: 829fcbf2936283ccdef781e842fb58b87297922c2a1c67c619f0979f89ea9e34
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 131 additions, 196 multiplications, 2 divisions, 0 square roots, 12 elementary functions, 0 comparisons and selections

//! `nsv_attitude`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `alpha` (dimensionless), `beta` (dimensionless), `mu`
/// (dimensionless), `p` (1/s), `q` (1/s), `r` (1/s), then 6 states of the exosystems of block 2.
pub const STATES: usize = 12;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 9;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [
    0.008726646259971648,
    0.008726646259971648,
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
    pub u_sat: Vector<T, 3>,
    /// Noise, standard normal, held between samples.
    pub xi: Vector<T, NOISE_CHANNELS>,
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
/// Drift, with the noise that is held between samples.
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
        rate.drift + diffuse(&rate.diffusion, &self.plant.xi)
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
        diffusion[(3, 0)] * noise[0] + diffusion[(3, 1)] * noise[1]
            + diffusion[(3, 2)] * noise[2],
        diffusion[(4, 0)] * noise[0] + diffusion[(4, 1)] * noise[1]
            + diffusion[(4, 2)] * noise[2],
        diffusion[(5, 0)] * noise[0] + diffusion[(5, 1)] * noise[1]
            + diffusion[(5, 2)] * noise[2],
        diffusion[(6, 3)] * noise[3],
        diffusion[(7, 4)] * noise[4],
        diffusion[(8, 5)] * noise[5],
        diffusion[(9, 6)] * noise[6],
        diffusion[(10, 7)] * noise[7],
        diffusion[(11, 8)] * noise[8],
    ])
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `lift`.
    pub lift_1: T,
    /// Part of `side`.
    pub side_1: T,
    /// Part of `roll`.
    pub roll_1: T,
    /// Part of `pitch`.
    pub pitch_1: T,
    /// Part of `yaw`.
    pub yaw_1: T,
    /// Part of `pitch_delta`.
    pub pitch_delta_1: T,
    /// Part of `yaw_delta`.
    pub yaw_delta_1: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 7 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;
    let lift_1 = real(97170193.3485195) * params.CL_scale;
    let side_1 = real(97170193.3485195) * params.CY_scale;
    let roll_1 = real(1777048495.9577248) * params.Cl_scale;
    let pitch_1 = real(2369397994.6102996) * params.Cm_scale;
    let yaw_1 = real(1777048495.9577248) * params.Cn_scale;
    let pitch_delta_1 = real(24.384) * params.Cm_scale;
    let yaw_delta_1 = real(18.288) * params.Cn_scale;
    Prepared {
        lift_1,
        side_1,
        roll_1,
        pitch_1,
        yaw_1,
        pitch_delta_1,
        yaw_delta_1,
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
/// Operations: 0 additions, 6 multiplications, 0 divisions, 0 square roots, 3 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 1 (attitude) (11) --
    let t1 = real(2.0) * t;
    let [sin_t, sin_t1] = Vector([t, t1]).sin().0;
    let t2 = (real(-0.1) * t).exp();
    let t3 = real(0.02) * sin_t1 * t2;
    // d_1(t)
    let d1 = Vector([t3, real(0.02) * sin_t * t2, t3]);
    Clock { d1 }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 12>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 12, 9>,
    /// `d_1(t)`
    pub d1: Vector<T, 3>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 3>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 131 additions, 183 multiplications, 2 divisions, 0 square roots, 9 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 12>,
    u_sat: Vector<T, 3>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let alpha = x[0];
    let beta = x[1];
    let mu = x[2];
    let alpha_deg = alpha * real(57.29577951308232);
    let at_alpha_deg_2 = polynomials::at_alpha_deg_2(alpha_deg);
    let lift = prepared.lift_1
        * (at_alpha_deg_2.CL_alpha + at_alpha_deg_2.CL_LE + at_alpha_deg_2.CL_RE);
    let side = prepared.side_1
        * (at_alpha_deg_2.CY_beta * beta + at_alpha_deg_2.CY_LE + at_alpha_deg_2.CY_RE
            + at_alpha_deg_2.CY_RUD);
    let p = x[3];
    let q = x[4];
    let r = x[5];
    let t1 = at_alpha_deg_2.Cl_beta * beta + at_alpha_deg_2.Cl_LE + at_alpha_deg_2.Cl_RE
        + at_alpha_deg_2.Cl_RUD
        + at_alpha_deg_2.Cl_p * p * real(18.288) * real(0.00016666666666666666);
    let roll = prepared.roll_1
        * (t1 + at_alpha_deg_2.Cl_r * r * real(18.288) * real(0.00016666666666666666));
    let pitch = prepared.pitch_1
        * (at_alpha_deg_2.Cm_alpha + at_alpha_deg_2.Cm_LE + at_alpha_deg_2.Cm_RE
            + at_alpha_deg_2.Cm_RUD
            + at_alpha_deg_2.Cm_q * q * real(24.384) * real(0.00016666666666666666));
    let t2 = at_alpha_deg_2.Cn_beta * beta + at_alpha_deg_2.Cn_LE + at_alpha_deg_2.Cn_RE
        + at_alpha_deg_2.Cn_RUD
        + at_alpha_deg_2.Cn_p * p * real(18.288) * real(0.00016666666666666666);
    let yaw = prepared.yaw_1
        * (t2 + at_alpha_deg_2.Cn_r * r * real(18.288) * real(0.00016666666666666666));
    let dCl = Vector([
        at_alpha_deg_2.Cl_LE_d3,
        at_alpha_deg_2.Cl_RE_d3,
        at_alpha_deg_2.Cl_RUD_d3,
    ]);
    let roll_delta = dCl * prepared.roll_1;
    let dCm = Vector([at_alpha_deg_2.Cm_LE_d3, at_alpha_deg_2.Cm_RE_d3, real(0.0)]);
    let pitch_delta = dCm * prepared.pitch_delta_1 * real(97170193.3485195);
    let dCn = Vector([
        at_alpha_deg_2.Cn_LE_d3,
        at_alpha_deg_2.Cn_RE_d3,
        at_alpha_deg_2.Cn_RUD_d3,
    ]);
    let yaw_delta = dCn * prepared.yaw_delta_1 * real(97170193.3485195);

    // -- true dynamics of block 1 (attitude) (11) --
    let t3 = Vector([alpha, beta, mu]);
    let [sin_alpha, _, sin_mu] = t3.sin().0;
    let [cos_alpha, cos_beta, cos_mu] = t3.cos().0;
    let t4 = real(1332506.5352200002) * cos_mu;
    let [_, tan_beta, _] = t3.tan().0;
    // F_1 with the plant's parameters
    let F1_plant = Vector([
        (t4 - lift) / (real(410460000.0) * cos_beta),
        (side + real(1332506.5352200002) * sin_mu) * real(2.4362909905959168e-9),
        (lift * tan_beta - t4 * tan_beta) * real(2.4362909905959168e-9),
    ]);
    let t5 = -tan_beta;
    let t6 = real(1.0) / cos_beta;
    // G_1 with the plant's parameters
    let G1_plant = Matrix::rows([
        [t5 * cos_alpha, real(1.0), t5 * sin_alpha],
        [sin_alpha, real(0.0), -cos_alpha],
        [cos_alpha * t6, real(0.0), sin_alpha * t6],
    ]);

    // -- given --
    let x2 = Vector([p, q, r]);

    // -- true dynamics of block 1 (attitude) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + G1_plant * x2 + clock.d1;

    // -- true dynamics of block 2 (rates) (11) --
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        roll * real(7.375621211696555e-7),
        (real(12202362.0) * p * r + pitch) * real(7.375621211696555e-8),
        (real(-12202362.0) * p * q + yaw) * real(7.375621211696555e-8),
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([real(2.0) * x[7], real(3.0) * x[8], x[10] + x[11]]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant
        + Vector::<
            T,
            3,
        >::from_f64([7.375621211696555e-7, 7.375621211696555e-8, 7.375621211696555e-8])
            .hadamard(u_sat) + d2;
    let t7 = Matrix::rows([
        [
            roll_delta[0] * real(7.375621211696555e-7),
            roll_delta[1] * real(7.375621211696555e-7),
            roll_delta[2] * real(7.375621211696555e-7),
        ],
        [
            pitch_delta[0] * real(7.375621211696555e-8),
            pitch_delta[1] * real(7.375621211696555e-8),
            pitch_delta[2] * real(7.375621211696555e-8),
        ],
        [
            yaw_delta[0] * real(7.375621211696555e-8),
            yaw_delta[1] * real(7.375621211696555e-8),
            yaw_delta[2] * real(7.375621211696555e-8),
        ],
    ]);
    // H_2 Sigma_2
    let HSigma2 = t7 * real(0.05);

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x1_flow[0],
        x1_flow[1],
        x1_flow[2],
        x2_flow[0],
        x2_flow[1],
        x2_flow[2],
        real(3.0) * x[7],
        real(-3.0) * x[6],
        real(3.0) * x[9],
        real(-3.0) * x[8],
        real(3.0) * x[11],
        real(-3.0) * x[10],
    ]);
    // columns: one per Wiener process
    let diffusion = {
        let mut sparse = Matrix::<T, 12, 9>::zero();
        sparse[(3, 0)] = HSigma2[(0, 0)];
        sparse[(3, 1)] = HSigma2[(0, 1)];
        sparse[(3, 2)] = HSigma2[(0, 2)];
        sparse[(4, 0)] = HSigma2[(1, 0)];
        sparse[(4, 1)] = HSigma2[(1, 1)];
        sparse[(4, 2)] = HSigma2[(1, 2)];
        sparse[(5, 0)] = HSigma2[(2, 0)];
        sparse[(5, 1)] = HSigma2[(2, 1)];
        sparse[(5, 2)] = HSigma2[(2, 2)];
        sparse[(6, 3)] = real(1.0);
        sparse[(7, 4)] = real(1.0);
        sparse[(8, 5)] = real(1.0);
        sparse[(9, 6)] = real(1.0);
        sparse[(10, 7)] = real(1.0);
        sparse[(11, 8)] = real(1.0);
        sparse
    };
    PlantOutputs {
        drift,
        diffusion,
        d1: clock.d1,
        d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 131 additions, 196 multiplications, 2 divisions, 0 square roots, 12 elementary
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
    dynamics(x, u_sat, &prepared, &clock)
}
