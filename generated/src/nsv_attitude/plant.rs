// SHA-256 of the text below: 9c081a9820807b128571408c3caded5c84c7c250bcd186b2d498bab34180d635
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 05232bb1e4d2b87c7bb300548a857e3c96008a6f6467540428e4dc35d68eaef0
// plant: 227 additions, 287 multiplications, 23 divisions, 0 square roots, 10 elementary functions, 0 comparisons and selections

//! `nsv_attitude`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
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
    /// Control, held between samples.
    pub u_sat: Vector<T, 3>,
    /// Noise, standard normal, held between samples.
    pub xi: Vector<T, NOISE_CHANNELS>,
}

impl<T: Real> Sde<T, STATES, 0> for Plant<T> {
    #[inline(always)]
    fn drift(&self, t: T, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, t, x })
    }

    #[inline(always)]
    fn diffusion(&self, _t: T, _x: &Vector<T, STATES>) -> Matrix<T, STATES, 0> {
        Matrix::zero()
    }
}
/// Drift, with the noise that is held between samples.
struct Drift<'a, T> {
    plant: &'a Plant<T>,
    t: T,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Drift<'_, T> {
    type Output = Vector<T, STATES>;
    #[inline(always)]
    fn run(self) -> Vector<T, STATES> {
        let rate = plant(self.t, *self.x, self.plant.u_sat, &self.plant.params);
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
/// Operations: 227 additions, 287 multiplications, 23 divisions, 0 square roots, 10 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 12>,
    u_sat: Vector<T, 3>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- disturbance observer of block 2 (20) (49) --
    // L_2
    let L2: Matrix<T, 3, 6> = Matrix::from_f64([
        [0.0, 2.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 3.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 1.0, 1.0],
    ]);

    // -- plant model --
    let alpha = x[0];
    let beta = x[1];
    let mu = x[2];
    let alpha_deg = alpha / real(0.017453292519943295);
    let at_alpha_deg = polynomials::at_alpha_deg(alpha_deg);
    let lift = real(97170193.3485195) * params.CL_scale
        * (at_alpha_deg.CL_alpha + at_alpha_deg.CL_LE + at_alpha_deg.CL_RE);
    let side = real(97170193.3485195) * params.CY_scale
        * (at_alpha_deg.CY_beta * beta + at_alpha_deg.CY_LE + at_alpha_deg.CY_RE
            + at_alpha_deg.CY_RUD);
    let p = x[3];
    let q = x[4];
    let r = x[5];
    let t1 = real(1777048495.9577248) * params.Cl_scale;
    let t2 = at_alpha_deg.Cl_beta * beta + at_alpha_deg.Cl_LE + at_alpha_deg.Cl_RE
        + at_alpha_deg.Cl_RUD + at_alpha_deg.Cl_p * p * real(18.288) / real(6000.0);
    let roll = t1 * (t2 + at_alpha_deg.Cl_r * r * real(18.288) / real(6000.0));
    let t3 = at_alpha_deg.Cm_alpha + at_alpha_deg.Cm_LE + at_alpha_deg.Cm_RE
        + at_alpha_deg.Cm_RUD + at_alpha_deg.Cm_q * q * real(24.384) / real(6000.0);
    let pitch = real(2369397994.6102996) * params.Cm_scale * t3;
    let drag = real(97170193.3485195) * params.CD_scale
        * (at_alpha_deg.CD_alpha + at_alpha_deg.CD_LE + at_alpha_deg.CD_RE
            + at_alpha_deg.CD_RUD);
    let t4 = at_alpha_deg.Cn_beta * beta + at_alpha_deg.Cn_LE + at_alpha_deg.Cn_RE
        + at_alpha_deg.Cn_RUD + at_alpha_deg.Cn_p * p * real(18.288) / real(6000.0);
    let yaw = real(1777048495.9577248) * params.Cn_scale
        * (t4 + at_alpha_deg.Cn_r * r * real(18.288) / real(6000.0));
    let dCl = Vector([
        at_alpha_deg.Cl_LE_d3,
        at_alpha_deg.Cl_RE_d3,
        at_alpha_deg.Cl_RUD_d3,
    ]);
    let roll_delta = dCl * t1;
    let dCm = Vector([at_alpha_deg.Cm_LE_d3, at_alpha_deg.Cm_RE_d3, real(0.0)]);
    let dCD = Vector([
        at_alpha_deg.CD_LE_d3,
        at_alpha_deg.CD_RE_d3,
        at_alpha_deg.CD_RUD_d3,
    ]);
    let dCL = Vector([at_alpha_deg.CL_LE_d3, at_alpha_deg.CL_RE_d3, real(0.0)]);
    let t5 = alpha.sin();
    let t6 = alpha.cos();
    let t7 = (dCD * params.CD_scale * t5 + dCL * params.CL_scale * t6) * real(0.0);
    let pitch_delta = (dCm * (real(24.384) * params.Cm_scale) + t7)
        * real(97170193.3485195);
    let dCn = Vector([
        at_alpha_deg.Cn_LE_d3,
        at_alpha_deg.Cn_RE_d3,
        at_alpha_deg.Cn_RUD_d3,
    ]);
    let dCY = Vector([
        at_alpha_deg.CY_LE_d3,
        at_alpha_deg.CY_RE_d3,
        at_alpha_deg.CY_RUD_d3,
    ]);
    let yaw_delta = (dCn * (real(18.288) * params.Cn_scale)
        + dCY * (real(0.0) * params.CY_scale)) * real(97170193.3485195);

    // -- true dynamics of block 1 (attitude) (11) --
    let t8 = mu.cos();
    let t9 = real(1332506.5352200002) * t8;
    let t10 = beta.cos();
    let t11 = beta.sin();
    let t12 = mu.sin();
    let t13 = beta.tan();
    let t14 = t13 + real(0.0) * t12;
    let t15 = side * real(0.0);
    let t16 = real(0.0) * (t5 * t14 - t6 * t11 * real(0.0) * t8);
    // F_1 with the plant's parameters
    let F1_plant = Vector([
        (-lift - real(0.0) * t5 + t9) / (real(410460000.0) * t10),
        (side - real(0.0) * t6 * t11 + real(1332506.5352200002) * t12)
            / real(410460000.0),
        (lift * t14 + t15 * t8 - t9 * t13 + t16) / real(410460000.0),
    ]);
    let t17 = -t13;
    // G_1 with the plant's parameters
    let G1_plant = Matrix([
        [t17 * t6, real(1.0), t17 * t5],
        [t5, real(0.0), -t6],
        [t6 / t10, real(0.0), t5 / t10],
    ]);
    let t18 = (real(-0.1) * t).exp();
    let t19 = real(0.02) * (real(2.0) * t).sin() * t18;
    // d_1(t)
    let d1 = Vector([t19, real(0.02) * t.sin() * t18, t19]);

    // -- given --
    let x2 = Vector([p, q, r]);
    let w2 = Vector([x[6], x[7], x[8], x[9], x[10], x[11]]);

    // -- true dynamics of block 1 (attitude) (11) --
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + G1_plant * x2 + d1;

    // -- true dynamics of block 2 (rates) (11) --
    let t20 = real(12202362.0) * p * r + pitch + real(0.0) * (drag * t5 + lift * t6);
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        (real(0.0) * q * r + roll) / real(1355818.0),
        t20 / real(13558180.0),
        (real(-12202362.0) * p * q + yaw + t15) / real(13558180.0),
    ]);
    // G_2 with the plant's parameters
    let G2_plant: Matrix<T, 3, 3> = Matrix::from_f64([
        [7.375621211696555e-7, 0.0, 0.0],
        [0.0, 7.375621211696555e-8, 0.0],
        [0.0, 0.0, 7.375621211696555e-8],
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    let t21: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.0, 3.0, 0.0, 0.0, 0.0, 0.0],
        [-3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 3.0, 0.0, 0.0],
        [0.0, 0.0, -3.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 3.0],
        [0.0, 0.0, 0.0, 0.0, -3.0, 0.0],
    ]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = t21 * w2;
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;
    let t22 = Matrix([
        [
            roll_delta[0] / real(1355818.0),
            roll_delta[1] / real(1355818.0),
            roll_delta[2] / real(1355818.0),
        ],
        [
            pitch_delta[0] / real(13558180.0),
            pitch_delta[1] / real(13558180.0),
            pitch_delta[2] / real(13558180.0),
        ],
        [
            yaw_delta[0] / real(13558180.0),
            yaw_delta[1] / real(13558180.0),
            yaw_delta[2] / real(13558180.0),
        ],
    ]);
    // H_2 Sigma_2
    let HSigma2 = t22
        .hadamard(
            Matrix::<
                T,
                3,
                3,
            >::from_f64([[0.05, 0.05, 0.05], [0.05, 0.05, 0.05], [0.05, 0.05, 0.05]]),
        );

    // -- packed plant state: x_1 .. x_n, then the exosystems --
    // dx/dt without noise
    let drift = Vector([
        x1_flow[0],
        x1_flow[1],
        x1_flow[2],
        x2_flow[0],
        x2_flow[1],
        x2_flow[2],
        w2_flow[0],
        w2_flow[1],
        w2_flow[2],
        w2_flow[3],
        w2_flow[4],
        w2_flow[5],
    ]);
    // columns: one per Wiener process
    let diffusion = Matrix([
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            HSigma2[(0, 0)],
            HSigma2[(0, 1)],
            HSigma2[(0, 2)],
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            HSigma2[(1, 0)],
            HSigma2[(1, 1)],
            HSigma2[(1, 2)],
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            HSigma2[(2, 0)],
            HSigma2[(2, 1)],
            HSigma2[(2, 2)],
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(1.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(1.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(1.0),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(1.0),
            real(0.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(1.0),
            real(0.0),
        ],
        [
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(0.0),
            real(1.0),
        ],
    ]);
    PlantOutputs {
        drift,
        diffusion,
        d1,
        d2,
    }
}
