// SHA-256 of the text below: 004da0cf9faf38ea558f986f3566a69f34bd383f3ab316fb47da9dae84b13a46
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 d972773dfb13676aaaf2db69a5f101781863a9afbf9a773c4ea267afdcbe643c
// initial: 259 additions, 296 multiplications, 32 divisions, 0 square roots, 18 elementary functions, 18 comparisons and selections
// control: 2292 additions, 2641 multiplications, 75 divisions, 3 square roots, 25 elementary functions, 49 comparisons and selections

//! `underwater_vehicle`: control law and sampled controller.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
use core::f64::consts::FRAC_PI_2;
use nsv_runtime::kernel;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Mask, Part, Real};
use nsv_runtime::status::Status;

/// Largest magnitude of each control: `F_x` in kg*m/s^2, `F_y` in kg*m/s^2, `F_z` in kg*m/s^2,
/// `M_x` in kg*m^2/s^2, `M_y` in kg*m^2/s^2, `M_z` in kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 6] = [40.0, 40.0, 40.0, 5.0, 5.0, 5.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.01;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): pose (north, east, down, phi, theta, psi).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 6>,
    /// Auxiliary anti-windup state zeta (13): velocity (surge, sway, heave, p, q, r).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 6>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// pose (north, east, down, phi, theta, psi).
    ///
    /// `th_1' = -S_1 (D_hat_1 + F_1 + G_1 x_2 + A_hat_1)`
    pub th1: Vector<T, 6>,
    /// Filtered virtual control h (33): velocity (surge, sway, heave, p, q, r).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 6>,
    /// Network weights W_hat (65), one row per monomial and one column per channel: velocity
    /// (surge, sway, heave, p, q, r).
    ///
    /// `W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, surge, sway, heave, p, q, r, surge2, surge_sway, surge_heave, surge_p, surge_q,
    /// surge_r, sway2, sway_heave, sway_p, sway_q, sway_r, heave2, heave_p, heave_q, heave_r, p2,
    /// p_q, p_r, q2, q_r, r2`.
    pub W2: Matrix<T, 28, 6>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// velocity (surge, sway, heave, p, q, r).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2)`
    pub th2: Vector<T, 12>,
    /// Bound eps_hat of the approximation error (66): velocity (surge, sway, heave, p, q, r).
    ///
    /// `eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)`
    pub eps2: T,
    /// Bound sigma_hat of the noise intensity (67): velocity (surge, sway, heave, p, q, r).
    ///
    /// `sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
    /// varsigma_2^2)) - lambda_sigma sigma_hat_2)`
    pub sigma2: T,
    /// Noise term phi (68), kept positive: velocity (surge, sway, heave, p, q, r).
    ///
    /// `phi_2(t + dt) = max(phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)), phi_min)`
    pub phi2: T,
}

impl<T: Real> State<T> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            zeta1: Vector::zero(),
            zeta2: Vector::zero(),
            th1: Vector::zero(),
            h1: Vector::zero(),
            W2: Matrix::zero(),
            th2: Vector::zero(),
            eps2: T::zero(),
            sigma2: T::zero(),
            phi2: T::zero(),
        }
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: &Self, b: &Self) -> Self {
        Self {
            zeta1: Vector::select(mask, a.zeta1, b.zeta1),
            zeta2: Vector::select(mask, a.zeta2, b.zeta2),
            th1: Vector::select(mask, a.th1, b.th1),
            h1: Vector::select(mask, a.h1, b.h1),
            W2: Matrix::select(mask, a.W2, b.W2),
            th2: Vector::select(mask, a.th2, b.th2),
            eps2: T::select(mask, a.eps2, b.eps2),
            sigma2: T::select(mask, a.sigma2, b.sigma2),
            phi2: T::select(mask, a.phi2, b.phi2),
        }
    }

    /// Whether every entry is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        self.zeta1
            .is_finite()
            .and(self.zeta2.is_finite())
            .and(self.th1.is_finite())
            .and(self.h1.is_finite())
            .and(self.W2.is_finite())
            .and(self.th2.is_finite())
            .and(self.eps2.is_finite())
            .and(self.sigma2.is_finite())
            .and(self.phi2.is_finite())
    }
}

