// SHA-256 of the text below: 1607ee2a52349513fec4f20acc95149dda7545a3f7496467d4b6b097dbcf7e28
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 4115 additions, 4522 multiplications, 21 divisions, 2 square roots, 28 elementary functions, 25 comparisons and selections

//! `underwater_vehicle`: Lyapunov function and its generator.
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
/// Operations: 4115 additions, 4522 multiplications, 21 divisions, 2 square roots, 28
/// elementary functions, 25 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    w2: Vector<T, 12>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;
    let LyapunovValues1 {
        cos_phi,
        cos_theta,
        cos_psi,
        t46,
        sin_phi,
        sin_theta,
        sin_psi,
        t47,
        t48,
        t49,
        t50,
        t51,
        t52,
        t53,
        t2,
        t3,
        t4,
        tan_theta,
        t54,
        t55,
        t56,
        t57,
        t58,
        m_x,
        m_y,
        m_z,
        I,
        p,
        q,
        r,
        surge,
        sway,
        heave,
        t10,
        t7,
        t8,
        force,
        t13,
        t12,
        moment,
        sin_t18,
        sin_t17,
        sin_t16,
        t20,
        t22,
        t23,
        cos_t18,
        cos_t16,
        t24,
        t25,
        t26,
        t27,
        t28,
        t29,
        t30,
        t31,
        t32,
        t33,
        t34,
        t35,
        t36,
        t37,
        t38,
        t39,
        y_r_dot,
        k1,
        k1_dot,
        e1,
        s1,
        t41,
        t42,
        t43,
        E1_free,
        E1,
        cosE1,
        t44,
        sec2E1,
        t45,
        c1,
        D_hat1,
        G_norm2_1,
    } = T::outlined(LyapunovPart1 {
        t,
        x1,
        x2,
        state,
        params,
    });
    let LyapunovValues2 {
        t69,
        t66,
        t70,
        t71,
        t72,
        t73,
        zeta1_dot,
        t146,
        t147,
        t148,
        h1_dot,
        e2,
        s2,
        t77,
        zeta2_dot,
        W2_dot,
        th2_dot,
        eps2_dot,
        sigma2_dot,
        phi2_dot,
        t153,
        t154,
        t155,
        t157,
        t158,
        t159,
        t160,
        t161,
        w2_flow,
        x2_flow,
        chi1,
        w_error2,
        t172,
        V,
        V_T1_flow,
        D_hat1_flow,
        V_D1_flow,
        V_zeta1_flow,
        y_r_dot2,
        Lam0_1_flow,
        c1_flow,
    } = T::outlined(LyapunovPart2 {
        t,
        x2,
        w2,
        state,
        plant,
        cos_phi,
        t46,
        sin_phi,
        sin_theta,
        t48,
        t49,
        t50,
        t52,
        t53,
        t2,
        t3,
        t4,
        t54,
        t55,
        t57,
        t58,
        m_x,
        m_y,
        m_z,
        I,
        p,
        q,
        r,
        surge,
        sway,
        heave,
        t10,
        t7,
        t8,
        force,
        t13,
        t12,
        moment,
        sin_t18,
        sin_t17,
        sin_t16,
        t20,
        t22,
        t23,
        cos_t18,
        cos_t16,
        t24,
        t25,
        t26,
        t27,
        t28,
        t29,
        t30,
        t31,
        t32,
        t33,
        t34,
        t35,
        t36,
        t37,
        t38,
        t39,
        y_r_dot,
        k1,
        k1_dot,
        e1,
        s1,
        t41,
        t42,
        t43,
        E1_free,
        E1,
        cosE1,
        t44,
        sec2E1,
        t45,
        c1,
        D_hat1,
        G_norm2_1,
    });

    // -- Ito generator (2) --
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t193 = sin_psi * t148;
    let t194 = sin_theta * t147;
    let t195 = cos_theta * t193 + cos_psi * t194;
    let t196 = cos_theta * t147;
    let t197 = cos_psi * t196 - sin_theta * t193;
    let t198 = cos_phi * t146;
    let t199 = cos_psi * t148;
    let t200 = sin_phi * t146;
    let t201 = sin_phi * t197 + t47 * t198 - (cos_phi * t199 - sin_psi * t200);
    let t202 = cos_phi * t197 - t47 * t200 + (sin_phi * t199 + sin_psi * t198);
    let t203 = cos_theta * t199 - sin_psi * t194;
    let t204 = sin_theta * t199 + sin_psi * t196;
    let t205 = sin_phi * t204 + t51 * t198 - (cos_phi * t193 + cos_psi * t200);
    let t206 = cos_phi * t204 - t51 * t200 - (cos_psi * t198 - sin_phi * t193);
    let t207 = cos_theta * t198 - sin_phi * t194;
    let t208 = cos_phi * t194 + cos_theta * t200;
    let t209 = t147 / (cos_theta * cos_theta);
    let t210 = tan_theta * t198 + sin_phi * t209;
    let t211 = cos_phi * t209 - tan_theta * t200;
    let t212 = t198 * t56 + t57 * t56 * t194;
    let t213 = t58 * t56 * t194 - t200 * t56;
    let t214 = (t48 + t48) * t201 - (t46 + t46) * t195 + (t49 + t49) * t202;
    let t215 = t214 + (t50 + t50) * t203 + (t52 + t52) * t205;
    let t216 = t215 + (t53 + t53) * t206 - (t2 - sin_theta) * t196;
    let t217 = t216 + (t3 + t3) * t207 - (t4 + t4) * t208;
    let t218 = t217 + (t54 + t54) * t210 + (t55 + t55) * t211;
    let t219 = t218 - (cos_phi + cos_phi) * t200 - (t69 - sin_phi) * t198;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t219 + (t57 + t57) * t212 + (t58 + t58) * t213;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t66;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(5.0) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    let t220 = Vector([
        t201 * t71[1] - t195 * t71[0] + t202 * t71[2],
        t203 * t71[0] + t205 * t71[1] + t206 * t71[2],
        t207 * t71[1] - t196 * t71[0] - t208 * t71[2],
        t210 * t73[0] + t211 * t73[1],
        -t200 * t73[0] - t198 * t73[1],
        t212 * t73[0] + t213 * t73[1],
    ]);
    let t221 = bracket1_flow - t220;
    let t222 = t70.solve(Vector([t221[0], t221[1], t221[2]]));
    let t223 = t72.solve(Vector([t221[4], t221[5]]));
    // chi1' along the flow
    let chi1_flow = h1_dot
        + Vector([
            t222[0],
            t222[1],
            t222[2],
            t221[3] - t54 * t223[0] - t55 * t223[1],
            t223[0],
            t223[1],
        ]);
    let t224 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t224 + t224) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t225 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t225 + t225;
    let t226 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t226 + t226) * real(0.25);
    let t227 = W2_dot.transpose() * state.W2 + t77 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t227[(0, 0)] + t227[(1, 1)] + t227[(2, 2)] + t227[(3, 3)]
        + t227[(4, 4)] + t227[(5, 5)]) * real(0.5);
    let t228 = Vector([
        real(-8.0) * e2_flow[0],
        real(5.8) * e2_flow[0],
        real(-8.0) * e2_flow[1],
        real(5.8) * e2_flow[1],
        real(-8.0) * e2_flow[2],
        real(5.8) * e2_flow[2],
        real(-8.0) * e2_flow[3],
        real(5.8) * e2_flow[3],
        real(-8.0) * e2_flow[4],
        real(5.8) * e2_flow[4],
        real(-8.0) * e2_flow[5],
        real(5.8) * e2_flow[5],
    ]);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + t228;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t229 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t229 + t229) * real(0.5);
    let t230 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t230 + t230) * real(0.5);
    let t231 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t231 + t231) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t172 - t172 * sigma2_dot) * real(0.5);
    let t232 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t232 + t232) * real(0.5);
    let t233 = t153 * real(0.1);
    let t234 = t154 * real(0.1);
    let t235 = t233 * e2[0] + t234 * e2[4];
    // D^1 s2 along noise1
    let s2_noise1_ = t235 + t235;
    let t236 = t233 * t233 + t234 * t234;
    // D^2 s2 along noise1
    let s2_noise1_2 = t236 + t236;
    let t237 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t237 + t237) * real(0.25);
    let t238 = real(-8.0) * t233;
    let t239 = real(5.8) * t233;
    let t240 = real(-8.0) * t234;
    let t241 = real(5.8) * t234;
    let t242 = t238 * t238 + t239 * t239 + t240 * t240 + t241 * t241;
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t242 + t242) * real(0.5);
    let t243 = t157 * real(0.1);
    let t244 = t158 * real(0.1);
    let t245 = t243 * e2[1] + t244 * e2[3];
    // D^1 s2 along noise2
    let s2_noise2_ = t245 + t245;
    let t246 = t243 * t243 + t244 * t244;
    // D^2 s2 along noise2
    let s2_noise2_2 = t246 + t246;
    let t247 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t247 + t247) * real(0.25);
    let t248 = real(-8.0) * t243;
    let t249 = real(5.8) * t243;
    let t250 = real(-8.0) * t244;
    let t251 = real(5.8) * t244;
    let t252 = t248 * t248 + t249 * t249 + t250 * t250 + t251 * t251;
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t252 + t252) * real(0.5);
    let t253 = t160 * real(0.1);
    let t254 = t253 * e2[2];
    // D^1 s2 along noise3
    let s2_noise3_ = t254 + t254;
    let t255 = t253 * t253;
    // D^2 s2 along noise3
    let s2_noise3_2 = t255 + t255;
    let t256 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t256 + t256) * real(0.25);
    let t257 = real(-8.0) * t253;
    let t258 = real(5.8) * t253;
    let t259 = t257 * t257 + t258 * t258;
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t259 + t259) * real(0.5);
    let t260 = t158 * real(0.01);
    let t261 = t159 * real(0.01);
    let t262 = t260 * e2[1] + t261 * e2[3];
    // D^1 s2 along noise4
    let s2_noise4_ = t262 + t262;
    let t263 = t260 * t260 + t261 * t261;
    // D^2 s2 along noise4
    let s2_noise4_2 = t263 + t263;
    let t264 = s2_noise4_2 * s2 + s2_noise4_ * s2_noise4_;
    // D^2 V_T2 along noise4
    let V_T2_noise4_2 = (t264 + t264) * real(0.25);
    let t265 = real(-8.0) * t260;
    let t266 = real(5.8) * t260;
    let t267 = real(-8.0) * t261;
    let t268 = real(5.8) * t261;
    let t269 = t265 * t265 + t266 * t266 + t267 * t267 + t268 * t268;
    // D^2 V_D2 along noise4
    let V_D2_noise4_2 = (t269 + t269) * real(0.5);
    let t270 = t154 * real(0.01);
    let t271 = t155 * real(0.01);
    let t272 = t270 * e2[0] + t271 * e2[4];
    // D^1 s2 along noise5
    let s2_noise5_ = t272 + t272;
    let t273 = t270 * t270 + t271 * t271;
    // D^2 s2 along noise5
    let s2_noise5_2 = t273 + t273;
    let t274 = s2_noise5_2 * s2 + s2_noise5_ * s2_noise5_;
    // D^2 V_T2 along noise5
    let V_T2_noise5_2 = (t274 + t274) * real(0.25);
    let t275 = real(-8.0) * t270;
    let t276 = real(5.8) * t270;
    let t277 = real(-8.0) * t271;
    let t278 = real(5.8) * t271;
    let t279 = t275 * t275 + t276 * t276 + t277 * t277 + t278 * t278;
    // D^2 V_D2 along noise5
    let V_D2_noise5_2 = (t279 + t279) * real(0.5);
    let t280 = t161 * real(0.01);
    let t281 = t280 * e2[5];
    // D^1 s2 along noise6
    let s2_noise6_ = t281 + t281;
    let t282 = t280 * t280;
    // D^2 s2 along noise6
    let s2_noise6_2 = t282 + t282;
    let t283 = s2_noise6_2 * s2 + s2_noise6_ * s2_noise6_;
    // D^2 V_T2 along noise6
    let V_T2_noise6_2 = (t283 + t283) * real(0.25);
    let t284 = real(-8.0) * t280;
    let t285 = real(5.8) * t280;
    let t286 = t284 * t284 + t285 * t285;
    // D^2 V_D2 along noise6
    let V_D2_noise6_2 = (t286 + t286) * real(0.5);
    let t287 = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow + V_eps2_flow;
    let t288 = t287 + V_sigma2_flow + V_phi2_flow + V_T2_noise1_2 * real(0.5)
        + V_D2_noise1_2 * real(0.5) + V_T2_noise2_2 * real(0.5);
    let t289 = t288 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + V_T2_noise4_2 * real(0.5);
    let t290 = t289 + V_D2_noise4_2 * real(0.5) + V_T2_noise5_2 * real(0.5)
        + V_D2_noise5_2 * real(0.5) + V_T2_noise6_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t290 + V_D2_noise6_2 * real(0.5) + real(0.005000000000000001)
        + real(0.005000000000000001) + real(0.005000000000000001)
        + real(0.020000000000000004) + real(0.020000000000000004)
        + real(0.020000000000000004);
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    state: &'a State<T>,
    params: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    cos_phi: T,
    cos_theta: T,
    cos_psi: T,
    t46: T,
    sin_phi: T,
    sin_theta: T,
    sin_psi: T,
    t47: T,
    t48: T,
    t49: T,
    t50: T,
    t51: T,
    t52: T,
    t53: T,
    t2: T,
    t3: T,
    t4: T,
    tan_theta: T,
    t54: T,
    t55: T,
    t56: T,
    t57: T,
    t58: T,
    m_x: T,
    m_y: T,
    m_z: T,
    I: T,
    p: T,
    q: T,
    r: T,
    surge: T,
    sway: T,
    heave: T,
    t10: Vector<T, 3>,
    t7: Vector<T, 3>,
    t8: Vector<T, 3>,
    force: Vector<T, 3>,
    t13: Vector<T, 3>,
    t12: Vector<T, 3>,
    moment: Vector<T, 3>,
    sin_t18: T,
    sin_t17: T,
    sin_t16: T,
    t20: T,
    t22: T,
    t23: T,
    cos_t18: T,
    cos_t16: T,
    t24: T,
    t25: T,
    t26: T,
    t27: T,
    t28: T,
    t29: T,
    t30: T,
    t31: T,
    t32: T,
    t33: T,
    t34: T,
    t35: T,
    t36: T,
    t37: T,
    t38: T,
    t39: T,
    y_r_dot: Vector<T, 6>,
    k1: T,
    k1_dot: T,
    e1: Vector<T, 6>,
    s1: T,
    t41: T,
    t42: T,
    t43: T,
    E1_free: T,
    E1: T,
    cosE1: T,
    t44: T,
    sec2E1: T,
    t45: T,
    c1: Vector<T, 6>,
    D_hat1: Vector<T, 6>,
    G_norm2_1: T,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, state, params } = self;
        let real = T::from_f64;

        // -- plant model --
        let psi = x1[5];
        let theta = x1[4];
        let phi = x1[3];
        let m_x = real(11.5) + params.added_scale * real(5.5);
        let arm = real(0.23);
        let m_y = real(11.5) + params.added_scale * real(12.7);
        let m_z = real(11.5) + params.added_scale * real(14.57);
        let I = real(0.16) + params.added_scale * real(0.12);
        let t1 = Vector([phi, theta, psi]);
        let [cos_phi, cos_theta, cos_psi] = t1.cos().0;
        let [sin_phi, sin_theta, sin_psi] = t1.sin().0;
        let t2 = -sin_theta;
        let t3 = cos_theta * sin_phi;
        let t4 = cos_theta * cos_phi;
        let down_axis = Vector([t2, t3, t4]);
        let p = x2[3];
        let q = x2[4];
        let r = x2[5];
        let surge = x2[0];
        let sway = x2[1];
        let heave = x2[2];
        let t5 = q * heave - r * sway;
        let t6 = r * surge - p * heave;
        let carried = Vector([t5, t6, p * sway - q * surge]);
        let t7 = Vector([real(5.5) * surge, real(12.7) * sway, real(14.57) * heave]);
        let added_momentum = t7 * params.added_scale;
        let t8 = Vector([
            (real(4.03) + real(18.18) * surge.abs()) * surge,
            (real(6.22) + real(21.66) * sway.abs()) * sway,
            (real(5.18) + real(36.99) * heave.abs()) * heave,
        ]);
        let drag = t8 * params.drag_scale;
        let t9 = Vector([p * r, q * r, -(p * p) - q * q]) * real(0.02);
        let t10 = down_axis * real(-1.9849999999999852) - (carried + t9) * real(11.5);
        let t11 = Vector([
            q * added_momentum[2] - r * added_momentum[1],
            r * added_momentum[0] - p * added_momentum[2],
            p * added_momentum[1] - q * added_momentum[0],
        ]);
        let force = t10 - t11 - drag;
        let t12 = Vector([
            (real(0.07) + real(1.55) * p.abs()) * p,
            (real(0.07) + real(1.55) * q.abs()) * q,
            (real(0.07) + real(1.55) * r.abs()) * r,
        ]);
        let drag_torque = t12 * params.torque_scale;
        let t13 = Vector([t6 - real(9.81) * t3, real(9.81) * t2 - t5, real(0.0)]);
        let t14 = Vector([
            sway * added_momentum[2] - heave * added_momentum[1],
            heave * added_momentum[0] - surge * added_momentum[2],
            surge * added_momentum[1] - sway * added_momentum[0],
        ]);
        let moment = t13 * arm - t14 - drag_torque;

        // -- reference and constraints --
        let t15 = real(0.3) * t;
        let t16 = real(0.1) * t;
        let t17 = real(0.4) * t;
        let t18 = real(0.2) * t;
        let t19 = Vector([t15, t18, t17, t16]);
        let [sin_t15, sin_t18, sin_t17, sin_t16] = t19.sin().0;
        let t20 = real(2.0) * sin_t15;
        let t21 = t * t;
        let t22 = (real(-0.02) * (t21 * t)).exp();
        let t23 = real(1.0) - t22;
        let [cos_t15, cos_t18, cos_t17, cos_t16] = t19.cos().0;
        let t24 = real(2.0) * (real(1.0) - cos_t15);
        let t25 = real(1.0) - cos_t18;
        let t26 = real(0.26179938779914946) * sin_t17;
        let t27 = real(0.4363323129985824) * sin_t15;
        let t28 = real(1.0471975511965979) * sin_t18;
        // y_r(t)
        let y_r = Vector([
            t20 * t23,
            t24 * t23,
            t25 * t23,
            t26 * t23,
            t27 * t23,
            t28 * t23,
        ]);
        let t29 = cos_t15 * real(0.3);
        let t30 = real(2.0) * t29;
        let t31 = real(-0.02) * (real(3.0) * t21);
        let t32 = t22 * t31;
        let t33 = sin_t15 * real(0.3);
        let t34 = real(2.0) * t33;
        let t35 = sin_t18 * real(0.2);
        let t36 = real(0.26179938779914946) * (cos_t17 * real(0.4));
        let t37 = real(0.4363323129985824) * t29;
        let t38 = cos_t18 * real(0.2);
        let t39 = real(1.0471975511965979) * t38;
        // y_r'
        let y_r_dot = Vector([
            t23 * t30 - t20 * t32,
            t23 * t34 - t24 * t32,
            t23 * t35 - t25 * t32,
            t23 * t36 - t26 * t32,
            t23 * t37 - t27 * t32,
            t23 * t39 - t28 * t32,
        ]);
        let t40 = (real(-0.3) * t).exp();
        // k_1(t)
        let k1 = real(0.4) * t40 + real(0.1);
        // k1'
        let k1_dot = real(0.4) * (t40 * real(-0.3));

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t41 = k1 * k1;
        let t42 = real(1.0) / t41;
        let t43 = s1 * t42;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t43 * t43);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));
        // cos E_1
        let cosE1 = E1.cos();
        let t44 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t44;
        let t45 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t45;

        // -- disturbance observer of block 1 (20) --
        // D_hat_1 = th_1 + S_1 x_1
        let D_hat1 = state.th1 + x1;

        // -- norms of block 1 --
        let t46 = cos_psi * cos_theta;
        let t47 = cos_psi * sin_theta;
        let t48 = t47 * sin_phi - sin_psi * cos_phi;
        let t49 = t47 * cos_phi + sin_psi * sin_phi;
        let t50 = sin_psi * cos_theta;
        let t51 = sin_psi * sin_theta;
        let t52 = t51 * sin_phi + cos_psi * cos_phi;
        let t53 = t51 * cos_phi - cos_psi * sin_phi;
        let [_, tan_theta, _] = t1.tan().0;
        let t54 = sin_phi * tan_theta;
        let t55 = cos_phi * tan_theta;
        let t56 = real(1.0) / cos_theta;
        let t57 = sin_phi * t56;
        let t58 = cos_phi * t56;
        let t59 = t50 * t50 + t52 * t52 + t53 * t53;
        let t60 = t46 * t46 + t48 * t48 + t49 * t49 + t59;
        let t61 = t60 + (sin_theta * sin_theta + t3 * t3 + t4 * t4);
        let t62 = t61 + (real(1.0) + t54 * t54 + t55 * t55);
        // ||G_1||^2
        let G_norm2_1 = t62 + (cos_phi * cos_phi + sin_phi * sin_phi)
            + (t57 * t57 + t58 * t58);
        LyapunovValues1 {
            cos_phi,
            cos_theta,
            cos_psi,
            t46,
            sin_phi,
            sin_theta,
            sin_psi,
            t47,
            t48,
            t49,
            t50,
            t51,
            t52,
            t53,
            t2,
            t3,
            t4,
            tan_theta,
            t54,
            t55,
            t56,
            t57,
            t58,
            m_x,
            m_y,
            m_z,
            I,
            p,
            q,
            r,
            surge,
            sway,
            heave,
            t10,
            t7,
            t8,
            force,
            t13,
            t12,
            moment,
            sin_t18,
            sin_t17,
            sin_t16,
            t20,
            t22,
            t23,
            cos_t18,
            cos_t16,
            t24,
            t25,
            t26,
            t27,
            t28,
            t29,
            t30,
            t31,
            t32,
            t33,
            t34,
            t35,
            t36,
            t37,
            t38,
            t39,
            y_r_dot,
            k1,
            k1_dot,
            e1,
            s1,
            t41,
            t42,
            t43,
            E1_free,
            E1,
            cosE1,
            t44,
            sec2E1,
            t45,
            c1,
            D_hat1,
            G_norm2_1,
        }
    }
}

