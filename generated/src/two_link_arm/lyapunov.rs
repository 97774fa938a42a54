// SHA-256 of the text below: 77060039e6bb1ad1ae7ca672ea9a4c0b5851f9e966270c17d4543a0529f4a148
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 500 additions, 632 multiplications, 11 divisions, 0 square roots, 13 elementary functions, 20 comparisons and selections

//! `two_link_arm`: Lyapunov function and its generator.
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
use nsv_runtime::real::Real;

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
/// Operations: 500 additions, 632 multiplications, 11 divisions, 0 square roots, 13 elementary
/// functions, 20 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 2>,
    x2: Vector<T, 2>,
    w2: Vector<T, 5>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let t1 = params.m_e * real(0.36);
    let a_1 = real(0.62) + t1 + params.m_e;
    let t2 = params.m_e * real(0.6);
    let a_3 = t2 * real(0.8660254037844386);
    let q2 = x1[1];
    let a_4 = t2 * real(0.5);
    let t3 = q2.cos();
    let t4 = q2.sin();
    let M_11 = a_1 + real(2.0) * a_3 * t3 + real(2.0) * a_4 * t4;
    let a_2 = real(0.25) + t1;
    let M_12 = a_2 + a_3 * t3 + a_4 * t4;
    let M = Matrix::rows([[M_11, M_12], [M_12, a_2]]);
    let coriolis = a_3 * t4 - a_4 * t3;
    let v2 = x2[1];
    let v1 = x2[0];
    let t5 = Vector([-v2 * v1 - (v1 + v2) * v2, v1 * v1]);
    let torque = t5 * coriolis;

    // -- known dynamics of block 2 (rates) (11) --
    let t6 = real(1.0) / (M_11 * a_2 - M_12 * M_12);
    let t7 = -M_12 * t6;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[a_2 * t6, t7], [t7, M_11 * t6]]);

    // -- reference and constraints --
    let t8 = real(2.0) * t;
    let t9 = t8.cos();
    let t10 = real(1.0) - t9;
    // y_r(t)
    let y_r = Vector([real(0.5235987755982989) * t10, real(FRAC_PI_4) * t10]);
    let t11 = t8.sin() * real(2.0);
    // y_r'
    let y_r_dot = Vector([real(0.5235987755982989) * t11, real(FRAC_PI_4) * t11]);
    let t12 = (real(-2.0) * t).exp();
    // k_1(t)
    let k1 = real(0.3) * t12 + real(0.05);
    let t13 = t12 * real(-2.0);
    // k1'
    let k1_dot = real(0.3) * t13;
    // k_2(t)
    let k2 = real(4.0) * t12 + real(1.0);
    // k2'
    let k2_dot = real(4.0) * t13;

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t14 = k1 * k1;
    let t15 = real(1.0) / t14;
    let t16 = s1 * t15;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t16 * t16);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    let t17 = k2 * k2;
    let t18 = real(1.0) / t17;
    let t19 = s2 * t18;
    // pi s_2^2 / (2 k_2^4), before the clamp
    let E2_free = real(FRAC_PI_2) * (t19 * t19);
    // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
    let E2 = E2_free.min(real(1.5697963267948967));
    let t20 = Vector([E1, E2]);
    let [cos_E1, cos_E2] = t20.cos().0;
    // cos E_2
    let cosE2 = cos_E2;
    let t21 = cosE2 * cosE2;
    // 1 / cos^2 E_2
    let sec2E2 = real(1.0) / t21;
    let t22 = s2 * sec2E2;
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * t22;

    // -- barrier of block 1 (23) (26) --
    // cos E_1
    let cosE1 = cos_E1;
    let t23 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t23;
    let t24 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t24;

    // -- robust feedback of block 1 (31) --
    let [sin_E1, sin_E2] = t20.sin().0;
    let t25 = sin_E1 * cosE1;
    let t26 = real(1.0) / E1_free;
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1
        * (real(5.0) * T::select(E1_free.lt(real(1e-300)), real(1.0), t25 * t26)
            + real(4.0) + t24 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t27 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t27 - y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t27;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(50.0);

    // -- MTPN of block 2 (4) (16) --
    // z_2, network inputs
    let z2 = Vector([v1, v2, q2]);
    // P_2 = P_m(z_2), 20 nodes
    let P2 = polynomials::basis2(z2);
    let t28 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t28 * P2;

    // -- disturbance observer of block 2 (49) --
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2
        + Vector([
            real(12.0) * e2[0],
            real(36.0) * e2[0],
            real(8.0) * e2[1],
            real(2.0) * e2[1],
            real(11.0) * e2[1],
        ]);
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([w_hat2[0], w_hat2[2] + w_hat2[3]]);

    // -- robust feedback of block 2 (63) --
    let t29 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t29 * state.eps2;
    let t30 = real(10.0)
        * T::select(
            E2_free.lt(real(1e-300)),
            real(1.0),
            sin_E2 * cosE2 * (real(1.0) / E2_free),
        ) + real(8.0);
    let t31 = t30 + t22 * real(0.9999999999999998) + real(0.5) * sec2E2
        + s_c1 * s_c1 * real(0.25) * t21;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b)
    // (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2 = e2 * t31 + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t32 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = A_hat2 - G2 * torque - h1_dot + t32 + D_hat2 + Lam2;
    let t33 = M * bracket2;
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t33;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 2>::from_f64([-60.0, -30.0]))
        .min(Vector::<T, 2>::from_f64([60.0, 30.0]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = G2 * (u_sat + t33) - t32;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (50) --
    let t34 = Vector([
        real(12.0) * Lam2[0],
        real(36.0) * Lam2[0],
        real(8.0) * Lam2[1],
        real(2.0) * Lam2[1],
        real(11.0) * Lam2[1],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = Vector([
        w_hat2[1],
        real(0.0),
        real(0.0),
        real(3.0) * w_hat2[4],
        real(-3.0) * w_hat2[3],
    ]) + t34;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (t22 * e2.dot(t29) - state.eps2);

    // -- true dynamics of block 2 (rates) (11) --
    let t35 = plant.m_e * real(0.36);
    let t36 = plant.m_e * real(0.6);
    let t37 = t36 * real(0.8660254037844386);
    let t38 = t36 * real(0.5);
    let t39 = real(0.62) + t35 + plant.m_e + real(2.0) * t37 * t3 + real(2.0) * t38 * t4;
    let t40 = real(0.25) + t35;
    let t41 = t40 + t37 * t3 + t38 * t4;
    let t42 = real(1.0) / (t39 * t40 - t41 * t41);
    let t43 = -t41 * t42;
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[t40 * t42, t43], [t43, t39 * t42]]);
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([w2[0], w2[2] + w2[3]]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = Vector([
        w2[1],
        real(0.0),
        real(0.0),
        real(3.0) * w2[4],
        real(-3.0) * w2[3],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = G2_plant * (u_sat - t5 * (t37 * t4 - t38 * t3)) + d2;

    // -- Lyapunov function of block 1 (23) (52) --
    let t44 = t14 * t14 * real(0.15915494309189535);
    let [tan_E1, tan_E2] = t20.tan().0;
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t44 * tan_E1;
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + bracket1;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    let t45 = t17 * t17 * real(0.15915494309189535);
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t45 * tan_E2;
    let t46 = t28 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t46[(0, 0)] + t46[(1, 1)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);

    // -- Lyapunov function (52) --
    // V, sum of the parts above
    let V = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2;

    // -- Ito generator (2) --
    // e1' along the flow
    let e1_flow = x2 - y_r_dot - zeta1_dot;
    let t47 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t47 + t47;
    let t48 = (t16 + t16) * (s1_flow * t15 - t16 * t15 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t48;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = tan_E1
        * (real(4.0) * (t14 * k1) * k1_dot * real(0.15915494309189535))
        + t44 * (E1_flow / t23);
    let t49 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t49 + t49) * real(0.5);
    let t50 = real(2.0) * (t9 * real(2.0));
    // y_r''
    let y_r_dot2 = Vector([real(0.5235987755982989) * t50, real(FRAC_PI_4) * t50]);
    let t51 = real(1.5697963267948967) * t26;
    let t52 = real(1.0).lt(t51);
    let t53 = T::select(t52, real(1.0), t51);
    let t54 = T::select(E1.eq(real(0.0)), real(1.0), t25 / E1);
    let t55 = t53 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t52, real(0.0), -(t54 * (t51 * t26 * E1_free_flow)));
    let t56 = t54 * t53;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(5.0) * e1[0] * t55 + t56 * (real(5.0) * e1_flow[0])
            + real(4.0) * e1_flow[0],
        real(5.0) * e1[1] * t55 + t56 * (real(5.0) * e1_flow[1]) + real(4.0) * e1_flow[1],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(sin_E1 * E1_flow);
    let t57 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t57 + e1_flow * t24;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1_flow * real(0.5);
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(20.0) - y_r_dot2 + Lam1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + bracket1_flow;
    let t58 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t58 + t58) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t59 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t59 + t59;
    let t60 = (t19 + t19) * (s2_flow * t18 - t19 * t18 * ((k2 + k2) * k2_dot));
    // E2_free' along the flow
    let E2_free_flow = real(FRAC_PI_2) * t60;
    // E2' along the flow
    let E2_flow = T::select(
        E2_free.lt(real(1.5697963267948967)),
        E2_free_flow,
        real(0.0),
    );
    // V_T2' along the flow
    let V_T2_flow = tan_E2
        * (real(4.0) * (t17 * k2) * k2_dot * real(0.15915494309189535))
        + t45 * (E2_flow / t21);
    let t61 = W2_dot.transpose() * state.W2 + t28 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t61[(0, 0)] + t61[(1, 1)]) * real(0.5);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot
        + Vector([
            real(12.0) * e2_flow[0],
            real(36.0) * e2_flow[0],
            real(8.0) * e2_flow[1],
            real(2.0) * e2_flow[1],
            real(11.0) * e2_flow[1],
        ]);
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t62 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t62 + t62) * real(0.5);
    let t63 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t63 + t63) * real(0.5);
    let t64 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t64 + t64) * real(5.0);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow + V_eps2_flow;
    LyapunovOutputs { V, LV }
}
