// SHA-256 of the text below: b78f81559b7c7a1ef0750630f05d30b14a7a4d32dfa74158459f95b651dfa442
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c
// lyapunov: 4121 additions, 4528 multiplications, 31 divisions, 2 square roots, 30 elementary functions, 23 comparisons and selections

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
/// Operations: 4121 additions, 4528 multiplications, 31 divisions, 2 square roots, 30
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
    let y_r = Vector([t30 * t33, t34 * t33, t35 * t33, t36 * t33, t37 * t33, t38 * t33]);
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

    // -- disturbance observer of block 1 (20) (49) --
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

    // -- robust feedback of block 1 (31) (63) --
    let t73 = kernel::sin_cos_over(E1);
    let t74 = real(1.0) / E1_free;
    let t75 = real(1.5697963267948967) * t74;
    let t76 = real(0.5) * G_norm2_1;
    // Lam_1 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31) + eta_1/2 c^T (36) +
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t73 * real(1.0).min(t75) + real(0.5) + t55 * real(0.5) + t55 * t76);
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t77 = state.zeta1 * real(5.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t77 - y_r_dot + D_hat1 + Lam1;
    let t78 = -sin_phi;
    let t79 = Matrix::rows([[t56, t58, t59], [t60, t62, t63], [t2, t3, t4]]);
    let t80 = t79.solve(Vector([bracket1[0], bracket1[1], bracket1[2]]));
    let t81 = Matrix::rows([[cos_phi, t78], [t67, t68]]);
    let t82 = t81.solve(Vector([bracket1[4], bracket1[5]]));
    let t83 = bracket1[3] - t64 * t82[0] - t65 * t82[1];
    let t84 = Vector([t80[0], t80[1], t80[2], t83, t82[0], t82[1]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t84;

    // -- auxiliary system of block 1 (13) (E1) --
    let t85 = Vector([
        t56 * state.zeta2[0] + t58 * state.zeta2[1] + t59 * state.zeta2[2],
        t60 * state.zeta2[0] + t62 * state.zeta2[1] + t63 * state.zeta2[2],
        t3 * state.zeta2[1] - sin_theta * state.zeta2[0] + t4 * state.zeta2[2],
        state.zeta2[3] + t64 * state.zeta2[4] + t65 * state.zeta2[5],
        cos_phi * state.zeta2[4] - sin_phi * state.zeta2[5],
        t67 * state.zeta2[4] + t68 * state.zeta2[5],
    ]);
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = t85 - t77;

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
    let t86 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t86 * P2;

    // -- disturbance observer of block 2 (20) (49) --
    let t87 = Vector([
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
    let w_hat2 = state.th2 + t87;
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
    let t88 = t16 * real(0.1);
    let t89 = t17 * real(0.01);
    let t90 = t19 * real(0.1);
    let t91 = t20 * real(0.01);
    let t92 = t21 * real(0.1);
    let t93 = t20 * real(0.1);
    let t94 = t22 * real(0.01);
    let t95 = t17 * real(0.1);
    let t96 = t23 * real(0.01);
    let t97 = t24 * real(0.01);
    let t98 = t88 * t88 + t89 * t89 + (t90 * t90 + t91 * t91);
    let t99 = t98 + t92 * t92 + (t93 * t93 + t94 * t94);
    // ||H_2||^2
    let H_norm2_2 = t99 + (t95 * t95 + t96 * t96) + t97 * t97;
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(7.3484692283495345);
    let t100 = real(-8.0) * t88;
    let t101 = real(-8.0) * t89;
    let t102 = real(5.8) * t88;
    let t103 = real(5.8) * t89;
    let t104 = real(-8.0) * t90;
    let t105 = real(-8.0) * t91;
    let t106 = real(5.8) * t90;
    let t107 = real(5.8) * t91;
    let t108 = real(-8.0) * t92;
    let t109 = real(5.8) * t92;
    let t110 = real(-8.0) * t93;
    let t111 = real(-8.0) * t94;
    let t112 = real(5.8) * t93;
    let t113 = real(5.8) * t94;
    let t114 = real(-8.0) * t95;
    let t115 = real(-8.0) * t96;
    let t116 = real(5.8) * t95;
    let t117 = real(5.8) * t96;
    let t118 = real(-8.0) * t97;
    let t119 = real(5.8) * t97;
    let t120 = t100 * t100 + t101 * t101 + (t102 * t102 + t103 * t103);
    let t121 = t120 + (t104 * t104 + t105 * t105) + (t106 * t106 + t107 * t107);
    let t122 = t121 + t108 * t108 + t109 * t109 + (t110 * t110 + t111 * t111);
    let t123 = t122 + (t112 * t112 + t113 * t113) + (t114 * t114 + t115 * t115);
    // ||S_2 H_2||^2
    let SH_norm2_2 = t123 + (t116 * t116 + t117 * t117) + t118 * t118 + t119 * t119;
    let t124 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t124 * t124 * real(0.5) + real(0.30000000000000004)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    let t125 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t125 * state.eps2;
    let t126 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t126 + real(1.0)).sqrt();
    let t127 = G_norm2_1 * s_c1;
    let t128 = state.phi2 * state.phi2;
    let t129 = Psi2 / (t128 + t126);
    let t130 = real(5.25) + s2 * real(3.0) + real(0.5) + t127 * t127 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31) + ||L||^2/(2 eta_1) c^T
    // (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4
    // eta_3^4), G, c, eta_3 of the outer block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 +
    // varsigma^2) (64) (E4, E7) + e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2 = e2 * (t130 + t124 * state.sigma2 * s_scale2 + t129) + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t131 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + A_hat2 - h1_dot + t131 + D_hat2 + Lam2;
    let t132 = real(1.0) / (t16 * t23 - t17 * t17);
    let t133 = -t17 * t132;
    let t134 = Matrix::rows([[t23 * t132, t133], [t133, t16 * t132]])
        * Vector([bracket2[0], bracket2[4]]);
    let t135 = real(1.0) / (t19 * t22 - t20 * t20);
    let t136 = -t20 * t135;
    let t137 = Matrix::rows([[t22 * t135, t136], [t136, t19 * t135]])
        * Vector([bracket2[1], bracket2[3]]);
    let t138 = bracket2[2] * (real(1.0) / t21);
    let t139 = bracket2[5] * (real(1.0) / t24);
    let t140 = Vector([t134[0], t137[0], t138, t137[1], t134[1], t139]);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t140;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
        .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    let t141 = u_sat + t140;
    let t142 = Vector([
        t16 * t141[0] + t17 * t141[4],
        t19 * t141[1] + t20 * t141[3],
        t21 * t141[2],
        t20 * t141[1] + t22 * t141[3],
        t17 * t141[0] + t23 * t141[4],
        t24 * t141[5],
    ]);
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = t142 - t131;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    let t143 = Vector([
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
    let t144 = Vector([
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
    let th2_dot = t143 + t144;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t125) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t124 * t126 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t129 + real(0.5);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.2)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (pose) (11) --
    let t145 = real(0.2) + real(0.1) * sin_t28;
    let t146 = real(-0.1) + real(0.1) * cos_t28;
    let t147 = real(0.05) * sin_t26;
    // d_1(t)
    let d1 = Vector([t145, t146, t147, real(0.0), real(0.0), real(0.0)]);
    let t148 = t56 * surge + t58 * sway + t59 * heave;
    let t149 = t60 * surge + t62 * sway + t63 * heave;
    let t150 = t3 * sway - sin_theta * surge + t4 * heave;
    let t151 = p + t64 * q + t65 * r;
    let t152 = cos_phi * q - sin_phi * r;
    let t153 = t67 * q + t68 * r;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = Vector([t148 + t145, t149 + t146, t150 + t147, t151, t152, t153]);

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
    let t154 = real(0.16) + plant.added_scale * real(0.12);
    let t155 = real(11.5) + plant.added_scale * real(5.5);
    let t156 = real(1.0) / (t155 * t154 - real(0.0529));
    let t157 = t154 * t156;
    let t158 = real(-0.23) * t156;
    let t159 = real(11.5) + plant.added_scale * real(12.7);
    let t160 = real(1.0) / (t159 * t154 - real(0.0529));
    let t161 = t154 * t160;
    let t162 = real(0.23) * t160;
    let t163 = real(1.0) / (real(11.5) + plant.added_scale * real(14.57));
    let t164 = t159 * t160;
    let t165 = t155 * t156;
    let t166 = real(1.0) / t154;
    let t167 = t7 * plant.added_scale;
    let t168 = Vector([
        q * t167[2] - r * t167[1],
        r * t167[0] - p * t167[2],
        p * t167[1] - q * t167[0],
    ]);
    let t169 = t10 - t168 - t8 * plant.drag_scale;
    let t170 = Vector([
        sway * t167[2] - heave * t167[1],
        heave * t167[0] - surge * t167[2],
        surge * t167[1] - sway * t167[0],
    ]);
    let t171 = t13 - t170 - t12 * plant.torque_scale;
    let t172 = Vector([t169[0], t169[1], t169[2], t171[0], t171[1], t171[2]]) + u_sat;
    let t173 = Vector([
        t157 * t172[0] + t158 * t172[4],
        t161 * t172[1] + t162 * t172[3],
        t163 * t172[2],
        t162 * t172[1] + t164 * t172[3],
        t158 * t172[0] + t165 * t172[4],
        t166 * t172[5],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = t173 + d2;

    // -- Lyapunov function of block 1 (23) (52) --
    let t174 = t51 * t51 * real(0.15915494309189535);
    let t175 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t174 * t175;
    // D_1 - D_hat_1
    let D_error1 = d1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t84;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t126 * real(0.25);
    let t176 = t86 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t176[(0, 0)] + t176[(1, 1)] + t176[(2, 2)] + t176[(3, 3)] + t176[(4, 4)]
        + t176[(5, 5)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);
    let t177 = real(6.0) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t177 * t177 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t128 * real(0.5);

    // -- Lyapunov function (52) --
    let t178 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2;
    // V, sum of the parts above
    let V = t178 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t179 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t179 + t179;
    let t180 = (t53 + t53) * (s1_flow * t52 - t53 * t52 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t180;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t175 * (real(4.0) * (t51 * k1) * k1_dot * real(0.15915494309189535))
        + t174 * (E1_flow / t54);
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
    let D_hat1_flow = x1_flow - (D_hat1 + Vector([t148, t149, t150, t151, t152, t153]));
    // D_error1' along the flow
    let D_error1_flow = d1_dot - D_hat1_flow;
    let t181 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t181 + t181) * real(0.5);
    let t182 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t182 + t182) * real(0.5);
    let t183 = -(real(0.3) * t43);
    let t184 = t40 * t42;
    let t185 = t41 * t42 + t32 * (real(-0.02) * (real(3.0) * (t + t)));
    let t186 = t44 * t42;
    let t187 = t45 * t42;
    let t188 = t46 * t42;
    let t189 = t47 * t42;
    let t190 = t49 * t42;
    // y_r''
    let y_r_dot2 = Vector([
        t33 * (real(2.0) * t183) - t184 - (t184 + t30 * t185),
        t33 * (real(2.0) * (real(0.3) * t39)) - t186 - (t186 + t34 * t185),
        t33 * (real(0.2) * t48) - t187 - (t187 + t35 * t185),
        t33 * (real(0.26179938779914946) * -(real(0.4) * (sin_t27 * real(0.4)))) - t188
            - (t188 + t36 * t185),
        t33 * (real(0.4363323129985824) * t183) - t189 - (t189 + t37 * t185),
        t33 * (real(1.0471975511965979) * -(real(0.2) * t45)) - t190
            - (t190 + t38 * t185),
    ]);
    let t191 = real(1.0).lt(t75);
    let t192 = T::select(t191, real(1.0), t75);
    let t193 = t192 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t191, real(0.0), -(t73 * (t75 * t74 * E1_free_flow)));
    let t194 = t73 * t192;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        e1[0] * t193 + t194 * e1_flow[0] + real(0.5) * e1_flow[0],
        e1[1] * t193 + t194 * e1_flow[1] + real(0.5) * e1_flow[1],
        e1[2] * t193 + t194 * e1_flow[2] + real(0.5) * e1_flow[2],
        e1[3] * t193 + t194 * e1_flow[3] + real(0.5) * e1_flow[3],
        e1[4] * t193 + t194 * e1_flow[4] + real(0.5) * e1_flow[4],
        e1[5] * t193 + t194 * e1_flow[5] + real(0.5) * e1_flow[5],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(E1.sin() * E1_flow);
    let t195 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t195 + e1_flow * t55;
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t196 = sin_psi * t153;
    let t197 = sin_theta * t152;
    let t198 = cos_theta * t196 + cos_psi * t197;
    let t199 = cos_theta * t152;
    let t200 = cos_psi * t199 - sin_theta * t196;
    let t201 = cos_phi * t151;
    let t202 = cos_psi * t153;
    let t203 = sin_phi * t151;
    let t204 = sin_phi * t200 + t57 * t201 - (cos_phi * t202 - sin_psi * t203);
    let t205 = cos_phi * t200 - t57 * t203 + (sin_phi * t202 + sin_psi * t201);
    let t206 = cos_theta * t202 - sin_psi * t197;
    let t207 = sin_theta * t202 + sin_psi * t199;
    let t208 = sin_phi * t207 + t61 * t201 - (cos_phi * t196 + cos_psi * t203);
    let t209 = cos_phi * t207 - t61 * t203 - (cos_psi * t201 - sin_phi * t196);
    let t210 = cos_theta * t201 - sin_phi * t197;
    let t211 = cos_phi * t197 + cos_theta * t203;
    let t212 = t152 / (cos_theta * cos_theta);
    let t213 = tan_theta * t201 + sin_phi * t212;
    let t214 = cos_phi * t212 - tan_theta * t203;
    let t215 = t201 * t66 + t67 * t66 * t197;
    let t216 = t68 * t66 * t197 - t203 * t66;
    let t217 = (t58 + t58) * t204 - (t56 + t56) * t198 + (t59 + t59) * t205;
    let t218 = t217 + (t60 + t60) * t206 + (t62 + t62) * t208;
    let t219 = t218 + (t63 + t63) * t209 - (t2 - sin_theta) * t199;
    let t220 = t219 + (t3 + t3) * t210 - (t4 + t4) * t211;
    let t221 = t220 + (t64 + t64) * t213 + (t65 + t65) * t214;
    let t222 = t221 - (cos_phi + cos_phi) * t203 - (t78 - sin_phi) * t201;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t222 + (t67 + t67) * t215 + (t68 + t68) * t216;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t76;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(5.0) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    let t223 = Vector([
        t204 * t80[1] - t198 * t80[0] + t205 * t80[2],
        t206 * t80[0] + t208 * t80[1] + t209 * t80[2],
        t210 * t80[1] - t199 * t80[0] - t211 * t80[2],
        t213 * t82[0] + t214 * t82[1],
        -t203 * t82[0] - t201 * t82[1],
        t215 * t82[0] + t216 * t82[1],
    ]);
    let t224 = bracket1_flow - t223;
    let t225 = t79.solve(Vector([t224[0], t224[1], t224[2]]));
    let t226 = t81.solve(Vector([t224[4], t224[5]]));
    // chi1' along the flow
    let chi1_flow = h1_dot
        + Vector([
            t225[0],
            t225[1],
            t225[2],
            t224[3] - t64 * t226[0] - t65 * t226[1],
            t226[0],
            t226[1],
        ]);
    let t227 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t227 + t227) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t228 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t228 + t228;
    let t229 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t229 + t229) * real(0.25);
    let t230 = W2_dot.transpose() * state.W2 + t86 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t230[(0, 0)] + t230[(1, 1)] + t230[(2, 2)] + t230[(3, 3)]
        + t230[(4, 4)] + t230[(5, 5)]) * real(0.5);
    let t231 = Vector([
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
    let w_hat2_flow = th2_dot + t231;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t232 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t232 + t232) * real(0.5);
    let t233 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t233 + t233) * real(0.5);
    let t234 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t234 + t234) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t177 - t177 * sigma2_dot) * real(0.5);
    let t235 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t235 + t235) * real(0.5);
    let t236 = t157 * real(0.1);
    let t237 = t158 * real(0.1);
    let t238 = t236 * e2[0] + t237 * e2[4];
    // D^1 s2 along noise1
    let s2_noise1_ = t238 + t238;
    let t239 = t236 * t236 + t237 * t237;
    // D^2 s2 along noise1
    let s2_noise1_2 = t239 + t239;
    let t240 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t240 + t240) * real(0.25);
    let t241 = real(-8.0) * t236;
    let t242 = real(5.8) * t236;
    let t243 = real(-8.0) * t237;
    let t244 = real(5.8) * t237;
    let t245 = t241 * t241 + t242 * t242 + t243 * t243 + t244 * t244;
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t245 + t245) * real(0.5);
    let t246 = t161 * real(0.1);
    let t247 = t162 * real(0.1);
    let t248 = t246 * e2[1] + t247 * e2[3];
    // D^1 s2 along noise2
    let s2_noise2_ = t248 + t248;
    let t249 = t246 * t246 + t247 * t247;
    // D^2 s2 along noise2
    let s2_noise2_2 = t249 + t249;
    let t250 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t250 + t250) * real(0.25);
    let t251 = real(-8.0) * t246;
    let t252 = real(5.8) * t246;
    let t253 = real(-8.0) * t247;
    let t254 = real(5.8) * t247;
    let t255 = t251 * t251 + t252 * t252 + t253 * t253 + t254 * t254;
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t255 + t255) * real(0.5);
    let t256 = t163 * real(0.1);
    let t257 = t256 * e2[2];
    // D^1 s2 along noise3
    let s2_noise3_ = t257 + t257;
    let t258 = t256 * t256;
    // D^2 s2 along noise3
    let s2_noise3_2 = t258 + t258;
    let t259 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t259 + t259) * real(0.25);
    let t260 = real(-8.0) * t256;
    let t261 = real(5.8) * t256;
    let t262 = t260 * t260 + t261 * t261;
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t262 + t262) * real(0.5);
    let t263 = t162 * real(0.01);
    let t264 = t164 * real(0.01);
    let t265 = t263 * e2[1] + t264 * e2[3];
    // D^1 s2 along noise4
    let s2_noise4_ = t265 + t265;
    let t266 = t263 * t263 + t264 * t264;
    // D^2 s2 along noise4
    let s2_noise4_2 = t266 + t266;
    let t267 = s2_noise4_2 * s2 + s2_noise4_ * s2_noise4_;
    // D^2 V_T2 along noise4
    let V_T2_noise4_2 = (t267 + t267) * real(0.25);
    let t268 = real(-8.0) * t263;
    let t269 = real(5.8) * t263;
    let t270 = real(-8.0) * t264;
    let t271 = real(5.8) * t264;
    let t272 = t268 * t268 + t269 * t269 + t270 * t270 + t271 * t271;
    // D^2 V_D2 along noise4
    let V_D2_noise4_2 = (t272 + t272) * real(0.5);
    let t273 = t158 * real(0.01);
    let t274 = t165 * real(0.01);
    let t275 = t273 * e2[0] + t274 * e2[4];
    // D^1 s2 along noise5
    let s2_noise5_ = t275 + t275;
    let t276 = t273 * t273 + t274 * t274;
    // D^2 s2 along noise5
    let s2_noise5_2 = t276 + t276;
    let t277 = s2_noise5_2 * s2 + s2_noise5_ * s2_noise5_;
    // D^2 V_T2 along noise5
    let V_T2_noise5_2 = (t277 + t277) * real(0.25);
    let t278 = real(-8.0) * t273;
    let t279 = real(5.8) * t273;
    let t280 = real(-8.0) * t274;
    let t281 = real(5.8) * t274;
    let t282 = t278 * t278 + t279 * t279 + t280 * t280 + t281 * t281;
    // D^2 V_D2 along noise5
    let V_D2_noise5_2 = (t282 + t282) * real(0.5);
    let t283 = t166 * real(0.01);
    let t284 = t283 * e2[5];
    // D^1 s2 along noise6
    let s2_noise6_ = t284 + t284;
    let t285 = t283 * t283;
    // D^2 s2 along noise6
    let s2_noise6_2 = t285 + t285;
    let t286 = s2_noise6_2 * s2 + s2_noise6_ * s2_noise6_;
    // D^2 V_T2 along noise6
    let V_T2_noise6_2 = (t286 + t286) * real(0.25);
    let t287 = real(-8.0) * t283;
    let t288 = real(5.8) * t283;
    let t289 = t287 * t287 + t288 * t288;
    // D^2 V_D2 along noise6
    let V_D2_noise6_2 = (t289 + t289) * real(0.5);
    let t290 = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow + V_eps2_flow;
    let t291 = t290 + V_sigma2_flow + V_phi2_flow + V_T2_noise1_2 * real(0.5)
        + V_D2_noise1_2 * real(0.5) + V_T2_noise2_2 * real(0.5);
    let t292 = t291 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + V_T2_noise4_2 * real(0.5);
    let t293 = t292 + V_D2_noise4_2 * real(0.5) + V_T2_noise5_2 * real(0.5)
        + V_D2_noise5_2 * real(0.5) + V_T2_noise6_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t293 + V_D2_noise6_2 * real(0.5) + real(0.005000000000000001)
        + real(0.005000000000000001) + real(0.005000000000000001)
        + real(0.020000000000000004) + real(0.020000000000000004)
        + real(0.020000000000000004);
    LyapunovOutputs { V, LV }
}