/// Part 2 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart2<'a, T: Real> {
    t: T,
    x2: Vector<T, 6>,
    w2: Vector<T, 12>,
    state: &'a State<T>,
    plant: &'a Params<T>,
    cos_phi: T,
    t46: T,
    sin_phi: T,
    sin_theta: T,
    t48: T,
    t49: T,
    t50: T,
    t52: T,
    t53: T,
    t2: T,
    t3: T,
    t4: T,
    t54: T,
    t55: T,
    t57: T,
    t58: T,
    m_x: T,
    m_y: T,
    m_z: T,
    I: T,
    p: T,
    q: T,
    r: T,
    surge: T,
    sway: T,
    heave: T,
    t10: Vector<T, 3>,
    t7: Vector<T, 3>,
    t8: Vector<T, 3>,
    force: Vector<T, 3>,
    t13: Vector<T, 3>,
    t12: Vector<T, 3>,
    moment: Vector<T, 3>,
    sin_t18: T,
    sin_t17: T,
    sin_t16: T,
    t20: T,
    t22: T,
    t23: T,
    cos_t18: T,
    cos_t16: T,
    t24: T,
    t25: T,
    t26: T,
    t27: T,
    t28: T,
    t29: T,
    t30: T,
    t31: T,
    t32: T,
    t33: T,
    t34: T,
    t35: T,
    t36: T,
    t37: T,
    t38: T,
    t39: T,
    y_r_dot: Vector<T, 6>,
    k1: T,
    k1_dot: T,
    e1: Vector<T, 6>,
    s1: T,
    t41: T,
    t42: T,
    t43: T,
    E1_free: T,
    E1: T,
    cosE1: T,
    t44: T,
    sec2E1: T,
    t45: T,
    c1: Vector<T, 6>,
    D_hat1: Vector<T, 6>,
    G_norm2_1: T,
}

