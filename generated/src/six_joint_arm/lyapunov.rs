// SHA-256 of the text below: 2b0cffeb357233269fce11f8fbdbb953bc9747bd1ce500bb3c75d8b9d0d35f83
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 1077 additions, 1472 multiplications, 21 divisions, 0 square roots, 35 elementary functions, 38 comparisons and selections

//! `six_joint_arm`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
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
/// Operations: 1077 additions, 1472 multiplications, 21 divisions, 0 square roots, 35
/// elementary functions, 38 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;
    let LyapunovValues1 {
        k_2,
        cos_q3,
        cos_q4,
        cos_q5,
        c_2,
        c_23,
        t4,
        k_3,
        sin_q3,
        sin_q4,
        sin_q5,
        s_23,
        s_2,
        t5,
        k_4,
        t6,
        M_11,
        k_5,
        t8,
        k_7,
        t9,
        M_12,
        M_13,
        M_22,
        t10,
        M_23,
        M_33,
        t37,
        t38,
        t39,
        t40,
        t41,
        t42,
        t11,
        t12,
        t13,
        t14,
        t16,
        t17,
        M_11_2,
        v2,
        M_11_3,
        v3,
        t43,
        v1,
        t44,
        t18,
        t19,
        t45,
        t46,
        t47,
        t48,
        t49,
        t50,
        t51,
        t52,
        t53,
        t54,
        t55,
        t56,
        t57,
        pull_2,
        t58,
        t59,
        t60,
        t61,
        t62,
        t63,
        t64,
        t65,
        t66,
        t67,
        tanh_t21,
        tanh_t26,
        tanh_t25,
        tanh_t24,
        tanh_t23,
        tanh_t22,
        t27,
        t28,
        t29,
        t30,
        t31,
        t32,
        F2,
    } = T::outlined(LyapunovPart1 { x1, x2, params });
    let LyapunovValues2 {
        sin_t73,
        sin_t71,
        cos_t73,
        cos_t72,
        cos_t71,
        c1,
        G_norm2_1,
        h1_dot,
        e2,
        s2,
        D_hat2,
        t105,
        t106,
        t108,
        t109,
        t110,
        t111,
        t112,
        t113,
        u,
        u_sat,
        zeta2_dot,
        t170,
        t171,
        t172,
        t117,
        t119,
        t120,
        t121,
        t122,
        t124,
        t125,
        t126,
        t127,
        t128,
        t130,
        t131,
        t132,
        t133,
        t144,
        t145,
        t146,
        t147,
        t149,
        t150,
        t151,
        t152,
        t153,
        t154,
        t155,
        t156,
        t157,
        t158,
        t159,
        t160,
        t161,
        t162,
        t164,
        t165,
        t166,
        t167,
        x2_flow,
        t176,
        t177,
        t178,
        t179,
        t180,
        t181,
        D_error2,
        V,
        V_T1_flow,
        V_zeta1_flow,
        c1_flow,
        alpha1_flow,
        V_chi1_flow,
    } = T::outlined(LyapunovPart2 {
        t,
        x1,
        x2,
        state,
        plant,
        cos_q3,
        c_2,
        c_23,
        t4,
        sin_q3,
        s_23,
        s_2,
        t5,
        M_11,
        M_12,
        M_13,
        M_22,
        M_23,
        M_33,
        t37,
        t38,
        t39,
        t40,
        t41,
        t42,
        t17,
        v2,
        v3,
        v1,
        t45,
        t46,
        t50,
        t53,
        t59,
        t60,
        t63,
        t66,
        t32,
        F2,
    });

    // -- Ito generator (2) --
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t203 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t203 + t203;
    let t204 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t204 + t204) * real(0.25);
    let t205 = real(3.0) * (cos_t71 * real(6.0));
    // d2'
    let d2_dot = Vector([
        real(0.2) * (cos_t73 * real(4.0)),
        -(real(0.2) * (sin_t73 * real(4.0))),
        real(0.5) * (cos_t72 * real(5.0)),
        t205,
        t205,
        -(real(3.0) * (sin_t71 * real(6.0))),
    ]);
    let t206 = t156 + plant.dry_scale * t27;
    let t207 = -t127;
    let t208 = x2[1] + x2[2];
    let t209 = c_23 * t208;
    let t210 = (s_23 + s_23) * t209;
    let t211 = s_2 * x2[1];
    let t212 = (c_2 + c_2) * t211;
    let t213 = t120 * t211;
    let t214 = t119 * t210 - t117 * t212 + (t121 * t209 - s_23 * t213);
    let t215 = Matrix::rows([
        [t122, t128, t207],
        [t128, t130, t132],
        [t207, t132, t133],
    ]);
    let t216: Vector<T, 3> = Vector::from_f64([1.0, 0.0, 0.0]);
    let t217 = t215.solve(t216);
    let t218 = c_2 * x2[1];
    let t219 = real(0.0238) * t211;
    let t220 = s_23 * t208;
    let t221 = t126 * t220;
    let t222 = t124 * t218 - t219 + t221;
    let t223 = cos_q3 * x2[2];
    let t224 = t120 * t223;
    let t225 = t131 * t223;
    let t226 = Vector([
        -(t214 * t217[0] + t222 * t217[1] + t221 * t217[2]),
        -(t222 * t217[0] + t224 * t217[1] + t225 * t217[2]),
        -(t221 * t217[0] + t225 * t217[1]),
    ]);
    let t227 = t215.solve(t226);
    let t228 = c_23 * (t146 * t209) - t147 * t220;
    let t229 = t16.sin() * (real(2.0) * x2[1] + x2[2]);
    let t230 = c_2 * (t144 * t218) - t145 * t211 + t228 - t120 * t229;
    let t231 = t228 - (c_23 * t213 + t121 * t220);
    let t232 = v1 * (v2 * t230 + t149 * x2_flow[1] + (v3 * t231 + t150 * x2_flow[2]));
    let t233 = t126 * t209;
    let t234 = real(0.0238) * t218;
    let t235 = (v2 + v2) * x2_flow[1];
    let t236 = t45 * (t233 - (t124 * t211 + t234)) + t154 * t235;
    let t237 = real(2.0) * x2_flow[1] + x2_flow[2];
    let t238 = v3 * (t46 * t233 + t153 * t237) + t155 * x2_flow[2];
    let t239 = real(6.3)
        * ((real(1.0) - tanh_t21 * tanh_t21) * (x2_flow[0] * real(10.0)));
    let t240 = t232 + t151 * x2_flow[0] + t236 + t238 + plant.dry_scale * t239;
    let t241 = t160 + (t59 - (t164 * c_2 + t166)) + plant.dry_scale * t28;
    let t242: Vector<T, 3> = Vector::from_f64([0.0, 1.0, 0.0]);
    let t243 = t215.solve(t242);
    let t244 = Vector([
        -(t214 * t243[0] + t222 * t243[1] + t221 * t243[2]),
        -(t222 * t243[0] + t224 * t243[1] + t225 * t243[2]),
        -(t221 * t243[0] + t225 * t243[1]),
    ]);
    let t245 = t215.solve(t244);
    let t246 = x2_flow[1] + real(0.5) * x2_flow[2];
    let t247 = sin_q3 * x2[2];
    let t248 = v3 * (t157 * t246 - t50 * (t120 * t247)) + t158 * x2_flow[2];
    let t249 = (v1 + v1) * x2_flow[0];
    let t250 = t248 - (t53 * (real(0.5) * t230) + t159 * t249);
    let t251 = real(1.02) * t218;
    let t252 = t165 * t209;
    let t253 = real(5.5)
        * ((real(1.0) - tanh_t26 * tanh_t26) * (x2_flow[1] * real(10.0)));
    let t254 = t250 + (t251 - (t252 - t164 * t211)) + plant.dry_scale * t253;
    let t255 = t206 * t227[0] + t217[0] * t240 + (t241 * t245[0] + t243[0] * t254);
    let t256 = t167 + plant.dry_scale * t29;
    let t257: Vector<T, 3> = Vector::from_f64([0.0, 0.0, 1.0]);
    let t258 = t215.solve(t257);
    let t259 = Vector([
        -(t214 * t258[0] + t222 * t258[1] + t221 * t258[2]),
        -(t222 * t258[0] + t224 * t258[1] + t225 * t258[2]),
        -(t221 * t258[0] + t225 * t258[1]),
    ]);
    let t260 = t215.solve(t259);
    let t261 = t162 * t235 - t45 * (t131 * t247);
    let t262 = real(0.25) * t220;
    let t263 = t53 * (real(-0.5) * t231) + t161 * t249 - t261 - (t262 + t252);
    let t264 = real(2.6)
        * ((real(1.0) - tanh_t25 * tanh_t25) * (x2_flow[2] * real(10.0)));
    let t265 = t263 + plant.dry_scale * t264;
    let t266 = t63 + plant.dry_scale * t30;
    let t267: Vector<T, 3> = Vector::from_f64([-0.0, -0.0, -0.0]);
    let t268 = t215.solve(t267);
    let t269 = cos_q5 * x2[4];
    let t270 = sin_q5 * (sin_q4 * (real(0.028) * t209) + t61 * (cos_q4 * x2[3]))
        + t62 * t269;
    let t271 = real(1.3)
        * ((real(1.0) - tanh_t24 * tanh_t24) * (x2_flow[3] * real(10.0)));
    let t272 = real(0.028) * t65;
    let t273 = plant.dry_scale * tanh_t23 - t272;
    let t274 = (real(1.0) - tanh_t23 * tanh_t23) * (x2_flow[4] * real(10.0));
    let t275 = cos_q5 * (cos_q4 * t209 - s_23 * (sin_q4 * x2[3]))
        - t64 * (sin_q5 * x2[4]);
    let t276 = real(0.028) * (c_23 * t269 - sin_q5 * t220 + t275);
    let t277 = t255 + (t256 * t260[0] + t258[0] * t265) + t266 * t268[0]
        + t273 * t268[0];
    let t278 = plant.dry_scale * t31;
    let t279 = real(1.2)
        * ((real(1.0) - tanh_t22 * tanh_t22) * (x2_flow[5] * real(10.0)));
    let t280 = t206 * t227[1] + t217[1] * t240 + (t241 * t245[1] + t243[1] * t254);
    let t281 = t280 + (t256 * t260[1] + t258[1] * t265) + t266 * t268[1]
        + t273 * t268[1];
    let t282 = t206 * t227[2] + t217[2] * t240 + (t241 * t245[2] + t243[2] * t254);
    let t283 = t282 + (t256 * t260[2] + t258[2] * t265) + t266 * t268[2]
        + t273 * t268[2];
    // F2_plant' along the flow
    let F2_plant_flow = Vector([
        -(t277 + t278 * t268[0]),
        -(t281 + t278 * t268[1]),
        -(t283 + t278 * t268[2]),
        -(real(5.0) * (t270 + plant.dry_scale * t271)),
        -(real(5.555555555555555) * (plant.dry_scale * t274 - t276)),
        -(real(5.2631578947368425) * (plant.dry_scale * t279)),
    ]);
    let t284 = t18 - t152 + t19;
    let t285 = t44 + t284 * t45 + t48 + params.dry_scale * t27;
    let t286 = t8 + t125 - t9;
    let t287 = -t9;
    let t288 = k_4 * t211;
    let t289 = k_3 * t210 - k_2 * t212 + (t6 * t209 - s_23 * t288);
    let t290 = Matrix::rows([
        [M_11, t286, t287],
        [t286, M_22, M_23],
        [t287, M_23, M_33],
    ]);
    let t291 = t290.solve(t216);
    let t292 = k_7 * t220;
    let t293 = k_5 * t218 - t219 + t292;
    let t294 = k_4 * t223;
    let t295 = t10 * t223;
    let t296 = Vector([
        -(t289 * t291[0] + t293 * t291[1] + t292 * t291[2]),
        -(t293 * t291[0] + t294 * t291[1] + t295 * t291[2]),
        -(t292 * t291[0] + t295 * t291[1]),
    ]);
    let t297 = t290.solve(t296);
    let t298 = c_23 * (t13 * t209) - t14 * t220;
    let t299 = c_2 * (t11 * t218) - t12 * t211 + t298 - k_4 * t229;
    let t300 = t298 - (c_23 * t288 + t6 * t220);
    let t301 = v1
        * (v2 * t299 + M_11_2 * x2_flow[1] + (v3 * t300 + M_11_3 * x2_flow[2]));
    let t302 = k_7 * t209;
    let t303 = t45 * (t302 - (k_5 * t211 + t234)) + t284 * t235;
    let t304 = v3 * (t46 * t302 + t19 * t237) + t47 * x2_flow[2];
    let t305 = t301 + t43 * x2_flow[0] + t303 + t304 + params.dry_scale * t239;
    let t306 = t54 + (t59 - (t57 * c_2 + t58)) + params.dry_scale * t28;
    let t307 = t290.solve(t242);
    let t308 = Vector([
        -(t289 * t307[0] + t293 * t307[1] + t292 * t307[2]),
        -(t293 * t307[0] + t294 * t307[1] + t295 * t307[2]),
        -(t292 * t307[0] + t295 * t307[1]),
    ]);
    let t309 = t290.solve(t308);
    let t310 = v3 * (t49 * t246 - t50 * (k_4 * t247)) + t51 * x2_flow[2];
    let t311 = t310 - (t53 * (real(0.5) * t299) + t52 * t249);
    let t312 = pull_2 * t209;
    let t313 = t311 + (t251 - (t312 - t57 * t211)) + params.dry_scale * t253;
    let t314 = t285 * t297[0] + t291[0] * t305 + (t306 * t309[0] + t307[0] * t313);
    let t315 = t67 + params.dry_scale * t29;
    let t316 = t290.solve(t257);
    let t317 = Vector([
        -(t289 * t316[0] + t293 * t316[1] + t292 * t316[2]),
        -(t293 * t316[0] + t294 * t316[1] + t295 * t316[2]),
        -(t292 * t316[0] + t295 * t316[1]),
    ]);
    let t318 = t290.solve(t317);
    let t319 = t56 * t235 - t45 * (t10 * t247);
    let t320 = t53 * (real(-0.5) * t300) + t55 * t249 - t319 - (t262 + t312);
    let t321 = t320 + params.dry_scale * t264;
    let t322 = t63 + params.dry_scale * t30;
    let t323 = t290.solve(t267);
    let t324 = params.dry_scale * tanh_t23 - t272;
    let t325 = t314 + (t315 * t318[0] + t316[0] * t321) + t322 * t323[0]
        + t324 * t323[0];
    let t326 = params.dry_scale * t31;
    let t327 = t285 * t297[1] + t291[1] * t305 + (t306 * t309[1] + t307[1] * t313);
    let t328 = t327 + (t315 * t318[1] + t316[1] * t321) + t322 * t323[1]
        + t324 * t323[1];
    let t329 = t285 * t297[2] + t291[2] * t305 + (t306 * t309[2] + t307[2] * t313);
    let t330 = t329 + (t315 * t318[2] + t316[2] * t321) + t322 * t323[2]
        + t324 * t323[2];
    // F2' along the flow
    let F2_flow = Vector([
        -(t325 + t326 * t323[0]),
        -(t328 + t326 * t323[1]),
        -(t330 + t326 * t323[2]),
        -(real(5.0) * (t270 + params.dry_scale * t271)),
        -(real(5.555555555555555) * (params.dry_scale * t274 - t276)),
        -(real(5.2631578947368425) * (params.dry_scale * t279)),
    ]);
    // h1_dot' along the flow
    let h1_dot_flow = (alpha1_flow - h1_dot) * real(200.0);
    let t331 = Vector([
        t37 * u_sat[0] + t38 * u_sat[1] + t39 * u_sat[2],
        t38 * u_sat[0] + t40 * u_sat[1] + t41 * u_sat[2],
        t39 * u_sat[0] + t41 * u_sat[1] + t42 * u_sat[2],
        t170,
        t171,
        t172,
    ]);
    // D_hat2' along the flow
    let D_hat2_flow = x2_flow * real(100.0) - (D_hat2 + F2 + t331) * real(100.0);
    // Lam0_2' along the flow
    let Lam0_2_flow = e2_flow * real(50.0);
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    // Lam2_disturbance' along the flow
    let Lam2_disturbance_flow = c2_flow * real(0.5);
    let t332 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t332 + t332;
    let t333 = (t105 + t105) * (G_norm2_1 * s_c1_flow);
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * t333 + t106 * e2_flow[0]) * real(0.25),
        (e2[1] * t333 + t106 * e2_flow[1]) * real(0.25),
        (e2[2] * t333 + t106 * e2_flow[2]) * real(0.25),
        (e2[3] * t333 + t106 * e2_flow[3]) * real(0.25),
        (e2[4] * t333 + t106 * e2_flow[4]) * real(0.25),
        (e2[5] * t333 + t106 * e2_flow[5]) * real(0.25),
    ]);
    // Lam2' along the flow
    let Lam2_flow = Lam0_2_flow + Lam2_disturbance_flow + Lam2_coupling_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow - h1_dot_flow + zeta2_dot * real(50.0) + D_hat2_flow
        + Lam2_flow;
    let t334 = t297[0] * t108 + t309[0] * t109 + t318[0] * t110 + t323[0] * t111;
    let t335 = t297[1] * t108 + t309[1] * t109 + t318[1] * t110 + t323[1] * t111;
    let t336 = t297[2] * t108 + t309[2] * t109 + t318[2] * t110 + t323[2] * t111;
    let t337 = Vector([
        t334 + t323[0] * t112 + t323[0] * t113,
        t335 + t323[1] * t112 + t323[1] * t113,
        t336 + t323[2] * t112 + t323[2] * t113,
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    let t338 = bracket2_flow - t337;
    let t339 = M_11 * t338[0] + M_12 * t338[1] + M_13 * t338[2];
    let t340 = M_12 * t338[0] + M_22 * t338[1] + M_23 * t338[2];
    let t341 = M_13 * t338[0] + M_23 * t338[1] + M_33 * t338[2];
    let t342 = real(0.2) * t338[3];
    let t343 = real(0.18) * t338[4];
    let t344 = real(0.19) * t338[5];
    // u' along the flow
    let u_flow = -Vector([t339, t340, t341, t342, t343, t344]);
    let t345 = real(-97.6).lt(u[0]);
    let t346 = T::select(
        T::select(t345, u[0], real(-97.6)).lt(real(97.6)),
        T::select(t345, u_flow[0], real(0.0)),
        real(0.0),
    );
    let t347 = real(-186.4).lt(u[1]);
    let t348 = T::select(
        T::select(t347, u[1], real(-186.4)).lt(real(186.4)),
        T::select(t347, u_flow[1], real(0.0)),
        real(0.0),
    );
    let t349 = real(-89.4).lt(u[2]);
    let t350 = T::select(
        T::select(t349, u[2], real(-89.4)).lt(real(89.4)),
        T::select(t349, u_flow[2], real(0.0)),
        real(0.0),
    );
    let t351 = t268[0] - t323[0];
    let t352 = t268[1] - t323[1];
    let t353 = t268[2] - t323[2];
    let t354 = (t227[0] - t297[0]) * u_sat[0] + (t245[0] - t309[0]) * u_sat[1]
        + (t260[0] - t318[0]) * u_sat[2];
    let t355 = t354 + t351 * u_sat[3] + t351 * u_sat[4] + t351 * u_sat[5];
    let t356 = (t227[1] - t297[1]) * u_sat[0] + (t245[1] - t309[1]) * u_sat[1]
        + (t260[1] - t318[1]) * u_sat[2];
    let t357 = t356 + t352 * u_sat[3] + t352 * u_sat[4] + t352 * u_sat[5];
    let t358 = (t227[2] - t297[2]) * u_sat[0] + (t245[2] - t309[2]) * u_sat[1]
        + (t260[2] - t318[2]) * u_sat[2];
    let t359 = t358 + t353 * u_sat[3] + t353 * u_sat[4] + t353 * u_sat[5];
    let t360 = Vector([
        t355 + (t176 * t346 + t177 * t348 + t178 * t350),
        t357 + (t177 * t346 + t179 * t348 + t180 * t350),
        t359 + (t178 * t346 + t180 * t348 + t181 * t350),
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    // D2' along the flow
    let D2_flow = d2_dot + (F2_plant_flow - F2_flow) + t360;
    // D_error2' along the flow
    let D_error2_flow = D2_flow - D_hat2_flow;
    let t361 = D_error2_flow.dot(D_error2);
    // V_D2' along the flow
    let V_D2_flow = (t361 + t361) * real(0.5);
    let t362 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t362 + t362) * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_D2_flow
        + V_zeta2_flow;
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    params: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    k_2: T,
    cos_q3: T,
    cos_q4: T,
    cos_q5: T,
    c_2: T,
    c_23: T,
    t4: T,
    k_3: T,
    sin_q3: T,
    sin_q4: T,
    sin_q5: T,
    s_23: T,
    s_2: T,
    t5: T,
    k_4: T,
    t6: T,
    M_11: T,
    k_5: T,
    t8: T,
    k_7: T,
    t9: T,
    M_12: T,
    M_13: T,
    M_22: T,
    t10: T,
    M_23: T,
    M_33: T,
    t37: T,
    t38: T,
    t39: T,
    t40: T,
    t41: T,
    t42: T,
    t11: T,
    t12: T,
    t13: T,
    t14: T,
    t16: T,
    t17: T,
    M_11_2: T,
    v2: T,
    M_11_3: T,
    v3: T,
    t43: T,
    v1: T,
    t44: T,
    t18: T,
    t19: T,
    t45: T,
    t46: T,
    t47: T,
    t48: T,
    t49: T,
    t50: T,
    t51: T,
    t52: T,
    t53: T,
    t54: T,
    t55: T,
    t56: T,
    t57: T,
    pull_2: T,
    t58: T,
    t59: T,
    t60: T,
    t61: T,
    t62: T,
    t63: T,
    t64: T,
    t65: T,
    t66: T,
    t67: T,
    tanh_t21: T,
    tanh_t26: T,
    tanh_t25: T,
    tanh_t24: T,
    tanh_t23: T,
    tanh_t22: T,
    t27: T,
    t28: T,
    t29: T,
    t30: T,
    t31: T,
    t32: Vector<T, 6>,
    F2: Vector<T, 6>,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { x1, x2, params } = self;
        let real = T::from_f64;

        // -- plant model --
        let k_1 = real(2.57) + params.load * real(0.022530010000000003);
        let k_2 = real(1.38) + params.load * real(0.18645124000000002);
        let q2 = x1[1];
        let q5 = x1[4];
        let q4 = x1[3];
        let q3 = x1[2];
        let t1 = q2 + q3;
        let t2 = Vector([t1, q2, q3, q4, q5]);
        let [cos_t1, cos_q2, cos_q3, cos_q4, cos_q5] = t2.cos().0;
        let c_2 = cos_q2;
        let c_23 = cos_t1;
        let t3 = params.load * real(0.18757560999999998);
        let k_3 = real(0.3) + t3;
        let [sin_t1, sin_q2, sin_q3, sin_q4, sin_q5] = t2.sin().0;
        let s_23 = sin_t1;
        let s_2 = sin_q2;
        let k_4 = real(0.744) + real(2.0) * params.load * real(0.4318) * real(0.4331);
        let t4 = c_2 * c_2;
        let t5 = s_23 * s_23;
        let t6 = k_4 * c_2;
        let M_11 = k_1 + k_2 * t4 + k_3 * t5 + t6 * s_23;
        let t7 = params.load * real(0.1501);
        let k_5 = real(0.69) + t7 * real(0.4318);
        let k_6 = real(0.0238);
        let k_7 = real(0.134) + t7 * real(0.4331);
        let t8 = k_5 * s_2;
        let t9 = k_7 * c_23;
        let M_12 = t8 + k_6 * c_2 - t9;
        let M_13 = -k_7 * c_23;
        let k_8 = real(6.79) + params.load * real(0.37402685);
        let M_22 = k_8 + k_4 * sin_q3;
        let k_9 = real(0.333) + t3;
        let t10 = real(0.5) * k_4;
        let M_23 = k_9 + t10 * sin_q3;
        let M_33 = real(1.16) + t3;
        let t11 = real(-2.0) * k_2;
        let t12 = t11 * s_2;
        let t13 = real(2.0) * k_3;
        let t14 = t13 * s_23;
        let t15 = t14 * c_23;
        let t16 = real(2.0) * q2 + q3;
        let t17 = t16.cos();
        let M_11_2 = t12 * c_2 + t15 + k_4 * t17;
        let v2 = x2[1];
        let M_11_3 = t15 + t6 * c_23;
        let v3 = x2[2];
        let v1 = x2[0];
        let t18 = k_5 * c_2;
        let t19 = k_7 * s_23;
        let M_12_2 = t18 - k_6 * s_2 + t19;
        let t20 = params.load * real(9.81);
        let pull_2 = real(8.4) + t20 * real(0.4331);
        let v6 = x2[5];
        let v5 = x2[4];
        let v4 = x2[3];
        let t21 = v1 * real(10.0);
        let t22 = v6 * real(10.0);
        let t23 = v5 * real(10.0);
        let t24 = v4 * real(10.0);
        let t25 = v3 * real(10.0);
        let t26 = v2 * real(10.0);
        let [tanh_t21, tanh_t26, tanh_t25, tanh_t24, tanh_t23, tanh_t22] = Vector([
                t21,
                t26,
                t25,
                t24,
                t23,
                t22,
            ])
            .tanh()
            .0;
        let t27 = real(6.3) * tanh_t21;
        let t28 = real(5.5) * tanh_t26;
        let t29 = real(2.6) * tanh_t25;
        let t30 = real(1.3) * tanh_t24;
        let t31 = real(1.2) * tanh_t22;
        let t32 = Vector([t27, t28, t29, t30, tanh_t23, t31]);
        let dry = t32 * params.dry_scale;

        // -- known dynamics of block 2 (rates) (11) --
        let t33 = M_22 * M_33 - M_23 * M_23;
        let t34 = M_23 * M_13 - M_33 * M_12;
        let t35 = M_12 * M_23 - M_13 * M_22;
        let t36 = real(1.0) / (M_11 * t33 + M_12 * t34 + M_13 * t35);
        let t37 = t33 * t36;
        let t38 = t34 * t36;
        let t39 = t35 * t36;
        let t40 = (M_33 * M_11 - M_13 * M_13) * t36;
        let t41 = (M_13 * M_12 - M_11 * M_23) * t36;
        let t42 = (M_11 * M_22 - M_12 * M_12) * t36;
        let t43 = M_11_2 * v2 + M_11_3 * v3;
        let t44 = t43 * v1;
        let t45 = v2 * v2;
        let t46 = real(2.0) * v2 + v3;
        let t47 = t19 * t46;
        let t48 = t47 * v3;
        let t49 = k_4 * cos_q3;
        let t50 = v2 + real(0.5) * v3;
        let t51 = t49 * t50;
        let t52 = real(0.5) * M_11_2;
        let t53 = v1 * v1;
        let t54 = t51 * v3 - t52 * t53;
        let t55 = real(-0.5) * M_11_3;
        let t56 = t10 * cos_q3;
        let t57 = real(37.2) + t20 * real(0.4318);
        let t58 = pull_2 * s_23;
        let t59 = real(1.02) * s_2;
        let t60 = real(0.25) * c_23;
        let t61 = real(0.028) * s_23;
        let t62 = t61 * sin_q4;
        let t63 = t62 * sin_q5;
        let t64 = s_23 * cos_q4;
        let t65 = c_23 * sin_q5 + t64 * cos_q5;
        let t66 = real(-0.028) * t65;
        let t67 = t55 * t53 - t56 * t45 + (t60 - t58);
        let t68 = Vector([
            t44 + M_12_2 * t45 + t48,
            t54 + (-t57 * c_2 - t58 + t59),
            t67,
            t63,
            t66,
            real(0.0),
        ]);
        let t69 = t68 + dry;
        // F_2(x_1 .. x_2)
        let F2 = Vector([
            -t37 * t69[0] - t38 * t69[1] - t39 * t69[2],
            -t38 * t69[0] - t40 * t69[1] - t41 * t69[2],
            -t39 * t69[0] - t41 * t69[1] - t42 * t69[2],
            real(-5.0) * t69[3],
            real(-5.555555555555555) * t69[4],
            real(-5.2631578947368425) * t69[5],
        ]);
        LyapunovValues1 {
            k_2,
            cos_q3,
            cos_q4,
            cos_q5,
            c_2,
            c_23,
            t4,
            k_3,
            sin_q3,
            sin_q4,
            sin_q5,
            s_23,
            s_2,
            t5,
            k_4,
            t6,
            M_11,
            k_5,
            t8,
            k_7,
            t9,
            M_12,
            M_13,
            M_22,
            t10,
            M_23,
            M_33,
            t37,
            t38,
            t39,
            t40,
            t41,
            t42,
            t11,
            t12,
            t13,
            t14,
            t16,
            t17,
            M_11_2,
            v2,
            M_11_3,
            v3,
            t43,
            v1,
            t44,
            t18,
            t19,
            t45,
            t46,
            t47,
            t48,
            t49,
            t50,
            t51,
            t52,
            t53,
            t54,
            t55,
            t56,
            t57,
            pull_2,
            t58,
            t59,
            t60,
            t61,
            t62,
            t63,
            t64,
            t65,
            t66,
            t67,
            tanh_t21,
            tanh_t26,
            tanh_t25,
            tanh_t24,
            tanh_t23,
            tanh_t22,
            t27,
            t28,
            t29,
            t30,
            t31,
            t32,
            F2,
        }
    }
}

/// Part 2 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart2<'a, T: Real> {
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    state: &'a State<T>,
    plant: &'a Params<T>,
    cos_q3: T,
    c_2: T,
    c_23: T,
    t4: T,
    sin_q3: T,
    s_23: T,
    s_2: T,
    t5: T,
    M_11: T,
    M_12: T,
    M_13: T,
    M_22: T,
    M_23: T,
    M_33: T,
    t37: T,
    t38: T,
    t39: T,
    t40: T,
    t41: T,
    t42: T,
    t17: T,
    v2: T,
    v3: T,
    v1: T,
    t45: T,
    t46: T,
    t50: T,
    t53: T,
    t59: T,
    t60: T,
    t63: T,
    t66: T,
    t32: Vector<T, 6>,
    F2: Vector<T, 6>,
}

