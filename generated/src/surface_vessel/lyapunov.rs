// SHA-256 of the text below: 1c61598fd5d50d2cef1fa0dfd00522a29b09bac28628227665a47d1518f9d6a9
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 744 additions, 939 multiplications, 13 divisions, 2 square roots, 13 elementary functions, 19 comparisons and selections

//! `surface_vessel`: Lyapunov function and its generator.
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
/// Operations: 744 additions, 939 multiplications, 13 divisions, 2 square roots, 13 elementary
/// functions, 19 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    w2: Vector<T, 6>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;
    let LyapunovValues1 {
        t7,
        t8,
        t9,
        G1,
        sway,
        r,
        surge,
        d_11,
        t4,
        t5,
        t20,
        t21,
        t22,
        t23,
        t24,
        t25,
        y_r_dot,
        k1,
        k1_dot,
        e1,
        s1,
        t26,
        t27,
        t28,
        E1_free,
        E1,
        cosE1,
        t29,
        sec2E1,
        t30,
        c1,
        t31,
        D_hat1,
        t32,
        t33,
        t34,
        t36,
        t37,
        t39,
        t40,
        t41,
        zeta1_dot,
        h1_dot,
        e2,
        s2,
        c2,
        P2,
        t42,
        t43,
        w_hat2,
        t46,
        t47,
        s_scale2,
        t49,
        t50,
        t51,
        Lam2,
        u_sat,
        zeta2_dot,
    } = T::outlined(LyapunovPart1 {
        t,
        x1,
        x2,
        state,
        params,
    });

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = (P2.outer(t42.hadamard(c2)) - state.W2 * real(0.1)) * real(10.0);

    // -- observer dynamics of block 2 (50) --
    let t55 = Vector([
        w_hat2[1],
        real(-36.0) * w_hat2[0] + real(-1.2) * w_hat2[1],
        w_hat2[3],
        real(-36.0) * w_hat2[2] + real(-1.2) * w_hat2[3],
        w_hat2[5],
        real(-36.0) * w_hat2[4] + real(-1.2) * w_hat2[5],
    ]);
    let t56 = Vector([
        real(-3.0) * Lam2[0],
        real(22.8) * Lam2[0],
        real(-3.0) * Lam2[1],
        real(22.8) * Lam2[1],
        real(-3.0) * Lam2[2],
        real(22.8) * Lam2[2],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = t55 + t56;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t46) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t49 * t47 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t51 + real(0.5);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.02)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (pose) (11) --
    let t57 = real(0.1) * t;
    let t58 = t57.sin();
    let t59 = t57.cos();
    // d_1(t)
    let d1 = Vector([
        real(0.03) + real(0.01) * t58,
        real(-0.02) + real(0.01) * t59,
        real(0.0),
    ]);
    let t60 = G1 * x2;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = t60 + d1;

    // -- true dynamics of block 2 (velocity) (11) --
    let t61 = real(23.8) + plant.added_scale * real(2.0);
    let t62 = real(23.8) + plant.added_scale * real(10.0);
    let t63 = real(1.76) + plant.added_scale;
    let t64 = real(1.0) / t61;
    let t65 = real(1.0) / (t62 * t63 - real(1.19858704));
    let t66 = t63 * t65;
    let t67 = real(-1.0948) * t65;
    let t68 = t62 * t65;
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([
        [t64, real(0.0), real(0.0)],
        [real(0.0), t66, t67],
        [real(0.0), t67, t68],
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([w2[1], w2[3], w2[5]]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = Vector([
        w2[1],
        real(-36.0) * w2[0] + real(-1.2) * w2[1],
        w2[3],
        real(-36.0) * w2[2] + real(-1.2) * w2[3],
        w2[5],
        real(-36.0) * w2[4] + real(-1.2) * w2[5],
    ]);
    let t69 = t62 * sway + real(1.0948) * r;
    let t70 = t61 * surge;
    let t71 = Vector([
        plant.damping_scale * d_11 * surge - t69 * r,
        t70 * r + plant.damping_scale * t4,
        t69 * surge - t70 * sway + plant.damping_scale * t5,
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = G2_plant * (u_sat - t71) + d2;

    // -- Lyapunov function of block 1 (23) (52) --
    let t72 = t26 * t26 * real(0.15915494309189535);
    let t73 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t72 * t73;
    // D_1 - D_hat_1
    let D_error1 = d1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t41;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t47 * real(0.25);
    let t74 = t43 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t74[(0, 0)] + t74[(1, 1)] + t74[(2, 2)]) * real(0.05);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);
    let t75 = real(3.0) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t75 * t75 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t50 * real(0.5);

    // -- Lyapunov function (52) --
    let t76 = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2;
    // V, sum of the parts above
    let V = t76 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    let t77 = t66 * real(0.02);
    let t78 = t67 * real(0.02);
    // column 2 of HSigma2
    let HSigma2_2 = Vector([real(0.0), t77, t78]);
    let t79 = t67 * real(0.005);
    let t80 = t68 * real(0.005);
    // column 3 of HSigma2
    let HSigma2_3 = Vector([real(0.0), t79, t80]);
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t81 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t81 + t81;
    let t82 = (t28 + t28) * (s1_flow * t27 - t28 * t27 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t82;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t73 * (real(4.0) * (t26 * k1) * k1_dot * real(0.15915494309189535))
        + t72 * (E1_flow / t29);
    // d1'
    let d1_dot = Vector([
        real(0.01) * (t59 * real(0.1)),
        -(real(0.01) * (t58 * real(0.1))),
        real(0.0),
    ]);
    // D_hat1' along the flow
    let D_hat1_flow = t31.hadamard(x1_flow) - t31.hadamard(D_hat1 + t60);
    // D_error1' along the flow
    let D_error1_flow = d1_dot - D_hat1_flow;
    let t83 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t83 + t83) * real(0.5);
    let t84 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t84 + t84) * real(0.5);
    let t85 = real(0.05) * (real(10.0) * (real(-0.1) * t22));
    // y_r''
    let y_r_dot2 = Vector([
        real(4.0) * (t21 * t85 - t23 * t25),
        real(4.0) * (t23 * t24 + t20 * t85),
        t85,
    ]);
    let t86 = real(1.5697963267948967) * t34;
    let t87 = real(1.0).lt(t86);
    let t88 = T::select(t87, real(1.0), t86);
    let t89 = T::select(E1.eq(real(0.0)), real(1.0), t33 / E1);
    let t90 = t88 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t87, real(0.0), -(t89 * (t86 * t34 * E1_free_flow)));
    let t91 = t89 * t88;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(0.55) * e1[0] * t90 + t91 * (real(0.55) * e1_flow[0])
            + real(0.25) * e1_flow[0],
        real(0.55) * e1[1] * t90 + t91 * (real(0.55) * e1_flow[1])
            + real(0.25) * e1_flow[1],
        real(0.75) * e1[2] * t90 + t91 * (real(0.75) * e1_flow[2])
            + real(0.25) * e1_flow[2],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(t32 * E1_flow);
    let t92 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t92 + e1_flow * t30;
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t93 = t8 * x1_flow[2];
    let t94 = -t93;
    let t95 = t7 * x1_flow[2];
    let t96 = t7 + t7;
    let t97 = t96 * t94 - (t9 - t8) * t95 + (t8 + t8) * t95;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t97 - t96 * t93;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t36;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = t37.hadamard(zeta1_dot) - y_r_dot2 + D_hat1_flow + Lam1_flow;
    let t98 = bracket1_flow
        - Vector([t94 * t40[0] - t95 * t40[1], t95 * t40[0] - t93 * t40[1], real(0.0)]);
    let t99 = t39.solve(Vector([t98[0], t98[1]]));
    // chi1' along the flow
    let chi1_flow = h1_dot + Vector([t99[0], t99[1], t98[2]]);
    let t100 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t100 + t100) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t101 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t101 + t101;
    let t102 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t102 + t102) * real(0.25);
    let t103 = W2_dot.transpose() * state.W2 + t43 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t103[(0, 0)] + t103[(1, 1)] + t103[(2, 2)]) * real(0.05);
    let t104 = Vector([
        real(-3.0) * e2_flow[0],
        real(22.8) * e2_flow[0],
        real(-3.0) * e2_flow[1],
        real(22.8) * e2_flow[1],
        real(-3.0) * e2_flow[2],
        real(22.8) * e2_flow[2],
    ]);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + t104;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t105 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t105 + t105) * real(0.5);
    let t106 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t106 + t106) * real(0.5);
    let t107 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t107 + t107) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t75 - t75 * sigma2_dot) * real(0.5);
    let t108 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t108 + t108) * real(0.5);
    let t109 = t64 * real(0.02);
    let t110 = t109 * e2[0];
    // D^1 s2 along noise1
    let s2_noise1_ = t110 + t110;
    let t111 = t109 * t109;
    // D^2 s2 along noise1
    let s2_noise1_2 = t111 + t111;
    let t112 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t112 + t112) * real(0.25);
    let t113 = real(-3.0) * t109;
    let t114 = real(22.8) * t109;
    let t115 = t113 * t113 + t114 * t114;
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t115 + t115) * real(0.5);
    let t116 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t116 + t116;
    let t117 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t117 + t117;
    let t118 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t118 + t118) * real(0.25);
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = Vector([
        real(-0.0),
        real(0.0),
        real(-3.0) * t77,
        real(22.8) * t77,
        real(-3.0) * t78,
        real(22.8) * t78,
    ]);
    let t119 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t119 + t119) * real(0.5);
    let t120 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t120 + t120;
    let t121 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t121 + t121;
    let t122 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t122 + t122) * real(0.25);
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = Vector([
        real(-0.0),
        real(0.0),
        real(-3.0) * t79,
        real(22.8) * t79,
        real(-3.0) * t80,
        real(22.8) * t80,
    ]);
    let t123 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t123 + t123) * real(0.5);
    let t124 = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow + V_eps2_flow;
    let t125 = t124 + V_sigma2_flow + V_phi2_flow + V_T2_noise1_2 * real(0.5)
        + V_D2_noise1_2 * real(0.5) + V_T2_noise2_2 * real(0.5);
    let t126 = t125 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + real(0.0008) + real(0.0008);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t126 + real(0.0032);
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    state: &'a State<T>,
    params: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    t7: T,
    t8: T,
    t9: T,
    G1: Matrix<T, 3, 3>,
    sway: T,
    r: T,
    surge: T,
    d_11: T,
    t4: T,
    t5: T,
    t20: T,
    t21: T,
    t22: T,
    t23: T,
    t24: T,
    t25: T,
    y_r_dot: Vector<T, 3>,
    k1: T,
    k1_dot: T,
    e1: Vector<T, 3>,
    s1: T,
    t26: T,
    t27: T,
    t28: T,
    E1_free: T,
    E1: T,
    cosE1: T,
    t29: T,
    sec2E1: T,
    t30: T,
    c1: Vector<T, 3>,
    t31: Vector<T, 3>,
    D_hat1: Vector<T, 3>,
    t32: T,
    t33: T,
    t34: T,
    t36: T,
    t37: Vector<T, 3>,
    t39: Matrix<T, 2, 2>,
    t40: Vector<T, 2>,
    t41: Vector<T, 3>,
    zeta1_dot: Vector<T, 3>,
    h1_dot: Vector<T, 3>,
    e2: Vector<T, 3>,
    s2: T,
    c2: Vector<T, 3>,
    P2: Vector<T, 10>,
    t42: Vector<T, 3>,
    t43: Matrix<T, 3, 10>,
    w_hat2: Vector<T, 6>,
    t46: Vector<T, 3>,
    t47: T,
    s_scale2: T,
    t49: T,
    t50: T,
    t51: T,
    Lam2: Vector<T, 3>,
    u_sat: Vector<T, 3>,
    zeta2_dot: Vector<T, 3>,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, state, params } = self;
        let real = T::from_f64;

        // -- plant model --
        let psi = x1[2];
        let m_11 = real(23.8) + params.added_scale * real(2.0);
        let m_22 = real(23.8) + params.added_scale * real(10.0);
        let m_23 = real(1.0948);
        let m_33 = real(1.76) + params.added_scale;
        let M = Matrix::rows([
            [m_11, real(0.0), real(0.0)],
            [real(0.0), m_22, m_23],
            [real(0.0), m_23, m_33],
        ]);
        let sway = x2[1];
        let r = x2[2];
        let sway_momentum = m_22 * sway + m_23 * r;
        let surge = x2[0];
        let d_11 = real(0.72253) - real(-1.32742) * surge.abs()
            - real(-5.86643) * (surge * surge);
        let t1 = sway.abs();
        let t2 = r.abs();
        let d_22 = real(0.88965) - real(-36.47287) * t1 - real(-0.805) * t2;
        let d_23 = real(7.25) - real(-0.845) * t1 - real(-3.45) * t2;
        let d_32 = real(-0.0313) - real(3.95645) * t1 - real(0.13) * t2;
        let d_33 = real(1.9) - real(0.08) * t1 - real(-0.75) * t2;
        let t3 = m_11 * surge;
        let t4 = d_22 * sway + d_23 * r;
        let t5 = d_32 * sway + d_33 * r;
        let resistance = Vector([
            params.damping_scale * d_11 * surge - sway_momentum * r,
            t3 * r + params.damping_scale * t4,
            sway_momentum * surge - t3 * sway + params.damping_scale * t5,
        ]);
        let t6 = (real(-0.1) * t).exp();
        let turn = real(0.05) * (t - real(10.0) * (real(1.0) - t6));

        // -- known dynamics of block 1 (pose) (11) --
        let t7 = psi.cos();
        let t8 = psi.sin();
        let t9 = -t8;
        // G_1(x_1 .. x_1)
        let G1 = Matrix::rows([
            [t7, t9, real(0.0)],
            [t8, t7, real(0.0)],
            [real(0.0), real(0.0), real(1.0)],
        ]);

        // -- known dynamics of block 2 (velocity) (11) --
        let t10 = real(1.0) / m_11;
        let t11 = real(1.0) / (m_22 * m_33 - real(1.19858704));
        let t12 = m_33 * t11;
        let t13 = real(-1.0948) * t11;
        let t14 = m_22 * t11;
        // G_2(x_1 .. x_2)
        let G2 = Matrix::rows([
            [t10, real(0.0), real(0.0)],
            [real(0.0), t12, t13],
            [real(0.0), t13, t14],
        ]);
        let t15 = t10 * real(0.02);
        let t16 = t12 * real(0.02);
        let t17 = t13 * real(0.005);
        let t18 = t13 * real(0.02);
        let t19 = t14 * real(0.005);
        // H_2(x_1 .. x_2)
        let H2 = Matrix::rows([
            [t15, real(0.0), real(0.0)],
            [real(0.0), t16, t17],
            [real(0.0), t18, t19],
        ]);

        // -- reference and constraints --
        // t'
        let one = real(1.0);
        let t20 = turn.sin();
        let t21 = turn.cos();
        // y_r(t)
        let y_r = Vector([real(4.0) * t20, real(4.0) * (real(1.0) - t21), turn]);
        let t22 = t6 * real(-0.1);
        let t23 = real(0.05) * (one + real(10.0) * t22);
        let t24 = t21 * t23;
        let t25 = t20 * t23;
        // y_r'
        let y_r_dot = Vector([real(4.0) * t24, real(4.0) * t25, t23]);
        // k_1(t)
        let k1 = real(0.25) * t6 + real(0.02);
        // k1'
        let k1_dot = real(0.25) * t22;

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t26 = k1 * k1;
        let t27 = real(1.0) / t26;
        let t28 = s1 * t27;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t28 * t28);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));
        // cos E_1
        let cosE1 = E1.cos();
        let t29 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t29;
        let t30 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t30;

        // -- disturbance observer of block 1 (20) --
        let t31: Vector<T, 3> = Vector::from_f64([0.5, 0.5, 1.0]);
        // D_hat_1 = th_1 + S_1 x_1
        let D_hat1 = state.th1 + t31.hadamard(x1);

        // -- norms of block 1 --
        // ||G_1||^2
        let G_norm2_1 = G1.sum_squares();

        // -- robust feedback of block 1 (31) --
        let t32 = E1.sin();
        let t33 = t32 * cosE1;
        let t34 = real(1.0) / E1_free;
        let t35 = Vector::<T, 3>::from_f64([0.55, 0.55, 0.75]).hadamard(e1)
            * T::select(E1_free.lt(real(1e-300)), real(1.0), t33 * t34);
        // Lam0 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31)
        let Lam0_1 = t35 + e1 * real(0.25);
        let t36 = real(0.5) * G_norm2_1;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = Lam0_1 + e1 * (t30 * real(0.5) + t30 * t36);
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t37: Vector<T, 3> = Vector::from_f64([2.0, 2.0, 4.0]);
        let t38 = t37.hadamard(state.zeta1);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t38 - y_r_dot + D_hat1 + Lam1;
        let t39 = Matrix::rows([[t7, t9], [t8, t7]]);
        let t40 = t39.solve(Vector([bracket1[0], bracket1[1]]));
        let t41 = Vector([t40[0], t40[1], bracket1[2]]);
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -t41;

        // -- auxiliary system of block 1 (13), erratum 1 --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = G1 * state.zeta2 - t38;

        // -- dynamic surface filter of block 1 (33) --
        // h_1' = (alpha_1 - h_1) / Fl_1
        let h1_dot = Vector::<T, 3>::from_f64([5.0, 5.0, 10.0])
            .hadamard(alpha1 - state.h1);

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
        let z2 = Vector([surge * real(5.0), sway * real(10.0), r * real(10.0)]);
        // P_2 = P_m(z_2), 10 nodes
        let P2 = polynomials::basis2(z2);
        let t42: Vector<T, 3> = Vector::from_f64([0.02, 0.02, 0.1]);
        let t43 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t42.hadamard(t43 * P2);

        // -- disturbance observer of block 2 (49) --
        let t44 = Vector([
            real(-3.0) * e2[0],
            real(22.8) * e2[0],
            real(-3.0) * e2[1],
            real(22.8) * e2[1],
            real(-3.0) * e2[2],
            real(22.8) * e2[2],
        ]);
        // w_hat_2 = th_2 + S_2 e_2
        let w_hat2 = state.th2 + t44;
        // D_hat_2 = L_2 w_hat_2
        let D_hat2 = Vector([w_hat2[1], w_hat2[3], w_hat2[5]]);

        // -- noise terms of block 2 (58) (62) --
        // ||H_2||^2
        let H_norm2_2 = H2.sum_squares();
        // ||Ybar_2||^2
        let Ybar_square2 = real(27.0);
        // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I
        // (58)
        let Ybar_norm2 = real(5.196152422706632);
        // S_2 H_2
        let SH2 = Matrix::rows([
            [real(-3.0) * t15, real(0.0), real(0.0)],
            [real(22.8) * t15, real(0.0), real(0.0)],
            [real(0.0), real(-3.0) * t16, real(-3.0) * t17],
            [real(0.0), real(22.8) * t16, real(22.8) * t17],
            [real(0.0), real(-3.0) * t18, real(-3.0) * t19],
            [real(0.0), real(22.8) * t18, real(22.8) * t19],
        ]);
        // ||S_2 H_2||^2
        let SH_norm2_2 = SH2.sum_squares();
        let t45 = H_norm2_2 * real(0.1);
        // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4
        // (62)
        let Psi2 = t45 * t45 * Ybar_square2 * real(0.5) + real(0.019200000000000002)
            + real(0.1) * (SH_norm2_2 * SH_norm2_2);

        // -- robust feedback of block 2 (63) --
        let t46 = (e2 * real(10.0)).tanh();
        // eps_hat Tanh(e / b) (64)
        let Lam2_error_bound = t46 * state.eps2;
        let t47 = s2 * s2;
        // 1 / sqrt(s_2^2 + varsigma_2^2)
        let s_scale2 = real(1.0) / (t47 + real(0.010000000000000002)).sqrt();
        let t48 = G_norm2_1 * s_c1;
        let t49 = H_norm2_2 * Ybar_norm2;
        let t50 = state.phi2 * state.phi2;
        let t51 = Psi2 / (t50 + t47);
        let t52 = real(3.5) + s2 * real(1.5) + real(0.5) + t48 * t48 * real(0.25);
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat
        // Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
        // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 +
        // e Psi cos^2 E / (phi^2 + s^2) (64)
        let Lam2 = e2 * (t52 + t49 * state.sigma2 * s_scale2 + t51) + Lam2_error_bound;

        // -- control (64) of block 2 --
        let t53 = state.zeta2 * real(10.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = A_hat2 - G2 * resistance - h1_dot + t53 + D_hat2 + Lam2;
        let t54 = M * bracket2;
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t54;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 3>::from_f64([-2.0, -2.0, -1.5]))
            .min(Vector::<T, 3>::from_f64([2.0, 2.0, 1.5]));

        // -- auxiliary system of block 2 (13), erratum 1 --
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = G2 * (u_sat + t54) - t53;
        LyapunovValues1 {
            t7,
            t8,
            t9,
            G1,
            sway,
            r,
            surge,
            d_11,
            t4,
            t5,
            t20,
            t21,
            t22,
            t23,
            t24,
            t25,
            y_r_dot,
            k1,
            k1_dot,
            e1,
            s1,
            t26,
            t27,
            t28,
            E1_free,
            E1,
            cosE1,
            t29,
            sec2E1,
            t30,
            c1,
            t31,
            D_hat1,
            t32,
            t33,
            t34,
            t36,
            t37,
            t39,
            t40,
            t41,
            zeta1_dot,
            h1_dot,
            e2,
            s2,
            c2,
            P2,
            t42,
            t43,
            w_hat2,
            t46,
            t47,
            s_scale2,
            t49,
            t50,
            t51,
            Lam2,
            u_sat,
            zeta2_dot,
        }
    }
}
