// SHA-256 of the text below: dc6cf8f71157ef41351e23d7284e88aa768f05d48b1060832642aec448ac1136
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 1967 additions, 2434 multiplications, 18 divisions, 3 square roots, 24 elementary functions, 110 comparisons and selections

//! `nsv_six_dof`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::polynomials;
use core::f64::consts::FRAC_PI_2;
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
/// Operations: 1967 additions, 2434 multiplications, 18 divisions, 3 square roots, 24
/// elementary functions, 110 comparisons and selections.
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
        y_r,
        t48,
        t50,
        t52,
        t53,
        t54,
        t56,
        t58,
        t59,
        t62,
        t64,
        t66,
        t67,
        t69,
        t71,
        t73,
        t74,
        t75,
        t77,
        t79,
        t80,
        y_r_dot,
    } = T::outlined(LyapunovPart1 { t, x1, x2, params });
    let LyapunovValues2 {
        k2,
        k2_dot,
        e1,
        s1,
        E1,
        t89,
        t90,
        e2,
        t91,
        E2_free,
        cosE1,
        cosE2,
        sec2E1,
        t96,
        c1,
        sin_E1,
        sin_E2,
        t98,
        t99,
        t100,
        t104,
        t107,
        zeta1_dot,
        h1_dot,
        t93,
        sec2E2,
        t108,
        zeta2_dot,
        W2_dot,
        th2_dot,
        eps2_dot,
        sigma2_dot,
        phi2_dot,
        w2_flow,
        x2_flow,
        HSigma2,
        tan_E2,
        chi1,
        t142,
        w_error2,
        t144,
        V,
        HSigma2_1,
        HSigma2_2,
        HSigma2_3,
        e1_flow,
        s1_flow,
        E1_free_flow,
        E1_flow,
        V_T1_flow,
        V_W1_flow,
        F1_flow,
        D_hat1_flow,
        V_D1_flow,
        V_zeta1_flow,
        t168,
        t169,
        t170,
        t171,
        t172,
        t173,
        G1_flow,
        A_hat1_flow,
    } = T::outlined(LyapunovPart2 {
        t,
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
        y_r,
        y_r_dot,
    });

    // -- Ito generator (2) --
    let t174 = t53 * real(0.4);
    let t175 = T::select(t50, T::select(t48, -t174, real(0.0)), real(0.0))
        + t52
            * T::select(
                t50,
                T::select(t48, real(0.08000000000000002), real(0.0)),
                real(0.0),
            );
    let t176 = t59 * real(0.4);
    let t177 = T::select(t56, T::select(t54, -t176, real(0.0)), real(0.0))
        + t58
            * T::select(
                t56,
                T::select(t54, real(0.08000000000000002), real(0.0)),
                real(0.0),
            );
    let t178 = T::select(
        t56,
        T::select(
            t54,
            -(t177 - T::select(t56, T::select(t54, t176, real(0.0)), real(0.0))),
            real(0.0),
        ),
        real(0.0),
    );
    let t179 = T::select(
        t50,
        T::select(
            t48,
            t175 - T::select(t50, T::select(t48, t174, real(0.0)), real(0.0)),
            real(0.0),
        ),
        real(0.0),
    ) + t178;
    let t180 = t67 * real(0.25);
    let t181 = T::select(t64, T::select(t62, -t180, real(0.0)), real(0.0))
        + t66 * T::select(t64, T::select(t62, real(0.03125), real(0.0)), real(0.0));
    let t182 = T::select(
        t64,
        T::select(
            t62,
            real(0.3)
                * (t181 - T::select(t64, T::select(t62, t180, real(0.0)), real(0.0))),
            real(0.0),
        ),
        real(0.0),
    );
    let t183 = t74 * real(0.3333333333333333);
    let t184 = T::select(t71, T::select(t69, -t183, real(0.0)), real(0.0))
        + t73
            * T::select(
                t71,
                T::select(t69, real(0.05555555555555555), real(0.0)),
                real(0.0),
            );
    let t185 = t80 * real(0.3333333333333333);
    let t186 = T::select(t77, T::select(t75, -t185, real(0.0)), real(0.0))
        + t79
            * T::select(
                t77,
                T::select(t75, real(0.05555555555555555), real(0.0)),
                real(0.0),
            );
    let t187 = T::select(
        t77,
        T::select(
            t75,
            -(t186 - T::select(t77, T::select(t75, t185, real(0.0)), real(0.0))),
            real(0.0),
        ),
        real(0.0),
    );
    let t188 = T::select(
        t71,
        T::select(
            t69,
            t184 - T::select(t71, T::select(t69, t183, real(0.0)), real(0.0)),
            real(0.0),
        ),
        real(0.0),
    ) + t187;
    // y_r''
    let y_r_dot2 = Vector([
        real(0.017453292519943295) * (real(1.5) * t179 + t182),
        real(0.0),
        real(0.3490658503988659) * t188,
    ]);
    let t189 = real(1.5697963267948967) * t99;
    let t190 = real(1.0).lt(t189);
    let t191 = T::select(t190, real(1.0), t189);
    let t192 = T::select(E1.eq(real(0.0)), real(1.0), t98 / E1);
    let t193 = t191 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t190, real(0.0), -(t192 * (t189 * t99 * E1_free_flow)));
    let t194 = t192 * t191;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(2.375) * e1[0] * t193 + t194 * (real(2.375) * e1_flow[0])
            + real(2.0) * e1_flow[0],
        real(2.375) * e1[1] * t193 + t194 * (real(2.375) * e1_flow[1])
            + real(2.0) * e1_flow[1],
        real(2.375) * e1[2] * t193 + t194 * (real(2.375) * e1_flow[2])
            + real(2.0) * e1_flow[2],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(sin_E1 * E1_flow);
    let t195 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t195 + e1_flow * t96;
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t196 = -((t17 + t17) * t169) - (t18 + t18) * t171
        + (sin_alpha + sin_alpha) * t170;
    let t197 = t196 + (t19 - cos_alpha) * t168 + (t21 + t21) * t172;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t197 + (t22 + t22) * t173;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t100;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = F1_flow + A_hat1_flow - y_r_dot2 + zeta1_dot * real(20.0)
        + D_hat1_flow + Lam1_flow;
    let t198 = bracket1_flow - G1_flow * t107;
    let t199 = t104.solve(Vector([t198[1], t198[2]]));
    // chi1' along the flow
    let chi1_flow = h1_dot
        + Vector([t199[0], t198[0] - t17 * t199[0] - t18 * t199[1], t199[1]]);
    let t200 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t200 + t200) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t201 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t201 + t201;
    let t202 = t91 + t91;
    // E2_free' along the flow
    let E2_free_flow = real(FRAC_PI_2)
        * (t202 * (s2_flow * t90 - t91 * t90 * ((k2 + k2) * k2_dot)));
    let t203 = E2_free.lt(real(1.5697963267948967));
    // E2' along the flow
    let E2_flow = T::select(t203, E2_free_flow, real(0.0));
    // V_T2' along the flow
    let V_T2_flow = tan_E2
        * (real(4.0) * (t89 * k2) * k2_dot * real(0.15915494309189535))
        + t142 * (E2_flow / t93);
    let t204 = W2_dot.transpose() * state.W2 + t108 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t204[(0, 0)] + t204[(1, 1)] + t204[(2, 2)]) * real(0.5);
    let t205 = Vector([
        real(-1.5) * e2_flow[0],
        real(1.5) * e2_flow[0],
        real(1.5) * e2_flow[1],
        e2_flow[1],
        real(-2.0) * e2_flow[2],
        real(4.0) * e2_flow[2],
    ]);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + t205;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t206 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t206 + t206) * real(0.5);
    let t207 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t207 + t207) * real(0.5);
    let t208 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t208 + t208) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t144 - t144 * sigma2_dot) * real(0.5);
    let t209 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t209 + t209) * real(0.5);
    let t210 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t210 + t210;
    let t211 = s2_noise1_ * t90;
    // D^1 E2_free along noise1
    let E2_free_noise1_ = real(FRAC_PI_2) * (t202 * t211);
    // D^1 E2 along noise1
    let E2_noise1_ = T::select(t203, E2_free_noise1_, real(0.0));
    let t212 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t212 + t212;
    // D^2 E2_free along noise1
    let E2_free_noise1_2 = real(FRAC_PI_2)
        * (t211 * (t211 + t211) + t202 * (s2_noise1_2 * t90));
    // D^2 E2 along noise1
    let E2_noise1_2 = T::select(t203, E2_free_noise1_2, real(0.0));
    let t213 = cosE2 + cosE2;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = t142
        * (E2_noise1_2 * sec2E2
            + E2_noise1_ * sec2E2 * sec2E2 * (t213 * (sin_E2 * E2_noise1_)));
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = Vector([
        real(-1.5) * HSigma2[(0, 0)],
        real(1.5) * HSigma2[(0, 0)],
        real(1.5) * HSigma2[(1, 0)],
        HSigma2[(1, 0)],
        real(-2.0) * HSigma2[(2, 0)],
        real(4.0) * HSigma2[(2, 0)],
    ]);
    let t214 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t214 + t214) * real(0.5);
    let t215 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t215 + t215;
    let t216 = s2_noise2_ * t90;
    // D^1 E2_free along noise2
    let E2_free_noise2_ = real(FRAC_PI_2) * (t202 * t216);
    // D^1 E2 along noise2
    let E2_noise2_ = T::select(t203, E2_free_noise2_, real(0.0));
    let t217 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t217 + t217;
    // D^2 E2_free along noise2
    let E2_free_noise2_2 = real(FRAC_PI_2)
        * (t216 * (t216 + t216) + t202 * (s2_noise2_2 * t90));
    // D^2 E2 along noise2
    let E2_noise2_2 = T::select(t203, E2_free_noise2_2, real(0.0));
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = t142
        * (E2_noise2_2 * sec2E2
            + E2_noise2_ * sec2E2 * sec2E2 * (t213 * (sin_E2 * E2_noise2_)));
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = Vector([
        real(-1.5) * HSigma2[(0, 1)],
        real(1.5) * HSigma2[(0, 1)],
        real(1.5) * HSigma2[(1, 1)],
        HSigma2[(1, 1)],
        real(-2.0) * HSigma2[(2, 1)],
        real(4.0) * HSigma2[(2, 1)],
    ]);
    let t218 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t218 + t218) * real(0.5);
    let t219 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t219 + t219;
    let t220 = s2_noise3_ * t90;
    // D^1 E2_free along noise3
    let E2_free_noise3_ = real(FRAC_PI_2) * (t202 * t220);
    // D^1 E2 along noise3
    let E2_noise3_ = T::select(t203, E2_free_noise3_, real(0.0));
    let t221 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t221 + t221;
    // D^2 E2_free along noise3
    let E2_free_noise3_2 = real(FRAC_PI_2)
        * (t220 * (t220 + t220) + t202 * (s2_noise3_2 * t90));
    // D^2 E2 along noise3
    let E2_noise3_2 = T::select(t203, E2_free_noise3_2, real(0.0));
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = t142
        * (E2_noise3_2 * sec2E2
            + E2_noise3_ * sec2E2 * sec2E2 * (t213 * (sin_E2 * E2_noise3_)));
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = Vector([
        real(-1.5) * HSigma2[(0, 2)],
        real(1.5) * HSigma2[(0, 2)],
        real(1.5) * HSigma2[(1, 2)],
        HSigma2[(1, 2)],
        real(-2.0) * HSigma2[(2, 2)],
        real(4.0) * HSigma2[(2, 2)],
    ]);
    let t222 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t222 + t222) * real(0.5);
    let t223 = V_T1_flow + V_W1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow
        + V_W2_flow + V_D2_flow + V_zeta2_flow;
    let t224 = t223 + V_eps2_flow + V_sigma2_flow + V_phi2_flow
        + V_T2_noise1_2 * real(0.5) + V_D2_noise1_2 * real(0.5);
    let t225 = t224 + V_T2_noise2_2 * real(0.5) + V_D2_noise2_2 * real(0.5)
        + V_T2_noise3_2 * real(0.5) + V_D2_noise3_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t225 + real(0.125) + real(0.125) + real(0.125) + real(0.125) + real(0.125)
        + real(0.125);
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    params: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    t1: T,
    at_alpha_deg_2: polynomials::AtAlphaDeg23<T>,
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
    y_r: Vector<T, 3>,
    t48: T::Mask,
    t50: T::Mask,
    t52: T,
    t53: T,
    t54: T::Mask,
    t56: T::Mask,
    t58: T,
    t59: T,
    t62: T::Mask,
    t64: T::Mask,
    t66: T,
    t67: T,
    t69: T::Mask,
    t71: T::Mask,
    t73: T,
    t74: T,
    t75: T::Mask,
    t77: T::Mask,
    t79: T,
    t80: T,
    y_r_dot: Vector<T, 3>,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, params } = self;
        let real = T::from_f64;

        // -- plant model --
        let alpha = x1[0];
        let alpha_deg = alpha * real(57.29577951308232);
        let t1 = real(97170193.3485195) * params.CL_scale;
        let at_alpha_deg_2 = polynomials::at_alpha_deg_2_3(alpha_deg);
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
        let t34 = (t - real(2.0)) * real(0.2);
        let t35 = t34.max(real(0.0)).min(real(1.0));
        let t36 = (t - real(11.0)) * real(0.2);
        let t37 = t36.max(real(0.0)).min(real(1.0));
        let t38 = t37 * t37 * (real(3.0) - real(2.0) * t37);
        let t39 = real(1.5)
            + real(1.5) * (t35 * t35 * (real(3.0) - real(2.0) * t35) - t38);
        let t40 = t - real(38.0);
        let t41 = t40 * real(0.125);
        let t42 = t41.max(real(0.0)).min(real(1.0));
        let t43 = (t - real(18.0)) * real(0.16666666666666666);
        let t44 = t43.max(real(0.0)).min(real(1.0));
        let t45 = t40 * real(0.16666666666666666);
        let t46 = t45.max(real(0.0)).min(real(1.0));
        let t47 = t46 * t46 * (real(3.0) - real(2.0) * t46);
        // y_r(t)
        let y_r = Vector([
            (t39 + real(0.3) * (t42 * t42 * (real(3.0) - real(2.0) * t42)))
                * real(0.017453292519943295),
            real(0.0),
            real(0.3490658503988659) * (t44 * t44 * (real(3.0) - real(2.0) * t44) - t47),
        ]);
        let t48 = real(0.0).lt(t34);
        let t49 = T::select(t48, t34, real(0.0));
        let t50 = t49.lt(real(1.0));
        let t51 = T::select(t50, t49, real(1.0));
        let t52 = real(3.0) - real(2.0) * t51;
        let t53 = (t51 + t51) * real(0.2);
        let t54 = real(0.0).lt(t36);
        let t55 = T::select(t54, t36, real(0.0));
        let t56 = t55.lt(real(1.0));
        let t57 = T::select(t56, t55, real(1.0));
        let t58 = real(3.0) - real(2.0) * t57;
        let t59 = (t57 + t57) * real(0.2);
        let t60 = T::select(
            t56,
            T::select(t54, -(t58 * t59 - t57 * t57 * real(0.4)), real(0.0)),
            real(0.0),
        );
        let t61 = T::select(
            t50,
            T::select(t48, t52 * t53 - t51 * t51 * real(0.4), real(0.0)),
            real(0.0),
        ) + t60;
        let t62 = real(0.0).lt(t41);
        let t63 = T::select(t62, t41, real(0.0));
        let t64 = t63.lt(real(1.0));
        let t65 = T::select(t64, t63, real(1.0));
        let t66 = real(3.0) - real(2.0) * t65;
        let t67 = (t65 + t65) * real(0.125);
        let t68 = T::select(
            t64,
            T::select(t62, real(0.3) * (t66 * t67 - t65 * t65 * real(0.25)), real(0.0)),
            real(0.0),
        );
        let t69 = real(0.0).lt(t43);
        let t70 = T::select(t69, t43, real(0.0));
        let t71 = t70.lt(real(1.0));
        let t72 = T::select(t71, t70, real(1.0));
        let t73 = real(3.0) - real(2.0) * t72;
        let t74 = (t72 + t72) * real(0.16666666666666666);
        let t75 = real(0.0).lt(t45);
        let t76 = T::select(t75, t45, real(0.0));
        let t77 = t76.lt(real(1.0));
        let t78 = T::select(t77, t76, real(1.0));
        let t79 = real(3.0) - real(2.0) * t78;
        let t80 = (t78 + t78) * real(0.16666666666666666);
        let t81 = T::select(
            t77,
            T::select(
                t75,
                -(t79 * t80 - t78 * t78 * real(0.3333333333333333)),
                real(0.0),
            ),
            real(0.0),
        );
        let t82 = T::select(
            t71,
            T::select(t69, t73 * t74 - t72 * t72 * real(0.3333333333333333), real(0.0)),
            real(0.0),
        ) + t81;
        // y_r'
        let y_r_dot = Vector([
            real(0.017453292519943295) * (real(1.5) * t61 + t68),
            real(0.0),
            real(0.3490658503988659) * t82,
        ]);
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
            y_r,
            t48,
            t50,
            t52,
            t53,
            t54,
            t56,
            t58,
            t59,
            t62,
            t64,
            t66,
            t67,
            t69,
            t71,
            t73,
            t74,
            t75,
            t77,
            t79,
            t80,
            y_r_dot,
        }
    }
}