/// What is used of the values of [`LyapunovPart2`].
struct LyapunovValues2<T: Real> {
    sin_t73: T,
    sin_t71: T,
    cos_t73: T,
    cos_t72: T,
    cos_t71: T,
    c1: Vector<T, 6>,
    G_norm2_1: T,
    h1_dot: Vector<T, 6>,
    e2: Vector<T, 6>,
    s2: T,
    D_hat2: Vector<T, 6>,
    t105: T,
    t106: T,
    t108: T,
    t109: T,
    t110: T,
    t111: T,
    t112: T,
    t113: T,
    u: Vector<T, 6>,
    u_sat: Vector<T, 6>,
    zeta2_dot: Vector<T, 6>,
    t170: T,
    t171: T,
    t172: T,
    t117: T,
    t119: T,
    t120: T,
    t121: T,
    t122: T,
    t124: T,
    t125: T,
    t126: T,
    t127: T,
    t128: T,
    t130: T,
    t131: T,
    t132: T,
    t133: T,
    t144: T,
    t145: T,
    t146: T,
    t147: T,
    t149: T,
    t150: T,
    t151: T,
    t152: T,
    t153: T,
    t154: T,
    t155: T,
    t156: T,
    t157: T,
    t158: T,
    t159: T,
    t160: T,
    t161: T,
    t162: T,
    t164: T,
    t165: T,
    t166: T,
    t167: T,
    x2_flow: Vector<T, 6>,
    t176: T,
    t177: T,
    t178: T,
    t179: T,
    t180: T,
    t181: T,
    D_error2: Vector<T, 6>,
    V: T,
    V_T1_flow: T,
    V_zeta1_flow: T,
    c1_flow: Vector<T, 6>,
    alpha1_flow: Vector<T, 6>,
    V_chi1_flow: T,
}

