// SHA-256 of the text below: 47ab9877fa38f50fc5b929e190c9fcf7b28e1ff5dae9f891ac0c73653b624631
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 05232bb1e4d2b87c7bb300548a857e3c96008a6f6467540428e4dc35d68eaef0
// lyapunov: 2530 additions, 3094 multiplications, 127 divisions, 3 square roots, 32 elementary functions, 32 comparisons and selections

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
/// Operations: 2530 additions, 3094 multiplications, 127 divisions, 3 square roots, 32
/// elementary functions, 32 comparisons and selections.
#[inline]
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
    let t2 = polynomials::CL_alpha(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::CL_LE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::CL_RE(alpha_deg, real(10.122243135087704), real(0.0));
    let lift = t1 * t2;
    let mu = x1[2];
    let beta = x1[1];
    let t3 = real(97170193.3485195) * params.CY_scale;
    let t4 = polynomials::CY_beta(alpha_deg, real(10.122243135087704), real(0.0));
    let t5 = t4 * beta
        + polynomials::CY_LE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::CY_RE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::CY_RUD(alpha_deg, real(10.122243135087704), real(0.0));
    let side = t3 * t5;
    let q = x2[1];
    let r = x2[2];
    let p = x2[0];
    let t6 = real(1777048495.9577248) * params.Cl_scale;
    let t7 = polynomials::Cl_beta(alpha_deg, real(10.122243135087704), real(0.0)) * beta
        + polynomials::Cl_LE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cl_RE(alpha_deg, real(10.122243135087704), real(0.0));
    let t8 = t7 + polynomials::Cl_RUD(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cl_p(alpha_deg, real(10.122243135087704), real(0.0)) * p
            * real(18.288) / real(6000.0);
    let t9 = t8
        + polynomials::Cl_r(alpha_deg, real(10.122243135087704), real(0.0)) * r
            * real(18.288) / real(6000.0);
    let roll = t6 * t9;
    let t10 = polynomials::Cm_alpha(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cm_LE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cm_RE(alpha_deg, real(10.122243135087704), real(0.0));
    let t11 = t10 + polynomials::Cm_RUD(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cm_q(alpha_deg, real(10.122243135087704), real(0.0)) * q
            * real(24.384) / real(6000.0);
    let pitch = real(2369397994.6102996) * params.Cm_scale * t11;
    let t12 = polynomials::CD_alpha(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::CD_LE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::CD_RE(alpha_deg, real(10.122243135087704), real(0.0));
    let t13 = t12 + polynomials::CD_RUD(alpha_deg, real(10.122243135087704), real(0.0));
    let drag = real(97170193.3485195) * params.CD_scale * t13;
    let t14 = polynomials::Cn_beta(alpha_deg, real(10.122243135087704), real(0.0)) * beta
        + polynomials::Cn_LE(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cn_RE(alpha_deg, real(10.122243135087704), real(0.0));
    let t15 = t14 + polynomials::Cn_RUD(alpha_deg, real(10.122243135087704), real(0.0))
        + polynomials::Cn_p(alpha_deg, real(10.122243135087704), real(0.0)) * p
            * real(18.288) / real(6000.0);
    let t16 = t15
        + polynomials::Cn_r(alpha_deg, real(10.122243135087704), real(0.0)) * r
            * real(18.288) / real(6000.0);
    let yaw = real(1777048495.9577248) * params.Cn_scale * t16;
    let dCl = Vector([
        polynomials::Cl_LE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::Cl_RE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::Cl_RUD_d3(alpha_deg, real(10.122243135087704), real(0.0)),
    ]);
    let roll_delta = dCl * t6;
    let dCm = Vector([
        polynomials::Cm_LE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::Cm_RE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::Cm_RUD_d3(alpha_deg, real(10.122243135087704), real(0.0)),
    ]);
    let dCD = Vector([
        polynomials::CD_LE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::CD_RE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::CD_RUD_d3(alpha_deg, real(10.122243135087704), real(0.0)),
    ]);
    let dCL = Vector([
        polynomials::CL_LE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::CL_RE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        real(0.0),
    ]);
    let t17 = alpha.sin();
    let t18 = alpha.cos();
    let t19 = (dCD * params.CD_scale * t17 + dCL * params.CL_scale * t18) * real(0.0);
    let pitch_delta = (dCm * (real(24.384) * params.Cm_scale) + t19)
        * real(97170193.3485195);
    let dCn = Vector([
        polynomials::Cn_LE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::Cn_RE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::Cn_RUD_d3(alpha_deg, real(10.122243135087704), real(0.0)),
    ]);
    let dCY = Vector([
        polynomials::CY_LE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::CY_RE_d3(alpha_deg, real(10.122243135087704), real(0.0)),
        polynomials::CY_RUD_d3(alpha_deg, real(10.122243135087704), real(0.0)),
    ]);
    let yaw_delta = (dCn * (real(18.288) * params.Cn_scale)
        + dCY * (real(0.0) * params.CY_scale)) * real(97170193.3485195);

    // -- known dynamics of block 1 (attitude) (11) --
    let t20 = real(0.0) * t17;
    let t21 = mu.cos();
    let t22 = real(1332506.5352200002) * t21;
    let t23 = beta.cos();
    let t24 = real(410460000.0) * t23;
    let t25 = real(0.0) * t18;
    let t26 = beta.sin();
    let t27 = t25 * t26;
    let t28 = mu.sin();
    let t29 = real(1332506.5352200002) * t28;
    let t30 = beta.tan();
    let t31 = t30 + real(0.0) * t28;
    let t32 = side * real(0.0);
    let t33 = t22 * t30;
    let t34 = t18 * t26 * real(0.0);
    let t35 = real(0.0) * (t17 * t31 - t34 * t21);
    // F_1(x_1 .. x_1)
    let F1 = Vector([
        (-lift - t20 + t22) / t24,
        (side - t27 + t29) / real(410460000.0),
        (lift * t31 + t32 * t21 - t33 + t35) / real(410460000.0),
    ]);
    let t36 = -t30;
    let t37 = t36 * t18;
    let t38 = t36 * t17;
    let t39 = -t18;
    let t40 = t18 / t23;
    let t41 = t17 / t23;
    // G_1(x_1 .. x_1)
    let G1 = Matrix([
        [t37, real(1.0), t38],
        [t17, real(0.0), t39],
        [t40, real(0.0), t41],
    ]);

    // -- known dynamics of block 2 (rates) (11) --
    let t42 = real(0.0) * q * r;
    let t43 = real(12202362.0) * p * r;
    let t44 = real(-12202362.0) * p * q;
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        (t42 + roll) / real(1355818.0),
        (t43 + pitch + real(0.0) * (drag * t17 + lift * t18)) / real(13558180.0),
        (t44 + yaw + t32) / real(13558180.0),
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
    let t45 = t.le(real(4.0));
    let t46 = real(FRAC_PI_4) * t - real(FRAC_PI_2);
    let t47 = t46.sin();
    let t48 = real(0.9424777960769379) * t;
    let t49 = t48.sin();
    let t50 = t.sin();
    let t51 = real(0.5) * t;
    let t52 = real(0.5) * t51.cos();
    // y_r(t)
    let y_r = Vector([
        T::select(
            t45,
            (real(2.5) * t47 + real(1.5)) * real(0.017453292519943295),
            real(0.06981317007977318),
        ),
        real(0.5) * t49 * real(0.017453292519943295),
        (real(-2.0) * t50 + t52) * real(0.017453292519943295),
    ]);
    let t53 = t46.cos();
    let t54 = t48.cos();
    let t55 = t.cos();
    let t56 = t51.sin();
    // y_r'
    let y_r_dot = Vector([
        T::select(
            t45,
            real(0.017453292519943295) * (real(2.5) * (t53 * real(FRAC_PI_4))),
            real(0.0),
        ),
        real(0.017453292519943295) * (real(0.5) * (t54 * real(0.9424777960769379))),
        real(0.017453292519943295) * (real(-2.0) * t55 - real(0.5) * (t56 * real(0.5))),
    ]);
    let t57 = real(3.0) * (-t).exp();
    // k_2(t)
    let k2 = t57 + real(0.5);
    // k_1(t)
    let k1 = k2 * real(0.017453292519943295);
    // k1'
    let k1_dot = -(real(0.017453292519943295) * t57);
    // k2'
    let k2_dot = -t57;

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t58 = k1 * k1;
    let t59 = s1 / t58;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t59 * t59);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t60 = cosE1 * cosE1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * s1 / t60;

    // -- MTPN of block 1 (4) (16) --
    // P_1 = P_m(z_1), 19 nodes
    let P1 = polynomials::basis1(x1);
    let t61 = state.W1.transpose();
    // A_hat_1 = iota_1 W_1^T P_1
    let A_hat1 = t61 * P1 * real(0.1);

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1 * real(10.0);

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) (63) --
    let t62 = kernel::sin_cos_over(E1);
    let t63 = real(1.5697963267948967) / E1_free;
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1 * real(2.375) * (t62 * real(1.0).min(t63)) + e1 * real(2.0);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    let t64 = real(0.5) * G_norm2_1;
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * t64;
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t65 = F1 + A_hat1;
    let t66 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t65 - y_r_dot + t66 + D_hat1 + Lam1;
    let t67 = G1.solve(bracket1);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t67;

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = G1 * state.zeta2 - t66;

    // -- weight law of block 1 (32) (65) --
    let t68: Vector<T, 3> = Vector::from_f64([0.1, 0.1, 0.1]);
    // W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)
    let W1_dot = P1.outer(t68.hadamard(c1)) - state.W1 * real(0.1);

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) / real(0.1);

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    let t69 = k2 * k2;
    let t70 = s2 / t69;
    // pi s_2^2 / (2 k_2^4), before the clamp
    let E2_free = real(FRAC_PI_2) * (t70 * t70);
    // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
    let E2 = E2_free.min(real(1.5697963267948967));
    // cos E_2
    let cosE2 = E2.cos();
    let t71 = cosE2 * cosE2;
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2 / t71;

    // -- MTPN of block 2 (4) (16) --
    // P_2 = P_m(z_2), 19 nodes
    let P2 = polynomials::basis2(x2);
    let t72 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t72 * P2 * real(0.1);

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
    let t73 = E2.sin();
    let t74 = real(3.0) / t71;
    let t75 = real(8.0) * E2_free * t73 / (t71 * cosE2) + t74;
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = (t75 * t75 + real(2.0) * (t74 * t74)).sqrt();
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t76 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t76 * t76 * real(0.5) + real(12.0)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(2.5)
        * (kernel::sin_cos_over(E2) * real(1.0).min(real(1.5697963267948967) / E2_free))
        + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(75.0);
    let t77 = e2 * real(0.5);
    // e / (2 cos^2 E) (63)
    let Lam2_network = t77 / t71;
    let t78 = t77.map(T::tanh);
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t78 * state.eps2;
    let t79 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t79 * t79) * real(0.25) * t71;
    let t80 = s2 * s2;
    let t81 = (t80 + real(1.0)).sqrt();
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t76 * state.sigma2) / t81;
    let t82 = state.phi2 * state.phi2;
    let t83 = Psi2 / (t82 + t80);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t83 * t71;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t84 = F2 + A_hat2;
    let t85 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t84 - h1_dot + t85 + D_hat2 + Lam2;
    let t86 = G2.solve(bracket2);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t86;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .zip(Vector::<T, 3>::from_f64([-2000000.0, -20000000.0, -20000000.0]), T::max)
        .zip(Vector::<T, 3>::from_f64([2000000.0, 20000000.0, 20000000.0]), T::min);

    // -- auxiliary system of block 2 (13) (E1) --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = G2 * (u_sat + t86) - t85;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(t68.hadamard(c2)) - state.W2 * real(0.1);

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
    let th2_dot = w2_closed * w_hat2 - S2 * (t84 + G2 * u - h1_dot + t85);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 / t71 * e2.dot(t78) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t76 * t80 / t71 / t81 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t83 + real(2.0);
    // phi_2' = -phi_2 Psi_2/(phi_2^2 + s_2^2) - kappa_phi phi_2 if ||e_2|| >= iota_phi, else 0
    let phi2_dot = T::select(
        s2.sqrt().ge(real(0.01)),
        -state.phi2 * phi2_decay,
        real(0.0),
    );

    // -- true dynamics of block 1 (attitude) (11) --
    let t87 = real(97170193.3485195) * plant.CL_scale;
    let t88 = t87 * t2;
    let t89 = real(97170193.3485195) * plant.CY_scale;
    let t90 = t89 * t5;
    let t91 = t90 * real(0.0);
    // F_1 with the plant's parameters
    let F1_plant = Vector([
        (-t88 - t20 + t22) / t24,
        (t90 - t27 + t29) / real(410460000.0),
        (t88 * t31 + t91 * t21 - t33 + t35) / real(410460000.0),
    ]);
    let t92 = real(2.0) * t;
    let t93 = real(0.02) * t92.sin();
    let t94 = (real(-0.1) * t).exp();
    let t95 = t93 * t94;
    let t96 = real(0.02) * t50;
    // d_1(t)
    let d1 = Vector([t95, t96 * t94, t95]);
    let t97 = G1 * x2;
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + t97 + d1;

    // -- true dynamics of block 2 (rates) (11) --
    let t98 = real(1777048495.9577248) * plant.Cl_scale;
    let t99 = real(0.0)
        * (real(97170193.3485195) * plant.CD_scale * t13 * t17 + t88 * t18);
    // F_2 with the plant's parameters
    let F2_plant = Vector([
        (t42 + t98 * t9) / real(1355818.0),
        (t43 + real(2369397994.6102996) * plant.Cm_scale * t11 + t99) / real(13558180.0),
        (t44 + real(1777048495.9577248) * plant.Cn_scale * t16 + t91) / real(13558180.0),
    ]);
    // G_2 with the plant's parameters
    let G2_plant: Matrix<T, 3, 3> = Matrix::from_f64([
        [7.375621211696555e-7, 0.0, 0.0],
        [0.0, 7.375621211696555e-8, 0.0],
        [0.0, 0.0, 7.375621211696555e-8],
    ]);
    // d_2 = L_2 w_2 (12)
    let d2 = L2 * w2;
    let t100: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.0, 3.0, 0.0, 0.0, 0.0, 0.0],
        [-3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 3.0, 0.0, 0.0],
        [0.0, 0.0, -3.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 3.0],
        [0.0, 0.0, 0.0, 0.0, -3.0, 0.0],
    ]);
    // w_2' = M_2 w_2 (12)
    let w2_flow = t100 * w2;
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;
    let t101 = dCl * t98;
    let t102 = (dCD * plant.CD_scale * t17 + dCL * plant.CL_scale * t18) * real(0.0);
    let t103 = (dCm * (real(24.384) * plant.Cm_scale) + t102) * real(97170193.3485195);
    let t104 = (dCn * (real(18.288) * plant.Cn_scale)
        + dCY * (real(0.0) * plant.CY_scale)) * real(97170193.3485195);
    let t105 = Matrix([
        [
            t101[0] / real(1355818.0),
            t101[1] / real(1355818.0),
            t101[2] / real(1355818.0),
        ],
        [
            t103[0] / real(13558180.0),
            t103[1] / real(13558180.0),
            t103[2] / real(13558180.0),
        ],
        [
            t104[0] / real(13558180.0),
            t104[1] / real(13558180.0),
            t104[2] / real(13558180.0),
        ],
    ]);
    // H_2 Sigma_2
    let HSigma2 = t105
        .hadamard(
            Matrix::<
                T,
                3,
                3,
            >::from_f64([[0.05, 0.05, 0.05], [0.05, 0.05, 0.05], [0.05, 0.05, 0.05]]),
        );

    // -- Lyapunov function of block 1 (23) (52) --
    let t106 = t58 * t58 / real(TAU);
    let t107 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t106 * t107;
    let t108 = t61 * state.W1;
    // tr(W_1^T W_1)/(2 Gamma_1)
    let V_W1 = (t108[(0, 0)] + t108[(1, 1)] + t108[(2, 2)]) * real(0.5);
    // D_1 = d_1 + model error of block 1
    let D1 = d1 + (F1_plant - F1);
    // D_1 - D_hat_1
    let D_error1 = D1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + t67;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    let t109 = t69 * t69 / real(TAU);
    let t110 = E2.tan();
    // k_2^4/(2 pi) tan E_2
    let V_T2 = t109 * t110;
    let t111 = t72 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = (t111[(0, 0)] + t111[(1, 1)] + t111[(2, 2)]) * real(0.5);
    // w_2 - w_hat_2
    let w_error2 = w2 - w_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = w_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);
    // eps_hat_2^2/(2 iota_20)
    let V_eps2 = state.eps2 * state.eps2 / real(0.2);
    let t112 = real(0.0075000000000000015) - state.sigma2;
    // (sigma_bar_2 - sigma_hat_2)^2/(2 taubar_2)
    let V_sigma2 = t112 * t112 * real(0.5);
    // phi_2^2/2
    let V_phi2 = t82 * real(0.5);

    // -- Lyapunov function (52) --
    let t113 = V_T1 + V_W1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;
    // V, sum of the parts above
    let V = t113 + V_eps2 + V_sigma2 + V_phi2;

    // -- Ito generator (2) --
    // column 1 of HSigma2
    let HSigma2_1 = Vector([HSigma2[(0, 0)], HSigma2[(1, 0)], HSigma2[(2, 0)]]);
    // column 2 of HSigma2
    let HSigma2_2 = Vector([HSigma2[(0, 1)], HSigma2[(1, 1)], HSigma2[(2, 1)]]);
    // column 3 of HSigma2
    let HSigma2_3 = Vector([HSigma2[(0, 2)], HSigma2[(1, 2)], HSigma2[(2, 2)]]);
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t114 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t114 + t114;
    let t115 = (t59 + t59) * (s1_flow / t58 - t59 / t58 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t115;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t107 * (real(4.0) * (t58 * k1) * k1_dot / real(TAU))
        + t106 * (E1_flow / t60);
    let t116 = W1_dot.transpose();
    let t117 = t116 * state.W1 + t61 * W1_dot;
    // V_W1' along the flow
    let V_W1_flow = (t117[(0, 0)] + t117[(1, 1)] + t117[(2, 2)]) * real(0.5);
    let t118 = t94 * real(-0.1);
    let t119 = t94 * (real(0.02) * (t92.cos() * real(2.0))) + t93 * t118;
    // d1'
    let d1_dot = Vector([t119, t94 * (real(0.02) * t55) + t96 * t118, t119]);
    let t120 = t26 * x1_flow[1];
    let t121 = real(410460000.0) * t120;
    let t122 = (t22 - (t88 + t20)) / t24 / t24 * t121;
    let t123 = t28 * x1_flow[2];
    let t124 = real(1332506.5352200002) * t123;
    let t125 = x1_flow[0] / real(0.017453292519943295);
    let t126 = polynomials::CL_alpha_d1(alpha_deg, real(10.122243135087704), real(0.0))
        * t125
        + polynomials::CL_LE_d1(alpha_deg, real(10.122243135087704), real(0.0)) * t125;
    let t127 = t126
        + polynomials::CL_RE_d1(alpha_deg, real(10.122243135087704), real(0.0)) * t125;
    let t128 = t87 * t127;
    let t129 = t18 * x1_flow[0];
    let t130 = real(0.0) * t129;
    let t131 = beta
        * (polynomials::CY_beta_d1(alpha_deg, real(10.122243135087704), real(0.0))
            * t125) + t4 * x1_flow[1];
    let t132 = t131
        + polynomials::CY_LE_d1(alpha_deg, real(10.122243135087704), real(0.0)) * t125
        + polynomials::CY_RE_d1(alpha_deg, real(10.122243135087704), real(0.0)) * t125;
    let t133 = t132
        + polynomials::CY_RUD_d1(alpha_deg, real(10.122243135087704), real(0.0)) * t125;
    let t134 = t89 * t133;
    let t135 = t23 * x1_flow[1];
    let t136 = t17 * x1_flow[0];
    let t137 = t25 * t135 - t26 * (real(0.0) * t136);
    let t138 = t21 * x1_flow[2];
    let t139 = real(1332506.5352200002) * t138;
    let t140 = x1_flow[1] / (t23 * t23);
    let t141 = t140 + real(0.0) * t138;
    let t142 = t31 * t128 + t88 * t141 + (t21 * (real(0.0) * t134) - t91 * t123);
    let t143 = t22 * t140 - t30 * t124;
    let t144 = t21 * (real(0.0) * (t18 * t135 - t26 * t136)) - t34 * t123;
    let t145 = real(0.0) * (t31 * t129 + t17 * t141 - t144);
    // F1_plant' along the flow
    let F1_plant_flow = Vector([
        t122 - (t124 + (t128 + t130)) / t24,
        (t134 - t137 + t139) / real(410460000.0),
        (t142 - t143 + t145) / real(410460000.0),
    ]);
    let t146 = (t22 - (lift + t20)) / t24 / t24 * t121;
    let t147 = t1 * t127;
    let t148 = t3 * t133;
    let t149 = t31 * t147 + lift * t141 + (t21 * (real(0.0) * t148) - t32 * t123);
    // F1' along the flow
    let F1_flow = Vector([
        t146 - (t124 + (t147 + t130)) / t24,
        (t148 - t137 + t139) / real(410460000.0),
        (t149 - t143 + t145) / real(410460000.0),
    ]);
    // D1' along the flow
    let D1_flow = d1_dot + (F1_plant_flow - F1_flow);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow * real(10.0) - (D_hat1 + t65 + t97) * real(10.0);
    // D_error1' along the flow
    let D_error1_flow = D1_flow - D_hat1_flow;
    let t150 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t150 + t150) * real(0.5);
    let t151 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t151 + t151) * real(0.5);
    let t152 = -(t18 * t140 - t30 * t136);
    let t153 = -(t17 * t140 + t30 * t129);
    let t154 = t40 / t23 * t120 - t136 / t23;
    let t155 = t129 / t23 + t41 / t23 * t120;
    // G1' along the flow
    let G1_flow = Matrix([
        [t152, real(0.0), t153],
        [t129, real(0.0), t136],
        [t154, real(0.0), t155],
    ]);
    // P1' along the flow
    let P1_flow = polynomials::basis1_rate(x1, x1_flow);
    // A_hat1' along the flow
    let A_hat1_flow = (t116 * P1 + t61 * P1_flow) * real(0.1);
    let t156 = real(-2.0) * (t55 * real(0.0) - t50)
        - real(0.5) * (real(0.5) * t52 + t56 * real(0.0));
    // y_r''
    let y_r_dot2 = Vector([
        T::select(
            t45,
            real(0.017453292519943295)
                * (real(2.5)
                    * (t53 * real(0.0) - real(FRAC_PI_4) * (t47 * real(FRAC_PI_4)))),
            real(0.0),
        ),
        real(0.017453292519943295)
            * (real(0.5)
                * (t54 * real(0.0)
                    - real(0.9424777960769379) * (t49 * real(0.9424777960769379)))),
        real(0.017453292519943295) * t156,
    ]);
    let t157 = real(1.0).lt(t63);
    let t158 = T::select(t157, real(1.0), t63);
    let t159 = t158 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t157, real(0.0), -(t62 * (t63 / E1_free * E1_free_flow)));
    let t160 = t62 * t158;
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(2.375) * e1[0] * t159 + t160 * (real(2.375) * e1_flow[0])
            + real(2.0) * e1_flow[0],
        real(2.375) * e1[1] * t159 + t160 * (real(2.375) * e1_flow[1])
            + real(2.0) * e1_flow[1],
        real(2.375) * e1[2] * t159 + t160 * (real(2.375) * e1_flow[2])
            + real(2.0) * e1_flow[2],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(E1.sin() * E1_flow);
    let t161 = (cosE1 + cosE1) * cosE1_flow;
    let t162 = s1 * e1[0] / t60 / t60 * t161;
    let t163 = s1 * e1[1] / t60 / t60 * t161;
    let t164 = s1 * e1[2] / t60 / t60 * t161;
    // c1' along the flow
    let c1_flow = Vector([
        (e1[0] * s1_flow + s1 * e1_flow[0]) / t60 - t162,
        (e1[1] * s1_flow + s1 * e1_flow[1]) / t60 - t163,
        (e1[2] * s1_flow + s1 * e1_flow[2]) / t60 - t164,
    ]);
    // Lam1_disturbance' along the flow
    let Lam1_disturbance_flow = c1_flow * real(0.5);
    let t165 = (t37 + t37) * t152 + real(0.0) + (t38 + t38) * t153;
    let t166 = t165 + (t17 + t17) * t129 + real(0.0) + (t39 - t18) * t136;
    // G_norm2_1' along the flow
    let G_norm2_1_flow = t166 + (t40 + t40) * t154 + real(0.0) + (t41 + t41) * t155;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1 * (real(0.5) * G_norm2_1_flow) + c1_flow * t64;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_disturbance_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = F1_flow + A_hat1_flow - y_r_dot2 + zeta1_dot * real(20.0)
        + D_hat1_flow + Lam1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + G1.solve(bracket1_flow - G1_flow * t67);
    let t167 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t167 + t167) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t168 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t168 + t168;
    let t169 = t70 + t70;
    // E2_free' along the flow
    let E2_free_flow = real(FRAC_PI_2)
        * (t169 * (s2_flow / t69 - t70 / t69 * ((k2 + k2) * k2_dot)));
    let t170 = E2_free.lt(real(1.5697963267948967));
    // E2' along the flow
    let E2_flow = T::select(t170, E2_free_flow, real(0.0));
    // V_T2' along the flow
    let V_T2_flow = t110 * (real(4.0) * (t69 * k2) * k2_dot / real(TAU))
        + t109 * (E2_flow / t71);
    let t171 = W2_dot.transpose() * state.W2 + t72 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = (t171[(0, 0)] + t171[(1, 1)] + t171[(2, 2)]) * real(0.5);
    // w_hat2' along the flow
    let w_hat2_flow = th2_dot + S2 * e2_flow;
    // w_error2' along the flow
    let w_error2_flow = w2_flow - w_hat2_flow;
    let t172 = w_error2_flow.dot(w_error2);
    // V_D2' along the flow
    let V_D2_flow = (t172 + t172) * real(0.5);
    let t173 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t173 + t173) * real(0.5);
    let t174 = eps2_dot * state.eps2;
    // V_eps2' along the flow
    let V_eps2_flow = (t174 + t174) / real(0.2);
    let t175 = -sigma2_dot * t112;
    // V_sigma2' along the flow
    let V_sigma2_flow = (t175 + t175) * real(0.5);
    let t176 = phi2_dot * state.phi2;
    // V_phi2' along the flow
    let V_phi2_flow = (t176 + t176) * real(0.5);
    let t177 = HSigma2_1.dot(e2);
    // D^1 s2 along noise1
    let s2_noise1_ = t177 + t177;
    let t178 = s2_noise1_ / t69;
    // D^1 E2_free along noise1
    let E2_free_noise1_ = real(FRAC_PI_2) * (t169 * t178);
    // D^1 E2 along noise1
    let E2_noise1_ = T::select(t170, E2_free_noise1_, real(0.0));
    let t179 = HSigma2_1.sum_squares();
    // D^2 s2 along noise1
    let s2_noise1_2 = t179 + t179;
    // D^2 E2_free along noise1
    let E2_free_noise1_2 = real(FRAC_PI_2)
        * (t178 * (t178 + t178) + t169 * (s2_noise1_2 / t69));
    // D^2 E2 along noise1
    let E2_noise1_2 = T::select(t170, E2_free_noise1_2, real(0.0));
    let t180 = cosE2 + cosE2;
    // D^2 V_T2 along noise1
    let V_T2_noise1_2 = t109
        * (E2_noise1_2 / t71 + E2_noise1_ / t71 / t71 * (t180 * (t73 * E2_noise1_)));
    // D^1 w_hat2 along noise1
    let w_hat2_noise1_ = S2 * HSigma2_1;
    let t181 = w_hat2_noise1_.sum_squares();
    // D^2 V_D2 along noise1
    let V_D2_noise1_2 = (t181 + t181) * real(0.5);
    let t182 = HSigma2_2.dot(e2);
    // D^1 s2 along noise2
    let s2_noise2_ = t182 + t182;
    let t183 = s2_noise2_ / t69;
    // D^1 E2_free along noise2
    let E2_free_noise2_ = real(FRAC_PI_2) * (t169 * t183);
    // D^1 E2 along noise2
    let E2_noise2_ = T::select(t170, E2_free_noise2_, real(0.0));
    let t184 = HSigma2_2.sum_squares();
    // D^2 s2 along noise2
    let s2_noise2_2 = t184 + t184;
    // D^2 E2_free along noise2
    let E2_free_noise2_2 = real(FRAC_PI_2)
        * (t183 * (t183 + t183) + t169 * (s2_noise2_2 / t69));
    // D^2 E2 along noise2
    let E2_noise2_2 = T::select(t170, E2_free_noise2_2, real(0.0));
    // D^2 V_T2 along noise2
    let V_T2_noise2_2 = t109
        * (E2_noise2_2 / t71 + E2_noise2_ / t71 / t71 * (t180 * (t73 * E2_noise2_)));
    // D^1 w_hat2 along noise2
    let w_hat2_noise2_ = S2 * HSigma2_2;
    let t185 = w_hat2_noise2_.sum_squares();
    // D^2 V_D2 along noise2
    let V_D2_noise2_2 = (t185 + t185) * real(0.5);
    let t186 = HSigma2_3.dot(e2);
    // D^1 s2 along noise3
    let s2_noise3_ = t186 + t186;
    let t187 = s2_noise3_ / t69;
    // D^1 E2_free along noise3
    let E2_free_noise3_ = real(FRAC_PI_2) * (t169 * t187);
    // D^1 E2 along noise3
    let E2_noise3_ = T::select(t170, E2_free_noise3_, real(0.0));
    let t188 = HSigma2_3.sum_squares();
    // D^2 s2 along noise3
    let s2_noise3_2 = t188 + t188;
    // D^2 E2_free along noise3
    let E2_free_noise3_2 = real(FRAC_PI_2)
        * (t187 * (t187 + t187) + t169 * (s2_noise3_2 / t69));
    // D^2 E2 along noise3
    let E2_noise3_2 = T::select(t170, E2_free_noise3_2, real(0.0));
    // D^2 V_T2 along noise3
    let V_T2_noise3_2 = t109
        * (E2_noise3_2 / t71 + E2_noise3_ / t71 / t71 * (t180 * (t73 * E2_noise3_)));
    // D^1 w_hat2 along noise3
    let w_hat2_noise3_ = S2 * HSigma2_3;
    let t189 = w_hat2_noise3_.sum_squares();
    // D^2 V_D2 along noise3
    let V_D2_noise3_2 = (t189 + t189) * real(0.5);
    let t190 = V_T1_flow + V_W1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow
        + V_W2_flow + V_D2_flow + V_zeta2_flow;
    let t191 = t190 + V_eps2_flow + V_sigma2_flow + V_phi2_flow
        + V_T2_noise1_2 * real(0.5) + V_D2_noise1_2 * real(0.5);
    let t192 = t191 + V_T2_noise2_2 * real(0.5) + V_D2_noise2_2 * real(0.5)
        + V_T2_noise3_2 * real(0.5) + V_D2_noise3_2 * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = t192 + real(0.5) + real(0.5) + real(0.5) + real(0.5) + real(0.5)
        + real(0.5);
    LyapunovOutputs { V, LV }
}