/// Part 2 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart2<'a, T: Real> {
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    w2: Vector<T, 6>,
    state: &'a State<T>,
    plant: &'a Params<T>,
    t1: T,
    at_alpha_deg_2: polynomials::AtAlphaDeg23<T>,
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
    y_r: Vector<T, 3>,
    y_r_dot: Vector<T, 3>,
}

/// What is used of the values of [`LyapunovPart2`].
struct LyapunovValues2<T: Real> {
    k2: T,
    k2_dot: T,
    e1: Vector<T, 3>,
    s1: T,
    E1: T,
    t89: T,
    t90: T,
    e2: Vector<T, 3>,
    t91: T,
    E2_free: T,
    cosE1: T,
    cosE2: T,
    sec2E1: T,
    t96: T,
    c1: Vector<T, 3>,
    sin_E1: T,
    sin_E2: T,
    t98: T,
    t99: T,
    t100: T,
    t104: Matrix<T, 2, 2>,
    t107: Vector<T, 3>,
    zeta1_dot: Vector<T, 3>,
    h1_dot: Vector<T, 3>,
    t93: T,
    sec2E2: T,
    t108: Matrix<T, 3, 19>,
    zeta2_dot: Vector<T, 3>,
    W2_dot: Matrix<T, 19, 3>,
    th2_dot: Vector<T, 6>,
    eps2_dot: T,
    sigma2_dot: T,
    phi2_dot: T,
    w2_flow: Vector<T, 6>,
    x2_flow: Vector<T, 3>,
    HSigma2: Matrix<T, 3, 3>,
    tan_E2: T,
    chi1: Vector<T, 3>,
    t142: T,
    w_error2: Vector<T, 6>,
    t144: T,
    V: T,
    HSigma2_1: Vector<T, 3>,
    HSigma2_2: Vector<T, 3>,
    HSigma2_3: Vector<T, 3>,
    e1_flow: Vector<T, 3>,
    s1_flow: T,
    E1_free_flow: T,
    E1_flow: T,
    V_T1_flow: T,
    V_W1_flow: T,
    F1_flow: Vector<T, 3>,
    D_hat1_flow: Vector<T, 3>,
    V_D1_flow: T,
    V_zeta1_flow: T,
    t168: T,
    t169: T,
    t170: T,
    t171: T,
    t172: T,
    t173: T,
    G1_flow: Matrix<T, 3, 3>,
    A_hat1_flow: Vector<T, 3>,
}