impl<T: Real> Part for LyapunovPart2<'_, T> {
    type Output = LyapunovValues2<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self {
            t,
            x1,
            x2,
            state,
            plant,
            cos_q3,
            c_2,
            c_23,
            t4,
            sin_q3,
            s_23,
            s_2,
            t5,
            M_11,
            M_12,
            M_13,
            M_22,
            M_23,
            M_33,
            t37,
            t38,
            t39,
            t40,
            t41,
            t42,
            t17,
            v2,
            v3,
            v1,
            t45,
            t46,
            t50,
            t53,
            t59,
            t60,
            t63,
            t66,
            t32,
            F2,
        } = self;
        let real = T::from_f64;

        // -- reference and constraints --
        let t70 = real(1.5) * t;
        let t71 = real(6.0) * t;
        let t72 = real(5.0) * t;
        let t73 = real(4.0) * t;
        let t74 = real(2.0) * t;
        let t75 = Vector([t, t70, t74, t73, t72, t71]);
        let [sin_t, sin_t70, sin_t74, sin_t73, sin_t72, sin_t71] = t75.sin().0;
        let t76 = real(1.0471975511965979) * sin_t70;
        let t77 = t * t;
        let t78 = (real(-0.1) * (t77 * t)).exp();
        let t79 = real(1.0) - t78;
        let t80 = real(0.6981317007977318) * sin_t;
        let t81 = real(0.8726646259971648) * sin_t70;
        let t82 = real(1.0471975511965979) * sin_t74;
        let t83 = t82 * t79;
        let t84 = real(FRAC_PI_4) * sin_t74;
        // y_r(t)
        let y_r = Vector([
            t76 * t79,
            real(-0.5235987755982989) + t80 * t79,
            t81 * t79,
            t83,
            t84 * t79,
            t83,
        ]);
        let [cos_t, cos_t70, cos_t74, cos_t73, cos_t72, cos_t71] = t75.cos().0;
        let t85 = cos_t70 * real(1.5);
        let t86 = real(1.0471975511965979) * t85;
        let t87 = real(-0.1) * (real(3.0) * t77);
        let t88 = t78 * t87;
        let t89 = real(0.6981317007977318) * cos_t;
        let t90 = real(0.8726646259971648) * t85;
        let t91 = cos_t74 * real(2.0);
        let t92 = real(1.0471975511965979) * t91;
        let t93 = t79 * t92 - t82 * t88;
        let t94 = real(FRAC_PI_4) * t91;
        // y_r'
        let y_r_dot = Vector([
            t79 * t86 - t76 * t88,
            t79 * t89 - t80 * t88,
            t79 * t90 - t81 * t88,
            t93,
            t79 * t94 - t84 * t88,
            t93,
        ]);
        let t95 = (real(-2.0) * t).exp();
        // k_1(t)
        let k1 = real(0.3) * t95 + real(0.02);
        // k1'
        let k1_dot = real(0.3) * (t95 * real(-2.0));

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t96 = k1 * k1;
        let t97 = real(1.0) / t96;
        let t98 = s1 * t97;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t98 * t98);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));
        // cos E_1
        let cosE1 = E1.cos();
        let t99 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t99;
        let t100 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t100;

        // -- norms of block 1 --
        // ||G_1||^2
        let G_norm2_1 = real(6.0);

        // -- robust feedback of block 1 (31) --
        let t101 = E1.sin();
        let t102 = t101 * cosE1;
        let t103 = real(1.0) / E1_free;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1
            * (real(3.5) * T::select(E1_free.lt(real(1e-300)), real(1.0), t102 * t103)
                + real(2.0) + t100 * real(3.0));
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t104 = state.zeta1 * real(20.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t104 - y_r_dot + Lam1;
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -bracket1;

        // -- auxiliary system of block 1 (13), erratum 1 --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = state.zeta2 - t104;

        // -- dynamic surface filter of block 1 (33) --
        // h_1' = (alpha_1 - h_1) / Fl_1
        let h1_dot = (alpha1 - state.h1) * real(200.0);

        // -- error variable of block 2 (14) --
        // e_2 = x_2 - h_1 - zeta_2
        let e2 = x2 - state.h1 - state.zeta2;

        // -- barrier of block 2 (23) (26) --
        // s_2 = e_2^T e_2
        let s2 = e2.sum_squares();

        // -- disturbance observer of block 2 (20) --
        // D_hat_2 = th_2 + S_2 x_2
        let D_hat2 = state.th2 + x2 * real(100.0);

        // -- robust feedback of block 2 (63) --
        let t105 = G_norm2_1 * s_c1;
        let t106 = t105 * t105;
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4),
        // G, c, eta_3 of the outer block (38)
        let Lam2 = e2 * (real(50.0) + s2 * real(0.5) + t106 * real(0.25));

        // -- control (64) of block 2 --
        let t107 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = F2 - h1_dot + t107 + D_hat2 + Lam2;
        let t108 = M_11 * bracket2[0] + M_12 * bracket2[1] + M_13 * bracket2[2];
        let t109 = M_12 * bracket2[0] + M_22 * bracket2[1] + M_23 * bracket2[2];
        let t110 = M_13 * bracket2[0] + M_23 * bracket2[1] + M_33 * bracket2[2];
        let t111 = real(0.2) * bracket2[3];
        let t112 = real(0.18) * bracket2[4];
        let t113 = real(0.19) * bracket2[5];
        let t114 = Vector([t108, t109, t110, t111, t112, t113]);
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t114;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 6>::from_f64([-97.6, -186.4, -89.4, -24.2, -20.1, -21.3]))
            .min(Vector::<T, 6>::from_f64([97.6, 186.4, 89.4, 24.2, 20.1, 21.3]));

        // -- auxiliary system of block 2 (13), erratum 1 --
        let t115 = u_sat + t114;
        let t116 = Vector([
            t37 * t115[0] + t38 * t115[1] + t39 * t115[2],
            t38 * t115[0] + t40 * t115[1] + t41 * t115[2],
            t39 * t115[0] + t41 * t115[1] + t42 * t115[2],
            real(5.0) * t115[3],
            real(5.555555555555555) * t115[4],
            real(5.2631578947368425) * t115[5],
        ]);
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = t116 - t107;

        // -- true dynamics of block 2 (rates) (11) --
        let t117 = real(1.38) + plant.load * real(0.18645124000000002);
        let t118 = plant.load * real(0.18757560999999998);
        let t119 = real(0.3) + t118;
        let t120 = real(0.744) + real(2.0) * plant.load * real(0.4318) * real(0.4331);
        let t121 = t120 * c_2;
        let t122 = real(2.57) + plant.load * real(0.022530010000000003) + t117 * t4
            + t119 * t5 + t121 * s_23;
        let t123 = plant.load * real(0.1501);
        let t124 = real(0.69) + t123 * real(0.4318);
        let t125 = real(0.0238) * c_2;
        let t126 = real(0.134) + t123 * real(0.4331);
        let t127 = t126 * c_23;
        let t128 = t124 * s_2 + t125 - t127;
        let t129 = -t126 * c_23;
        let t130 = real(6.79) + plant.load * real(0.37402685) + t120 * sin_q3;
        let t131 = real(0.5) * t120;
        let t132 = real(0.333) + t118 + t131 * sin_q3;
        let t133 = real(1.16) + t118;
        let t134 = t130 * t133 - t132 * t132;
        let t135 = t132 * t129 - t133 * t128;
        let t136 = t128 * t132 - t129 * t130;
        let t137 = real(1.0) / (t122 * t134 + t128 * t135 + t129 * t136);
        let t138 = t134 * t137;
        let t139 = t135 * t137;
        let t140 = t136 * t137;
        let t141 = (t133 * t122 - t129 * t129) * t137;
        let t142 = (t129 * t128 - t122 * t132) * t137;
        let t143 = (t122 * t130 - t128 * t128) * t137;
        let t144 = real(-2.0) * t117;
        let t145 = t144 * s_2;
        let t146 = real(2.0) * t119;
        let t147 = t146 * s_23;
        let t148 = t147 * c_23;
        let t149 = t145 * c_2 + t148 + t120 * t17;
        let t150 = t148 + t121 * c_23;
        let t151 = t149 * v2 + t150 * v3;
        let t152 = real(0.0238) * s_2;
        let t153 = t126 * s_23;
        let t154 = t124 * c_2 - t152 + t153;
        let t155 = t153 * t46;
        let t156 = t151 * v1 + t154 * t45 + t155 * v3;
        let t157 = t120 * cos_q3;
        let t158 = t157 * t50;
        let t159 = real(0.5) * t149;
        let t160 = t158 * v3 - t159 * t53;
        let t161 = real(-0.5) * t150;
        let t162 = t131 * cos_q3;
        let t163 = plant.load * real(9.81);
        let t164 = real(37.2) + t163 * real(0.4318);
        let t165 = real(8.4) + t163 * real(0.4331);
        let t166 = t165 * s_23;
        let t167 = t161 * t53 - t162 * t45 + (t60 - t166);
        let t168 = Vector([
            t156,
            t160 + (-t164 * c_2 - t166 + t59),
            t167,
            t63,
            t66,
            real(0.0),
        ]);
        let t169 = t168 + t32 * plant.dry_scale;
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            -t138 * t169[0] - t139 * t169[1] - t140 * t169[2],
            -t139 * t169[0] - t141 * t169[1] - t142 * t169[2],
            -t140 * t169[0] - t142 * t169[1] - t143 * t169[2],
            real(-5.0) * t169[3],
            real(-5.555555555555555) * t169[4],
            real(-5.2631578947368425) * t169[5],
        ]);
        // d_2(t)
        let d2 = Vector([
            real(0.2) * sin_t73,
            real(0.2) * cos_t73,
            real(0.5) * sin_t72,
            real(3.0) * (real(1.0) + sin_t71),
            real(3.0) * sin_t71,
            real(3.0) * cos_t71,
        ]);
        let t170 = real(5.0) * u_sat[3];
        let t171 = real(5.555555555555555) * u_sat[4];
        let t172 = real(5.2631578947368425) * u_sat[5];
        let t173 = Vector([
            t138 * u_sat[0] + t139 * u_sat[1] + t140 * u_sat[2],
            t139 * u_sat[0] + t141 * u_sat[1] + t142 * u_sat[2],
            t140 * u_sat[0] + t142 * u_sat[1] + t143 * u_sat[2],
            t170,
            t171,
            t172,
        ]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = F2_plant + t173 + d2;

        // -- Lyapunov function of block 1 (23) (52) --
        let t174 = t96 * t96 * real(0.15915494309189535);
        let t175 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t174 * t175;
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + bracket1;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = s2 * s2 * real(0.25);
        let t176 = t138 - t37;
        let t177 = t139 - t38;
        let t178 = t140 - t39;
        let t179 = t141 - t40;
        let t180 = t142 - t41;
        let t181 = t143 - t42;
        let t182 = Vector([
            t176 * u_sat[0] + t177 * u_sat[1] + t178 * u_sat[2],
            t177 * u_sat[0] + t179 * u_sat[1] + t180 * u_sat[2],
            t178 * u_sat[0] + t180 * u_sat[1] + t181 * u_sat[2],
            real(0.0),
            real(0.0),
            real(0.0),
        ]);
        // D_2 = d_2 + model error of block 2
        let D2 = d2 + (F2_plant - F2) + t182;
        // D_2 - D_hat_2
        let D_error2 = D2 - D_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = D_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);

        // -- Lyapunov function (52) --
        // V, sum of the parts above
        let V = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_D2 + V_zeta2;

        // -- Ito generator (2) --
        // e1' along the flow
        let e1_flow = x2 - y_r_dot - zeta1_dot;
        let t183 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t183 + t183;
        let t184 = (t98 + t98) * (s1_flow * t97 - t98 * t97 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t184;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t175
            * (real(4.0) * (t96 * k1) * k1_dot * real(0.15915494309189535))
            + t174 * (E1_flow / t99);
        let t185 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t185 + t185) * real(0.5);
        let t186 = -(real(1.5) * (sin_t70 * real(1.5)));
        let t187 = t86 * t88;
        let t188 = t87 * t88 + t78 * (real(-0.1) * (real(3.0) * (t + t)));
        let t189 = t89 * t88;
        let t190 = t90 * t88;
        let t191 = -(real(2.0) * (sin_t74 * real(2.0)));
        let t192 = t92 * t88;
        let t193 = t79 * (real(1.0471975511965979) * t191) - t192 - (t192 + t82 * t188);
        let t194 = t94 * t88;
        // y_r''
        let y_r_dot2 = Vector([
            t79 * (real(1.0471975511965979) * t186) - t187 - (t187 + t76 * t188),
            t79 * (real(0.6981317007977318) * -sin_t) - t189 - (t189 + t80 * t188),
            t79 * (real(0.8726646259971648) * t186) - t190 - (t190 + t81 * t188),
            t193,
            t79 * (real(FRAC_PI_4) * t191) - t194 - (t194 + t84 * t188),
            t193,
        ]);
        let t195 = real(1.5697963267948967) * t103;
        let t196 = real(1.0).lt(t195);
        let t197 = T::select(t196, real(1.0), t195);
        let t198 = T::select(E1.eq(real(0.0)), real(1.0), t102 / E1);
        let t199 = t197 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t196, real(0.0), -(t198 * (t195 * t103 * E1_free_flow)));
        let t200 = t198 * t197;
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            real(3.5) * e1[0] * t199 + t200 * (real(3.5) * e1_flow[0])
                + real(2.0) * e1_flow[0],
            real(3.5) * e1[1] * t199 + t200 * (real(3.5) * e1_flow[1])
                + real(2.0) * e1_flow[1],
            real(3.5) * e1[2] * t199 + t200 * (real(3.5) * e1_flow[2])
                + real(2.0) * e1_flow[2],
            real(3.5) * e1[3] * t199 + t200 * (real(3.5) * e1_flow[3])
                + real(2.0) * e1_flow[3],
            real(3.5) * e1[4] * t199 + t200 * (real(3.5) * e1_flow[4])
                + real(2.0) * e1_flow[4],
            real(3.5) * e1[5] * t199 + t200 * (real(3.5) * e1_flow[5])
                + real(2.0) * e1_flow[5],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(t101 * E1_flow);
        let t201 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t201 + e1_flow * t100;
        // Lam1_filter' along the flow
        let Lam1_filter_flow = c1_flow * real(3.0);
        // Lam1' along the flow
        let Lam1_flow = Lam0_1_flow + Lam1_filter_flow;
        // bracket1' along the flow
        let bracket1_flow = zeta1_dot * real(20.0) - y_r_dot2 + Lam1_flow;
        // alpha1' along the flow
        let alpha1_flow = -bracket1_flow;
        // chi1' along the flow
        let chi1_flow = h1_dot + bracket1_flow;
        let t202 = chi1_flow.dot(chi1);
        // V_chi1' along the flow
        let V_chi1_flow = (t202 + t202) * real(0.5);
        LyapunovValues2 {
            sin_t73,
            sin_t71,
            cos_t73,
            cos_t72,
            cos_t71,
            c1,
            G_norm2_1,
            h1_dot,
            e2,
            s2,
            D_hat2,
            t105,
            t106,
            t108,
            t109,
            t110,
            t111,
            t112,
            t113,
            u,
            u_sat,
            zeta2_dot,
            t170,
            t171,
            t172,
            t117,
            t119,
            t120,
            t121,
            t122,
            t124,
            t125,
            t126,
            t127,
            t128,
            t130,
            t131,
            t132,
            t133,
            t144,
            t145,
            t146,
            t147,
            t149,
            t150,
            t151,
            t152,
            t153,
            t154,
            t155,
            t156,
            t157,
            t158,
            t159,
            t160,
            t161,
            t162,
            t164,
            t165,
            t166,
            t167,
            x2_flow,
            t176,
            t177,
            t178,
            t179,
            t180,
            t181,
            D_error2,
            V,
            V_T1_flow,
            V_zeta1_flow,
            c1_flow,
            alpha1_flow,
            V_chi1_flow,
        }
    }
}