/// What is used of the values of [`LyapunovPart2`].
struct LyapunovValues2<T: Real> {
    t69: T,
    t66: T,
    t70: Matrix<T, 3, 3>,
    t71: Vector<T, 3>,
    t72: Matrix<T, 2, 2>,
    t73: Vector<T, 2>,
    zeta1_dot: Vector<T, 6>,
    t146: T,
    t147: T,
    t148: T,
    h1_dot: Vector<T, 6>,
    e2: Vector<T, 6>,
    s2: T,
    t77: Matrix<T, 6, 28>,
    zeta2_dot: Vector<T, 6>,
    W2_dot: Matrix<T, 28, 6>,
    th2_dot: Vector<T, 12>,
    eps2_dot: T,
    sigma2_dot: T,
    phi2_dot: T,
    t153: T,
    t154: T,
    t155: T,
    t157: T,
    t158: T,
    t159: T,
    t160: T,
    t161: T,
    w2_flow: Vector<T, 12>,
    x2_flow: Vector<T, 6>,
    chi1: Vector<T, 6>,
    w_error2: Vector<T, 12>,
    t172: T,
    V: T,
    V_T1_flow: T,
    D_hat1_flow: Vector<T, 6>,
    V_D1_flow: T,
    V_zeta1_flow: T,
    y_r_dot2: Vector<T, 6>,
    Lam0_1_flow: Vector<T, 6>,
    c1_flow: Vector<T, 6>,
}

