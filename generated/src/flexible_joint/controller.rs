// SHA-256 of the text below: e96d1f2ef71b08fbf38f92c0f3059dd34268fac13e1b4308e9fd852cda9a17b3
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 17 additions, 52 multiplications, 4 divisions, 0 square roots, 7 elementary functions, 3 comparisons and selections
// control: 83 additions, 120 multiplications, 4 divisions, 0 square roots, 7 elementary functions, 6 comparisons and selections

//! `flexible_joint`: control law and sampled controller.
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

/// Largest magnitude of each control: `torque` in kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 1] = [3.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.0005;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 1] = [0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): link_angle (q1).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): link_rate (v1).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 zeta_3`
    pub zeta2: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): motor_angle (q2).
    ///
    /// `zeta_3' = -C_3 zeta_3 + G_3 zeta_4`
    pub zeta3: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): motor_rate (v2).
    ///
    /// `zeta_4' = -C_4 zeta_4 + G_4 (sat(u) - u)`
    pub zeta4: Vector<T, 1>,
    /// Filtered virtual control h (33): link_rate (v1).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 1>,
    /// Network weights W_hat, one row per monomial and one column per channel: link_rate (v1).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (32): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, z1, v1, z12, z1_v1, v12`.
    pub W2: Matrix<T, 6, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// link_rate (v1).
    ///
    /// `th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 (21): th_2' = -S_2 (D_hat_2 +
    /// F_2 + G_2 x_3 + A_hat_2)`
    pub th2: Vector<T, 1>,
    /// Filtered virtual control h (33): motor_angle (q2).
    ///
    /// `h_2' = (alpha_2 - h_2) / Fl_2`
    pub h2: Vector<T, 1>,
    /// Filtered virtual control h (33): motor_rate (v2).
    ///
    /// `h_3' = (alpha_3 - h_3) / Fl_3`
    pub h3: Vector<T, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// motor_rate (v2).
    ///
    /// `th_4' = (M_4 - S_4 L_4) w_hat_4 - S_4 (F_4 + G_4 u - h_3' + C_4 zeta_4 + A_hat_4) (50) =
    /// M_4 w_hat_4 + S_4 Lam_4, since the sum in brackets is -(D_hat_4 + Lam_4) under (64)`
    pub th4: Vector<T, 3>,
}

impl<T: Real> State<T> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            zeta1: Vector::zero(),
            zeta2: Vector::zero(),
            zeta3: Vector::zero(),
            zeta4: Vector::zero(),
            h1: Vector::zero(),
            W2: Matrix::zero(),
            th2: Vector::zero(),
            h2: Vector::zero(),
            h3: Vector::zero(),
            th4: Vector::zero(),
        }
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: &Self, b: &Self) -> Self {
        Self {
            zeta1: Vector::select(mask, a.zeta1, b.zeta1),
            zeta2: Vector::select(mask, a.zeta2, b.zeta2),
            zeta3: Vector::select(mask, a.zeta3, b.zeta3),
            zeta4: Vector::select(mask, a.zeta4, b.zeta4),
            h1: Vector::select(mask, a.h1, b.h1),
            W2: Matrix::select(mask, a.W2, b.W2),
            th2: Vector::select(mask, a.th2, b.th2),
            h2: Vector::select(mask, a.h2, b.h2),
            h3: Vector::select(mask, a.h3, b.h3),
            th4: Vector::select(mask, a.th4, b.th4),
        }
    }

    /// Whether every entry is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        self.zeta1
            .is_finite()
            .and(self.zeta2.is_finite())
            .and(self.zeta3.is_finite())
            .and(self.zeta4.is_finite())
            .and(self.h1.is_finite())
            .and(self.W2.is_finite())
            .and(self.th2.is_finite())
            .and(self.h2.is_finite())
            .and(self.h3.is_finite())
            .and(self.th4.is_finite())
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
    pub u: Vector<T, 1>,
    /// Control to apply: within its limits, always finite.
    pub u_sat: Vector<T, 1>,
    /// `y_r(t)`
    pub y_r: Vector<T, 1>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 1>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub alpha2: Vector<T, 1>,
    /// `D_hat_2 = th_2 + S_2 x_2`
    pub D_hat2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
    /// `alpha_3 = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]`
    pub alpha3: Vector<T, 1>,
    /// `e_4 = x_4 - h_3 - zeta_4`
    pub e4: Vector<T, 1>,
    /// `D_hat_4 = L_4 w_hat_4`
    pub D_hat4: Vector<T, 1>,
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
            alpha2: Vector::zero(),
            D_hat2: Vector::zero(),
            e3: Vector::zero(),
            alpha3: Vector::zero(),
            e4: Vector::zero(),
            D_hat4: Vector::zero(),
        }
    }
}

