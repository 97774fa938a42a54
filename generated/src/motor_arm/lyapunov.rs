// SHA-256 of the text below: 84ef46c8a3e167fa89fc89ce8a882a3f2f591767495a0b6e93581f52f16b7706
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 282 additions, 424 multiplications, 15 divisions, 2 square roots, 13 elementary functions, 15 comparisons and selections

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
/// Operations: 282 additions, 424 multiplications, 15 divisions, 2 square roots, 13 elementary
/// functions, 15 comparisons and selections.
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
    let LyapunovValues1 {
        inertia,
        F3,
        cos_t5,
        c1,
        s_c1,
        e2,
        s2,
        z2,
        t24,
        Psi2,
        t28,
        t29,
        t27,
        s_scale2,
        t30,
        t31,
        t32,
        t34,
        t39,
        zeta2_dot,
        eps2_dot,
        sigma2_dot,
        phi2_dot,
        h2_dot,
        e3,
        s3,
        D_hat3,
        zeta3_dot,
        t45,
        t51,
        x3_flow,
        chi2,
        t49,
        D_error3,
        V,
        HSigma2_1,
        V_T1_flow,
        V_zeta1_flow,
        c1_flow,
        V_chi1_flow,
        e2_flow,
        s2_flow,
        V_T2_flow,
        V_W2_flow,
        w_hat2_flow,
        V_D2_flow,
        V_zeta2_flow,
        F2_flow,
        A_hat2_flow,
        h1_dot_flow,
    } = T::outlined(LyapunovPart1 {
        t,
        x1,
        x2,
        x3,
        w2,
        state,
        params,
        plant,
    });

    // -- Ito generator (2) --
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    let t71 = e2[0].tanh();
    let t72 = real(1.0) - t71 * t71;
    // Lam2_error_bound' along the flow
    let Lam2_error_bound_flow = Vector([
        t71 * eps2_dot + state.eps2 * (t72 * e2_flow[0]),
    ]);
    let t73 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t73 + t73;
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * ((s_c1 + s_c1) * s_c1_flow) + t29 * e2_flow[0]) * real(0.25),
    ]);
    let t74 = s_scale2 * s_scale2;
    let t75 = s2 + s2;
    let t76 = t75 * s2_flow;
    let t77 = t27 + t27;
    let t78 = e2 * (t30 * sigma2_dot * s_scale2 - t31 * (t74 * (t76 / t77)));
    // Lam2_noise' along the flow
    let Lam2_noise_flow = t78 + e2_flow * t32;
    let t79 = real(1.0) / t34;
    let t80 = Psi2 * t79;
    let t81 = t80 * t79;
    // Lam2_diffusion' along the flow
    let Lam2_diffusion_flow = Vector([
        t80 * e2_flow[0] - e2[0] * (t81 * ((state.phi2 + state.phi2) * phi2_dot + t76)),
    ]);
    let t82 = real(0.5) + t28;
    // Lam2' along the flow
    let Lam2_flow = e2_flow * real(45.5) + c2_flow * t82 + Lam2_error_bound_flow
        + Lam2_coupling_flow + Lam2_noise_flow + Lam2_diffusion_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow + A_hat2_flow - h1_dot_flow + zeta2_dot * real(50.0)
        + w_hat2_flow + Lam2_flow;
    // chi2' along the flow
    let chi2_flow = h2_dot + bracket2_flow * t39;
    let t83 = chi2_flow.dot(chi2);
    // V_chi2' along the flow
    let V_chi2_flow = (t83 + t83) * real(0.5);
    let t84 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t84 + t84) * real(5.0);
    // V_sigma2' along the flow
    let V_sigma2_flow = (-sigma2_dot * t49 - t49 * sigma2_dot) * real(0.5);
    let t85 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t85 + t85) * real(0.5);
    // e3' along the flow
    let e3_flow = x3_flow - h2_dot - zeta3_dot;
    let t86 = e3_flow.dot(e3);
    // s3' along the flow
    let s3_flow = t86 + t86;
    let t87 = s3_flow * s3;
    // V_T3' along the flow
    let V_T3_flow = (t87 + t87) * real(0.25);
    // d3'
    let d3_dot = Vector([real(0.5) * (cos_t5 * real(20.0)) * real(40.0)]);
    // D_hat3' along the flow
    let D_hat3_flow = x3_flow * real(50.0) - (D_hat3 + F3 + t45) * real(50.0);
    // D_error3' along the flow
    let D_error3_flow = d3_dot - D_hat3_flow;
    let t88 = D_error3_flow.dot(D_error3);
    // V_D3' along the flow
    let V_D3_flow = (t88 + t88) * real(0.5);
    let t89 = zeta3_dot.dot(state.zeta3);
    // V_zeta3' along the flow
    let V_zeta3_flow = (t89 + t89) * real(0.5);
    let t90 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t90 + t90;
    let t91 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t91 + t91;
    let t92 = s2_noise1_2 * s2 + s2_noise1_ * s2_noise1_;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = (t92 + t92) * real(0.25);
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = HSigma2_1 * real(10.0);
    let t93 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t93 + t93) * real(0.5);
    // D^1 F2 along noise1
    let F2_noise1_ = Vector([-(real(0.01625) * t51 / inertia)]);
    // D^1 z2 along noise1
    let z2_noise1_ = Vector([real(0.0), t51]);
    // D^1 P2 along noise1
    let P2_noise1_ = polynomials::basis2_rate(z2, z2_noise1_);
    // D^1 A_hat2 along noise1
    let A_hat2_noise1_ = t24 * P2_noise1_;
    // D^1 c2 along noise1
    let c2_noise1_ = e2 * s2_noise1_ + HSigma2_1 * s2;
    let t94 = t72 * t51;
    // D^1 Lam2_error_bound along noise1
    let Lam2_error_bound_noise1_ = Vector([state.eps2 * t94]);
    // D^1 Lam2_coupling along noise1
    let Lam2_coupling_noise1_ = Vector([t29 * t51 * real(0.25)]);
    let t95 = t75 * s2_noise1_;
    let t96 = t74 * (t95 / t77);
    // D^1 s_scale2 along noise1
    let s_scale2_noise1_ = -t96;
    let t97 = t31 * s_scale2_noise1_;
    // D^1 Lam2_noise along noise1
    let Lam2_noise_noise1_ = e2 * t97 + HSigma2_1 * t32;
    let t98 = t81 * t95;
    // D^1 Lam2_diffusion along noise1
    let Lam2_diffusion_noise1_ = Vector([t80 * t51 - e2[0] * t98]);
    // D^1 Lam2 along noise1
    let Lam2_noise1_ = HSigma2_1 * real(45.5) + c2_noise1_ * t82
        + Lam2_error_bound_noise1_ + Lam2_coupling_noise1_ + Lam2_noise_noise1_
        + Lam2_diffusion_noise1_;
    // D^1 bracket2 along noise1
    let bracket2_noise1_ = F2_noise1_ + A_hat2_noise1_ + w_hat2_noise1_ + Lam2_noise1_;
    // D^1 chi2 along noise1
    let chi2_noise1_ = bracket2_noise1_ * t39;
    // D^2 z2 along noise1
    let z2_noise1_2: Vector<T, 2> = Vector::zero();
    // D^2 P2 along noise1
    let P2_noise1_2 = polynomials::basis2_rate2(z2, z2_noise1_, z2_noise1_2);
    // D^2 A_hat2 along noise1
    let A_hat2_noise1_2 = t24 * P2_noise1_2;
    let t99 = s2_noise1_ + s2_noise1_;
    // D^2 c2 along noise1
    let c2_noise1_2 = e2 * s2_noise1_2 + HSigma2_1 * t99;
    // D^2 Lam2_error_bound along noise1
    let Lam2_error_bound_noise1_2 = Vector([state.eps2 * -(t51 * ((t71 + t71) * t94))]);
    let t100 = real(1.0) / t77;
    let t101 = t95 * t100;
    let t102 = s2_noise1_ * t99 + t75 * s2_noise1_2;
    let t103 = t101 * (t74 * t101 * s_scale2 + t74 * s_scale2 * t101);
    // D^2 s_scale2 along noise1
    let s_scale2_noise1_2 = -(t74 * (t102 * t100 - t101 * t100 * (t101 + t101)) - t103);
    // D^2 Lam2_noise along noise1
    let Lam2_noise_noise1_2 = e2 * (t31 * s_scale2_noise1_2)
        + HSigma2_1 * (t97 - t31 * t96);
    let t104 = t51 * t98;
    let t105 = e2[0] * (t81 * t102 - t95 * (t98 * t79 + t81 * t79 * t95));
    // D^2 Lam2_diffusion along noise1
    let Lam2_diffusion_noise1_2 = Vector([-t104 - (t104 + t105)]);
    // D^2 Lam2 along noise1
    let Lam2_noise1_2 = c2_noise1_2 * t82 + Lam2_error_bound_noise1_2
        + Lam2_noise_noise1_2 + Lam2_diffusion_noise1_2;
    // D^2 bracket2 along noise1
    let bracket2_noise1_2 = A_hat2_noise1_2 + Lam2_noise1_2;
    // D^2 chi2 along noise1
    let chi2_noise1_2 = bracket2_noise1_2 * t39;
    let t106 = chi2_noise1_2.dot(chi2) + chi2_noise1_.sum_squares();
    // D^2 V_chi2 along noise1
    let V_chi2_noise1_2 = (t106 + t106) * real(0.5);
    let t107 = V_T1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow + V_D2_flow
        + V_zeta2_flow + V_chi2_flow + V_eps2_flow;
    let t108 = t107 + V_sigma2_flow + V_phi2_flow + V_T3_flow + V_D3_flow + V_zeta3_flow
        + V_T2_noise1_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t108 + V_D2_noise1_2 * real(0.5) + V_chi2_noise1_2 * real(0.5)
        + real(0.125);
    LyapunovOutputs { V, LV }
}

