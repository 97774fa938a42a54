// SHA-256 of the text below: c40746061542c68085a440637c06c867b78b6d669a5b03e12ce9dcadfeb7d738
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c
// lyapunov: 4171 additions, 4572 multiplications, 46 divisions, 2 square roots, 30 elementary functions, 23 comparisons and selections

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
/// Operations: 4171 additions, 4572 multiplications, 46 divisions, 2 square roots, 30
/// elementary functions, 23 comparisons and selections.
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

    // -- plant model --
    let psi = x1[5];
    let phi = x1[3];
    let theta = x1[4];
    let I = real(0.16) + params.added_scale * real(0.12);
    let m_x = real(11.5) + params.added_scale * real(5.5);
    let det_xq = m_x * I - real(0.0529);
    let m_y = real(11.5) + params.added_scale * real(12.7);
    let det_yp = m_y * I - real(0.0529);
    let m_z = real(11.5) + params.added_scale * real(14.57);
    let t1 = Vector([psi, theta, phi]);
    let [cos_psi, cos_theta, cos_phi] = t1.cos().0;
    let [sin_psi, sin_theta, sin_phi] = t1.sin().0;
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
    let t15 = I / det_xq;
    let t16 = real(-0.23) / det_xq;
    let t17 = I / det_yp;
    let t18 = real(0.23) / det_yp;
    let t19 = real(1.0) / m_z;
    let t20 = m_y / det_yp;
    let t21 = m_x / det_xq;
    let t22 = real(1.0) / I;
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        t15 * force[0] + t16 * moment[1],
        t17 * force[1] + t18 * moment[0],
        t19 * force[2],
        t18 * force[1] + t20 * moment[0],
        t16 * force[0] + t21 * moment[1],
        t22 * moment[2],
    ]);

    // -- reference and constraints --
    let t23 = real(0.3) * t;
    let t24 = real(0.1) * t;
    let t25 = real(0.4) * t;
    let t26 = real(0.2) * t;
    let t27 = Vector([t23, t26, t25, t24]);
    let [sin_t23, sin_t26, sin_t25, sin_t24] = t27.sin().0;
    let t28 = real(2.0) * sin_t23;
    let t29 = t * t;
    let t30 = (real(-0.02) * (t29 * t)).exp();
    let t31 = real(1.0) - t30;
    let [cos_t23, cos_t26, cos_t25, cos_t24] = t27.cos().0;
    let t32 = real(2.0) * (real(1.0) - cos_t23);
    let t33 = real(1.0) - cos_t26;
    let t34 = real(0.26179938779914946) * sin_t25;
    let t35 = real(0.4363323129985824) * sin_t23;
    let t36 = real(1.0471975511965979) * sin_t26;
    // y_r(t)
    let y_r = Vector([t28 * t31, t32 * t31, t33 * t31, t34 * t31, t35 * t31, t36 * t31]);
    let t37 = cos_t23 * real(0.3);
    let t38 = real(2.0) * t37;
    let t39 = real(-0.02) * (real(3.0) * t29);
    let t40 = t30 * t39;
    let t41 = sin_t23 * real(0.3);
    let t42 = real(2.0) * t41;
    let t43 = sin_t26 * real(0.2);
    let t44 = real(0.26179938779914946) * (cos_t25 * real(0.4));
    let t45 = real(0.4363323129985824) * t37;
    let t46 = cos_t26 * real(0.2);
    let t47 = real(1.0471975511965979) * t46;
    // y_r'
    let y_r_dot = Vector([
        t31 * t38 - t28 * t40,
        t31 * t42 - t32 * t40,
        t31 * t43 - t33 * t40,
        t31 * t44 - t34 * t40,
        t31 * t45 - t35 * t40,
        t31 * t47 - t36 * t40,
    ]);
    let t48 = (real(-0.3) * t).exp();
    // k_1(t)
    let k1 = real(0.4) * t48 + real(0.1);
    // k1'
    let k1_dot = real(0.4) * (t48 * real(-0.3));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t49 = k1 * k1;
    let t50 = real(1.0) / t49;
    let t51 = s1 * t50;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t51 * t51);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t52 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t52;
    let t53 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t53;

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1;

    // -- norms of block 1 --
    let t54 = cos_psi * cos_theta;
    let t55 = cos_psi * sin_theta;
    let t56 = t55 * sin_phi - sin_psi * cos_phi;
    let t57 = t55 * cos_phi + sin_psi * sin_phi;
    let t58 = sin_psi * cos_theta;
    let t59 = sin_psi * sin_theta;
    let t60 = t59 * sin_phi + cos_psi * cos_phi;
    let t61 = t59 * cos_phi - cos_psi * sin_phi;
    let [_, tan_theta, _] = t1.tan().0;
    let t62 = sin_phi * tan_theta;
    let t63 = cos_phi * tan_theta;
    let t64 = sin_phi / cos_theta;
    let t65 = cos_phi / cos_theta;
    let t66 = t58 * t58 + t60 * t60 + t61 * t61;
    let t67 = t54 * t54 + t56 * t56 + t57 * t57 + t66;
    let t68 = t67 + (sin_theta * sin_theta + t3 * t3 + t4 * t4);
    let t69 = t68 + (real(1.0) + t62 * t62 + t63 * t63);
    // ||G_1||^2
    let G_norm2_1 = t69 + (cos_phi * cos_phi + sin_phi * sin_phi)
        + (t64 * t64 + t65 * t65);

    // -- robust feedback of block 1 (31) (63) --
    let t70 = kernel::sin_cos_over(E1);
    let t71 = real(1.5697963267948967) / E1_free;
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1 * (t70 * real(1.0).min(t71)) + e1 * real(0.5);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    let t72 = real(0.5) * G_norm2_1;
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * t72;
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t73 = state.zeta1 * real(5.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t73 - y_r_dot + D_hat1 + Lam1;
    let t74 = -sin_phi;
    let t75 = Matrix::rows([[t54, t56, t57], [t58, t60, t61], [t2, t3, t4]]);
    let t76 = t75.solve(Vector([bracket1[0], bracket1[1], bracket1[2]]));
    let t77 = Matrix::rows([[cos_phi, t74], [t64, t65]]);
    let t78 = t77.solve(Vector([bracket1[4], bracket1[5]]));
    let t79 = bracket1[3] - t62 * t78[0] - t63 * t78[1];
    let t80 = Vector([t76[0], t76[1], t76[2], t79, t78[0], t78[1]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t80;

    // -- auxiliary system of block 1 (13) (E1) --
    let t81 = Vector([
        t54 * state.zeta2[0] + t56 * state.zeta2[1] + t57 * state.zeta2[2],
        t58 * state.zeta2[0] + t60 * state.zeta2[1] + t61 * state.zeta2[2],
        t2 * state.zeta2[0] + t3 * state.zeta2[1] + t4 * state.zeta2[2],
        state.zeta2[3] + t62 * state.zeta2[4] + t63 * state.zeta2[5],
        cos_phi * state.zeta2[4] + t74 * state.zeta2[5],
        t64 * state.zeta2[4] + t65 * state.zeta2[5],
    ]);
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = t81 - t73;

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
    let t82 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t82 * P2;

    // -- disturbance observer of block 2 (20) (49) --
    let t83 = Vector([
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
    let w_hat2 = state.th2 + t83;
    // d_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([
        w_hat2[1],
        w_hat2[3],
        w_hat2[5],
        w_hat2[7],
        w_hat2[9],
        w_hat2[11],
    ]);

    // -- noise terms of block 2 (58) (62) --
    let t84 = t15 * real(0.1);
    let t85 = t16 * real(0.01);
    let t86 = t17 * real(0.1);
    let t87 = t18 * real(0.01);
    let t88 = t19 * real(0.1);
    let t89 = t18 * real(0.1);
    let t90 = t20 * real(0.01);
    let t91 = t16 * real(0.1);
    let t92 = t21 * real(0.01);
    let t93 = t22 * real(0.01);
    let t94 = t84 * t84 + t85 * t85 + (t86 * t86 + t87 * t87);
    let t95 = t94 + t88 * t88 + (t89 * t89 + t90 * t90);
    // ||H_2||^2
    let H_norm2_2 = t95 + (t91 * t91 + t92 * t92) + t93 * t93;
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(7.3484692283495345);
    let t96 = real(-8.0) * t84;
    let t97 = real(-8.0) * t85;
    let t98 = real(5.8) * t84;
    let t99 = real(5.8) * t85;
    let t100 = real(-8.0) * t86;
    let t101 = real(-8.0) * t87;
    let t102 = real(5.8) * t86;
    let t103 = real(5.8) * t87;
    let t104 = real(-8.0) * t88;
    let t105 = real(5.8) * t88;
    let t106 = real(-8.0) * t89;
    let t107 = real(-8.0) * t90;
    let t108 = real(5.8) * t89;
    let t109 = real(5.8) * t90;
    let t110 = real(-8.0) * t91;
    let t111 = real(-8.0) * t92;
    let t112 = real(5.8) * t91;
    let t113 = real(5.8) * t92;
    let t114 = real(-8.0) * t93;
    let t115 = real(5.8) * t93;
    let t116 = t96 * t96 + t97 * t97 + (t98 * t98 + t99 * t99);
    let t117 = t116 + (t100 * t100 + t101 * t101) + (t102 * t102 + t103 * t103);
    let t118 = t117 + t104 * t104 + t105 * t105 + (t106 * t106 + t107 * t107);
    let t119 = t118 + (t108 * t108 + t109 * t109) + (t110 * t110 + t111 * t111);
    // ||S_2 H_2||^2
    let SH_norm2_2 = t119 + (t112 * t112 + t113 * t113) + t114 * t114 + t115 * t115;
    let t120 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t120 * t120 * real(0.5) + real(0.30000000000000004)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(3.25) + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(3.0);
    // e / (2 cos^2 E) (63)
    let Lam2_network = e2 * real(0.5);
    let t121 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t121 * state.eps2;
    let t122 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t122 * t122) * real(0.25);
    let t123 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t123 + real(1.0)).sqrt();
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t120 * state.sigma2 * s_scale2);
    let t124 = state.phi2 * state.phi2;
    let t125 = Psi2 / (t124 + t123);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t125;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t126 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + A_hat2 - h1_dot + t126 + D_hat2 + Lam2;
    let t127 = real(1.0) / (t15 * t21 - t16 * t16);
    let t128 = -t16 * t127;
    let t129 = Matrix::rows([[t21 * t127, t128], [t128, t15 * t127]])
        * Vector([bracket2[0], bracket2[4]]);
    let t130 = real(1.0) / (t17 * t20 - t18 * t18);
    let t131 = -t18 * t130;
    let t132 = Matrix::rows([[t20 * t130, t131], [t131, t17 * t130]])
        * Vector([bracket2[1], bracket2[3]]);
    let t133 = bracket2[2] * (real(1.0) / t19);
    let t134 = bracket2[5] * (real(1.0) / t22);
    let t135 = Vector([t129[0], t132[0], t133, t132[1], t129[1], t134]);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t135;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
        .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    let t136 = u_sat + t135;
    let t137 = Vector([
        t15 * t136[0] + t16 * t136[4],
        t17 * t136[1] + t18 * t136[3],
        t19 * t136[2],
        t18 * t136[1] + t20 * t136[3],
        t16 * t136[0] + t21 * t136[4],
        t22 * t136[5],
    ]);
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = t137 - t126;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
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
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) = M_2
    // w_hat_2 + S_2 Lam_2
    let th2_dot = t138 + t139;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t121) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t120 * t123 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t125 + real(0.5);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.2)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (pose) (11) --
    let t140 = real(0.2) + real(0.1) * sin_t26;
    let t141 = real(-0.1) + real(0.1) * cos_t26;
    let t142 = real(0.05) * sin_t24;
    // d_1(t)
    let d1 = Vector([t140, t141, t142, real(0.0), real(0.0), real(0.0)]);
    let t143 = t54 * surge + t56 * sway + t57 * heave;
    let t144 = t58 * surge + t60 * sway + t61 * heave;
    let t145 = t2 * surge + t3 * sway + t4 * heave;
    let t146 = p + t62 * q + t63 * r;
    let t147 = cos_phi * q + t74 * r;
    let t148 = t64 * q + t65 * r;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = Vector([t143 + t140, t144 + t141, t145 + t142, t146, t147, t148]);

    // -- true dynamics of block 2 (velocity) (11) --
    let t149 = real(0.16) + plant.added_scale * real(0.12);
    let t150 = real(11.5) + plant.added_scale * real(5.5);
    let t151 = t150 * t149 - real(0.0529);
    let t152 = t149 / t151;
    let t153 = real(-0.23) / t151;
    let t154 = real(11.5) + plant.added_scale * real(12.7);
    let t155 = t154 * t149 - real(0.0529);
    let t156 = t149 / t155;
    let t157 = real(0.23) / t155;
    let t158 = real(1.0) / (real(11.5) + plant.added_scale * real(14.57));
    let t159 = t154 / t155;
    let t160 = t150 / t151;
    let t161 = real(1.0) / t149;
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
    let t166 = t13 - t165 - t12 * plant.torque_scale;
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        t152 * t164[0] + t153 * t166[1],
        t156 * t164[1] + t157 * t166[0],
        t158 * t164[2],
        t157 * t164[1] + t159 * t166[0],
        t153 * t164[0] + t160 * t166[1],
        t161 * t166[2],
    ]);
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
    let t167 = Vector([
        t152 * u_sat[0] + t153 * u_sat[4],
        t156 * u_sat[1] + t157 * u_sat[3],
        t158 * u_sat[2],
        t157 * u_sat[1] + t159 * u_sat[3],
        t153 * u_sat[0] + t160 * u_sat[4],
        t161 * u_sat[5],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + t167 + d2;

    // -- Lyapunov function of block 1 (23) (52) --
    let t168 = t49 * t49 * real(0.15915494309189535);
    let t169 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t168 * t169;
    // D_1 - D_hat_1
    let D_error1 = d1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t80;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t123 * real(0.25);
    let t170 = t82 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t170[(0, 0)] + t170[(1, 1)] + t170[(2, 2)] + t170[(3, 3)] + t170[(4, 4)]
        + t170[(5, 5)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);
    let t171 = real(6.0) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t171 * t171 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t124 * real(0.5);

    // -- Lyapunov function (52) --
    let t172 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2;
    // V, sum of the parts above
    let V = t172 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t173 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t173 + t173;
    let t174 = (t51 + t51) * (s1_flow * t50 - t51 * t50 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t174;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t169 * (real(4.0) * (t49 * k1) * k1_dot * real(0.15915494309189535))
        + t168 * (E1_flow / t52);
    // d1'
    let d1_dot = Vector([
        real(0.1) * t46,
        -(real(0.1) * t43),
        real(0.05) * (cos_t24 * real(0.1)),
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow - (D_hat1 + Vector([t143, t144, t145, t146, t147, t148]));
    // D_error1' along the flow
    let D_error1_flow = d1_dot - D_hat1_flow;
    let t175 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t175 + t175) * real(0.5);
    let t176 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t176 + t176) * real(0.5);
    let t177 = -(real(0.3) * t41);
    let t178 = t38 * t40;
    let t179 = t39 * t40 + t30 * (real(-0.02) * (real(3.0) * (t + t)));
    let t180 = t42 * t40;
    let t181 = t43 * t40;
    let t182 = t44 * t40;
    let t183 = t45 * t40;
    let t184 = t47 * t40;
    // y_r''
    let y_r_dot2 = Vector([
        t31 * (real(2.0) * t177) - t178 - (t178 + t28 * t179),
        t31 * (real(2.0) * (real(0.3) * t37)) - t180 - (t180 + t32 * t179),
        t31 * (real(0.2) * t46) - t181 - (t181 + t33 * t179),
        t31 * (real(0.26179938779914946) * -(real(0.4) * (sin_t25 * real(0.4)))) - t182
            - (t182 + t34 * t179),
        t31 * (real(0.4363323129985824) * t177) - t183 - (t183 + t35 * t179),
        t31 * (real(1.0471975511965979) * -(real(0.2) * t43)) - t184
            - (t184 + t36 * t179),
    ]);
    let t185 = real(1.0).lt(t71);
    let t186 = T::select(t185, real(1.0), t71);
    let t187 = t186 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t185, real(0.0), -(t70 * (t71 / E1_free * E1_free_flow)));
    let t188 = t70 * t186;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        e1[0] * t187 + t188 * e1_flow[0] + real(0.5) * e1_flow[0],
        e1[1] * t187 + t188 * e1_flow[1] + real(0.5) * e1_flow[1],
        e1[2] * t187 + t188 * e1_flow[2] + real(0.5) * e1_flow[2],
        e1[3] * t187 + t188 * e1_flow[3] + real(0.5) * e1_flow[3],
        e1[4] * t187 + t188 * e1_flow[4] + real(0.5) * e1_flow[4],
        e1[5] * t187 + t188 * e1_flow[5] + real(0.5) * e1_flow[5],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(E1.sin() * E1_flow);
    // sec2E1' along the flow
    let sec2E1_flow = -(sec2E1 / t52 * ((cosE1 + cosE1) * cosE1_flow));
    // c1' along the flow
    let c1_flow = e1 * (s1_flow * sec2E1 + s1 * sec2E1_flow) + e1_flow * t53;
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t189 = sin_psi * t148;
    let t190 = sin_theta * t147;
    let t191 = -(cos_theta * t189 + cos_psi * t190);
    let t192 = cos_theta * t147;
    let t193 = cos_psi * t192 - sin_theta * t189;
    let t194 = cos_phi * t146;
    let t195 = cos_psi * t148;
    let t196 = sin_phi * t146;
    let t197 = sin_phi * t193 + t55 * t194 - (cos_phi * t195 - sin_psi * t196);
    let t198 = cos_phi * t193 - t55 * t196 + (sin_phi * t195 + sin_psi * t194);
    let t199 = cos_theta * t195 - sin_psi * t190;
    let t200 = sin_theta * t195 + sin_psi * t192;
    let t201 = sin_phi * t200 + t59 * t194 - (cos_phi * t189 + cos_psi * t196);
    let t202 = cos_phi * t200 - t59 * t196 - (cos_psi * t194 - sin_phi * t189);
    let t203 = -t192;
    let t204 = cos_theta * t194 - sin_phi * t190;
    let t205 = -(cos_phi * t190 + cos_theta * t196);
    let t206 = t147 / (cos_theta * cos_theta);
    let t207 = tan_theta * t194 + sin_phi * t206;
    let t208 = cos_phi * t206 - tan_theta * t196;
    let t209 = -t196;
    let t210 = -t194;
    let t211 = t194 / cos_theta + t64 / cos_theta * t190;
    let t212 = t65 / cos_theta * t190 - t196 / cos_theta;
    let t213 = (t54 + t54) * t191 + (t56 + t56) * t197 + (t57 + t57) * t198;
    let t214 = t213 + (t58 + t58) * t199 + (t60 + t60) * t201;
    let t215 = t214 + (t61 + t61) * t202 + (t2 - sin_theta) * t203;
    let t216 = t215 + (t3 + t3) * t204 + (t4 + t4) * t205;
    let t217 = t216 + (t62 + t62) * t207 + (t63 + t63) * t208;
    let t218 = t217 + (cos_phi + cos_phi) * t209 + (t74 - sin_phi) * t210;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t218 + (t64 + t64) * t211 + (t65 + t65) * t212;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t72;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(5.0) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    let t219 = Vector([
        t191 * t76[0] + t197 * t76[1] + t198 * t76[2],
        t199 * t76[0] + t201 * t76[1] + t202 * t76[2],
        t203 * t76[0] + t204 * t76[1] + t205 * t76[2],
        t207 * t78[0] + t208 * t78[1],
        t209 * t78[0] + t210 * t78[1],
        t211 * t78[0] + t212 * t78[1],
    ]);
    let t220 = bracket1_flow - t219;
    let t221 = t75.solve(Vector([t220[0], t220[1], t220[2]]));
    let t222 = t77.solve(Vector([t220[4], t220[5]]));
    // chi1' along the flow
    let chi1_flow = h1_dot
        + Vector([
            t221[0],
            t221[1],
            t221[2],
            t220[3] - t62 * t222[0] - t63 * t222[1],
            t222[0],
            t222[1],
        ]);
    let t223 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t223 + t223) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t224 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t224 + t224;
    let t225 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t225 + t225) * real(0.25);
    let t226 = W2_dot.transpose() * state.W2 + t82 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t226[(0, 0)] + t226[(1, 1)] + t226[(2, 2)] + t226[(3, 3)]
        + t226[(4, 4)] + t226[(5, 5)]) * real(0.5);
    let t227 = Vector([
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
    let w_hat2_flow = th2_dot + t227;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t228 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t228 + t228) * real(0.5);
    let t229 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t229 + t229) * real(0.5);
    let t230 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t230 + t230) * real(5.0);
    let t231 = -sigma2_dot * t171;
    // V_sigma2' along the flow
    let V_sigma2_flow = (t231 + t231) * real(0.5);
    let t232 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t232 + t232) * real(0.5);
    let t233 = t152 * real(0.1);
    let t234 = t153 * real(0.1);
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
    let t243 = t156 * real(0.1);
    let t244 = t157 * real(0.1);
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
    let t253 = t158 * real(0.1);
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
    let t260 = t157 * real(0.01);
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
    let t270 = t153 * real(0.01);
    let t271 = t160 * real(0.01);
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
