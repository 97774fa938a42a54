// SHA-256 of the text below: f6e9bac5489961043b8d962633496892c8cf39d8e4535e6e37735513134d1db1
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c
// lyapunov: 5514 additions, 6017 multiplications, 98 divisions, 2 square roots, 28 elementary functions, 70 comparisons and selections

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
/// Operations: 5514 additions, 6017 multiplications, 98 divisions, 2 square roots, 28
/// elementary functions, 70 comparisons and selections.
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
    let theta = x1[4];
    let phi = x1[3];
    let t1 = Vector([phi, theta, psi]);
    let [cos_phi, cos_theta, cos_psi] = t1.cos().0;
    let t2 = cos_psi * cos_theta;
    let [sin_phi, sin_theta, sin_psi] = t1.sin().0;
    let t3 = cos_psi * sin_theta;
    let t4 = t3 * sin_phi - sin_psi * cos_phi;
    let t5 = t3 * cos_phi + sin_psi * sin_phi;
    let t6 = sin_psi * cos_theta;
    let t7 = sin_psi * sin_theta;
    let t8 = t7 * sin_phi + cos_psi * cos_phi;
    let t9 = t7 * cos_phi - cos_psi * sin_phi;
    let t10 = -sin_theta;
    let t11 = cos_theta * sin_phi;
    let t12 = cos_theta * cos_phi;
    let [_, tan_theta, _] = t1.tan().0;
    let t13 = sin_phi * tan_theta;
    let t14 = cos_phi * tan_theta;
    let t15 = -sin_phi;
    let t16 = sin_phi / cos_theta;
    let t17 = cos_phi / cos_theta;
    let J = Matrix::rows([
        [t2, t4, t5, real(0.0), real(0.0), real(0.0)],
        [t6, t8, t9, real(0.0), real(0.0), real(0.0)],
        [t10, t11, t12, real(0.0), real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(1.0), t13, t14],
        [real(0.0), real(0.0), real(0.0), real(0.0), cos_phi, t15],
        [real(0.0), real(0.0), real(0.0), real(0.0), t16, t17],
    ]);
    let I = real(0.16) + params.added_scale * real(0.12);
    let m_x = real(11.5) + params.added_scale * real(5.5);
    let det_xq = m_x * I - real(0.0529);
    let m_y = real(11.5) + params.added_scale * real(12.7);
    let det_yp = m_y * I - real(0.0529);
    let m_z = real(11.5) + params.added_scale * real(14.57);
    let t18 = real(-0.23) / det_xq;
    let t19 = real(0.23) / det_yp;
    let inverse_M = Matrix::rows([
        [I / det_xq, real(0.0), real(0.0), real(0.0), t18, real(0.0)],
        [real(0.0), I / det_yp, real(0.0), t19, real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(1.0) / m_z, real(0.0), real(0.0), real(0.0)],
        [real(0.0), t19, real(0.0), m_y / det_yp, real(0.0), real(0.0)],
        [t18, real(0.0), real(0.0), real(0.0), m_x / det_xq, real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(1.0) / I],
    ]);
    let down_axis = Vector([t10, t11, t12]);
    let p = x2[3];
    let q = x2[4];
    let r = x2[5];
    let surge = x2[0];
    let sway = x2[1];
    let heave = x2[2];
    let t20 = q * heave - r * sway;
    let t21 = r * surge - p * heave;
    let carried = Vector([t20, t21, p * sway - q * surge]);
    let t22 = Vector([real(5.5) * surge, real(12.7) * sway, real(14.57) * heave]);
    let added_momentum = t22 * params.added_scale;
    let t23 = Vector([
        (real(4.03) + real(18.18) * surge.abs()) * surge,
        (real(6.22) + real(21.66) * sway.abs()) * sway,
        (real(5.18) + real(36.99) * heave.abs()) * heave,
    ]);
    let drag = t23 * params.drag_scale;
    let t24 = Vector([p * r, q * r, -(p * p) - q * q]) * real(0.02);
    let t25 = down_axis * real(-1.9849999999999852) - (carried + t24) * real(11.5);
    let t26 = Vector([
        q * added_momentum[2] - r * added_momentum[1],
        r * added_momentum[0] - p * added_momentum[2],
        p * added_momentum[1] - q * added_momentum[0],
    ]);
    let force = t25 - t26 - drag;
    let t27 = Vector([
        (real(0.07) + real(1.55) * p.abs()) * p,
        (real(0.07) + real(1.55) * q.abs()) * q,
        (real(0.07) + real(1.55) * r.abs()) * r,
    ]);
    let drag_torque = t27 * params.torque_scale;
    let t28 = Vector([t21 - real(9.81) * t11, real(9.81) * t10 - t20, real(0.0)])
        * real(0.23);
    let t29 = Vector([
        sway * added_momentum[2] - heave * added_momentum[1],
        heave * added_momentum[0] - surge * added_momentum[2],
        surge * added_momentum[1] - sway * added_momentum[0],
    ]);
    let moment = t28 - t29 - drag_torque;
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
    let t30 = real(0.3) * t;
    let t31 = real(0.1) * t;
    let t32 = real(0.4) * t;
    let t33 = real(0.2) * t;
    let t34 = Vector([t30, t33, t32, t31]);
    let [sin_t30, sin_t33, sin_t32, sin_t31] = t34.sin().0;
    let t35 = real(2.0) * sin_t30;
    let t36 = t * t;
    let t37 = (real(-0.02) * (t36 * t)).exp();
    let t38 = real(1.0) - t37;
    let [cos_t30, cos_t33, cos_t32, cos_t31] = t34.cos().0;
    let t39 = real(2.0) * (real(1.0) - cos_t30);
    let t40 = real(1.0) - cos_t33;
    let t41 = real(0.26179938779914946) * sin_t32;
    let t42 = real(0.4363323129985824) * sin_t30;
    let t43 = real(1.0471975511965979) * sin_t33;
    // y_r(t)
    let y_r = Vector([t35 * t38, t39 * t38, t40 * t38, t41 * t38, t42 * t38, t43 * t38]);
    let t44 = cos_t30 * real(0.3);
    let t45 = real(2.0) * t44;
    let t46 = real(-0.02) * (real(3.0) * t36);
    let t47 = t37 * t46;
    let t48 = sin_t30 * real(0.3);
    let t49 = real(2.0) * t48;
    let t50 = sin_t33 * real(0.2);
    let t51 = real(0.26179938779914946) * (cos_t32 * real(0.4));
    let t52 = real(0.4363323129985824) * t44;
    let t53 = cos_t33 * real(0.2);
    let t54 = real(1.0471975511965979) * t53;
    // y_r'
    let y_r_dot = Vector([
        t38 * t45 - t35 * t47,
        t38 * t49 - t39 * t47,
        t38 * t50 - t40 * t47,
        t38 * t51 - t41 * t47,
        t38 * t52 - t42 * t47,
        t38 * t54 - t43 * t47,
    ]);
    let t55 = (real(-0.3) * t).exp();
    // k_1(t)
    let k1 = real(0.4) * t55 + real(0.1);
    // k1'
    let k1_dot = real(0.4) * (t55 * real(-0.3));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t56 = k1 * k1;
    let t57 = s1 / t56;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t57 * t57);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t58 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t58;
    let t59 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t59;

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = J.sum_squares();

    // -- robust feedback of block 1 (31) (63) --
    let t60 = E1.sin();
    let t61 = t60 * cosE1;
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1
        * T::select(E1_free.lt(real(1e-300)), real(1.0), t61 * (real(1.0) / E1_free))
        + e1 * real(0.5);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    let t62 = real(0.5) * G_norm2_1;
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * t62;
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t63 = state.zeta1 * real(5.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t63 - y_r_dot + D_hat1 + Lam1;
    let t64 = J.solve(bracket1);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t64;

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = J * state.zeta2 - t63;

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
    let t65 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t65 * P2;

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
    let t66 = Vector([
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
    let w_hat2 = state.th2 + t66;
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
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // ||Ybar_2||^2
    let Ybar_square2 = real(54.0);
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(7.3484692283495345);
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5)
        + real(0.30000000000000004) + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(3.25) + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(3.0);
    // e / (2 cos^2 E) (63)
    let Lam2_network = e2 * real(0.5);
    let t67 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t67 * state.eps2;
    let t68 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t68 * t68) * real(0.25);
    let t69 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t69 + real(1.0)).sqrt();
    let t70 = H_norm2_2 * Ybar_norm2;
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t70 * state.sigma2 * s_scale2);
    let t71 = state.phi2 * state.phi2;
    let t72 = Psi2 / (t71 + t69);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t72;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t73 = F2 + A_hat2;
    let t74 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t73 - h1_dot + t74 + D_hat2 + Lam2;
    let t75 = inverse_M.solve(bracket2);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t75;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
        .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = inverse_M * (u_sat + t75) - t74;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    let t76 = Vector([
        real(9.0) * w_hat2[1],
        real(-6.0) * w_hat2[1] - w_hat2[0],
        real(9.0) * w_hat2[3],
        real(-6.0) * w_hat2[3] - w_hat2[2],
        real(9.0) * w_hat2[5],
        real(-6.0) * w_hat2[5] - w_hat2[4],
        real(9.0) * w_hat2[7],
        real(-6.0) * w_hat2[7] - w_hat2[6],
        real(9.0) * w_hat2[9],
        real(-6.0) * w_hat2[9] - w_hat2[8],
        real(9.0) * w_hat2[11],
        real(-6.0) * w_hat2[11] - w_hat2[10],
    ]);
    let t77 = t73 + inverse_M * u - h1_dot + t74;
    let t78 = Vector([
        real(-8.0) * t77[0],
        real(5.8) * t77[0],
        real(-8.0) * t77[1],
        real(5.8) * t77[1],
        real(-8.0) * t77[2],
        real(5.8) * t77[2],
        real(-8.0) * t77[3],
        real(5.8) * t77[3],
        real(-8.0) * t77[4],
        real(5.8) * t77[4],
        real(-8.0) * t77[5],
        real(5.8) * t77[5],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2)
    let th2_dot = t76 - t78;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t67) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t70 * t69 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t72 + real(0.5);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.2)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (pose) (11) --
    // d_1(t)
    let d1 = Vector([
        real(0.2) + real(0.1) * sin_t33,
        real(-0.1) + real(0.1) * cos_t33,
        real(0.05) * sin_t31,
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    let t79 = J * x2;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = t79 + d1;

    // -- true dynamics of block 2 (velocity) (11) --
    let t80 = real(0.16) + plant.added_scale * real(0.12);
    let t81 = real(11.5) + plant.added_scale * real(5.5);
    let t82 = t81 * t80 - real(0.0529);
    let t83 = real(-0.23) / t82;
    let t84 = real(11.5) + plant.added_scale * real(12.7);
    let t85 = t84 * t80 - real(0.0529);
    let t86 = real(0.23) / t85;
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([
        [t80 / t82, real(0.0), real(0.0), real(0.0), t83, real(0.0)],
        [real(0.0), t80 / t85, real(0.0), t86, real(0.0), real(0.0)],
        [
            real(0.0),
            real(0.0),
            real(1.0) / (real(11.5) + plant.added_scale * real(14.57)),
            real(0.0),
            real(0.0),
            real(0.0),
        ],
        [real(0.0), t86, real(0.0), t84 / t85, real(0.0), real(0.0)],
        [t83, real(0.0), real(0.0), real(0.0), t81 / t82, real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(1.0) / t80],
    ]);
    let t87 = t22 * plant.added_scale;
    let t88 = Vector([
        q * t87[2] - r * t87[1],
        r * t87[0] - p * t87[2],
        p * t87[1] - q * t87[0],
    ]);
    let t89 = t25 - t88 - t23 * plant.drag_scale;
    let t90 = Vector([
        sway * t87[2] - heave * t87[1],
        heave * t87[0] - surge * t87[2],
        surge * t87[1] - sway * t87[0],
    ]);
    let t91 = t28 - t90 - t27 * plant.torque_scale;
    // F_2 with the plant's parameters
    let F2_plant = G2_plant * Vector([t89[0], t89[1], t89[2], t91[0], t91[1], t91[2]]);
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
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;
    let t92: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.1, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.1, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.1, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.01, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.01, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.01],
    ]);
    // H_2 Sigma_2
    let HSigma2 = G2_plant * t92;

    // -- Lyapunov function of block 1 (23) (52) --
    let t93 = t56 * t56 * real(0.15915494309189535);
    let t94 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t93 * t94;
    // D_1 - D_hat_1
    let D_error1 = d1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t64;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t69 * real(0.25);
    let t95 = t65 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t95[(0, 0)] + t95[(1, 1)] + t95[(2, 2)] + t95[(3, 3)] + t95[(4, 4)]
        + t95[(5, 5)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);
    let t96 = real(6.0) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t96 * t96 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t71 * real(0.5);

    // -- Lyapunov function (52) --
    let t97 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2;
    // V, sum of the parts above
    let V = t97 + V_sigma2 + V_phi2;

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
    let t98 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t98 + t98;
    let t99 = (t57 + t57) * (s1_flow / t56 - t57 / t56 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t99;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t94 * (real(4.0) * (t56 * k1) * k1_dot * real(0.15915494309189535))
        + t93 * (E1_flow / t58);
    // d1'
    let d1_dot = Vector([
        real(0.1) * t53,
        -(real(0.1) * t50),
        real(0.05) * (cos_t31 * real(0.1)),
        real(0.0),
        real(0.0),
        real(0.0),
    ]);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow - (D_hat1 + t79);
    // D_error1' along the flow
    let D_error1_flow = d1_dot - D_hat1_flow;
    let t100 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t100 + t100) * real(0.5);
    let t101 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t101 + t101) * real(0.5);
    let t102 = sin_psi * x1_flow[5];
    let t103 = sin_theta * x1_flow[4];
    let t104 = -(cos_theta * t102 + cos_psi * t103);
    let t105 = cos_theta * x1_flow[4];
    let t106 = cos_psi * t105 - sin_theta * t102;
    let t107 = cos_phi * x1_flow[3];
    let t108 = cos_psi * x1_flow[5];
    let t109 = sin_phi * x1_flow[3];
    let t110 = sin_phi * t106 + t3 * t107 - (cos_phi * t108 - sin_psi * t109);
    let t111 = cos_phi * t106 - t3 * t109 + (sin_phi * t108 + sin_psi * t107);
    let t112 = cos_theta * t108 - sin_psi * t103;
    let t113 = sin_theta * t108 + sin_psi * t105;
    let t114 = sin_phi * t113 + t7 * t107 - (cos_phi * t102 + cos_psi * t109);
    let t115 = cos_phi * t113 - t7 * t109 - (cos_psi * t107 - sin_phi * t102);
    let t116 = -t105;
    let t117 = cos_theta * t107 - sin_phi * t103;
    let t118 = -(cos_phi * t103 + cos_theta * t109);
    let t119 = x1_flow[4] / (cos_theta * cos_theta);
    let t120 = tan_theta * t107 + sin_phi * t119;
    let t121 = cos_phi * t119 - tan_theta * t109;
    let t122 = -t109;
    let t123 = -t107;
    let t124 = t107 / cos_theta + t16 / cos_theta * t103;
    let t125 = t17 / cos_theta * t103 - t109 / cos_theta;
    // G1' along the flow
    let G1_flow = Matrix::rows([
        [t104, t110, t111, real(0.0), real(0.0), real(0.0)],
        [t112, t114, t115, real(0.0), real(0.0), real(0.0)],
        [t116, t117, t118, real(0.0), real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), t120, t121],
        [real(0.0), real(0.0), real(0.0), real(0.0), t122, t123],
        [real(0.0), real(0.0), real(0.0), real(0.0), t124, t125],
    ]);
    let t126 = -(real(0.3) * t48);
    let t127 = t45 * t47;
    let t128 = t46 * t47 + t37 * (real(-0.02) * (real(3.0) * (t + t)));
    let t129 = t49 * t47;
    let t130 = t50 * t47;
    let t131 = t51 * t47;
    let t132 = t52 * t47;
    let t133 = t54 * t47;
    // y_r''
    let y_r_dot2 = Vector([
        t38 * (real(2.0) * t126) - t127 - (t127 + t35 * t128),
        t38 * (real(2.0) * (real(0.3) * t44)) - t129 - (t129 + t39 * t128),
        t38 * (real(0.2) * t53) - t130 - (t130 + t40 * t128),
        t38 * (real(0.26179938779914946) * -(real(0.4) * (sin_t32 * real(0.4)))) - t131
            - (t131 + t41 * t128),
        t38 * (real(0.4363323129985824) * t126) - t132 - (t132 + t42 * t128),
        t38 * (real(1.0471975511965979) * -(real(0.2) * t50)) - t133
            - (t133 + t43 * t128),
    ]);
    let t134 = real(1.5697963267948967) / E1_free;
    let t135 = real(1.0).lt(t134);
    let t136 = T::select(t135, real(1.0), t134);
    let t137 = T::select(E1.eq(real(0.0)), real(1.0), t61 / E1);
    let t138 = t136 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t135, real(0.0), -(t137 * (t134 / E1_free * E1_free_flow)));
    let t139 = t137 * t136;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        e1[0] * t138 + t139 * e1_flow[0] + real(0.5) * e1_flow[0],
        e1[1] * t138 + t139 * e1_flow[1] + real(0.5) * e1_flow[1],
        e1[2] * t138 + t139 * e1_flow[2] + real(0.5) * e1_flow[2],
        e1[3] * t138 + t139 * e1_flow[3] + real(0.5) * e1_flow[3],
        e1[4] * t138 + t139 * e1_flow[4] + real(0.5) * e1_flow[4],
        e1[5] * t138 + t139 * e1_flow[5] + real(0.5) * e1_flow[5],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(t60 * E1_flow);
    // sec2E1' along the flow
    let sec2E1_flow = -(sec2E1 / t58 * ((cosE1 + cosE1) * cosE1_flow));
    // c1' along the flow
    let c1_flow = e1 * (s1_flow * sec2E1 + s1 * sec2E1_flow) + e1_flow * t59;
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t140 = (t2 + t2) * t104 + (t4 + t4) * t110 + (t5 + t5) * t111;
    let t141 = t140 + (t6 + t6) * t112 + (t8 + t8) * t114;
    let t142 = t141 + (t9 + t9) * t115 + (t10 - sin_theta) * t116;
    let t143 = t142 + (t11 + t11) * t117 + (t12 + t12) * t118;
    let t144 = t143 + (t13 + t13) * t120 + (t14 + t14) * t121;
    let t145 = t144 + (cos_phi + cos_phi) * t122 + (t15 - sin_phi) * t123;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t145 + (t16 + t16) * t124 + (t17 + t17) * t125;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t62;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(5.0) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + J.solve(bracket1_flow - G1_flow * t64);
    let t146 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t146 + t146) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t147 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t147 + t147;
    let t148 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t148 + t148) * real(0.25);
    let t149 = W2_dot.transpose() * state.W2 + t65 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t149[(0, 0)] + t149[(1, 1)] + t149[(2, 2)] + t149[(3, 3)]
        + t149[(4, 4)] + t149[(5, 5)]) * real(0.5);
    let t150 = Vector([
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
    let w_hat2_flow = th2_dot + t150;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t151 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t151 + t151) * real(0.5);
    let t152 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t152 + t152) * real(0.5);
    let t153 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t153 + t153) * real(5.0);
    let t154 = -sigma2_dot * t96;
    // V_sigma2' along the flow
    let V_sigma2_flow = (t154 + t154) * real(0.5);
    let t155 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t155 + t155) * real(0.5);
    let t156 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t156 + t156;
    let t157 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t157 + t157;
    let t158 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t158 + t158) * real(0.25);
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = Vector([
        real(-8.0) * HSigma2[(0, 0)],
        real(5.8) * HSigma2[(0, 0)],
        real(-8.0) * HSigma2[(1, 0)],
        real(5.8) * HSigma2[(1, 0)],
        real(-8.0) * HSigma2[(2, 0)],
        real(5.8) * HSigma2[(2, 0)],
        real(-8.0) * HSigma2[(3, 0)],
        real(5.8) * HSigma2[(3, 0)],
        real(-8.0) * HSigma2[(4, 0)],
        real(5.8) * HSigma2[(4, 0)],
        real(-8.0) * HSigma2[(5, 0)],
        real(5.8) * HSigma2[(5, 0)],
    ]);
    let t159 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t159 + t159) * real(0.5);
    let t160 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t160 + t160;
    let t161 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t161 + t161;
    let t162 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t162 + t162) * real(0.25);
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = Vector([
        real(-8.0) * HSigma2[(0, 1)],
        real(5.8) * HSigma2[(0, 1)],
        real(-8.0) * HSigma2[(1, 1)],
        real(5.8) * HSigma2[(1, 1)],
        real(-8.0) * HSigma2[(2, 1)],
        real(5.8) * HSigma2[(2, 1)],
        real(-8.0) * HSigma2[(3, 1)],
        real(5.8) * HSigma2[(3, 1)],
        real(-8.0) * HSigma2[(4, 1)],
        real(5.8) * HSigma2[(4, 1)],
        real(-8.0) * HSigma2[(5, 1)],
        real(5.8) * HSigma2[(5, 1)],
    ]);
    let t163 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t163 + t163) * real(0.5);
    let t164 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t164 + t164;
    let t165 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t165 + t165;
    let t166 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t166 + t166) * real(0.25);
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = Vector([
        real(-8.0) * HSigma2[(0, 2)],
        real(5.8) * HSigma2[(0, 2)],
        real(-8.0) * HSigma2[(1, 2)],
        real(5.8) * HSigma2[(1, 2)],
        real(-8.0) * HSigma2[(2, 2)],
        real(5.8) * HSigma2[(2, 2)],
        real(-8.0) * HSigma2[(3, 2)],
        real(5.8) * HSigma2[(3, 2)],
        real(-8.0) * HSigma2[(4, 2)],
        real(5.8) * HSigma2[(4, 2)],
        real(-8.0) * HSigma2[(5, 2)],
        real(5.8) * HSigma2[(5, 2)],
    ]);
    let t167 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t167 + t167) * real(0.5);
    let t168 = HSigma2_4.dot(e2);
    // D^1 s2 along noise4
    let s2_noise4_ = t168 + t168;
    let t169 = HSigma2_4.sum_squares();
    // D^2 s2 along noise4
    let s2_noise4_2 = t169 + t169;
    let t170 = s2_noise4_2 * s2 + s2_noise4_ * s2_noise4_;
    // D^2 V_T2 along noise4
    let V_T2_noise4_2 = (t170 + t170) * real(0.25);
    // D^1 w_hat2 along noise4
    let w_hat2_noise4_ = Vector([
        real(-8.0) * HSigma2[(0, 3)],
        real(5.8) * HSigma2[(0, 3)],
        real(-8.0) * HSigma2[(1, 3)],
        real(5.8) * HSigma2[(1, 3)],
        real(-8.0) * HSigma2[(2, 3)],
        real(5.8) * HSigma2[(2, 3)],
        real(-8.0) * HSigma2[(3, 3)],
        real(5.8) * HSigma2[(3, 3)],
        real(-8.0) * HSigma2[(4, 3)],
        real(5.8) * HSigma2[(4, 3)],
        real(-8.0) * HSigma2[(5, 3)],
        real(5.8) * HSigma2[(5, 3)],
    ]);
    let t171 = w_hat2_noise4_.sum_squares();
    // D^2 V_D2 along noise4
    let V_D2_noise4_2 = (t171 + t171) * real(0.5);
    let t172 = HSigma2_5.dot(e2);
    // D^1 s2 along noise5
    let s2_noise5_ = t172 + t172;
    let t173 = HSigma2_5.sum_squares();
    // D^2 s2 along noise5
    let s2_noise5_2 = t173 + t173;
    let t174 = s2_noise5_2 * s2 + s2_noise5_ * s2_noise5_;
    // D^2 V_T2 along noise5
    let V_T2_noise5_2 = (t174 + t174) * real(0.25);
    // D^1 w_hat2 along noise5
    let w_hat2_noise5_ = Vector([
        real(-8.0) * HSigma2[(0, 4)],
        real(5.8) * HSigma2[(0, 4)],
        real(-8.0) * HSigma2[(1, 4)],
        real(5.8) * HSigma2[(1, 4)],
        real(-8.0) * HSigma2[(2, 4)],
        real(5.8) * HSigma2[(2, 4)],
        real(-8.0) * HSigma2[(3, 4)],
        real(5.8) * HSigma2[(3, 4)],
        real(-8.0) * HSigma2[(4, 4)],
        real(5.8) * HSigma2[(4, 4)],
        real(-8.0) * HSigma2[(5, 4)],
        real(5.8) * HSigma2[(5, 4)],
    ]);
    let t175 = w_hat2_noise5_.sum_squares();
    // D^2 V_D2 along noise5
    let V_D2_noise5_2 = (t175 + t175) * real(0.5);
    let t176 = HSigma2_6.dot(e2);
    // D^1 s2 along noise6
    let s2_noise6_ = t176 + t176;
    let t177 = HSigma2_6.sum_squares();
    // D^2 s2 along noise6
    let s2_noise6_2 = t177 + t177;
    let t178 = s2_noise6_2 * s2 + s2_noise6_ * s2_noise6_;
    // D^2 V_T2 along noise6
    let V_T2_noise6_2 = (t178 + t178) * real(0.25);
    // D^1 w_hat2 along noise6
    let w_hat2_noise6_ = Vector([
        real(-8.0) * HSigma2[(0, 5)],
        real(5.8) * HSigma2[(0, 5)],
        real(-8.0) * HSigma2[(1, 5)],
        real(5.8) * HSigma2[(1, 5)],
        real(-8.0) * HSigma2[(2, 5)],
        real(5.8) * HSigma2[(2, 5)],
        real(-8.0) * HSigma2[(3, 5)],
        real(5.8) * HSigma2[(3, 5)],
        real(-8.0) * HSigma2[(4, 5)],
        real(5.8) * HSigma2[(4, 5)],
        real(-8.0) * HSigma2[(5, 5)],
        real(5.8) * HSigma2[(5, 5)],
    ]);
    let t179 = w_hat2_noise6_.sum_squares();
    // D^2 V_D2 along noise6
    let V_D2_noise6_2 = (t179 + t179) * real(0.5);
    let t180 = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow + V_eps2_flow;
    let t181 = t180 + V_sigma2_flow + V_phi2_flow + V_T2_noise1_2 * real(0.5)
        + V_D2_noise1_2 * real(0.5) + V_T2_noise2_2 * real(0.5);
    let t182 = t181 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + V_T2_noise4_2 * real(0.5);
    let t183 = t182 + V_D2_noise4_2 * real(0.5) + V_T2_noise5_2 * real(0.5)
        + V_D2_noise5_2 * real(0.5) + V_T2_noise6_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t183 + V_D2_noise6_2 * real(0.5) + real(0.005000000000000001)
        + real(0.005000000000000001) + real(0.005000000000000001)
        + real(0.020000000000000004) + real(0.020000000000000004)
        + real(0.020000000000000004);
    LyapunovOutputs { V, LV }
}