/// Robot link with an elastic joint
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
    pub fn reset(
        &mut self,
        t: T,
        x1: Vector<T, 1>,
        x2: Vector<T, 1>,
        x3: Vector<T, 1>,
        x4: Vector<T, 1>,
    ) {
        self.state = State::zero();
        self.started = T::Mask::splat(false);
        let mask = t
            .is_finite()
            .and(x1.is_finite())
            .and(x2.is_finite())
            .and(x3.is_finite())
            .and(x4.is_finite());
        T::outlined(Begin {
            controller: self,
            mask,
            t,
            x1,
            x2,
            x3,
            x4,
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
    pub fn step(
        &mut self,
        t: T,
        x1: Vector<T, 1>,
        x2: Vector<T, 1>,
        x3: Vector<T, 1>,
        x4: Vector<T, 1>,
    ) -> Output<T> {
        let clock = clock(t);
        self.step_at(t, &clock, x1, x2, x3, x4)
    }

    /// As [`Controller::step`], with the values of [`clock`] at this time, which can serve many
    /// runs.
    #[inline(always)]
    pub fn step_at(
        &mut self,
        t: T,
        clock: &Clock<T>,
        x1: Vector<T, 1>,
        x2: Vector<T, 1>,
        x3: Vector<T, 1>,
        x4: Vector<T, 1>,
    ) -> Output<T> {
        let measured = t
            .is_finite()
            .and(x1.is_finite())
            .and(x2.is_finite())
            .and(x3.is_finite())
            .and(x4.is_finite());
        let starting = measured.and(self.started.not());
        if starting.any() {
            T::outlined(Begin {
                controller: self,
                mask: starting,
                t,
                x1,
                x2,
                x3,
                x4,
            });
        }
        let before = if measured.all() { None } else { Some(self.state) };
        let law = law(
            x1,
            x2,
            x3,
            x4,
            &mut self.state,
            &self.params,
            &self.prepared,
            clock,
        );
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
        let saturated = u[0].ne(u_sat[0]);
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
            alpha2: law.alpha2,
            D_hat2: law.D_hat2,
            e3: law.e3,
            alpha3: law.alpha3,
            e4: law.e4,
            D_hat4: law.D_hat4,
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
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    x4: Vector<T, 1>,
}
impl<T: Real> Part for Begin<'_, T> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let start = initial(
            self.t,
            self.x1,
            self.x2,
            self.x3,
            self.x4,
            &self.controller.params,
        );
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
            x3: Vector::zero(),
            x4: Vector::zero(),
        });
        controller.started = controller.started.and(mask.not());
    }
}

