// SHA-256 of the text below: 7ba49b7739c05513d8365ef63c06178eb66bee812c0efdaa774129978d10e678
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 1005 additions, 1206 multiplications, 20 divisions, 2 square roots, 20 elementary functions, 19 comparisons and selections

//! `quadrotor`: Lyapunov function and its generator.
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
/// Operations: 1005 additions, 1206 multiplications, 20 divisions, 2 square roots, 20
/// elementary functions, 19 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    w2: Vector<T, 8>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;
    let LyapunovValues1 {
        e2,
        s2,
        t41,
        zeta2_dot,
        W2_dot,
        th2_dot,
        eps2_dot,
        sigma2_dot,
        phi2_dot,
        t70,
        t71,
        t72,
        w2_flow,
        w_error2,
        t76,
        V,
        V_T1_flow,
        V_zeta1_flow,
        V_chi1_flow,
        e2_flow,
    } = T::outlined(LyapunovPart1 {
        t,
        x1,
        x2,
        w2,
        state,
        params,
        plant,
    });

    // -- Ito generator (2) --
    let t105 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t105 + t105;
    let t106 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t106 + t106) * real(0.25);
    let t107 = W2_dot.transpose() * state.W2 + t41 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t107[(0, 0)] + t107[(1, 1)] + t107[(2, 2)]) * real(0.5);
    let t108 = Vector([
        real(14.6) * e2_flow[0],
        real(23.0) * e2_flow[0],
        real(14.0) * e2_flow[0],
        real(14.6) * e2_flow[1],
        real(23.0) * e2_flow[1],
        real(14.0) * e2_flow[1],
        real(8.0) * e2_flow[2],
        -e2_flow[2],
    ]);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + t108;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t109 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t109 + t109) * real(0.5);
    let t110 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t110 + t110) * real(0.5);
    let t111 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t111 + t111) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t76 - t76 * sigma2_dot) * real(0.5);
    let t112 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t112 + t112) * real(0.5);
    let t113 = real(0.0001) * t70;
    let t114 = t113 * e2[0];
    // D^1 s2 along noise1
    let s2_noise1_ = t114 + t114;
    let t115 = t113 * t113;
    // D^2 s2 along noise1
    let s2_noise1_2 = t115 + t115;
    let t116 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t116 + t116) * real(0.25);
    let t117 = real(14.6) * t113;
    let t118 = real(23.0) * t113;
    let t119 = real(14.0) * t113;
    let t120 = t117 * t117 + t118 * t118 + t119 * t119;
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t120 + t120) * real(0.5);
    let t121 = real(0.0001) * t71;
    let t122 = t121 * e2[1];
    // D^1 s2 along noise2
    let s2_noise2_ = t122 + t122;
    let t123 = t121 * t121;
    // D^2 s2 along noise2
    let s2_noise2_2 = t123 + t123;
    let t124 = s2_noise2_2 * s2 + s2_noise2_ * s2_noise2_;
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = (t124 + t124) * real(0.25);
    let t125 = real(14.6) * t121;
    let t126 = real(23.0) * t121;
    let t127 = real(14.0) * t121;
    let t128 = t125 * t125 + t126 * t126 + t127 * t127;
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t128 + t128) * real(0.5);
    let t129 = real(0.0001) * t72;
    let t130 = t129 * e2[2];
    // D^1 s2 along noise3
    let s2_noise3_ = t130 + t130;
    let t131 = t129 * t129;
    // D^2 s2 along noise3
    let s2_noise3_2 = t131 + t131;
    let t132 = s2_noise3_2 * s2 + s2_noise3_ * s2_noise3_;
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = (t132 + t132) * real(0.25);
    let t133 = real(8.0) * t129;
    let t134 = t133 * t133 + t131;
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t134 + t134) * real(0.5);
    let t135 = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow + V_eps2_flow + V_sigma2_flow;
    let t136 = t135 + V_phi2_flow + V_T2_noise1_2 * real(0.5) + V_D2_noise1_2 * real(0.5)
        + V_T2_noise2_2 * real(0.5);
    let t137 = t136 + V_D2_noise2_2 * real(0.5) + V_T2_noise3_2 * real(0.5)
        + V_D2_noise3_2 * real(0.5) + real(0.5) + real(2.0);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t137 + real(0.5) + real(2.0) + real(0.125);
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    w2: Vector<T, 8>,
    state: &'a State<T>,
    params: &'a Params<T>,
    plant: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    e2: Vector<T, 3>,
    s2: T,
    t41: Matrix<T, 3, 20>,
    zeta2_dot: Vector<T, 3>,
    W2_dot: Matrix<T, 20, 3>,
    th2_dot: Vector<T, 8>,
    eps2_dot: T,
    sigma2_dot: T,
    phi2_dot: T,
    t70: T,
    t71: T,
    t72: T,
    w2_flow: Vector<T, 8>,
    w_error2: Vector<T, 8>,
    t76: T,
    V: T,
    V_T1_flow: T,
    V_zeta1_flow: T,
    V_chi1_flow: T,
    e2_flow: Vector<T, 3>,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, w2, state, params, plant } = self;
        let real = T::from_f64;

        // -- plant model --
        let phi = x1[0];
        let theta = x1[1];
        let J_y = params.pitch_scale * real(0.00368);
        let J_z = params.yaw_scale * real(0.00703);
        let q = x2[1];
        let r = x2[2];
        let J_x = params.roll_scale * real(0.00365);
        let p = x2[0];

        // -- known dynamics of block 1 (attitude) (11) --
        let t1 = Vector([phi, theta]);
        let [sin_phi, sin_theta] = t1.sin().0;
        let [_, tan_theta] = t1.tan().0;
        let t2 = sin_phi * tan_theta;
        let [cos_phi, cos_theta] = t1.cos().0;
        let t3 = cos_phi * tan_theta;
        let t4 = -sin_phi;
        let t5 = real(1.0) / cos_theta;
        let t6 = sin_phi * t5;
        let t7 = cos_phi * t5;
        // G_1(x_1 .. x_1)
        let G1 = Matrix::rows([
            [real(1.0), t2, t3],
            [real(0.0), cos_phi, t4],
            [real(0.0), t6, t7],
        ]);

        // -- known dynamics of block 2 (rates) (11) --
        let t8 = real(1.0) / J_x;
        let t9 = real(1.0) / J_y;
        let t10 = real(1.0) / J_z;
        // F_2(x_1 .. x_2)
        let F2 = Vector([
            (J_y - J_z) * q * r * t8,
            (J_z - J_x) * p * r * t9,
            (J_x - J_y) * p * q * t10,
        ]);

        // -- reference and constraints --
        let t11 = real(2.0) * t;
        let t12 = real(0.5) * t;
        let t13 = real(3.0) * t;
        let t14 = Vector([t11, t13, t12]);
        let [sin_t11, sin_t13, sin_t12] = t14.sin().0;
        let t15 = real(0.6108652381980153) * sin_t11;
        let t16 = t * t;
        let t17 = (real(-0.1) * (t16 * t)).exp();
        let t18 = real(1.0) - t17;
        let t19 = real(0.4363323129985824) * sin_t13;
        let t20 = real(FRAC_PI_2) * sin_t12;
        // y_r(t)
        let y_r = Vector([t15 * t18, t19 * t18, t20 * t18]);
        let [cos_t11, cos_t13, cos_t12] = t14.cos().0;
        let t21 = real(0.6108652381980153) * (cos_t11 * real(2.0));
        let t22 = real(-0.1) * (real(3.0) * t16);
        let t23 = t17 * t22;
        let t24 = real(0.4363323129985824) * (cos_t13 * real(3.0));
        let t25 = real(FRAC_PI_2) * (cos_t12 * real(0.5));
        // y_r'
        let y_r_dot = Vector([
            t18 * t21 - t15 * t23,
            t18 * t24 - t19 * t23,
            t18 * t25 - t20 * t23,
        ]);
        let t26 = (real(-2.0) * t).exp();
        // k_1(t)
        let k1 = real(0.3) * t26 + real(0.04);
        // k1'
        let k1_dot = real(0.3) * (t26 * real(-2.0));

        // -- error variable of block 1 (14) --
        // e_1 = x_1 - y_r - zeta_1
        let e1 = x1 - y_r - state.zeta1;

        // -- barrier of block 1 (23) (26) --
        // s_1 = e_1^T e_1
        let s1 = e1.sum_squares();
        let t27 = k1 * k1;
        let t28 = real(1.0) / t27;
        let t29 = s1 * t28;
        // pi s_1^2 / (2 k_1^4), before the clamp
        let E1_free = real(FRAC_PI_2) * (t29 * t29);
        // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
        let E1 = E1_free.min(real(1.5697963267948967));
        // cos E_1
        let cosE1 = E1.cos();
        let t30 = cosE1 * cosE1;
        // 1 / cos^2 E_1
        let sec2E1 = real(1.0) / t30;
        let t31 = s1 * sec2E1;
        // c_1 = s_1 e_1^T / cos^2 E_1
        let c1 = e1 * t31;

        // -- norms of block 1 --
        // ||G_1||^2
        let G_norm2_1 = G1.sum_squares();

        // -- robust feedback of block 1 (31) --
        let t32 = E1.sin();
        let t33 = t32 * cosE1;
        let t34 = real(1.0) / E1_free;
        let t35 = real(0.5) * G_norm2_1;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1
            * (real(3.5) * T::select(E1_free.lt(real(1e-300)), real(1.0), t33 * t34)
                + real(2.0) + t31 * t35);
        // ||c_1||^2
        let s_c1 = c1.sum_squares();

        // -- virtual control (31) of block 1 --
        let t36 = state.zeta1 * real(20.0);
        // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
        let bracket1 = t36 - y_r_dot + Lam1;
        let t37 = Matrix::rows([[cos_phi, t4], [t6, t7]]);
        let t38 = t37.solve(Vector([bracket1[1], bracket1[2]]));
        let t39 = bracket1[0] - t2 * t38[0] - t3 * t38[1];
        let t40 = Vector([t39, t38[0], t38[1]]);
        // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
        let alpha1 = -t40;

        // -- auxiliary system of block 1 (13), erratum 1 --
        // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
        let zeta1_dot = G1 * state.zeta2 - t36;

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
        // P_2 = P_m(z_2), 20 nodes
        let P2 = polynomials::basis2(x2);
        let t41 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t41 * P2;

        // -- disturbance observer of block 2 (49) --
        let t42 = Vector([
            real(14.6) * e2[0],
            real(23.0) * e2[0],
            real(14.0) * e2[0],
            real(14.6) * e2[1],
            real(23.0) * e2[1],
            real(14.0) * e2[1],
            real(8.0) * e2[2],
            -e2[2],
        ]);
        // w_hat_2 = th_2 + S_2 e_2
        let w_hat2 = state.th2 + t42;
        // D_hat_2 = L_2 w_hat_2
        let D_hat2 = Vector([
            w_hat2[0] + w_hat2[2],
            w_hat2[3] + w_hat2[5],
            w_hat2[6] + w_hat2[7],
        ]);

        // -- noise terms of block 2 (58) (62) --
        let t43 = real(0.0001) * t8;
        let t44 = real(0.0001) * t9;
        let t45 = real(0.0001) * t10;
        let t46 = t45 * t45;
        // ||H_2||^2
        let H_norm2_2 = t43 * t43 + t44 * t44 + t46;
        // ||Ybar_2||^2
        let Ybar_square2 = real(27.0);
        // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I
        // (58)
        let Ybar_norm2 = real(5.196152422706632);
        let t47 = real(14.6) * t43;
        let t48 = real(23.0) * t43;
        let t49 = real(14.0) * t43;
        let t50 = real(14.6) * t44;
        let t51 = real(23.0) * t44;
        let t52 = real(14.0) * t44;
        let t53 = real(8.0) * t45;
        let t54 = t47 * t47 + t48 * t48 + t49 * t49 + t50 * t50;
        // ||S_2 H_2||^2
        let SH_norm2_2 = t54 + t51 * t51 + t52 * t52 + t53 * t53 + t46;
        // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4
        // (62)
        let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(20.5)
            + real(0.01) * (SH_norm2_2 * SH_norm2_2);

        // -- robust feedback of block 2 (63) --
        let t55 = e2.tanh();
        // eps_hat Tanh(e / b) (64)
        let Lam2_error_bound = t55 * state.eps2;
        let t56 = s2 * s2;
        // 1 / sqrt(s_2^2 + varsigma_2^2)
        let s_scale2 = real(1.0) / (t56 + real(1.0)).sqrt();
        let t57 = G_norm2_1 * s_c1;
        let t58 = H_norm2_2 * Ybar_norm2;
        let t59 = state.phi2 * state.phi2;
        let t60 = Psi2 / (t59 + t56);
        let t61 = real(25.0) + s2 * real(3.0) + real(0.5) + t57 * t57 * real(0.25);
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat
        // Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
        // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 +
        // e Psi cos^2 E / (phi^2 + s^2) (64)
        let Lam2 = e2 * (t61 + t58 * state.sigma2 * s_scale2 + t60) + Lam2_error_bound;

        // -- control (64) of block 2 --
        let t62 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = F2 + A_hat2 - h1_dot + t62 + D_hat2 + Lam2;
        let t63 = bracket2
            .hadamard(Vector::splat(real(1.0)).quotient(Vector([t8, t9, t10])));
        // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let u = -t63;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u
            .max(Vector::<T, 3>::from_f64([-0.2, -0.2, -0.05]))
            .min(Vector::<T, 3>::from_f64([0.2, 0.2, 0.05]));

        // -- auxiliary system of block 2 (13), erratum 1 --
        let t64 = u_sat + t63;
        // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
        let zeta2_dot = Vector([t8 * t64[0], t9 * t64[1], t10 * t64[2]]) - t62;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

        // -- observer dynamics of block 2 (50) --
        let t65 = Vector([
            real(-0.2) * w_hat2[0] + real(12.0) * w_hat2[1],
            real(-12.0) * w_hat2[0] + real(-0.2) * w_hat2[1],
            -w_hat2[2],
            real(-0.2) * w_hat2[3] + real(12.0) * w_hat2[4],
            real(-12.0) * w_hat2[3] + real(-0.2) * w_hat2[4],
            -w_hat2[5],
            real(0.0),
            real(-3.0) * w_hat2[7],
        ]);
        let t66 = Vector([
            real(14.6) * Lam2[0],
            real(23.0) * Lam2[0],
            real(14.0) * Lam2[0],
            real(14.6) * Lam2[1],
            real(23.0) * Lam2[1],
            real(14.0) * Lam2[1],
            real(8.0) * Lam2[2],
            -Lam2[2],
        ]);
        // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
        // M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
        let th2_dot = t65 + t66;

        // -- network error bound of block 2 (66) --
        // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
        let eps2_dot = real(0.1) * (s2 * e2.dot(t55) - state.eps2);

        // -- noise bound of block 2 (67) --
        // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
        // varsigma_2^2)) - lambda_sigma sigma_hat_2)
        let sigma2_dot = t58 * t56 * s_scale2 - real(0.1) * state.sigma2;

        // -- compensation of block 2 (68) --
        // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
        let phi2_decay = t60 + real(0.5);
        // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
        let phi2_dot = T::select(
            s2.sqrt().ge(real(0.2)),
            -state.phi2 * phi2_decay,
            real(0.0),
        );

        // -- true dynamics of block 1 (attitude) (11) --
        // F_1 + G_1 x_2 + d_1
        let x1_flow = G1 * x2;

        // -- true dynamics of block 2 (rates) (11) --
        let t67 = plant.pitch_scale * real(0.00368);
        let t68 = plant.yaw_scale * real(0.00703);
        let t69 = plant.roll_scale * real(0.00365);
        let t70 = real(1.0) / t69;
        let t71 = real(1.0) / t67;
        let t72 = real(1.0) / t68;
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            (t67 - t68) * q * r * t70,
            (t68 - t69) * p * r * t71,
            (t69 - t67) * p * q * t72,
        ]);
        // d_2 = L_2 w_2 (12)
        let d2 = Vector([w2[0] + w2[2], w2[3] + w2[5], w2[6] + w2[7]]);
        // w_2' = M_2 w_2 (12)
        let w2_flow = Vector([
            real(-0.2) * w2[0] + real(12.0) * w2[1],
            real(-12.0) * w2[0] + real(-0.2) * w2[1],
            -w2[2],
            real(-0.2) * w2[3] + real(12.0) * w2[4],
            real(-12.0) * w2[3] + real(-0.2) * w2[4],
            -w2[5],
            real(0.0),
            real(-3.0) * w2[7],
        ]);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = F2_plant + Vector([t70 * u_sat[0], t71 * u_sat[1], t72 * u_sat[2]])
            + d2;

        // -- Lyapunov function of block 1 (23) (52) --
        let t73 = t27 * t27 * real(0.15915494309189535);
        let t74 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t73 * t74;
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + t40;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = t56 * real(0.25);
        let t75 = t41 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = (t75[(0, 0)] + t75[(1, 1)] + t75[(2, 2)]) * real(0.5);
        // w_2 - w_hat_2
        let w_error2 = w2 - w_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = w_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // eps_hat_2^2/(2 iota_20)
        let V_eps2 = state.eps2 * state.eps2 * real(5.0);
        let t76 = real(3.0) - state.sigma2;
        // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
        let V_sigma2 = t76 * t76 * real(0.5);
        // phi_2^2/2
        let V_phi2 = t59 * real(0.5);

        // -- Lyapunov function (52) --
        let t77 = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_eps2
            + V_sigma2;
        // V, sum of the parts above
        let V = t77 + V_phi2;

        // -- Ito generator (2) --
        // e1' along the flow
        let e1_flow = x1_flow - y_r_dot - zeta1_dot;
        let t78 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t78 + t78;
        let t79 = (t29 + t29) * (s1_flow * t28 - t29 * t28 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t79;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t74
            * (real(4.0) * (t27 * k1) * k1_dot * real(0.15915494309189535))
            + t73 * (E1_flow / t30);
        let t80 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t80 + t80) * real(0.5);
        let t81 = cos_phi * x1_flow[0];
        let t82 = x1_flow[1] / (cos_theta * cos_theta);
        let t83 = tan_theta * t81 + sin_phi * t82;
        let t84 = sin_phi * x1_flow[0];
        let t85 = cos_phi * t82 - tan_theta * t84;
        let t86 = sin_theta * x1_flow[1];
        let t87 = t81 * t5 + t6 * t5 * t86;
        let t88 = t7 * t5 * t86 - t84 * t5;
        // G1' along the flow
        let G1_flow = Matrix::rows([
            [real(0.0), t83, t85],
            [real(0.0), -t84, -t81],
            [real(0.0), t87, t88],
        ]);
        let t89 = t21 * t23;
        let t90 = t22 * t23 + t17 * (real(-0.1) * (real(3.0) * (t + t)));
        let t91 = t24 * t23;
        let t92 = t25 * t23;
        // y_r''
        let y_r_dot2 = Vector([
            t18 * (real(0.6108652381980153) * -(real(2.0) * (sin_t11 * real(2.0)))) - t89
                - (t89 + t15 * t90),
            t18 * (real(0.4363323129985824) * -(real(3.0) * (sin_t13 * real(3.0)))) - t91
                - (t91 + t19 * t90),
            t18 * (real(FRAC_PI_2) * -(real(0.5) * (sin_t12 * real(0.5)))) - t92
                - (t92 + t20 * t90),
        ]);
        let t93 = real(1.5697963267948967) * t34;
        let t94 = real(1.0).lt(t93);
        let t95 = T::select(t94, real(1.0), t93);
        let t96 = T::select(E1.eq(real(0.0)), real(1.0), t33 / E1);
        let t97 = t95 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t94, real(0.0), -(t96 * (t93 * t34 * E1_free_flow)));
        let t98 = t96 * t95;
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            real(3.5) * e1[0] * t97 + t98 * (real(3.5) * e1_flow[0])
                + real(2.0) * e1_flow[0],
            real(3.5) * e1[1] * t97 + t98 * (real(3.5) * e1_flow[1])
                + real(2.0) * e1_flow[1],
            real(3.5) * e1[2] * t97 + t98 * (real(3.5) * e1_flow[2])
                + real(2.0) * e1_flow[2],
        ]);
        let t99 = (t2 + t2) * t83 + (t3 + t3) * t85 - (cos_phi + cos_phi) * t84;
        let t100 = t99 - (t4 - sin_phi) * t81 + (t6 + t6) * t87;
        // G_norm2_1' along the flow
        let G_norm2_1_flow = t100 + (t7 + t7) * t88;
        // cosE1' along the flow
        let cosE1_flow = -(t32 * E1_flow);
        let t101 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t101 + e1_flow * t31;
        // Lam1_filter' along the flow
        let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t35;
        // Lam1' along the flow
        let Lam1_flow = Lam0_1_flow + Lam1_filter_flow;
        // bracket1' along the flow
        let bracket1_flow = zeta1_dot * real(20.0) - y_r_dot2 + Lam1_flow;
        let t102 = bracket1_flow - G1_flow * t40;
        let t103 = t37.solve(Vector([t102[1], t102[2]]));
        // chi1' along the flow
        let chi1_flow = h1_dot
            + Vector([t102[0] - t2 * t103[0] - t3 * t103[1], t103[0], t103[1]]);
        let t104 = chi1_flow.dot(chi1);
        // V_chi1' along the flow
        let V_chi1_flow = (t104 + t104) * real(0.5);
        // e2' along the flow
        let e2_flow = x2_flow - h1_dot - zeta2_dot;
        LyapunovValues1 {
            e2,
            s2,
            t41,
            zeta2_dot,
            W2_dot,
            th2_dot,
            eps2_dot,
            sigma2_dot,
            phi2_dot,
            t70,
            t71,
            t72,
            w2_flow,
            w_error2,
            t76,
            V,
            V_T1_flow,
            V_zeta1_flow,
            V_chi1_flow,
            e2_flow,
        }
    }
}