/// What a sample of the controller gives.
///
/// With `Status::NON_FINITE_INPUT`, only the control is meaningful.
#[derive(Clone, Copy, Debug)]
pub struct Output<T: Real> {
    /// What happened, in any lane.
    pub status: Status,
    /// Whether the law was finite, so that its control and next states are used.
    pub valid: T::Mask,
    /// Control that the law asks for, before its limits.
    pub u: Vector<T, 6>,
    /// Control to apply: within its limits, always finite.
    pub u_sat: Vector<T, 6>,
    /// `y_r(t)`
    pub y_r: Vector<T, 6>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 6>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 6>,
    /// `D_hat_1 = th_1 + S_1 x_1`
    pub D_hat1: Vector<T, 6>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 6>,
    /// `d_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 6>,
}

/// Underwater vehicle in waves and a current
///
/// The sampled controller: [`Controller::step`] is total, allocates nothing and cannot panic.
#[derive(Clone, Debug)]
pub struct Controller<T: Real> {
    params: Params<T>,
    state: State<T>,
    started: T::Mask,
}

impl<T: Real> Controller<T> {
    /// A controller that starts at its first step.
    #[inline(always)]
    pub fn new(params: Params<T>) -> Self {
        Self {
            params,
            state: State::zero(),
            started: T::Mask::splat(false),
        }
    }

    /// Starts anew from these measurements; from the next ones if they are not finite.
    #[inline(always)]
    pub fn reset(&mut self, t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) {
        let start = initial(t, x1, x2);
        let finite = start
            .is_finite()
            .and(t.is_finite())
            .and(x1.is_finite())
            .and(x2.is_finite());
        self.state = State::select(finite, &start, &State::zero());
        self.started = finite;
    }

    /// One sample: the control for the time since start (s) and the measured states (SI), after
    /// which the states are those of the next sample.
    ///
    /// Where a measurement, a next state or the control is not finite, the control is [`SAFE_INPUT`],
    /// the status has `NON_FINITE_INPUT`, and the states stay as they were. `SATURATED` means that
    /// a control is at its limit, `CONSTRAINT_VIOLATED` that an error has reached its bound and the
    /// barrier was clamped.
    ///
    /// The first step with finite measurements initialises the states; so does the step after one
    /// whose law overflowed although its measurements were finite, since such states are beyond
    /// use.
    #[inline(always)]
    pub fn step(&mut self, t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) -> Output<T> {
        let measured = t.is_finite().and(x1.is_finite()).and(x2.is_finite());
        let starting = measured.and(self.started.not());
        if starting.any() {
            T::outlined(Begin {
                controller: self,
                mask: starting,
                t,
                x1,
                x2,
            });
        }
        let law = control(t, x1, x2, &self.state, &self.params);
        let valid = measured
            .and(law.u.is_finite())
            .and(law.u_sat.is_finite())
            .and(law.next.is_finite());
        self.state = if valid.all() {
            law.next
        } else {
            State::select(valid, &law.next, &self.state)
        };
        self.started = valid.or(self.started.and(measured.not()));
        let u = Vector::select(valid, law.u, Vector::from_f64(SAFE_INPUT));
        let u_sat = Vector::select(valid, law.u_sat, Vector::from_f64(SAFE_INPUT));
        let saturated = u[0]
            .ne(u_sat[0])
            .or(u[1].ne(u_sat[1]))
            .or(u[2].ne(u_sat[2]))
            .or(u[3].ne(u_sat[3]))
            .or(u[4].ne(u_sat[4]))
            .or(u[5].ne(u_sat[5]));
        let status = Status::NON_FINITE_INPUT.when(valid.not().any())
            | Status::CONSTRAINT_VIOLATED.when(valid.and(law.violated).any())
            | Status::SATURATED.when(saturated.any());
        Output {
            status,
            valid,
            u,
            u_sat,
            y_r: law.y_r,
            e1: law.e1,
            k1: law.k1,
            alpha1: law.alpha1,
            D_hat1: law.D_hat1,
            e2: law.e2,
            D_hat2: law.D_hat2,
        }
    }

