// SHA-256 of the text below: e7149a039ef9aea01637357f26335ea2a96228b9047b7c39b01d063b1af51f37
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 31 additions, 76 multiplications, 5 divisions, 0 square roots, 16 elementary functions, 3 comparisons and selections
// control: 279 additions, 423 multiplications, 13 divisions, 3 square roots, 20 elementary functions, 13 comparisons and selections

//! `quadrotor`: control law and sampled controller.
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

/// Largest magnitude of each control: `roll_torque` in kg*m^2/s^2, `pitch_torque` in
/// kg*m^2/s^2, `yaw_torque` in kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 3] = [0.2, 0.2, 0.05];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.002;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 3] = [0.0, 0.0, 0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): attitude (phi, theta, psi).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 3>,
    /// Auxiliary anti-windup state zeta (13): rates (p, q, r).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 3>,
    /// Filtered virtual control h (33): rates (p, q, r).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 3>,
    /// Network weights W_hat, one row per monomial and one column per channel: rates (p, q, r).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, p, q, r, p2, p_q, p_r, q2, q_r, r2, p3, p2_q, p2_r, p_q2, p_q_r, p_r2, q3, q2_r,
    /// q_r2, r3`.
    pub W2: Matrix<T, 20, 3>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// rates (p, q, r).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
    /// M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)`
    pub th2: Vector<T, 8>,
    /// Bound eps_hat of the approximation error (66): rates (p, q, r).
    ///
    /// `eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)`
    pub eps2: T,
    /// Bound sigma_hat of the noise intensity (67): rates (p, q, r).
    ///
    /// `sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
    /// varsigma_2^2)) - lambda_sigma sigma_hat_2)`
    pub sigma2: T,
    /// Noise term phi (68), kept positive: rates (p, q, r).
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
    pub u: Vector<T, 3>,
    /// Control to apply: within its limits, always finite.
    pub u_sat: Vector<T, 3>,
    /// `y_r(t)`
    pub y_r: Vector<T, 3>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 3>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 3>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 3>,
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 3>,
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
            e2: Vector::zero(),
            D_hat2: Vector::zero(),
        }
    }
}

