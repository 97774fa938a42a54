// SHA-256 of the text below: ab8890fba03ded5e8dfdcc998e2cf123a9426e4a7fcb880bb25b2bc9386dd875
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 268 additions, 352 multiplications, 6 divisions, 0 square roots, 10 elementary functions, 70 comparisons and selections

//! `missile_pitch`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::{polynomials, tables};
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
/// Operations: 268 additions, 352 multiplications, 6 divisions, 0 square roots, 10 elementary
/// functions, 70 comparisons and selections.
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
    let alpha = x1[0];
    let q = x2[0];

    // -- known dynamics of block 1 (incidence) (11) --
    let t1 = real(0.06206968077555868) * params.CN_scale;
    let at_alpha_mach = tables::at_alpha_mach_2(alpha, real(3.0));
    let t2 = t1 * at_alpha_mach.CN;
    let t3 = alpha.cos();
    // F_1(x_1 .. x_1)
    let F1 = Vector([t2 * t3]);

    // -- known dynamics of block 2 (rate) (11) --
    let t4 = real(11.08751530287415) * params.CM_scale;
    // F_2(x_1 .. x_2)
    let F2 = Vector([t4 * at_alpha_mach.CM]);
    let t5 = real(11.08751530287415) * params.fin_scale * real(-0.206)
        * real(57.29577951308232);
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t5]]);

    // -- reference and constraints --
    let t6 = (t - real(0.2)) * real(2.0000000000000004);
    let t7 = t6.max(real(0.0)).min(real(1.0));
    let t8 = (t - real(1.5)) * real(1.6666666666666665);
    let t9 = t8.max(real(0.0)).min(real(1.0));
    let t10 = real(18.0) * (t9 * t9 * (real(3.0) - real(2.0) * t9));
    let t11 = real(12.0) * (t7 * t7 * (real(3.0) - real(2.0) * t7)) - t10;
    let t12 = (t - real(3.0)) * real(1.6666666666666665);
    let t13 = t12.max(real(0.0)).min(real(1.0));
    // y_r(t)
    let y_r = Vector([
        (t11 + real(14.0) * (t13 * t13 * (real(3.0) - real(2.0) * t13)))
            * real(0.017453292519943295),
    ]);
    let t14 = real(0.0).lt(t6);
    let t15 = T::select(t14, t6, real(0.0));
    let t16 = t15.lt(real(1.0));
    let t17 = T::select(t16, t15, real(1.0));
    let t18 = real(3.0) - real(2.0) * t17;
    let t19 = (t17 + t17) * real(2.0000000000000004);
    let t20 = T::select(
        t16,
        T::select(
            t14,
            real(12.0) * (t18 * t19 - t17 * t17 * real(4.000000000000001)),
            real(0.0),
        ),
        real(0.0),
    );
    let t21 = real(0.0).lt(t8);
    let t22 = T::select(t21, t8, real(0.0));
    let t23 = t22.lt(real(1.0));
    let t24 = T::select(t23, t22, real(1.0));
    let t25 = real(3.0) - real(2.0) * t24;
    let t26 = (t24 + t24) * real(1.6666666666666665);
    let t27 = T::select(
        t23,
        T::select(
            t21,
            -(real(18.0) * (t25 * t26 - t24 * t24 * real(3.333333333333333))),
            real(0.0),
        ),
        real(0.0),
    );
    let t28 = real(0.0).lt(t12);
    let t29 = T::select(t28, t12, real(0.0));
    let t30 = t29.lt(real(1.0));
    let t31 = T::select(t30, t29, real(1.0));
    let t32 = real(3.0) - real(2.0) * t31;
    let t33 = (t31 + t31) * real(1.6666666666666665);
    let t34 = T::select(
        t30,
        T::select(
            t28,
            real(14.0) * (t32 * t33 - t31 * t31 * real(3.333333333333333)),
            real(0.0),
        ),
        real(0.0),
    );
    // y_r'
    let y_r_dot = Vector([real(0.017453292519943295) * (t20 + t27 + t34)]);
    let t35 = (real(-3.0) * t).exp();
    // k_1(t)
    let k1 = (real(4.0) * t35 + real(2.0)) * real(0.017453292519943295);
    // k1'
    let k1_dot = real(0.017453292519943295) * (real(4.0) * (t35 * real(-3.0)));

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t36 = k1 * k1;
    let t37 = real(1.0) / t36;
    let t38 = s1 * t37;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t38 * t38);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t39 = cosE1 * cosE1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / t39;
    let t40 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t40;

    // -- disturbance observer of block 1 (20) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1 * real(10.0);

    // -- robust feedback of block 1 (31) --
    let t41 = E1.sin();
    let t42 = t41 * cosE1;
    let t43 = real(1.0) / E1_free;
    let t44 = t40 * real(0.5);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1
        * (real(10.0) * T::select(E1_free.lt(real(1e-300)), real(1.0), t42 * t43)
            + real(8.0) + t44 + t44);
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t45 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = F1 - y_r_dot + t45 + D_hat1 + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t45;

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
    let z2 = Vector([alpha, q]);
    // P_2 = P_m(z_2), 6 nodes
    let P2 = polynomials::basis2(z2);
    let t46 = state.W2.transpose();
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = t46 * P2;

    // -- disturbance observer of block 2 (20) --
    // D_hat_2 = th_2 + S_2 x_2
    let D_hat2 = state.th2 + x2 * real(30.0);

    // -- robust feedback of block 2 (63) --
    let t47 = s_c1 * s_c1;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam2 = e2 * (real(45.0) + s2 * real(0.5) + t47 * real(0.25));

    // -- control (64) of block 2 --
    let t48 = F2 + A_hat2;
    let t49 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t48 - h1_dot + t49 + D_hat2 + Lam2;
    let t50 = real(1.0) / t5;
    let t51 = bracket2 * t50;
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t51;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::splat(real(-0.4363323129985824)))
        .min(Vector::splat(real(0.4363323129985824)));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = G2 * (u_sat + t51) - t49;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- true dynamics of block 1 (incidence) (11) --
    let t52 = real(0.06206968077555868) * plant.CN_scale;
    let t53 = t52 * at_alpha_mach.CN;
    // F_1 with the plant's parameters
    let F1_plant = Vector([t53 * t3]);
    let t54 = real(3.0) * t;
    let t55 = real(5.0) * t;
    let t56 = Vector([t54, t55]);
    let [sin_t54, sin_t55] = t56.sin().0;
    // d_1(t)
    let d1 = Vector([real(0.02) * sin_t54]);
    // F_1 + G_1 x_2 + d_1
    let x1_flow = F1_plant + x2 + d1;

    // -- true dynamics of block 2 (rate) (11) --
    let t57 = real(11.08751530287415) * plant.CM_scale;
    // F_2 with the plant's parameters
    let F2_plant = Vector([t57 * at_alpha_mach.CM]);
    // G_2 with the plant's parameters
    let G2_plant = Matrix::rows([
        [
            real(11.08751530287415) * plant.fin_scale * real(-0.206)
                * real(57.29577951308232),
        ],
    ]);
    // d_2(t)
    let d2 = Vector([sin_t55]);
    // F_2 + G_2 x_3 + d_2
    let x2_flow = F2_plant + G2_plant * u_sat + d2;

    // -- Lyapunov function of block 1 (23) (52) --
    let t58 = t36 * t36 * real(0.15915494309189535);
    let t59 = E1.tan();
    // k_1^4/(2 pi) tan E_1
    let V_T1 = t58 * t59;
    // D_1 = d_1 + model error of block 1
    let D1 = d1 + (F1_plant - F1);
    // D_1 - D_hat_1
    let D_error1 = D1 - D_hat1;
    // 1/2 ||theta_1 - th_1||^2
    let V_D1 = D_error1.sum_squares() * real(0.5);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);
    // chi_1 = h_1 - alpha_1 (34)
    let chi1 = state.h1 + bracket1;
    // 1/2 ||chi_1||^2
    let V_chi1 = chi1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = s2 * s2 * real(0.25);
    let t60 = t46 * state.W2;
    // tr(W_2^T W_2)/(2 Gamma_2)
    let V_W2 = t60[(0, 0)] * real(0.5);
    let t61 = G2_plant - G2;
    // D_2 = d_2 + model error of block 2
    let D2 = d2 + (F2_plant - F2) + t61 * u_sat;
    // D_2 - D_hat_2
    let D_error2 = D2 - D_hat2;
    // 1/2 ||theta_2 - th_2||^2
    let V_D2 = D_error2.sum_squares() * real(0.5);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);

    // -- Lyapunov function (52) --
    // V, sum of the parts above
    let V = V_T1 + V_D1 + V_zeta1 + V_chi1 + V_T2 + V_W2 + V_D2 + V_zeta2;

    // -- Ito generator (2) --
    // e1' along the flow
    let e1_flow = x1_flow - y_r_dot - zeta1_dot;
    let t62 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t62 + t62;
    let t63 = (t38 + t38) * (s1_flow * t37 - t38 * t37 * ((k1 + k1) * k1_dot));
    // E1_free' along the flow
    let E1_free_flow = real(FRAC_PI_2) * t63;
    // E1' along the flow
    let E1_flow = T::select(
        E1_free.lt(real(1.5697963267948967)),
        E1_free_flow,
        real(0.0),
    );
    // V_T1' along the flow
    let V_T1_flow = t59 * (real(4.0) * (t36 * k1) * k1_dot * real(0.15915494309189535))
        + t58 * (E1_flow / t39);
    let [cos_t54, cos_t55] = t56.cos().0;
    // d1'
    let d1_dot = Vector([real(0.02) * (cos_t54 * real(3.0))]);
    let t64 = at_alpha_mach.CN_d1 * x1_flow[0];
    let t65 = alpha.sin() * x1_flow[0];
    // F1_plant' along the flow
    let F1_plant_flow = Vector([t3 * (t52 * t64) - t53 * t65]);
    // F1' along the flow
    let F1_flow = Vector([t3 * (t1 * t64) - t2 * t65]);
    // D1' along the flow
    let D1_flow = d1_dot + (F1_plant_flow - F1_flow);
    // D_hat1' along the flow
    let D_hat1_flow = x1_flow * real(10.0) - (D_hat1 + F1 + x2) * real(10.0);
    // D_error1' along the flow
    let D_error1_flow = D1_flow - D_hat1_flow;
    let t66 = D_error1_flow.dot(D_error1);
    // V_D1' along the flow
    let V_D1_flow = (t66 + t66) * real(0.5);
    let t67 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t67 + t67) * real(0.5);
    let t68 = t19 * real(4.000000000000001);
    let t69 = T::select(t16, T::select(t14, -t68, real(0.0)), real(0.0))
        + t18
            * T::select(
                t16,
                T::select(t14, real(8.000000000000004), real(0.0)),
                real(0.0),
            );
    let t70 = T::select(
        t16,
        T::select(
            t14,
            real(12.0)
                * (t69 - T::select(t16, T::select(t14, t68, real(0.0)), real(0.0))),
            real(0.0),
        ),
        real(0.0),
    );
    let t71 = t26 * real(3.333333333333333);
    let t72 = T::select(t23, T::select(t21, -t71, real(0.0)), real(0.0))
        + t25
            * T::select(
                t23,
                T::select(t21, real(5.5555555555555545), real(0.0)),
                real(0.0),
            );
    let t73 = T::select(
        t23,
        T::select(
            t21,
            -(real(18.0)
                * (t72 - T::select(t23, T::select(t21, t71, real(0.0)), real(0.0)))),
            real(0.0),
        ),
        real(0.0),
    );
    let t74 = t33 * real(3.333333333333333);
    let t75 = T::select(t30, T::select(t28, -t74, real(0.0)), real(0.0))
        + t32
            * T::select(
                t30,
                T::select(t28, real(5.5555555555555545), real(0.0)),
                real(0.0),
            );
    let t76 = T::select(
        t30,
        T::select(
            t28,
            real(14.0)
                * (t75 - T::select(t30, T::select(t28, t74, real(0.0)), real(0.0))),
            real(0.0),
        ),
        real(0.0),
    );
    // y_r''
    let y_r_dot2 = Vector([real(0.017453292519943295) * (t70 + t73 + t76)]);
    let t77 = real(1.5697963267948967) * t43;
    let t78 = real(1.0).lt(t77);
    let t79 = T::select(t78, real(1.0), t77);
    let t80 = T::select(E1.eq(real(0.0)), real(1.0), t42 / E1);
    let t81 = t79 * (kernel::sin_cos_over_d1(E1) * E1_flow)
        + T::select(t78, real(0.0), -(t80 * (t77 * t43 * E1_free_flow)));
    // Lam0_1' along the flow
    let Lam0_1_flow = Vector([
        real(10.0) * e1[0] * t81 + t80 * t79 * (real(10.0) * e1_flow[0])
            + real(8.0) * e1_flow[0],
    ]);
    // cosE1' along the flow
    let cosE1_flow = -(t41 * E1_flow);
    let t82 = e1
        * (s1_flow * sec2E1 - s1 * (sec2E1 * sec2E1 * ((cosE1 + cosE1) * cosE1_flow)));
    // c1' along the flow
    let c1_flow = t82 + e1_flow * t40;
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + c1_flow;
    // bracket1' along the flow
    let bracket1_flow = F1_flow - y_r_dot2 + zeta1_dot * real(20.0) + D_hat1_flow
        + Lam1_flow;
    // alpha1' along the flow
    let alpha1_flow = -bracket1_flow;
    // chi1' along the flow
    let chi1_flow = h1_dot + bracket1_flow;
    let t83 = chi1_flow.dot(chi1);
    // V_chi1' along the flow
    let V_chi1_flow = (t83 + t83) * real(0.5);
    // e2' along the flow
    let e2_flow = x2_flow - h1_dot - zeta2_dot;
    let t84 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t84 + t84;
    let t85 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t85 + t85) * real(0.25);
    let t86 = W2_dot.transpose();
    let t87 = t86 * state.W2 + t46 * W2_dot;
    // V_W2' along the flow
    let V_W2_flow = t87[(0, 0)] * real(0.5);
    // d2'
    let d2_dot = Vector([cos_t55 * real(5.0)]);
    let t88 = at_alpha_mach.CM_d1 * x1_flow[0];
    // F2_plant' along the flow
    let F2_plant_flow = Vector([t57 * t88]);
    // F2' along the flow
    let F2_flow = Vector([t4 * t88]);
    // z2' along the flow
    let z2_flow = Vector([x1_flow[0], x2_flow[0]]);
    // P2' along the flow
    let P2_flow = polynomials::basis2_rate(z2, z2_flow);
    // A_hat2' along the flow
    let A_hat2_flow = t86 * P2 + t46 * P2_flow;
    // h1_dot' along the flow
    let h1_dot_flow = (alpha1_flow - h1_dot) * real(50.0);
    // D_hat2' along the flow
    let D_hat2_flow = x2_flow * real(30.0) - (D_hat2 + t48 + G2 * u_sat) * real(30.0);
    // Lam0_2' along the flow
    let Lam0_2_flow = e2_flow * real(45.0);
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    // Lam2_disturbance' along the flow
    let Lam2_disturbance_flow = c2_flow * real(0.5);
    let t89 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t89 + t89;
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * ((s_c1 + s_c1) * s_c1_flow) + t47 * e2_flow[0]) * real(0.25),
    ]);
    // Lam2' along the flow
    let Lam2_flow = Lam0_2_flow + Lam2_disturbance_flow + Lam2_coupling_flow;
    // bracket2' along the flow
    let bracket2_flow = F2_flow + A_hat2_flow - h1_dot_flow + zeta2_dot * real(50.0)
        + D_hat2_flow + Lam2_flow;
    // u' along the flow
    let u_flow = -(bracket2_flow * t50);
    let t90 = real(-0.4363323129985824).lt(u[0]);
    // u_sat' along the flow
    let u_sat_flow = Vector([
        T::select(
            T::select(t90, u[0], real(-0.4363323129985824)).lt(real(0.4363323129985824)),
            T::select(t90, u_flow[0], real(0.0)),
            real(0.0),
        ),
    ]);
    // D2' along the flow
    let D2_flow = d2_dot + (F2_plant_flow - F2_flow) + t61 * u_sat_flow;
    // D_error2' along the flow
    let D_error2_flow = D2_flow - D_hat2_flow;
    let t91 = D_error2_flow.dot(D_error2);
    // V_D2' along the flow
    let V_D2_flow = (t91 + t91) * real(0.5);
    let t92 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t92 + t92) * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = V_T1_flow + V_D1_flow + V_zeta1_flow + V_chi1_flow + V_T2_flow + V_W2_flow
        + V_D2_flow + V_zeta2_flow;
    LyapunovOutputs { V, LV }
}