    /// The states.
    #[inline(always)]
    pub fn state(&self) -> &State<T> {
        &self.state
    }

    /// The parameters.
    #[inline(always)]
    pub fn params(&self) -> &Params<T> {
        &self.params
    }
}

/// Initialises the states where the mask is true and they are finite.
struct Begin<'a, T: Real> {
    controller: &'a mut Controller<T>,
    mask: T::Mask,
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
}
impl<T: Real> Part for Begin<'_, T> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let start = initial(self.t, self.x1, self.x2);
        let mask = self.mask.and(start.is_finite());
        self.controller.state = State::select(mask, &start, &self.controller.state);
    }
}

/// The controller's states at its first sample.
///
/// Operations: 259 additions, 296 multiplications, 32 divisions, 0 square roots, 18 elementary
/// functions, 18 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) -> State<T> {
    let real = T::from_f64;

    // -- known dynamics of block 1 (pose) (11) --
    // F_1(x_1 .. x_1)
    let F1: Vector<T, 6> = Vector::zero();

    // -- plant model --
    let psi = x1[5];
    let theta = x1[4];
    let phi = x1[3];
    let t1 = psi.cos();
    let t2 = theta.cos();
    let t3 = theta.sin();
    let t4 = t1 * t3;
    let t5 = phi.sin();
    let t6 = psi.sin();
    let t7 = phi.cos();
    let t8 = t6 * t3;
    let t9 = theta.tan();
    let J = Matrix([
        [t1 * t2, t4 * t5 - t6 * t7, t4 * t7 + t6 * t5, real(0.0), real(0.0), real(0.0)],
        [t6 * t2, t8 * t5 + t1 * t7, t8 * t7 - t1 * t5, real(0.0), real(0.0), real(0.0)],
        [-t3, t2 * t5, t2 * t7, real(0.0), real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(1.0), t5 * t9, t7 * t9],
        [real(0.0), real(0.0), real(0.0), real(0.0), t7, -t5],
        [real(0.0), real(0.0), real(0.0), real(0.0), t5 / t2, t7 / t2],
    ]);

    // -- reference and constraints --
    let t10 = real(0.3) * t;
    let t11 = t10.sin();
    let t12 = real(2.0) * t11;
    let t13 = t * t;
    let t14 = (real(-0.02) * (t13 * t)).exp();
    let t15 = real(1.0) - t14;
    let t16 = t10.cos();
    let t17 = real(2.0) * (real(1.0) - t16);
    let t18 = real(0.2) * t;
    let t19 = t18.cos();
    let t20 = real(1.0) - t19;
    let t21 = real(0.4) * t;
    let t22 = real(0.26179938779914946) * t21.sin();
    let t23 = real(0.4363323129985824) * t11;
    let t24 = t18.sin();
    let t25 = real(1.0471975511965979) * t24;
    // y_r(t)
    let y_r = Vector([t12 * t15, t17 * t15, t20 * t15, t22 * t15, t23 * t15, t25 * t15]);
    let t26 = t16 * real(0.3);
    let t27 = t14 * (real(-0.02) * (real(3.0) * t13));
    // y_r'
    let y_r_dot = Vector([
        t15 * (real(2.0) * t26) - t12 * t27,
        t15 * (real(2.0) * (t11 * real(0.3))) - t17 * t27,
        t15 * (t24 * real(0.2)) - t20 * t27,
        t15 * (real(0.26179938779914946) * (t21.cos() * real(0.4))) - t22 * t27,
        t15 * (real(0.4363323129985824) * t26) - t23 * t27,
        t15 * (real(1.0471975511965979) * (t19 * real(0.2))) - t25 * t27,
    ]);
    // k_1(t)
    let k1 = real(0.4) * (real(-0.3) * t).exp() + real(0.1);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 6> = Vector::zero();
    let th1 = -x1;
    let zeta2: Vector<T, 6> = Vector::zero();
    let W2: Matrix<T, 28, 6> = Matrix::zero();
    let eps2 = real(0.0);
    let sigma2 = real(0.0);
    let phi2 = real(10.0);

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t28 = s1 / (k1 * k1);
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t28 * t28);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t29 = cosE1 * cosE1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * s1 / t29;

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = x1 - x1;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = J.sum_squares();

    // -- robust feedback of block 1 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1
        * (kernel::sin_cos_over(E1) * real(1.0).min(real(1.5697963267948967) / E1_free))
        + e1 * real(0.5);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * (real(0.5) * G_norm2_1);
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = F1 - y_r_dot + Vector::<T, 6>::zero() + D_hat1 + Lam1;
    let t30 = J.solve(bracket1);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t30;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + t30;

    // -- disturbance observer of block 2 (20) (49) --
    // S_2, observer gain
    let S2: Matrix<T, 12, 6> = Matrix::from_f64([
        [-8.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [5.8, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, -8.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 5.8, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -8.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 5.8, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, -8.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 5.8, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -8.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 5.8, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, -8.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 5.8],
    ]);

    // -- given --
    let th2 = -(S2 * e2);
    State {
        zeta1,
        zeta2,
        th1,
        h1: alpha1,
        W2,
        th2,
        eps2,
        sigma2,
        phi2,
    }
}

