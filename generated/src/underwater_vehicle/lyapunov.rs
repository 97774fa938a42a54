// SHA-256 of the text below: fb478436699c4957c56c1491c0d968b1b495efa2825cd2d1312e7b85695c343e
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 4121 additions, 4529 multiplications, 31 divisions, 2 square roots, 28 elementary functions, 25 comparisons and selections

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
/// Operations: 4121 additions, 4529 multiplications, 31 divisions, 2 square roots, 28
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
        t56,
        sin_phi,
        sin_theta,
        sin_psi,
        t57,
        t58,
        t59,
        t60,
        t61,
        t62,
        t63,
        t2,
        t3,
        t4,
        tan_theta,
        t64,
        t65,
        t66,
        t67,
        t68,
        t16,
        t17,
        t19,
        t20,
        t21,
        t22,
        t23,
        t24,
        p,
        q,
        r,
        surge,
        sway,
        heave,
        t10,
        t7,
        t8,
        t13,
        t12,
        F2,
        sin_t28,
        sin_t27,
        sin_t26,
        t30,
        t32,
        t33,
        cos_t28,
        cos_t26,
        t34,
        t35,
        t36,
        t37,
        t38,
        t39,
        t40,
        t41,
        t42,
        t43,
        t44,
        t45,
        t46,
        t47,
        t48,
        t49,
        y_r_dot,
        k1,
        k1_dot,
        e1,
        s1,
        t51,
        t52,
        t53,
        E1_free,
        E1,
        cosE1,
        t54,
        sec2E1,
        t55,
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
        t79,
        t76,
        t80,
        t81,
        t82,
        t83,
        zeta1_dot,
        t152,
        t153,
        t154,
        h1_dot,
        e2,
        s2,
        t87,
        zeta2_dot,
        W2_dot,
        th2_dot,
        eps2_dot,
        sigma2_dot,
        phi2_dot,
        t158,
        t159,
        t162,
        t163,
        t164,
        t165,
        t166,
        t167,
        w2_flow,
        x2_flow,
        chi1,
        w_error2,
        t178,
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
        t56,
        sin_phi,
        sin_theta,
        t58,
        t59,
        t60,
        t62,
        t63,
        t2,
        t3,
        t4,
        t64,
        t65,
        t67,
        t68,
        t16,
        t17,
        t19,
        t20,
        t21,
        t22,
        t23,
        t24,
        p,
        q,
        r,
        surge,
        sway,
        heave,
        t10,
        t7,
        t8,
        t13,
        t12,
        F2,
        sin_t28,
        sin_t27,
        sin_t26,
        t30,
        t32,
        t33,
        cos_t28,
        cos_t26,
        t34,
        t35,
        t36,
        t37,
        t38,
        t39,
        t40,
        t41,
        t42,
        t43,
        t44,
        t45,
        t46,
        t47,
        t48,
        t49,
        y_r_dot,
        k1,
        k1_dot,
        e1,
        s1,
        t51,
        t52,
        t53,
        E1_free,
        E1,
        cosE1,
        t54,
        sec2E1,
        t55,
        c1,
        D_hat1,
        G_norm2_1,
    });

    // -- Ito generator (2) --
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t199 = sin_psi * t154;
    let t200 = sin_theta * t153;
    let t201 = cos_theta * t199 + cos_psi * t200;
    let t202 = cos_theta * t153;
    let t203 = cos_psi * t202 - sin_theta * t199;
    let t204 = cos_phi * t152;
    let t205 = cos_psi * t154;
    let t206 = sin_phi * t152;
    let t207 = sin_phi * t203 + t57 * t204 - (cos_phi * t205 - sin_psi * t206);
    let t208 = cos_phi * t203 - t57 * t206 + (sin_phi * t205 + sin_psi * t204);
    let t209 = cos_theta * t205 - sin_psi * t200;
    let t210 = sin_theta * t205 + sin_psi * t202;
    let t211 = sin_phi * t210 + t61 * t204 - (cos_phi * t199 + cos_psi * t206);
    let t212 = cos_phi * t210 - t61 * t206 - (cos_psi * t204 - sin_phi * t199);
    let t213 = cos_theta * t204 - sin_phi * t200;
    let t214 = cos_phi * t200 + cos_theta * t206;
    let t215 = t153 / (cos_theta * cos_theta);
    let t216 = tan_theta * t204 + sin_phi * t215;
    let t217 = cos_phi * t215 - tan_theta * t206;
    let t218 = t204 * t66 + t67 * t66 * t200;
    let t219 = t68 * t66 * t200 - t206 * t66;
    let t220 = (t58 + t58) * t207 - (t56 + t56) * t201 + (t59 + t59) * t208;
    let t221 = t220 + (t60 + t60) * t209 + (t62 + t62) * t211;
    let t222 = t221 + (t63 + t63) * t212 - (t2 - sin_theta) * t202;
    let t223 = t222 + (t3 + t3) * t213 - (t4 + t4) * t214;
    let t224 = t223 + (t64 + t64) * t216 + (t65 + t65) * t217;
    let t225 = t224 - (cos_phi + cos_phi) * t206 - (t79 - sin_phi) * t204;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t225 + (t67 + t67) * t218 + (t68 + t68) * t219;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t76;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(5.0) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    let t226 = Vector([
        t207 * t81[1] - t201 * t81[0] + t208 * t81[2],
        t209 * t81[0] + t211 * t81[1] + t212 * t81[2],
        t213 * t81[1] - t202 * t81[0] - t214 * t81[2],
        t216 * t83[0] + t217 * t83[1],
        -t206 * t83[0] - t204 * t83[1],
        t218 * t83[0] + t219 * t83[1],
    ]);
    let t227 = bracket1_flow - t226;
    let t228 = t80.solve(Vector([t227[0], t227[1], t227[2]]));
    let t229 = t82.solve(Vector([t227[4], t227[5]]));
    // chi1' along the flow
    let chi1_flow = h1_dot
        + Vector([
            t228[0],
            t228[1],
            t228[2],
            t227[3] - t64 * t229[0] - t65 * t229[1],
            t229[0],
            t229[1],
        ]);
    let t230 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t230 + t230) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t231 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t231 + t231;
    let t232 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t232 + t232) * real(0.25);
    let t233 = W2_dot.transpose() * state.W2 + t87 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t233[(0, 0)] + t233[(1, 1)] + t233[(2, 2)] + t233[(3, 3)]
        + t233[(4, 4)] + t233[(5, 5)]) * real(0.5);
    let t234 = Vector([
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
    let w_hat2_flow = th2_dot + t234;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t235 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t235 + t235) * real(0.5);
    let t236 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t236 + t236) * real(0.5);
    let t237 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t237 + t237) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t178 - t178 * sigma2_dot) * real(0.5);
    let t238 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t238 + t238) * real(0.5);
    let t239 = t158 * real(0.1);
    let t240 = t159 * real(0.1);
    let t241 = t239 * e2[0] + t240 * e2[4];
    // D^1 s2 along noise1
    let s2_noise1_ = t241 + t241;
    let t242 = t239 * t239 + t240 * t240;
    // D^2 s2 along noise1
    let s2_noise1_2 = t242 + t242;
    let t243 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t243 + t243) * real(0.25);
    let t244 = real(-8.0) * t239;
    let t245 = real(5.8) * t239;
    let t246 = real(-8.0) * t240;
    let t247 = real(5.8) * t240;
    let t248 = t244 * t244 + t245 * t245 + t246 * t246 + t247 * t247;
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t248 + t248) * real(0.5);
    let t249 = t162 * real(0.1);
    let t250 = t163 * real(0.1);
    let t251 = t249 * e2[1] + t250 * e2[3];
    // D^1 s2 along noise2
    let s2_noise2_ = t251 + t251;
    let t252 = t249 * t249 + t250 * t250;
    // D^2 s2 along noise2
    let s2_noise2_2 = t252 + t252;
    let t253 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t253 + t253) * real(0.25);
    let t254 = real(-8.0) * t249;
    let t255 = real(5.8) * t249;
    let t256 = real(-8.0) * t250;
    let t257 = real(5.8) * t250;
    let t258 = t254 * t254 + t255 * t255 + t256 * t256 + t257 * t257;
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t258 + t258) * real(0.5);
    let t259 = t164 * real(0.1);
    let t260 = t259 * e2[2];
    // D^1 s2 along noise3
    let s2_noise3_ = t260 + t260;
    let t261 = t259 * t259;
    // D^2 s2 along noise3
    let s2_noise3_2 = t261 + t261;
    let t262 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t262 + t262) * real(0.25);
    let t263 = real(-8.0) * t259;
    let t264 = real(5.8) * t259;
    let t265 = t263 * t263 + t264 * t264;
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t265 + t265) * real(0.5);
    let t266 = t163 * real(0.01);
    let t267 = t165 * real(0.01);
    let t268 = t266 * e2[1] + t267 * e2[3];
    // D^1 s2 along noise4
    let s2_noise4_ = t268 + t268;
    let t269 = t266 * t266 + t267 * t267;
    // D^2 s2 along noise4
    let s2_noise4_2 = t269 + t269;
    let t270 = s2_noise4_2 * s2 + s2_noise4_ * s2_noise4_;
    // D^2 V_T2 along noise4
    let V_T2_noise4_2 = (t270 + t270) * real(0.25);
    let t271 = real(-8.0) * t266;
    let t272 = real(5.8) * t266;
    let t273 = real(-8.0) * t267;
    let t274 = real(5.8) * t267;
    let t275 = t271 * t271 + t272 * t272 + t273 * t273 + t274 * t274;
    // D^2 V_D2 along noise4
    let V_D2_noise4_2 = (t275 + t275) * real(0.5);
    let t276 = t159 * real(0.01);
    let t277 = t166 * real(0.01);
    let t278 = t276 * e2[0] + t277 * e2[4];
    // D^1 s2 along noise5
    let s2_noise5_ = t278 + t278;
    let t279 = t276 * t276 + t277 * t277;
    // D^2 s2 along noise5
    let s2_noise5_2 = t279 + t279;
    let t280 = s2_noise5_2 * s2 + s2_noise5_ * s2_noise5_;
    // D^2 V_T2 along noise5
    let V_T2_noise5_2 = (t280 + t280) * real(0.25);
    let t281 = real(-8.0) * t276;
    let t282 = real(5.8) * t276;
    let t283 = real(-8.0) * t277;
    let t284 = real(5.8) * t277;
    let t285 = t281 * t281 + t282 * t282 + t283 * t283 + t284 * t284;
    // D^2 V_D2 along noise5
    let V_D2_noise5_2 = (t285 + t285) * real(0.5);
    let t286 = t167 * real(0.01);
    let t287 = t286 * e2[5];
    // D^1 s2 along noise6
    let s2_noise6_ = t287 + t287;
    let t288 = t286 * t286;
    // D^2 s2 along noise6
    let s2_noise6_2 = t288 + t288;
    let t289 = s2_noise6_2 * s2 + s2_noise6_ * s2_noise6_;
    // D^2 V_T2 along noise6
    let V_T2_noise6_2 = (t289 + t289) * real(0.25);
    let t290 = real(-8.0) * t286;
    let t291 = real(5.8) * t286;
    let t292 = t290 * t290 + t291 * t291;
    // D^2 V_D2 along noise6
    let V_D2_noise6_2 = (t292 + t292) * real(0.5);
    let t293 = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow + V_eps2_flow;
    let t294 = t293 + V_sigma2_flow + V_phi2_flow + V_T2_noise1_2 * real(0.5)
        + V_D2_noise1_2 * real(0.5) + V_T2_noise2_2 * real(0.5);
    let t295 = t294 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + V_T2_noise4_2 * real(0.5);
    let t296 = t295 + V_D2_noise4_2 * real(0.5) + V_T2_noise5_2 * real(0.5)
        + V_D2_noise5_2 * real(0.5) + V_T2_noise6_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t296 + V_D2_noise6_2 * real(0.5) + real(0.005000000000000001)
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
    t56: T,
    sin_phi: T,
    sin_theta: T,
    sin_psi: T,
    t57: T,
    t58: T,
    t59: T,
    t60: T,
    t61: T,
    t62: T,
    t63: T,
    t2: T,
    t3: T,
    t4: T,
    tan_theta: T,
    t64: T,
    t65: T,
    t66: T,
    t67: T,
    t68: T,
    t16: T,
    t17: T,
    t19: T,
    t20: T,
    t21: T,
    t22: T,
    t23: T,
    t24: T,
    p: T,
    q: T,
    r: T,
    surge: T,
    sway: T,
    heave: T,
    t10: Vector<T, 3>,
    t7: Vector<T, 3>,
    t8: Vector<T, 3>,
    t13: Vector<T, 3>,
    t12: Vector<T, 3>,
    F2: Vector<T, 6>,
    sin_t28: T,
    sin_t27: T,
    sin_t26: T,
    t30: T,
    t32: T,
    t33: T,
    cos_t28: T,
    cos_t26: T,
    t34: T,
    t35: T,
    t36: T,
    t37: T,
    t38: T,
    t39: T,
    t40: T,
    t41: T,
    t42: T,
    t43: T,
    t44: T,
    t45: T,
    t46: T,
    t47: T,
    t48: T,
    t49: T,
    y_r_dot: Vector<T, 6>,
    k1: T,
    k1_dot: T,
    e1: Vector<T, 6>,
    s1: T,
    t51: T,
    t52: T,
    t53: T,
    E1_free: T,
    E1: T,
    cosE1: T,
    t54: T,
    sec2E1: T,
    t55: T,
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
        let I = real(0.16) + params.added_scale * real(0.12);
        let m_x = real(11.5) + params.added_scale * real(5.5);
        let det_xq = m_x * I - real(0.0529);
        let m_y = real(11.5) + params.added_scale * real(12.7);
        let det_yp = m_y * I - real(0.0529);
        let m_z = real(11.5) + params.added_scale * real(14.57);
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
        let t13 = Vector([t6 - real(9.81) * t3, real(9.81) * t2 - t5, real(0.0)])
            * real(0.23);
        let t14 = Vector([
            sway * added_momentum[2] - heave * added_momentum[1],
            heave * added_momentum[0] - surge * added_momentum[2],
            surge * added_momentum[1] - sway * added_momentum[0],
        ]);
        let moment = t13 - t14 - drag_torque;

        // -- known dynamics of block 2 (velocity) (11) --
        let t15 = real(1.0) / det_xq;
        let t16 = I * t15;
        let t17 = real(-0.23) * t15;
        let t18 = real(1.0) / det_yp;
        let t19 = I * t18;
        let t20 = real(0.23) * t18;
        let t21 = real(1.0) / m_z;
        let t22 = m_y * t18;
        let t23 = m_x * t15;
        let t24 = real(1.0) / I;
        // F_2(x_1 .. x_2)
        let F2 = Vector([
            t16 * force[0] + t17 * moment[1],
            t19 * force[1] + t20 * moment[0],
            t21 * force[2],
            t20 * force[1] + t22 * moment[0],
            t17 * force[0] + t23 * moment[1],
            t24 * moment[2],
        ]);

        // -- reference and constraints --
        let t25 = real(0.3) * t;
        let t26 = real(0.1) * t;
        let t27 = real(0.4) * t;
        let t28 = real(0.2) * t;
        let t29 = Vector([t25, t28, t27, t26]);
        let [sin_t25, sin_t28, sin_t27, sin_t26] = t29.sin().0;
        let t30 = real(2.0) * sin_t25;
        let t31 = t * t;
        let t32 = (real(-0.02) * (t31 * t)).exp();
        let t33 = real(1.0) - t32;
        let [cos_t25, cos_t28, cos_t27, cos_t26] = t29.cos().0;
        let t34 = real(2.0) * (real(1.0) - cos_t25);
        let t35 = real(1.0) - cos_t28;
        let t36 = real(0.26179938779914946) * sin_t27;
        let t37 = real(0.4363323129985824) * sin_t25;
        let t38 = real(1.0471975511965979) * sin_t28;
        // y_r(t)
        let y_r = Vector([
            t30 * t33,
            t34 * t33,
            t35 * t33,
            t36 * t33,
            t37 * t33,
            t38 * t33,
        ]);
        let t39 = cos_t25 * real(0.3);
        let t40 = real(2.0) * t39;
        let t41 = real(-0.02) * (real(3.0) * t31);
        let t42 = t32 * t41;
        let t43 = sin_t25 * real(0.3);
        let t44 = real(2.0) * t43;
        let t45 = sin_t28 * real(0.2);
        let t46 = real(0.26179938779914946) * (cos_t27 * real(0.4));
        let t47 = real(0.4363323129985824) * t39;
        let t48 = cos_t28 * real(0.2);
        let t49 = real(1.0471975511965979) * t48;
        // y_r'
        let y_r_dot = Vector([
            t33 * t40 - t30 * t42,
            t33 * t44 - t34 * t42,
            t33 * t45 - t35 * t42,
            t33 * t46 - t36 * t42,
            t33 * t47 - t37 * t42,
            t33 * t49 - t38 * t42,
        ]);
        let t50 = (real(-0.3) * t).exp();
        // k_1(t)
        let k1 = real(0.4) * t50 + real(0.1);
        // k1'
        let k1_dot = real(0.4) * (t50 * real(-0.3));

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t51 = k1 * k1;
        let t52 = real(1.0) / t51;
        let t53 = s1 * t52;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t53 * t53);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));
        // cos E_1
        let cosE1 = E1.cos();
        let t54 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t54;
        let t55 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t55;

        // -- disturbance observer of block 1 (20) --
        // D_hat_1 = th_1 + S_1 x_1
        let D_hat1 = state.th1 + x1;

        // -- norms of block 1 --
        let t56 = cos_psi * cos_theta;
        let t57 = cos_psi * sin_theta;
        let t58 = t57 * sin_phi - sin_psi * cos_phi;
        let t59 = t57 * cos_phi + sin_psi * sin_phi;
        let t60 = sin_psi * cos_theta;
        let t61 = sin_psi * sin_theta;
        let t62 = t61 * sin_phi + cos_psi * cos_phi;
        let t63 = t61 * cos_phi - cos_psi * sin_phi;
        let [_, tan_theta, _] = t1.tan().0;
        let t64 = sin_phi * tan_theta;
        let t65 = cos_phi * tan_theta;
        let t66 = real(1.0) / cos_theta;
        let t67 = sin_phi * t66;
        let t68 = cos_phi * t66;
        let t69 = t60 * t60 + t62 * t62 + t63 * t63;
        let t70 = t56 * t56 + t58 * t58 + t59 * t59 + t69;
        let t71 = t70 + (sin_theta * sin_theta + t3 * t3 + t4 * t4);
        let t72 = t71 + (real(1.0) + t64 * t64 + t65 * t65);
        // ||G_1||^2
        let G_norm2_1 = t72 + (cos_phi * cos_phi + sin_phi * sin_phi)
            + (t67 * t67 + t68 * t68);
        LyapunovValues1 {
            cos_phi,
            cos_theta,
            cos_psi,
            t56,
            sin_phi,
            sin_theta,
            sin_psi,
            t57,
            t58,
            t59,
            t60,
            t61,
            t62,
            t63,
            t2,
            t3,
            t4,
            tan_theta,
            t64,
            t65,
            t66,
            t67,
            t68,
            t16,
            t17,
            t19,
            t20,
            t21,
            t22,
            t23,
            t24,
            p,
            q,
            r,
            surge,
            sway,
            heave,
            t10,
            t7,
            t8,
            t13,
            t12,
            F2,
            sin_t28,
            sin_t27,
            sin_t26,
            t30,
            t32,
            t33,
            cos_t28,
            cos_t26,
            t34,
            t35,
            t36,
            t37,
            t38,
            t39,
            t40,
            t41,
            t42,
            t43,
            t44,
            t45,
            t46,
            t47,
            t48,
            t49,
            y_r_dot,
            k1,
            k1_dot,
            e1,
            s1,
            t51,
            t52,
            t53,
            E1_free,
            E1,
            cosE1,
            t54,
            sec2E1,
            t55,
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
    t56: T,
    sin_phi: T,
    sin_theta: T,
    t58: T,
    t59: T,
    t60: T,
    t62: T,
    t63: T,
    t2: T,
    t3: T,
    t4: T,
    t64: T,
    t65: T,
    t67: T,
    t68: T,
    t16: T,
    t17: T,
    t19: T,
    t20: T,
    t21: T,
    t22: T,
    t23: T,
    t24: T,
    p: T,
    q: T,
    r: T,
    surge: T,
    sway: T,
    heave: T,
    t10: Vector<T, 3>,
    t7: Vector<T, 3>,
    t8: Vector<T, 3>,
    t13: Vector<T, 3>,
    t12: Vector<T, 3>,
    F2: Vector<T, 6>,
    sin_t28: T,
    sin_t27: T,
    sin_t26: T,
    t30: T,
    t32: T,
    t33: T,
    cos_t28: T,
    cos_t26: T,
    t34: T,
    t35: T,
    t36: T,
    t37: T,
    t38: T,
    t39: T,
    t40: T,
    t41: T,
    t42: T,
    t43: T,
    t44: T,
    t45: T,
    t46: T,
    t47: T,
    t48: T,
    t49: T,
    y_r_dot: Vector<T, 6>,
    k1: T,
    k1_dot: T,
    e1: Vector<T, 6>,
    s1: T,
    t51: T,
    t52: T,
    t53: T,
    E1_free: T,
    E1: T,
    cosE1: T,
    t54: T,
    sec2E1: T,
    t55: T,
    c1: Vector<T, 6>,
    D_hat1: Vector<T, 6>,
    G_norm2_1: T,
}

