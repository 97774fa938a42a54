// SHA-256 of the text below: 03e93efd6c43584d59ac1baee9ac239843264bb278ef833e71e9aff9223e7d0f
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 eaec085705702921007be8e6ce482fe8ff0bdc8ba32b44e358ef4f3b85103df7
// lyapunov: 282 additions, 423 multiplications, 15 divisions, 2 square roots, 13 elementary functions, 14 comparisons and selections

//! `motor_arm`: Lyapunov function and its generator.
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
/// Operations: 282 additions, 423 multiplications, 15 divisions, 2 square roots, 13 elementary
/// functions, 14 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    w2: Vector<T, 1>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let rate = x2[0];
    let weight = (real(0.253) + params.load_mass) * real(0.305) * real(9.81);
    let angle = x1[0];
    let inertia = real(0.017315216666666668) + params.load_mass * real(0.093025)
        + real(2.0) * params.load_mass * real(0.000529) * real(0.2);
    let amps = x3[0];

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = real(0.01625) * rate;
    let t2 = angle.sin();
    let t3 = real(1.0) / inertia;
    // F_2(x_1 .. x_2)
    let F2 = Vector([-(t1 + weight * t2) * t3]);
    let t4 = real(0.9) * t3;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t4]]);
    // H_2(x_1 .. x_2)
    let H2 = Matrix::rows([[real(0.01) * t3]]);

    // -- known dynamics of block 3 (current) (11) --
    // F_3(x_1 .. x_3)
    let F3 = Vector([-(real(5.0) * amps + real(0.9) * rate) * real(40.0)]);

    // -- reference and constraints --
    let t5 = real(20.0) * t;
    let t6 = Vector([t, t5]);
    let [sin_t, sin_t5] = t6.sin().0;
    let t7 = real(FRAC_PI_2) * sin_t;
    let t8 = t * t;
    let t9 = (real(-0.1) * (t8 * t)).exp();
    let t10 = real(1.0) - t9;
    // y_r(t)
    let y_r = Vector([t7 * t10]);
    let [cos_t, cos_t5] = t6.cos().0;
    let t11 = real(FRAC_PI_2) * cos_t;
    let t12 = real(-0.1) * (real(3.0) * t8);
    let t13 = t9 * t12;
    // y_r'
    let y_r_dot = Vector([t10 * t11 - t7 * t13]);
    let t14 = (real(-2.0) * t).exp();
    // k_1(t)
    let k1 = real(0.3) * t14 + real(0.05);
    // k1'
    let k1_dot = real(0.3) * (t14 * real(-2.0));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t15 = k1 * k1;
    let t16 = real(1.0) / t15;
    let t17 = s1 * t16;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t17 * t17);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t18 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t18;
    let t19 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t19;

    // -- robust feedback of block 1 (31) (63) --
    let t20 = E1.sin();
    let t21 = T::select(E1.eq(real(0.0)), real(1.0), t20 * cosE1 / E1);
    let t22 = real(1.0) / E1_free;
    let t23 = real(1.5697963267948967) * t22;
    // Lam_1 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1
        * (real(3.2199999999999998) * (t21 * real(1.0).min(t23)) + real(1.72)
            + t19 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t24 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t24 - y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t24;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(50.0);

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2;

    // -- MTPN of block 2 (4) (16) --
    // z_2, network inputs
    let z2 = Vector([t2, rate]);
    // P_2 = P_m(z_2), 6 nodes
    let P2 = polynomials::basis2(z2);
    let t25 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t25 * P2;

    // -- disturbance observer of block 2 (20) (49) --
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + e2 * real(10.0);

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(3.0);
    // S_2
    let S2: Matrix<T, 1, 1> = Matrix::from_f64([[10.0]]);
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t26 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t26 * t26 * real(0.5) + real(0.5) + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    let t27 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t27 * state.eps2;
    let t28 = s2 * s2;
    let t29 = (t28 + real(1.0)).sqrt();
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / t29;
    let t30 = real(0.05) * G_norm2_2;
    let t31 = s_c1 * s_c1;
    let t32 = t26 * state.sigma2;
    let t33 = t32 * s_scale2;
    let t34 = state.phi2 * state.phi2;
    let t35 = t34 + t28;
    let t36 = Psi2 / t35;
    let t37 = real(45.0) + s2 * real(0.5) + s2 * t30 + real(0.5) + t31 * real(0.25)
        + t33;
    // Lam_2 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31) + ||L||^2/(2 eta_1) c^T
    // (63) + eta_2/2 ||G||^2 c^T (37) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b) (64) + ||G||^4
    // ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38) + ||H||^2 ||Ybar||
    // sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7) + e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2 = e2 * (t37 + t36) + Lam2_error_bound;
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t38 = F2 + A_hat2;
    let t39 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t38 - h1_dot + t39 + w_hat2 + Lam2;
    let t40 = real(1.0) / t4;
    let t41 = bracket2 * t40;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -t41;

    // -- auxiliary system of block 2 (13) (E1) --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = G2 * state.zeta3 - t39;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2)
    let th2_dot = w_hat2 * real(-12.0)
        - (t38 + G2 * (x3 - state.zeta3) - h1_dot + t39) * real(10.0);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t27) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t26 * t28 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t36 + real(0.5);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.2)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- dynamic surface filter of block 2 (33) --
    // h_2' = (alpha_2 - h_2) / Fl_2
    let h2_dot = (alpha2 - state.h2) * real(200.0);

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 - state.h2 - state.zeta3;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();

    // -- disturbance observer of block 3 (20) (49) --
    // D_hat_3 = th_3 + S_3 x_3
    let D_hat3 = state.th3 + x3 * real(50.0);

    // -- robust feedback of block 3 (31) (63) --
    let t42 = G_norm2_2 * s_c2;
    // Lam_3 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31) + eta_1/2 c^T (36) +
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam3 = e3 * (real(225.0) + s3 * real(0.5) + t42 * t42 * real(0.015625));

    // -- control (64) of block 3 --
    let t43 = state.zeta3 * real(100.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = F3 - h2_dot + t43 + D_hat3 + Lam3;
    let t44 = bracket3 * real(0.025);
    // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let u = -t44;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-40.0))).min(Vector::splat(real(40.0)));

    // -- auxiliary system of block 3 (13) (E1) --
    // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
    let zeta3_dot = (u_sat + t44) * real(40.0) - t43;

    // -- true dynamics of block 2 (speed) (11) --
    let t45 = real(1.0)
        / (real(0.017315216666666668) + plant.load_mass * real(0.093025)
            + real(2.0) * plant.load_mass * real(0.000529) * real(0.2));
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        -(t1 + (real(0.253) + plant.load_mass) * real(0.305) * real(9.81) * t2) * t45,
    ]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[real(0.9) * t45]]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = w2 * real(-2.0);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * x3 + w2;

    // -- true dynamics of block 3 (current) (11) --
    // d_3(t)
    let d3 = Vector([real(0.5) * sin_t5 * real(40.0)]);
    let t46 = u_sat * real(40.0);
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3 + t46 + d3;

    // -- Lyapunov function of block 1 (23) (52) --
    let t47 = t15 * t15 * real(0.15915494309189535);
    let t48 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t47 * t48;
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + bracket1;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t28 * real(0.25);
    let t49 = t25 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = t49[(0, 0)] * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // chi_2 = h_2 - alpha_2 (34)
    let chi2 = state.h2 + t41;
    // 1/2 ||chi_2||^2
    let V_chi2 = chi2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);
    let t50 = real(1.0) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t50 * t50 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t34 * real(0.5);

    // -- Lyapunov function of block 3 (23) (52) --
    // k_3^4/(2 pi) tan E_3
    let V_T3 = s3 * s3 * real(0.25);
    // D_3 - D_hat_3
    let D_error3 = d3 - D_hat3;
    // 1/2 ||theta_3 - th_3||^2
    let V_D3 = D_error3.sum_squares() * real(0.5);
    // 1/2 ||zeta_3||^2
    let V_zeta3 = state.zeta3.sum_squares() * real(0.5);

    // -- Lyapunov function (52) --
    let t51 = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_chi2 + V_eps2;
    // V, sum of the parts above
    let V = t51 + V_sigma2 + V_phi2 + V_T3 + V_D3 + V_zeta3;

    // -- Ito generator (2) --
    let t52 = real(0.01) * t45;
    // column 1 of HSigma2
    let HSigma2_1 = Vector([t52]);
    // e1' along the flow
    let e1_flow = x2 - y_r_dot - zeta1_dot;
    let t53 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t53 + t53;
    let t54 = (t17 + t17) * (s1_flow * t16 - t17 * t16 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t54;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t48 * (real(4.0) * (t15 * k1) * k1_dot * real(0.15915494309189535))
        + t47 * (E1_flow / t18);
    let t55 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t55 + t55) * real(0.5);
    let t56 = t11 * t13;
    let t57 = t56 + t7 * (t12 * t13 + t9 * (real(-0.1) * (real(3.0) * (t + t))));
    // y_r''
    let y_r_dot2 = Vector([t10 * (real(FRAC_PI_2) * -sin_t) - t56 - t57]);
    let t58 = real(1.0).lt(t23);
    let t59 = T::select(t58, real(1.0), t23);
    let t60 = t59 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t58, real(0.0), -(t21 * (t23 * t22 * E1_free_flow)));
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(3.2199999999999998) * e1[0] * t60
            + t21 * t59 * (real(3.2199999999999998) * e1_flow[0])
            + real(1.72) * e1_flow[0],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(t20 * E1_flow);
    let t61 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t61 + e1_flow * t19;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1_flow * real(0.5);
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = zeta1_dot * real(20.0) - y_r_dot2 + Lam1_flow;
    // alpha1' along the flow
    let alpha1_flow = -bracket1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + bracket1_flow;
    let t62 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t62 + t62) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t63 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t63 + t63;
    let t64 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t64 + t64) * real(0.25);
    let t65 = W2_dot.transpose();
    let t66 = t65 * state.W2 + t25 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = t66[(0, 0)] * real(0.5);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + e2_flow * real(10.0);
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t67 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t67 + t67) * real(0.5);
    let t68 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t68 + t68) * real(0.5);
    let t69 = angle.cos() * x2[0];
    // F2' along the flow
    let F2_flow = Vector([-((real(0.01625) * x2_flow[0] + weight * t69) * t3)]);
    // z2' along the flow
    let z2_flow = Vector([t69, x2_flow[0]]);
    // P2' along the flow
    let P2_flow = polynomials::basis2_rate(z2, z2_flow);
    // A_hat2' along the flow
    let A_hat2_flow = t65 * P2 + t25 * P2_flow;
    // h1_dot' along the flow
    let h1_dot_flow = (alpha1_flow - h1_dot) * real(50.0);
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    let t70 = e2[0].tanh();
    let t71 = real(1.0) - t70 * t70;
    // Lam2_error_bound' along the flow
    let Lam2_error_bound_flow = Vector([
        t70 * eps2_dot + state.eps2 * (t71 * e2_flow[0]),
    ]);
    let t72 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t72 + t72;
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * ((s_c1 + s_c1) * s_c1_flow) + t31 * e2_flow[0]) * real(0.25),
    ]);
    let t73 = s_scale2 * s_scale2;
    let t74 = s2 + s2;
    let t75 = t74 * s2_flow;
    let t76 = t29 + t29;
    let t77 = e2 * (t26 * sigma2_dot * s_scale2 - t32 * (t73 * (t75 / t76)));
    // Lam2_noise' along the flow
    let Lam2_noise_flow = t77 + e2_flow * t33;
    let t78 = real(1.0) / t35;
    let t79 = Psi2 * t78;
    let t80 = t79 * t78;
    // Lam2_diffusion' along the flow
    let Lam2_diffusion_flow = Vector([
        t79 * e2_flow[0] - e2[0] * (t80 * ((state.phi2 + state.phi2) * phi2_dot + t75)),
    ]);
    let t81 = real(0.5) + t30;
    // Lam2' along the flow
    let Lam2_flow = e2_flow * real(45.5) + c2_flow * t81 + Lam2_error_bound_flow
        + Lam2_coupling_flow + Lam2_noise_flow + Lam2_diffusion_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow + A_hat2_flow - h1_dot_flow + zeta2_dot * real(50.0)
        + w_hat2_flow + Lam2_flow;
    // chi2' along the flow
    let chi2_flow = h2_dot + bracket2_flow * t40;
    let t82 = chi2_flow.dot(chi2);
    // V_chi2' along the flow
    let V_chi2_flow = (t82 + t82) * real(0.5);
    let t83 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t83 + t83) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t50 - t50 * sigma2_dot) * real(0.5);
    let t84 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t84 + t84) * real(0.5);
    // e3' along the flow
    let e3_flow = x3_flow - h2_dot - zeta3_dot;
    let t85 = e3_flow.dot(e3);
    // s3' along the flow
    let s3_flow = t85 + t85;
    let t86 = s3_flow * s3;
    // V_T3' along the flow
    let V_T3_flow = (t86 + t86) * real(0.25);
    // d3'
    let d3_dot = Vector([real(0.5) * (cos_t5 * real(20.0)) * real(40.0)]);
    // D_hat3' along the flow
    let D_hat3_flow = x3_flow * real(50.0) - (D_hat3 + F3 + t46) * real(50.0);
    // D_error3' along the flow
    let D_error3_flow = d3_dot - D_hat3_flow;
    let t87 = D_error3_flow.dot(D_error3);
    // V_D3' along the flow
    let V_D3_flow = (t87 + t87) * real(0.5);
    let t88 = zeta3_dot.dot(state.zeta3);
    // V_zeta3' along the flow
    let V_zeta3_flow = (t88 + t88) * real(0.5);
    let t89 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t89 + t89;
    let t90 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t90 + t90;
    let t91 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t91 + t91) * real(0.25);
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = HSigma2_1 * real(10.0);
    let t92 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t92 + t92) * real(0.5);
    // D^1 F2 along noise1
    let F2_noise1_ = Vector([-(real(0.01625) * t52 / inertia)]);
    // D^1 z2 along noise1
    let z2_noise1_ = Vector([real(0.0), t52]);
    // D^1 P2 along noise1
    let P2_noise1_ = polynomials::basis2_rate(z2, z2_noise1_);
    // D^1 A_hat2 along noise1
    let A_hat2_noise1_ = t25 * P2_noise1_;
    // D^1 c2 along noise1
    let c2_noise1_ = e2 * s2_noise1_ + HSigma2_1 * s2;
    let t93 = t71 * t52;
    // D^1 Lam2_error_bound along noise1
    let Lam2_error_bound_noise1_ = Vector([state.eps2 * t93]);
    // D^1 Lam2_coupling along noise1
    let Lam2_coupling_noise1_ = Vector([t31 * t52 * real(0.25)]);
    let t94 = t74 * s2_noise1_;
    let t95 = t73 * (t94 / t76);
    // D^1 s_scale2 along noise1
    let s_scale2_noise1_ = -t95;
    let t96 = t32 * s_scale2_noise1_;
    // D^1 Lam2_noise along noise1
    let Lam2_noise_noise1_ = e2 * t96 + HSigma2_1 * t33;
    let t97 = t80 * t94;
    // D^1 Lam2_diffusion along noise1
    let Lam2_diffusion_noise1_ = Vector([t79 * t52 - e2[0] * t97]);
    // D^1 Lam2 along noise1
    let Lam2_noise1_ = HSigma2_1 * real(45.5) + c2_noise1_ * t81
        + Lam2_error_bound_noise1_ + Lam2_coupling_noise1_ + Lam2_noise_noise1_
        + Lam2_diffusion_noise1_;
    // D^1 bracket2 along noise1
    let bracket2_noise1_ = F2_noise1_ + A_hat2_noise1_ + w_hat2_noise1_ + Lam2_noise1_;
    // D^1 chi2 along noise1
    let chi2_noise1_ = bracket2_noise1_ * t40;
    // D^2 z2 along noise1
    let z2_noise1_2: Vector<T, 2> = Vector::zero();
    // D^2 P2 along noise1
    let P2_noise1_2 = polynomials::basis2_rate2(z2, z2_noise1_, z2_noise1_2);
    // D^2 A_hat2 along noise1
    let A_hat2_noise1_2 = t25 * P2_noise1_2;
    let t98 = s2_noise1_ + s2_noise1_;
    // D^2 c2 along noise1
    let c2_noise1_2 = e2 * s2_noise1_2 + HSigma2_1 * t98;
    // D^2 Lam2_error_bound along noise1
    let Lam2_error_bound_noise1_2 = Vector([state.eps2 * -(t52 * ((t70 + t70) * t93))]);
    let t99 = real(1.0) / t76;
    let t100 = t94 * t99;
    let t101 = s2_noise1_ * t98 + t74 * s2_noise1_2;
    let t102 = t100 * (t73 * t100 * s_scale2 + t73 * s_scale2 * t100);
    // D^2 s_scale2 along noise1
    let s_scale2_noise1_2 = -(t73 * (t101 * t99 - t100 * t99 * (t100 + t100)) - t102);
    // D^2 Lam2_noise along noise1
    let Lam2_noise_noise1_2 = e2 * (t32 * s_scale2_noise1_2)
        + HSigma2_1 * (t96 - t32 * t95);
    let t103 = t52 * t97;
    let t104 = e2[0] * (t80 * t101 - t94 * (t97 * t78 + t80 * t78 * t94));
    // D^2 Lam2_diffusion along noise1
    let Lam2_diffusion_noise1_2 = Vector([-t103 - (t103 + t104)]);
    // D^2 Lam2 along noise1
    let Lam2_noise1_2 = c2_noise1_2 * t81 + Lam2_error_bound_noise1_2
        + Lam2_noise_noise1_2 + Lam2_diffusion_noise1_2;
    // D^2 bracket2 along noise1
    let bracket2_noise1_2 = A_hat2_noise1_2 + Lam2_noise1_2;
    // D^2 chi2 along noise1
    let chi2_noise1_2 = bracket2_noise1_2 * t40;
    let t105 = chi2_noise1_2.dot(chi2) + chi2_noise1_.sum_squares();
    // D^2 V_chi2 along noise1
    let V_chi2_noise1_2 = (t105 + t105) * real(0.5);
    let t106 = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow + V_chi2_flow + V_eps2_flow;
    let t107 = t106 + V_sigma2_flow + V_phi2_flow + V_T3_flow + V_D3_flow + V_zeta3_flow
        + V_T2_noise1_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t107 + V_D2_noise1_2 * real(0.5) + V_chi2_noise1_2 * real(0.5)
        + real(0.125);
    LyapunovOutputs { V, LV }
}
