// SHA-256 of the text below: 0c92299ec9e210fe2bfddc0d28c126d1ffab052fb1c91be9a8acb10d78652b8c
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 77 additions, 155 multiplications, 6 divisions, 0 square roots, 19 elementary functions, 3 comparisons and selections
// control: 708 additions, 1018 multiplications, 12 divisions, 3 square roots, 26 elementary functions, 19 comparisons and selections

//! `underwater_vehicle`: control law and sampled controller.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
use core::f64::consts::FRAC_PI_2;
use nsv_runtime::ahead::OfTime;
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
#[repr(align(64))]
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
    /// `th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 +
    /// F_1 + G_1 x_2 + A_hat_1)`
    pub th1: Vector<T, 6>,
    /// Filtered virtual control h (33): velocity (surge, sway, heave, p, q, r).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 6>,
    /// Network weights W_hat, one row per monomial and one column per channel: velocity (surge,
    /// sway, heave, p, q, r).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, surge, sway, heave, p, q, r, surge2, surge_sway, surge_heave, surge_p, surge_q,
    /// surge_r, sway2, sway_heave, sway_p, sway_q, sway_r, heave2, heave_p, heave_q, heave_r, p2,
    /// p_q, p_r, q2, q_r, r2`.
    pub W2: Matrix<T, 28, 6>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// velocity (surge, sway, heave, p, q, r).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
    /// M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)`
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
    /// `phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >=
    /// iota_phi, else phi_2; at least phi_min (68), erratum 11`
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
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 6>,
}
impl<T: Real> Output<T> {
    /// Before the first sample: all zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            status: Status::OK,
            valid: T::Mask::splat(false),
            u: Vector::zero(),
            u_sat: Vector::zero(),
            y_r: Vector::zero(),
            e1: Vector::zero(),
            k1: T::zero(),
            alpha1: Vector::zero(),
            D_hat1: Vector::zero(),
            e2: Vector::zero(),
            D_hat2: Vector::zero(),
        }
    }
}

/// Underwater vehicle in waves and a current
///
/// The sampled controller: [`Controller::step`] is total, allocates nothing and cannot panic.
#[derive(Clone, Debug)]
pub struct Controller<T: Real> {
    params: Params<T>,
    prepared: Prepared<T>,
    state: State<T>,
    started: T::Mask,
}

impl<T: Real> Controller<T> {
    /// A controller that starts at its first step.
    #[inline(always)]
    pub fn new(params: Params<T>) -> Self {
        Self {
            prepared: prepare(&params),
            params,
            state: State::zero(),
            started: T::Mask::splat(false),
        }
    }

    /// Starts anew from these measurements; from the next ones if they are not finite.
    #[inline(always)]
    pub fn reset(&mut self, t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) {
        self.state = State::zero();
        self.started = T::Mask::splat(false);
        let mask = t.is_finite().and(x1.is_finite()).and(x2.is_finite());
        T::outlined(Begin {
            controller: self,
            mask,
            t,
            x1,
            x2,
        });
    }

    /// One sample: the control for the time since start (s) and the measured states (SI), after
    /// which the states are those of the next sample.
    ///
    /// Where a measurement, a next state or the control is not finite, the control is [`SAFE_INPUT`]
    /// and the status has `NON_FINITE_INPUT`. `SATURATED` means that a control is at its limit,
    /// `CONSTRAINT_VIOLATED` that an error has reached its bound and the barrier was clamped.
    ///
    /// The first step with finite measurements initialises the states. A measurement that is not
    /// finite leaves them as they were; a law that overflows although its measurements are finite
    /// gives them up, and the next step with finite measurements starts anew.
    #[inline(always)]
    pub fn step(&mut self, t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) -> Output<T> {
        let clock = clock(t);
        self.step_at(t, &clock, x1, x2)
    }

    /// As [`Controller::step`], with the values of [`clock`] at this time, which can serve many
    /// runs.
    #[inline(always)]
    pub fn step_at(
        &mut self,
        t: T,
        clock: &Clock<T>,
        x1: Vector<T, 6>,
        x2: Vector<T, 6>,
    ) -> Output<T> {
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
        let before = if measured.all() { None } else { Some(self.state) };
        let law = law(x1, x2, &mut self.state, &self.params, &self.prepared, clock);
        let valid = measured
            .and(self.started)
            .and(law.u.is_finite())
            .and(law.u_sat.is_finite())
            .and(self.state.is_finite());
        if !valid.all() {
            T::outlined(Restore {
                controller: self,
                valid,
                measured,
                before,
            });
        }
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
        self.controller.started = self.controller.started.or(mask);
    }
}

