// SHA-256 of the text below: 32182cb156ff6dc465cda7c0dfa5f0684d7c34a92304cfc7f8c6ca42fe3b58af
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 05232bb1e4d2b87c7bb300548a857e3c96008a6f6467540428e4dc35d68eaef0
// lyapunov: 1946 additions, 2403 multiplications, 40 divisions, 3 square roots, 34 elementary functions, 32 comparisons and selections

//! `nsv_attitude`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::polynomials;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
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
/// Operations: 1946 additions, 2403 multiplications, 40 divisions, 3 square roots, 34
/// elementary functions, 32 comparisons and selections.
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

    // -- plant model --
    let alpha = x1[0];
    let alpha_deg = alpha * real(57.29577951308232);
    let t1 = real(97170193.3485195) * params.CL_scale;
    let at_alpha_deg_2 = polynomials::at_alpha_deg_2_2(alpha_deg);
    let t2 = at_alpha_deg_2.CL_alpha + at_alpha_deg_2.CL_LE + at_alpha_deg_2.CL_RE;
    let lift = t1 * t2;
    let beta = x1[1];
    let mu = x1[2];
    let t3 = real(97170193.3485195) * params.CY_scale;
    let t4 = at_alpha_deg_2.CY_beta * beta + at_alpha_deg_2.CY_LE + at_alpha_deg_2.CY_RE
        + at_alpha_deg_2.CY_RUD;
    let side = t3 * t4;
    let q = x2[1];
    let r = x2[2];
    let p = x2[0];
    let t5 = real(1777048495.9577248) * params.Cl_scale;
    let t6 = at_alpha_deg_2.Cl_beta * beta + at_alpha_deg_2.Cl_LE + at_alpha_deg_2.Cl_RE
        + at_alpha_deg_2.Cl_RUD
        + at_alpha_deg_2.Cl_p * p * real(18.288) * real(0.00016666666666666666);
    let t7 = t6 + at_alpha_deg_2.Cl_r * r * real(18.288) * real(0.00016666666666666666);
    let roll = t5 * t7;
    let t8 = at_alpha_deg_2.Cm_alpha + at_alpha_deg_2.Cm_LE + at_alpha_deg_2.Cm_RE
        + at_alpha_deg_2.Cm_RUD
        + at_alpha_deg_2.Cm_q * q * real(24.384) * real(0.00016666666666666666);
    let pitch = real(2369397994.6102996) * params.Cm_scale * t8;
    let t9 = at_alpha_deg_2.Cn_beta * beta + at_alpha_deg_2.Cn_LE + at_alpha_deg_2.Cn_RE
        + at_alpha_deg_2.Cn_RUD
        + at_alpha_deg_2.Cn_p * p * real(18.288) * real(0.00016666666666666666);
    let t10 = t9 + at_alpha_deg_2.Cn_r * r * real(18.288) * real(0.00016666666666666666);
    let yaw = real(1777048495.9577248) * params.Cn_scale * t10;
    let dCl = Vector([
        at_alpha_deg_2.Cl_LE_d3,
        at_alpha_deg_2.Cl_RE_d3,
        at_alpha_deg_2.Cl_RUD_d3,
    ]);
    let roll_delta = dCl * t5;
    let dCm = Vector([at_alpha_deg_2.Cm_LE_d3, at_alpha_deg_2.Cm_RE_d3, real(0.0)]);
    let pitch_delta = dCm * (real(24.384) * params.Cm_scale) * real(97170193.3485195);
    let dCn = Vector([
        at_alpha_deg_2.Cn_LE_d3,
        at_alpha_deg_2.Cn_RE_d3,
        at_alpha_deg_2.Cn_RUD_d3,
    ]);
    let yaw_delta = dCn * (real(18.288) * params.Cn_scale) * real(97170193.3485195);

    // -- known dynamics of block 1 (attitude) (11) --
    let t11 = Vector([alpha, mu, beta]);
    let [sin_alpha, sin_mu, sin_beta] = t11.sin().0;
    let [cos_alpha, cos_mu, cos_beta] = t11.cos().0;
    let t12 = real(1332506.5352200002) * cos_mu;
    let t13 = real(410460000.0) * cos_beta;
    let t14 = (t12 - lift) / t13;
    let t15 = real(1332506.5352200002) * sin_mu;
    let [_, _, tan_beta] = t11.tan().0;
    let t16 = t12 * tan_beta;
    // F_1(x_1 .. x_1)
    let F1 = Vector([
        t14,
        (side + t15) * real(2.4362909905959168e-9),
        (lift * tan_beta - t16) * real(2.4362909905959168e-9),
    ]);
    let t17 = -tan_beta;
    let t18 = t17 * cos_alpha;
    let t19 = t17 * sin_alpha;
    let t20 = -cos_alpha;
    let t21 = cos_alpha / cos_beta;
    let t22 = sin_alpha / cos_beta;
    // G_1(x_1 .. x_1)
    let G1 = Matrix::rows([
        [t18, real(1.0), t19],
        [sin_alpha, real(0.0), t20],
        [t21, real(0.0), t22],
    ]);

    // -- known dynamics of block 2 (rates) (11) --
    let t23 = real(12202362.0) * p * r;
    let t24 = real(-12202362.0) * p * q;
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        roll * real(7.375621211696555e-7),
        (t23 + pitch) * real(7.375621211696555e-8),
        (t24 + yaw) * real(7.375621211696555e-8),
    ]);
    let t25 = roll_delta[0] * real(7.375621211696555e-7);
    let t26 = roll_delta[1] * real(7.375621211696555e-7);
    let t27 = roll_delta[2] * real(7.375621211696555e-7);
    let t28 = pitch_delta[0] * real(7.375621211696555e-8);
    let t29 = pitch_delta[1] * real(7.375621211696555e-8);
    let t30 = pitch_delta[2] * real(7.375621211696555e-8);
    let t31 = yaw_delta[0] * real(7.375621211696555e-8);
    let t32 = yaw_delta[1] * real(7.375621211696555e-8);
    let t33 = yaw_delta[2] * real(7.375621211696555e-8);
    // H_2(x_1 .. x_2)
    let H2 = Matrix::rows([[t25, t26, t27], [t28, t29, t30], [t31, t32, t33]]);

    // -- reference and constraints --
    let t34 = t.le(real(4.0));
    let t35 = real(FRAC_PI_4) * t - real(FRAC_PI_2);
    let t36 = real(2.0) * t;
    let t37 = real(0.5) * t;
    let t38 = real(0.9424777960769379) * t;
    let t39 = Vector([t, t35, t38, t37, t36]);
    let [sin_t, sin_t35, sin_t38, sin_t37, sin_t36] = t39.sin().0;
    let [cos_t, cos_t35, cos_t38, cos_t37, cos_t36] = t39.cos().0;
    let t40 = real(0.5) * cos_t37;
    // y_r(t)
    let y_r = Vector([
        T::select(
            t34,
            (real(2.5) * sin_t35 + real(1.5)) * real(0.017453292519943295),
            real(0.06981317007977318),
        ),
        real(0.5) * sin_t38 * real(0.017453292519943295),
        (real(-2.0) * sin_t + t40) * real(0.017453292519943295),
    ]);
    // y_r'
    let y_r_dot = Vector([
        T::select(
            t34,
            real(0.017453292519943295) * (real(2.5) * (cos_t35 * real(FRAC_PI_4))),
            real(0.0),
        ),
        real(0.017453292519943295) * (real(0.5) * (cos_t38 * real(0.9424777960769379))),
        real(0.017453292519943295)
            * (real(-2.0) * cos_t - real(0.5) * (sin_t37 * real(0.5))),
    ]);
    let t41 = -t;
    let t42 = real(-0.1) * t;
    let [exp_t41, exp_t42] = Vector([t41, t42]).exp().0;
    let t43 = real(3.0) * exp_t41;
    // k_2(t)
    let k2 = t43 + real(0.5);
    // k_1(t)
    let k1 = k2 * real(0.017453292519943295);
    // k1'
    let k1_dot = -(real(0.017453292519943295) * t43);
    // k2'
    let k2_dot = -t43;

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t44 = k1 * k1;
    let t45 = real(1.0) / t44;
    let t46 = s1 * t45;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t46 * t46);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t47 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t47;
    let t48 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t48;

    // -- MTPN of block 1 (4) (16) --
    // P_1 = P_m(z_1), 19 nodes
    let P1 = polynomials::basis1(x1);
    let t49 = state.W1.transpose();
    // A_hat_1 = iota_1 W_1^T P_1
    let A_hat1 = t49 * P1 * real(0.1);

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1 * real(10.0);

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) (63) --
    let t50 = kernel::sin_cos_over(E1);
    let t51 = real(1.5697963267948967) / E1_free;
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1 * real(2.375) * (t50 * real(1.0).min(t51)) + e1 * real(2.0);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    let t52 = real(0.5) * G_norm2_1;
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * t52;
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t53 = F1 + A_hat1;
    let t54 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t53 - y_r_dot + t54 + D_hat1 + Lam1;
    let t55 = Matrix::rows([[sin_alpha, t20], [t21, t22]]);
    let t56 = t55.solve(Vector([bracket1[1], bracket1[2]]));
    let t57 = bracket1[0] - t18 * t56[0] - t19 * t56[1];
    let t58 = Vector([t56[0], t57, t56[1]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t58;

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = G1 * state.zeta2 - t54;

    // -- weight law of block 1 (32) (65) --
    // W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)
    let W1_dot = P1.outer(c1 * real(0.1)) - state.W1 * real(0.1);

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(10.0);

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    let t59 = k2 * k2;
    let t60 = real(1.0) / t59;
    let t61 = s2 * t60;
    // pi s_2^2 / (2 k_2^4), before the clamp
    let E2_free = real(FRAC_PI_2) * (t61 * t61);
    // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
    let E2 = E2_free.min(real(1.5697963267948967));
    // cos E_2
    let cosE2 = E2.cos();
    let t62 = cosE2 * cosE2;
    // 1 / cos^2 E_2
    let sec2E2 = real(1.0) / t62;
    let t63 = s2 * sec2E2;
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * t63;

    // -- MTPN of block 2 (4) (16) --
    // P_2 = P_m(z_2), 19 nodes
    let P2 = polynomials::basis2(x2);
    let t64 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t64 * P2 * real(0.1);

    // -- disturbance observer of block 2 (20) (49) --
    let t65 = Vector([
        real(-1.5) * e2[0],
        real(1.5) * e2[0],
        real(1.5) * e2[1],
        e2[1],
        real(-2.0) * e2[2],
        real(4.0) * e2[2],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + t65;
    // d_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([
        real(2.0) * w_hat2[1],
        real(3.0) * w_hat2[2],
        w_hat2[4] + w_hat2[5],
    ]);

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    let t66 = E2.sin();
    let t67 = real(3.0) * sec2E2;
    let t68 = real(8.0) * E2_free * t66 * (cosE2 * (sec2E2 * sec2E2)) + t67;
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = (t68 * t68 + real(2.0) * (t67 * t67)).sqrt();
    // S_2 H_2
    let SH2 = Matrix::rows([
        [real(-1.5) * t25, real(-1.5) * t26, real(-1.5) * t27],
        [real(1.5) * t25, real(1.5) * t26, real(1.5) * t27],
        [real(1.5) * t28, real(1.5) * t29, real(1.5) * t30],
        [t28, t29, t30],
        [real(-2.0) * t31, real(-2.0) * t32, real(-2.0) * t33],
        [real(4.0) * t31, real(4.0) * t32, real(4.0) * t33],
    ]);
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t69 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t69 * t69 * real(0.5) + real(12.0)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(2.5)
        * (kernel::sin_cos_over(E2) * real(1.0).min(real(1.5697963267948967) / E2_free))
        + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(75.0);
    // e / (2 cos^2 E) (63)
    let Lam2_network = e2 * (real(0.5) * sec2E2);
    let t70 = (e2 * real(0.5)).tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t70 * state.eps2;
    let t71 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t71 * t71) * real(0.25) * t62;
    let t72 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t72 + real(1.0)).sqrt();
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t69 * state.sigma2 * s_scale2);
    let t73 = state.phi2 * state.phi2;
    let t74 = Psi2 / (t73 + t72);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t74 * t62;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t75 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + A_hat2 - h1_dot + t75 + D_hat2 + Lam2;
    let t76 = bracket2
        .hadamard(Vector::<T, 3>::from_f64([1355818.0, 13558180.0, 13558180.0]));
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t76;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 3>::from_f64([-2000000.0, -20000000.0, -20000000.0]))
        .min(Vector::<T, 3>::from_f64([2000000.0, 20000000.0, 20000000.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    let t77: Vector<T, 3> = Vector::from_f64([
        7.375621211696555e-7,
        7.375621211696555e-8,
        7.375621211696555e-8,
    ]);
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = t77.hadamard(u_sat + t76) - t75;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2 * real(0.1)) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    let t78 = Vector([
        real(3.0) * w_hat2[1],
        real(-3.0) * w_hat2[0],
        real(3.0) * w_hat2[3],
        real(-3.0) * w_hat2[2],
        real(3.0) * w_hat2[5],
        real(-3.0) * w_hat2[4],
    ]);
    let t79 = Vector([
        real(-1.5) * Lam2[0],
        real(1.5) * Lam2[0],
        real(1.5) * Lam2[1],
        Lam2[1],
        real(-2.0) * Lam2[2],
        real(4.0) * Lam2[2],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) = M_2
    // w_hat_2 + S_2 Lam_2
    let th2_dot = t78 + t79;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (t63 * e2.dot(t70) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t69 * t72 * sec2E2 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t74 + real(2.0);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.01)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (attitude) (11) --
    let t80 = real(97170193.3485195) * plant.CL_scale;
    let t81 = t80 * t2;
    let t82 = (t12 - t81) / t13;
    let t83 = real(97170193.3485195) * plant.CY_scale;
    // F_1 with the plant's parameters
    let F1_plant = Vector([
        t82,
        (t83 * t4 + t15) * real(2.4362909905959168e-9),
        (t81 * tan_beta - t16) * real(2.4362909905959168e-9),
    ]);
    let t84 = real(0.02) * sin_t36;
    let t85 = t84 * exp_t42;
    let t86 = real(0.02) * sin_t;
    // d_1(t)
    let d1 = Vector([t85, t86 * exp_t42, t85]);
    let t87 = G1 * x2;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + t87 + d1;

    // -- true dynamics of block 2 (rates) (11) --
    let t88 = real(1777048495.9577248) * plant.Cl_scale;
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        t88 * t7 * real(7.375621211696555e-7),
        (t23 + real(2369397994.6102996) * plant.Cm_scale * t8)
            * real(7.375621211696555e-8),
        (t24 + real(1777048495.9577248) * plant.Cn_scale * t10)
            * real(7.375621211696555e-8),
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([real(2.0) * w2[1], real(3.0) * w2[2], w2[4] + w2[5]]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = Vector([
        real(3.0) * w2[1],
        real(-3.0) * w2[0],
        real(3.0) * w2[3],
        real(-3.0) * w2[2],
        real(3.0) * w2[5],
        real(-3.0) * w2[4],
    ]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + t77.hadamard(u_sat) + d2;
    let t89 = dCl * t88;
    let t90 = dCm * (real(24.384) * plant.Cm_scale) * real(97170193.3485195);
    let t91 = dCn * (real(18.288) * plant.Cn_scale) * real(97170193.3485195);
    let t92 = Matrix::rows([
        [
            t89[0] * real(7.375621211696555e-7),
            t89[1] * real(7.375621211696555e-7),
            t89[2] * real(7.375621211696555e-7),
        ],
        [
            t90[0] * real(7.375621211696555e-8),
            t90[1] * real(7.375621211696555e-8),
            t90[2] * real(7.375621211696555e-8),
        ],
        [
            t91[0] * real(7.375621211696555e-8),
            t91[1] * real(7.375621211696555e-8),
            t91[2] * real(7.375621211696555e-8),
        ],
    ]);
    // H_2 Sigma_2
    let HSigma2 = t92 * real(0.05);

    // -- Lyapunov function of block 1 (23) (52) --
    let t93 = t44 * t44 * real(0.15915494309189535);
    let t94 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t93 * t94;
    let t95 = t49 * state.W1;
    // tr(W_1^T W_1)/(2 Gamma_1)
    let V_W1 = (t95[(0, 0)] + t95[(1, 1)] + t95[(2, 2)]) * real(0.5);
    // D_1 = d_1 + model error of block 1
    let D1 = d1 + (F1_plant - F1);
    // D_1 - D_hat_1
    let D_error1 = D1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t58;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    let t96 = t59 * t59 * real(0.15915494309189535);
    let t97 = E2.tan();
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t96 * t97;
    let t98 = t64 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t98[(0, 0)] + t98[(1, 1)] + t98[(2, 2)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 * real(5.0);
    let t99 = real(0.0075000000000000015) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t99 * t99 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t73 * real(0.5);

    // -- Lyapunov function (52) --
    let t100 = V_T1 + V_W1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;
    // V, sum of the parts above
    let V = t100 + V_eps2 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    // column 1 of HSigma2
    let HSigma2_1 = Vector([HSigma2[(0, 0)], HSigma2[(1, 0)], HSigma2[(2, 0)]]);
    // column 2 of HSigma2
    let HSigma2_2 = Vector([HSigma2[(0, 1)], HSigma2[(1, 1)], HSigma2[(2, 1)]]);
    // column 3 of HSigma2
    let HSigma2_3 = Vector([HSigma2[(0, 2)], HSigma2[(1, 2)], HSigma2[(2, 2)]]);
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t101 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t101 + t101;
    let t102 = (t46 + t46) * (s1_flow * t45 - t46 * t45 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t102;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t94 * (real(4.0) * (t44 * k1) * k1_dot * real(0.15915494309189535))
        + t93 * (E1_flow / t47);
    let t103 = W1_dot.transpose();
    let t104 = t103 * state.W1 + t49 * W1_dot;
    // V_W1' along the flow
    let V_W1_flow = (t104[(0, 0)] + t104[(1, 1)] + t104[(2, 2)]) * real(0.5);
    let t105 = exp_t42 * real(-0.1);
    let t106 = exp_t42 * (real(0.02) * (cos_t36 * real(2.0))) + t84 * t105;
    // d1'
    let d1_dot = Vector([t106, exp_t42 * (real(0.02) * cos_t) + t86 * t105, t106]);
    let t107 = sin_beta * x1_flow[1];
    let t108 = real(410460000.0) * t107;
    let t109 = real(1332506.5352200002) * (sin_mu * x1_flow[2]);
    let t110 = x1_flow[0] * real(57.29577951308232);
    let t111 = real(0.0001485745427349122) * t110;
    let t112 = at_alpha_deg_2.CL_alpha_d1 * t110 + t111 + t111;
    let t113 = t80 * t112;
    let t114 = beta * (at_alpha_deg_2.CY_beta_d1 * t110)
        + at_alpha_deg_2.CY_beta * x1_flow[1] + at_alpha_deg_2.CY_LE_d1 * t110
        + at_alpha_deg_2.CY_RE_d1 * t110;
    let t115 = t114 + real(4.86e-20) * t110;
    let t116 = real(1332506.5352200002) * (cos_mu * x1_flow[2]);
    let t117 = x1_flow[1] / (cos_beta * cos_beta);
    let t118 = t12 * t117 - tan_beta * t109;
    // F1_plant' along the flow
    let F1_plant_flow = Vector([
        t82 / t13 * t108 - (t109 + t113) / t13,
        (t83 * t115 + t116) * real(2.4362909905959168e-9),
        (tan_beta * t113 + t81 * t117 - t118) * real(2.4362909905959168e-9),
    ]);
    let t119 = t1 * t112;
    // F1' along the flow
    let F1_flow = Vector([
        t14 / t13 * t108 - (t109 + t119) / t13,
        (t3 * t115 + t116) * real(2.4362909905959168e-9),
        (tan_beta * t119 + lift * t117 - t118) * real(2.4362909905959168e-9),
    ]);
    // D1' along the flow
    let D1_flow = d1_dot + (F1_plant_flow - F1_flow);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow * real(10.0) - (D_hat1 + t53 + t87) * real(10.0);
    // D_error1' along the flow
    let D_error1_flow = D1_flow - D_hat1_flow;
    let t120 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t120 + t120) * real(0.5);
    let t121 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t121 + t121) * real(0.5);
    let t122 = sin_alpha * x1_flow[0];
    let t123 = -(cos_alpha * t117 - tan_beta * t122);
    let t124 = cos_alpha * x1_flow[0];
    let t125 = -(sin_alpha * t117 + tan_beta * t124);
    let t126 = t21 / cos_beta * t107 - t122 / cos_beta;
    let t127 = t124 / cos_beta + t22 / cos_beta * t107;
    // G1' along the flow
    let G1_flow = Matrix::rows([
        [t123, real(0.0), t125],
        [t124, real(0.0), t122],
        [t126, real(0.0), t127],
    ]);
    // P1' along the flow
    let P1_flow = polynomials::basis1_rate(x1, x1_flow);
    // A_hat1' along the flow
    let A_hat1_flow = (t103 * P1 + t49 * P1_flow) * real(0.1);
    // y_r''
    let y_r_dot2 = Vector([
        T::select(
            t34,
            real(0.017453292519943295)
                * (real(2.5) * -(real(FRAC_PI_4) * (sin_t35 * real(FRAC_PI_4)))),
            real(0.0),
        ),
        real(0.017453292519943295)
            * (real(0.5)
                * -(real(0.9424777960769379) * (sin_t38 * real(0.9424777960769379)))),
        real(0.017453292519943295)
            * (real(-2.0) * -sin_t - real(0.5) * (real(0.5) * t40)),
    ]);
    let t128 = real(1.0).lt(t51);
    let t129 = T::select(t128, real(1.0), t51);
    let t130 = t129 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t128, real(0.0), -(t50 * (t51 / E1_free * E1_free_flow)));
    let t131 = t50 * t129;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(2.375) * e1[0] * t130 + t131 * (real(2.375) * e1_flow[0])
            + real(2.0) * e1_flow[0],
        real(2.375) * e1[1] * t130 + t131 * (real(2.375) * e1_flow[1])
            + real(2.0) * e1_flow[1],
        real(2.375) * e1[2] * t130 + t131 * (real(2.375) * e1_flow[2])
            + real(2.0) * e1_flow[2],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(E1.sin() * E1_flow);
    // sec2E1' along the flow
    let sec2E1_flow = -(sec2E1 / t47 * ((cosE1 + cosE1) * cosE1_flow));
    // c1' along the flow
    let c1_flow = e1 * (s1_flow * sec2E1 + s1 * sec2E1_flow) + e1_flow * t48;
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t132 = (t18 + t18) * t123 + (t19 + t19) * t125 + (sin_alpha + sin_alpha) * t124;
    let t133 = t132 + (t20 - cos_alpha) * t122 + (t21 + t21) * t126;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t133 + (t22 + t22) * t127;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t52;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = F1_flow + A_hat1_flow - y_r_dot2 + zeta1_dot * real(20.0)
        + D_hat1_flow + Lam1_flow;
    let t134 = bracket1_flow - G1_flow * t58;
    let t135 = t55.solve(Vector([t134[1], t134[2]]));
    // chi1' along the flow
    let chi1_flow = h1_dot
        + Vector([t135[0], t134[0] - t18 * t135[0] - t19 * t135[1], t135[1]]);
    let t136 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t136 + t136) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t137 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t137 + t137;
    let t138 = t61 + t61;
    // E2_free' along the flow
    let E2_free_flow = real(FRAC_PI_2)
        * (t138 * (s2_flow * t60 - t61 * t60 * ((k2 + k2) * k2_dot)));
    let t139 = E2_free.lt(real(1.5697963267948967));
    // E2' along the flow
    let E2_flow = T::select(t139, E2_free_flow, real(0.0));
    // V_T2' along the flow
    let V_T2_flow = t97 * (real(4.0) * (t59 * k2) * k2_dot * real(0.15915494309189535))
        + t96 * (E2_flow / t62);
    let t140 = W2_dot.transpose() * state.W2 + t64 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t140[(0, 0)] + t140[(1, 1)] + t140[(2, 2)]) * real(0.5);
    let t141 = Vector([
        real(-1.5) * e2_flow[0],
        real(1.5) * e2_flow[0],
        real(1.5) * e2_flow[1],
        e2_flow[1],
        real(-2.0) * e2_flow[2],
        real(4.0) * e2_flow[2],
    ]);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + t141;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t142 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t142 + t142) * real(0.5);
    let t143 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t143 + t143) * real(0.5);
    let t144 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t144 + t144) * real(5.0);
    let t145 = -sigma2_dot * t99;
    // V_sigma2' along the flow
    let V_sigma2_flow = (t145 + t145) * real(0.5);
    let t146 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t146 + t146) * real(0.5);
    let t147 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t147 + t147;
    let t148 = s2_noise1_ * t60;
    // D^1 E2_free along noise1
    let E2_free_noise1_ = real(FRAC_PI_2) * (t138 * t148);
    // D^1 E2 along noise1
    let E2_noise1_ = T::select(t139, E2_free_noise1_, real(0.0));
    let t149 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t149 + t149;
    // D^2 E2_free along noise1
    let E2_free_noise1_2 = real(FRAC_PI_2)
        * (t148 * (t148 + t148) + t138 * (s2_noise1_2 * t60));
    // D^2 E2 along noise1
    let E2_noise1_2 = T::select(t139, E2_free_noise1_2, real(0.0));
    let t150 = cosE2 + cosE2;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = t96
        * (E2_noise1_2 / t62 + E2_noise1_ / t62 / t62 * (t150 * (t66 * E2_noise1_)));
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = Vector([
        real(-1.5) * HSigma2[(0, 0)],
        real(1.5) * HSigma2[(0, 0)],
        real(1.5) * HSigma2[(1, 0)],
        HSigma2[(1, 0)],
        real(-2.0) * HSigma2[(2, 0)],
        real(4.0) * HSigma2[(2, 0)],
    ]);
    let t151 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t151 + t151) * real(0.5);
    let t152 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t152 + t152;
    let t153 = s2_noise2_ * t60;
    // D^1 E2_free along noise2
    let E2_free_noise2_ = real(FRAC_PI_2) * (t138 * t153);
    // D^1 E2 along noise2
    let E2_noise2_ = T::select(t139, E2_free_noise2_, real(0.0));
    let t154 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t154 + t154;
    // D^2 E2_free along noise2
    let E2_free_noise2_2 = real(FRAC_PI_2)
        * (t153 * (t153 + t153) + t138 * (s2_noise2_2 * t60));
    // D^2 E2 along noise2
    let E2_noise2_2 = T::select(t139, E2_free_noise2_2, real(0.0));
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = t96
        * (E2_noise2_2 / t62 + E2_noise2_ / t62 / t62 * (t150 * (t66 * E2_noise2_)));
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = Vector([
        real(-1.5) * HSigma2[(0, 1)],
        real(1.5) * HSigma2[(0, 1)],
        real(1.5) * HSigma2[(1, 1)],
        HSigma2[(1, 1)],
        real(-2.0) * HSigma2[(2, 1)],
        real(4.0) * HSigma2[(2, 1)],
    ]);
    let t155 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t155 + t155) * real(0.5);
    let t156 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t156 + t156;
    let t157 = s2_noise3_ * t60;
    // D^1 E2_free along noise3
    let E2_free_noise3_ = real(FRAC_PI_2) * (t138 * t157);
    // D^1 E2 along noise3
    let E2_noise3_ = T::select(t139, E2_free_noise3_, real(0.0));
    let t158 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t158 + t158;
    // D^2 E2_free along noise3
    let E2_free_noise3_2 = real(FRAC_PI_2)
        * (t157 * (t157 + t157) + t138 * (s2_noise3_2 * t60));
    // D^2 E2 along noise3
    let E2_noise3_2 = T::select(t139, E2_free_noise3_2, real(0.0));
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = t96
        * (E2_noise3_2 / t62 + E2_noise3_ / t62 / t62 * (t150 * (t66 * E2_noise3_)));
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = Vector([
        real(-1.5) * HSigma2[(0, 2)],
        real(1.5) * HSigma2[(0, 2)],
        real(1.5) * HSigma2[(1, 2)],
        HSigma2[(1, 2)],
        real(-2.0) * HSigma2[(2, 2)],
        real(4.0) * HSigma2[(2, 2)],
    ]);
    let t159 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t159 + t159) * real(0.5);
    let t160 = V_T1_flow + V_W1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow
        + V_W2_flow + V_D2_flow + V_zeta2_flow;
    let t161 = t160 + V_eps2_flow + V_sigma2_flow + V_phi2_flow
        + V_T2_noise1_2 * real(0.5) + V_D2_noise1_2 * real(0.5);
    let t162 = t161 + V_T2_noise2_2 * real(0.5) + V_D2_noise2_2 * real(0.5)
        + V_T2_noise3_2 * real(0.5) + V_D2_noise3_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t162 + real(0.5) + real(0.5) + real(0.5) + real(0.5) + real(0.5)
        + real(0.5);
    LyapunovOutputs { V, LV }
}
