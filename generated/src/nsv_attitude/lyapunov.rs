// SHA-256 of the text below: ff8492cbfd16b4d7d89e6142e7ce182373dd116c080d647f3d3d4ab256801e66
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 1928 additions, 2399 multiplications, 18 divisions, 3 square roots, 30 elementary functions, 34 comparisons and selections

//! `nsv_attitude`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::polynomials;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use nsv_runtime::kernel;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};

/// Results of [`lyapunov`].
#[derive(Clone, Copy, Debug)]
pub struct LyapunovOutputs<T: Real> {
    /// `V, sum of the parts above`
    pub V: T,
    /// `LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j`
    pub LV: T,
}

/// The Lyapunov function V and its Ito generator LV (2) along the plant with parameters
/// `plant`, under the controller with parameters `params`.
///
/// Operations: 1928 additions, 2399 multiplications, 18 divisions, 3 square roots, 30
/// elementary functions, 34 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    w2: Vector<T, 6>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;
    let LyapunovValues1 {
        t1,
        at_alpha_deg_2,
        t2,
        lift,
        beta,
        sin_alpha,
        sin_beta,
        sin_x1_2,
        cos_alpha,
        cos_beta,
        cos_x1_2,
        t11,
        t12,
        t13,
        t3,
        t4,
        t14,
        tan_beta,
        t15,
        F1,
        t17,
        t18,
        t19,
        t20,
        t21,
        t22,
        G1,
        t7,
        t23,
        t8,
        t24,
        t10,
        F2,
        dCl,
        t25,
        t26,
        t27,
        dCm,
        t28,
        t29,
        t30,
        dCn,
        t31,
        t32,
        t33,
        H2,
        t34,
        sin_t,
        sin_t35,
        sin_t38,
        sin_t36,
        cos_t,
        cos_t36,
        t40,
        y_r_dot,
        exp_t42,
        k2,
        k1,
        k1_dot,
        k2_dot,
        e1,
        s1,
        t44,
        t45,
        t46,
        E1_free,
        E1,
        t47,
        t48,
        e2,
        s2,
        t49,
        E2_free,
        t50,
        cosE1,
        cosE2,
        t53,
        sec2E1,
        t51,
        sec2E2,
        t52,
        c2,
    } = T::outlined(LyapunovPart1 {
        t,
        x1,
        x2,
        state,
        params,
    });
    let LyapunovValues2 {
        sin_E2,
        sigma2_dot,
        phi2_dot,
        HSigma2,
        t98,
        t100,
        V,
        HSigma2_1,
        HSigma2_2,
        HSigma2_3,
        V_T1_flow,
        V_W1_flow,
        V_D1_flow,
        V_zeta1_flow,
        V_chi1_flow,
        t143,
        t144,
        V_T2_flow,
        V_W2_flow,
        V_D2_flow,
        V_zeta2_flow,
        V_eps2_flow,
    } = T::outlined(LyapunovPart2 {
        x1,
        x2,
        w2,
        state,
        plant,
        t1,
        at_alpha_deg_2,
        t2,
        lift,
        beta,
        sin_alpha,
        sin_beta,
        sin_x1_2,
        cos_alpha,
        cos_beta,
        cos_x1_2,
        t11,
        t12,
        t13,
        t3,
        t4,
        t14,
        tan_beta,
        t15,
        F1,
        t17,
        t18,
        t19,
        t20,
        t21,
        t22,
        G1,
        t7,
        t23,
        t8,
        t24,
        t10,
        F2,
        dCl,
        t25,
        t26,
        t27,
        dCm,
        t28,
        t29,
        t30,
        dCn,
        t31,
        t32,
        t33,
        H2,
        t34,
        sin_t,
        sin_t35,
        sin_t38,
        sin_t36,
        cos_t,
        cos_t36,
        t40,
        y_r_dot,
        exp_t42,
        k2,
        k1,
        k1_dot,
        k2_dot,
        e1,
        s1,
        t44,
        t45,
        t46,
        E1_free,
        E1,
        t47,
        t48,
        e2,
        s2,
        t49,
        E2_free,
        t50,
        cosE1,
        cosE2,
        t53,
        sec2E1,
        t51,
        sec2E2,
        t52,
        c2,
    });

    // -- Ito generator (2) --
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t100 - t100 * sigma2_dot) * real(0.5);
    let t150 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t150 + t150) * real(0.5);
    let t151 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t151 + t151;
    let t152 = s2_noise1_ * t48;
    // D^1 E2_free along noise1
    let E2_free_noise1_ = real(FRAC_PI_2) * (t143 * t152);
    // D^1 E2 along noise1
    let E2_noise1_ = T::select(t144, E2_free_noise1_, real(0.0));
    let t153 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t153 + t153;
    // D^2 E2_free along noise1
    let E2_free_noise1_2 = real(FRAC_PI_2)
        * (t152 * (t152 + t152) + t143 * (s2_noise1_2 * t48));
    // D^2 E2 along noise1
    let E2_noise1_2 = T::select(t144, E2_free_noise1_2, real(0.0));
    let t154 = cosE2 + cosE2;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = t98
        * (E2_noise1_2 * sec2E2
            + E2_noise1_ * sec2E2 * sec2E2 * (t154 * (sin_E2 * E2_noise1_)));
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = Vector([
        real(-1.5) * HSigma2[(0, 0)],
        real(1.5) * HSigma2[(0, 0)],
        real(1.5) * HSigma2[(1, 0)],
        HSigma2[(1, 0)],
        real(-2.0) * HSigma2[(2, 0)],
        real(4.0) * HSigma2[(2, 0)],
    ]);
    let t155 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t155 + t155) * real(0.5);
    let t156 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t156 + t156;
    let t157 = s2_noise2_ * t48;
    // D^1 E2_free along noise2
    let E2_free_noise2_ = real(FRAC_PI_2) * (t143 * t157);
    // D^1 E2 along noise2
    let E2_noise2_ = T::select(t144, E2_free_noise2_, real(0.0));
    let t158 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t158 + t158;
    // D^2 E2_free along noise2
    let E2_free_noise2_2 = real(FRAC_PI_2)
        * (t157 * (t157 + t157) + t143 * (s2_noise2_2 * t48));
    // D^2 E2 along noise2
    let E2_noise2_2 = T::select(t144, E2_free_noise2_2, real(0.0));
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = t98
        * (E2_noise2_2 * sec2E2
            + E2_noise2_ * sec2E2 * sec2E2 * (t154 * (sin_E2 * E2_noise2_)));
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = Vector([
        real(-1.5) * HSigma2[(0, 1)],
        real(1.5) * HSigma2[(0, 1)],
        real(1.5) * HSigma2[(1, 1)],
        HSigma2[(1, 1)],
        real(-2.0) * HSigma2[(2, 1)],
        real(4.0) * HSigma2[(2, 1)],
    ]);
    let t159 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t159 + t159) * real(0.5);
    let t160 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t160 + t160;
    let t161 = s2_noise3_ * t48;
    // D^1 E2_free along noise3
    let E2_free_noise3_ = real(FRAC_PI_2) * (t143 * t161);
    // D^1 E2 along noise3
    let E2_noise3_ = T::select(t144, E2_free_noise3_, real(0.0));
    let t162 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t162 + t162;
    // D^2 E2_free along noise3
    let E2_free_noise3_2 = real(FRAC_PI_2)
        * (t161 * (t161 + t161) + t143 * (s2_noise3_2 * t48));
    // D^2 E2 along noise3
    let E2_noise3_2 = T::select(t144, E2_free_noise3_2, real(0.0));
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = t98
        * (E2_noise3_2 * sec2E2
            + E2_noise3_ * sec2E2 * sec2E2 * (t154 * (sin_E2 * E2_noise3_)));
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = Vector([
        real(-1.5) * HSigma2[(0, 2)],
        real(1.5) * HSigma2[(0, 2)],
        real(1.5) * HSigma2[(1, 2)],
        HSigma2[(1, 2)],
        real(-2.0) * HSigma2[(2, 2)],
        real(4.0) * HSigma2[(2, 2)],
    ]);
    let t163 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t163 + t163) * real(0.5);
    let t164 = V_T1_flow + V_W1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow
        + V_W2_flow + V_D2_flow + V_zeta2_flow;
    let t165 = t164 + V_eps2_flow + V_sigma2_flow + V_phi2_flow
        + V_T2_noise1_2 * real(0.5) + V_D2_noise1_2 * real(0.5);
    let t166 = t165 + V_T2_noise2_2 * real(0.5) + V_D2_noise2_2 * real(0.5)
        + V_T2_noise3_2 * real(0.5) + V_D2_noise3_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t166 + real(0.5) + real(0.5) + real(0.5) + real(0.5) + real(0.5)
        + real(0.5);
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    state: &'a State<T>,
    params: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    t1: T,
    at_alpha_deg_2: polynomials::AtAlphaDeg22<T>,
    t2: T,
    lift: T,
    beta: T,
    sin_alpha: T,
    sin_beta: T,
    sin_x1_2: T,
    cos_alpha: T,
    cos_beta: T,
    cos_x1_2: T,
    t11: T,
    t12: T,
    t13: T,
    t3: T,
    t4: T,
    t14: T,
    tan_beta: T,
    t15: T,
    F1: Vector<T, 3>,
    t17: T,
    t18: T,
    t19: T,
    t20: T,
    t21: T,
    t22: T,
    G1: Matrix<T, 3, 3>,
    t7: T,
    t23: T,
    t8: T,
    t24: T,
    t10: T,
    F2: Vector<T, 3>,
    dCl: Vector<T, 3>,
    t25: T,
    t26: T,
    t27: T,
    dCm: Vector<T, 3>,
    t28: T,
    t29: T,
    t30: T,
    dCn: Vector<T, 3>,
    t31: T,
    t32: T,
    t33: T,
    H2: Matrix<T, 3, 3>,
    t34: T::Mask,
    sin_t: T,
    sin_t35: T,
    sin_t38: T,
    sin_t36: T,
    cos_t: T,
    cos_t36: T,
    t40: T,
    y_r_dot: Vector<T, 3>,
    exp_t42: T,
    k2: T,
    k1: T,
    k1_dot: T,
    k2_dot: T,
    e1: Vector<T, 3>,
    s1: T,
    t44: T,
    t45: T,
    t46: T,
    E1_free: T,
    E1: T,
    t47: T,
    t48: T,
    e2: Vector<T, 3>,
    s2: T,
    t49: T,
    E2_free: T,
    t50: Vector<T, 2>,
    cosE1: T,
    cosE2: T,
    t53: T,
    sec2E1: T,
    t51: T,
    sec2E2: T,
    t52: T,
    c2: Vector<T, 3>,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, state, params } = self;
        let real = T::from_f64;

        // -- plant model --
        let alpha = x1[0];
        let alpha_deg = alpha * real(57.29577951308232);
        let t1 = real(97170193.3485195) * params.CL_scale;
        let at_alpha_deg_2 = polynomials::at_alpha_deg_2_2(alpha_deg);
        let t2 = at_alpha_deg_2.CL_alpha + at_alpha_deg_2.CL_LE + at_alpha_deg_2.CL_RE;
        let lift = t1 * t2;
        let beta = x1[1];
        let t3 = real(97170193.3485195) * params.CY_scale;
        let t4 = at_alpha_deg_2.CY_beta * beta + at_alpha_deg_2.CY_LE
            + at_alpha_deg_2.CY_RE + at_alpha_deg_2.CY_RUD;
        let side = t3 * t4;
        let q = x2[1];
        let r = x2[2];
        let p = x2[0];
        let t5 = real(1777048495.9577248) * params.Cl_scale;
        let t6 = at_alpha_deg_2.Cl_beta * beta + at_alpha_deg_2.Cl_LE
            + at_alpha_deg_2.Cl_RE + at_alpha_deg_2.Cl_RUD
            + at_alpha_deg_2.Cl_p * p * real(18.288) * real(0.00016666666666666666);
        let t7 = t6
            + at_alpha_deg_2.Cl_r * r * real(18.288) * real(0.00016666666666666666);
        let roll = t5 * t7;
        let t8 = at_alpha_deg_2.Cm_alpha + at_alpha_deg_2.Cm_LE + at_alpha_deg_2.Cm_RE
            + at_alpha_deg_2.Cm_RUD
            + at_alpha_deg_2.Cm_q * q * real(24.384) * real(0.00016666666666666666);
        let pitch = real(2369397994.6102996) * params.Cm_scale * t8;
        let t9 = at_alpha_deg_2.Cn_beta * beta + at_alpha_deg_2.Cn_LE
            + at_alpha_deg_2.Cn_RE + at_alpha_deg_2.Cn_RUD
            + at_alpha_deg_2.Cn_p * p * real(18.288) * real(0.00016666666666666666);
        let t10 = t9
            + at_alpha_deg_2.Cn_r * r * real(18.288) * real(0.00016666666666666666);
        let yaw = real(1777048495.9577248) * params.Cn_scale * t10;
        let dCl = Vector([
            at_alpha_deg_2.Cl_LE_d3,
            at_alpha_deg_2.Cl_RE_d3,
            at_alpha_deg_2.Cl_RUD_d3,
        ]);
        let roll_delta = dCl * t5;
        let dCm = Vector([at_alpha_deg_2.Cm_LE_d3, at_alpha_deg_2.Cm_RE_d3, real(0.0)]);
        let pitch_delta = dCm * (real(24.384) * params.Cm_scale)
            * real(97170193.3485195);
        let dCn = Vector([
            at_alpha_deg_2.Cn_LE_d3,
            at_alpha_deg_2.Cn_RE_d3,
            at_alpha_deg_2.Cn_RUD_d3,
        ]);
        let yaw_delta = dCn * (real(18.288) * params.Cn_scale) * real(97170193.3485195);

        // -- known dynamics of block 1 (attitude) (11) --
        let [sin_alpha, sin_beta, sin_x1_2] = x1.sin().0;
        let [cos_alpha, cos_beta, cos_x1_2] = x1.cos().0;
        let t11 = real(1332506.5352200002) * cos_x1_2;
        let t12 = t11 - lift;
        let t13 = real(410460000.0) * cos_beta;
        let t14 = real(1332506.5352200002) * sin_x1_2;
        let [_, tan_beta, _] = x1.tan().0;
        let t15 = t11 * tan_beta;
        // F_1(x_1 .. x_1)
        let F1 = Vector([
            t12 / t13,
            (side + t14) * real(2.4362909905959168e-9),
            (lift * tan_beta - t15) * real(2.4362909905959168e-9),
        ]);
        let t16 = -tan_beta;
        let t17 = t16 * cos_alpha;
        let t18 = t16 * sin_alpha;
        let t19 = -cos_alpha;
        let t20 = real(1.0) / cos_beta;
        let t21 = cos_alpha * t20;
        let t22 = sin_alpha * t20;
        // G_1(x_1 .. x_1)
        let G1 = Matrix::rows([
            [t17, real(1.0), t18],
            [sin_alpha, real(0.0), t19],
            [t21, real(0.0), t22],
        ]);

        // -- known dynamics of block 2 (rates) (11) --
        let t23 = real(12202362.0) * p * r;
        let t24 = real(-12202362.0) * p * q;
        // F_2(x_1 .. x_2)
        let F2 = Vector([
            roll * real(7.375621211696555e-7),
            (t23 + pitch) * real(7.375621211696555e-8),
            (t24 + yaw) * real(7.375621211696555e-8),
        ]);
        let t25 = roll_delta[0] * real(7.375621211696555e-7);
        let t26 = roll_delta[1] * real(7.375621211696555e-7);
        let t27 = roll_delta[2] * real(7.375621211696555e-7);
        let t28 = pitch_delta[0] * real(7.375621211696555e-8);
        let t29 = pitch_delta[1] * real(7.375621211696555e-8);
        let t30 = pitch_delta[2] * real(7.375621211696555e-8);
        let t31 = yaw_delta[0] * real(7.375621211696555e-8);
        let t32 = yaw_delta[1] * real(7.375621211696555e-8);
        let t33 = yaw_delta[2] * real(7.375621211696555e-8);
        // H_2(x_1 .. x_2)
        let H2 = Matrix::rows([[t25, t26, t27], [t28, t29, t30], [t31, t32, t33]]);

        // -- reference and constraints --
        let t34 = t.le(real(4.0));
        let t35 = real(FRAC_PI_4) * t - real(FRAC_PI_2);
        let t36 = real(2.0) * t;
        let t37 = real(0.5) * t;
        let t38 = real(0.9424777960769379) * t;
        let t39 = Vector([t, t35, t38, t37, t36]);
        let [sin_t, sin_t35, sin_t38, sin_t37, sin_t36] = t39.sin().0;
        let [cos_t, cos_t35, cos_t38, cos_t37, cos_t36] = t39.cos().0;
        let t40 = real(0.5) * cos_t37;
        // y_r(t)
        let y_r = Vector([
            T::select(
                t34,
                (real(2.5) * sin_t35 + real(1.5)) * real(0.017453292519943295),
                real(0.06981317007977318),
            ),
            real(0.5) * sin_t38 * real(0.017453292519943295),
            (real(-2.0) * sin_t + t40) * real(0.017453292519943295),
        ]);
        // y_r'
        let y_r_dot = Vector([
            T::select(
                t34,
                real(0.017453292519943295) * (real(2.5) * (cos_t35 * real(FRAC_PI_4))),
                real(0.0),
            ),
            real(0.017453292519943295)
                * (real(0.5) * (cos_t38 * real(0.9424777960769379))),
            real(0.017453292519943295)
                * (real(-2.0) * cos_t - real(0.5) * (sin_t37 * real(0.5))),
        ]);
        let t41 = -t;
        let t42 = real(-0.1) * t;
        let [exp_t41, exp_t42] = Vector([t41, t42]).exp().0;
        let t43 = real(3.0) * exp_t41;
        // k_2(t)
        let k2 = t43 + real(0.5);
        // k_1(t)
        let k1 = k2 * real(0.017453292519943295);
        // k1'
        let k1_dot = -(real(0.017453292519943295) * t43);
        // k2'
        let k2_dot = -t43;

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t44 = k1 * k1;
        let t45 = real(1.0) / t44;
        let t46 = s1 * t45;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t46 * t46);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));

        // -- error variable of block 2 (14) --
        // e_2 = x_2 - h_1 - zeta_2
        let e2 = x2 - state.h1 - state.zeta2;

        // -- barrier of block 2 (23) (26) --
        // s_2 = e_2^T e_2
        let s2 = e2.sum_squares();
        let t47 = k2 * k2;
        let t48 = real(1.0) / t47;
        let t49 = s2 * t48;
        // pi s_2^2 / (2 k_2^4), before the clamp
        let E2_free = real(FRAC_PI_2) * (t49 * t49);
        // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
        let E2 = E2_free.min(real(1.5697963267948967));
        let t50 = Vector([E1, E2]);
        let [cos_E1, cos_E2] = t50.cos().0;
        // cos E_2
        let cosE2 = cos_E2;
        let t51 = cosE2 * cosE2;
        // 1 / cos^2 E_2
        let sec2E2 = real(1.0) / t51;
        let t52 = s2 * sec2E2;
        // c_2 = s_2 e_2^T / cos^2 E_2
        let c2 = e2 * t52;

        // -- barrier of block 1 (23) (26) --
        // cos E_1
        let cosE1 = cos_E1;
        let t53 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t53;
        LyapunovValues1 {
            t1,
            at_alpha_deg_2,
            t2,
            lift,
            beta,
            sin_alpha,
            sin_beta,
            sin_x1_2,
            cos_alpha,
            cos_beta,
            cos_x1_2,
            t11,
            t12,
            t13,
            t3,
            t4,
            t14,
            tan_beta,
            t15,
            F1,
            t17,
            t18,
            t19,
            t20,
            t21,
            t22,
            G1,
            t7,
            t23,
            t8,
            t24,
            t10,
            F2,
            dCl,
            t25,
            t26,
            t27,
            dCm,
            t28,
            t29,
            t30,
            dCn,
            t31,
            t32,
            t33,
            H2,
            t34,
            sin_t,
            sin_t35,
            sin_t38,
            sin_t36,
            cos_t,
            cos_t36,
            t40,
            y_r_dot,
            exp_t42,
            k2,
            k1,
            k1_dot,
            k2_dot,
            e1,
            s1,
            t44,
            t45,
            t46,
            E1_free,
            E1,
            t47,
            t48,
            e2,
            s2,
            t49,
            E2_free,
            t50,
            cosE1,
            cosE2,
            t53,
            sec2E1,
            t51,
            sec2E2,
            t52,
            c2,
        }
    }
}

