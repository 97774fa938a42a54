// SHA-256 of the text below: b463c08b41078c656fe5b8fd87a02ae664bfa96c2f35f1ab21efa7b0c3dd3ef1
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 252 additions, 356 multiplications, 10 divisions, 2 square roots, 9 elementary functions, 15 comparisons and selections

//! `active_suspension`: Lyapunov function and its generator.
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
/// Operations: 252 additions, 356 multiplications, 10 divisions, 2 square roots, 9 elementary
/// functions, 15 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    w2: Vector<T, 3>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let z = x1[0];
    let v = x2[0];
    let f = x3[0];

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = z * z;
    let t2 = -(real(16000.0) * z + real(400000.0) * (t1 * z) + real(1000.0) * v);
    let t3 = real(1.0) / params.body_mass;
    // F_2(x_1 .. x_2)
    let F2 = Vector([t2 * t3]);
    let t4 = real(1000.0) * t3;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t4]]);

    // -- known dynamics of block 3 (actuator) (11) --
    // F_3(x_1 .. x_3)
    let F3 = Vector([real(-60.0) * f]);

    // -- reference and constraints --
    let t5 = real(0.8) * t;
    let t6 = t5.sin();
    let t7 = (real(3.0) * t6).tanh();
    // y_r(t)
    let y_r = Vector([real(0.05) * t7]);
    let t8 = real(1.0) - t7 * t7;
    let t9 = real(3.0) * (t5.cos() * real(0.8));
    let t10 = t8 * t9;
    // y_r'
    let y_r_dot = Vector([real(0.05) * t10]);
    let t11 = (real(-2.0) * t).exp();
    // k_1(t)
    let k1 = real(0.03) * t11 + real(0.002);
    // k1'
    let k1_dot = real(0.03) * (t11 * real(-2.0));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t12 = k1 * k1;
    let t13 = real(1.0) / t12;
    let t14 = s1 * t13;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t14 * t14);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t15 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t15;
    let t16 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t16;

    // -- robust feedback of block 1 (31) --
    let t17 = E1.sin();
    let t18 = t17 * cosE1;
    let t19 = real(1.0) / E1_free;
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1
        * (real(6.0) * T::select(E1_free.lt(real(1e-300)), real(1.0), t18 * t19)
            + real(4.0) + t16 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t20 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t20 - y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t20;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(200.0);

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
    let z2 = Vector([z * real(20.0), v * real(5.0)]);
    // P_2 = P_m(z_2), 10 nodes
    let P2 = polynomials::basis2(z2);
    let t21 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t21 * P2;

    // -- disturbance observer of block 2 (49) --
    // S_2, observer gain
    let S2: Matrix<T, 3, 1> = Matrix::from_f64([[2.0], [-0.18], [14.0]]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + S2 * e2;
    // L_2
    let L2: Matrix<T, 1, 3> = Matrix::from_f64([[53.3, 53.3, 3.33]]);
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = L2 * w_hat2;

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();

    // -- robust feedback of block 2 (31) --
    let t22 = (e2 * real(10.0)).tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t22 * state.eps2;
    let t23 = real(0.05) * G_norm2_2;
    let t24 = s_c1 * s_c1;
    let t25 = e2
        * (real(30.0) + s2 * real(2846.4344499999997) + s2 * t23 + real(0.5)
            + t24 * real(0.25));
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + eta_2/2 ||G||^2 c^T (37) + e / (2 cos^2 E)
    // (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of
    // the outer block (38)
    let Lam2 = t25 + Lam2_error_bound;
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t26 = F2 + A_hat2;
    let t27 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t26 - h1_dot + t27 + D_hat2 + Lam2;
    let t28 = real(1.0) / t4;
    let t29 = bracket2 * t28;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -t29;

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = G2 * state.zeta3 - t27;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (50) --
    // M_2 - S_2 L_2
    let w2_closed: Matrix<T, 3, 3> = Matrix::from_f64([
        [-107.1, -106.6, -6.66],
        [9.594, 9.594, 1.5994000000000002],
        [-746.1999999999999, -3913.2, -52.220000000000006],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2) (50)
    let th2_dot = w2_closed * w_hat2
        - S2 * (t26 + G2 * (x3 - state.zeta3) - h1_dot + t27);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t22) - state.eps2);

    // -- dynamic surface filter of block 2 (33) --
    // h_2' = (alpha_2 - h_2) / Fl_2
    let h2_dot = (alpha2 - state.h2) * real(1000.0);

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 - state.h2 - state.zeta3;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();

    // -- noise terms of block 3 (58) (62) --
    // Psi_3 = ||H_3||^4 ||Ybar_3||^2 varsigma_3^2/2 + 2 ||N_3||^2 + eta_noise ||S_3 H_3||^4 (62)
    let Psi3 = real(0.09331199999999999);

    // -- robust feedback of block 3 (63) --
    let t30 = s3 * s3;
    // 1 / sqrt(s_3^2 + varsigma_3^2)
    let s_scale3 = real(1.0) / (t30 + real(0.010000000000000002)).sqrt();
    let t31 = G_norm2_2 * s_c2;
    let t32 = state.phi3 * state.phi3;
    let t33 = Psi3 / (t32 + t30);
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
    // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 + e
    // Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam3 = e3
        * (real(150.0) + t31 * t31 * real(0.25) + real(4.32) * state.sigma3 * s_scale3
            + t33);

    // -- control (64) of block 3 --
    let t34 = state.zeta3 * real(100.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = F3 - h2_dot + t34 + Lam3;
    let t35 = bracket3 * real(0.016666666666666666);
    // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let u = -t35;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-2.0))).min(Vector::splat(real(2.0)));

    // -- auxiliary system of block 3 (13), erratum 1 --
    // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
    let zeta3_dot = (u_sat + t35) * real(60.0) - t34;

    // -- noise bound of block 3 (67) --
    // sigma_hat_3' = taubar_3 (||H_3||^2 ||Ybar_3|| s_3^2 / (cos^2 E_3 sqrt(s_3^2 + varsigma_3^2))
    // - lambda_sigma sigma_hat_3)
    let sigma3_dot = real(4.32) * t30 * s_scale3 - real(0.1) * state.sigma3;

    // -- compensation of block 3 (68) --
    // Psi_3/(phi_3^2 + s_3^2) + kappa_phi
    let phi3_decay = t33 + real(0.5);
    // phi_3' = -phi_3 Psi_3/(phi_3^2 + s_3^2) - kappa_phi phi_3 if ||e_3|| >= iota_phi, else 0
    let phi3_dot = T::select(
        s3.sqrt().ge(real(0.02)),
        -state.phi3 * phi3_decay,
        real(0.0),
    );

    // -- true dynamics of block 2 (speed) (11) --
    let t36 = real(1.0) / plant.body_mass;
    // F_2 with the plant's parameters
    let F2_plant = Vector([t2 * t36]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[real(1000.0) * t36]]);
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    // w_2' = M_2 w_2 (12)
    let w2_flow = Vector([
        real(-0.5) * w2[0],
        w2[2],
        real(-3167.0) * w2[1] + real(-5.6) * w2[2],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * x3 + d2;

    // -- true dynamics of block 3 (actuator) (11) --
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3 + u_sat * real(60.0);

    // -- Lyapunov function of block 1 (23) (52) --
    let t37 = t12 * t12 * real(0.15915494309189535);
    let t38 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t37 * t38;
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + bracket1;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = s2 * s2 * real(0.25);
    let t39 = t21 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = t39[(0, 0)] * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // chi_2 = h_2 - alpha_2 (34)
    let chi2 = state.h2 + t29;
    // 1/2 ||chi_2||^2
    let V_chi2 = chi2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);

    // -- Lyapunov function of block 3 (23) (52) --
    // k_3^4/(2 pi) tan E_3
    let V_T3 = t30 * real(0.25);
    // 1/2 ||zeta_3||^2
    let V_zeta3 = state.zeta3.sum_squares() * real(0.5);
    let t40 = real(1.0) - state.sigma3;
    // (sigma_bar_3 - sigma_hat_3)^2/(2 taubar_3)
    let V_sigma3 = t40 * t40 * real(0.5);
    // phi_3^2/2
    let V_phi3 = t32 * real(0.5);

    // -- Lyapunov function (52) --
    let t41 = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_chi2 + V_eps2;
    // V, sum of the parts above
    let V = t41 + V_T3 + V_zeta3 + V_sigma3 + V_phi3;

    // -- Ito generator (2) --
    // column 1 of HSigma3
    let HSigma3_1: Vector<T, 1> = Vector::from_f64([1.2]);
    // e1' along the flow
    let e1_flow = x2 - y_r_dot - zeta1_dot;
    let t42 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t42 + t42;
    let t43 = (t14 + t14) * (s1_flow * t13 - t14 * t13 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t43;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t38 * (real(4.0) * (t12 * k1) * k1_dot * real(0.15915494309189535))
        + t37 * (E1_flow / t15);
    let t44 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t44 + t44) * real(0.5);
    let t45 = t8 * (real(3.0) * -(real(0.8) * (t6 * real(0.8))))
        - t9 * ((t7 + t7) * t10);
    // y_r''
    let y_r_dot2 = Vector([real(0.05) * t45]);
    let t46 = real(1.5697963267948967) * t19;
    let t47 = real(1.0).lt(t46);
    let t48 = T::select(t47, real(1.0), t46);
    let t49 = T::select(E1.eq(real(0.0)), real(1.0), t18 / E1);
    let t50 = t48 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t47, real(0.0), -(t49 * (t46 * t19 * E1_free_flow)));
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(6.0) * e1[0] * t50 + t49 * t48 * (real(6.0) * e1_flow[0])
            + real(4.0) * e1_flow[0],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(t17 * E1_flow);
    let t51 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t51 + e1_flow * t16;
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
    let t52 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t52 + t52) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t53 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t53 + t53;
    let t54 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t54 + t54) * real(0.25);
    let t55 = W2_dot.transpose();
    let t56 = t55 * state.W2 + t21 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = t56[(0, 0)] * real(0.5);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + S2 * e2_flow;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t57 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t57 + t57) * real(0.5);
    let t58 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t58 + t58) * real(0.5);
    // F2' along the flow
    let F2_flow = Vector([
        -((real(16000.0) * x2[0] + real(400000.0) * (real(3.0) * t1 * x2[0])
            + real(1000.0) * x2_flow[0]) * t3),
    ]);
    // z2' along the flow
    let z2_flow = Vector([x2[0] * real(20.0), x2_flow[0] * real(5.0)]);
    // P2' along the flow
    let P2_flow = polynomials::basis2_rate(z2, z2_flow);
    // A_hat2' along the flow
    let A_hat2_flow = t55 * P2 + t21 * P2_flow;
    // h1_dot' along the flow
    let h1_dot_flow = (alpha1_flow - h1_dot) * real(200.0);
    // D_hat2' along the flow
    let D_hat2_flow = L2 * w_hat2_flow;
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    let t59 = (real(10.0) * e2[0]).tanh();
    // Lam2_error_bound' along the flow
    let Lam2_error_bound_flow = Vector([
        t59 * eps2_dot
            + state.eps2 * ((real(1.0) - t59 * t59) * (real(10.0) * e2_flow[0])),
    ]);
    let t60 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t60 + t60;
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * ((s_c1 + s_c1) * s_c1_flow) + t24 * e2_flow[0]) * real(0.25),
    ]);
    // Lam2' along the flow
    let Lam2_flow = e2_flow * real(30.5) + c2_flow * (real(2846.4344499999997) + t23)
        + Lam2_error_bound_flow + Lam2_coupling_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow + A_hat2_flow - h1_dot_flow + zeta2_dot * real(50.0)
        + D_hat2_flow + Lam2_flow;
    // chi2' along the flow
    let chi2_flow = h2_dot + bracket2_flow * t28;
    let t61 = chi2_flow.dot(chi2);
    // V_chi2' along the flow
    let V_chi2_flow = (t61 + t61) * real(0.5);
    let t62 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t62 + t62) * real(5.0);
    // e3' along the flow
    let e3_flow = x3_flow - h2_dot - zeta3_dot;
    let t63 = e3_flow.dot(e3);
    // s3' along the flow
    let s3_flow = t63 + t63;
    let t64 = s3_flow * s3;
    // V_T3' along the flow
    let V_T3_flow = (t64 + t64) * real(0.25);
    let t65 = zeta3_dot.dot(state.zeta3);
    // V_zeta3' along the flow
    let V_zeta3_flow = (t65 + t65) * real(0.5);
    // V_sigma3' along the flow
    let V_sigma3_flow = (-sigma3_dot * t40 - t40 * sigma3_dot) * real(0.5);
    let t66 = phi3_dot * state.phi3;
    // V_phi3' along the flow
    let V_phi3_flow = (t66 + t66) * real(0.5);
    let t67 = HSigma3_1.dot(e3);
    // D^1 s3 along noise3
    let s3_noise3_ = t67 + t67;
    // D^2 s3 along noise3
    let s3_noise3_2 = real(2.88);
    let t68 = s3_noise3_2 * s3 + s3_noise3_ * s3_noise3_;
    // D^2 V_T3 along noise3
    let V_T3_noise3_2 = (t68 + t68) * real(0.25);
    let t69 = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow + V_chi2_flow + V_eps2_flow;
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t69 + V_T3_flow + V_zeta3_flow + V_sigma3_flow + V_phi3_flow + real(0.0002)
        + real(0.08000000000000002) + V_T3_noise3_2 * real(0.5);
    LyapunovOutputs { V, LV }
}