/// Part 1 of [`lyapunov`]: short functions compile faster than one long one.
struct LyapunovPart1<'a, T: Real> {
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    w2: Vector<T, 1>,
    state: &'a State<T>,
    params: &'a Params<T>,
    plant: &'a Params<T>,
}

/// What is used of the values of [`LyapunovPart1`].
struct LyapunovValues1<T: Real> {
    inertia: T,
    F3: Vector<T, 1>,
    cos_t5: T,
    c1: Vector<T, 1>,
    s_c1: T,
    e2: Vector<T, 1>,
    s2: T,
    z2: Vector<T, 2>,
    t24: Matrix<T, 1, 6>,
    Psi2: T,
    t28: T,
    t29: T,
    t27: T,
    s_scale2: T,
    t30: T,
    t31: T,
    t32: T,
    t34: T,
    t39: T,
    zeta2_dot: Vector<T, 1>,
    eps2_dot: T,
    sigma2_dot: T,
    phi2_dot: T,
    h2_dot: Vector<T, 1>,
    e3: Vector<T, 1>,
    s3: T,
    D_hat3: Vector<T, 1>,
    zeta3_dot: Vector<T, 1>,
    t45: Vector<T, 1>,
    t51: T,
    x3_flow: Vector<T, 1>,
    chi2: Vector<T, 1>,
    t49: T,
    D_error3: Vector<T, 1>,
    V: T,
    HSigma2_1: Vector<T, 1>,
    V_T1_flow: T,
    V_zeta1_flow: T,
    c1_flow: Vector<T, 1>,
    V_chi1_flow: T,
    e2_flow: Vector<T, 1>,
    s2_flow: T,
    V_T2_flow: T,
    V_W2_flow: T,
    w_hat2_flow: Vector<T, 1>,
    V_D2_flow: T,
    V_zeta2_flow: T,
    F2_flow: Vector<T, 1>,
    A_hat2_flow: Vector<T, 1>,
    h1_dot_flow: Vector<T, 1>,
}