/// Part 2 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart2<'a, T: Real> {
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    w2: Vector<T, 6>,
    state: &'a State<T>,
    plant: &'a Params<T>,
    t1: T,
    at_alpha_deg_2: polynomials::AtAlphaDeg22<T>,
    t2: T,
    lift: T,
    beta: T,
    sin_alpha: T,
    sin_beta: T,
    sin_x1_2: T,
    cos_alpha: T,
    cos_beta: T,
    cos_x1_2: T,
    t11: T,
    t12: T,
    t13: T,
    t3: T,
    t4: T,
    t14: T,
    tan_beta: T,
    t15: T,
    F1: Vector<T, 3>,
    t17: T,
    t18: T,
    t19: T,
    t20: T,
    t21: T,
    t22: T,
    G1: Matrix<T, 3, 3>,
    t7: T,
    t23: T,
    t8: T,
    t24: T,
    t10: T,
    F2: Vector<T, 3>,
    dCl: Vector<T, 3>,
    t25: T,
    t26: T,
    t27: T,
    dCm: Vector<T, 3>,
    t28: T,
    t29: T,
    t30: T,
    dCn: Vector<T, 3>,
    t31: T,
    t32: T,
    t33: T,
    H2: Matrix<T, 3, 3>,
    t34: T::Mask,
    sin_t: T,
    sin_t35: T,
    sin_t38: T,
    sin_t36: T,
    cos_t: T,
    cos_t36: T,
    t40: T,
    y_r_dot: Vector<T, 3>,
    exp_t42: T,
    k2: T,
    k1: T,
    k1_dot: T,
    k2_dot: T,
    e1: Vector<T, 3>,
    s1: T,
    t44: T,
    t45: T,
    t46: T,
    E1_free: T,
    E1: T,
    t47: T,
    t48: T,
    e2: Vector<T, 3>,
    s2: T,
    t49: T,
    E2_free: T,
    t50: Vector<T, 2>,
    cosE1: T,
    cosE2: T,
    t53: T,
    sec2E1: T,
    t51: T,
    sec2E2: T,
    t52: T,
    c2: Vector<T, 3>,
}