/// What is used of the values of [`LyapunovPart2`].
struct LyapunovValues2<T: Real> {
    t79: T,
    t76: T,
    t80: Matrix<T, 3, 3>,
    t81: Vector<T, 3>,
    t82: Matrix<T, 2, 2>,
    t83: Vector<T, 2>,
    zeta1_dot: Vector<T, 6>,
    t152: T,
    t153: T,
    t154: T,
    h1_dot: Vector<T, 6>,
    e2: Vector<T, 6>,
    s2: T,
    t87: Matrix<T, 6, 28>,
    zeta2_dot: Vector<T, 6>,
    W2_dot: Matrix<T, 28, 6>,
    th2_dot: Vector<T, 12>,
    eps2_dot: T,
    sigma2_dot: T,
    phi2_dot: T,
    t158: T,
    t159: T,
    t162: T,
    t163: T,
    t164: T,
    t165: T,
    t166: T,
    t167: T,
    w2_flow: Vector<T, 12>,
    x2_flow: Vector<T, 6>,
    chi1: Vector<T, 6>,
    w_error2: Vector<T, 12>,
    t178: T,
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
            t56,
            sin_phi,
            sin_theta,
            t58,
            t59,
            t60,
            t62,
            t63,
            t2,
            t3,
            t4,
            t64,
            t65,
            t67,
            t68,
            t16,
            t17,
            t19,
            t20,
            t21,
            t22,
            t23,
            t24,
            p,
            q,
            r,
            surge,
            sway,
            heave,
            t10,
            t7,
            t8,
            t13,
            t12,
            F2,
            sin_t28,
            sin_t27,
            sin_t26,
            t30,
            t32,
            t33,
            cos_t28,
            cos_t26,
            t34,
            t35,
            t36,
            t37,
            t38,
            t39,
            t40,
            t41,
            t42,
            t43,
            t44,
            t45,
            t46,
            t47,
            t48,
            t49,
            y_r_dot,
            k1,
            k1_dot,
            e1,
            s1,
            t51,
            t52,
            t53,
            E1_free,
            E1,
            cosE1,
            t54,
            sec2E1,
            t55,
            c1,
            D_hat1,
            G_norm2_1,
        } = self;
        let real = T::from_f64;

        // -- robust feedback of block 1 (31) (63) --
        let t73 = E1.sin();
        let t74 = t73 * cosE1;
        let t75 = real(1.0) / E1_free;
        let t76 = real(0.5) * G_norm2_1;
        let t77 = T::select(E1_free.lt(real(1e-300)), real(1.0), t74 * t75) + real(0.5)
            + t55 * real(0.5) + t55 * t76;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1 * t77;
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t78 = state.zeta1 * real(5.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t78 - y_r_dot + D_hat1 + Lam1;
        let t79 = -sin_phi;
        let t80 = Matrix::rows([[t56, t58, t59], [t60, t62, t63], [t2, t3, t4]]);
        let t81 = t80.solve(Vector([bracket1[0], bracket1[1], bracket1[2]]));
        let t82 = Matrix::rows([[cos_phi, t79], [t67, t68]]);
        let t83 = t82.solve(Vector([bracket1[4], bracket1[5]]));
        let t84 = bracket1[3] - t64 * t83[0] - t65 * t83[1];
        let t85 = Vector([t81[0], t81[1], t81[2], t84, t83[0], t83[1]]);
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -t85;

        // -- auxiliary system of block 1 (13) (E1) --
        let t86 = Vector([
            t56 * state.zeta2[0] + t58 * state.zeta2[1] + t59 * state.zeta2[2],
            t60 * state.zeta2[0] + t62 * state.zeta2[1] + t63 * state.zeta2[2],
            t3 * state.zeta2[1] - sin_theta * state.zeta2[0] + t4 * state.zeta2[2],
            state.zeta2[3] + t64 * state.zeta2[4] + t65 * state.zeta2[5],
            cos_phi * state.zeta2[4] - sin_phi * state.zeta2[5],
            t67 * state.zeta2[4] + t68 * state.zeta2[5],
        ]);
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = t86 - t78;

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
        let t87 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t87 * P2;

        // -- disturbance observer of block 2 (49) --
        let t88 = Vector([
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
        let w_hat2 = state.th2 + t88;
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
        let t89 = t16 * real(0.1);
        let t90 = t17 * real(0.01);
        let t91 = t19 * real(0.1);
        let t92 = t20 * real(0.01);
        let t93 = t21 * real(0.1);
        let t94 = t20 * real(0.1);
        let t95 = t22 * real(0.01);
        let t96 = t17 * real(0.1);
        let t97 = t23 * real(0.01);
        let t98 = t24 * real(0.01);
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

        // -- robust feedback of block 2 (31) (63) --
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
        // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7) + e Psi
        // cos^2 E / (phi^2 + s^2) (64)
        let Lam2 = e2 * (t131 + t128 * state.sigma2 * s_scale2 + t130)
            + Lam2_error_bound;

        // -- control (64) of block 2 --
        let t132 = state.zeta2 * real(10.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = F2 + A_hat2 - h1_dot + t132 + D_hat2 + Lam2;
        let t133 = real(1.0) / (t16 * t23 - t17 * t17);
        let t134 = -t17 * t133;
        let t135 = Matrix::rows([[t23 * t133, t134], [t134, t16 * t133]])
            * Vector([bracket2[0], bracket2[4]]);
        let t136 = real(1.0) / (t19 * t22 - t20 * t20);
        let t137 = -t20 * t136;
        let t138 = Matrix::rows([[t22 * t136, t137], [t137, t19 * t136]])
            * Vector([bracket2[1], bracket2[3]]);
        let t139 = bracket2[2] * (real(1.0) / t21);
        let t140 = bracket2[5] * (real(1.0) / t24);
        let t141 = Vector([t135[0], t138[0], t139, t138[1], t135[1], t140]);
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t141;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
            .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

        // -- auxiliary system of block 2 (13) (E1) --
        let t142 = u_sat + t141;
        let t143 = Vector([
            t16 * t142[0] + t17 * t142[4],
            t19 * t142[1] + t20 * t142[3],
            t21 * t142[2],
            t20 * t142[1] + t22 * t142[3],
            t17 * t142[0] + t23 * t142[4],
            t24 * t142[5],
        ]);
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = t143 - t132;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

        // -- observer dynamics of block 2 (50) --
        let t144 = Vector([
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
        let t145 = Vector([
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
        // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) = M_2
        // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
        let th2_dot = t144 + t145;

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
        let t146 = real(0.2) + real(0.1) * sin_t28;
        let t147 = real(-0.1) + real(0.1) * cos_t28;
        let t148 = real(0.05) * sin_t26;
        // d_1(t)
        let d1 = Vector([t146, t147, t148, real(0.0), real(0.0), real(0.0)]);
        let t149 = t56 * surge + t58 * sway + t59 * heave;
        let t150 = t60 * surge + t62 * sway + t63 * heave;
        let t151 = t3 * sway - sin_theta * surge + t4 * heave;
        let t152 = p + t64 * q + t65 * r;
        let t153 = cos_phi * q - sin_phi * r;
        let t154 = t67 * q + t68 * r;
        // F_1 + G_1 x_2 + d_1
        let x1_flow = Vector([t149 + t146, t150 + t147, t151 + t148, t152, t153, t154]);

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
        let t155 = real(0.16) + plant.added_scale * real(0.12);
        let t156 = real(11.5) + plant.added_scale * real(5.5);
        let t157 = real(1.0) / (t156 * t155 - real(0.0529));
        let t158 = t155 * t157;
        let t159 = real(-0.23) * t157;
        let t160 = real(11.5) + plant.added_scale * real(12.7);
        let t161 = real(1.0) / (t160 * t155 - real(0.0529));
        let t162 = t155 * t161;
        let t163 = real(0.23) * t161;
        let t164 = real(1.0) / (real(11.5) + plant.added_scale * real(14.57));
        let t165 = t160 * t161;
        let t166 = t156 * t157;
        let t167 = real(1.0) / t155;
        let t168 = t7 * plant.added_scale;
        let t169 = Vector([
            q * t168[2] - r * t168[1],
            r * t168[0] - p * t168[2],
            p * t168[1] - q * t168[0],
        ]);
        let t170 = t10 - t169 - t8 * plant.drag_scale;
        let t171 = Vector([
            sway * t168[2] - heave * t168[1],
            heave * t168[0] - surge * t168[2],
            surge * t168[1] - sway * t168[0],
        ]);
        let t172 = t13 - t171 - t12 * plant.torque_scale;
        let t173 = Vector([t170[0], t170[1], t170[2], t172[0], t172[1], t172[2]])
            + u_sat;
        let t174 = Vector([
            t158 * t173[0] + t159 * t173[4],
            t162 * t173[1] + t163 * t173[3],
            t164 * t173[2],
            t163 * t173[1] + t165 * t173[3],
            t159 * t173[0] + t166 * t173[4],
            t167 * t173[5],
        ]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = t174 + d2;

        // -- Lyapunov function of block 1 (23) (52) --
        let t175 = t51 * t51 * real(0.15915494309189535);
        let t176 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t175 * t176;
        // D_1 - D_hat_1
        let D_error1 = d1 - D_hat1;
        // 1/2 ||theta_1 - th_1||^2
        let V_D1 = D_error1.sum_squares() * real(0.5);
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + t85;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = t126 * real(0.25);
        let t177 = t87 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = (t177[(0, 0)] + t177[(1, 1)] + t177[(2, 2)] + t177[(3, 3)]
            + t177[(4, 4)] + t177[(5, 5)]) * real(0.5);
        // w_2 - w_hat_2
        let w_error2 = w2 - w_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = w_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // eps_hat_2^2/(2 iota_20)
        let V_eps2 = state.eps2 * state.eps2 * real(5.0);
        let t178 = real(6.0) - state.sigma2;
        // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
        let V_sigma2 = t178 * t178 * real(0.5);
        // phi_2^2/2
        let V_phi2 = t129 * real(0.5);

        // -- Lyapunov function (52) --
        let t179 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2
            + V_eps2;
        // V, sum of the parts above
        let V = t179 + V_sigma2 + V_phi2;

        // -- Ito generator (2) --
        // e1' along the flow
        let e1_flow = x1_flow - y_r_dot - zeta1_dot;
        let t180 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t180 + t180;
        let t181 = (t53 + t53) * (s1_flow * t52 - t53 * t52 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t181;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t176
            * (real(4.0) * (t51 * k1) * k1_dot * real(0.15915494309189535))
            + t175 * (E1_flow / t54);
        // d1'
        let d1_dot = Vector([
            real(0.1) * t48,
            -(real(0.1) * t45),
            real(0.05) * (cos_t26 * real(0.1)),
            real(0.0),
            real(0.0),
            real(0.0),
        ]);
        // D_hat1' along the flow
        let D_hat1_flow = x1_flow
            - (D_hat1 + Vector([t149, t150, t151, t152, t153, t154]));
        // D_error1' along the flow
        let D_error1_flow = d1_dot - D_hat1_flow;
        let t182 = D_error1_flow.dot(D_error1);
        // V_D1' along the flow
        let V_D1_flow = (t182 + t182) * real(0.5);
        let t183 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t183 + t183) * real(0.5);
        let t184 = -(real(0.3) * t43);
        let t185 = t40 * t42;
        let t186 = t41 * t42 + t32 * (real(-0.02) * (real(3.0) * (t + t)));
        let t187 = t44 * t42;
        let t188 = t45 * t42;
        let t189 = t46 * t42;
        let t190 = t47 * t42;
        let t191 = t49 * t42;
        // y_r''
        let y_r_dot2 = Vector([
            t33 * (real(2.0) * t184) - t185 - (t185 + t30 * t186),
            t33 * (real(2.0) * (real(0.3) * t39)) - t187 - (t187 + t34 * t186),
            t33 * (real(0.2) * t48) - t188 - (t188 + t35 * t186),
            t33 * (real(0.26179938779914946) * -(real(0.4) * (sin_t27 * real(0.4))))
                - t189 - (t189 + t36 * t186),
            t33 * (real(0.4363323129985824) * t184) - t190 - (t190 + t37 * t186),
            t33 * (real(1.0471975511965979) * -(real(0.2) * t45)) - t191
                - (t191 + t38 * t186),
        ]);
        let t192 = real(1.5697963267948967) * t75;
        let t193 = real(1.0).lt(t192);
        let t194 = T::select(t193, real(1.0), t192);
        let t195 = T::select(E1.eq(real(0.0)), real(1.0), t74 / E1);
        let t196 = t194 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t193, real(0.0), -(t195 * (t192 * t75 * E1_free_flow)));
        let t197 = t195 * t194;
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            e1[0] * t196 + t197 * e1_flow[0] + real(0.5) * e1_flow[0],
            e1[1] * t196 + t197 * e1_flow[1] + real(0.5) * e1_flow[1],
            e1[2] * t196 + t197 * e1_flow[2] + real(0.5) * e1_flow[2],
            e1[3] * t196 + t197 * e1_flow[3] + real(0.5) * e1_flow[3],
            e1[4] * t196 + t197 * e1_flow[4] + real(0.5) * e1_flow[4],
            e1[5] * t196 + t197 * e1_flow[5] + real(0.5) * e1_flow[5],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(t73 * E1_flow);
        let t198 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t198 + e1_flow * t55;
        LyapunovValues2 {
            t79,
            t76,
            t80,
            t81,
            t82,
            t83,
            zeta1_dot,
            t152,
            t153,
            t154,
            h1_dot,
            e2,
            s2,
            t87,
            zeta2_dot,
            W2_dot,
            th2_dot,
            eps2_dot,
            sigma2_dot,
            phi2_dot,
            t158,
            t159,
            t162,
            t163,
            t164,
            t165,
            t166,
            t167,
            w2_flow,
            x2_flow,
            chi1,
            w_error2,
            t178,
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
