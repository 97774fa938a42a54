// SHA-256 of the text below: 8ea472f26fb008b7fe673fa8720fcdd126f21d510ac378d92346efa6840f2b33
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 05232bb1e4d2b87c7bb300548a857e3c96008a6f6467540428e4dc35d68eaef0
// lyapunov: 2302 additions, 2746 multiplications, 127 divisions, 3 square roots, 32 elementary functions, 32 comparisons and selections

//! `nsv_attitude`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::polynomials;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};
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
/// Operations: 2302 additions, 2746 multiplications, 127 divisions, 3 square roots, 32
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
    let alpha_deg = alpha / real(0.017453292519943295);
    let t1 = real(97170193.3485195) * params.CL_scale;
    let at_alpha_deg = polynomials::at_alpha_deg_3(alpha_deg);
    let t2 = at_alpha_deg.CL_alpha + at_alpha_deg.CL_LE + at_alpha_deg.CL_RE;
    let lift = t1 * t2;
    let mu = x1[2];
    let beta = x1[1];
    let t3 = real(97170193.3485195) * params.CY_scale;
    let t4 = at_alpha_deg.CY_beta * beta + at_alpha_deg.CY_LE + at_alpha_deg.CY_RE
        + at_alpha_deg.CY_RUD;
    let side = t3 * t4;
    let q = x2[1];
    let r = x2[2];
    let p = x2[0];
    let t5 = real(1777048495.9577248) * params.Cl_scale;
    let t6 = at_alpha_deg.Cl_beta * beta + at_alpha_deg.Cl_LE + at_alpha_deg.Cl_RE
        + at_alpha_deg.Cl_RUD + at_alpha_deg.Cl_p * p * real(18.288) / real(6000.0);
    let t7 = t6 + at_alpha_deg.Cl_r * r * real(18.288) / real(6000.0);
    let roll = t5 * t7;
    let t8 = at_alpha_deg.Cm_alpha + at_alpha_deg.Cm_LE + at_alpha_deg.Cm_RE
        + at_alpha_deg.Cm_RUD + at_alpha_deg.Cm_q * q * real(24.384) / real(6000.0);
    let pitch = real(2369397994.6102996) * params.Cm_scale * t8;
    let t9 = at_alpha_deg.CD_alpha + at_alpha_deg.CD_LE + at_alpha_deg.CD_RE
        + at_alpha_deg.CD_RUD;
    let drag = real(97170193.3485195) * params.CD_scale * t9;
    let t10 = at_alpha_deg.Cn_beta * beta + at_alpha_deg.Cn_LE + at_alpha_deg.Cn_RE
        + at_alpha_deg.Cn_RUD + at_alpha_deg.Cn_p * p * real(18.288) / real(6000.0);
    let t11 = t10 + at_alpha_deg.Cn_r * r * real(18.288) / real(6000.0);
    let yaw = real(1777048495.9577248) * params.Cn_scale * t11;
    let dCl = Vector([
        at_alpha_deg.Cl_LE_d3,
        at_alpha_deg.Cl_RE_d3,
        at_alpha_deg.Cl_RUD_d3,
    ]);
    let roll_delta = dCl * t5;
    let dCm = Vector([at_alpha_deg.Cm_LE_d3, at_alpha_deg.Cm_RE_d3, real(0.0)]);
    let dCD = Vector([
        at_alpha_deg.CD_LE_d3,
        at_alpha_deg.CD_RE_d3,
        at_alpha_deg.CD_RUD_d3,
    ]);
    let dCL = Vector([at_alpha_deg.CL_LE_d3, at_alpha_deg.CL_RE_d3, real(0.0)]);
    let t12 = alpha.sin();
    let t13 = alpha.cos();
    let t14 = (dCD * params.CD_scale * t12 + dCL * params.CL_scale * t13) * real(0.0);
    let pitch_delta = (dCm * (real(24.384) * params.Cm_scale) + t14)
        * real(97170193.3485195);
    let dCn = Vector([
        at_alpha_deg.Cn_LE_d3,
        at_alpha_deg.Cn_RE_d3,
        at_alpha_deg.Cn_RUD_d3,
    ]);
    let dCY = Vector([
        at_alpha_deg.CY_LE_d3,
        at_alpha_deg.CY_RE_d3,
        at_alpha_deg.CY_RUD_d3,
    ]);
    let yaw_delta = (dCn * (real(18.288) * params.Cn_scale)
        + dCY * (real(0.0) * params.CY_scale)) * real(97170193.3485195);

    // -- known dynamics of block 1 (attitude) (11) --
    let t15 = real(0.0) * t12;
    let t16 = mu.cos();
    let t17 = real(1332506.5352200002) * t16;
    let t18 = beta.cos();
    let t19 = real(410460000.0) * t18;
    let t20 = real(0.0) * t13;
    let t21 = beta.sin();
    let t22 = t20 * t21;
    let t23 = mu.sin();
    let t24 = real(1332506.5352200002) * t23;
    let t25 = beta.tan();
    let t26 = t25 + real(0.0) * t23;
    let t27 = side * real(0.0);
    let t28 = t17 * t25;
    let t29 = t13 * t21 * real(0.0);
    let t30 = real(0.0) * (t12 * t26 - t29 * t16);
    // F_1(x_1 .. x_1)
    let F1 = Vector([
        (-lift - t15 + t17) / t19,
        (side - t22 + t24) / real(410460000.0),
        (lift * t26 + t27 * t16 - t28 + t30) / real(410460000.0),
    ]);
    let t31 = -t25;
    let t32 = t31 * t13;
    let t33 = t31 * t12;
    let t34 = -t13;
    let t35 = t13 / t18;
    let t36 = t12 / t18;
    // G_1(x_1 .. x_1)
    let G1 = Matrix([
        [t32, real(1.0), t33],
        [t12, real(0.0), t34],
        [t35, real(0.0), t36],
    ]);

    // -- known dynamics of block 2 (rates) (11) --
    let t37 = real(0.0) * q * r;
    let t38 = real(12202362.0) * p * r;
    let t39 = real(-12202362.0) * p * q;
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        (t37 + roll) / real(1355818.0),
        (t38 + pitch + real(0.0) * (drag * t12 + lift * t13)) / real(13558180.0),
        (t39 + yaw + t27) / real(13558180.0),
    ]);
    // G_2(x_1 .. x_2)
    let G2: Matrix<T, 3, 3> = Matrix::from_f64([
        [7.375621211696555e-7, 0.0, 0.0],
        [0.0, 7.375621211696555e-8, 0.0],
        [0.0, 0.0, 7.375621211696555e-8],
    ]);
    // H_2(x_1 .. x_2)
    let H2 = Matrix([
        [
            roll_delta[0] / real(1355818.0),
            roll_delta[1] / real(1355818.0),
            roll_delta[2] / real(1355818.0),
        ],
        [
            pitch_delta[0] / real(13558180.0),
            pitch_delta[1] / real(13558180.0),
            pitch_delta[2] / real(13558180.0),
        ],
        [
            yaw_delta[0] / real(13558180.0),
            yaw_delta[1] / real(13558180.0),
            yaw_delta[2] / real(13558180.0),
        ],
    ]);

    // -- reference and constraints --
    let t40 = t.le(real(4.0));
    let t41 = real(FRAC_PI_4) * t - real(FRAC_PI_2);
    let t42 = t41.sin();
    let t43 = real(0.9424777960769379) * t;
    let t44 = t43.sin();
    let t45 = t.sin();
    let t46 = real(0.5) * t;
    let t47 = real(0.5) * t46.cos();
    // y_r(t)
    let y_r = Vector([
        T::select(
            t40,
            (real(2.5) * t42 + real(1.5)) * real(0.017453292519943295),
            real(0.06981317007977318),
        ),
        real(0.5) * t44 * real(0.017453292519943295),
        (real(-2.0) * t45 + t47) * real(0.017453292519943295),
    ]);
    let t48 = t41.cos();
    let t49 = t43.cos();
    let t50 = t.cos();
    let t51 = t46.sin();
    // y_r'
    let y_r_dot = Vector([
        T::select(
            t40,
            real(0.017453292519943295) * (real(2.5) * (t48 * real(FRAC_PI_4))),
            real(0.0),
        ),
        real(0.017453292519943295) * (real(0.5) * (t49 * real(0.9424777960769379))),
        real(0.017453292519943295) * (real(-2.0) * t50 - real(0.5) * (t51 * real(0.5))),
    ]);
    let t52 = real(3.0) * (-t).exp();
    // k_2(t)
    let k2 = t52 + real(0.5);
    // k_1(t)
    let k1 = k2 * real(0.017453292519943295);
    // k1'
    let k1_dot = -(real(0.017453292519943295) * t52);
    // k2'
    let k2_dot = -t52;

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t53 = k1 * k1;
    let t54 = s1 / t53;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t54 * t54);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t55 = cosE1 * cosE1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * s1 / t55;

    // -- MTPN of block 1 (4) (16) --
    // P_1 = P_m(z_1), 19 nodes
    let P1 = polynomials::basis1(x1);
    let t56 = state.W1.transpose();
    // A_hat_1 = iota_1 W_1^T P_1
    let A_hat1 = t56 * P1 * real(0.1);

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1 * real(10.0);

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) (63) --
    let t57 = kernel::sin_cos_over(E1);
    let t58 = real(1.5697963267948967) / E1_free;
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1 * real(2.375) * (t57 * real(1.0).min(t58)) + e1 * real(2.0);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    let t59 = real(0.5) * G_norm2_1;
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * t59;
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t60 = F1 + A_hat1;
    let t61 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t60 - y_r_dot + t61 + D_hat1 + Lam1;
    let t62 = G1.solve(bracket1);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t62;

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = G1 * state.zeta2 - t61;

    // -- weight law of block 1 (32) (65) --
    let t63: Vector<T, 3> = Vector::from_f64([0.1, 0.1, 0.1]);
    // W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)
    let W1_dot = P1.outer(t63.hadamard(c1)) - state.W1 * real(0.1);

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) / real(0.1);

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    let t64 = k2 * k2;
    let t65 = s2 / t64;
    // pi s_2^2 / (2 k_2^4), before the clamp
    let E2_free = real(FRAC_PI_2) * (t65 * t65);
    // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
    let E2 = E2_free.min(real(1.5697963267948967));
    // cos E_2
    let cosE2 = E2.cos();
    let t66 = cosE2 * cosE2;
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2 / t66;

    // -- MTPN of block 2 (4) (16) --
    // P_2 = P_m(z_2), 19 nodes
    let P2 = polynomials::basis2(x2);
    let t67 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t67 * P2 * real(0.1);

    // -- disturbance observer of block 2 (20) (49) --
    // S_2, observer gain
    let S2: Matrix<T, 6, 3> = Matrix::from_f64([
        [-1.5, 0.0, 0.0],
        [1.5, 0.0, 0.0],
        [0.0, 1.5, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, -2.0],
        [0.0, 0.0, 4.0],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + S2 * e2;
    // L_2
    let L2: Matrix<T, 3, 6> = Matrix::from_f64([
        [0.0, 2.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 3.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 1.0, 1.0],
    ]);
    // d_hat_2 = L_2 w_hat_2
    let D_hat2 = L2 * w_hat2;

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    let t68 = E2.sin();
    let t69 = real(3.0) / t66;
    let t70 = real(8.0) * E2_free * t68 / (t66 * cosE2) + t69;
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = (t70 * t70 + real(2.0) * (t69 * t69)).sqrt();
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t71 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t71 * t71 * real(0.5) + real(12.0)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(2.5)
        * (kernel::sin_cos_over(E2) * real(1.0).min(real(1.5697963267948967) / E2_free))
        + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(75.0);
    let t72 = e2 * real(0.5);
    // e / (2 cos^2 E) (63)
    let Lam2_network = t72 / t66;
    let t73 = t72.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t73 * state.eps2;
    let t74 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t74 * t74) * real(0.25) * t66;
    let t75 = s2 * s2;
    let t76 = (t75 + real(1.0)).sqrt();
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t71 * state.sigma2) / t76;
    let t77 = state.phi2 * state.phi2;
    let t78 = Psi2 / (t77 + t75);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t78 * t66;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t79 = F2 + A_hat2;
    let t80 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t79 - h1_dot + t80 + D_hat2 + Lam2;
    let t81 = G2.solve(bracket2);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t81;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 3>::from_f64([-2000000.0, -20000000.0, -20000000.0]))
        .min(Vector::<T, 3>::from_f64([2000000.0, 20000000.0, 20000000.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = G2 * (u_sat + t81) - t80;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(t63.hadamard(c2)) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    // M_2 - S_2 L_2
    let w2_closed: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.0, 6.0, 0.0, 0.0, 0.0, 0.0],
        [-3.0, -3.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -4.5, 3.0, 0.0, 0.0],
        [0.0, 0.0, -6.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 2.0, 5.0],
        [0.0, 0.0, 0.0, 0.0, -7.0, -4.0],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2)
    let th2_dot = w2_closed * w_hat2 - S2 * (t79 + G2 * u - h1_dot + t80);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 / t66 * e2.dot(t73) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t71 * t75 / t66 / t76 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t78 + real(2.0);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.01)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (attitude) (11) --
    let t82 = real(97170193.3485195) * plant.CL_scale;
    let t83 = t82 * t2;
    let t84 = real(97170193.3485195) * plant.CY_scale;
    let t85 = t84 * t4;
    let t86 = t85 * real(0.0);
    // F_1 with the plant's parameters
    let F1_plant = Vector([
        (-t83 - t15 + t17) / t19,
        (t85 - t22 + t24) / real(410460000.0),
        (t83 * t26 + t86 * t16 - t28 + t30) / real(410460000.0),
    ]);
    let t87 = real(2.0) * t;
    let t88 = real(0.02) * t87.sin();
    let t89 = (real(-0.1) * t).exp();
    let t90 = t88 * t89;
    let t91 = real(0.02) * t45;
    // d_1(t)
    let d1 = Vector([t90, t91 * t89, t90]);
    let t92 = G1 * x2;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + t92 + d1;

    // -- true dynamics of block 2 (rates) (11) --
    let t93 = real(1777048495.9577248) * plant.Cl_scale;
    let t94 = real(0.0)
        * (real(97170193.3485195) * plant.CD_scale * t9 * t12 + t83 * t13);
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        (t37 + t93 * t7) / real(1355818.0),
        (t38 + real(2369397994.6102996) * plant.Cm_scale * t8 + t94) / real(13558180.0),
        (t39 + real(1777048495.9577248) * plant.Cn_scale * t11 + t86) / real(13558180.0),
    ]);
    // G_2 with the plant's parameters
    let G2_plant: Matrix<T, 3, 3> = Matrix::from_f64([
        [7.375621211696555e-7, 0.0, 0.0],
        [0.0, 7.375621211696555e-8, 0.0],
        [0.0, 0.0, 7.375621211696555e-8],
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    let t95: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.0, 3.0, 0.0, 0.0, 0.0, 0.0],
        [-3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 3.0, 0.0, 0.0],
        [0.0, 0.0, -3.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 3.0],
        [0.0, 0.0, 0.0, 0.0, -3.0, 0.0],
    ]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = t95 * w2;
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;
    let t96 = dCl * t93;
    let t97 = (dCD * plant.CD_scale * t12 + dCL * plant.CL_scale * t13) * real(0.0);
    let t98 = (dCm * (real(24.384) * plant.Cm_scale) + t97) * real(97170193.3485195);
    let t99 = (dCn * (real(18.288) * plant.Cn_scale)
        + dCY * (real(0.0) * plant.CY_scale)) * real(97170193.3485195);
    let t100 = Matrix([
        [t96[0] / real(1355818.0), t96[1] / real(1355818.0), t96[2] / real(1355818.0)],
        [
            t98[0] / real(13558180.0),
            t98[1] / real(13558180.0),
            t98[2] / real(13558180.0),
        ],
        [t99[0] / real(13558180.0), t99[1] / real(13558180.0), t99[2] / real(13558180.0)],
    ]);
    // H_2 Sigma_2
    let HSigma2 = t100
        .hadamard(
            Matrix::<
                T,
                3,
                3,
            >::from_f64([[0.05, 0.05, 0.05], [0.05, 0.05, 0.05], [0.05, 0.05, 0.05]]),
        );

    // -- Lyapunov function of block 1 (23) (52) --
    let t101 = t53 * t53 / real(TAU);
    let t102 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t101 * t102;
    let t103 = t56 * state.W1;
    // tr(W_1^T W_1)/(2 Gamma_1)
    let V_W1 = (t103[(0, 0)] + t103[(1, 1)] + t103[(2, 2)]) * real(0.5);
    // D_1 = d_1 + model error of block 1
    let D1 = d1 + (F1_plant - F1);
    // D_1 - D_hat_1
    let D_error1 = D1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t62;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    let t104 = t64 * t64 / real(TAU);
    let t105 = E2.tan();
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t104 * t105;
    let t106 = t67 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t106[(0, 0)] + t106[(1, 1)] + t106[(2, 2)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 / real(0.2);
    let t107 = real(0.0075000000000000015) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t107 * t107 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t77 * real(0.5);

    // -- Lyapunov function (52) --
    let t108 = V_T1 + V_W1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;
    // V, sum of the parts above
    let V = t108 + V_eps2 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    // column 1 of HSigma2
    let HSigma2_1 = Vector([HSigma2[(0, 0)], HSigma2[(1, 0)], HSigma2[(2, 0)]]);
    // column 2 of HSigma2
    let HSigma2_2 = Vector([HSigma2[(0, 1)], HSigma2[(1, 1)], HSigma2[(2, 1)]]);
    // column 3 of HSigma2
    let HSigma2_3 = Vector([HSigma2[(0, 2)], HSigma2[(1, 2)], HSigma2[(2, 2)]]);
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t109 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t109 + t109;
    let t110 = (t54 + t54) * (s1_flow / t53 - t54 / t53 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t110;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t102 * (real(4.0) * (t53 * k1) * k1_dot / real(TAU))
        + t101 * (E1_flow / t55);
    let t111 = W1_dot.transpose();
    let t112 = t111 * state.W1 + t56 * W1_dot;
    // V_W1' along the flow
    let V_W1_flow = (t112[(0, 0)] + t112[(1, 1)] + t112[(2, 2)]) * real(0.5);
    let t113 = t89 * real(-0.1);
    let t114 = t89 * (real(0.02) * (t87.cos() * real(2.0))) + t88 * t113;
    // d1'
    let d1_dot = Vector([t114, t89 * (real(0.02) * t50) + t91 * t113, t114]);
    let t115 = t21 * x1_flow[1];
    let t116 = real(410460000.0) * t115;
    let t117 = (t17 - (t83 + t15)) / t19 / t19 * t116;
    let t118 = t23 * x1_flow[2];
    let t119 = real(1332506.5352200002) * t118;
    let t120 = x1_flow[0] / real(0.017453292519943295);
    let t121 = real(0.0001485745427349122) * t120;
    let t122 = at_alpha_deg.CL_alpha_d1 * t120 + t121 + t121;
    let t123 = t82 * t122;
    let t124 = t13 * x1_flow[0];
    let t125 = real(0.0) * t124;
    let t126 = beta * (at_alpha_deg.CY_beta_d1 * t120)
        + at_alpha_deg.CY_beta * x1_flow[1] + at_alpha_deg.CY_LE_d1 * t120
        + at_alpha_deg.CY_RE_d1 * t120;
    let t127 = t126 + real(4.86e-20) * t120;
    let t128 = t84 * t127;
    let t129 = t18 * x1_flow[1];
    let t130 = t12 * x1_flow[0];
    let t131 = t20 * t129 - t21 * (real(0.0) * t130);
    let t132 = t16 * x1_flow[2];
    let t133 = real(1332506.5352200002) * t132;
    let t134 = x1_flow[1] / (t18 * t18);
    let t135 = t134 + real(0.0) * t132;
    let t136 = t26 * t123 + t83 * t135 + (t16 * (real(0.0) * t128) - t86 * t118);
    let t137 = t17 * t134 - t25 * t119;
    let t138 = t16 * (real(0.0) * (t13 * t129 - t21 * t130)) - t29 * t118;
    let t139 = real(0.0) * (t26 * t124 + t12 * t135 - t138);
    // F1_plant' along the flow
    let F1_plant_flow = Vector([
        t117 - (t119 + (t123 + t125)) / t19,
        (t128 - t131 + t133) / real(410460000.0),
        (t136 - t137 + t139) / real(410460000.0),
    ]);
    let t140 = (t17 - (lift + t15)) / t19 / t19 * t116;
    let t141 = t1 * t122;
    let t142 = t3 * t127;
    let t143 = t26 * t141 + lift * t135 + (t16 * (real(0.0) * t142) - t27 * t118);
    // F1' along the flow
    let F1_flow = Vector([
        t140 - (t119 + (t141 + t125)) / t19,
        (t142 - t131 + t133) / real(410460000.0),
        (t143 - t137 + t139) / real(410460000.0),
    ]);
    // D1' along the flow
    let D1_flow = d1_dot + (F1_plant_flow - F1_flow);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow * real(10.0) - (D_hat1 + t60 + t92) * real(10.0);
    // D_error1' along the flow
    let D_error1_flow = D1_flow - D_hat1_flow;
    let t144 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t144 + t144) * real(0.5);
    let t145 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t145 + t145) * real(0.5);
    let t146 = -(t13 * t134 - t25 * t130);
    let t147 = -(t12 * t134 + t25 * t124);
    let t148 = t35 / t18 * t115 - t130 / t18;
    let t149 = t124 / t18 + t36 / t18 * t115;
    // G1' along the flow
    let G1_flow = Matrix([
        [t146, real(0.0), t147],
        [t124, real(0.0), t130],
        [t148, real(0.0), t149],
    ]);
    // P1' along the flow
    let P1_flow = polynomials::basis1_rate(x1, x1_flow);
    // A_hat1' along the flow
    let A_hat1_flow = (t111 * P1 + t56 * P1_flow) * real(0.1);
    let t150 = real(-2.0) * (t50 * real(0.0) - t45)
        - real(0.5) * (real(0.5) * t47 + t51 * real(0.0));
    // y_r''
    let y_r_dot2 = Vector([
        T::select(
            t40,
            real(0.017453292519943295)
                * (real(2.5)
                    * (t48 * real(0.0) - real(FRAC_PI_4) * (t42 * real(FRAC_PI_4)))),
            real(0.0),
        ),
        real(0.017453292519943295)
            * (real(0.5)
                * (t49 * real(0.0)
                    - real(0.9424777960769379) * (t44 * real(0.9424777960769379)))),
        real(0.017453292519943295) * t150,
    ]);
    let t151 = real(1.0).lt(t58);
    let t152 = T::select(t151, real(1.0), t58);
    let t153 = t152 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t151, real(0.0), -(t57 * (t58 / E1_free * E1_free_flow)));
    let t154 = t57 * t152;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(2.375) * e1[0] * t153 + t154 * (real(2.375) * e1_flow[0])
            + real(2.0) * e1_flow[0],
        real(2.375) * e1[1] * t153 + t154 * (real(2.375) * e1_flow[1])
            + real(2.0) * e1_flow[1],
        real(2.375) * e1[2] * t153 + t154 * (real(2.375) * e1_flow[2])
            + real(2.0) * e1_flow[2],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(E1.sin() * E1_flow);
    let t155 = (cosE1 + cosE1) * cosE1_flow;
    let t156 = s1 * e1[0] / t55 / t55 * t155;
    let t157 = s1 * e1[1] / t55 / t55 * t155;
    let t158 = s1 * e1[2] / t55 / t55 * t155;
    // c1' along the flow
    let c1_flow = Vector([
        (e1[0] * s1_flow + s1 * e1_flow[0]) / t55 - t156,
        (e1[1] * s1_flow + s1 * e1_flow[1]) / t55 - t157,
        (e1[2] * s1_flow + s1 * e1_flow[2]) / t55 - t158,
    ]);
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t159 = (t32 + t32) * t146 + real(0.0) + (t33 + t33) * t147;
    let t160 = t159 + (t12 + t12) * t124 + real(0.0) + (t34 - t13) * t130;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t160 + (t35 + t35) * t148 + real(0.0) + (t36 + t36) * t149;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t59;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = F1_flow + A_hat1_flow - y_r_dot2 + zeta1_dot * real(20.0)
        + D_hat1_flow + Lam1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + G1.solve(bracket1_flow - G1_flow * t62);
    let t161 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t161 + t161) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t162 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t162 + t162;
    let t163 = t65 + t65;
    // E2_free' along the flow
    let E2_free_flow = real(FRAC_PI_2)
        * (t163 * (s2_flow / t64 - t65 / t64 * ((k2 + k2) * k2_dot)));
    let t164 = E2_free.lt(real(1.5697963267948967));
    // E2' along the flow
    let E2_flow = T::select(t164, E2_free_flow, real(0.0));
    // V_T2' along the flow
    let V_T2_flow = t105 * (real(4.0) * (t64 * k2) * k2_dot / real(TAU))
        + t104 * (E2_flow / t66);
    let t165 = W2_dot.transpose() * state.W2 + t67 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t165[(0, 0)] + t165[(1, 1)] + t165[(2, 2)]) * real(0.5);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + S2 * e2_flow;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t166 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t166 + t166) * real(0.5);
    let t167 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t167 + t167) * real(0.5);
    let t168 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t168 + t168) / real(0.2);
    let t169 = -sigma2_dot * t107;
    // V_sigma2' along the flow
    let V_sigma2_flow = (t169 + t169) * real(0.5);
    let t170 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t170 + t170) * real(0.5);
    let t171 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t171 + t171;
    let t172 = s2_noise1_ / t64;
    // D^1 E2_free along noise1
    let E2_free_noise1_ = real(FRAC_PI_2) * (t163 * t172);
    // D^1 E2 along noise1
    let E2_noise1_ = T::select(t164, E2_free_noise1_, real(0.0));
    let t173 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t173 + t173;
    // D^2 E2_free along noise1
    let E2_free_noise1_2 = real(FRAC_PI_2)
        * (t172 * (t172 + t172) + t163 * (s2_noise1_2 / t64));
    // D^2 E2 along noise1
    let E2_noise1_2 = T::select(t164, E2_free_noise1_2, real(0.0));
    let t174 = cosE2 + cosE2;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = t104
        * (E2_noise1_2 / t66 + E2_noise1_ / t66 / t66 * (t174 * (t68 * E2_noise1_)));
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = S2 * HSigma2_1;
    let t175 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t175 + t175) * real(0.5);
    let t176 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t176 + t176;
    let t177 = s2_noise2_ / t64;
    // D^1 E2_free along noise2
    let E2_free_noise2_ = real(FRAC_PI_2) * (t163 * t177);
    // D^1 E2 along noise2
    let E2_noise2_ = T::select(t164, E2_free_noise2_, real(0.0));
    let t178 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t178 + t178;
    // D^2 E2_free along noise2
    let E2_free_noise2_2 = real(FRAC_PI_2)
        * (t177 * (t177 + t177) + t163 * (s2_noise2_2 / t64));
    // D^2 E2 along noise2
    let E2_noise2_2 = T::select(t164, E2_free_noise2_2, real(0.0));
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = t104
        * (E2_noise2_2 / t66 + E2_noise2_ / t66 / t66 * (t174 * (t68 * E2_noise2_)));
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = S2 * HSigma2_2;
    let t179 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t179 + t179) * real(0.5);
    let t180 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t180 + t180;
    let t181 = s2_noise3_ / t64;
    // D^1 E2_free along noise3
    let E2_free_noise3_ = real(FRAC_PI_2) * (t163 * t181);
    // D^1 E2 along noise3
    let E2_noise3_ = T::select(t164, E2_free_noise3_, real(0.0));
    let t182 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t182 + t182;
    // D^2 E2_free along noise3
    let E2_free_noise3_2 = real(FRAC_PI_2)
        * (t181 * (t181 + t181) + t163 * (s2_noise3_2 / t64));
    // D^2 E2 along noise3
    let E2_noise3_2 = T::select(t164, E2_free_noise3_2, real(0.0));
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = t104
        * (E2_noise3_2 / t66 + E2_noise3_ / t66 / t66 * (t174 * (t68 * E2_noise3_)));
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = S2 * HSigma2_3;
    let t183 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t183 + t183) * real(0.5);
    let t184 = V_T1_flow + V_W1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow
        + V_W2_flow + V_D2_flow + V_zeta2_flow;
    let t185 = t184 + V_eps2_flow + V_sigma2_flow + V_phi2_flow
        + V_T2_noise1_2 * real(0.5) + V_D2_noise1_2 * real(0.5);
    let t186 = t185 + V_T2_noise2_2 * real(0.5) + V_D2_noise2_2 * real(0.5)
        + V_T2_noise3_2 * real(0.5) + V_D2_noise3_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t186 + real(0.5) + real(0.5) + real(0.5) + real(0.5) + real(0.5)
        + real(0.5);
    LyapunovOutputs { V, LV }
}