/// Quadrotor attitude in gusts
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
    pub fn reset(&mut self, t: T, x1: Vector<T, 3>, x2: Vector<T, 3>) {
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
    pub fn step(&mut self, t: T, x1: Vector<T, 3>, x2: Vector<T, 3>) -> Output<T> {
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
        x1: Vector<T, 3>,
        x2: Vector<T, 3>,
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
        let law = law(x1, x2, &mut self.state, &self.prepared, clock);
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
        let saturated = u[0].ne(u_sat[0]).or(u[1].ne(u_sat[1])).or(u[2].ne(u_sat[2]));
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
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
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
/// Operations: 31 additions, 76 multiplications, 5 divisions, 0 square roots, 16 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(t: T, x1: Vector<T, 3>, x2: Vector<T, 3>) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let phi = x1[0];
    let theta = x1[1];

    // -- known dynamics of block 1 (attitude) (11) --
    let t1 = Vector([phi, theta]);
    let [sin_phi, _] = t1.sin().0;
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

    // -- reference and constraints --
    let t8 = real(2.0) * t;
    let t9 = real(0.5) * t;
    let t10 = real(3.0) * t;
    let t11 = Vector([t8, t10, t9]);
    let [sin_t8, sin_t10, sin_t9] = t11.sin().0;
    let t12 = real(0.6108652381980153) * sin_t8;
    let t13 = t * t;
    let t14 = (real(-0.1) * (t13 * t)).exp();
    let t15 = real(1.0) - t14;
    let t16 = real(0.4363323129985824) * sin_t10;
    let t17 = real(FRAC_PI_2) * sin_t9;
    // y_r(t)
    let y_r = Vector([t12 * t15, t16 * t15, t17 * t15]);
    let [cos_t8, cos_t10, cos_t9] = t11.cos().0;
    let t18 = t14 * (real(-0.1) * (real(3.0) * t13));
    // y_r'
    let y_r_dot = Vector([
        t15 * (real(0.6108652381980153) * (cos_t8 * real(2.0))) - t12 * t18,
        t15 * (real(0.4363323129985824) * (cos_t10 * real(3.0))) - t16 * t18,
        t15 * (real(FRAC_PI_2) * (cos_t9 * real(0.5))) - t17 * t18,
    ]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.04);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 3> = Vector::zero();
    let zeta2: Vector<T, 3> = Vector::zero();
    let W2: Matrix<T, 20, 3> = Matrix::zero();
    let eps2 = real(0.0);
    let sigma2 = real(0.0);
    let phi2 = real(10.0);

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t19 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t19 * t19);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) --
    let t20 = real(3.5)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(2.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t20 + s1 * sec2E1 * (real(0.5) * G_norm2_1));

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = Lam1 - y_r_dot;
    let t21 = Matrix::rows([[cos_phi, t4], [t6, t7]])
        .solve(Vector([bracket1[1], bracket1[2]]));
    let t22 = bracket1[0] - t2 * t21[0] - t3 * t21[1];
    let t23 = Vector([t22, t21[0], t21[1]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t23;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + t23;

    // -- given --
    let t24 = real(14.6) * e2[0];
    let t25 = real(23.0) * e2[0];
    let t26 = real(14.0) * e2[0];
    let t27 = real(14.6) * e2[1];
    let t28 = real(23.0) * e2[1];
    let t29 = real(14.0) * e2[1];
    let t30 = real(8.0) * e2[2];
    let t31 = -e2[2];
    let th2 = -Vector([t24, t25, t26, t27, t28, t29, t30, t31]);
    State {
        zeta1,
        zeta2,
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
    /// Part of `F2`.
    pub F2_1: T,
    /// Part of `F2`.
    pub F2_2: T,
    /// Part of `F2`.
    pub F2_3: T,
    /// Part of `F2`.
    pub F2_4: T,
    /// Part of `F2`.
    pub F2_5: T,
    /// Part of `F2`.
    pub F2_6: T,
    /// `Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)`
    pub Psi2: T,
    /// Part of `Lam2`.
    pub Lam2_1: T,
    /// Part of `u`.
    pub u_1: Vector<T, 3>,
    /// `phi_min = sqrt(Psi_2 dt / 0.1), erratum 11`
    pub phi2_min: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 14 additions, 30 multiplications, 6 divisions, 1 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let J_y = params.pitch_scale * real(0.00368);
    let J_z = params.yaw_scale * real(0.00703);
    let J_x = params.roll_scale * real(0.00365);

    // -- noise terms of block 2 (58) (62) --
    // ||Ybar_2||^2
    let Ybar_square2 = real(27.0);
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(5.196152422706632);
    let F2_1 = J_y - J_z;
    let F2_2 = real(1.0) / J_x;
    let F2_3 = J_z - J_x;
    let F2_4 = real(1.0) / J_y;
    let F2_5 = J_x - J_y;
    let F2_6 = real(1.0) / J_z;

    // -- noise terms of block 2 (58) (62) --
    let t1 = real(0.0001) * F2_2;
    let t2 = real(0.0001) * F2_4;
    let t3 = real(0.0001) * F2_6;
    let t4 = t3 * t3;
    // ||H_2||^2
    let H_norm2_2 = t1 * t1 + t2 * t2 + t4;
    let t5 = real(14.6) * t1;
    let t6 = real(23.0) * t1;
    let t7 = real(14.0) * t1;
    let t8 = real(14.6) * t2;
    let t9 = real(23.0) * t2;
    let t10 = real(14.0) * t2;
    let t11 = real(8.0) * t3;
    let t12 = t5 * t5 + t6 * t6 + t7 * t7 + t8 * t8;
    // ||S_2 H_2||^2
    let SH_norm2_2 = t12 + t9 * t9 + t10 * t10 + t11 * t11 + t4;
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(20.5)
        + real(0.01) * (SH_norm2_2 * SH_norm2_2);

    // -- states of block 2, one sample later --
    // phi_min = sqrt(Psi_2 dt / 0.1), erratum 11
    let phi2_min = (Psi2 * real(0.02)).sqrt();
    let Lam2_1 = H_norm2_2 * Ybar_norm2;
    let u_1 = Vector::splat(real(1.0)).quotient(Vector([F2_2, F2_4, F2_6]));
    Prepared {
        F2_1,
        F2_2,
        F2_3,
        F2_4,
        F2_5,
        F2_6,
        Psi2,
        Lam2_1,
        u_1,
        phi2_min,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `y_r(t)`
    pub y_r: Vector<T, 3>,
    /// `y_r'`
    pub y_r_dot: Vector<T, 3>,
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
/// Operations: 5 additions, 30 multiplications, 1 divisions, 0 square roots, 8 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(2.0) * t;
    let t2 = real(0.5) * t;
    let t3 = real(3.0) * t;
    let t4 = Vector([t1, t3, t2]);
    let [sin_t1, sin_t3, sin_t2] = t4.sin().0;
    let t5 = real(0.6108652381980153) * sin_t1;
    let t6 = t * t;
    let t7 = (real(-0.1) * (t6 * t)).exp();
    let t8 = real(1.0) - t7;
    let t9 = real(0.4363323129985824) * sin_t3;
    let t10 = real(FRAC_PI_2) * sin_t2;
    // y_r(t)
    let y_r = Vector([t5 * t8, t9 * t8, t10 * t8]);
    let [cos_t1, cos_t3, cos_t2] = t4.cos().0;
    let t11 = t7 * (real(-0.1) * (real(3.0) * t6));
    // y_r'
    let y_r_dot = Vector([
        t8 * (real(0.6108652381980153) * (cos_t1 * real(2.0))) - t5 * t11,
        t8 * (real(0.4363323129985824) * (cos_t3 * real(3.0))) - t9 * t11,
        t8 * (real(FRAC_PI_2) * (cos_t2 * real(0.5))) - t10 * t11,
    ]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.04);
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
    pub u: Vector<T, 3>,
    /// `sat(u), each component limited to +-u_max (8)`
    pub u_sat: Vector<T, 3>,
    /// `E_1 >= pi/2 - delta`
    pub violated: T::Mask,
    /// `y_r(t)`
    pub y_r: Vector<T, 3>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 3>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 3>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 3>,
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 3>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `attitude`, which are numbers in the formulas: `K = 6`, `kbar = 2`, `C = 20
/// I`, `Fl = 0.01 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 20`, `kbar = 10`, `C = 50
/// I`, `S = (14.6 0 0; 23 0 0; 14 0 0; 0 14.6 0; 0 23 0; 0 14 0; 0 0 8; 0 0 -1)`, `M =
/// diag((-0.2 12 0; -12 -0.2 0; 0 0 -1), (-0.2 12 0; -12 -0.2 0; 0 0 -1), diag(0, -3))`, `N =
/// diag((1 0; 0 0; 0 2), (1 0; 0 0; 0 2), (0; 0.5))`, `L = diag((1 0 1), (1 0 1), (1 1))`,
/// `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`, `iota_0 = 0.1`, `b = 1`, `eta_noise = 0.01`,
/// `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 1`, `kappa_phi = 0.5`, `iota_phi = 0.2`.
///
/// Operations: 260 additions, 363 multiplications, 6 divisions, 2 square roots, 12 elementary
/// functions, 13 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    state: &mut State<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let phi = x1[0];
    let theta = x1[1];
    let q = x2[1];
    let r = x2[2];
    let p = x2[0];

    // -- known dynamics of block 1 (attitude) (11) --
    let t1 = Vector([phi, theta]);
    let [sin_phi, _] = t1.sin().0;
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
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        prepared.F2_1 * q * r * prepared.F2_2,
        prepared.F2_3 * p * r * prepared.F2_4,
        prepared.F2_5 * p * q * prepared.F2_6,
    ]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t8 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t8 * t8);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t9 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t9;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) --
    let t10 = real(3.5)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(2.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t10 + t9 * (real(0.5) * G_norm2_1));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t11 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t11 - clock.y_r_dot + Lam1;
    let t12 = Matrix::rows([[cos_phi, t4], [t6, t7]])
        .solve(Vector([bracket1[1], bracket1[2]]));
    let t13 = bracket1[0] - t2 * t12[0] - t3 * t12[1];
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -Vector([t13, t12[0], t12[1]]);

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = G1 * state.zeta2 - t11;

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
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (49) --
    let t14 = Vector([
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
    let w_hat2 = state.th2 + t14;
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([
        w_hat2[0] + w_hat2[2],
        w_hat2[3] + w_hat2[5],
        w_hat2[6] + w_hat2[7],
    ]);

    // -- robust feedback of block 2 (63) --
    let t15 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t15 * state.eps2;
    let t16 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t16 + real(1.0)).sqrt();
    let t17 = G_norm2_1 * s_c1;
    let t18 = prepared.Psi2 / (state.phi2 * state.phi2 + t16);
    let t19 = real(25.0) + s2 * real(3.0) + real(0.5) + t17 * t17 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b)
    // (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38) +
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 + e Psi cos^2 E /
    // (phi^2 + s^2) (64)
    let Lam2 = e2 * (t19 + prepared.Lam2_1 * state.sigma2 * s_scale2 + t18)
        + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t20 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + A_hat2 - h1_dot + t20 + D_hat2 + Lam2;
    let t21 = bracket2.hadamard(prepared.u_1);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t21;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 3>::from_f64([-0.2, -0.2, -0.05]))
        .min(Vector::<T, 3>::from_f64([0.2, 0.2, 0.05]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    let t22 = u_sat + t21;
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = Vector([
        prepared.F2_2 * t22[0],
        prepared.F2_4 * t22[1],
        prepared.F2_6 * t22[2],
    ]) - t20;

    // -- observer dynamics of block 2 (50) --
    let t23 = Vector([
        real(-0.2) * w_hat2[0] + real(12.0) * w_hat2[1],
        real(-12.0) * w_hat2[0] + real(-0.2) * w_hat2[1],
        -w_hat2[2],
        real(-0.2) * w_hat2[3] + real(12.0) * w_hat2[4],
        real(-12.0) * w_hat2[3] + real(-0.2) * w_hat2[4],
        -w_hat2[5],
        real(0.0),
        real(-3.0) * w_hat2[7],
    ]);
    let t24 = Vector([
        real(14.6) * Lam2[0],
        real(23.0) * Lam2[0],
        real(14.0) * Lam2[0],
        real(14.6) * Lam2[1],
        real(23.0) * Lam2[1],
        real(14.0) * Lam2[1],
        real(8.0) * Lam2[2],
        -Lam2[2],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = t23 + t24;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t15) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = prepared.Lam2_1 * t16 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t18 + real(0.5);

    // -- states of block 2, one sample later --
    // g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    let th2_step = Vector([
        real(0.0019704072450943437) * th2_dot[0]
            + real(2.3760064293746006e-5) * th2_dot[1]
            + real(-2.8986780435574954e-5) * th2_dot[2],
        real(-6.887725507835615e-5) * th2_dot[0]
            + real(0.001999046853157618) * th2_dot[1]
            + real(-4.486290593564899e-5) * th2_dot[2],
        real(-2.744792717515158e-5) * th2_dot[0]
            + real(-2.2066040612331694e-7) * th2_dot[1]
            + real(0.001970566782864293) * th2_dot[2],
        real(0.0019704072450943437) * th2_dot[3]
            + real(2.3760064293746006e-5) * th2_dot[4]
            + real(-2.8986780435574954e-5) * th2_dot[5],
        real(-6.887725507835615e-5) * th2_dot[3]
            + real(0.001999046853157618) * th2_dot[4]
            + real(-4.486290593564899e-5) * th2_dot[5],
        real(-2.744792717515158e-5) * th2_dot[3]
            + real(-2.2066040612331694e-7) * th2_dot[4]
            + real(0.001970566782864293) * th2_dot[5],
        real(0.0019840744219549776) * th2_dot[6]
            + real(-1.589373755972973e-5) * th2_dot[7],
        real(1.9867171949662163e-6) * th2_dot[6]
            + real(0.001995994725124775) * th2_dot[7],
    ]);

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.0019605280423838395);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0018126924692201815);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0019032516392808085);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    state.th2 = state.th2 + th2_step;
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(real(0.9998000199986667), P2, c2 * real(0.001999800013332667));
    // eps2(t + dt) = eps2 + g eps2', g = (1 - exp(-a dt))/a, a = iota_20 (66)
    state.eps2 = state.eps2 + real(0.001999800013332667) * eps2_dot;
    // sigma2(t + dt) = sigma2 + g sigma2', g = (1 - exp(-a dt))/a, a = taubar_2 lambda_sigma (67)
    state.sigma2 = state.sigma2 + real(0.001999800013332667) * sigma2_dot;
    // phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >= iota_phi,
    // else phi_2; at least phi_min (68), erratum 11
    state.phi2 = T::select(
            s2.sqrt().ge(real(0.2)),
            state.phi2 * (-(real(0.002) * phi2_decay)).exp(),
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
        e2,
        D_hat2,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `attitude`, which are numbers in the formulas: `K = 6`, `kbar = 2`, `C = 20
/// I`, `Fl = 0.01 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 20`, `kbar = 10`, `C = 50
/// I`, `S = (14.6 0 0; 23 0 0; 14 0 0; 0 14.6 0; 0 23 0; 0 14 0; 0 0 8; 0 0 -1)`, `M =
/// diag((-0.2 12 0; -12 -0.2 0; 0 0 -1), (-0.2 12 0; -12 -0.2 0; 0 0 -1), diag(0, -3))`, `N =
/// diag((1 0; 0 0; 0 2), (1 0; 0 0; 0 2), (0; 0.5))`, `L = diag((1 0 1), (1 0 1), (1 1))`,
/// `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`, `iota_0 = 0.1`, `b = 1`, `eta_noise = 0.01`,
/// `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 1`, `kappa_phi = 0.5`, `iota_phi = 0.2`.
///
/// Operations: 279 additions, 423 multiplications, 13 divisions, 3 square roots, 20 elementary
/// functions, 13 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    law(x1, x2, state, &prepared, &clock)
}