impl<T: Real> Part for LyapunovPart2<'_, T> {
    type Output = LyapunovValues2<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self {
            t,
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
            y_r,
            y_r_dot,
        } = self;
        let real = T::from_f64;

        // -- reference and constraints --
        let t83 = -t;
        let t84 = real(-0.1) * t;
        let [exp_t83, exp_t84] = Vector([t83, t84]).exp().0;
        let t85 = real(3.0) * exp_t83;
        // k_2(t)
        let k2 = t85 + real(0.5);
        // k_1(t)
        let k1 = k2 * real(0.017453292519943295);
        // k1'
        let k1_dot = -(real(0.017453292519943295) * t85);
        // k2'
        let k2_dot = -t85;

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t86 = k1 * k1;
        let t87 = real(1.0) / t86;
        let t88 = s1 * t87;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t88 * t88);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));

        // -- error variable of block 2 (14) --
        // e_2 = x_2 - h_1 - zeta_2
        let e2 = x2 - state.h1 - state.zeta2;

        // -- barrier of block 2 (23) (26) --
        // s_2 = e_2^T e_2
        let s2 = e2.sum_squares();
        let t89 = k2 * k2;
        let t90 = real(1.0) / t89;
        let t91 = s2 * t90;
        // pi s_2^2 / (2 k_2^4), before the clamp
        let E2_free = real(FRAC_PI_2) * (t91 * t91);
        // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
        let E2 = E2_free.min(real(1.5697963267948967));
        let t92 = Vector([E1, E2]);
        let [cos_E1, cos_E2] = t92.cos().0;
        // cos E_2
        let cosE2 = cos_E2;
        let t93 = cosE2 * cosE2;
        // 1 / cos^2 E_2
        let sec2E2 = real(1.0) / t93;
        let t94 = s2 * sec2E2;
        // c_2 = s_2 e_2^T / cos^2 E_2
        let c2 = e2 * t94;

        // -- barrier of block 1 (23) (26) --
        // cos E_1
        let cosE1 = cos_E1;
        let t95 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t95;
        let t96 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t96;

        // -- MTPN of block 1 (4) (16) --
        // P_1 = P_m(z_1), 19 nodes
        let P1 = polynomials::basis1(x1);
        let t97 = state.W1.transpose();
        // A_hat_1 = iota_1 W_1^T P_1
        let A_hat1 = t97 * P1 * real(0.1);

        // -- disturbance observer of block 1 (20) --
        // D_hat_1 = th_1 + S_1 x_1
        let D_hat1 = state.th1 + x1 * real(10.0);

        // -- norms of block 1 --
        // ||G_1||^2
        let G_norm2_1 = G1.sum_squares();

        // -- robust feedback of block 1 (31) --
        let [sin_E1, sin_E2] = t92.sin().0;
        let t98 = sin_E1 * cosE1;
        let t99 = real(1.0) / E1_free;
        let t100 = real(0.5) * G_norm2_1;
        let t101 = real(2.375)
            * T::select(E1_free.lt(real(1e-300)), real(1.0), t98 * t99) + real(2.0)
            + t96 * real(0.5);
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1 * (t101 + t96 * t100);
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t102 = F1 + A_hat1;
        let t103 = state.zeta1 * real(20.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t102 - y_r_dot + t103 + D_hat1 + Lam1;
        let t104 = Matrix::rows([[sin_alpha, t19], [t21, t22]]);
        let t105 = t104.solve(Vector([bracket1[1], bracket1[2]]));
        let t106 = bracket1[0] - t17 * t105[0] - t18 * t105[1];
        let t107 = Vector([t105[0], t106, t105[1]]);
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -t107;

        // -- auxiliary system of block 1 (13), erratum 1 --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = G1 * state.zeta2 - t103;

        // -- weight law of block 1 (32) (65) --
        // W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)
        let W1_dot = P1.outer(c1 * real(0.1)) - state.W1 * real(0.1);

        // -- dynamic surface filter of block 1 (33) --
        // h_1' = (alpha_1 - h_1) / Fl_1
        let h1_dot = (alpha1 - state.h1) * real(10.0);

        // -- MTPN of block 2 (4) (16) --
        // P_2 = P_m(z_2), 19 nodes
        let P2 = polynomials::basis2(x2);
        let t108 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t108 * P2 * real(0.1);

        // -- disturbance observer of block 2 (49) --
        let t109 = Vector([
            real(-1.5) * e2[0],
            real(1.5) * e2[0],
            real(1.5) * e2[1],
            e2[1],
            real(-2.0) * e2[2],
            real(4.0) * e2[2],
        ]);
        // w_hat_2 = th_2 + S_2 e_2
        let w_hat2 = state.th2 + t109;
        // D_hat_2 = L_2 w_hat_2
        let D_hat2 = Vector([
            real(2.0) * w_hat2[1],
            real(3.0) * w_hat2[2],
            w_hat2[4] + w_hat2[5],
        ]);

        // -- noise terms of block 2 (58) (62) --
        // ||H_2||^2
        let H_norm2_2 = H2.sum_squares();
        let t110 = real(3.0) * sec2E2;
        let t111 = real(8.0) * E2_free * sin_E2 * (cosE2 * (sec2E2 * sec2E2)) + t110;
        // ||Ybar_2||^2
        let Ybar_square2 = t111 * t111 + real(2.0) * (t110 * t110);
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
        let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(3.0)
            + real(0.1) * (SH_norm2_2 * SH_norm2_2);

        // -- robust feedback of block 2 (63) --
        let t112 = (e2 * real(0.5)).tanh();
        // eps_hat Tanh(e / b) (64)
        let Lam2_error_bound = t112 * state.eps2;
        let t113 = s2 * s2;
        // 1 / sqrt(s_2^2 + varsigma_2^2)
        let s_scale2 = real(1.0) / (t113 + real(1.0)).sqrt();
        let t114 = real(2.5)
            * T::select(
                E2_free.lt(real(1e-300)),
                real(1.0),
                sin_E2 * cosE2 * (real(1.0) / E2_free),
            ) + real(2.0);
        let t115 = G_norm2_1 * s_c1;
        let t116 = H_norm2_2 * Ybar_norm2;
        let t117 = state.phi2 * state.phi2;
        let t118 = Psi2 / (t117 + t113);
        let t119 = t114 + t94 * real(75.0) + real(0.5) * sec2E2
            + t115 * t115 * real(0.25) * t93;
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat
        // Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
        // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 +
        // e Psi cos^2 E / (phi^2 + s^2) (64)
        let Lam2 = e2 * (t119 + t116 * state.sigma2 * s_scale2 + t118 * t93)
            + Lam2_error_bound;

        // -- control (64) of block 2 --
        let t120 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = F2 + A_hat2 - h1_dot + t120 + D_hat2 + Lam2;
        let t121 = bracket2
            .hadamard(Vector::<T, 3>::from_f64([1355818.0, 13558180.0, 13558180.0]));
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t121;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 3>::from_f64([-2000000.0, -20000000.0, -20000000.0]))
            .min(Vector::<T, 3>::from_f64([2000000.0, 20000000.0, 20000000.0]));

        // -- auxiliary system of block 2 (13), erratum 1 --
        let t122: Vector<T, 3> = Vector::from_f64([
            7.375621211696555e-7,
            7.375621211696555e-8,
            7.375621211696555e-8,
        ]);
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = t122.hadamard(u_sat + t121) - t120;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2 * real(0.1)) - state.W2 * real(0.1);

        // -- observer dynamics of block 2 (50) --
        let t123 = Vector([
            real(3.0) * w_hat2[1],
            real(-3.0) * w_hat2[0],
            real(3.0) * w_hat2[3],
            real(-3.0) * w_hat2[2],
            real(3.0) * w_hat2[5],
            real(-3.0) * w_hat2[4],
        ]);
        let t124 = Vector([
            real(-1.5) * Lam2[0],
            real(1.5) * Lam2[0],
            real(1.5) * Lam2[1],
            Lam2[1],
            real(-2.0) * Lam2[2],
            real(4.0) * Lam2[2],
        ]);
        // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
        // M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
        let th2_dot = t123 + t124;

        // -- network error bound of block 2 (66) --
        // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
        let eps2_dot = real(0.1) * (t94 * e2.dot(t112) - state.eps2);

        // -- noise bound of block 2 (67) --
        // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
        // varsigma_2^2)) - lambda_sigma sigma_hat_2)
        let sigma2_dot = t116 * t113 * sec2E2 * s_scale2 - real(0.1) * state.sigma2;

        // -- compensation of block 2 (68) --
        // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
        let phi2_decay = t118 + real(2.0);
        // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
        let phi2_dot = T::select(
            s2.sqrt().ge(real(0.01)),
            -state.phi2 * phi2_decay,
            real(0.0),
        );

        // -- true dynamics of block 1 (attitude) (11) --
        let t125 = real(97170193.3485195) * plant.CL_scale;
        let t126 = t125 * t2;
        let t127 = t11 - t126;
        let t128 = real(97170193.3485195) * plant.CY_scale;
        // F_1 with the plant's parameters
        let F1_plant = Vector([
            t127 / t13,
            (t128 * t4 + t14) * real(2.4362909905959168e-9),
            (t126 * tan_beta - t15) * real(2.4362909905959168e-9),
        ]);
        let t129 = real(2.0) * t;
        let t130 = Vector([t, t129]);
        let [sin_t, sin_t129] = t130.sin().0;
        let t131 = real(0.02) * sin_t129;
        let t132 = t131 * exp_t84;
        let t133 = real(0.02) * sin_t;
        // d_1(t)
        let d1 = Vector([t132, t133 * exp_t84, t132]);
        let t134 = G1 * x2;
        // F_1 + G_1 x_2 + d_1
        let x1_flow = F1_plant + t134 + d1;

        // -- true dynamics of block 2 (rates) (11) --
        let t135 = real(1777048495.9577248) * plant.Cl_scale;
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            t135 * t7 * real(7.375621211696555e-7),
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
        let x2_flow = F2_plant + t122.hadamard(u_sat) + d2;
        let t136 = dCl * t135;
        let t137 = dCm * (real(24.384) * plant.Cm_scale) * real(97170193.3485195);
        let t138 = dCn * (real(18.288) * plant.Cn_scale) * real(97170193.3485195);
        let t139 = Matrix::rows([
            [
                t136[0] * real(7.375621211696555e-7),
                t136[1] * real(7.375621211696555e-7),
                t136[2] * real(7.375621211696555e-7),
            ],
            [
                t137[0] * real(7.375621211696555e-8),
                t137[1] * real(7.375621211696555e-8),
                t137[2] * real(7.375621211696555e-8),
            ],
            [
                t138[0] * real(7.375621211696555e-8),
                t138[1] * real(7.375621211696555e-8),
                t138[2] * real(7.375621211696555e-8),
            ],
        ]);
        // H_2 Sigma_2
        let HSigma2 = t139 * real(0.05);

        // -- Lyapunov function of block 1 (23) (52) --
        let t140 = t86 * t86 * real(0.15915494309189535);
        let [tan_E1, tan_E2] = t92.tan().0;
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t140 * tan_E1;
        let t141 = t97 * state.W1;
        // tr(W_1^T W_1)/(2 Gamma_1)
        let V_W1 = (t141[(0, 0)] + t141[(1, 1)] + t141[(2, 2)]) * real(0.5);
        // D_1 = d_1 + model error of block 1
        let D1 = d1 + (F1_plant - F1);
        // D_1 - D_hat_1
        let D_error1 = D1 - D_hat1;
        // 1/2 ||theta_1 - th_1||^2
        let V_D1 = D_error1.sum_squares() * real(0.5);
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + t107;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        let t142 = t89 * t89 * real(0.15915494309189535);
        // k_2^4/(2 pi) tan E_2
        let V_T2 = t142 * tan_E2;
        let t143 = t108 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = (t143[(0, 0)] + t143[(1, 1)] + t143[(2, 2)]) * real(0.5);
        // w_2 - w_hat_2
        let w_error2 = w2 - w_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = w_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // eps_hat_2^2/(2 iota_20)
        let V_eps2 = state.eps2 * state.eps2 * real(5.0);
        let t144 = real(0.0075000000000000015) - state.sigma2;
        // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
        let V_sigma2 = t144 * t144 * real(0.5);
        // phi_2^2/2
        let V_phi2 = t117 * real(0.5);

        // -- Lyapunov function (52) --
        let t145 = V_T1 + V_W1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;
        // V, sum of the parts above
        let V = t145 + V_eps2 + V_sigma2 + V_phi2;

        // -- Ito generator (2) --
        // column 1 of HSigma2
        let HSigma2_1 = Vector([HSigma2[(0, 0)], HSigma2[(1, 0)], HSigma2[(2, 0)]]);
        // column 2 of HSigma2
        let HSigma2_2 = Vector([HSigma2[(0, 1)], HSigma2[(1, 1)], HSigma2[(2, 1)]]);
        // column 3 of HSigma2
        let HSigma2_3 = Vector([HSigma2[(0, 2)], HSigma2[(1, 2)], HSigma2[(2, 2)]]);
        // e1' along the flow
        let e1_flow = x1_flow - y_r_dot - zeta1_dot;
        let t146 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t146 + t146;
        let t147 = (t88 + t88) * (s1_flow * t87 - t88 * t87 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t147;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = tan_E1
            * (real(4.0) * (t86 * k1) * k1_dot * real(0.15915494309189535))
            + t140 * (E1_flow / t95);
        let t148 = W1_dot.transpose();
        let t149 = t148 * state.W1 + t97 * W1_dot;
        // V_W1' along the flow
        let V_W1_flow = (t149[(0, 0)] + t149[(1, 1)] + t149[(2, 2)]) * real(0.5);
        let [cos_t, cos_t129] = t130.cos().0;
        let t150 = exp_t84 * real(-0.1);
        let t151 = exp_t84 * (real(0.02) * (cos_t129 * real(2.0))) + t131 * t150;
        // d1'
        let d1_dot = Vector([t151, exp_t84 * (real(0.02) * cos_t) + t133 * t150, t151]);
        let t152 = real(1.0) / t13;
        let t153 = sin_beta * x1_flow[1];
        let t154 = real(410460000.0) * t153;
        let t155 = real(1332506.5352200002) * (sin_x1_2 * x1_flow[2]);
        let t156 = x1_flow[0] * real(57.29577951308232);
        let t157 = real(0.0001485745427349122) * t156;
        let t158 = at_alpha_deg_2.CL_alpha_d1 * t156 + t157 + t157;
        let t159 = t125 * t158;
        let t160 = beta * (at_alpha_deg_2.CY_beta_d1 * t156)
            + at_alpha_deg_2.CY_beta * x1_flow[1] + at_alpha_deg_2.CY_LE_d1 * t156
            + at_alpha_deg_2.CY_RE_d1 * t156;
        let t161 = t160 + real(4.86e-20) * t156;
        let t162 = real(1332506.5352200002) * (cos_x1_2 * x1_flow[2]);
        let t163 = x1_flow[1] / (cos_beta * cos_beta);
        let t164 = t11 * t163 - tan_beta * t155;
        // F1_plant' along the flow
        let F1_plant_flow = Vector([
            t127 * t152 * t152 * t154 - (t155 + t159) * t152,
            (t128 * t161 + t162) * real(2.4362909905959168e-9),
            (tan_beta * t159 + t126 * t163 - t164) * real(2.4362909905959168e-9),
        ]);
        let t165 = t1 * t158;
        // F1' along the flow
        let F1_flow = Vector([
            t12 * t152 * t152 * t154 - (t155 + t165) * t152,
            (t3 * t161 + t162) * real(2.4362909905959168e-9),
            (tan_beta * t165 + lift * t163 - t164) * real(2.4362909905959168e-9),
        ]);
        // D1' along the flow
        let D1_flow = d1_dot + (F1_plant_flow - F1_flow);
        // D_hat1' along the flow
        let D_hat1_flow = x1_flow * real(10.0) - (D_hat1 + t102 + t134) * real(10.0);
        // D_error1' along the flow
        let D_error1_flow = D1_flow - D_hat1_flow;
        let t166 = D_error1_flow.dot(D_error1);
        // V_D1' along the flow
        let V_D1_flow = (t166 + t166) * real(0.5);
        let t167 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t167 + t167) * real(0.5);
        let t168 = sin_alpha * x1_flow[0];
        let t169 = cos_alpha * t163 - tan_beta * t168;
        let t170 = cos_alpha * x1_flow[0];
        let t171 = sin_alpha * t163 + tan_beta * t170;
        let t172 = t21 * t20 * t153 - t168 * t20;
        let t173 = t170 * t20 + t22 * t20 * t153;
        // G1' along the flow
        let G1_flow = Matrix::rows([
            [-t169, real(0.0), -t171],
            [t170, real(0.0), t168],
            [t172, real(0.0), t173],
        ]);
        // P1' along the flow
        let P1_flow = polynomials::basis1_rate(x1, x1_flow);
        // A_hat1' along the flow
        let A_hat1_flow = (t148 * P1 + t97 * P1_flow) * real(0.1);
        LyapunovValues2 {
            k2,
            k2_dot,
            e1,
            s1,
            E1,
            t89,
            t90,
            e2,
            t91,
            E2_free,
            cosE1,
            cosE2,
            sec2E1,
            t96,
            c1,
            sin_E1,
            sin_E2,
            t98,
            t99,
            t100,
            t104,
            t107,
            zeta1_dot,
            h1_dot,
            t93,
            sec2E2,
            t108,
            zeta2_dot,
            W2_dot,
            th2_dot,
            eps2_dot,
            sigma2_dot,
            phi2_dot,
            w2_flow,
            x2_flow,
            HSigma2,
            tan_E2,
            chi1,
            t142,
            w_error2,
            t144,
            V,
            HSigma2_1,
            HSigma2_2,
            HSigma2_3,
            e1_flow,
            s1_flow,
            E1_free_flow,
            E1_flow,
            V_T1_flow,
            V_W1_flow,
            F1_flow,
            D_hat1_flow,
            V_D1_flow,
            V_zeta1_flow,
            t168,
            t169,
            t170,
            t171,
            t172,
            t173,
            G1_flow,
            A_hat1_flow,
        }
    }
}