impl<T: Real> Part for LyapunovPart1<'_, T> {
    type Output = LyapunovValues1<T>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { t, x1, x2, x3, w2, state, params, plant } = self;
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

        // -- robust feedback of block 1 (31) --
        let t20 = E1.sin();
        let t21 = t20 * cosE1;
        let t22 = real(1.0) / E1_free;
        // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
        let Lam1 = e1
            * (real(3.2199999999999998)
                * T::select(E1_free.lt(real(1e-300)), real(1.0), t21 * t22) + real(1.72)
                + t19 * real(0.5));
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
        let t24 = state.W2.transpose();
        // A_hat_2 = iota_2 W_2^T P_2
        let A_hat2 = t24 * P2;

        // -- disturbance observer of block 2 (49) --
        // w_hat_2 = th_2 + S_2 e_2
        let w_hat2 = state.th2 + e2 * real(10.0);

        // -- norms of block 2 --
        // ||G_2||^2
        let G_norm2_2 = G2.sum_squares();

        // -- noise terms of block 2 (58) (62) --
        // ||H_2||^2
        let H_norm2_2 = H2.sum_squares();
        // ||Ybar_2||^2
        let Ybar_square2 = real(9.0);
        // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I
        // (58)
        let Ybar_norm2 = real(3.0);
        // S_2
        let S2: Matrix<T, 1, 1> = Matrix::from_f64([[10.0]]);
        // S_2 H_2
        let SH2 = S2 * H2;
        // ||S_2 H_2||^2
        let SH_norm2_2 = SH2.sum_squares();
        // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4
        // (62)
        let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(0.5)
            + real(0.1) * (SH_norm2_2 * SH_norm2_2);

        // -- robust feedback of block 2 (31) --
        let t25 = e2.tanh();
        // eps_hat Tanh(e / b) (64)
        let Lam2_error_bound = t25 * state.eps2;
        let t26 = s2 * s2;
        let t27 = (t26 + real(1.0)).sqrt();
        // 1 / sqrt(s_2^2 + varsigma_2^2)
        let s_scale2 = real(1.0) / t27;
        let t28 = real(0.05) * G_norm2_2;
        let t29 = s_c1 * s_c1;
        let t30 = H_norm2_2 * Ybar_norm2;
        let t31 = t30 * state.sigma2;
        let t32 = t31 * s_scale2;
        let t33 = state.phi2 * state.phi2;
        let t34 = t33 + t26;
        let t35 = Psi2 / t34;
        let t36 = real(45.0) + s2 * real(0.5) + s2 * t28 + real(0.5) + t29 * real(0.25)
            + t32;
        // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + eta_2/2 ||G||^2 c^T (37) + e /
        // (2 cos^2 E) (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4),
        // G, c, eta_3 of the outer block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 +
        // varsigma^2) (64), errata 4 and 7 + e Psi cos^2 E / (phi^2 ...
        let Lam2 = e2 * (t36 + t35) + Lam2_error_bound;
        // ||c_2||^2
        let s_c2 = c2.sum_squares();

        // -- virtual control (31) of block 2 --
        let t37 = F2 + A_hat2;
        let t38 = state.zeta2 * real(50.0);
        // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
        let bracket2 = t37 - h1_dot + t38 + w_hat2 + Lam2;
        let t39 = real(1.0) / t4;
        let t40 = bracket2 * t39;
        // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
        let alpha2 = -t40;

        // -- auxiliary system of block 2 (13), erratum 1 --
        // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
        let zeta2_dot = G2 * state.zeta3 - t38;

        // -- weight law of block 2 (32) (65) --
        // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
        let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

        // -- observer dynamics of block 2 (50) --
        // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2) (50)
        let th2_dot = w_hat2 * real(-12.0)
            - (t37 + G2 * (x3 - state.zeta3) - h1_dot + t38) * real(10.0);

        // -- network error bound of block 2 (66) --
        // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
        let eps2_dot = real(0.1) * (s2 * e2.dot(t25) - state.eps2);

        // -- noise bound of block 2 (67) --
        // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
        // varsigma_2^2)) - lambda_sigma sigma_hat_2)
        let sigma2_dot = t30 * t26 * s_scale2 - real(0.1) * state.sigma2;

        // -- compensation of block 2 (68) --
        // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
        let phi2_decay = t35 + real(0.5);
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

        // -- disturbance observer of block 3 (20) --
        // D_hat_3 = th_3 + S_3 x_3
        let D_hat3 = state.th3 + x3 * real(50.0);

        // -- robust feedback of block 3 (63) --
        let t41 = G_norm2_2 * s_c2;
        // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E)
        // before the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4),
        // G, c, eta_3 of the outer block (38)
        let Lam3 = e3 * (real(225.0) + s3 * real(0.5) + t41 * t41 * real(0.015625));

        // -- control (64) of block 3 --
        let t42 = state.zeta3 * real(100.0);
        // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
        let bracket3 = F3 - h2_dot + t42 + D_hat3 + Lam3;
        let t43 = bracket3 * real(0.025);
        // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
        let u = -t43;
        // sat(u), each component limited to +-u_max (8)
        let u_sat = u.max(Vector::splat(real(-40.0))).min(Vector::splat(real(40.0)));

        // -- auxiliary system of block 3 (13), erratum 1 --
        // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
        let zeta3_dot = (u_sat + t43) * real(40.0) - t42;

        // -- true dynamics of block 2 (speed) (11) --
        let t44 = real(1.0)
            / (real(0.017315216666666668) + plant.load_mass * real(0.093025)
                + real(2.0) * plant.load_mass * real(0.000529) * real(0.2));
        // F_2 with the plant's parameters
        let F2_plant = Vector([
            -(t1 + (real(0.253) + plant.load_mass) * real(0.305) * real(9.81) * t2) * t44,
        ]);
        // G_2 with the plant's parameters
        let G2_plant = Matrix::rows([[real(0.9) * t44]]);
        // w_2' = M_2 w_2 (12)
        let w2_flow = w2 * real(-2.0);
        // F_2 + G_2 x_3 + d_2
        let x2_flow = F2_plant + G2_plant * x3 + w2;

        // -- true dynamics of block 3 (current) (11) --
        // d_3(t)
        let d3 = Vector([real(0.5) * sin_t5 * real(40.0)]);
        let t45 = u_sat * real(40.0);
        // F_3 + G_3 x_4 + d_3
        let x3_flow = F3 + t45 + d3;

        // -- Lyapunov function of block 1 (23) (52) --
        let t46 = t15 * t15 * real(0.15915494309189535);
        let t47 = E1.tan();
        // k_1^4/(2 pi) tan E_1
        let V_T1 = t46 * t47;
        // 1/2 ||zeta_1||^2
        let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
        // chi_1 = h_1 - alpha_1 (34)
        let chi1 = state.h1 + bracket1;
        // 1/2 ||chi_1||^2
        let V_chi1 = chi1.sum_squares() * real(0.5);

        // -- Lyapunov function of block 2 (23) (52) --
        // k_2^4/(2 pi) tan E_2
        let V_T2 = t26 * real(0.25);
        let t48 = t24 * state.W2;
        // tr(W_2^T W_2)/(2 Gamma_2)
        let V_W2 = t48[(0, 0)] * real(0.5);
        // w_2 - w_hat_2
        let w_error2 = w2 - w_hat2;
        // 1/2 ||theta_2 - th_2||^2
        let V_D2 = w_error2.sum_squares() * real(0.5);
        // 1/2 ||zeta_2||^2
        let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
        // chi_2 = h_2 - alpha_2 (34)
        let chi2 = state.h2 + t40;
        // 1/2 ||chi_2||^2
        let V_chi2 = chi2.sum_squares() * real(0.5);
        // eps_hat_2^2/(2 iota_20)
        let V_eps2 = state.eps2 * state.eps2 * real(5.0);
        let t49 = real(1.0) - state.sigma2;
        // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
        let V_sigma2 = t49 * t49 * real(0.5);
        // phi_2^2/2
        let V_phi2 = t33 * real(0.5);

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
        let t50 = V_T1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2 + V_chi2
            + V_eps2;
        // V, sum of the parts above
        let V = t50 + V_sigma2 + V_phi2 + V_T3 + V_D3 + V_zeta3;

        // -- Ito generator (2) --
        let t51 = real(0.01) * t44;
        // column 1 of HSigma2
        let HSigma2_1 = Vector([t51]);
        // e1' along the flow
        let e1_flow = x2 - y_r_dot - zeta1_dot;
        let t52 = e1_flow.dot(e1);
        // s1' along the flow
        let s1_flow = t52 + t52;
        let t53 = (t17 + t17) * (s1_flow * t16 - t17 * t16 * ((k1 + k1) * k1_dot));
        // E1_free' along the flow
        let E1_free_flow = real(FRAC_PI_2) * t53;
        // E1' along the flow
        let E1_flow = T::select(
            E1_free.lt(real(1.5697963267948967)),
            E1_free_flow,
            real(0.0),
        );
        // V_T1' along the flow
        let V_T1_flow = t47
            * (real(4.0) * (t15 * k1) * k1_dot * real(0.15915494309189535))
            + t46 * (E1_flow / t18);
        let t54 = zeta1_dot.dot(state.zeta1);
        // V_zeta1' along the flow
        let V_zeta1_flow = (t54 + t54) * real(0.5);
        let t55 = t11 * t13;
        let t56 = t55 + t7 * (t12 * t13 + t9 * (real(-0.1) * (real(3.0) * (t + t))));
        // y_r''
        let y_r_dot2 = Vector([t10 * (real(FRAC_PI_2) * -sin_t) - t55 - t56]);
        let t57 = real(1.5697963267948967) * t22;
        let t58 = real(1.0).lt(t57);
        let t59 = T::select(t58, real(1.0), t57);
        let t60 = T::select(E1.eq(real(0.0)), real(1.0), t21 / E1);
        let t61 = t59 * (kernel::sin_cos_over_d1(E1) * E1_flow)
            + T::select(t58, real(0.0), -(t60 * (t57 * t22 * E1_free_flow)));
        // Lam0_1' along the flow
        let Lam0_1_flow = Vector([
            real(3.2199999999999998) * e1[0] * t61
                + t60 * t59 * (real(3.2199999999999998) * e1_flow[0])
                + real(1.72) * e1_flow[0],
        ]);
        // cosE1' along the flow
        let cosE1_flow = -(t20 * E1_flow);
        let t62 = e1
            * (s1_flow * sec2E1
                - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
        // c1' along the flow
        let c1_flow = t62 + e1_flow * t19;
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
        let t63 = chi1_flow.dot(chi1);
        // V_chi1' along the flow
        let V_chi1_flow = (t63 + t63) * real(0.5);
        // e2' along the flow
        let e2_flow = x2_flow - h1_dot - zeta2_dot;
        let t64 = e2_flow.dot(e2);
        // s2' along the flow
        let s2_flow = t64 + t64;
        let t65 = s2_flow * s2;
        // V_T2' along the flow
        let V_T2_flow = (t65 + t65) * real(0.25);
        let t66 = W2_dot.transpose();
        let t67 = t66 * state.W2 + t24 * W2_dot;
        // V_W2' along the flow
        let V_W2_flow = t67[(0, 0)] * real(0.5);
        // w_hat2' along the flow
        let w_hat2_flow = th2_dot + e2_flow * real(10.0);
        // w_error2' along the flow
        let w_error2_flow = w2_flow - w_hat2_flow;
        let t68 = w_error2_flow.dot(w_error2);
        // V_D2' along the flow
        let V_D2_flow = (t68 + t68) * real(0.5);
        let t69 = zeta2_dot.dot(state.zeta2);
        // V_zeta2' along the flow
        let V_zeta2_flow = (t69 + t69) * real(0.5);
        let t70 = angle.cos() * x2[0];
        // F2' along the flow
        let F2_flow = Vector([-((real(0.01625) * x2_flow[0] + weight * t70) * t3)]);
        // z2' along the flow
        let z2_flow = Vector([t70, x2_flow[0]]);
        // P2' along the flow
        let P2_flow = polynomials::basis2_rate(z2, z2_flow);
        // A_hat2' along the flow
        let A_hat2_flow = t66 * P2 + t24 * P2_flow;
        // h1_dot' along the flow
        let h1_dot_flow = (alpha1_flow - h1_dot) * real(50.0);
        LyapunovValues1 {
            inertia,
            F3,
            cos_t5,
            c1,
            s_c1,
            e2,
            s2,
            z2,
            t24,
            Psi2,
            t28,
            t29,
            t27,
            s_scale2,
            t30,
            t31,
            t32,
            t34,
            t39,
            zeta2_dot,
            eps2_dot,
            sigma2_dot,
            phi2_dot,
            h2_dot,
            e3,
            s3,
            D_hat3,
            zeta3_dot,
            t45,
            t51,
            x3_flow,
            chi2,
            t49,
            D_error3,
            V,
            HSigma2_1,
            V_T1_flow,
            V_zeta1_flow,
            c1_flow,
            V_chi1_flow,
            e2_flow,
            s2_flow,
            V_T2_flow,
            V_W2_flow,
            w_hat2_flow,
            V_D2_flow,
            V_zeta2_flow,
            F2_flow,
            A_hat2_flow,
            h1_dot_flow,
        }
    }
}
