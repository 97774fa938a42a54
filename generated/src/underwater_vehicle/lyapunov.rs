// SHA-256 of the text below: c19fd87ebe9ff0f54aa208543e5f2624132d623bff6b3be49b03b07409e6349f
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c
// lyapunov: 6488 additions, 6972 multiplications, 135 divisions, 2 square roots, 28 elementary functions, 68 comparisons and selections

//! `underwater_vehicle`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::polynomials;
use core::f64::consts::{FRAC_PI_2, TAU};
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
/// Operations: 6488 additions, 6972 multiplications, 135 divisions, 2 square roots, 28
/// elementary functions, 68 comparisons and selections.
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

    // -- known dynamics of block 1 (pose) (11) --
    // F_1(x_1 .. x_1)
    let F1: Vector<T, 6> = Vector::zero();

    // -- plant model --
    let psi = x1[5];
    let theta = x1[4];
    let phi = x1[3];
    let t1 = psi.cos();
    let t2 = theta.cos();
    let t3 = t1 * t2;
    let t4 = theta.sin();
    let t5 = t1 * t4;
    let t6 = phi.sin();
    let t7 = psi.sin();
    let t8 = phi.cos();
    let t9 = t5 * t6 - t7 * t8;
    let t10 = t5 * t8 + t7 * t6;
    let t11 = t7 * t2;
    let t12 = t7 * t4;
    let t13 = t12 * t6 + t1 * t8;
    let t14 = t12 * t8 - t1 * t6;
    let t15 = -t4;
    let t16 = t2 * t6;
    let t17 = t2 * t8;
    let t18 = theta.tan();
    let t19 = t6 * t18;
    let t20 = t8 * t18;
    let t21 = -t6;
    let t22 = t6 / t2;
    let t23 = t8 / t2;
    let J = Matrix([
        [t3, t9, t10, real(0.0), real(0.0), real(0.0)],
        [t11, t13, t14, real(0.0), real(0.0), real(0.0)],
        [t15, t16, t17, real(0.0), real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(1.0), t19, t20],
        [real(0.0), real(0.0), real(0.0), real(0.0), t8, t21],
        [real(0.0), real(0.0), real(0.0), real(0.0), t22, t23],
    ]);
    let I = real(0.16) + params.added_scale * real(0.12);
    let m_x = real(11.5) + params.added_scale * real(5.5);
    let det_xq = m_x * I - real(0.0529);
    let m_y = real(11.5) + params.added_scale * real(12.7);
    let det_yp = m_y * I - real(0.0529);
    let m_z = real(11.5) + params.added_scale * real(14.57);
    let t24 = real(-0.23) / det_xq;
    let t25 = real(0.23) / det_yp;
    let inverse_M = Matrix([
        [I / det_xq, real(0.0), real(0.0), real(0.0), t24, real(0.0)],
        [real(0.0), I / det_yp, real(0.0), t25, real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(1.0) / m_z, real(0.0), real(0.0), real(0.0)],
        [real(0.0), t25, real(0.0), m_y / det_yp, real(0.0), real(0.0)],
        [t24, real(0.0), real(0.0), real(0.0), m_x / det_xq, real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(1.0) / I],
    ]);
    let down_axis = Vector([t15, t16, t17]);
    let p = x2[3];
    let q = x2[4];
    let r = x2[5];
    let surge = x2[0];
    let sway = x2[1];
    let heave = x2[2];
    let t26 = q * heave - r * sway;
    let t27 = r * surge - p * heave;
    let carried = Vector([t26, t27, p * sway - q * surge]);
    let t28 = Vector([real(5.5) * surge, real(12.7) * sway, real(14.57) * heave]);
    let added_momentum = t28 * params.added_scale;
    let t29 = Vector([
        (real(4.03) + real(18.18) * surge.abs()) * surge,
        (real(6.22) + real(21.66) * sway.abs()) * sway,
        (real(5.18) + real(36.99) * heave.abs()) * heave,
    ]);
    let drag = t29 * params.drag_scale;
    let t30 = Vector([p * r, q * r, -(p * p) - q * q]) * real(0.02);
    let t31 = down_axis * real(-1.9849999999999852) - (carried + t30) * real(11.5);
    let t32 = Vector([
        q * added_momentum[2] - r * added_momentum[1],
        r * added_momentum[0] - p * added_momentum[2],
        p * added_momentum[1] - q * added_momentum[0],
    ]);
    let force = t31 - t32 - drag;
    let t33 = Vector([
        (real(0.07) + real(1.55) * p.abs()) * p,
        (real(0.07) + real(1.55) * q.abs()) * q,
        (real(0.07) + real(1.55) * r.abs()) * r,
    ]);
    let drag_torque = t33 * params.torque_scale;
    let t34 = Vector([t27 - real(9.81) * t16, real(9.81) * t15 - t26, real(0.0)])
        * real(0.23);
    let t35 = Vector([
        sway * added_momentum[2] - heave * added_momentum[1],
        heave * added_momentum[0] - surge * added_momentum[2],
        surge * added_momentum[1] - sway * added_momentum[0],
    ]);
    let moment = t34 - t35 - drag_torque;
    let shaking: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.1, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.1, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.1, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.01, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.01, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.01],
    ]);

    // -- known dynamics of block 2 (velocity) (11) --
    // F_2(x_1 .. x_2)
    let F2 = inverse_M
        * Vector([force[0], force[1], force[2], moment[0], moment[1], moment[2]]);
    // H_2(x_1 .. x_2)
    let H2 = inverse_M * shaking;

    // -- reference and constraints --
    let t36 = real(0.3) * t;
    let t37 = t36.sin();
    let t38 = real(2.0) * t37;
    let t39 = t * t;
    let t40 = (real(-0.02) * (t39 * t)).exp();
    let t41 = real(1.0) - t40;
    let t42 = t36.cos();
    let t43 = real(2.0) * (real(1.0) - t42);
    let t44 = real(0.2) * t;
    let t45 = t44.cos();
    let t46 = real(1.0) - t45;
    let t47 = real(0.4) * t;
    let t48 = t47.sin();
    let t49 = real(0.26179938779914946) * t48;
    let t50 = real(0.4363323129985824) * t37;
    let t51 = t44.sin();
    let t52 = real(1.0471975511965979) * t51;
    // y_r(t)
    let y_r = Vector([t38 * t41, t43 * t41, t46 * t41, t49 * t41, t50 * t41, t52 * t41]);
    let t53 = t42 * real(0.3);
    let t54 = real(2.0) * t53;
    let t55 = real(3.0) * t39;
    let t56 = real(-0.02) * t55;
    let t57 = t40 * t56;
    let t58 = t37 * real(0.3);
    let t59 = real(2.0) * t58;
    let t60 = t51 * real(0.2);
    let t61 = t47.cos();
    let t62 = real(0.26179938779914946) * (t61 * real(0.4));
    let t63 = real(0.4363323129985824) * t53;
    let t64 = t45 * real(0.2);
    let t65 = real(1.0471975511965979) * t64;
    // y_r'
    let y_r_dot = Vector([
        t41 * t54 - t38 * t57,
        t41 * t59 - t43 * t57,
        t41 * t60 - t46 * t57,
        t41 * t62 - t49 * t57,
        t41 * t63 - t50 * t57,
        t41 * t65 - t52 * t57,
    ]);
    let t66 = (real(-0.3) * t).exp();
    // k_1(t)
    let k1 = real(0.4) * t66 + real(0.1);
    // k1'
    let k1_dot = real(0.4) * (t66 * real(-0.3));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t67 = k1 * k1;
    let t68 = s1 / t67;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t68 * t68);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t69 = cosE1 * cosE1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * s1 / t69;

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = J.sum_squares();

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
    let bracket1 = F1 - y_r_dot + t73 + D_hat1 + Lam1;
    let t74 = J.solve(bracket1);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t74;

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = J * state.zeta2 - t73;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) / real(0.1);

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
    let t75 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t75 * P2;

    // -- disturbance observer of block 2 (20) (49) --
    // S_2, observer gain
    let S2: Matrix<T, 12, 6> = Matrix::from_f64([
        [-8.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [5.8, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, -8.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 5.8, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -8.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 5.8, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, -8.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 5.8, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -8.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 5.8, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, -8.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 5.8],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + S2 * e2;
    // L_2
    let L2: Matrix<T, 6, 12> = Matrix::from_f64([
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    ]);
    // d_hat_2 = L_2 w_hat_2
    let D_hat2 = L2 * w_hat2;

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(7.3484692283495345);
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t76 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t76 * t76 * real(0.5) + real(0.30000000000000004)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(3.25) + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(3.0);
    // e / (2 cos^2 E) (63)
    let Lam2_network = e2 * real(0.5);
    let t77 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t77 * state.eps2;
    let t78 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t78 * t78) * real(0.25);
    let t79 = s2 * s2;
    let t80 = (t79 + real(1.0)).sqrt();
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t76 * state.sigma2) / t80;
    let t81 = state.phi2 * state.phi2;
    let t82 = Psi2 / (t81 + t79);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t82;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t83 = F2 + A_hat2;
    let t84 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t83 - h1_dot + t84 + D_hat2 + Lam2;
    let t85 = inverse_M.solve(bracket2);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t85;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
        .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = inverse_M * (u_sat + t85) - t84;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    // M_2 - S_2 L_2
    let w2_closed: Matrix<T, 12, 12> = Matrix::from_f64([
        [0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [-1.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -1.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -1.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -6.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -6.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -6.0],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2)
    let th2_dot = w2_closed * w_hat2 - S2 * (t83 + inverse_M * u - h1_dot + t84);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t77) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t76 * t79 / t80 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t82 + real(0.5);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.2)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (pose) (11) --
    // F_1 with the plant's parameters
    let F1_plant: Vector<T, 6> = Vector::zero();
    let t86 = real(0.1) * t;
    // d_1(t)
    let d1 = Vector([
        real(0.2) + real(0.1) * t51,
        real(-0.1) + real(0.1) * t45,
        real(0.05) * t86.sin(),
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    let t87 = J * x2;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + t87 + d1;

    // -- true dynamics of block 2 (velocity) (11) --
    let t88 = real(0.16) + plant.added_scale * real(0.12);
    let t89 = real(11.5) + plant.added_scale * real(5.5);
    let t90 = t89 * t88 - real(0.0529);
    let t91 = real(-0.23) / t90;
    let t92 = real(11.5) + plant.added_scale * real(12.7);
    let t93 = t92 * t88 - real(0.0529);
    let t94 = real(0.23) / t93;
    // G_2 with the plant's parameters
    let G2_plant = Matrix([
        [t88 / t90, real(0.0), real(0.0), real(0.0), t91, real(0.0)],
        [real(0.0), t88 / t93, real(0.0), t94, real(0.0), real(0.0)],
        [
            real(0.0),
            real(0.0),
            real(1.0) / (real(11.5) + plant.added_scale * real(14.57)),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [real(0.0), t94, real(0.0), t92 / t93, real(0.0), real(0.0)],
        [t91, real(0.0), real(0.0), real(0.0), t89 / t90, real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(1.0) / t88],
    ]);
    let t95 = t28 * plant.added_scale;
    let t96 = Vector([
        q * t95[2] - r * t95[1],
        r * t95[0] - p * t95[2],
        p * t95[1] - q * t95[0],
    ]);
    let t97 = t31 - t96 - t29 * plant.drag_scale;
    let t98 = Vector([
        sway * t95[2] - heave * t95[1],
        heave * t95[0] - surge * t95[2],
        surge * t95[1] - sway * t95[0],
    ]);
    let t99 = t34 - t98 - t33 * plant.torque_scale;
    // F_2 with the plant's parameters
    let F2_plant = G2_plant * Vector([t97[0], t97[1], t97[2], t99[0], t99[1], t99[2]]);
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    let t100: Matrix<T, 12, 12> = Matrix::from_f64([
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [-1.0, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -1.0, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -1.0, -0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.2, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.2, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.2],
    ]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = t100 * w2;
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;
    let t101: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.1, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.1, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.1, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.01, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.01, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.01],
    ]);
    // H_2 Sigma_2
    let HSigma2 = G2_plant * t101;

    // -- Lyapunov function of block 1 (23) (52) --
    let t102 = t67 * t67 / real(TAU);
    let t103 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t102 * t103;
    // D_1 - D_hat_1
    let D_error1 = d1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t74;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t79 * real(0.25);
    let t104 = t75 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t104[(0, 0)] + t104[(1, 1)] + t104[(2, 2)] + t104[(3, 3)] + t104[(4, 4)]
        + t104[(5, 5)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 / real(0.2);
    let t105 = real(6.0) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t105 * t105 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t81 * real(0.5);

    // -- Lyapunov function (52) --
    let t106 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2;
    // V, sum of the parts above
    let V = t106 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    // column 1 of HSigma2
    let HSigma2_1 = Vector([
        HSigma2[(0, 0)],
        HSigma2[(1, 0)],
        HSigma2[(2, 0)],
        HSigma2[(3, 0)],
        HSigma2[(4, 0)],
        HSigma2[(5, 0)],
    ]);
    // column 2 of HSigma2
    let HSigma2_2 = Vector([
        HSigma2[(0, 1)],
        HSigma2[(1, 1)],
        HSigma2[(2, 1)],
        HSigma2[(3, 1)],
        HSigma2[(4, 1)],
        HSigma2[(5, 1)],
    ]);
    // column 3 of HSigma2
    let HSigma2_3 = Vector([
        HSigma2[(0, 2)],
        HSigma2[(1, 2)],
        HSigma2[(2, 2)],
        HSigma2[(3, 2)],
        HSigma2[(4, 2)],
        HSigma2[(5, 2)],
    ]);
    // column 4 of HSigma2
    let HSigma2_4 = Vector([
        HSigma2[(0, 3)],
        HSigma2[(1, 3)],
        HSigma2[(2, 3)],
        HSigma2[(3, 3)],
        HSigma2[(4, 3)],
        HSigma2[(5, 3)],
    ]);
    // column 5 of HSigma2
    let HSigma2_5 = Vector([
        HSigma2[(0, 4)],
        HSigma2[(1, 4)],
        HSigma2[(2, 4)],
        HSigma2[(3, 4)],
        HSigma2[(4, 4)],
        HSigma2[(5, 4)],
    ]);
    // column 6 of HSigma2
    let HSigma2_6 = Vector([
        HSigma2[(0, 5)],
        HSigma2[(1, 5)],
        HSigma2[(2, 5)],
        HSigma2[(3, 5)],
        HSigma2[(4, 5)],
        HSigma2[(5, 5)],
    ]);
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t107 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t107 + t107;
    let t108 = (t68 + t68) * (s1_flow / t67 - t68 / t67 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t108;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t103 * (real(4.0) * (t67 * k1) * k1_dot / real(TAU))
        + t102 * (E1_flow / t69);
    // d1'
    let d1_dot = Vector([
        real(0.1) * t64,
        -(real(0.1) * t60),
        real(0.05) * (t86.cos() * real(0.1)),
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow - (D_hat1 + F1 + t87);
    // D_error1' along the flow
    let D_error1_flow = d1_dot - D_hat1_flow;
    let t109 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t109 + t109) * real(0.5);
    let t110 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t110 + t110) * real(0.5);
    let t111 = t7 * x1_flow[5];
    let t112 = t4 * x1_flow[4];
    let t113 = -(t2 * t111 + t1 * t112);
    let t114 = t2 * x1_flow[4];
    let t115 = t1 * t114 - t4 * t111;
    let t116 = t8 * x1_flow[3];
    let t117 = t1 * x1_flow[5];
    let t118 = t6 * x1_flow[3];
    let t119 = t6 * t115 + t5 * t116 - (t8 * t117 - t7 * t118);
    let t120 = t8 * t115 - t5 * t118 + (t6 * t117 + t7 * t116);
    let t121 = t2 * t117 - t7 * t112;
    let t122 = t4 * t117 + t7 * t114;
    let t123 = t6 * t122 + t12 * t116 - (t8 * t111 + t1 * t118);
    let t124 = t8 * t122 - t12 * t118 - (t1 * t116 - t6 * t111);
    let t125 = -t114;
    let t126 = t2 * t116 - t6 * t112;
    let t127 = -(t8 * t112 + t2 * t118);
    let t128 = x1_flow[4] / (t2 * t2);
    let t129 = t18 * t116 + t6 * t128;
    let t130 = t8 * t128 - t18 * t118;
    let t131 = -t118;
    let t132 = -t116;
    let t133 = t116 / t2 + t22 / t2 * t112;
    let t134 = t23 / t2 * t112 - t118 / t2;
    // G1' along the flow
    let G1_flow = Matrix([
        [t113, t119, t120, real(0.0), real(0.0), real(0.0)],
        [t121, t123, t124, real(0.0), real(0.0), real(0.0)],
        [t125, t126, t127, real(0.0), real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), t129, t130],
        [real(0.0), real(0.0), real(0.0), real(0.0), t131, t132],
        [real(0.0), real(0.0), real(0.0), real(0.0), t133, t134],
    ]);
    let t135 = t42 * real(0.0) - real(0.3) * t58;
    let t136 = t54 * t57;
    let t137 = t56 * t57 + t40 * (real(-0.02) * (real(3.0) * (t + t) + t55 * real(0.0)));
    let t138 = t59 * t57;
    let t139 = t41 * (real(2.0) * (real(0.3) * t53 + t37 * real(0.0))) - t138;
    let t140 = t60 * t57;
    let t141 = t62 * t57;
    let t142 = t41
        * (real(0.26179938779914946) * (t61 * real(0.0) - real(0.4) * (t48 * real(0.4))))
        - t141;
    let t143 = t63 * t57;
    let t144 = t65 * t57;
    let t145 = t41 * (real(1.0471975511965979) * (t45 * real(0.0) - real(0.2) * t60))
        - t144;
    // y_r''
    let y_r_dot2 = Vector([
        t41 * (real(2.0) * t135) - t136 - (t136 + t38 * t137),
        t139 - (t138 + t43 * t137),
        t41 * (real(0.2) * t64 + t51 * real(0.0)) - t140 - (t140 + t46 * t137),
        t142 - (t141 + t49 * t137),
        t41 * (real(0.4363323129985824) * t135) - t143 - (t143 + t50 * t137),
        t145 - (t144 + t52 * t137),
    ]);
    let t146 = real(1.0).lt(t71);
    let t147 = T::select(t146, real(1.0), t71);
    let t148 = t147 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t146, real(0.0), -(t70 * (t71 / E1_free * E1_free_flow)));
    let t149 = t70 * t147;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        e1[0] * t148 + t149 * e1_flow[0] + real(0.5) * e1_flow[0],
        e1[1] * t148 + t149 * e1_flow[1] + real(0.5) * e1_flow[1],
        e1[2] * t148 + t149 * e1_flow[2] + real(0.5) * e1_flow[2],
        e1[3] * t148 + t149 * e1_flow[3] + real(0.5) * e1_flow[3],
        e1[4] * t148 + t149 * e1_flow[4] + real(0.5) * e1_flow[4],
        e1[5] * t148 + t149 * e1_flow[5] + real(0.5) * e1_flow[5],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(E1.sin() * E1_flow);
    let t150 = (cosE1 + cosE1) * cosE1_flow;
    let t151 = s1 * e1[0] / t69 / t69 * t150;
    let t152 = s1 * e1[1] / t69 / t69 * t150;
    let t153 = s1 * e1[2] / t69 / t69 * t150;
    let t154 = s1 * e1[3] / t69 / t69 * t150;
    let t155 = s1 * e1[4] / t69 / t69 * t150;
    let t156 = s1 * e1[5] / t69 / t69 * t150;
    // c1' along the flow
    let c1_flow = Vector([
        (e1[0] * s1_flow + s1 * e1_flow[0]) / t69 - t151,
        (e1[1] * s1_flow + s1 * e1_flow[1]) / t69 - t152,
        (e1[2] * s1_flow + s1 * e1_flow[2]) / t69 - t153,
        (e1[3] * s1_flow + s1 * e1_flow[3]) / t69 - t154,
        (e1[4] * s1_flow + s1 * e1_flow[4]) / t69 - t155,
        (e1[5] * s1_flow + s1 * e1_flow[5]) / t69 - t156,
    ]);
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t157 = (t3 + t3) * t113 + (t9 + t9) * t119 + (t10 + t10) * t120;
    let t158 = t157 + real(0.0) + real(0.0) + real(0.0) + (t11 + t11) * t121;
    let t159 = t158 + (t13 + t13) * t123 + (t14 + t14) * t124 + real(0.0) + real(0.0);
    let t160 = t159 + real(0.0) + (t15 - t4) * t125 + (t16 + t16) * t126;
    let t161 = t160 + (t17 + t17) * t127 + real(0.0) + real(0.0) + real(0.0) + real(0.0)
        + real(0.0);
    let t162 = t161 + real(0.0) + real(0.0) + (t19 + t19) * t129 + (t20 + t20) * t130;
    let t163 = t162 + real(0.0) + real(0.0) + real(0.0) + real(0.0) + (t8 + t8) * t131;
    let t164 = t163 + (t21 - t6) * t132 + real(0.0) + real(0.0) + real(0.0) + real(0.0);
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t164 + (t22 + t22) * t133 + (t23 + t23) * t134;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t72;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(5.0) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + J.solve(bracket1_flow - G1_flow * t74);
    let t165 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t165 + t165) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t166 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t166 + t166;
    let t167 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t167 + t167) * real(0.25);
    let t168 = W2_dot.transpose() * state.W2 + t75 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t168[(0, 0)] + t168[(1, 1)] + t168[(2, 2)] + t168[(3, 3)]
        + t168[(4, 4)] + t168[(5, 5)]) * real(0.5);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + S2 * e2_flow;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t169 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t169 + t169) * real(0.5);
    let t170 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t170 + t170) * real(0.5);
    let t171 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t171 + t171) / real(0.2);
    let t172 = -sigma2_dot * t105;
    // V_sigma2' along the flow
    let V_sigma2_flow = (t172 + t172) * real(0.5);
    let t173 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t173 + t173) * real(0.5);
    let t174 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t174 + t174;
    let t175 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t175 + t175;
    let t176 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t176 + t176) * real(0.25);
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = S2 * HSigma2_1;
    let t177 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t177 + t177) * real(0.5);
    let t178 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t178 + t178;
    let t179 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t179 + t179;
    let t180 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t180 + t180) * real(0.25);
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = S2 * HSigma2_2;
    let t181 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t181 + t181) * real(0.5);
    let t182 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t182 + t182;
    let t183 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t183 + t183;
    let t184 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t184 + t184) * real(0.25);
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = S2 * HSigma2_3;
    let t185 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t185 + t185) * real(0.5);
    let t186 = HSigma2_4.dot(e2);
    // D^1 s2 along noise4
    let s2_noise4_ = t186 + t186;
    let t187 = HSigma2_4.sum_squares();
    // D^2 s2 along noise4
    let s2_noise4_2 = t187 + t187;
    let t188 = s2_noise4_2 * s2 + s2_noise4_ * s2_noise4_;
    // D^2 V_T2 along noise4
    let V_T2_noise4_2 = (t188 + t188) * real(0.25);
    // D^1 w_hat2 along noise4
    let w_hat2_noise4_ = S2 * HSigma2_4;
    let t189 = w_hat2_noise4_.sum_squares();
    // D^2 V_D2 along noise4
    let V_D2_noise4_2 = (t189 + t189) * real(0.5);
    let t190 = HSigma2_5.dot(e2);
    // D^1 s2 along noise5
    let s2_noise5_ = t190 + t190;
    let t191 = HSigma2_5.sum_squares();
    // D^2 s2 along noise5
    let s2_noise5_2 = t191 + t191;
    let t192 = s2_noise5_2 * s2 + s2_noise5_ * s2_noise5_;
    // D^2 V_T2 along noise5
    let V_T2_noise5_2 = (t192 + t192) * real(0.25);
    // D^1 w_hat2 along noise5
    let w_hat2_noise5_ = S2 * HSigma2_5;
    let t193 = w_hat2_noise5_.sum_squares();
    // D^2 V_D2 along noise5
    let V_D2_noise5_2 = (t193 + t193) * real(0.5);
    let t194 = HSigma2_6.dot(e2);
    // D^1 s2 along noise6
    let s2_noise6_ = t194 + t194;
    let t195 = HSigma2_6.sum_squares();
    // D^2 s2 along noise6
    let s2_noise6_2 = t195 + t195;
    let t196 = s2_noise6_2 * s2 + s2_noise6_ * s2_noise6_;
    // D^2 V_T2 along noise6
    let V_T2_noise6_2 = (t196 + t196) * real(0.25);
    // D^1 w_hat2 along noise6
    let w_hat2_noise6_ = S2 * HSigma2_6;
    let t197 = w_hat2_noise6_.sum_squares();
    // D^2 V_D2 along noise6
    let V_D2_noise6_2 = (t197 + t197) * real(0.5);
    let t198 = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow + V_eps2_flow;
    let t199 = t198 + V_sigma2_flow + V_phi2_flow + V_T2_noise1_2 * real(0.5)
        + V_D2_noise1_2 * real(0.5) + V_T2_noise2_2 * real(0.5);
    let t200 = t199 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + V_T2_noise4_2 * real(0.5);
    let t201 = t200 + V_D2_noise4_2 * real(0.5) + V_T2_noise5_2 * real(0.5)
        + V_D2_noise5_2 * real(0.5) + V_T2_noise6_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t201 + V_D2_noise6_2 * real(0.5) + real(0.005000000000000001)
        + real(0.005000000000000001) + real(0.005000000000000001)
        + real(0.020000000000000004) + real(0.020000000000000004)
        + real(0.020000000000000004);
    LyapunovOutputs { V, LV }
}