impl<T: Real> Part for LyapunovPart2<'_, T> {
    type Output = LyapunovValues2<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self {
            t,
            x2,
            w2,
            state,
            plant,
            cos_phi,
            t46,
            sin_phi,
            sin_theta,
            t48,
            t49,
            t50,
            t52,
            t53,
            t2,
            t3,
            t4,
            t54,
            t55,
            t57,
            t58,
            m_x,
            m_y,
            m_z,
            I,
            p,
            q,
            r,
            surge,
            sway,
            heave,
            t10,
            t7,
            t8,
            force,
            t13,
            t12,
            moment,
            sin_t18,
            sin_t17,
            sin_t16,
            t20,
            t22,
            t23,
            cos_t18,
            cos_t16,
            t24,
            t25,
            t26,
            t27,
            t28,
            t29,
            t30,
            t31,
            t32,
            t33,
            t34,
            t35,
            t36,
            t37,
            t38,
            t39,
            y_r_dot,
            k1,
            k1_dot,
            e1,
            s1,
            t41,
            t42,
            t43,
            E1_free,
            E1,
            cosE1,
            t44,
            sec2E1,
            t45,
            c1,
            D_hat1,
            G_norm2_1,
        } = self;
        let real = T::from_f64;

        // -- robust feedback of block 1 (31) --
        let t63 = E1.sin();
        let t64 = t63 * cosE1;
        let t65 = real(1.0) / E1_free;
        let t66 = real(0.5) * G_norm2_1;
        let t67 = T::select(E1_free.lt(real(1e-300)), real(1.0), t64 * t65) + real(0.5)
            + t45 * real(0.5) + t45 * t66;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1 * t67;
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t68 = state.zeta1 * real(5.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t68 - y_r_dot + D_hat1 + Lam1;
        let t69 = -sin_phi;
        let t70 = Matrix::rows([[t46, t48, t49], [t50, t52, t53], [t2, t3, t4]]);
        let t71 = t70.solve(Vector([bracket1[0], bracket1[1], bracket1[2]]));
        let t72 = Matrix::rows([[cos_phi, t69], [t57, t58]]);
        let t73 = t72.solve(Vector([bracket1[4], bracket1[5]]));
        let t74 = bracket1[3] - t54 * t73[0] - t55 * t73[1];
        let t75 = Vector([t71[0], t71[1], t71[2], t74, t73[0], t73[1]]);
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -t75;

        // -- auxiliary system of block 1 (13), erratum 1 --
        let t76 = Vector([
            t46 * state.zeta2[0] + t48 * state.zeta2[1] + t49 * state.zeta2[2],
            t50 * state.zeta2[0] + t52 * state.zeta2[1] + t53 * state.zeta2[2],
            t3 * state.zeta2[1] - sin_theta * state.zeta2[0] + t4 * state.zeta2[2],
            state.zeta2[3] + t54 * state.zeta2[4] + t55 * state.zeta2[5],
            cos_phi * state.zeta2[4] - sin_phi * state.zeta2[5],
            t57 * state.zeta2[4] + t58 * state.zeta2[5],
        ]);
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = t76 - t68;

        // -- dynamic surface filter of block 1 (33) --
        // h_1' = (alpha_1 - h_1) / Fl_1
        let h1_dot = (alpha1 - state.h1) * real(10.0);

        // -- error variable of block 2 (14) --
        // e_2 = x_2 - h_1 - zeta_2
        let e2 = x2 - state.h1 - state.zeta2;

        // -- barrier of block 2 (23) (26) --
        // s_2 = e_2^T e_2
        let s2 = e2.sum_squares();
        // c_2 = s_2 e_2^T / cos^2 E_2
        let c2 = e2 * s2;

        // -- MTPN of block 2 (4) (16) --
        // P_2 = P_m(z_2), 28 nodes
        let P2 = polynomials::basis2(x2);
        let t77 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t77 * P2;

        // -- disturbance observer of block 2 (49) --
        let t78 = Vector([
            real(-8.0) * e2[0],
            real(5.8) * e2[0],
            real(-8.0) * e2[1],
            real(5.8) * e2[1],
            real(-8.0) * e2[2],
            real(5.8) * e2[2],
            real(-8.0) * e2[3],
            real(5.8) * e2[3],
            real(-8.0) * e2[4],
            real(5.8) * e2[4],
            real(-8.0) * e2[5],
            real(5.8) * e2[5],
        ]);
        // w_hat_2 = th_2 + S_2 e_2
        let w_hat2 = state.th2 + t78;
        // D_hat_2 = L_2 w_hat_2
        let D_hat2 = Vector([
            w_hat2[1],
            w_hat2[3],
            w_hat2[5],
            w_hat2[7],
            w_hat2[9],
            w_hat2[11],
        ]);

        // -- noise terms of block 2 (58) (62) --
        let t79 = real(1.0) / (m_x * I - real(0.0529));
        let t80 = I * t79;
        let t81 = real(-0.23) * t79;
        let t82 = m_x * t79;
        let t83 = real(1.0) / (m_y * I - real(0.0529));
        let t84 = I * t83;
        let t85 = real(0.23) * t83;
        let t86 = m_y * t83;
        let t87 = real(1.0) / m_z;
        let t88 = real(1.0) / I;
        let t89 = t80 * real(0.1);
        let t90 = t81 * real(0.01);
        let t91 = t84 * real(0.1);
        let t92 = t85 * real(0.01);
        let t93 = t87 * real(0.1);
        let t94 = t85 * real(0.1);
        let t95 = t86 * real(0.01);
        let t96 = t81 * real(0.1);
        let t97 = t82 * real(0.01);
        let t98 = t88 * real(0.01);
        let t99 = t89 * t89 + t90 * t90 + (t91 * t91 + t92 * t92);
        let t100 = t99 + t93 * t93 + (t94 * t94 + t95 * t95);
        // ||H_2||^2
        let H_norm2_2 = t100 + (t96 * t96 + t97 * t97) + t98 * t98;
        // ||Ybar_2||^2
        let Ybar_square2 = real(54.0);
        // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I
        // (58)
        let Ybar_norm2 = real(7.3484692283495345);
        let t101 = real(-8.0) * t89;
        let t102 = real(-8.0) * t90;
        let t103 = real(5.8) * t89;
        let t104 = real(5.8) * t90;
        let t105 = real(-8.0) * t91;
        let t106 = real(-8.0) * t92;
        let t107 = real(5.8) * t91;
        let t108 = real(5.8) * t92;
        let t109 = real(-8.0) * t93;
        let t110 = real(5.8) * t93;
        let t111 = real(-8.0) * t94;
        let t112 = real(-8.0) * t95;
        let t113 = real(5.8) * t94;
        let t114 = real(5.8) * t95;
        let t115 = real(-8.0) * t96;
        let t116 = real(-8.0) * t97;
        let t117 = real(5.8) * t96;
        let t118 = real(5.8) * t97;
        let t119 = real(-8.0) * t98;
        let t120 = real(5.8) * t98;
        let t121 = t101 * t101 + t102 * t102 + (t103 * t103 + t104 * t104);
        let t122 = t121 + (t105 * t105 + t106 * t106) + (t107 * t107 + t108 * t108);
        let t123 = t122 + t109 * t109 + t110 * t110 + (t111 * t111 + t112 * t112);
        let t124 = t123 + (t113 * t113 + t114 * t114) + (t115 * t115 + t116 * t116);
        // ||S_2 H_2||^2
        let SH_norm2_2 = t124 + (t117 * t117 + t118 * t118) + t119 * t119 + t120 * t120;
        // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4
        // (62)
        let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5)
            + real(0.30000000000000004) + real(0.1) * (SH_norm2_2 * SH_norm2_2);

        // -- robust feedback of block 2 (63) --
        let t125 = e2.tanh();
        // eps_hat Tanh(e / b) (64)
        let Lam2_error_bound = t125 * state.eps2;
        let t126 = s2 * s2;
        // 1 / sqrt(s_2^2 + varsigma_2^2)
        let s_scale2 = real(1.0) / (t126 + real(1.0)).sqrt();
        let t127 = G_norm2_1 * s_c1;
        let t128 = H_norm2_2 * Ybar_norm2;
        let t129 = state.phi2 * state.phi2;
        let t130 = Psi2 / (t129 + t126);
        let t131 = real(5.25) + s2 * real(3.0) + real(0.5) + t127 * t127 * real(0.25);
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat
        // Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
        // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 +
        // e Psi cos^2 E / (phi^2 + s^2) (64)
        let Lam2 = e2 * (t131 + t128 * state.sigma2 * s_scale2 + t130)
            + Lam2_error_bound;

        // -- control (64) of block 2 --
        let t132 = state.zeta2 * real(10.0);
        let t133 = A_hat2 - h1_dot + t132 + D_hat2 + Lam2;
        let t134 = Vector([
            m_x * t133[0] + real(0.23) * t133[4],
            m_y * t133[1] + real(-0.23) * t133[3],
            m_z * t133[2],
            real(-0.23) * t133[1] + I * t133[3],
            real(0.23) * t133[0] + I * t133[4],
            I * t133[5],
        ]);
        let t135 = t134
            + Vector([force[0], force[1], force[2], moment[0], moment[1], moment[2]]);
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t135;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
            .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

        // -- auxiliary system of block 2 (13), erratum 1 --
        let t136 = u_sat + t135;
        let t137 = Vector([
            t80 * t136[0] + t81 * t136[4],
            t84 * t136[1] + t85 * t136[3],
            t87 * t136[2],
            t85 * t136[1] + t86 * t136[3],
            t81 * t136[0] + t82 * t136[4],
            t88 * t136[5],
        ]);
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = t137 - t132;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

        // -- observer dynamics of block 2 (50) --
        let t138 = Vector([
            w_hat2[1],
            real(-0.2) * w_hat2[1] - w_hat2[0],
            w_hat2[3],
            real(-0.2) * w_hat2[3] - w_hat2[2],
            w_hat2[5],
            real(-0.2) * w_hat2[5] - w_hat2[4],
            w_hat2[7],
            real(-0.2) * w_hat2[7] - w_hat2[6],
            w_hat2[9],
            real(-0.2) * w_hat2[9] - w_hat2[8],
            w_hat2[11],
            real(-0.2) * w_hat2[11] - w_hat2[10],
        ]);
        let t139 = Vector([
            real(-8.0) * Lam2[0],
            real(5.8) * Lam2[0],
            real(-8.0) * Lam2[1],
            real(5.8) * Lam2[1],
            real(-8.0) * Lam2[2],
            real(5.8) * Lam2[2],
            real(-8.0) * Lam2[3],
            real(5.8) * Lam2[3],
            real(-8.0) * Lam2[4],
            real(5.8) * Lam2[4],
            real(-8.0) * Lam2[5],
            real(5.8) * Lam2[5],
        ]);
        // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
        // M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
        let th2_dot = t138 + t139;

        // -- network error bound of block 2 (66) --
        // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
        let eps2_dot = real(0.1) * (s2 * e2.dot(t125) - state.eps2);

        // -- noise bound of block 2 (67) --
        // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
        // varsigma_2^2)) - lambda_sigma sigma_hat_2)
        let sigma2_dot = t128 * t126 * s_scale2 - real(0.1) * state.sigma2;

        // -- compensation of block 2 (68) --
        // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
        let phi2_decay = t130 + real(0.5);
        // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
        let phi2_dot = T::select(
            s2.sqrt().ge(real(0.2)),
            -state.phi2 * phi2_decay,
            real(0.0),
        );

        // -- true dynamics of block 1 (pose) (11) --
        let t140 = real(0.2) + real(0.1) * sin_t18;
        let t141 = real(-0.1) + real(0.1) * cos_t18;
        let t142 = real(0.05) * sin_t16;
        // d_1(t)
        let d1 = Vector([t140, t141, t142, real(0.0), real(0.0), real(0.0)]);
        let t143 = t46 * surge + t48 * sway + t49 * heave;
        let t144 = t50 * surge + t52 * sway + t53 * heave;
        let t145 = t3 * sway - sin_theta * surge + t4 * heave;
        let t146 = p + t54 * q + t55 * r;
        let t147 = cos_phi * q - sin_phi * r;
        let t148 = t57 * q + t58 * r;
        // F_1 + G_1 x_2 + d_1
        let x1_flow = Vector([t143 + t140, t144 + t141, t145 + t142, t146, t147, t148]);

        // -- true dynamics of block 2 (velocity) (11) --
        // d_2 = L_2 w_2 (12)
        let d2 = Vector([w2[1], w2[3], w2[5], w2[7], w2[9], w2[11]]);
        // w_2' = M_2 w_2 (12)
        let w2_flow = Vector([
            w2[1],
            real(-0.2) * w2[1] - w2[0],
            w2[3],
            real(-0.2) * w2[3] - w2[2],
            w2[5],
            real(-0.2) * w2[5] - w2[4],
            w2[7],
            real(-0.2) * w2[7] - w2[6],
            w2[9],
            real(-0.2) * w2[9] - w2[8],
            w2[11],
            real(-0.2) * w2[11] - w2[10],
        ]);
        let t149 = real(11.5) + plant.added_scale * real(5.5);
        let t150 = real(11.5) + plant.added_scale * real(12.7);
        let t151 = real(0.16) + plant.added_scale * real(0.12);
        let t152 = real(1.0) / (t149 * t151 - real(0.0529));
        let t153 = t151 * t152;
        let t154 = real(-0.23) * t152;
        let t155 = t149 * t152;
        let t156 = real(1.0) / (t150 * t151 - real(0.0529));
        let t157 = t151 * t156;
        let t158 = real(0.23) * t156;
        let t159 = t150 * t156;
        let t160 = real(1.0) / (real(11.5) + plant.added_scale * real(14.57));
        let t161 = real(1.0) / t151;
        let t162 = t7 * plant.added_scale;
        let t163 = Vector([
            q * t162[2] - r * t162[1],
            r * t162[0] - p * t162[2],
            p * t162[1] - q * t162[0],
        ]);
        let t164 = t10 - t163 - t8 * plant.drag_scale;
        let t165 = Vector([
            sway * t162[2] - heave * t162[1],
            heave * t162[0] - surge * t162[2],
            surge * t162[1] - sway * t162[0],
        ]);
        let t166 = t13 * real(0.23) - t165 - t12 * plant.torque_scale;
        let t167 = Vector([t164[0], t164[1], t164[2], t166[0], t166[1], t166[2]])
            + u_sat;
        let t168 = Vector([
            t153 * t167[0] + t154 * t167[4],
            t157 * t167[1] + t158 * t167[3],
            t160 * t167[2],
            t158 * t167[1] + t159 * t167[3],
            t154 * t167[0] + t155 * t167[4],
            t161 * t167[5],
        ]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = t168 + d2;

        // -- Lyapunov function of block 1 (23) (52) --
        let t169 = t41 * t41 * real(0.15915494309189535);
        let t170 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t169 * t170;
        // D_1 - D_hat_1
        let D_error1 = d1 - D_hat1;
        // 1/2 ||theta_1 - th_1||^2
        let V_D1 = D_error1.sum_squares() * real(0.5);
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + t75;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = t126 * real(0.25);
        let t171 = t77 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = (t171[(0, 0)] + t171[(1, 1)] + t171[(2, 2)] + t171[(3, 3)]
            + t171[(4, 4)] + t171[(5, 5)]) * real(0.5);
        // w_2 - w_hat_2
        let w_error2 = w2 - w_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = w_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // eps_hat_2^2/(2 iota_20)
        let V_eps2 = state.eps2 * state.eps2 * real(5.0);
        let t172 = real(6.0) - state.sigma2;
        // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
        let V_sigma2 = t172 * t172 * real(0.5);
        // phi_2^2/2
        let V_phi2 = t129 * real(0.5);

        // -- Lyapunov function (52) --
        let t173 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2
            + V_eps2;
        // V, sum of the parts above
        let V = t173 + V_sigma2 + V_phi2;

        // -- Ito generator (2) --
        // e1' along the flow
        let e1_flow = x1_flow - y_r_dot - zeta1_dot;
        let t174 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t174 + t174;
        let t175 = (t43 + t43) * (s1_flow * t42 - t43 * t42 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t175;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t170
            * (real(4.0) * (t41 * k1) * k1_dot * real(0.15915494309189535))
            + t169 * (E1_flow / t44);
        // d1'
        let d1_dot = Vector([
            real(0.1) * t38,
            -(real(0.1) * t35),
            real(0.05) * (cos_t16 * real(0.1)),
            real(0.0),
            real(0.0),
            real(0.0),
        ]);
        // D_hat1' along the flow
        let D_hat1_flow = x1_flow
            - (D_hat1 + Vector([t143, t144, t145, t146, t147, t148]));
        // D_error1' along the flow
        let D_error1_flow = d1_dot - D_hat1_flow;
        let t176 = D_error1_flow.dot(D_error1);
        // V_D1' along the flow
        let V_D1_flow = (t176 + t176) * real(0.5);
        let t177 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t177 + t177) * real(0.5);
        let t178 = -(real(0.3) * t33);
        let t179 = t30 * t32;
        let t180 = t31 * t32 + t22 * (real(-0.02) * (real(3.0) * (t + t)));
        let t181 = t34 * t32;
        let t182 = t35 * t32;
        let t183 = t36 * t32;
        let t184 = t37 * t32;
        let t185 = t39 * t32;
        // y_r''
        let y_r_dot2 = Vector([
            t23 * (real(2.0) * t178) - t179 - (t179 + t20 * t180),
            t23 * (real(2.0) * (real(0.3) * t29)) - t181 - (t181 + t24 * t180),
            t23 * (real(0.2) * t38) - t182 - (t182 + t25 * t180),
            t23 * (real(0.26179938779914946) * -(real(0.4) * (sin_t17 * real(0.4))))
                - t183 - (t183 + t26 * t180),
            t23 * (real(0.4363323129985824) * t178) - t184 - (t184 + t27 * t180),
            t23 * (real(1.0471975511965979) * -(real(0.2) * t35)) - t185
                - (t185 + t28 * t180),
        ]);
        let t186 = real(1.5697963267948967) * t65;
        let t187 = real(1.0).lt(t186);
        let t188 = T::select(t187, real(1.0), t186);
        let t189 = T::select(E1.eq(real(0.0)), real(1.0), t64 / E1);
        let t190 = t188 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t187, real(0.0), -(t189 * (t186 * t65 * E1_free_flow)));
        let t191 = t189 * t188;
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            e1[0] * t190 + t191 * e1_flow[0] + real(0.5) * e1_flow[0],
            e1[1] * t190 + t191 * e1_flow[1] + real(0.5) * e1_flow[1],
            e1[2] * t190 + t191 * e1_flow[2] + real(0.5) * e1_flow[2],
            e1[3] * t190 + t191 * e1_flow[3] + real(0.5) * e1_flow[3],
            e1[4] * t190 + t191 * e1_flow[4] + real(0.5) * e1_flow[4],
            e1[5] * t190 + t191 * e1_flow[5] + real(0.5) * e1_flow[5],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(t63 * E1_flow);
        let t192 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t192 + e1_flow * t45;
        LyapunovValues2 {
            t69,
            t66,
            t70,
            t71,
            t72,
            t73,
            zeta1_dot,
            t146,
            t147,
            t148,
            h1_dot,
            e2,
            s2,
            t77,
            zeta2_dot,
            W2_dot,
            th2_dot,
            eps2_dot,
            sigma2_dot,
            phi2_dot,
            t153,
            t154,
            t155,
            t157,
            t158,
            t159,
            t160,
            t161,
            w2_flow,
            x2_flow,
            chi1,
            w_error2,
            t172,
            V,
            V_T1_flow,
            D_hat1_flow,
            V_D1_flow,
            V_zeta1_flow,
            y_r_dot2,
            Lam0_1_flow,
            c1_flow,
        }
    }
}