/// What is used of the values of [`LyapunovPart2`].
struct LyapunovValues2<T: Real> {
    sin_E2: T,
    sigma2_dot: T,
    phi2_dot: T,
    HSigma2: Matrix<T, 3, 3>,
    t98: T,
    t100: T,
    V: T,
    HSigma2_1: Vector<T, 3>,
    HSigma2_2: Vector<T, 3>,
    HSigma2_3: Vector<T, 3>,
    V_T1_flow: T,
    V_W1_flow: T,
    V_D1_flow: T,
    V_zeta1_flow: T,
    V_chi1_flow: T,
    t143: T,
    t144: T::Mask,
    V_T2_flow: T,
    V_W2_flow: T,
    V_D2_flow: T,
    V_zeta2_flow: T,
    V_eps2_flow: T,
}

impl<T: Real> Part for LyapunovPart2<'_, T> {
    type Output = LyapunovValues2<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self {
            x1,
            x2,
            w2,
            state,
            plant,
            t1,
            at_alpha_deg_2,
            t2,
            lift,
            beta,
            sin_alpha,
            sin_beta,
            sin_x1_2,
            cos_alpha,
            cos_beta,
            cos_x1_2,
            t11,
            t12,
            t13,
            t3,
            t4,
            t14,
            tan_beta,
            t15,
            F1,
            t17,
            t18,
            t19,
            t20,
            t21,
            t22,
            G1,
            t7,
            t23,
            t8,
            t24,
            t10,
            F2,
            dCl,
            t25,
            t26,
            t27,
            dCm,
            t28,
            t29,
            t30,
            dCn,
            t31,
            t32,
            t33,
            H2,
            t34,
            sin_t,
            sin_t35,
            sin_t38,
            sin_t36,
            cos_t,
            cos_t36,
            t40,
            y_r_dot,
            exp_t42,
            k2,
            k1,
            k1_dot,
            k2_dot,
            e1,
            s1,
            t44,
            t45,
            t46,
            E1_free,
            E1,
            t47,
            t48,
            e2,
            s2,
            t49,
            E2_free,
            t50,
            cosE1,
            cosE2,
            t53,
            sec2E1,
            t51,
            sec2E2,
            t52,
            c2,
        } = self;
        let real = T::from_f64;

        // -- barrier of block 1 (23) (26) --
        let t54 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t54;

        // -- MTPN of block 1 (4) (16) --
        // P_1 = P_m(z_1), 19 nodes
        let P1 = polynomials::basis1(x1);
        let t55 = state.W1.transpose();
        // A_hat_1 = iota_1 W_1^T P_1
        let A_hat1 = t55 * P1 * real(0.1);

        // -- disturbance observer of block 1 (20) --
        // D_hat_1 = th_1 + S_1 x_1
        let D_hat1 = state.th1 + x1 * real(10.0);

        // -- norms of block 1 --
        // ||G_1||^2
        let G_norm2_1 = G1.sum_squares();

        // -- robust feedback of block 1 (31) --
        let [sin_E1, sin_E2] = t50.sin().0;
        let t56 = sin_E1 * cosE1;
        let t57 = real(1.0) / E1_free;
        let t58 = real(0.5) * G_norm2_1;
        let t59 = real(2.375) * T::select(E1_free.lt(real(1e-300)), real(1.0), t56 * t57)
            + real(2.0) + t54 * real(0.5);
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1 * (t59 + t54 * t58);
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t60 = F1 + A_hat1;
        let t61 = state.zeta1 * real(20.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t60 - y_r_dot + t61 + D_hat1 + Lam1;
        let t62 = Matrix::rows([[sin_alpha, t19], [t21, t22]]);
        let t63 = t62.solve(Vector([bracket1[1], bracket1[2]]));
        let t64 = bracket1[0] - t17 * t63[0] - t18 * t63[1];
        let t65 = Vector([t63[0], t64, t63[1]]);
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -t65;

        // -- auxiliary system of block 1 (13), erratum 1 --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = G1 * state.zeta2 - t61;

        // -- weight law of block 1 (32) (65) --
        // W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)
        let W1_dot = P1.outer(c1 * real(0.1)) - state.W1 * real(0.1);

        // -- dynamic surface filter of block 1 (33) --
        // h_1' = (alpha_1 - h_1) / Fl_1
        let h1_dot = (alpha1 - state.h1) * real(10.0);

        // -- MTPN of block 2 (4) (16) --
        // P_2 = P_m(z_2), 19 nodes
        let P2 = polynomials::basis2(x2);
        let t66 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t66 * P2 * real(0.1);

        // -- disturbance observer of block 2 (49) --
        let t67 = Vector([
            real(-1.5) * e2[0],
            real(1.5) * e2[0],
            real(1.5) * e2[1],
            e2[1],
            real(-2.0) * e2[2],
            real(4.0) * e2[2],
        ]);
        // w_hat_2 = th_2 + S_2 e_2
        let w_hat2 = state.th2 + t67;
        // D_hat_2 = L_2 w_hat_2
        let D_hat2 = Vector([
            real(2.0) * w_hat2[1],
            real(3.0) * w_hat2[2],
            w_hat2[4] + w_hat2[5],
        ]);

        // -- noise terms of block 2 (58) (62) --
        // ||H_2||^2
        let H_norm2_2 = H2.sum_squares();
        let t68 = real(3.0) * sec2E2;
        let t69 = real(8.0) * E2_free * sin_E2 * (cosE2 * (sec2E2 * sec2E2)) + t68;
        // ||Ybar_2||^2
        let Ybar_square2 = t69 * t69 + real(2.0) * (t68 * t68);
        // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I
        // (58)
        let Ybar_norm2 = Ybar_square2.sqrt();
        // S_2 H_2
        let SH2 = Matrix::rows([
            [real(-1.5) * t25, real(-1.5) * t26, real(-1.5) * t27],
            [real(1.5) * t25, real(1.5) * t26, real(1.5) * t27],
            [real(1.5) * t28, real(1.5) * t29, real(1.5) * t30],
            [t28, t29, t30],
            [real(-2.0) * t31, real(-2.0) * t32, real(-2.0) * t33],
            [real(4.0) * t31, real(4.0) * t32, real(4.0) * t33],
        ]);
        // ||S_2 H_2||^2
        let SH_norm2_2 = SH2.sum_squares();
        // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4
        // (62)
        let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(12.0)
            + real(0.1) * (SH_norm2_2 * SH_norm2_2);

        // -- robust feedback of block 2 (63) --
        let t70 = (e2 * real(0.5)).tanh();
        // eps_hat Tanh(e / b) (64)
        let Lam2_error_bound = t70 * state.eps2;
        let t71 = s2 * s2;
        // 1 / sqrt(s_2^2 + varsigma_2^2)
        let s_scale2 = real(1.0) / (t71 + real(1.0)).sqrt();
        let t72 = real(2.5)
            * T::select(
                E2_free.lt(real(1e-300)),
                real(1.0),
                sin_E2 * cosE2 * (real(1.0) / E2_free),
            ) + real(2.0);
        let t73 = G_norm2_1 * s_c1;
        let t74 = H_norm2_2 * Ybar_norm2;
        let t75 = state.phi2 * state.phi2;
        let t76 = Psi2 / (t75 + t71);
        let t77 = t72 + t52 * real(75.0) + real(0.5) * sec2E2
            + t73 * t73 * real(0.25) * t51;
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat
        // Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
        // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 +
        // e Psi cos^2 E / (phi^2 + s^2) (64)
        let Lam2 = e2 * (t77 + t74 * state.sigma2 * s_scale2 + t76 * t51)
            + Lam2_error_bound;

        // -- control (64) of block 2 --
        let t78 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = F2 + A_hat2 - h1_dot + t78 + D_hat2 + Lam2;
        let t79 = bracket2
            .hadamard(Vector::<T, 3>::from_f64([1355818.0, 13558180.0, 13558180.0]));
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t79;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 3>::from_f64([-2000000.0, -20000000.0, -20000000.0]))
            .min(Vector::<T, 3>::from_f64([2000000.0, 20000000.0, 20000000.0]));

        // -- auxiliary system of block 2 (13), erratum 1 --
        let t80: Vector<T, 3> = Vector::from_f64([
            7.375621211696555e-7,
            7.375621211696555e-8,
            7.375621211696555e-8,
        ]);
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = t80.hadamard(u_sat + t79) - t78;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2 * real(0.1)) - state.W2 * real(0.1);

        // -- observer dynamics of block 2 (50) --
        let t81 = Vector([
            real(3.0) * w_hat2[1],
            real(-3.0) * w_hat2[0],
            real(3.0) * w_hat2[3],
            real(-3.0) * w_hat2[2],
            real(3.0) * w_hat2[5],
            real(-3.0) * w_hat2[4],
        ]);
        let t82 = Vector([
            real(-1.5) * Lam2[0],
            real(1.5) * Lam2[0],
            real(1.5) * Lam2[1],
            Lam2[1],
            real(-2.0) * Lam2[2],
            real(4.0) * Lam2[2],
        ]);
        // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
        // M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
        let th2_dot = t81 + t82;

        // -- network error bound of block 2 (66) --
        // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
        let eps2_dot = real(0.1) * (t52 * e2.dot(t70) - state.eps2);

        // -- noise bound of block 2 (67) --
        // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
        // varsigma_2^2)) - lambda_sigma sigma_hat_2)
        let sigma2_dot = t74 * t71 * sec2E2 * s_scale2 - real(0.1) * state.sigma2;

        // -- compensation of block 2 (68) --
        // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
        let phi2_decay = t76 + real(2.0);
        // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
        let phi2_dot = T::select(
            s2.sqrt().ge(real(0.01)),
            -state.phi2 * phi2_decay,
            real(0.0),
        );

        // -- true dynamics of block 1 (attitude) (11) --
        let t83 = real(97170193.3485195) * plant.CL_scale;
        let t84 = t83 * t2;
        let t85 = t11 - t84;
        let t86 = real(97170193.3485195) * plant.CY_scale;
        // F_1 with the plant's parameters
        let F1_plant = Vector([
            t85 / t13,
            (t86 * t4 + t14) * real(2.4362909905959168e-9),
            (t84 * tan_beta - t15) * real(2.4362909905959168e-9),
        ]);
        let t87 = real(0.02) * sin_t36;
        let t88 = t87 * exp_t42;
        let t89 = real(0.02) * sin_t;
        // d_1(t)
        let d1 = Vector([t88, t89 * exp_t42, t88]);
        let t90 = G1 * x2;
        // F_1 + G_1 x_2 + d_1
        let x1_flow = F1_plant + t90 + d1;

        // -- true dynamics of block 2 (rates) (11) --
        let t91 = real(1777048495.9577248) * plant.Cl_scale;
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            t91 * t7 * real(7.375621211696555e-7),
            (t23 + real(2369397994.6102996) * plant.Cm_scale * t8)
                * real(7.375621211696555e-8),
            (t24 + real(1777048495.9577248) * plant.Cn_scale * t10)
                * real(7.375621211696555e-8),
        ]);
        // d_2 = L_2 w_2 (12)
        let d2 = Vector([real(2.0) * w2[1], real(3.0) * w2[2], w2[4] + w2[5]]);
        // w_2' = M_2 w_2 (12)
        let w2_flow = Vector([
            real(3.0) * w2[1],
            real(-3.0) * w2[0],
            real(3.0) * w2[3],
            real(-3.0) * w2[2],
            real(3.0) * w2[5],
            real(-3.0) * w2[4],
        ]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = F2_plant + t80.hadamard(u_sat) + d2;
        let t92 = dCl * t91;
        let t93 = dCm * (real(24.384) * plant.Cm_scale) * real(97170193.3485195);
        let t94 = dCn * (real(18.288) * plant.Cn_scale) * real(97170193.3485195);
        let t95 = Matrix::rows([
            [
                t92[0] * real(7.375621211696555e-7),
                t92[1] * real(7.375621211696555e-7),
                t92[2] * real(7.375621211696555e-7),
            ],
            [
                t93[0] * real(7.375621211696555e-8),
                t93[1] * real(7.375621211696555e-8),
                t93[2] * real(7.375621211696555e-8),
            ],
            [
                t94[0] * real(7.375621211696555e-8),
                t94[1] * real(7.375621211696555e-8),
                t94[2] * real(7.375621211696555e-8),
            ],
        ]);
        // H_2 Sigma_2
        let HSigma2 = t95 * real(0.05);

        // -- Lyapunov function of block 1 (23) (52) --
        let t96 = t44 * t44 * real(0.15915494309189535);
        let [tan_E1, tan_E2] = t50.tan().0;
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t96 * tan_E1;
        let t97 = t55 * state.W1;
        // tr(W_1^T W_1)/(2 Gamma_1)
        let V_W1 = (t97[(0, 0)] + t97[(1, 1)] + t97[(2, 2)]) * real(0.5);
        // D_1 = d_1 + model error of block 1
        let D1 = d1 + (F1_plant - F1);
        // D_1 - D_hat_1
        let D_error1 = D1 - D_hat1;
        // 1/2 ||theta_1 - th_1||^2
        let V_D1 = D_error1.sum_squares() * real(0.5);
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + t65;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        let t98 = t47 * t47 * real(0.15915494309189535);
        // k_2^4/(2 pi) tan E_2
        let V_T2 = t98 * tan_E2;
        let t99 = t66 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = (t99[(0, 0)] + t99[(1, 1)] + t99[(2, 2)]) * real(0.5);
        // w_2 - w_hat_2
        let w_error2 = w2 - w_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = w_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // eps_hat_2^2/(2 iota_20)
        let V_eps2 = state.eps2 * state.eps2 * real(5.0);
        let t100 = real(0.0075000000000000015) - state.sigma2;
        // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
        let V_sigma2 = t100 * t100 * real(0.5);
        // phi_2^2/2
        let V_phi2 = t75 * real(0.5);

        // -- Lyapunov function (52) --
        let t101 = V_T1 + V_W1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;
        // V, sum of the parts above
        let V = t101 + V_eps2 + V_sigma2 + V_phi2;

        // -- Ito generator (2) --
        // column 1 of HSigma2
        let HSigma2_1 = Vector([HSigma2[(0, 0)], HSigma2[(1, 0)], HSigma2[(2, 0)]]);
        // column 2 of HSigma2
        let HSigma2_2 = Vector([HSigma2[(0, 1)], HSigma2[(1, 1)], HSigma2[(2, 1)]]);
        // column 3 of HSigma2
        let HSigma2_3 = Vector([HSigma2[(0, 2)], HSigma2[(1, 2)], HSigma2[(2, 2)]]);
        // e1' along the flow
        let e1_flow = x1_flow - y_r_dot - zeta1_dot;
        let t102 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t102 + t102;
        let t103 = (t46 + t46) * (s1_flow * t45 - t46 * t45 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t103;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = tan_E1
            * (real(4.0) * (t44 * k1) * k1_dot * real(0.15915494309189535))
            + t96 * (E1_flow / t53);
        let t104 = W1_dot.transpose();
        let t105 = t104 * state.W1 + t55 * W1_dot;
        // V_W1' along the flow
        let V_W1_flow = (t105[(0, 0)] + t105[(1, 1)] + t105[(2, 2)]) * real(0.5);
        let t106 = exp_t42 * real(-0.1);
        let t107 = exp_t42 * (real(0.02) * (cos_t36 * real(2.0))) + t87 * t106;
        // d1'
        let d1_dot = Vector([t107, exp_t42 * (real(0.02) * cos_t) + t89 * t106, t107]);
        let t108 = real(1.0) / t13;
        let t109 = sin_beta * x1_flow[1];
        let t110 = real(410460000.0) * t109;
        let t111 = real(1332506.5352200002) * (sin_x1_2 * x1_flow[2]);
        let t112 = x1_flow[0] * real(57.29577951308232);
        let t113 = real(0.0001485745427349122) * t112;
        let t114 = at_alpha_deg_2.CL_alpha_d1 * t112 + t113 + t113;
        let t115 = t83 * t114;
        let t116 = beta * (at_alpha_deg_2.CY_beta_d1 * t112)
            + at_alpha_deg_2.CY_beta * x1_flow[1] + at_alpha_deg_2.CY_LE_d1 * t112
            + at_alpha_deg_2.CY_RE_d1 * t112;
        let t117 = t116 + real(4.86e-20) * t112;
        let t118 = real(1332506.5352200002) * (cos_x1_2 * x1_flow[2]);
        let t119 = x1_flow[1] / (cos_beta * cos_beta);
        let t120 = t11 * t119 - tan_beta * t111;
        // F1_plant' along the flow
        let F1_plant_flow = Vector([
            t85 * t108 * t108 * t110 - (t111 + t115) * t108,
            (t86 * t117 + t118) * real(2.4362909905959168e-9),
            (tan_beta * t115 + t84 * t119 - t120) * real(2.4362909905959168e-9),
        ]);
        let t121 = t1 * t114;
        // F1' along the flow
        let F1_flow = Vector([
            t12 * t108 * t108 * t110 - (t111 + t121) * t108,
            (t3 * t117 + t118) * real(2.4362909905959168e-9),
            (tan_beta * t121 + lift * t119 - t120) * real(2.4362909905959168e-9),
        ]);
        // D1' along the flow
        let D1_flow = d1_dot + (F1_plant_flow - F1_flow);
        // D_hat1' along the flow
        let D_hat1_flow = x1_flow * real(10.0) - (D_hat1 + t60 + t90) * real(10.0);
        // D_error1' along the flow
        let D_error1_flow = D1_flow - D_hat1_flow;
        let t122 = D_error1_flow.dot(D_error1);
        // V_D1' along the flow
        let V_D1_flow = (t122 + t122) * real(0.5);
        let t123 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t123 + t123) * real(0.5);
        let t124 = sin_alpha * x1_flow[0];
        let t125 = cos_alpha * t119 - tan_beta * t124;
        let t126 = cos_alpha * x1_flow[0];
        let t127 = sin_alpha * t119 + tan_beta * t126;
        let t128 = t21 * t20 * t109 - t124 * t20;
        let t129 = t126 * t20 + t22 * t20 * t109;
        // G1' along the flow
        let G1_flow = Matrix::rows([
            [-t125, real(0.0), -t127],
            [t126, real(0.0), t124],
            [t128, real(0.0), t129],
        ]);
        // P1' along the flow
        let P1_flow = polynomials::basis1_rate(x1, x1_flow);
        // A_hat1' along the flow
        let A_hat1_flow = (t104 * P1 + t55 * P1_flow) * real(0.1);
        // y_r''
        let y_r_dot2 = Vector([
            T::select(
                t34,
                real(0.017453292519943295)
                    * (real(2.5) * -(real(FRAC_PI_4) * (sin_t35 * real(FRAC_PI_4)))),
                real(0.0),
            ),
            real(0.017453292519943295)
                * (real(0.5)
                    * -(real(0.9424777960769379)
                        * (sin_t38 * real(0.9424777960769379)))),
            real(0.017453292519943295)
                * (real(-2.0) * -sin_t - real(0.5) * (real(0.5) * t40)),
        ]);
        let t130 = real(1.5697963267948967) * t57;
        let t131 = real(1.0).lt(t130);
        let t132 = T::select(t131, real(1.0), t130);
        let t133 = T::select(E1.eq(real(0.0)), real(1.0), t56 / E1);
        let t134 = t132 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t131, real(0.0), -(t133 * (t130 * t57 * E1_free_flow)));
        let t135 = t133 * t132;
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            real(2.375) * e1[0] * t134 + t135 * (real(2.375) * e1_flow[0])
                + real(2.0) * e1_flow[0],
            real(2.375) * e1[1] * t134 + t135 * (real(2.375) * e1_flow[1])
                + real(2.0) * e1_flow[1],
            real(2.375) * e1[2] * t134 + t135 * (real(2.375) * e1_flow[2])
                + real(2.0) * e1_flow[2],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(sin_E1 * E1_flow);
        let t136 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t136 + e1_flow * t54;
        // Lam1_disturbance' along the flow
        let Lam1_disturbance_flow = c1_flow * real(0.5);
        let t137 = -((t17 + t17) * t125) - (t18 + t18) * t127
            + (sin_alpha + sin_alpha) * t126;
        let t138 = t137 + (t19 - cos_alpha) * t124 + (t21 + t21) * t128;
        // G_norm2_1' along the flow
        let G_norm2_1_flow = t138 + (t22 + t22) * t129;
        // Lam1_filter' along the flow
        let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t58;
        // Lam1' along the flow
        let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
        // bracket1' along the flow
        let bracket1_flow = F1_flow + A_hat1_flow - y_r_dot2 + zeta1_dot * real(20.0)
            + D_hat1_flow + Lam1_flow;
        let t139 = bracket1_flow - G1_flow * t65;
        let t140 = t62.solve(Vector([t139[1], t139[2]]));
        // chi1' along the flow
        let chi1_flow = h1_dot
            + Vector([t140[0], t139[0] - t17 * t140[0] - t18 * t140[1], t140[1]]);
        let t141 = chi1_flow.dot(chi1);
        // V_chi1' along the flow
        let V_chi1_flow = (t141 + t141) * real(0.5);
        // e2' along the flow
        let e2_flow = x2_flow - h1_dot - zeta2_dot;
        let t142 = e2_flow.dot(e2);
        // s2' along the flow
        let s2_flow = t142 + t142;
        let t143 = t49 + t49;
        // E2_free' along the flow
        let E2_free_flow = real(FRAC_PI_2)
            * (t143 * (s2_flow * t48 - t49 * t48 * ((k2 + k2) * k2_dot)));
        let t144 = E2_free.lt(real(1.5697963267948967));
        // E2' along the flow
        let E2_flow = T::select(t144, E2_free_flow, real(0.0));
        // V_T2' along the flow
        let V_T2_flow = tan_E2
            * (real(4.0) * (t47 * k2) * k2_dot * real(0.15915494309189535))
            + t98 * (E2_flow / t51);
        let t145 = W2_dot.transpose() * state.W2 + t66 * W2_dot;
        // V_W2' along the flow
        let V_W2_flow = (t145[(0, 0)] + t145[(1, 1)] + t145[(2, 2)]) * real(0.5);
        let t146 = Vector([
            real(-1.5) * e2_flow[0],
            real(1.5) * e2_flow[0],
            real(1.5) * e2_flow[1],
            e2_flow[1],
            real(-2.0) * e2_flow[2],
            real(4.0) * e2_flow[2],
        ]);
        // w_hat2' along the flow
        let w_hat2_flow = th2_dot + t146;
        // w_error2' along the flow
        let w_error2_flow = w2_flow - w_hat2_flow;
        let t147 = w_error2_flow.dot(w_error2);
        // V_D2' along the flow
        let V_D2_flow = (t147 + t147) * real(0.5);
        let t148 = zeta2_dot.dot(state.zeta2);
        // V_zeta2' along the flow
        let V_zeta2_flow = (t148 + t148) * real(0.5);
        let t149 = eps2_dot * state.eps2;
        // V_eps2' along the flow
        let V_eps2_flow = (t149 + t149) * real(5.0);
        LyapunovValues2 {
            sin_E2,
            sigma2_dot,
            phi2_dot,
            HSigma2,
            t98,
            t100,
            V,
            HSigma2_1,
            HSigma2_2,
            HSigma2_3,
            V_T1_flow,
            V_W1_flow,
            V_D1_flow,
            V_zeta1_flow,
            V_chi1_flow,
            t143,
            t144,
            V_T2_flow,
            V_W2_flow,
            V_D2_flow,
            V_zeta2_flow,
            V_eps2_flow,
        }
    }
}
