// SHA-256 of the text below: 928da083069baf620eaf20a1cf2f5796785f3aa759bca4680f4324db8b5566f4
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// lyapunov: 190 additions, 212 multiplications, 0 divisions, 0 square roots, 3 elementary functions, 2 comparisons and selections

//! `chaotic_jerk`: Lyapunov function and its generator.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::controller::State;
use super::params::Params;
use super::polynomials;
use nsv_runtime::linear::Vector;
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
/// Operations: 190 additions, 212 multiplications, 0 divisions, 0 square roots, 3 elementary
/// functions, 2 comparisons and selections.
#[inline(always)]
pub fn lyapunov<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    state: &State<T>,
    params: &Params<T>,
    plant: &Params<T>,
) -> LyapunovOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let x = x1[0];
    let v = x2[0];
    let w = x3[0];

    // -- known dynamics of block 3 (acceleration) (11) --
    let t1 = x * x;
    // F_3(x_1 .. x_3)
    let F3 = Vector([-params.c * x - params.b * v - params.a * w + t1]);

    // -- reference and constraints --
    let t2 = t.sin();
    let t3 = real(2.0) * t2;
    let t4 = t * t;
    let t5 = (real(-0.1) * (t4 * t)).exp();
    let t6 = real(1.0) - t5;
    // y_r(t)
    let y_r = Vector([t3 * t6]);
    let t7 = t.cos();
    let t8 = real(2.0) * t7;
    let t9 = real(-0.1) * (real(3.0) * t4);
    let t10 = t5 * t9;
    // y_r'
    let y_r_dot = Vector([t6 * t8 - t3 * t10]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * s1;

    // -- robust feedback of block 1 (31) --
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (real(3.0) + s1 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t11 = state.zeta1 * real(10.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t11 - y_r_dot + Lam1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t11;

    // -- exact derivative of the virtual control of block 1 (34) --
    let t12 = real(2.0) * -t2;
    let t13 = t8 * t10;
    let t14 = real(-0.1) * (real(3.0) * (t + t));
    let t15 = t9 * t10 + t5 * t14;
    // y_r''
    let y_r_dot2 = Vector([t6 * t12 - t13 - (t13 + t3 * t15)]);
    // e1'
    let e1_dot = x2 - y_r_dot - zeta1_dot;
    // Lam0_1'
    let Lam0_1_dot = e1_dot * real(3.0);
    let t16 = e1_dot.dot(e1);
    // s1'
    let s1_dot = t16 + t16;
    // c1'
    let c1_dot = e1 * s1_dot + e1_dot * s1;
    // Lam1_filter'
    let Lam1_filter_dot = c1_dot * real(0.5);
    // Lam1'
    let Lam1_dot = Lam0_1_dot + Lam1_filter_dot;
    let t17 = zeta1_dot * real(10.0);
    let t18 = t17 - y_r_dot2;
    // bracket1'
    let bracket1_dot = t18 + Lam1_dot;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + bracket1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2;

    // -- robust feedback of block 2 (31) --
    let t19 = s_c1 * s_c1;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G,
    // c, eta_3 of the outer block (38)
    let Lam2 = e2 * (real(3.0) + s2 * real(0.5) + t19 * real(0.25));
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t20 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = bracket1_dot + t20 + Lam2;

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = state.zeta3 - t20;

    // -- exact derivative of the virtual control of block 2 (34) --
    let t21 = t12 * t10;
    let t22 = t8 * t15;
    let t23 = t21 + t22;
    let t24 = t10 * t14;
    let t25 = t23
        + (t22 + t3 * (t24 + t9 * t15 + (t24 + t5 * real(-0.6000000000000001))));
    // y_r'''
    let y_r_dot3 = Vector([t6 * (real(2.0) * -t7) - t21 - t23 - t25]);
    // zeta1_dot'
    let zeta1_dot_dot = zeta2_dot - t17;
    // e1''
    let e1_dot2 = x3 - y_r_dot2 - zeta1_dot_dot;
    // Lam0_1''
    let Lam0_1_dot2 = e1_dot2 * real(3.0);
    let t26 = e1_dot2.dot(e1) + e1_dot.sum_squares();
    // s1''
    let s1_dot2 = t26 + t26;
    // c1''
    let c1_dot2 = e1 * s1_dot2 + e1_dot * (s1_dot + s1_dot) + e1_dot2 * s1;
    // Lam1_filter''
    let Lam1_filter_dot2 = c1_dot2 * real(0.5);
    // Lam1''
    let Lam1_dot2 = Lam0_1_dot2 + Lam1_filter_dot2;
    let t27 = zeta1_dot_dot * real(10.0) - y_r_dot3;
    // bracket1''
    let bracket1_dot2 = t27 + Lam1_dot2;
    // e2'
    let e2_dot = x3 + bracket1_dot - zeta2_dot;
    // Lam0_2'
    let Lam0_2_dot = e2_dot * real(3.0);
    let t28 = e2_dot.dot(e2);
    // s2'
    let s2_dot = t28 + t28;
    // c2'
    let c2_dot = e2 * s2_dot + e2_dot * s2;
    // Lam2_filter'
    let Lam2_filter_dot = c2_dot * real(0.5);
    let t29 = c1_dot.dot(c1);
    // s_c1'
    let s_c1_dot = t29 + t29;
    let t30 = s_c1 + s_c1;
    // Lam2_coupling'
    let Lam2_coupling_dot = Vector([
        (e2[0] * (t30 * s_c1_dot) + t19 * e2_dot[0]) * real(0.25),
    ]);
    // Lam2'
    let Lam2_dot = Lam0_2_dot + Lam2_filter_dot + Lam2_coupling_dot;
    let t31 = zeta2_dot * real(10.0);
    // bracket2'
    let bracket2_dot = bracket1_dot2 + t31 + Lam2_dot;

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 + bracket2 - state.zeta3;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();
    // c_3 = s_3 e_3^T / cos^2 E_3
    let c3 = e3 * s3;

    // -- MTPN of block 3 (4) (16) --
    // z_3, network inputs
    let z3 = Vector([x, v, w]);
    // P_3 = P_m(z_3), 10 nodes
    let P3 = polynomials::basis3(z3);
    let t32 = state.W3.transpose();
    // A_hat_3 = iota_3 W_3^T P_3
    let A_hat3 = t32 * P3;

    // -- disturbance observer of block 3 (20) --
    // D_hat_3 = th_3 + S_3 x_3
    let D_hat3 = state.th3 + x3 * real(10.0);

    // -- robust feedback of block 3 (63) --
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam3 = e3 * (real(3.0) + s3 * real(0.5) + s_c2 * s_c2 * real(0.25));

    // -- control (64) of block 3 --
    let t33 = F3 + A_hat3;
    let t34 = state.zeta3 * real(20.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = t33 + bracket2_dot + t34 + D_hat3 + Lam3;
    // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let u = -bracket3;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-20.0))).min(Vector::splat(real(20.0)));

    // -- auxiliary system of block 3 (13), erratum 1 --
    // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
    let zeta3_dot = u_sat + bracket3 - t34;

    // -- weight law of block 3 (32) (65) --
    // W_3' = Gamma_3 (P_3 c_3 I_3 - lambda_3 W_3)
    let W3_dot = P3.outer(c3) - state.W3 * real(0.1);

    // -- true dynamics of block 3 (acceleration) (11) --
    // F_3 with the plant's parameters
    let F3_plant = Vector([-plant.c * x - plant.b * v - plant.a * w + t1]);
    // d_3(t)
    let d3 = Vector([real(0.2) * t2]);
    // F_3 + G_3 x_4 + d_3
    let x3_flow = F3_plant + u_sat + d3;

    // -- Lyapunov function of block 1 (23) (52) --
    // k_1^4/(2 pi) tan E_1
    let V_T1 = s1 * s1 * real(0.25);
    // 1/2 ||zeta_1||^2
    let V_zeta1 = state.zeta1.sum_squares() * real(0.5);

    // -- Lyapunov function of block 2 (23) (52) --
    // k_2^4/(2 pi) tan E_2
    let V_T2 = s2 * s2 * real(0.25);
    // 1/2 ||zeta_2||^2
    let V_zeta2 = state.zeta2.sum_squares() * real(0.5);

    // -- Lyapunov function of block 3 (23) (52) --
    // k_3^4/(2 pi) tan E_3
    let V_T3 = s3 * s3 * real(0.25);
    let t35 = t32 * state.W3;
    // tr(W_3^T W_3)/(2 Gamma_3)
    let V_W3 = t35[(0, 0)] * real(0.5);
    // D_3 = d_3 + model error of block 3
    let D3 = d3 + (F3_plant - F3);
    // D_3 - D_hat_3
    let D_error3 = D3 - D_hat3;
    // 1/2 ||theta_3 - th_3||^2
    let V_D3 = D_error3.sum_squares() * real(0.5);
    // 1/2 ||zeta_3||^2
    let V_zeta3 = state.zeta3.sum_squares() * real(0.5);

    // -- Lyapunov function (52) --
    // V, sum of the parts above
    let V = V_T1 + V_zeta1 + V_T2 + V_zeta2 + V_T3 + V_W3 + V_D3 + V_zeta3;

    // -- Ito generator (2) --
    // e1' along the flow
    let e1_flow = x2 - y_r_dot - zeta1_dot;
    let t36 = e1_flow.dot(e1);
    // s1' along the flow
    let s1_flow = t36 + t36;
    let t37 = s1_flow * s1;
    // V_T1' along the flow
    let V_T1_flow = (t37 + t37) * real(0.25);
    let t38 = zeta1_dot.dot(state.zeta1);
    // V_zeta1' along the flow
    let V_zeta1_flow = (t38 + t38) * real(0.5);
    // Lam0_1' along the flow
    let Lam0_1_flow = e1_flow * real(3.0);
    // c1' along the flow
    let c1_flow = e1 * s1_flow + e1_flow * s1;
    // Lam1_filter' along the flow
    let Lam1_filter_flow = c1_flow * real(0.5);
    // Lam1' along the flow
    let Lam1_flow = Lam0_1_flow + Lam1_filter_flow;
    // bracket1' along the flow
    let bracket1_flow = t18 + Lam1_flow;
    // e2' along the flow
    let e2_flow = x3 + bracket1_flow - zeta2_dot;
    let t39 = e2_flow.dot(e2);
    // s2' along the flow
    let s2_flow = t39 + t39;
    let t40 = s2_flow * s2;
    // V_T2' along the flow
    let V_T2_flow = (t40 + t40) * real(0.25);
    let t41 = zeta2_dot.dot(state.zeta2);
    // V_zeta2' along the flow
    let V_zeta2_flow = (t41 + t41) * real(0.5);
    // e1_dot' along the flow
    let e1_dot_flow = x3 - y_r_dot2 - zeta1_dot_dot;
    // Lam0_1_dot' along the flow
    let Lam0_1_dot_flow = e1_dot_flow * real(3.0);
    let t42 = e1_dot_flow.dot(e1) + e1_dot.dot(e1_flow);
    // s1_dot' along the flow
    let s1_dot_flow = t42 + t42;
    // c1_dot' along the flow
    let c1_dot_flow = e1 * s1_dot_flow + e1_flow * s1_dot
        + (e1_dot * s1_flow + e1_dot_flow * s1);
    // Lam1_filter_dot' along the flow
    let Lam1_filter_dot_flow = c1_dot_flow * real(0.5);
    // Lam1_dot' along the flow
    let Lam1_dot_flow = Lam0_1_dot_flow + Lam1_filter_dot_flow;
    // bracket1_dot' along the flow
    let bracket1_dot_flow = t27 + Lam1_dot_flow;
    // Lam0_2' along the flow
    let Lam0_2_flow = e2_flow * real(3.0);
    // c2' along the flow
    let c2_flow = e2 * s2_flow + e2_flow * s2;
    // Lam2_filter' along the flow
    let Lam2_filter_flow = c2_flow * real(0.5);
    let t43 = c1_flow.dot(c1);
    // s_c1' along the flow
    let s_c1_flow = t43 + t43;
    // Lam2_coupling' along the flow
    let Lam2_coupling_flow = Vector([
        (e2[0] * (t30 * s_c1_flow) + t19 * e2_flow[0]) * real(0.25),
    ]);
    // Lam2' along the flow
    let Lam2_flow = Lam0_2_flow + Lam2_filter_flow + Lam2_coupling_flow;
    // bracket2' along the flow
    let bracket2_flow = bracket1_dot_flow + t31 + Lam2_flow;
    // e3' along the flow
    let e3_flow = x3_flow + bracket2_flow - zeta3_dot;
    let t44 = e3_flow.dot(e3);
    // s3' along the flow
    let s3_flow = t44 + t44;
    let t45 = s3_flow * s3;
    // V_T3' along the flow
    let V_T3_flow = (t45 + t45) * real(0.25);
    let t46 = W3_dot.transpose() * state.W3 + t32 * W3_dot;
    // V_W3' along the flow
    let V_W3_flow = t46[(0, 0)] * real(0.5);
    // d3'
    let d3_dot = Vector([real(0.2) * t7]);
    let t47 = (x + x) * x2[0];
    // F3_plant' along the flow
    let F3_plant_flow = Vector([
        t47 - (plant.c * x2[0] + plant.b * x3[0] + plant.a * x3_flow[0]),
    ]);
    // F3' along the flow
    let F3_flow = Vector([
        t47 - (params.c * x2[0] + params.b * x3[0] + params.a * x3_flow[0]),
    ]);
    // D3' along the flow
    let D3_flow = d3_dot + (F3_plant_flow - F3_flow);
    // D_hat3' along the flow
    let D_hat3_flow = x3_flow * real(10.0) - (D_hat3 + t33 + u_sat) * real(10.0);
    // D_error3' along the flow
    let D_error3_flow = D3_flow - D_hat3_flow;
    let t48 = D_error3_flow.dot(D_error3);
    // V_D3' along the flow
    let V_D3_flow = (t48 + t48) * real(0.5);
    let t49 = zeta3_dot.dot(state.zeta3);
    // V_zeta3' along the flow
    let V_zeta3_flow = (t49 + t49) * real(0.5);
    // LV = V_t + V_x f + 1/2 sum_j g_j^T V_xx g_j
    let LV = V_T1_flow + V_zeta1_flow + V_T2_flow + V_zeta2_flow + V_T3_flow + V_W3_flow
        + V_D3_flow + V_zeta3_flow;
    LyapunovOutputs { V, LV }
}
