// SHA-256 of the text below: 687417687323b4608c0450ece066fdc4b3ce89df5b7fd2ee6f13efc66f499df0
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 142 additions, 202 multiplications, 8 divisions, 0 square roots, 10 elementary functions, 18 comparisons and selections

//! `pendulum`: Lyapunov function and its generator.
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
/// Operations: 142 additions, 202 multiplications, 8 divisions, 0 square roots, 10 elementary
/// functions, 18 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let theta = x1[0];
    let omega = x2[0];
    let inertia = params.mass * real(0.25);

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = theta.sin();
    let t2 = real(-19.62) * t1;
    let t3 = real(0.1) * omega;
    let t4 = real(1.0) / inertia;
    // F_2(x_1 .. x_2)
    let F2 = Vector([t2 - t3 * t4]);
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t4]]);

    // -- reference and constraints --
    let t5 = real(3.0) * t;
    let t6 = Vector([t, t5]);
    let [sin_t, sin_t5] = t6.sin().0;
    // y_r(t)
    let y_r = Vector([real(FRAC_PI_2) * sin_t]);
    let [cos_t, cos_t5] = t6.cos().0;
    // y_r'
    let y_r_dot = Vector([real(FRAC_PI_2) * cos_t]);
    let t7 = (real(-2.0) * t).exp();
    // k_1(t)
    let k1 = (real(30.0) * t7 + real(6.0)) * real(0.017453292519943295);
    // k1'
    let k1_dot = real(0.017453292519943295) * (real(30.0) * (t7 * real(-2.0)));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t8 = k1 * k1;
    let t9 = real(1.0) / t8;
    let t10 = s1 * t9;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t10 * t10);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t11 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t11;
    let t12 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t12;

    // -- robust feedback of block 1 (31) --
    let t13 = E1.sin();
    let t14 = t13 * cosE1;
    let t15 = real(1.0) / E1_free;
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1
        * (real(5.0) * T::select(E1_free.lt(real(1e-300)), real(1.0), t14 * t15)
            + real(4.0) + t12 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t16 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t16 - y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t16;

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
    let z2 = Vector([t1, omega]);
    // P_2 = P_m(z_2), 6 nodes
    let P2 = polynomials::basis2(z2);
    let t17 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t17 * P2;

    // -- disturbance observer of block 2 (20) --
    // D_hat_2 = th_2 + S_2 x_2
    let D_hat2 = state.th2 + x2 * real(20.0);

    // -- robust feedback of block 2 (63) --
    let t18 = s_c1 * s_c1;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam2 = e2 * (real(22.5) + s2 * real(0.5) + t18 * real(0.25));

    // -- control (64) of block 2 --
    let t19 = F2 + A_hat2;
    let t20 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t19 - h1_dot + t20 + D_hat2 + Lam2;
    let t21 = real(1.0) / t4;
    let t22 = bracket2 * t21;
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t22;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-8.0))).min(Vector::splat(real(8.0)));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = G2 * (u_sat + t22) - t20;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- true dynamics of block 2 (speed) (11) --
    let t23 = real(1.0) / (plant.mass * real(0.25));
    // F_2 with the plant's parameters
    let F2_plant = Vector([t2 - t3 * t23]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([[t23]]);
    // d_2(t)
    let d2 = Vector([real(1.0) + real(2.0) * sin_t5]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;

    // -- Lyapunov function of block 1 (23) (52) --
    let t24 = t8 * t8 * real(0.15915494309189535);
    let t25 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t24 * t25;
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + bracket1;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = s2 * s2 * real(0.25);
    let t26 = t17 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = t26[(0, 0)] * real(0.5);
    let t27 = G2_plant - G2;
    // D_2 = d_2 + model error of block 2
    let D2 = d2 + (F2_plant - F2) + t27 * u_sat;
    // D_2 - D_hat_2
    let D_error2 = D2 - D_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = D_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);

    // -- Lyapunov function (52) --
    // V, sum of the parts above
    let V = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;

    // -- Ito generator (2) --
    // e1' along the flow
    let e1_flow = x2 - y_r_dot - zeta1_dot;
    let t28 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t28 + t28;
    let t29 = (t10 + t10) * (s1_flow * t9 - t10 * t9 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t29;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t25 * (real(4.0) * (t8 * k1) * k1_dot * real(0.15915494309189535))
        + t24 * (E1_flow / t11);
    let t30 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t30 + t30) * real(0.5);
    // y_r''
    let y_r_dot2 = Vector([real(FRAC_PI_2) * -sin_t]);
    let t31 = real(1.5697963267948967) * t15;
    let t32 = real(1.0).lt(t31);
    let t33 = T::select(t32, real(1.0), t31);
    let t34 = T::select(E1.eq(real(0.0)), real(1.0), t14 / E1);
    let t35 = t33 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t32, real(0.0), -(t34 * (t31 * t15 * E1_free_flow)));
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(5.0) * e1[0] * t35 + t34 * t33 * (real(5.0) * e1_flow[0])
            + real(4.0) * e1_flow[0],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(t13 * E1_flow);
    let t36 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t36 + e1_flow * t12;
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
    let t37 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t37 + t37) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t38 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t38 + t38;
    let t39 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t39 + t39) * real(0.25);
    let t40 = W2_dot.transpose();
    let t41 = t40 * state.W2 + t17 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = t41[(0, 0)] * real(0.5);
    // d2'
    let d2_dot = Vector([real(2.0) * (cos_t5 * real(3.0))]);
    let t42 = theta.cos() * x2[0];
    let t43 = real(19.62) * t42;
    let t44 = real(0.1) * x2_flow[0];
    // F2_plant' along the flow
    let F2_plant_flow = Vector([-(t43 + t44 * t23)]);
    // F2' along the flow
    let F2_flow = Vector([-(t43 + t44 * t4)]);
    // z2' along the flow
    let z2_flow = Vector([t42, x2_flow[0]]);
    // P2' along the flow
    let P2_flow = polynomials::basis2_rate(z2, z2_flow);
    // A_hat2' along the flow
    let A_hat2_flow = t40 * P2 + t17 * P2_flow;
    // h1_dot' along the flow
    let h1_dot_flow = (alpha1_flow - h1_dot) * real(50.0);
    // D_hat2' along the flow
    let D_hat2_flow = x2_flow * real(20.0) - (D_hat2 + t19 + G2 * u_sat) * real(20.0);
    // Lam0_2' along the flow
    let Lam0_2_flow = e2_flow * real(22.5);
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    // Lam2_disturbance' along the flow
    let Lam2_disturbance_flow = c2_flow * real(0.5);
    let t45 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t45 + t45;
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * ((s_c1 + s_c1) * s_c1_flow) + t18 * e2_flow[0]) * real(0.25),
    ]);
    // Lam2' along the flow
    let Lam2_flow = Lam0_2_flow + Lam2_disturbance_flow + Lam2_coupling_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow + A_hat2_flow - h1_dot_flow + zeta2_dot * real(50.0)
        + D_hat2_flow + Lam2_flow;
    // u' along the flow
    let u_flow = -(bracket2_flow * t21);
    let t46 = real(-8.0).lt(u[0]);
    // u_sat' along the flow
    let u_sat_flow = Vector([
        T::select(
            T::select(t46, u[0], real(-8.0)).lt(real(8.0)),
            T::select(t46, u_flow[0], real(0.0)),
            real(0.0),
        ),
    ]);
    // D2' along the flow
    let D2_flow = d2_dot + (F2_plant_flow - F2_flow) + t27 * u_sat_flow;
    // D_error2' along the flow
    let D_error2_flow = D2_flow - D_hat2_flow;
    let t47 = D_error2_flow.dot(D_error2);
    // V_D2' along the flow
    let V_D2_flow = (t47 + t47) * real(0.5);
    let t48 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t48 + t48) * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow;
    LyapunovOutputs { V, LV }
}
