// SHA-256 of the text below: 1bfe7b87628b8595a4ed998bbbdbcecf45db0d721072100f2a6e60cce0186517
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 850 additions, 1072 multiplications, 15 divisions, 0 square roots, 35 elementary functions, 38 comparisons and selections

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
/// Operations: 850 additions, 1072 multiplications, 15 divisions, 0 square roots, 35 elementary
/// functions, 38 comparisons and selections.
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
        k_4,
        sin_q3,
        sin_q4,
        sin_q5,
        s_23,
        s_2,
        M_22,
        M_33,
        t4,
        M_23,
        A_11,
        k_2,
        cos_q3,
        cos_q4,
        cos_q5,
        c_2,
        c_23,
        t5,
        k_3,
        t6,
        t7,
        M_11,
        t11,
        k_5,
        t9,
        k_7,
        t10,
        t34,
        t35,
        t36,
        t37,
        t38,
        t12,
        t39,
        t40,
        t41,
        t13,
        t14,
        t15,
        t16,
        t18,
        t19,
        M_11_2,
        v2,
        M_11_3,
        v3,
        t42,
        v1,
        t43,
        t20,
        t21,
        t44,
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
        pull_2,
        t57,
        t58,
        t59,
        t60,
        t61,
        t62,
        t63,
        t64,
        t65,
        tanh_t23,
        tanh_t28,
        tanh_t27,
        tanh_t26,
        tanh_t25,
        tanh_t24,
        t29,
        t30,
        t31,
        t32,
        F2,
    } = T::outlined(LyapunovPart1 { x1, x2, params });
    let LyapunovValues2 {
        sin_t71,
        sin_t69,
        cos_t71,
        cos_t70,
        cos_t69,
        c1,
        G_norm2_1,
        h1_dot,
        e2,
        s2,
        D_hat2,
        t103,
        t104,
        t106,
        t107,
        u,
        u_sat,
        zeta2_dot,
        t173,
        t174,
        t175,
        t114,
        t115,
        t117,
        t118,
        t119,
        t120,
        t121,
        t122,
        t123,
        t124,
        t125,
        t127,
        t128,
        t129,
        t130,
        t131,
        t133,
        t135,
        t141,
        t143,
        t145,
        t147,
        t148,
        t149,
        t150,
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
        t163,
        t164,
        t165,
        t167,
        t168,
        t169,
        t170,
        x2_flow,
        t179,
        t180,
        t181,
        t182,
        t183,
        t184,
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
        sin_q3,
        s_23,
        s_2,
        cos_q3,
        c_2,
        c_23,
        t5,
        t6,
        t34,
        t35,
        t36,
        t38,
        t39,
        t41,
        t19,
        v2,
        v3,
        v1,
        t44,
        t45,
        t49,
        t52,
        t58,
        t59,
        t62,
        t64,
        t32,
        F2,
    });

    // -- Ito generator (2) --
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t206 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t206 + t206;
    let t207 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t207 + t207) * real(0.25);
    let t208 = real(3.0) * (cos_t69 * real(6.0));
    // d2'
    let d2_dot = Vector([
        real(0.2) * (cos_t71 * real(4.0)),
        -(real(0.2) * (sin_t71 * real(4.0))),
        real(0.5) * (cos_t70 * real(5.0)),
        t208,
        t208,
        -(real(3.0) * (sin_t69 * real(6.0))),
    ]);
    let t209 = t163 + (t58 - (t167 * c_2 + t169)) + plant.dry_scale * t30;
    let t210 = cos_q3 * x2[2];
    let t211 = t118 * t210;
    let t212 = x2[1] + x2[2];
    let t213 = s_23 * t212;
    let t214 = t129 * t213;
    let t215 = c_2 * x2[1];
    let t216 = s_2 * x2[1];
    let t217 = real(0.0238) * t216;
    let t218 = t127 * t215 - t217 + t214;
    let t219 = t130 * t211 - t119 * t214 + t117 * t218;
    let t220 = t130 * t119 + t133;
    let t221 = t135 + t130 * t115;
    let t222 = real(1.0) / (t125 - t131 * t220 - t130 * t221);
    let t223 = t220 * t222;
    let t224 = c_23 * t212;
    let t225 = (s_23 + s_23) * t224;
    let t226 = (c_2 + c_2) * t216;
    let t227 = t114 * t216;
    let t228 = t122 * t225 - t121 * t226 + (t123 * t224 - s_23 * t227);
    let t229 = t114 * t210;
    let t230 = t117 * t229 - (t119 + t119) * t211;
    let t231 = t120 * t228 + t124 * t230 - (t220 * t218 + t131 * t219);
    let t232 = t119 * t218 + t131 * t211 + (t130 * t229 - t115 * t214);
    let t233 = t231 - (t130 * t232 - t221 * t214);
    let t234 = t219 * t222 - t223 * t222 * t233;
    let t235 = x2_flow[1] + real(0.5) * x2_flow[2];
    let t236 = sin_q3 * x2[2];
    let t237 = v3 * (t160 * t235 - t49 * (t114 * t236)) + t161 * x2_flow[2];
    let t238 = c_23 * (t149 * t224) - t150 * t213;
    let t239 = t18.sin() * (real(2.0) * x2[1] + x2[2]);
    let t240 = c_2 * (t147 * t215) - t148 * t216 + t238 - t114 * t239;
    let t241 = (v1 + v1) * x2_flow[0];
    let t242 = t237 - (t52 * (real(0.5) * t240) + t162 * t241);
    let t243 = real(1.02) * t215;
    let t244 = t168 * t224;
    let t245 = real(5.5)
        * ((real(1.0) - tanh_t28 * tanh_t28) * (x2_flow[1] * real(10.0)));
    let t246 = t242 + (t243 - (t244 - t167 * t216)) + plant.dry_scale * t245;
    let t247 = t159 + plant.dry_scale * t29;
    let t248 = t120 * t222;
    let t249 = t230 * t222 - t248 * t222 * t233;
    let t250 = t238 - (c_23 * t227 + t123 * t213);
    let t251 = v1 * (v2 * t240 + t152 * x2_flow[1] + (v3 * t250 + t153 * x2_flow[2]));
    let t252 = t129 * t224;
    let t253 = real(0.0238) * t215;
    let t254 = (v2 + v2) * x2_flow[1];
    let t255 = t44 * (t252 - (t127 * t216 + t253)) + t157 * t254;
    let t256 = real(2.0) * x2_flow[1] + x2_flow[2];
    let t257 = v3 * (t45 * t252 + t156 * t256) + t158 * x2_flow[2];
    let t258 = real(6.3)
        * ((real(1.0) - tanh_t23 * tanh_t23) * (x2_flow[0] * real(10.0)));
    let t259 = t251 + t154 * x2_flow[0] + t255 + t257 + plant.dry_scale * t258;
    let t260 = t209 * t234 + t223 * t246 - (t247 * t249 + t248 * t259);
    let t261 = t170 + plant.dry_scale * t31;
    let t262 = t221 * t222;
    let t263 = t232 * t222 - t262 * t222 * t233;
    let t264 = t165 * t254 - t44 * (t118 * t236);
    let t265 = real(0.25) * t213;
    let t266 = t52 * (real(-0.5) * t250) + t164 * t241 - t264 - (t265 + t244);
    let t267 = real(2.6)
        * ((real(1.0) - tanh_t27 * tanh_t27) * (x2_flow[2] * real(10.0)));
    let t268 = t266 + plant.dry_scale * t267;
    let t269 = (t141 - t130 * t130) * t222;
    let t270 = (t117 * t228 + (t130 + t130) * t214) * t222 - t269 * t222 * t233;
    let t271 = t247 * t234 + t223 * t259 - (t209 * t270 + t269 * t246);
    let t272 = (t130 * t218 - t131 * t214 + (t119 * t228 + t124 * t211)) * t222;
    let t273 = (t131 * t130 + t143) * t222;
    let t274 = t272 - t273 * t222 * t233;
    let t275 = t209 * t274 + t273 * t246 - (t247 * t263 + t262 * t259);
    let t276 = (t115 * t228 + t124 * t229 - (t131 + t131) * t218) * t222;
    let t277 = t145 * t222;
    let t278 = t276 - t277 * t222 * t233;
    let t279 = cos_q5 * x2[4];
    let t280 = sin_q5 * (sin_q4 * (real(0.028) * t224) + t60 * (cos_q4 * x2[3]))
        + t61 * t279;
    let t281 = real(1.3)
        * ((real(1.0) - tanh_t26 * tanh_t26) * (x2_flow[3] * real(10.0)));
    let t282 = (real(1.0) - tanh_t25 * tanh_t25) * (x2_flow[4] * real(10.0));
    let t283 = cos_q5 * (cos_q4 * t224 - s_23 * (sin_q4 * x2[3]))
        - t63 * (sin_q5 * x2[4]);
    let t284 = real(0.028) * (c_23 * t279 - sin_q5 * t213 + t283);
    let t285 = real(1.2)
        * ((real(1.0) - tanh_t24 * tanh_t24) * (x2_flow[5] * real(10.0)));
    // F2_plant' along the flow
    let F2_plant_flow = Vector([
        t260 - (t261 * t263 + t262 * t268),
        t271 + (t261 * t274 + t273 * t268),
        t275 - (t261 * t278 + t277 * t268),
        -((t280 + plant.dry_scale * t281) * real(5.0)),
        -((plant.dry_scale * t282 - t284) * real(5.555555555555555)),
        -(plant.dry_scale * t285 * real(5.2631578947368425)),
    ]);
    let t286 = t53 + (t58 - (t56 * c_2 + t57)) + params.dry_scale * t30;
    let t287 = t4 * t210;
    let t288 = k_7 * t213;
    let t289 = k_5 * t215 - t217 + t288;
    let t290 = t10 * t287 - M_23 * t288 + M_33 * t289;
    let t291 = t9 + t128 - t10;
    let t292 = t10 * M_23 + t291 * M_33;
    let t293 = t291 * M_23 + t10 * M_22;
    let t294 = real(1.0) / (t11 - t291 * t292 - t10 * t293);
    let t295 = t292 * t294;
    let t296 = k_4 * t216;
    let t297 = k_3 * t225 - k_2 * t226 + (t7 * t224 - s_23 * t296);
    let t298 = k_4 * t210;
    let t299 = M_33 * t298 - (M_23 + M_23) * t287;
    let t300 = A_11 * t297 + M_11 * t299 - (t292 * t289 + t291 * t290);
    let t301 = M_23 * t289 + t291 * t287 + (t10 * t298 - M_22 * t288);
    let t302 = t300 - (t10 * t301 - t293 * t288);
    let t303 = t290 * t294 - t295 * t294 * t302;
    let t304 = v3 * (t48 * t235 - t49 * (k_4 * t236)) + t50 * x2_flow[2];
    let t305 = c_23 * (t15 * t224) - t16 * t213;
    let t306 = c_2 * (t13 * t215) - t14 * t216 + t305 - k_4 * t239;
    let t307 = t304 - (t52 * (real(0.5) * t306) + t51 * t241);
    let t308 = pull_2 * t224;
    let t309 = t307 + (t243 - (t308 - t56 * t216)) + params.dry_scale * t245;
    let t310 = t20 - t155 + t21;
    let t311 = t43 + t310 * t44 + t47 + params.dry_scale * t29;
    let t312 = A_11 * t294;
    let t313 = t299 * t294 - t312 * t294 * t302;
    let t314 = t305 - (c_23 * t296 + t7 * t213);
    let t315 = v1
        * (v2 * t306 + M_11_2 * x2_flow[1] + (v3 * t314 + M_11_3 * x2_flow[2]));
    let t316 = k_7 * t224;
    let t317 = t44 * (t316 - (k_5 * t216 + t253)) + t310 * t254;
    let t318 = v3 * (t45 * t316 + t21 * t256) + t46 * x2_flow[2];
    let t319 = t315 + t42 * x2_flow[0] + t317 + t318 + params.dry_scale * t258;
    let t320 = t286 * t303 + t295 * t309 - (t311 * t313 + t312 * t319);
    let t321 = t65 + params.dry_scale * t31;
    let t322 = t293 * t294;
    let t323 = t301 * t294 - t322 * t294 * t302;
    let t324 = t55 * t254 - t44 * (t4 * t236);
    let t325 = t52 * (real(-0.5) * t314) + t54 * t241 - t324 - (t265 + t308);
    let t326 = t325 + params.dry_scale * t267;
    let t327 = (t37 - t10 * t10) * t294;
    let t328 = (M_33 * t297 + (t10 + t10) * t288) * t294 - t327 * t294 * t302;
    let t329 = t311 * t303 + t295 * t319 - (t286 * t328 + t327 * t309);
    let t330 = (t10 * t289 - t291 * t288 + (M_23 * t297 + M_11 * t287)) * t294;
    let t331 = (t291 * t10 + t12) * t294;
    let t332 = t330 - t331 * t294 * t302;
    let t333 = t286 * t332 + t331 * t309 - (t311 * t323 + t322 * t319);
    let t334 = (M_22 * t297 + M_11 * t298 - (t291 + t291) * t289) * t294;
    let t335 = (t40 - t291 * t291) * t294;
    let t336 = t334 - t335 * t294 * t302;
    // F2' along the flow
    let F2_flow = Vector([
        t320 - (t321 * t323 + t322 * t326),
        t329 + (t321 * t332 + t331 * t326),
        t333 - (t321 * t336 + t335 * t326),
        -((t280 + params.dry_scale * t281) * real(5.0)),
        -((params.dry_scale * t282 - t284) * real(5.555555555555555)),
        -(params.dry_scale * t285 * real(5.2631578947368425)),
    ]);
    // h1_dot' along the flow
    let h1_dot_flow = (alpha1_flow - h1_dot) * real(200.0);
    let t337 = Vector([
        t34 * u_sat[0] + t35 * u_sat[1] + t36 * u_sat[2],
        t35 * u_sat[0] + t38 * u_sat[1] + t39 * u_sat[2],
        t36 * u_sat[0] + t39 * u_sat[1] + t41 * u_sat[2],
        t173,
        t174,
        t175,
    ]);
    // D_hat2' along the flow
    let D_hat2_flow = x2_flow * real(100.0) - (D_hat2 + F2 + t337) * real(100.0);
    // Lam0_2' along the flow
    let Lam0_2_flow = e2_flow * real(50.0);
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    // Lam2_disturbance' along the flow
    let Lam2_disturbance_flow = c2_flow * real(0.5);
    let t338 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t338 + t338;
    let t339 = (t103 + t103) * (G_norm2_1 * s_c1_flow);
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * t339 + t104 * e2_flow[0]) * real(0.25),
        (e2[1] * t339 + t104 * e2_flow[1]) * real(0.25),
        (e2[2] * t339 + t104 * e2_flow[2]) * real(0.25),
        (e2[3] * t339 + t104 * e2_flow[3]) * real(0.25),
        (e2[4] * t339 + t104 * e2_flow[4]) * real(0.25),
        (e2[5] * t339 + t104 * e2_flow[5]) * real(0.25),
    ]);
    // Lam2' along the flow
    let Lam2_flow = Lam0_2_flow + Lam2_disturbance_flow + Lam2_coupling_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow - h1_dot_flow + zeta2_dot * real(50.0) + D_hat2_flow
        + Lam2_flow;
    let t340 = Vector([
        t313 * t107[0] - t303 * t107[1] + t323 * t107[2],
        t328 * t107[1] - t303 * t107[0] - t332 * t107[2],
        t323 * t107[0] - t332 * t107[1] + t336 * t107[2],
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    let t341 = bracket2_flow - t340;
    let t342 = t106.solve(Vector([t341[0], t341[1], t341[2]]));
    let t343 = t341[3] * real(0.2);
    let t344 = t341[4] * real(0.18);
    let t345 = t341[5] * real(0.18999999999999997);
    // u' along the flow
    let u_flow = -Vector([t342[0], t342[1], t342[2], t343, t344, t345]);
    let t346 = real(-97.6).lt(u[0]);
    let t347 = T::select(
        T::select(t346, u[0], real(-97.6)).lt(real(97.6)),
        T::select(t346, u_flow[0], real(0.0)),
        real(0.0),
    );
    let t348 = real(-186.4).lt(u[1]);
    let t349 = T::select(
        T::select(t348, u[1], real(-186.4)).lt(real(186.4)),
        T::select(t348, u_flow[1], real(0.0)),
        real(0.0),
    );
    let t350 = real(-89.4).lt(u[2]);
    let t351 = T::select(
        T::select(t350, u[2], real(-89.4)).lt(real(89.4)),
        T::select(t350, u_flow[2], real(0.0)),
        real(0.0),
    );
    let t352 = t303 - t234;
    let t353 = t263 - t323;
    let t354 = t332 - t274;
    let t355 = (t249 - t313) * u_sat[0] + t352 * u_sat[1] + t353 * u_sat[2];
    let t356 = t352 * u_sat[0] + (t270 - t328) * u_sat[1] + t354 * u_sat[2];
    let t357 = t353 * u_sat[0] + t354 * u_sat[1] + (t278 - t336) * u_sat[2];
    let t358 = Vector([
        t355 + (t179 * t347 + t180 * t349 + t181 * t351),
        t356 + (t180 * t347 + t182 * t349 + t183 * t351),
        t357 + (t181 * t347 + t183 * t349 + t184 * t351),
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    // D2' along the flow
    let D2_flow = d2_dot + (F2_plant_flow - F2_flow) + t358;
    // D_error2' along the flow
    let D_error2_flow = D2_flow - D_hat2_flow;
    let t359 = D_error2_flow.dot(D_error2);
    // V_D2' along the flow
    let V_D2_flow = (t359 + t359) * real(0.5);
    let t360 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t360 + t360) * real(0.5);
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
    k_4: T,
    sin_q3: T,
    sin_q4: T,
    sin_q5: T,
    s_23: T,
    s_2: T,
    M_22: T,
    M_33: T,
    t4: T,
    M_23: T,
    A_11: T,
    k_2: T,
    cos_q3: T,
    cos_q4: T,
    cos_q5: T,
    c_2: T,
    c_23: T,
    t5: T,
    k_3: T,
    t6: T,
    t7: T,
    M_11: T,
    t11: T,
    k_5: T,
    t9: T,
    k_7: T,
    t10: T,
    t34: T,
    t35: T,
    t36: T,
    t37: T,
    t38: T,
    t12: T,
    t39: T,
    t40: T,
    t41: T,
    t13: T,
    t14: T,
    t15: T,
    t16: T,
    t18: T,
    t19: T,
    M_11_2: T,
    v2: T,
    M_11_3: T,
    v3: T,
    t42: T,
    v1: T,
    t43: T,
    t20: T,
    t21: T,
    t44: T,
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
    pull_2: T,
    t57: T,
    t58: T,
    t59: T,
    t60: T,
    t61: T,
    t62: T,
    t63: T,
    t64: T,
    t65: T,
    tanh_t23: T,
    tanh_t28: T,
    tanh_t27: T,
    tanh_t26: T,
    tanh_t25: T,
    tanh_t24: T,
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
        let k_8 = real(6.79) + params.load * real(0.37402685);
        let k_4 = real(0.744) + real(2.0) * params.load * real(0.4318) * real(0.4331);
        let q3 = x1[2];
        let q5 = x1[4];
        let q4 = x1[3];
        let q2 = x1[1];
        let t1 = q2 + q3;
        let t2 = Vector([t1, q2, q3, q4, q5]);
        let [sin_t1, sin_q2, sin_q3, sin_q4, sin_q5] = t2.sin().0;
        let s_23 = sin_t1;
        let s_2 = sin_q2;
        let M_22 = k_8 + k_4 * sin_q3;
        let t3 = params.load * real(0.18757560999999998);
        let M_33 = real(1.16) + t3;
        let k_9 = real(0.333) + t3;
        let t4 = real(0.5) * k_4;
        let M_23 = k_9 + t4 * sin_q3;
        let A_11 = M_22 * M_33 - M_23 * M_23;
        let k_1 = real(2.57) + params.load * real(0.022530010000000003);
        let k_2 = real(1.38) + params.load * real(0.18645124000000002);
        let [cos_t1, cos_q2, cos_q3, cos_q4, cos_q5] = t2.cos().0;
        let c_2 = cos_q2;
        let c_23 = cos_t1;
        let k_3 = real(0.3) + t3;
        let t5 = c_2 * c_2;
        let t6 = s_23 * s_23;
        let t7 = k_4 * c_2;
        let M_11 = k_1 + k_2 * t5 + k_3 * t6 + t7 * s_23;
        let t8 = params.load * real(0.1501);
        let k_5 = real(0.69) + t8 * real(0.4318);
        let k_6 = real(0.0238);
        let k_7 = real(0.134) + t8 * real(0.4331);
        let t9 = k_5 * s_2;
        let t10 = k_7 * c_23;
        let M_12 = t9 + k_6 * c_2 - t10;
        let M_13 = -k_7 * c_23;
        let A_12 = M_13 * M_23 - M_12 * M_33;
        let A_13 = M_12 * M_23 - M_13 * M_22;
        let t11 = M_11 * A_11;
        let det_M = t11 + M_12 * A_12 + M_13 * A_13;
        let t12 = M_11 * M_23;
        let A_23 = M_12 * M_13 - t12;
        let t13 = real(-2.0) * k_2;
        let t14 = t13 * s_2;
        let t15 = real(2.0) * k_3;
        let t16 = t15 * s_23;
        let t17 = t16 * c_23;
        let t18 = real(2.0) * q2 + q3;
        let t19 = t18.cos();
        let M_11_2 = t14 * c_2 + t17 + k_4 * t19;
        let v2 = x2[1];
        let M_11_3 = t17 + t7 * c_23;
        let v3 = x2[2];
        let v1 = x2[0];
        let t20 = k_5 * c_2;
        let t21 = k_7 * s_23;
        let M_12_2 = t20 - k_6 * s_2 + t21;
        let t22 = params.load * real(9.81);
        let pull_2 = real(8.4) + t22 * real(0.4331);
        let v6 = x2[5];
        let v5 = x2[4];
        let v4 = x2[3];
        let t23 = v1 * real(10.0);
        let t24 = v6 * real(10.0);
        let t25 = v5 * real(10.0);
        let t26 = v4 * real(10.0);
        let t27 = v3 * real(10.0);
        let t28 = v2 * real(10.0);
        let [tanh_t23, tanh_t28, tanh_t27, tanh_t26, tanh_t25, tanh_t24] = Vector([
                t23,
                t28,
                t27,
                t26,
                t25,
                t24,
            ])
            .tanh()
            .0;
        let t29 = real(6.3) * tanh_t23;
        let t30 = real(5.5) * tanh_t28;
        let t31 = real(2.6) * tanh_t27;
        let t32 = Vector([
            t29,
            t30,
            t31,
            real(1.3) * tanh_t26,
            tanh_t25,
            real(1.2) * tanh_t24,
        ]);
        let dry = t32 * params.dry_scale;

        // -- known dynamics of block 2 (rates) (11) --
        let t33 = real(1.0) / det_M;
        let t34 = A_11 * t33;
        let t35 = A_12 * t33;
        let t36 = A_13 * t33;
        let t37 = M_11 * M_33;
        let t38 = (t37 - M_13 * M_13) * t33;
        let t39 = A_23 * t33;
        let t40 = M_11 * M_22;
        let t41 = (t40 - M_12 * M_12) * t33;
        let t42 = M_11_2 * v2 + M_11_3 * v3;
        let t43 = t42 * v1;
        let t44 = v2 * v2;
        let t45 = real(2.0) * v2 + v3;
        let t46 = t21 * t45;
        let t47 = t46 * v3;
        let t48 = k_4 * cos_q3;
        let t49 = v2 + real(0.5) * v3;
        let t50 = t48 * t49;
        let t51 = real(0.5) * M_11_2;
        let t52 = v1 * v1;
        let t53 = t50 * v3 - t51 * t52;
        let t54 = real(-0.5) * M_11_3;
        let t55 = t4 * cos_q3;
        let t56 = real(37.2) + t22 * real(0.4318);
        let t57 = pull_2 * s_23;
        let t58 = real(1.02) * s_2;
        let t59 = real(0.25) * c_23;
        let t60 = real(0.028) * s_23;
        let t61 = t60 * sin_q4;
        let t62 = t61 * sin_q5;
        let t63 = s_23 * cos_q4;
        let t64 = real(-0.028) * (c_23 * sin_q5 + t63 * cos_q5);
        let t65 = t54 * t52 - t55 * t44 + (t59 - t57);
        let t66 = Vector([
            t43 + M_12_2 * t44 + t47,
            t53 + (-t56 * c_2 - t57 + t58),
            t65,
            t62,
            t64,
            real(0.0),
        ]);
        let t67 = t66 + dry;
        // F_2(x_1 .. x_2)
        let F2 = Vector([
            -t34 * t67[0] - t35 * t67[1] - t36 * t67[2],
            -t35 * t67[0] - t38 * t67[1] - t39 * t67[2],
            -t36 * t67[0] - t39 * t67[1] - t41 * t67[2],
            real(-5.0) * t67[3],
            real(-5.555555555555555) * t67[4],
            real(-5.2631578947368425) * t67[5],
        ]);
        LyapunovValues1 {
            k_4,
            sin_q3,
            sin_q4,
            sin_q5,
            s_23,
            s_2,
            M_22,
            M_33,
            t4,
            M_23,
            A_11,
            k_2,
            cos_q3,
            cos_q4,
            cos_q5,
            c_2,
            c_23,
            t5,
            k_3,
            t6,
            t7,
            M_11,
            t11,
            k_5,
            t9,
            k_7,
            t10,
            t34,
            t35,
            t36,
            t37,
            t38,
            t12,
            t39,
            t40,
            t41,
            t13,
            t14,
            t15,
            t16,
            t18,
            t19,
            M_11_2,
            v2,
            M_11_3,
            v3,
            t42,
            v1,
            t43,
            t20,
            t21,
            t44,
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
            pull_2,
            t57,
            t58,
            t59,
            t60,
            t61,
            t62,
            t63,
            t64,
            t65,
            tanh_t23,
            tanh_t28,
            tanh_t27,
            tanh_t26,
            tanh_t25,
            tanh_t24,
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
    sin_q3: T,
    s_23: T,
    s_2: T,
    cos_q3: T,
    c_2: T,
    c_23: T,
    t5: T,
    t6: T,
    t34: T,
    t35: T,
    t36: T,
    t38: T,
    t39: T,
    t41: T,
    t19: T,
    v2: T,
    v3: T,
    v1: T,
    t44: T,
    t45: T,
    t49: T,
    t52: T,
    t58: T,
    t59: T,
    t62: T,
    t64: T,
    t32: Vector<T, 6>,
    F2: Vector<T, 6>,
}

/// What is used of the values of [`LyapunovPart2`].
struct LyapunovValues2<T: Real> {
    sin_t71: T,
    sin_t69: T,
    cos_t71: T,
    cos_t70: T,
    cos_t69: T,
    c1: Vector<T, 6>,
    G_norm2_1: T,
    h1_dot: Vector<T, 6>,
    e2: Vector<T, 6>,
    s2: T,
    D_hat2: Vector<T, 6>,
    t103: T,
    t104: T,
    t106: Matrix<T, 3, 3>,
    t107: Vector<T, 3>,
    u: Vector<T, 6>,
    u_sat: Vector<T, 6>,
    zeta2_dot: Vector<T, 6>,
    t173: T,
    t174: T,
    t175: T,
    t114: T,
    t115: T,
    t117: T,
    t118: T,
    t119: T,
    t120: T,
    t121: T,
    t122: T,
    t123: T,
    t124: T,
    t125: T,
    t127: T,
    t128: T,
    t129: T,
    t130: T,
    t131: T,
    t133: T,
    t135: T,
    t141: T,
    t143: T,
    t145: T,
    t147: T,
    t148: T,
    t149: T,
    t150: T,
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
    t163: T,
    t164: T,
    t165: T,
    t167: T,
    t168: T,
    t169: T,
    t170: T,
    x2_flow: Vector<T, 6>,
    t179: T,
    t180: T,
    t181: T,
    t182: T,
    t183: T,
    t184: T,
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
            sin_q3,
            s_23,
            s_2,
            cos_q3,
            c_2,
            c_23,
            t5,
            t6,
            t34,
            t35,
            t36,
            t38,
            t39,
            t41,
            t19,
            v2,
            v3,
            v1,
            t44,
            t45,
            t49,
            t52,
            t58,
            t59,
            t62,
            t64,
            t32,
            F2,
        } = self;
        let real = T::from_f64;

        // -- reference and constraints --
        let t68 = real(1.5) * t;
        let t69 = real(6.0) * t;
        let t70 = real(5.0) * t;
        let t71 = real(4.0) * t;
        let t72 = real(2.0) * t;
        let t73 = Vector([t, t68, t72, t71, t70, t69]);
        let [sin_t, sin_t68, sin_t72, sin_t71, sin_t70, sin_t69] = t73.sin().0;
        let t74 = real(1.0471975511965979) * sin_t68;
        let t75 = t * t;
        let t76 = (real(-0.1) * (t75 * t)).exp();
        let t77 = real(1.0) - t76;
        let t78 = real(0.6981317007977318) * sin_t;
        let t79 = real(0.8726646259971648) * sin_t68;
        let t80 = real(1.0471975511965979) * sin_t72;
        let t81 = t80 * t77;
        let t82 = real(FRAC_PI_4) * sin_t72;
        // y_r(t)
        let y_r = Vector([
            t74 * t77,
            real(-0.5235987755982989) + t78 * t77,
            t79 * t77,
            t81,
            t82 * t77,
            t81,
        ]);
        let [cos_t, cos_t68, cos_t72, cos_t71, cos_t70, cos_t69] = t73.cos().0;
        let t83 = cos_t68 * real(1.5);
        let t84 = real(1.0471975511965979) * t83;
        let t85 = real(-0.1) * (real(3.0) * t75);
        let t86 = t76 * t85;
        let t87 = real(0.6981317007977318) * cos_t;
        let t88 = real(0.8726646259971648) * t83;
        let t89 = cos_t72 * real(2.0);
        let t90 = real(1.0471975511965979) * t89;
        let t91 = t77 * t90 - t80 * t86;
        let t92 = real(FRAC_PI_4) * t89;
        // y_r'
        let y_r_dot = Vector([
            t77 * t84 - t74 * t86,
            t77 * t87 - t78 * t86,
            t77 * t88 - t79 * t86,
            t91,
            t77 * t92 - t82 * t86,
            t91,
        ]);
        let t93 = (real(-2.0) * t).exp();
        // k_1(t)
        let k1 = real(0.3) * t93 + real(0.02);
        // k1'
        let k1_dot = real(0.3) * (t93 * real(-2.0));

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t94 = k1 * k1;
        let t95 = real(1.0) / t94;
        let t96 = s1 * t95;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t96 * t96);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));
        // cos E_1
        let cosE1 = E1.cos();
        let t97 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t97;
        let t98 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t98;

        // -- norms of block 1 --
        // ||G_1||^2
        let G_norm2_1 = real(6.0);

        // -- robust feedback of block 1 (31) (63) --
        let t99 = E1.sin();
        let t100 = t99 * cosE1;
        let t101 = real(1.0) / E1_free;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1
            * (real(3.5) * T::select(E1_free.lt(real(1e-300)), real(1.0), t100 * t101)
                + real(2.0) + t98 * real(3.0));
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t102 = state.zeta1 * real(20.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t102 - y_r_dot + Lam1;
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -bracket1;

        // -- auxiliary system of block 1 (13) (E1) --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = state.zeta2 - t102;

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

        // -- robust feedback of block 2 (31) (63) --
        let t103 = G_norm2_1 * s_c1;
        let t104 = t103 * t103;
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4),
        // G, c, eta_3 of the outer block (38)
        let Lam2 = e2 * (real(50.0) + s2 * real(0.5) + t104 * real(0.25));

        // -- control (64) of block 2 --
        let t105 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = F2 - h1_dot + t105 + D_hat2 + Lam2;
        let t106 = Matrix::rows([[t34, t35, t36], [t35, t38, t39], [t36, t39, t41]]);
        let t107 = t106.solve(Vector([bracket2[0], bracket2[1], bracket2[2]]));
        let t108 = bracket2[3] * real(0.2);
        let t109 = bracket2[4] * real(0.18);
        let t110 = bracket2[5] * real(0.18999999999999997);
        let t111 = Vector([t107[0], t107[1], t107[2], t108, t109, t110]);
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t111;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 6>::from_f64([-97.6, -186.4, -89.4, -24.2, -20.1, -21.3]))
            .min(Vector::<T, 6>::from_f64([97.6, 186.4, 89.4, 24.2, 20.1, 21.3]));

        // -- auxiliary system of block 2 (13) (E1) --
        let t112 = u_sat + t111;
        let t113 = Vector([
            t34 * t112[0] + t35 * t112[1] + t36 * t112[2],
            t35 * t112[0] + t38 * t112[1] + t39 * t112[2],
            t36 * t112[0] + t39 * t112[1] + t41 * t112[2],
            real(5.0) * t112[3],
            real(5.555555555555555) * t112[4],
            real(5.2631578947368425) * t112[5],
        ]);
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = t113 - t105;

        // -- true dynamics of block 2 (rates) (11) --
        let t114 = real(0.744) + real(2.0) * plant.load * real(0.4318) * real(0.4331);
        let t115 = real(6.79) + plant.load * real(0.37402685) + t114 * sin_q3;
        let t116 = plant.load * real(0.18757560999999998);
        let t117 = real(1.16) + t116;
        let t118 = real(0.5) * t114;
        let t119 = real(0.333) + t116 + t118 * sin_q3;
        let t120 = t115 * t117 - t119 * t119;
        let t121 = real(1.38) + plant.load * real(0.18645124000000002);
        let t122 = real(0.3) + t116;
        let t123 = t114 * c_2;
        let t124 = real(2.57) + plant.load * real(0.022530010000000003) + t121 * t5
            + t122 * t6 + t123 * s_23;
        let t125 = t124 * t120;
        let t126 = plant.load * real(0.1501);
        let t127 = real(0.69) + t126 * real(0.4318);
        let t128 = real(0.0238) * c_2;
        let t129 = real(0.134) + t126 * real(0.4331);
        let t130 = t129 * c_23;
        let t131 = t127 * s_2 + t128 - t130;
        let t132 = -t129 * c_23;
        let t133 = t131 * t117;
        let t134 = t132 * t119 - t133;
        let t135 = t131 * t119;
        let t136 = t135 - t132 * t115;
        let t137 = real(1.0) / (t125 + t131 * t134 + t132 * t136);
        let t138 = t120 * t137;
        let t139 = t134 * t137;
        let t140 = t136 * t137;
        let t141 = t124 * t117;
        let t142 = (t141 - t132 * t132) * t137;
        let t143 = t124 * t119;
        let t144 = (t131 * t132 - t143) * t137;
        let t145 = t124 * t115 - t131 * t131;
        let t146 = t145 * t137;
        let t147 = real(-2.0) * t121;
        let t148 = t147 * s_2;
        let t149 = real(2.0) * t122;
        let t150 = t149 * s_23;
        let t151 = t150 * c_23;
        let t152 = t148 * c_2 + t151 + t114 * t19;
        let t153 = t151 + t123 * c_23;
        let t154 = t152 * v2 + t153 * v3;
        let t155 = real(0.0238) * s_2;
        let t156 = t129 * s_23;
        let t157 = t127 * c_2 - t155 + t156;
        let t158 = t156 * t45;
        let t159 = t154 * v1 + t157 * t44 + t158 * v3;
        let t160 = t114 * cos_q3;
        let t161 = t160 * t49;
        let t162 = real(0.5) * t152;
        let t163 = t161 * v3 - t162 * t52;
        let t164 = real(-0.5) * t153;
        let t165 = t118 * cos_q3;
        let t166 = plant.load * real(9.81);
        let t167 = real(37.2) + t166 * real(0.4318);
        let t168 = real(8.4) + t166 * real(0.4331);
        let t169 = t168 * s_23;
        let t170 = t164 * t52 - t165 * t44 + (t59 - t169);
        let t171 = Vector([
            t159,
            t163 + (-t167 * c_2 - t169 + t58),
            t170,
            t62,
            t64,
            real(0.0),
        ]);
        let t172 = t171 + t32 * plant.dry_scale;
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            -t138 * t172[0] - t139 * t172[1] - t140 * t172[2],
            -t139 * t172[0] - t142 * t172[1] - t144 * t172[2],
            -t140 * t172[0] - t144 * t172[1] - t146 * t172[2],
            real(-5.0) * t172[3],
            real(-5.555555555555555) * t172[4],
            real(-5.2631578947368425) * t172[5],
        ]);
        // d_2(t)
        let d2 = Vector([
            real(0.2) * sin_t71,
            real(0.2) * cos_t71,
            real(0.5) * sin_t70,
            real(3.0) * (real(1.0) + sin_t69),
            real(3.0) * sin_t69,
            real(3.0) * cos_t69,
        ]);
        let t173 = real(5.0) * u_sat[3];
        let t174 = real(5.555555555555555) * u_sat[4];
        let t175 = real(5.2631578947368425) * u_sat[5];
        let t176 = Vector([
            t138 * u_sat[0] + t139 * u_sat[1] + t140 * u_sat[2],
            t139 * u_sat[0] + t142 * u_sat[1] + t144 * u_sat[2],
            t140 * u_sat[0] + t144 * u_sat[1] + t146 * u_sat[2],
            t173,
            t174,
            t175,
        ]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = F2_plant + t176 + d2;

        // -- Lyapunov function of block 1 (23) (52) --
        let t177 = t94 * t94 * real(0.15915494309189535);
        let t178 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t177 * t178;
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + bracket1;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = s2 * s2 * real(0.25);
        let t179 = t138 - t34;
        let t180 = t139 - t35;
        let t181 = t140 - t36;
        let t182 = t142 - t38;
        let t183 = t144 - t39;
        let t184 = t146 - t41;
        let t185 = Vector([
            t179 * u_sat[0] + t180 * u_sat[1] + t181 * u_sat[2],
            t180 * u_sat[0] + t182 * u_sat[1] + t183 * u_sat[2],
            t181 * u_sat[0] + t183 * u_sat[1] + t184 * u_sat[2],
            real(0.0),
            real(0.0),
            real(0.0),
        ]);
        // D_2 = d_2 + model error of block 2
        let D2 = d2 + (F2_plant - F2) + t185;
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
        let t186 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t186 + t186;
        let t187 = (t96 + t96) * (s1_flow * t95 - t96 * t95 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t187;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t178
            * (real(4.0) * (t94 * k1) * k1_dot * real(0.15915494309189535))
            + t177 * (E1_flow / t97);
        let t188 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t188 + t188) * real(0.5);
        let t189 = -(real(1.5) * (sin_t68 * real(1.5)));
        let t190 = t84 * t86;
        let t191 = t85 * t86 + t76 * (real(-0.1) * (real(3.0) * (t + t)));
        let t192 = t87 * t86;
        let t193 = t88 * t86;
        let t194 = -(real(2.0) * (sin_t72 * real(2.0)));
        let t195 = t90 * t86;
        let t196 = t77 * (real(1.0471975511965979) * t194) - t195 - (t195 + t80 * t191);
        let t197 = t92 * t86;
        // y_r''
        let y_r_dot2 = Vector([
            t77 * (real(1.0471975511965979) * t189) - t190 - (t190 + t74 * t191),
            t77 * (real(0.6981317007977318) * -sin_t) - t192 - (t192 + t78 * t191),
            t77 * (real(0.8726646259971648) * t189) - t193 - (t193 + t79 * t191),
            t196,
            t77 * (real(FRAC_PI_4) * t194) - t197 - (t197 + t82 * t191),
            t196,
        ]);
        let t198 = real(1.5697963267948967) * t101;
        let t199 = real(1.0).lt(t198);
        let t200 = T::select(t199, real(1.0), t198);
        let t201 = T::select(E1.eq(real(0.0)), real(1.0), t100 / E1);
        let t202 = t200 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t199, real(0.0), -(t201 * (t198 * t101 * E1_free_flow)));
        let t203 = t201 * t200;
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            real(3.5) * e1[0] * t202 + t203 * (real(3.5) * e1_flow[0])
                + real(2.0) * e1_flow[0],
            real(3.5) * e1[1] * t202 + t203 * (real(3.5) * e1_flow[1])
                + real(2.0) * e1_flow[1],
            real(3.5) * e1[2] * t202 + t203 * (real(3.5) * e1_flow[2])
                + real(2.0) * e1_flow[2],
            real(3.5) * e1[3] * t202 + t203 * (real(3.5) * e1_flow[3])
                + real(2.0) * e1_flow[3],
            real(3.5) * e1[4] * t202 + t203 * (real(3.5) * e1_flow[4])
                + real(2.0) * e1_flow[4],
            real(3.5) * e1[5] * t202 + t203 * (real(3.5) * e1_flow[5])
                + real(2.0) * e1_flow[5],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(t99 * E1_flow);
        let t204 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t204 + e1_flow * t98;
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
        let t205 = chi1_flow.dot(chi1);
        // V_chi1' along the flow
        let V_chi1_flow = (t205 + t205) * real(0.5);
        LyapunovValues2 {
            sin_t71,
            sin_t69,
            cos_t71,
            cos_t70,
            cos_t69,
            c1,
            G_norm2_1,
            h1_dot,
            e2,
            s2,
            D_hat2,
            t103,
            t104,
            t106,
            t107,
            u,
            u_sat,
            zeta2_dot,
            t173,
            t174,
            t175,
            t114,
            t115,
            t117,
            t118,
            t119,
            t120,
            t121,
            t122,
            t123,
            t124,
            t125,
            t127,
            t128,
            t129,
            t130,
            t131,
            t133,
            t135,
            t141,
            t143,
            t145,
            t147,
            t148,
            t149,
            t150,
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
            t163,
            t164,
            t165,
            t167,
            t168,
            t169,
            t170,
            x2_flow,
            t179,
            t180,
            t181,
            t182,
            t183,
            t184,
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