/// Results of [`control`].
#[derive(Clone, Copy, Debug)]
pub struct ControlOutputs<T: Real> {
    /// `u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub u: Vector<T, 6>,
    /// `sat(u), each component limited to +-u_max (8)`
    pub u_sat: Vector<T, 6>,
    /// `E_1 >= pi/2 - delta`
    pub violated: T::Mask,
    /// `y_r(t)`
    pub y_r: Vector<T, 6>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 6>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 6>,
    /// `D_hat_1 = th_1 + S_1 x_1`
    pub D_hat1: Vector<T, 6>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 6>,
    /// `d_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 6>,
    /// All outputs `next.*`.
    pub next: State<T>,
}

/// One sample of the control law: control, next states and the signals on the way.
///
/// Operations: 2292 additions, 2641 multiplications, 75 divisions, 3 square roots, 25
/// elementary functions, 49 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    state: &State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- known dynamics of block 1 (pose) (11) --
    // F_1(x_1 .. x_1)
    let F1: Vector<T, 6> = Vector::zero();

    // -- plant model --
    let psi = x1[5];
    let theta = x1[4];
    let phi = x1[3];
    let t1 = psi.cos();
    let t2 = theta.cos();
    let t3 = theta.sin();
    let t4 = t1 * t3;
    let t5 = phi.sin();
    let t6 = psi.sin();
    let t7 = phi.cos();
    let t8 = t6 * t3;
    let t9 = -t3;
    let t10 = t2 * t5;
    let t11 = t2 * t7;
    let t12 = theta.tan();
    let J = Matrix([
        [t1 * t2, t4 * t5 - t6 * t7, t4 * t7 + t6 * t5, real(0.0), real(0.0), real(0.0)],
        [t6 * t2, t8 * t5 + t1 * t7, t8 * t7 - t1 * t5, real(0.0), real(0.0), real(0.0)],
        [t9, t10, t11, real(0.0), real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(1.0), t5 * t12, t7 * t12],
        [real(0.0), real(0.0), real(0.0), real(0.0), t7, -t5],
        [real(0.0), real(0.0), real(0.0), real(0.0), t5 / t2, t7 / t2],
    ]);
    let I = real(0.16) + params.added_scale * real(0.12);
    let m_x = real(11.5) + params.added_scale * real(5.5);
    let det_xq = m_x * I - real(0.0529);
    let m_y = real(11.5) + params.added_scale * real(12.7);
    let det_yp = m_y * I - real(0.0529);
    let m_z = real(11.5) + params.added_scale * real(14.57);
    let t13 = real(-0.23) / det_xq;
    let t14 = real(0.23) / det_yp;
    let inverse_M = Matrix([
        [I / det_xq, real(0.0), real(0.0), real(0.0), t13, real(0.0)],
        [real(0.0), I / det_yp, real(0.0), t14, real(0.0), real(0.0)],
        [real(0.0), real(0.0), real(1.0) / m_z, real(0.0), real(0.0), real(0.0)],
        [real(0.0), t14, real(0.0), m_y / det_yp, real(0.0), real(0.0)],
        [t13, real(0.0), real(0.0), real(0.0), m_x / det_xq, real(0.0)],
        [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(1.0) / I],
    ]);
    let down_axis = Vector([t9, t10, t11]);
    let p = x2[3];
    let q = x2[4];
    let r = x2[5];
    let surge = x2[0];
    let sway = x2[1];
    let heave = x2[2];
    let t15 = q * heave - r * sway;
    let t16 = r * surge - p * heave;
    let carried = Vector([t15, t16, p * sway - q * surge]);
    let added_momentum = Vector([
        real(5.5) * surge,
        real(12.7) * sway,
        real(14.57) * heave,
    ]) * params.added_scale;
    let t17 = Vector([
        (real(4.03) + real(18.18) * surge.abs()) * surge,
        (real(6.22) + real(21.66) * sway.abs()) * sway,
        (real(5.18) + real(36.99) * heave.abs()) * heave,
    ]);
    let drag = t17 * params.drag_scale;
    let t18 = Vector([p * r, q * r, -(p * p) - q * q]) * real(0.02);
    let t19 = Vector([
        q * added_momentum[2] - r * added_momentum[1],
        r * added_momentum[0] - p * added_momentum[2],
        p * added_momentum[1] - q * added_momentum[0],
    ]);
    let force = down_axis * real(-1.9849999999999852) - (carried + t18) * real(11.5)
        - t19 - drag;
    let t20 = Vector([
        (real(0.07) + real(1.55) * p.abs()) * p,
        (real(0.07) + real(1.55) * q.abs()) * q,
        (real(0.07) + real(1.55) * r.abs()) * r,
    ]);
    let drag_torque = t20 * params.torque_scale;
    let t21 = Vector([
        sway * added_momentum[2] - heave * added_momentum[1],
        heave * added_momentum[0] - surge * added_momentum[2],
        surge * added_momentum[1] - sway * added_momentum[0],
    ]);
    let moment = Vector([t16 - real(9.81) * t10, real(9.81) * t9 - t15, real(0.0)])
        * real(0.23) - t21 - drag_torque;
    let shaking: Matrix<T, 6, 6> = Matrix::from_f64([
        [0.1, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.1, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.1, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.01, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.01, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.01],
    ]);

    // -- known dynamics of block 2 (velocity) (11) --
    // F_2(x_1 .. x_2)
    let F2 = inverse_M
        * Vector([force[0], force[1], force[2], moment[0], moment[1], moment[2]]);
    // H_2(x_1 .. x_2)
    let H2 = inverse_M * shaking;

    // -- reference and constraints --
    let t22 = real(0.3) * t;
    let t23 = t22.sin();
    let t24 = real(2.0) * t23;
    let t25 = t * t;
    let t26 = (real(-0.02) * (t25 * t)).exp();
    let t27 = real(1.0) - t26;
    let t28 = t22.cos();
    let t29 = real(2.0) * (real(1.0) - t28);
    let t30 = real(0.2) * t;
    let t31 = t30.cos();
    let t32 = real(1.0) - t31;
    let t33 = real(0.4) * t;
    let t34 = real(0.26179938779914946) * t33.sin();
    let t35 = real(0.4363323129985824) * t23;
    let t36 = t30.sin();
    let t37 = real(1.0471975511965979) * t36;
    // y_r(t)
    let y_r = Vector([t24 * t27, t29 * t27, t32 * t27, t34 * t27, t35 * t27, t37 * t27]);
    let t38 = t28 * real(0.3);
    let t39 = t26 * (real(-0.02) * (real(3.0) * t25));
    // y_r'
    let y_r_dot = Vector([
        t27 * (real(2.0) * t38) - t24 * t39,
        t27 * (real(2.0) * (t23 * real(0.3))) - t29 * t39,
        t27 * (t36 * real(0.2)) - t32 * t39,
        t27 * (real(0.26179938779914946) * (t33.cos() * real(0.4))) - t34 * t39,
        t27 * (real(0.4363323129985824) * t38) - t35 * t39,
        t27 * (real(1.0471975511965979) * (t31 * real(0.2))) - t37 * t39,
    ]);
    // k_1(t)
    let k1 = real(0.4) * (real(-0.3) * t).exp() + real(0.1);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t40 = s1 / (k1 * k1);
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t40 * t40);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    let t41 = cosE1 * cosE1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * s1 / t41;

    // -- disturbance observer of block 1 (20) (49) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = J.sum_squares();

    // -- robust feedback of block 1 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_1 = e1
        * (kernel::sin_cos_over(E1) * real(1.0).min(real(1.5697963267948967) / E1_free))
        + e1 * real(0.5);
    // eta_1/2 c^T (36)
    let Lam1_disturbance = c1 * real(0.5);
    // eta_2/2 ||G||^2 c^T (37)
    let Lam1_filter = c1 * (real(0.5) * G_norm2_1);
    // Lam_1, sum of the terms above
    let Lam1 = Lam0_1 + Lam1_disturbance + Lam1_filter;
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t42 = state.zeta1 * real(5.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = F1 - y_r_dot + t42 + D_hat1 + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -J.solve(bracket1);

    // -- auxiliary system of block 1 (13) (E1) --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = J * state.zeta2 - t42;

    // -- observer dynamics of block 1 (21) (50) --
    // th_1' = -S_1 (D_hat_1 + F_1 + G_1 x_2 + A_hat_1)
    let th1_dot = -(D_hat1 + F1 + J * x2);

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) / real(0.1);

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2;

    // -- MTPN of block 2 (4) (16) --
    // P_2 = P_m(z_2), 28 nodes
    let P2 = polynomials::basis2(x2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose() * P2;

    // -- disturbance observer of block 2 (20) (49) --
    // S_2, observer gain
    let S2: Matrix<T, 12, 6> = Matrix::from_f64([
        [-8.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [5.8, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, -8.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 5.8, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -8.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 5.8, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, -8.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 5.8, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -8.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 5.8, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, -8.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 5.8],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + S2 * e2;
    // L_2
    let L2: Matrix<T, 6, 12> = Matrix::from_f64([
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    ]);
    // d_hat_2 = L_2 w_hat_2
    let D_hat2 = L2 * w_hat2;

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(7.3484692283495345);
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t43 = H_norm2_2 * Ybar_norm2;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t43 * t43 * real(0.5) + real(0.30000000000000004)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) (63) --
    // Lam0 = (4 kbar + K) k^4/(2 pi) sin E cos E / s^2 e + kbar e (31)
    let Lam0_2 = e2 * real(3.25) + e2 * real(2.0);
    // ||L||^2/(2 eta_1) c^T (63)
    let Lam2_disturbance = c2 * real(3.0);
    // e / (2 cos^2 E) (63)
    let Lam2_network = e2 * real(0.5);
    let t44 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t44 * state.eps2;
    let t45 = G_norm2_1 * s_c1;
    // ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2_coupling = e2 * (t45 * t45) * real(0.25);
    let t46 = s2 * s2;
    let t47 = (t46 + real(1.0)).sqrt();
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64) (E4, E7)
    let Lam2_noise = e2 * (t43 * state.sigma2) / t47;
    let t48 = Psi2 / (state.phi2 * state.phi2 + t46);
    // e Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam2_diffusion = e2 * t48;
    // Lam_2, sum of the terms above
    let Lam2 = Lam0_2 + Lam2_disturbance + Lam2_network + Lam2_error_bound
        + Lam2_coupling + Lam2_noise + Lam2_diffusion;

    // -- control (64) of block 2 --
    let t49 = F2 + A_hat2;
    let t50 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t49 - h1_dot + t50 + D_hat2 + Lam2;
    let t51 = inverse_M.solve(bracket2);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t51;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
        .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

    // -- auxiliary system of block 2 (13) (E1) --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = inverse_M * (u_sat + t51) - t50;

    // -- weight law of block 2 (32) (65) --
    // W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    let W2_dot = P2.outer(c2) - state.W2 * real(0.1);

    // -- observer dynamics of block 2 (21) (50) --
    // M_2 - S_2 L_2
    let w2_closed: Matrix<T, 12, 12> = Matrix::from_f64([
        [0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [-1.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, -1.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, -1.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -6.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -6.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -6.0],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2)
    let th2_dot = w2_closed * w_hat2 - S2 * (t49 + inverse_M * u - h1_dot + t50);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t44) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t43 * t46 / t47 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t48 + real(0.5);

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + Gamma zeta1'
    let zeta1_next = state.zeta1 + zeta1_dot * real(0.009754115099857198);
    // h1(t + dt) = h1 + Gamma h1'
    let h1_next = state.h1 + h1_dot * real(0.009516258196404044);
    // th1(t + dt) = th1 + Gamma th1'
    let th1_next = state.th1 + th1_dot * real(0.009950166250831947);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + Gamma zeta2'
    let zeta2_next = state.zeta2 + zeta2_dot * real(0.009516258196404044);
    // Gamma of th2
    let th2_step: Matrix<T, 12, 12> = Matrix::from_f64([
        [
            0.0099985222988428,
            0.00044110044503657773,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            -4.9011160559619754e-5,
            0.009704455335485081,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0099985222988428,
            0.00044110044503657773,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            -4.9011160559619754e-5,
            0.009704455335485081,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0099985222988428,
            0.00044110044503657773,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            -4.9011160559619754e-5,
            0.009704455335485081,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0099985222988428,
            0.00044110044503657773,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            -4.9011160559619754e-5,
            0.009704455335485081,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0099985222988428,
            0.00044110044503657773,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            -4.9011160559619754e-5,
            0.009704455335485081,
            0.0,
            0.0,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0099985222988428,
            0.00044110044503657773,
        ],
        [
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            -4.9011160559619754e-5,
            0.009704455335485081,
        ],
    ]);
    // th2(t + dt) = th2 + Gamma th2'
    let th2_next = state.th2 + th2_step * th2_dot;
    // W2(t + dt) = W2 + Gamma W2'
    let W2_next = state.W2 + W2_dot * real(0.009995001666250083);
    // eps2(t + dt) = eps2 + Gamma eps2'
    let eps2_next = state.eps2 + real(0.009995001666250083) * eps2_dot;
    // sigma2(t + dt) = sigma2 + Gamma sigma2'
    let sigma2_next = state.sigma2 + real(0.009995001666250083) * sigma2_dot;
    // phi_min = sqrt(Psi_2 dt / 0.1) (E11)
    let phi2_min = (Psi2 * real(0.09999999999999999)).sqrt();
    // phi_2(t + dt) = max(phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)), phi_min)
    let phi2_next = T::select(
            s2.sqrt().ge(real(0.2)),
            state.phi2 * (-(real(0.01) * phi2_decay)).exp(),
            state.phi2,
        )
        .max(phi2_min);
    ControlOutputs {
        u,
        u_sat,
        violated: violated1,
        y_r,
        e1,
        k1,
        alpha1,
        D_hat1,
        e2,
        D_hat2,
        next: State {
            zeta1: zeta1_next,
            zeta2: zeta2_next,
            th1: th1_next,
            h1: h1_next,
            W2: W2_next,
            th2: th2_next,
            eps2: eps2_next,
            sigma2: sigma2_next,
            phi2: phi2_next,
        },
    }
}