/// Gives the states back where the law was not finite: those before it, or if they made it
/// overflow those of a start at the origin, until the next sample.
struct Restore<'a, T: Real> {
    controller: &'a mut Controller<T>,
    valid: T::Mask,
    measured: T::Mask,
    before: Option<State<T>>,
}
impl<T: Real> Part for Restore<'_, T> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let zero = State::zero();
        let controller = self.controller;
        let kept = match &self.before {
            Some(before) => State::select(self.measured, &zero, before),
            None => zero,
        };
        controller.state = State::select(self.valid, &controller.state, &kept);
        let mask = self.measured.and(self.valid.not());
        T::outlined(Begin {
            controller: &mut *controller,
            mask,
            t: T::zero(),
            x1: Vector::zero(),
            x2: Vector::zero(),
        });
        controller.started = controller.started.and(mask.not());
    }
}

/// The controller's states at its first sample.
///
/// Operations: 77 additions, 155 multiplications, 6 divisions, 0 square roots, 19 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let psi = x1[5];
    let theta = x1[4];
    let phi = x1[3];

    // -- reference and constraints --
    let t1 = real(0.3) * t;
    let t2 = real(0.4) * t;
    let t3 = real(0.2) * t;
    let t4 = Vector([t1, t3, t2]);
    let [sin_t1, sin_t3, sin_t2] = t4.sin().0;
    let t5 = real(2.0) * sin_t1;
    let t6 = t * t;
    let t7 = (real(-0.02) * (t6 * t)).exp();
    let t8 = real(1.0) - t7;
    let [cos_t1, cos_t3, cos_t2] = t4.cos().0;
    let t9 = real(2.0) * (real(1.0) - cos_t1);
    let t10 = real(1.0) - cos_t3;
    let t11 = real(0.26179938779914946) * sin_t2;
    let t12 = real(0.4363323129985824) * sin_t1;
    let t13 = real(1.0471975511965979) * sin_t3;
    // y_r(t)
    let y_r = Vector([t5 * t8, t9 * t8, t10 * t8, t11 * t8, t12 * t8, t13 * t8]);
    let t14 = cos_t1 * real(0.3);
    let t15 = t7 * (real(-0.02) * (real(3.0) * t6));
    // y_r'
    let y_r_dot = Vector([
        t8 * (real(2.0) * t14) - t5 * t15,
        t8 * (real(2.0) * (sin_t1 * real(0.3))) - t9 * t15,
        t8 * (sin_t3 * real(0.2)) - t10 * t15,
        t8 * (real(0.26179938779914946) * (cos_t2 * real(0.4))) - t11 * t15,
        t8 * (real(0.4363323129985824) * t14) - t12 * t15,
        t8 * (real(1.0471975511965979) * (cos_t3 * real(0.2))) - t13 * t15,
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
    let t16 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t16 * t16);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);

    // -- norms of block 1 --
    let t17 = Vector([phi, theta, psi]);
    let [cos_phi, cos_theta, cos_psi] = t17.cos().0;
    let t18 = cos_psi * cos_theta;
    let [sin_phi, sin_theta, sin_psi] = t17.sin().0;
    let t19 = cos_psi * sin_theta;
    let t20 = t19 * sin_phi - sin_psi * cos_phi;
    let t21 = t19 * cos_phi + sin_psi * sin_phi;
    let t22 = sin_psi * cos_theta;
    let t23 = sin_psi * sin_theta;
    let t24 = t23 * sin_phi + cos_psi * cos_phi;
    let t25 = t23 * cos_phi - cos_psi * sin_phi;
    let t26 = cos_theta * sin_phi;
    let t27 = cos_theta * cos_phi;
    let [_, tan_theta, _] = t17.tan().0;
    let t28 = sin_phi * tan_theta;
    let t29 = cos_phi * tan_theta;
    let t30 = real(1.0) / cos_theta;
    let t31 = sin_phi * t30;
    let t32 = cos_phi * t30;
    let t33 = t22 * t22 + t24 * t24 + t25 * t25;
    let t34 = t18 * t18 + t20 * t20 + t21 * t21 + t33;
    let t35 = t34 + (sin_theta * sin_theta + t26 * t26 + t27 * t27);
    let t36 = t35 + (real(1.0) + t28 * t28 + t29 * t29);
    // ||G_1||^2
    let G_norm2_1 = t36 + (cos_phi * cos_phi + sin_phi * sin_phi)
        + (t31 * t31 + t32 * t32);

    // -- robust feedback of block 1 (31) --
    let t37 = s1 * sec2E1;
    let t38 = T::select(
        E1_free.lt(real(1e-300)),
        real(1.0),
        E1.sin() * cosE1 * (real(1.0) / E1_free),
    ) + real(0.5);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t38 + t37 * real(0.5) + t37 * (real(0.5) * G_norm2_1));

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = Lam1 - y_r_dot;
    let t39 = Matrix::rows([[t18, t20, t21], [t22, t24, t25], [-sin_theta, t26, t27]])
        .solve(Vector([bracket1[0], bracket1[1], bracket1[2]]));
    let t40 = Matrix::rows([[cos_phi, -sin_phi], [t31, t32]])
        .solve(Vector([bracket1[4], bracket1[5]]));
    let t41 = bracket1[3] - t28 * t40[0] - t29 * t40[1];
    let t42 = Vector([t39[0], t39[1], t39[2], t41, t40[0], t40[1]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t42;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + t42;

    // -- given --
    let t43 = real(-8.0) * e2[0];
    let t44 = real(5.8) * e2[0];
    let t45 = real(-8.0) * e2[1];
    let t46 = real(5.8) * e2[1];
    let t47 = real(-8.0) * e2[2];
    let t48 = real(5.8) * e2[2];
    let t49 = real(-8.0) * e2[3];
    let t50 = real(5.8) * e2[3];
    let t51 = real(-8.0) * e2[4];
    let t52 = real(5.8) * e2[4];
    let t53 = real(-8.0) * e2[5];
    let t54 = real(5.8) * e2[5];
    let th2 = -Vector([t43, t44, t45, t46, t47, t48, t49, t50, t51, t52, t53, t54]);
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

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `m_x`.
    pub m_x: T,
    /// `m_y`.
    pub m_y: T,
    /// `m_z`.
    pub m_z: T,
    /// `I`.
    pub I: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_1: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_2: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_3: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_4: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_5: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_6: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_7: T,
    /// Part of `H_norm2_2`.
    pub H_norm2_2_8: T,
    /// `Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)`
    pub Psi2: T,
    /// Part of `Lam2`.
    pub Lam2_1: T,
    /// `phi_min = sqrt(Psi_2 dt / 0.1), erratum 11`
    pub phi2_min: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 36 additions, 79 multiplications, 4 divisions, 1 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let m_x = real(11.5) + params.added_scale * real(5.5);
    let m_y = real(11.5) + params.added_scale * real(12.7);
    let m_z = real(11.5) + params.added_scale * real(14.57);
    let I = real(0.16) + params.added_scale * real(0.12);

    // -- noise terms of block 2 (58) (62) --
    // ||Ybar_2||^2
    let Ybar_square2 = real(54.0);
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(7.3484692283495345);
    let t1 = real(1.0) / (m_x * I - real(0.0529));
    let H_norm2_2_1 = I * t1;
    let H_norm2_2_2 = real(-0.23) * t1;
    let H_norm2_2_3 = m_x * t1;
    let t2 = real(1.0) / (m_y * I - real(0.0529));
    let H_norm2_2_4 = I * t2;
    let H_norm2_2_5 = real(0.23) * t2;
    let H_norm2_2_6 = m_y * t2;
    let H_norm2_2_7 = real(1.0) / m_z;
    let H_norm2_2_8 = real(1.0) / I;

    // -- noise terms of block 2 (58) (62) --
    let t3 = H_norm2_2_1 * real(0.1);
    let t4 = H_norm2_2_2 * real(0.01);
    let t5 = H_norm2_2_4 * real(0.1);
    let t6 = H_norm2_2_5 * real(0.01);
    let t7 = H_norm2_2_7 * real(0.1);
    let t8 = H_norm2_2_5 * real(0.1);
    let t9 = H_norm2_2_6 * real(0.01);
    let t10 = H_norm2_2_2 * real(0.1);
    let t11 = H_norm2_2_3 * real(0.01);
    let t12 = H_norm2_2_8 * real(0.01);
    let t13 = t3 * t3 + t4 * t4 + (t5 * t5 + t6 * t6);
    let t14 = t13 + t7 * t7 + (t8 * t8 + t9 * t9);
    // ||H_2||^2
    let H_norm2_2 = t14 + (t10 * t10 + t11 * t11) + t12 * t12;
    let t15 = real(-8.0) * t3;
    let t16 = real(-8.0) * t4;
    let t17 = real(5.8) * t3;
    let t18 = real(5.8) * t4;
    let t19 = real(-8.0) * t5;
    let t20 = real(-8.0) * t6;
    let t21 = real(5.8) * t5;
    let t22 = real(5.8) * t6;
    let t23 = real(-8.0) * t7;
    let t24 = real(5.8) * t7;
    let t25 = real(-8.0) * t8;
    let t26 = real(-8.0) * t9;
    let t27 = real(5.8) * t8;
    let t28 = real(5.8) * t9;
    let t29 = real(-8.0) * t10;
    let t30 = real(-8.0) * t11;
    let t31 = real(5.8) * t10;
    let t32 = real(5.8) * t11;
    let t33 = real(-8.0) * t12;
    let t34 = real(5.8) * t12;
    let t35 = t15 * t15 + t16 * t16 + (t17 * t17 + t18 * t18);
    let t36 = t35 + (t19 * t19 + t20 * t20) + (t21 * t21 + t22 * t22);
    let t37 = t36 + t23 * t23 + t24 * t24 + (t25 * t25 + t26 * t26);
    let t38 = t37 + (t27 * t27 + t28 * t28) + (t29 * t29 + t30 * t30);
    // ||S_2 H_2||^2
    let SH_norm2_2 = t38 + (t31 * t31 + t32 * t32) + t33 * t33 + t34 * t34;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5)
        + real(0.30000000000000004) + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- states of block 2, one sample later --
    // phi_min = sqrt(Psi_2 dt / 0.1), erratum 11
    let phi2_min = (Psi2 * real(0.09999999999999999)).sqrt();
    let Lam2_1 = H_norm2_2 * Ybar_norm2;
    Prepared {
        m_x,
        m_y,
        m_z,
        I,
        H_norm2_2_1,
        H_norm2_2_2,
        H_norm2_2_3,
        H_norm2_2_4,
        H_norm2_2_5,
        H_norm2_2_6,
        H_norm2_2_7,
        H_norm2_2_8,
        Psi2,
        Lam2_1,
        phi2_min,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `y_r(t)`
    pub y_r: Vector<T, 6>,
    /// `y_r'`
    pub y_r_dot: Vector<T, 6>,
    /// `k_1(t)`
    pub k1: T,
    /// Part of `E1_free`.
    pub E1_free_1: T,
}

impl<T: Real> OfTime<T> for Clock<T> {
    #[inline(always)]
    fn at(t: T) -> Self {
        clock(t)
    }

    #[inline(always)]
    fn of_lane(&self, lane: usize) -> Self {
        Self {
            y_r: self.y_r.in_every_lane(lane),
            y_r_dot: self.y_r_dot.in_every_lane(lane),
            k1: self.k1.in_every_lane(lane),
            E1_free_1: self.E1_free_1.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 10 additions, 45 multiplications, 1 divisions, 0 square roots, 8 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(0.3) * t;
    let t2 = real(0.4) * t;
    let t3 = real(0.2) * t;
    let t4 = Vector([t1, t3, t2]);
    let [sin_t1, sin_t3, sin_t2] = t4.sin().0;
    let t5 = real(2.0) * sin_t1;
    let t6 = t * t;
    let t7 = (real(-0.02) * (t6 * t)).exp();
    let t8 = real(1.0) - t7;
    let [cos_t1, cos_t3, cos_t2] = t4.cos().0;
    let t9 = real(2.0) * (real(1.0) - cos_t1);
    let t10 = real(1.0) - cos_t3;
    let t11 = real(0.26179938779914946) * sin_t2;
    let t12 = real(0.4363323129985824) * sin_t1;
    let t13 = real(1.0471975511965979) * sin_t3;
    // y_r(t)
    let y_r = Vector([t5 * t8, t9 * t8, t10 * t8, t11 * t8, t12 * t8, t13 * t8]);
    let t14 = cos_t1 * real(0.3);
    let t15 = t7 * (real(-0.02) * (real(3.0) * t6));
    // y_r'
    let y_r_dot = Vector([
        t8 * (real(2.0) * t14) - t5 * t15,
        t8 * (real(2.0) * (sin_t1 * real(0.3))) - t9 * t15,
        t8 * (sin_t3 * real(0.2)) - t10 * t15,
        t8 * (real(0.26179938779914946) * (cos_t2 * real(0.4))) - t11 * t15,
        t8 * (real(0.4363323129985824) * t14) - t12 * t15,
        t8 * (real(1.0471975511965979) * (cos_t3 * real(0.2))) - t13 * t15,
    ]);
    // k_1(t)
    let k1 = real(0.4) * (real(-0.3) * t).exp() + real(0.1);
    let E1_free_1 = real(1.0) / (k1 * k1);
    Clock {
        y_r,
        y_r_dot,
        k1,
        E1_free_1,
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
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 6>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `pose`, which are numbers in the formulas: `K = 2`, `kbar = 0.5`, `C = 5
/// I`, `Fl = 0.1 s`, `S = I`, `eta_1 = 1`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `velocity`, which are numbers in the formulas: `K = 5`, `kbar = 2`, `C = 10
/// I`, `S = (-8 0 0 0 0 0; 5.8 0 0 0 0 0; 0 -8 0 0 0 0; 0 5.8 0 0 0 0; 0 0 -8 0 0 0; 0 0 5.8 0 0 0; 0 0 0 -8 0 0; 0 0 0 5.8 0 0; 0 0 0 0 -8 0; 0 0 0 0 5.8 0; 0 0 0 0 0 -8; 0 0 0 0 0 5.8)`,
/// `M = (0 1; -1 -0.2) in each channel`, `N = diag((0; 0.1), (0; 0.1), (0; 0.1), (0; 0.2), (0; 0.2),
/// (0; 0.2))`, `L = (0 1) in each channel`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`,
/// `iota_0 = 0.1`, `b = 1`, `eta_noise = 0.1`, `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 1`,
/// `kappa_phi = 0.5`, `iota_phi = 0.2`.
///
/// Operations: 662 additions, 894 multiplications, 7 divisions, 2 square roots, 18 elementary
/// functions, 19 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    state: &mut State<T>,
    params: &Params<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let psi = x1[5];
    let theta = x1[4];
    let phi = x1[3];
    let arm = real(0.23);
    let t1 = Vector([phi, theta, psi]);
    let [cos_phi, cos_theta, cos_psi] = t1.cos().0;
    let [sin_phi, sin_theta, sin_psi] = t1.sin().0;
    let t2 = -sin_theta;
    let t3 = cos_theta * sin_phi;
    let t4 = cos_theta * cos_phi;
    let down_axis = Vector([t2, t3, t4]);
    let p = x2[3];
    let q = x2[4];
    let r = x2[5];
    let surge = x2[0];
    let sway = x2[1];
    let heave = x2[2];
    let t5 = q * heave - r * sway;
    let t6 = r * surge - p * heave;
    let carried = Vector([t5, t6, p * sway - q * surge]);
    let added_momentum = Vector([
        real(5.5) * surge,
        real(12.7) * sway,
        real(14.57) * heave,
    ]) * params.added_scale;
    let t7 = Vector([
        (real(4.03) + real(18.18) * surge.abs()) * surge,
        (real(6.22) + real(21.66) * sway.abs()) * sway,
        (real(5.18) + real(36.99) * heave.abs()) * heave,
    ]);
    let drag = t7 * params.drag_scale;
    let t8 = Vector([p * r, q * r, -(p * p) - q * q]) * real(0.02);
    let t9 = Vector([
        q * added_momentum[2] - r * added_momentum[1],
        r * added_momentum[0] - p * added_momentum[2],
        p * added_momentum[1] - q * added_momentum[0],
    ]);
    let force = down_axis * real(-1.9849999999999852) - (carried + t8) * real(11.5) - t9
        - drag;
    let t10 = Vector([
        (real(0.07) + real(1.55) * p.abs()) * p,
        (real(0.07) + real(1.55) * q.abs()) * q,
        (real(0.07) + real(1.55) * r.abs()) * r,
    ]);
    let drag_torque = t10 * params.torque_scale;
    let t11 = Vector([
        sway * added_momentum[2] - heave * added_momentum[1],
        heave * added_momentum[0] - surge * added_momentum[2],
        surge * added_momentum[1] - sway * added_momentum[0],
    ]);
    let moment = Vector([t6 - real(9.81) * t3, real(9.81) * t2 - t5, real(0.0)]) * arm
        - t11 - drag_torque;

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t12 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t12 * t12);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t13 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t13;

    // -- disturbance observer of block 1 (20) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1;

    // -- norms of block 1 --
    let t14 = cos_psi * cos_theta;
    let t15 = cos_psi * sin_theta;
    let t16 = t15 * sin_phi - sin_psi * cos_phi;
    let t17 = t15 * cos_phi + sin_psi * sin_phi;
    let t18 = sin_psi * cos_theta;
    let t19 = sin_psi * sin_theta;
    let t20 = t19 * sin_phi + cos_psi * cos_phi;
    let t21 = t19 * cos_phi - cos_psi * sin_phi;
    let [_, tan_theta, _] = t1.tan().0;
    let t22 = sin_phi * tan_theta;
    let t23 = cos_phi * tan_theta;
    let t24 = real(1.0) / cos_theta;
    let t25 = sin_phi * t24;
    let t26 = cos_phi * t24;
    let t27 = t18 * t18 + t20 * t20 + t21 * t21;
    let t28 = t14 * t14 + t16 * t16 + t17 * t17 + t27;
    let t29 = t28 + (sin_theta * sin_theta + t3 * t3 + t4 * t4);
    let t30 = t29 + (real(1.0) + t22 * t22 + t23 * t23);
    // ||G_1||^2
    let G_norm2_1 = t30 + (cos_phi * cos_phi + sin_phi * sin_phi)
        + (t25 * t25 + t26 * t26);

    // -- robust feedback of block 1 (31) --
    let t31 = T::select(
        E1_free.lt(real(1e-300)),
        real(1.0),
        E1.sin() * cosE1 * (real(1.0) / E1_free),
    ) + real(0.5);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t31 + t13 * real(0.5) + t13 * (real(0.5) * G_norm2_1));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t32 = state.zeta1 * real(5.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t32 - clock.y_r_dot + D_hat1 + Lam1;
    let t33 = Matrix::rows([[t14, t16, t17], [t18, t20, t21], [t2, t3, t4]])
        .solve(Vector([bracket1[0], bracket1[1], bracket1[2]]));
    let t34 = Matrix::rows([[cos_phi, -sin_phi], [t25, t26]])
        .solve(Vector([bracket1[4], bracket1[5]]));
    let t35 = bracket1[3] - t22 * t34[0] - t23 * t34[1];
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -Vector([t33[0], t33[1], t33[2], t35, t34[0], t34[1]]);

    // -- auxiliary system of block 1 (13), erratum 1 --
    let t36 = Vector([
        t14 * state.zeta2[0] + t16 * state.zeta2[1] + t17 * state.zeta2[2],
        t18 * state.zeta2[0] + t20 * state.zeta2[1] + t21 * state.zeta2[2],
        t3 * state.zeta2[1] - sin_theta * state.zeta2[0] + t4 * state.zeta2[2],
        state.zeta2[3] + t22 * state.zeta2[4] + t23 * state.zeta2[5],
        cos_phi * state.zeta2[4] - sin_phi * state.zeta2[5],
        t25 * state.zeta2[4] + t26 * state.zeta2[5],
    ]);
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = t36 - t32;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(10.0);

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
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (49) --
    let t37 = Vector([
        real(-8.0) * e2[0],
        real(5.8) * e2[0],
        real(-8.0) * e2[1],
        real(5.8) * e2[1],
        real(-8.0) * e2[2],
        real(5.8) * e2[2],
        real(-8.0) * e2[3],
        real(5.8) * e2[3],
        real(-8.0) * e2[4],
        real(5.8) * e2[4],
        real(-8.0) * e2[5],
        real(5.8) * e2[5],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + t37;
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([
        w_hat2[1],
        w_hat2[3],
        w_hat2[5],
        w_hat2[7],
        w_hat2[9],
        w_hat2[11],
    ]);

    // -- robust feedback of block 2 (63) --
    let t38 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t38 * state.eps2;
    let t39 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t39 + real(1.0)).sqrt();
    let t40 = G_norm2_1 * s_c1;
    let t41 = prepared.Psi2 / (state.phi2 * state.phi2 + t39);
    let t42 = real(5.25) + s2 * real(3.0) + real(0.5) + t40 * t40 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b)
    // (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38) +
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 + e Psi cos^2 E /
    // (phi^2 + s^2) (64)
    let Lam2 = e2 * (t42 + prepared.Lam2_1 * state.sigma2 * s_scale2 + t41)
        + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t43 = state.zeta2 * real(10.0);
    let t44 = A_hat2 - h1_dot + t43 + D_hat2 + Lam2;
    let t45 = Vector([
        prepared.m_x * t44[0] + real(0.23) * t44[4],
        prepared.m_y * t44[1] + real(-0.23) * t44[3],
        prepared.m_z * t44[2],
        real(-0.23) * t44[1] + prepared.I * t44[3],
        real(0.23) * t44[0] + prepared.I * t44[4],
        prepared.I * t44[5],
    ]);
    let t46 = t45
        + Vector([force[0], force[1], force[2], moment[0], moment[1], moment[2]]);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t46;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-40.0, -40.0, -40.0, -5.0, -5.0, -5.0]))
        .min(Vector::<T, 6>::from_f64([40.0, 40.0, 40.0, 5.0, 5.0, 5.0]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    let t47 = u_sat + t46;
    let t48 = Vector([
        prepared.H_norm2_2_1 * t47[0] + prepared.H_norm2_2_2 * t47[4],
        prepared.H_norm2_2_4 * t47[1] + prepared.H_norm2_2_5 * t47[3],
        prepared.H_norm2_2_7 * t47[2],
        prepared.H_norm2_2_5 * t47[1] + prepared.H_norm2_2_6 * t47[3],
        prepared.H_norm2_2_2 * t47[0] + prepared.H_norm2_2_3 * t47[4],
        prepared.H_norm2_2_8 * t47[5],
    ]);
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = t48 - t43;

    // -- observer dynamics of block 2 (50) --
    let t49 = Vector([
        w_hat2[1],
        real(-0.2) * w_hat2[1] - w_hat2[0],
        w_hat2[3],
        real(-0.2) * w_hat2[3] - w_hat2[2],
        w_hat2[5],
        real(-0.2) * w_hat2[5] - w_hat2[4],
        w_hat2[7],
        real(-0.2) * w_hat2[7] - w_hat2[6],
        w_hat2[9],
        real(-0.2) * w_hat2[9] - w_hat2[8],
        w_hat2[11],
        real(-0.2) * w_hat2[11] - w_hat2[10],
    ]);
    let t50 = Vector([
        real(-8.0) * Lam2[0],
        real(5.8) * Lam2[0],
        real(-8.0) * Lam2[1],
        real(5.8) * Lam2[1],
        real(-8.0) * Lam2[2],
        real(5.8) * Lam2[2],
        real(-8.0) * Lam2[3],
        real(5.8) * Lam2[3],
        real(-8.0) * Lam2[4],
        real(5.8) * Lam2[4],
        real(-8.0) * Lam2[5],
        real(5.8) * Lam2[5],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = t49 + t50;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t38) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = prepared.Lam2_1 * t39 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t41 + real(0.5);

    // -- states of block 1, one sample later --
    let t51 = Vector([
        t14 * surge + t16 * sway + t17 * heave,
        t18 * surge + t20 * sway + t21 * heave,
        t3 * sway - sin_theta * surge + t4 * heave,
        p + t22 * q + t23 * r,
        cos_phi * q - sin_phi * r,
        t25 * q + t26 * r,
    ]);

    // -- states of block 2, one sample later --
    // g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    let th2_step = Vector([
        real(0.0099985222988428) * th2_dot[0]
            + real(0.00044110044503657773) * th2_dot[1],
        real(-4.9011160559619754e-5) * th2_dot[0]
            + real(0.009704455335485081) * th2_dot[1],
        real(0.0099985222988428) * th2_dot[2]
            + real(0.00044110044503657773) * th2_dot[3],
        real(-4.9011160559619754e-5) * th2_dot[2]
            + real(0.009704455335485081) * th2_dot[3],
        real(0.0099985222988428) * th2_dot[4]
            + real(0.00044110044503657773) * th2_dot[5],
        real(-4.9011160559619754e-5) * th2_dot[4]
            + real(0.009704455335485081) * th2_dot[5],
        real(0.0099985222988428) * th2_dot[6]
            + real(0.00044110044503657773) * th2_dot[7],
        real(-4.9011160559619754e-5) * th2_dot[6]
            + real(0.009704455335485081) * th2_dot[7],
        real(0.0099985222988428) * th2_dot[8]
            + real(0.00044110044503657773) * th2_dot[9],
        real(-4.9011160559619754e-5) * th2_dot[8]
            + real(0.009704455335485081) * th2_dot[9],
        real(0.0099985222988428) * th2_dot[10]
            + real(0.00044110044503657773) * th2_dot[11],
        real(-4.9011160559619754e-5) * th2_dot[10]
            + real(0.009704455335485081) * th2_dot[11],
    ]);

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.009754115099857198);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.009516258196404044);
    // th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 + F_1
    // + G_1 x_2 + A_hat_1)
    state.th1 = state.th1 - (D_hat1 + t51) * real(0.009950166250831947);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.009516258196404044);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    state.th2 = state.th2 + th2_step;
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(real(0.999000499833375), P2, c2 * real(0.009995001666250083));
    // eps2(t + dt) = eps2 + g eps2', g = (1 - exp(-a dt))/a, a = iota_20 (66)
    state.eps2 = state.eps2 + real(0.009995001666250083) * eps2_dot;
    // sigma2(t + dt) = sigma2 + g sigma2', g = (1 - exp(-a dt))/a, a = taubar_2 lambda_sigma (67)
    state.sigma2 = state.sigma2 + real(0.009995001666250083) * sigma2_dot;
    // phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >= iota_phi,
    // else phi_2; at least phi_min (68), erratum 11
    state.phi2 = T::select(
            s2.sqrt().ge(real(0.2)),
            state.phi2 * (-(real(0.01) * phi2_decay)).exp(),
            state.phi2,
        )
        .max(prepared.phi2_min);
    ControlOutputs {
        u,
        u_sat,
        violated: violated1,
        y_r: clock.y_r,
        e1,
        k1: clock.k1,
        alpha1,
        D_hat1,
        e2,
        D_hat2,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `pose`, which are numbers in the formulas: `K = 2`, `kbar = 0.5`, `C = 5
/// I`, `Fl = 0.1 s`, `S = I`, `eta_1 = 1`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `velocity`, which are numbers in the formulas: `K = 5`, `kbar = 2`, `C = 10
/// I`, `S = (-8 0 0 0 0 0; 5.8 0 0 0 0 0; 0 -8 0 0 0 0; 0 5.8 0 0 0 0; 0 0 -8 0 0 0; 0 0 5.8 0 0 0; 0 0 0 -8 0 0; 0 0 0 5.8 0 0; 0 0 0 0 -8 0; 0 0 0 0 5.8 0; 0 0 0 0 0 -8; 0 0 0 0 0 5.8)`,
/// `M = (0 1; -1 -0.2) in each channel`, `N = diag((0; 0.1), (0; 0.1), (0; 0.1), (0; 0.2), (0; 0.2),
/// (0; 0.2))`, `L = (0 1) in each channel`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`,
/// `iota_0 = 0.1`, `b = 1`, `eta_noise = 0.1`, `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 1`,
/// `kappa_phi = 0.5`, `iota_phi = 0.2`.
///
/// Operations: 708 additions, 1018 multiplications, 12 divisions, 3 square roots, 26 elementary
/// functions, 19 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 6>,
    x2: Vector<T, 6>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    law(x1, x2, state, params, &prepared, &clock)
}