/// The controller's states at its first sample.
///
/// Operations: 17 additions, 52 multiplications, 4 divisions, 0 square roots, 7 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    x4: Vector<T, 1>,
    params: &Params<T>,
) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let q1 = x1[0];

    // -- known dynamics of block 2 (link_rate) (11) --
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        -(params.weight * q1.sin() + params.stiffness * q1) * real(32.25806451612903),
    ]);
    let t1 = params.stiffness * real(32.25806451612903);
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t1]]);

    // -- reference and constraints --
    let t2 = real(1.0471975511965979) * t.sin();
    let t3 = t * t;
    let t4 = (real(-0.1) * (t3 * t)).exp();
    let t5 = real(1.0) - t4;
    // y_r(t)
    let y_r = Vector([t2 * t5]);
    // y_r'
    let y_r_dot = Vector([
        t5 * (real(1.0471975511965979) * t.cos())
            - t2 * (t4 * (real(-0.1) * (real(3.0) * t3))),
    ]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.05);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 1> = Vector::zero();
    let zeta2: Vector<T, 1> = Vector::zero();
    let W2: Matrix<T, 6, 1> = Matrix::zero();
    let th2 = -(x2 * real(40.0));
    let zeta3: Vector<T, 1> = Vector::zero();
    let zeta4: Vector<T, 1> = Vector::zero();

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t6 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t6 * t6);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t7 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t7;

    // -- robust feedback of block 1 (31) --
    let t8 = real(5.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(4.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t8 + t7 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = Lam1 - y_r_dot;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + bracket1;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2;

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();

    // -- robust feedback of block 2 (31) --
    let t9 = real(34.5) + s2 * real(0.5) + s2 * (real(5e-5) * G_norm2_2)
        + s_c1 * s_c1 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E)
    // e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2 = e2 * t9;
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + Lam2;
    let t10 = bracket2 * (real(1.0) / t1);
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -t10;

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 + t10;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();

    // -- robust feedback of block 3 (31) --
    let t11 = G_norm2_2 * s_c2;
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G,
    // c, eta_3 of the outer block (38)
    let Lam3 = e3 * (real(100.0) + s3 * real(0.5) + t11 * t11 * real(2.5e-9));

    // -- virtual control (31) of block 3 --
    // alpha_3 = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let alpha3 = -Lam3;

    // -- error variable of block 4 (14) --
    // e_4 = x_4 - h_3 - zeta_4
    let e4 = x4 + Lam3;

    // -- disturbance observer of block 4 (49) --
    // S_4, observer gain
    let S4: Matrix<T, 3, 1> = Matrix::from_f64([[40.0], [20.0], [60.0]]);

    // -- given --
    let th4 = -(S4 * e4);
    State {
        zeta1,
        zeta2,
        zeta3,
        zeta4,
        h1: alpha1,
        W2,
        th2,
        h2: alpha2,
        h3: alpha3,
        th4,
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `G_2(x_1 .. x_2)`
    pub G2: Matrix<T, 1, 1>,
    /// `||G_2||^2`
    pub G_norm2_2: T,
    /// Part of `Lam2`.
    pub Lam2_1: T,
    /// Part of `alpha2`.
    pub alpha2_1: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 3 multiplications, 1 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- known dynamics of block 2 (link_rate) (11) --
    let t1 = params.stiffness * real(32.25806451612903);
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t1]]);

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();
    let Lam2_1 = real(5e-5) * G_norm2_2;
    let alpha2_1 = real(1.0) / t1;
    Prepared {
        G2,
        G_norm2_2,
        Lam2_1,
        alpha2_1,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `y_r(t)`
    pub y_r: Vector<T, 1>,
    /// `y_r'`
    pub y_r_dot: Vector<T, 1>,
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
/// Operations: 3 additions, 14 multiplications, 1 divisions, 0 square roots, 4 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(1.0471975511965979) * t.sin();
    let t2 = t * t;
    let t3 = (real(-0.1) * (t2 * t)).exp();
    let t4 = real(1.0) - t3;
    // y_r(t)
    let y_r = Vector([t1 * t4]);
    // y_r'
    let y_r_dot = Vector([
        t4 * (real(1.0471975511965979) * t.cos())
            - t1 * (t3 * (real(-0.1) * (real(3.0) * t2))),
    ]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.05);
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
    /// `u = -G_4^-1 [ F_4 + A_hat_4 - h_3' + C_4 zeta_4 + D_hat_4 + Lam_4 ]`
    pub u: Vector<T, 1>,
    /// `sat(u), each component limited to +-u_max (8)`
    pub u_sat: Vector<T, 1>,
    /// `E_1 >= pi/2 - delta`
    pub violated: T::Mask,
    /// `y_r(t)`
    pub y_r: Vector<T, 1>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 1>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub alpha2: Vector<T, 1>,
    /// `D_hat_2 = th_2 + S_2 x_2`
    pub D_hat2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
    /// `alpha_3 = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]`
    pub alpha3: Vector<T, 1>,
    /// `e_4 = x_4 - h_3 - zeta_4`
    pub e4: Vector<T, 1>,
    /// `D_hat_4 = L_4 w_hat_4`
    pub D_hat4: Vector<T, 1>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `link_angle`, which are numbers in the formulas: `K = 4`, `kbar = 4`, `C = 20`,
/// `Fl = 0.01 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `link_rate`, which are numbers in the formulas: `K = 10`, `kbar = 16`, `C = 50`,
/// `Fl = 0.002 s`, `S = 40`, `eta_1 = 1`, `eta_2 = 0.0001`, `eta_3 = 100`, `Gamma = 1`, `lambda = 0.1`,
/// `iota = 1`.
///
/// Gains of block 3, `motor_angle`, which are numbers in the formulas: `K = 40`, `kbar = 45`,
/// `C = 100`, `Fl = 0.001 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 4, `motor_rate`, which are numbers in the formulas: `K = 100`, `kbar = 120`,
/// `C = 200`, `S = (40; 20; 60)`, `M = (0 0 0; 0 0 20; 0 -20 0)`, `L = (1 1 0)`, `eta_1 = 1`.
///
/// Operations: 80 additions, 103 multiplications, 2 divisions, 0 square roots, 3 elementary
/// functions, 6 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    x4: Vector<T, 1>,
    state: &mut State<T>,
    params: &Params<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let q1 = x1[0];
    let v2 = x4[0];
    let q2 = x3[0];
    let v1 = x2[0];

    // -- known dynamics of block 2 (link_rate) (11) --
    let t1 = q1.sin();
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        -(params.weight * t1 + params.stiffness * q1) * real(32.25806451612903),
    ]);

    // -- known dynamics of block 4 (motor_rate) (11) --
    // F_4(x_1 .. x_4)
    let F4 = Vector([-(real(0.007) * v2 + params.stiffness * (q2 - q1)) * real(250.0)]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t2 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t2 * t2);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t3 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t3;

    // -- robust feedback of block 1 (31) --
    let t4 = real(5.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(4.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t4 + t3 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t5 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t5 - clock.y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t5;

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
    // z_2, network inputs
    let z2 = Vector([t1, v1]);
    // P_2 = P_m(z_2), 6 nodes
    let P2 = polynomials::basis2(z2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (20) --
    // D_hat_2 = th_2 + S_2 x_2
    let D_hat2 = state.th2 + x2 * real(40.0);

    // -- robust feedback of block 2 (31) --
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E)
    // e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2 = e2
        * (real(34.5) + s2 * real(0.5) + s2 * prepared.Lam2_1
            + s_c1 * s_c1 * real(0.25));
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t6 = F2 + A_hat2;
    let t7 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t6 - h1_dot + t7 + D_hat2 + Lam2;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -(bracket2 * prepared.alpha2_1);

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = prepared.G2 * state.zeta3 - t7;

    // -- dynamic surface filter of block 2 (33) --
    // h_2' = (alpha_2 - h_2) / Fl_2
    let h2_dot = (alpha2 - state.h2) * real(500.0);

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 - state.h2 - state.zeta3;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();
    // c_3 = s_3 e_3^T / cos^2 E_3
    let c3 = e3 * s3;

    // -- robust feedback of block 3 (31) --
    let t8 = prepared.G_norm2_2 * s_c2;
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G,
    // c, eta_3 of the outer block (38)
    let Lam3 = e3 * (real(100.0) + s3 * real(0.5) + t8 * t8 * real(2.5e-9));
    // ||c_3||^2
    let s_c3 = c3.sum_squares();

    // -- virtual control (31) of block 3 --
    let t9 = state.zeta3 * real(100.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = t9 - h2_dot + Lam3;
    // alpha_3 = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let alpha3 = -bracket3;

    // -- auxiliary system of block 3 (13), erratum 1 --
    // zeta_3' = -C_3 zeta_3 + G_3 zeta_4
    let zeta3_dot = state.zeta4 - t9;

    // -- dynamic surface filter of block 3 (33) --
    // h_3' = (alpha_3 - h_3) / Fl_3
    let h3_dot = (alpha3 - state.h3) * real(1000.0);

    // -- error variable of block 4 (14) --
    // e_4 = x_4 - h_3 - zeta_4
    let e4 = x4 - state.h3 - state.zeta4;

    // -- barrier of block 4 (23) (26) --
    // s_4 = e_4^T e_4
    let s4 = e4.sum_squares();

    // -- disturbance observer of block 4 (49) --
    // S_4, observer gain
    let S4: Matrix<T, 3, 1> = Matrix::from_f64([[40.0], [20.0], [60.0]]);
    // w_hat_4 = th_4 + S_4 e_4
    let w_hat4 = state.th4 + S4 * e4;
    // L_4
    let L4: Matrix<T, 1, 3> = Matrix::from_f64([[1.0, 1.0, 0.0]]);
    // D_hat_4 = L_4 w_hat_4
    let D_hat4 = L4 * w_hat4;

    // -- robust feedback of block 4 (63) --
    // Lam_4 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4),
    // G, c, eta_3 of the outer block (38)
    let Lam4 = e4 * (real(265.0) + s4 + s_c3 * s_c3 * real(0.25));

    // -- control (64) of block 4 --
    let t10 = state.zeta4 * real(200.0);
    // F_4 + A_hat_4 - h_3' + C_4 zeta_4 + D_hat_4 + Lam_4
    let bracket4 = F4 - h3_dot + t10 + D_hat4 + Lam4;
    let t11 = bracket4 * real(0.004);
    // u = -G_4^-1 [ F_4 + A_hat_4 - h_3' + C_4 zeta_4 + D_hat_4 + Lam_4 ]
    let u = -t11;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-3.0))).min(Vector::splat(real(3.0)));

    // -- auxiliary system of block 4 (13), erratum 1 --
    // zeta_4' = -C_4 zeta_4 + G_4 (sat(u) - u)
    let zeta4_dot = (u_sat + t11) * real(250.0) - t10;

    // -- observer dynamics of block 4 (50) --
    // th_4' = (M_4 - S_4 L_4) w_hat_4 - S_4 (F_4 + G_4 u - h_3' + C_4 zeta_4 + A_hat_4) (50) = M_4
    // w_hat_4 + S_4 Lam_4, since the sum in brackets is -(D_hat_4 + Lam_4) under (64)
    let th4_dot = Vector([real(0.0), real(20.0) * w_hat4[2], real(-20.0) * w_hat4[1]])
        + S4 * Lam4;

    // -- states of block 4, one sample later --
    // g(S_4 L_4 - M_4)
    let th4_weight: Matrix<T, 3, 3> = Matrix::from_f64([
        [0.000495049750665833, -4.950207916806941e-6, -1.6542082639089032e-8],
        [-2.4999170823621035e-6, 0.0004974917704589582, 2.4916460410425596e-6],
        [-7.417040833890866e-6, -9.916957916252972e-6, 0.0004999668744173617],
    ]);
    // g th4', g = (1 - exp(-a dt))/a, a = S_4 L_4 - M_4 (50)
    let th4_step = th4_weight * th4_dot;

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.0004975083125415973);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0004877057549928599);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0004938017594333467);
    // h2(t + dt) = h2 + g h2', g = (1 - exp(-a dt))/a, a = 1/Fl_2 (33)
    state.h2 = state.h2 + h2_dot * real(0.00044239843385719023);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 (21): th_2' = -S_2 (D_hat_2 + F_2
    // + G_2 x_3 + A_hat_2)
    state.th2 = state.th2
        - (D_hat2 + t6 + prepared.G2 * x3) * real(40.0) * real(0.0004950331673311175);
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (32): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(real(0.9999500012499791), P2, c2 * real(0.0004999875002083307));

    // -- states of block 3, one sample later --
    // zeta3(t + dt) = zeta3 + g zeta3', g = (1 - exp(-a dt))/a, a = C_3 (13)
    state.zeta3 = state.zeta3 + zeta3_dot * real(0.0004877057549928599);
    // h3(t + dt) = h3 + g h3', g = (1 - exp(-a dt))/a, a = 1/Fl_3 (33)
    state.h3 = state.h3 + h3_dot * real(0.00039346934028736656);

    // -- states of block 4, one sample later --
    // zeta4(t + dt) = zeta4 + g zeta4', g = (1 - exp(-a dt))/a, a = C_4 (13)
    state.zeta4 = state.zeta4 + zeta4_dot * real(0.00047581290982020213);
    // th4(t + dt) = th4 + g th4', g = (1 - exp(-a dt))/a, a = S_4 L_4 - M_4 (50)
    state.th4 = state.th4 + th4_step;
    ControlOutputs {
        u,
        u_sat,
        violated: violated1,
        y_r: clock.y_r,
        e1,
        k1: clock.k1,
        alpha1,
        e2,
        alpha2,
        D_hat2,
        e3,
        alpha3,
        e4,
        D_hat4,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `link_angle`, which are numbers in the formulas: `K = 4`, `kbar = 4`, `C = 20`,
/// `Fl = 0.01 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `link_rate`, which are numbers in the formulas: `K = 10`, `kbar = 16`, `C = 50`,
/// `Fl = 0.002 s`, `S = 40`, `eta_1 = 1`, `eta_2 = 0.0001`, `eta_3 = 100`, `Gamma = 1`, `lambda = 0.1`,
/// `iota = 1`.
///
/// Gains of block 3, `motor_angle`, which are numbers in the formulas: `K = 40`, `kbar = 45`,
/// `C = 100`, `Fl = 0.001 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 4, `motor_rate`, which are numbers in the formulas: `K = 100`, `kbar = 120`,
/// `C = 200`, `S = (40; 20; 60)`, `M = (0 0 0; 0 0 20; 0 -20 0)`, `L = (1 1 0)`, `eta_1 = 1`.
///
/// Operations: 83 additions, 120 multiplications, 4 divisions, 0 square roots, 7 elementary
/// functions, 6 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    x4: Vector<T, 1>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    law(x1, x2, x3, x4, state, params, &prepared, &clock)
}
