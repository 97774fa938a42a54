// SHA-256 of the text below: adc54b26f6c66375388a2829a82c69cacce8604a5165ff131eaca5eec0c0bd57
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 237 additions, 315 multiplications, 6 divisions, 0 square roots, 11 elementary functions, 13 comparisons and selections

//! `flexible_joint`: Lyapunov function and its generator.
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
/// Operations: 237 additions, 315 multiplications, 6 divisions, 0 square roots, 11 elementary
/// functions, 13 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    x4: Vector<T, 1>,
    w4: Vector<T, 3>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;
    let LyapunovValues1 {
        c2,
        G_norm2_2,
        h2_dot,
        e3,
        s3,
        t31,
        t32,
        zeta3_dot,
        h3_dot,
        e4,
        s4,
        S4,
        zeta4_dot,
        th4_dot,
        w4_flow,
        x4_flow,
        chi3,
        w_error4,
        V,
        V_T1_flow,
        V_zeta1_flow,
        V_chi1_flow,
        V_T2_flow,
        V_W2_flow,
        V_D2_flow,
        V_zeta2_flow,
        c2_flow,
        alpha2_flow,
        V_chi2_flow,
    } = T::outlined(LyapunovPart1 {
        t,
        x1,
        x2,
        x3,
        x4,
        w4,
        state,
        params,
        plant,
    });

    // -- Ito generator (2) --
    // e3' along the flow
    let e3_flow = x4 - h2_dot - zeta3_dot;
    let t63 = e3_flow.dot(e3);
    // s3' along the flow
    let s3_flow = t63 + t63;
    let t64 = s3_flow * s3;
    // V_T3' along the flow
    let V_T3_flow = (t64 + t64) * real(0.25);
    let t65 = zeta3_dot.dot(state.zeta3);
    // V_zeta3' along the flow
    let V_zeta3_flow = (t65 + t65) * real(0.5);
    // h2_dot' along the flow
    let h2_dot_flow = (alpha2_flow - h2_dot) * real(500.0);
    // Lam0_3' along the flow
    let Lam0_3_flow = e3_flow * real(100.0);
    // c3' along the flow
    let c3_flow = e3 * s3_flow + e3_flow * s3;
    // Lam3_filter' along the flow
    let Lam3_filter_flow = c3_flow * real(0.5);
    let t66 = c2_flow.dot(c2);
    // s_c2' along the flow
    let s_c2_flow = t66 + t66;
    // Lam3_coupling' along the flow
    let Lam3_coupling_flow = Vector([
        (e3[0] * ((t31 + t31) * (G_norm2_2 * s_c2_flow)) + t32 * e3_flow[0])
            * real(2.5e-9),
    ]);
    // Lam3' along the flow
    let Lam3_flow = Lam0_3_flow + Lam3_filter_flow + Lam3_coupling_flow;
    // bracket3' along the flow
    let bracket3_flow = zeta3_dot * real(100.0) - h2_dot_flow + Lam3_flow;
    // chi3' along the flow
    let chi3_flow = h3_dot + bracket3_flow;
    let t67 = chi3_flow.dot(chi3);
    // V_chi3' along the flow
    let V_chi3_flow = (t67 + t67) * real(0.5);
    // e4' along the flow
    let e4_flow = x4_flow - h3_dot - zeta4_dot;
    let t68 = e4_flow.dot(e4);
    // s4' along the flow
    let s4_flow = t68 + t68;
    let t69 = s4_flow * s4;
    // V_T4' along the flow
    let V_T4_flow = (t69 + t69) * real(0.25);
    // w_hat4' along the flow
    let w_hat4_flow = th4_dot + S4 * e4_flow;
    // w_error4' along the flow
    let w_error4_flow = w4_flow - w_hat4_flow;
    let t70 = w_error4_flow.dot(w_error4);
    // V_D4' along the flow
    let V_D4_flow = (t70 + t70) * real(0.5);
    let t71 = zeta4_dot.dot(state.zeta4);
    // V_zeta4' along the flow
    let V_zeta4_flow = (t71 + t71) * real(0.5);
    let t72 = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow + V_chi2_flow + V_T3_flow;
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t72 + V_zeta3_flow + V_chi3_flow + V_T4_flow + V_D4_flow + V_zeta4_flow;
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    x4: Vector<T, 1>,
    w4: Vector<T, 3>,
    state: &'a State<T>,
    params: &'a Params<T>,
    plant: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    c2: Vector<T, 1>,
    G_norm2_2: T,
    h2_dot: Vector<T, 1>,
    e3: Vector<T, 1>,
    s3: T,
    t31: T,
    t32: T,
    zeta3_dot: Vector<T, 1>,
    h3_dot: Vector<T, 1>,
    e4: Vector<T, 1>,
    s4: T,
    S4: Matrix<T, 3, 1>,
    zeta4_dot: Vector<T, 1>,
    th4_dot: Vector<T, 3>,
    w4_flow: Vector<T, 3>,
    x4_flow: Vector<T, 1>,
    chi3: Vector<T, 1>,
    w_error4: Vector<T, 3>,
    V: T,
    V_T1_flow: T,
    V_zeta1_flow: T,
    V_chi1_flow: T,
    V_T2_flow: T,
    V_W2_flow: T,
    V_D2_flow: T,
    V_zeta2_flow: T,
    c2_flow: Vector<T, 1>,
    alpha2_flow: Vector<T, 1>,
    V_chi2_flow: T,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, x3, x4, w4, state, params, plant } = self;
        let real = T::from_f64;

        // -- plant model --
        let q1 = x1[0];
        let v2 = x4[0];
        let q2 = x3[0];
        let v1 = x2[0];

        // -- known dynamics of block 2 (link_rate) (11) --
        let t1 = q1.sin();
        // F_2(x_1 .. x_2)
        let F2 = Vector([
            -(params.weight * t1 + params.stiffness * q1) * real(32.25806451612903),
        ]);
        let t2 = params.stiffness * real(32.25806451612903);
        // G_2(x_1 .. x_2)
        let G2 = Matrix::rows([[t2]]);

        // -- known dynamics of block 4 (motor_rate) (11) --
        let t3 = real(0.007) * v2;
        let t4 = q2 - q1;
        // F_4(x_1 .. x_4)
        let F4 = Vector([-(t3 + params.stiffness * t4) * real(250.0)]);

        // -- reference and constraints --
        let t5 = real(3.0) * t;
        let t6 = Vector([t, t5]);
        let [sin_t, sin_t5] = t6.sin().0;
        let t7 = real(1.0471975511965979) * sin_t;
        let t8 = t * t;
        let t9 = (real(-0.1) * (t8 * t)).exp();
        let t10 = real(1.0) - t9;
        // y_r(t)
        let y_r = Vector([t7 * t10]);
        let [cos_t, cos_t5] = t6.cos().0;
        let t11 = real(1.0471975511965979) * cos_t;
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

        // -- robust feedback of block 1 (31) --
        let t20 = E1.sin();
        let t21 = t20 * cosE1;
        let t22 = real(1.0) / E1_free;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1
            * (real(5.0) * T::select(E1_free.lt(real(1e-300)), real(1.0), t21 * t22)
                + real(4.0) + t19 * real(0.5));
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t23 = state.zeta1 * real(20.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t23 - y_r_dot + Lam1;
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -bracket1;

        // -- auxiliary system of block 1 (13), erratum 1 --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = state.zeta2 - t23;

        // -- dynamic surface filter of block 1 (33) --
        // h_1' = (alpha_1 - h_1) / Fl_1
        let h1_dot = (alpha1 - state.h1) * real(100.0);

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
        let z2 = Vector([t1, v1]);
        // P_2 = P_m(z_2), 6 nodes
        let P2 = polynomials::basis2(z2);
        let t24 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t24 * P2;

        // -- disturbance observer of block 2 (20) --
        // D_hat_2 = th_2 + S_2 x_2
        let D_hat2 = state.th2 + x2 * real(40.0);

        // -- norms of block 2 --
        // ||G_2||^2
        let G_norm2_2 = G2.sum_squares();

        // -- robust feedback of block 2 (31) --
        let t25 = real(5e-5) * G_norm2_2;
        let t26 = s_c1 * s_c1;
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37) + ||G||^4
        // ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
        let Lam2 = e2 * (real(34.5) + s2 * real(0.5) + s2 * t25 + t26 * real(0.25));
        // ||c_2||^2
        let s_c2 = c2.sum_squares();

        // -- virtual control (31) of block 2 --
        let t27 = F2 + A_hat2;
        let t28 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = t27 - h1_dot + t28 + D_hat2 + Lam2;
        let t29 = real(1.0) / t2;
        let t30 = bracket2 * t29;
        // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let alpha2 = -t30;

        // -- auxiliary system of block 2 (13), erratum 1 --
        // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
        let zeta2_dot = G2 * state.zeta3 - t28;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

        // -- dynamic surface filter of block 2 (33) --
        // h_2' = (alpha_2 - h_2) / Fl_2
        let h2_dot = (alpha2 - state.h2) * real(500.0);

        // -- error variable of block 3 (14) --
        // e_3 = x_3 - h_2 - zeta_3
        let e3 = x3 - state.h2 - state.zeta3;

        // -- barrier of block 3 (23) (26) --
        // s_3 = e_3^T e_3
        let s3 = e3.sum_squares();
        // c_3 = s_3 e_3^T / cos^2 E_3
        let c3 = e3 * s3;

        // -- robust feedback of block 3 (31) --
        let t31 = G_norm2_2 * s_c2;
        let t32 = t31 * t31;
        // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E) e / (4
        // eta_3^4), G, c, eta_3 of the outer block (38)
        let Lam3 = e3 * (real(100.0) + s3 * real(0.5) + t32 * real(2.5e-9));
        // ||c_3||^2
        let s_c3 = c3.sum_squares();

        // -- virtual control (31) of block 3 --
        let t33 = state.zeta3 * real(100.0);
        // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
        let bracket3 = t33 - h2_dot + Lam3;
        // alpha_3 = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
        let alpha3 = -bracket3;

        // -- auxiliary system of block 3 (13), erratum 1 --
        // zeta_3' = -C_3 zeta_3 + G_3 zeta_4
        let zeta3_dot = state.zeta4 - t33;

        // -- dynamic surface filter of block 3 (33) --
        // h_3' = (alpha_3 - h_3) / Fl_3
        let h3_dot = (alpha3 - state.h3) * real(1000.0);

        // -- error variable of block 4 (14) --
        // e_4 = x_4 - h_3 - zeta_4
        let e4 = x4 - state.h3 - state.zeta4;

        // -- barrier of block 4 (23) (26) --
        // s_4 = e_4^T e_4
        let s4 = e4.sum_squares();

        // -- disturbance observer of block 4 (49) --
        // S_4, observer gain
        let S4: Matrix<T, 3, 1> = Matrix::from_f64([[40.0], [20.0], [60.0]]);
        // w_hat_4 = th_4 + S_4 e_4
        let w_hat4 = state.th4 + S4 * e4;
        // L_4
        let L4: Matrix<T, 1, 3> = Matrix::from_f64([[1.0, 1.0, 0.0]]);
        // D_hat_4 = L_4 w_hat_4
        let D_hat4 = L4 * w_hat4;

        // -- robust feedback of block 4 (63) --
        // Lam_4 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + ||G||^4 ||c||^4 cos^2(E) e / (4
        // eta_3^4), G, c, eta_3 of the outer block (38)
        let Lam4 = e4 * (real(265.0) + s4 + s_c3 * s_c3 * real(0.25));

        // -- control (64) of block 4 --
        let t34 = state.zeta4 * real(200.0);
        // F_4 + A_hat_4 - h_3' + C_4 zeta_4 + D_hat_4 + Lam_4
        let bracket4 = F4 - h3_dot + t34 + D_hat4 + Lam4;
        let t35 = bracket4 * real(0.004);
        // u = -G_4^-1 [ F_4 + A_hat_4 - h_3' + C_4 zeta_4 + D_hat_4 + Lam_4 ]
        let u = -t35;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u.max(Vector::splat(real(-3.0))).min(Vector::splat(real(3.0)));

        // -- auxiliary system of block 4 (13), erratum 1 --
        // zeta_4' = -C_4 zeta_4 + G_4 (sat(u) - u)
        let zeta4_dot = (u_sat + t35) * real(250.0) - t34;

        // -- observer dynamics of block 4 (50) --
        // th_4' = (M_4 - S_4 L_4) w_hat_4 - S_4 (F_4 + G_4 u - h_3' + C_4 zeta_4 + A_hat_4) (50) =
        // M_4 w_hat_4 + S_4 Lam_4, since the sum in brackets is -(D_hat_4 + Lam_4) under (64)
        let th4_dot = Vector([
            real(0.0),
            real(20.0) * w_hat4[2],
            real(-20.0) * w_hat4[1],
        ]) + S4 * Lam4;

        // -- true dynamics of block 2 (link_rate) (11) --
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            -(plant.weight * t1 + plant.stiffness * q1) * real(32.25806451612903),
        ]);
        // G_2 with the plant's parameters
        let G2_plant = Matrix::rows([[plant.stiffness * real(32.25806451612903)]]);
        // d_2(t)
        let d2 = Vector([real(0.1) * (real(1.0) + sin_t5) * real(32.25806451612903)]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = F2_plant + G2_plant * x3 + d2;

        // -- true dynamics of block 4 (motor_rate) (11) --
        // F_4 with the plant's parameters
        let F4_plant = Vector([-(t3 + plant.stiffness * t4) * real(250.0)]);
        // d_4 = L_4 w_4 (12)
        let d4 = L4 * w4;
        // w_4' = M_4 w_4 (12)
        let w4_flow = Vector([real(0.0), real(20.0) * w4[2], real(-20.0) * w4[1]]);
        // F_4 + G_4 x_5 + d_4
        let x4_flow = F4_plant + u_sat * real(250.0) + d4;

        // -- Lyapunov function of block 1 (23) (52) --
        let t36 = t15 * t15 * real(0.15915494309189535);
        let t37 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t36 * t37;
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + bracket1;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = s2 * s2 * real(0.25);
        let t38 = t24 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = t38[(0, 0)] * real(0.5);
        let t39 = G2_plant - G2;
        // D_2 = d_2 + model error of block 2
        let D2 = d2 + (F2_plant - F2) + t39 * x3;
        // D_2 - D_hat_2
        let D_error2 = D2 - D_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = D_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // chi_2 = h_2 - alpha_2 (34)
        let chi2 = state.h2 + t30;
        // 1/2 ||chi_2||^2
        let V_chi2 = chi2.sum_squares() * real(0.5);

        // -- Lyapunov function of block 3 (23) (52) --
        // k_3^4/(2 pi) tan E_3
        let V_T3 = s3 * s3 * real(0.25);
        // 1/2 ||zeta_3||^2
        let V_zeta3 = state.zeta3.sum_squares() * real(0.5);
        // chi_3 = h_3 - alpha_3 (34)
        let chi3 = state.h3 + bracket3;
        // 1/2 ||chi_3||^2
        let V_chi3 = chi3.sum_squares() * real(0.5);

        // -- Lyapunov function of block 4 (23) (52) --
        // k_4^4/(2 pi) tan E_4
        let V_T4 = s4 * s4 * real(0.25);
        // w_4 - w_hat_4
        let w_error4 = w4 - w_hat4;
        // 1/2 ||theta_4 - th_4||^2
        let V_D4 = w_error4.sum_squares() * real(0.5);
        // 1/2 ||zeta_4||^2
        let V_zeta4 = state.zeta4.sum_squares() * real(0.5);

        // -- Lyapunov function (52) --
        let t40 = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_chi2 + V_T3;
        // V, sum of the parts above
        let V = t40 + V_zeta3 + V_chi3 + V_T4 + V_D4 + V_zeta4;

        // -- Ito generator (2) --
        // e1' along the flow
        let e1_flow = x2 - y_r_dot - zeta1_dot;
        let t41 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t41 + t41;
        let t42 = (t17 + t17) * (s1_flow * t16 - t17 * t16 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t42;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t37
            * (real(4.0) * (t15 * k1) * k1_dot * real(0.15915494309189535))
            + t36 * (E1_flow / t18);
        let t43 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t43 + t43) * real(0.5);
        let t44 = t11 * t13;
        let t45 = t44 + t7 * (t12 * t13 + t9 * (real(-0.1) * (real(3.0) * (t + t))));
        // y_r''
        let y_r_dot2 = Vector([t10 * (real(1.0471975511965979) * -sin_t) - t44 - t45]);
        let t46 = real(1.5697963267948967) * t22;
        let t47 = real(1.0).lt(t46);
        let t48 = T::select(t47, real(1.0), t46);
        let t49 = T::select(E1.eq(real(0.0)), real(1.0), t21 / E1);
        let t50 = t48 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t47, real(0.0), -(t49 * (t46 * t22 * E1_free_flow)));
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            real(5.0) * e1[0] * t50 + t49 * t48 * (real(5.0) * e1_flow[0])
                + real(4.0) * e1_flow[0],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(t20 * E1_flow);
        let t51 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t51 + e1_flow * t19;
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
        let t56 = t55 * state.W2 + t24 * W2_dot;
        // V_W2' along the flow
        let V_W2_flow = t56[(0, 0)] * real(0.5);
        // d2'
        let d2_dot = Vector([
            real(0.1) * (cos_t5 * real(3.0)) * real(32.25806451612903),
        ]);
        let t57 = q1.cos() * x2[0];
        // F2_plant' along the flow
        let F2_plant_flow = Vector([
            -((plant.weight * t57 + plant.stiffness * x2[0]) * real(32.25806451612903)),
        ]);
        // F2' along the flow
        let F2_flow = Vector([
            -((params.weight * t57 + params.stiffness * x2[0]) * real(32.25806451612903)),
        ]);
        // D2' along the flow
        let D2_flow = d2_dot + (F2_plant_flow - F2_flow) + t39 * x4;
        // D_hat2' along the flow
        let D_hat2_flow = x2_flow * real(40.0) - (D_hat2 + t27 + G2 * x3) * real(40.0);
        // D_error2' along the flow
        let D_error2_flow = D2_flow - D_hat2_flow;
        let t58 = D_error2_flow.dot(D_error2);
        // V_D2' along the flow
        let V_D2_flow = (t58 + t58) * real(0.5);
        let t59 = zeta2_dot.dot(state.zeta2);
        // V_zeta2' along the flow
        let V_zeta2_flow = (t59 + t59) * real(0.5);
        // z2' along the flow
        let z2_flow = Vector([t57, x2_flow[0]]);
        // P2' along the flow
        let P2_flow = polynomials::basis2_rate(z2, z2_flow);
        // A_hat2' along the flow
        let A_hat2_flow = t55 * P2 + t24 * P2_flow;
        // h1_dot' along the flow
        let h1_dot_flow = (alpha1_flow - h1_dot) * real(100.0);
        // Lam0_2' along the flow
        let Lam0_2_flow = e2_flow * real(34.5);
        // c2' along the flow
        let c2_flow = e2 * s2_flow + e2_flow * s2;
        let t60 = c1_flow.dot(c1);
        // s_c1' along the flow
        let s_c1_flow = t60 + t60;
        // Lam2_coupling' along the flow
        let Lam2_coupling_flow = Vector([
            (e2[0] * ((s_c1 + s_c1) * s_c1_flow) + t26 * e2_flow[0]) * real(0.25),
        ]);
        // Lam2' along the flow
        let Lam2_flow = Lam0_2_flow + c2_flow * (real(0.5) + t25) + Lam2_coupling_flow;
        // bracket2' along the flow
        let bracket2_flow = F2_flow + A_hat2_flow - h1_dot_flow + zeta2_dot * real(50.0)
            + D_hat2_flow + Lam2_flow;
        let t61 = bracket2_flow * t29;
        // alpha2' along the flow
        let alpha2_flow = -t61;
        // chi2' along the flow
        let chi2_flow = h2_dot + t61;
        let t62 = chi2_flow.dot(chi2);
        // V_chi2' along the flow
        let V_chi2_flow = (t62 + t62) * real(0.5);
        LyapunovValues1 {
            c2,
            G_norm2_2,
            h2_dot,
            e3,
            s3,
            t31,
            t32,
            zeta3_dot,
            h3_dot,
            e4,
            s4,
            S4,
            zeta4_dot,
            th4_dot,
            w4_flow,
            x4_flow,
            chi3,
            w_error4,
            V,
            V_T1_flow,
            V_zeta1_flow,
            V_chi1_flow,
            V_T2_flow,
            V_W2_flow,
            V_D2_flow,
            V_zeta2_flow,
            c2_flow,
            alpha2_flow,
            V_chi2_flow,
        }
    }
}
