// SHA-256 of the text below: 33134cee1c71760e181e9fd10fe3ac03ad723b01b542edcb033951bca4465c5a
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 55 additions, 83 multiplications, 3 divisions, 0 square roots, 4 elementary functions, 31 comparisons and selections
// control: 108 additions, 147 multiplications, 4 divisions, 0 square roots, 4 elementary functions, 34 comparisons and selections

//! `missile_pitch`: control law and sampled controller.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::{polynomials, tables};
use core::f64::consts::FRAC_PI_2;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Mask, Part, Real};
use nsv_runtime::status::Status;

/// Largest magnitude of each control: `delta` in dimensionless.
pub const INPUT_LIMIT: [f64; 1] = [0.4363323129985824];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.001;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 1] = [0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): incidence (alpha).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): rate (q).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// incidence (alpha).
    ///
    /// `th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 +
    /// F_1 + G_1 x_2 + A_hat_1)`
    pub th1: Vector<T, 1>,
    /// Filtered virtual control h (33): rate (q).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 1>,
    /// Network weights W_hat, one row per monomial and one column per channel: rate (q).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, alpha, q, alpha2, alpha_q, q2`.
    pub W2: Matrix<T, 6, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// rate (q).
    ///
    /// `th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 (21): th_2' = -S_2 (D_hat_2 +
    /// F_2 + G_2 sat(u) + A_hat_2)`
    pub th2: Vector<T, 1>,
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
    /// `D_hat_1 = th_1 + S_1 x_1`
    pub D_hat1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `D_hat_2 = th_2 + S_2 x_2`
    pub D_hat2: Vector<T, 1>,
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

/// Missile pitch autopilot with lookup tables at a falling Mach number
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
    pub fn reset(&mut self, t: T, x1: Vector<T, 1>, x2: Vector<T, 1>) {
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
    pub fn step(&mut self, t: T, x1: Vector<T, 1>, x2: Vector<T, 1>) -> Output<T> {
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
        x1: Vector<T, 1>,
        x2: Vector<T, 1>,
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
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
}
impl<T: Real> Part for Begin<'_, T> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let start = initial(self.t, self.x1, self.x2, &self.controller.params);
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
/// Operations: 55 additions, 83 multiplications, 3 divisions, 0 square roots, 4 elementary
/// functions, 31 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    params: &Params<T>,
) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let alpha = x1[0];

    // -- known dynamics of block 1 (incidence) (11) --
    // F_1(x_1 .. x_1)
    let F1 = Vector([
        real(0.06206968077555868) * params.CN_scale * tables::CN(alpha, real(3.0))
            * alpha.cos(),
    ]);

    // -- reference and constraints --
    let t1 = (t - real(0.2)) * real(2.0000000000000004);
    let t2 = t1.max(real(0.0)).min(real(1.0));
    let t3 = (t - real(1.5)) * real(1.6666666666666665);
    let t4 = t3.max(real(0.0)).min(real(1.0));
    let t5 = real(18.0) * (t4 * t4 * (real(3.0) - real(2.0) * t4));
    let t6 = real(12.0) * (t2 * t2 * (real(3.0) - real(2.0) * t2)) - t5;
    let t7 = (t - real(3.0)) * real(1.6666666666666665);
    let t8 = t7.max(real(0.0)).min(real(1.0));
    // y_r(t)
    let y_r = Vector([
        (t6 + real(14.0) * (t8 * t8 * (real(3.0) - real(2.0) * t8)))
            * real(0.017453292519943295),
    ]);
    let t9 = real(0.0).lt(t1);
    let t10 = T::select(t9, t1, real(0.0));
    let t11 = t10.lt(real(1.0));
    let t12 = T::select(t11, t10, real(1.0));
    let t13 = (real(3.0) - real(2.0) * t12) * ((t12 + t12) * real(2.0000000000000004))
        - t12 * t12 * real(4.000000000000001);
    let t14 = real(0.0).lt(t3);
    let t15 = T::select(t14, t3, real(0.0));
    let t16 = t15.lt(real(1.0));
    let t17 = T::select(t16, t15, real(1.0));
    let t18 = (real(3.0) - real(2.0) * t17) * ((t17 + t17) * real(1.6666666666666665))
        - t17 * t17 * real(3.333333333333333);
    let t19 = T::select(t16, T::select(t14, -(real(18.0) * t18), real(0.0)), real(0.0));
    let t20 = T::select(t11, T::select(t9, real(12.0) * t13, real(0.0)), real(0.0))
        + t19;
    let t21 = real(0.0).lt(t7);
    let t22 = T::select(t21, t7, real(0.0));
    let t23 = t22.lt(real(1.0));
    let t24 = T::select(t23, t22, real(1.0));
    let t25 = (real(3.0) - real(2.0) * t24) * ((t24 + t24) * real(1.6666666666666665))
        - t24 * t24 * real(3.333333333333333);
    // y_r'
    let y_r_dot = Vector([
        real(0.017453292519943295)
            * (t20
                + T::select(t23, T::select(t21, real(14.0) * t25, real(0.0)), real(0.0))),
    ]);
    // k_1(t)
    let k1 = (real(4.0) * (real(-3.0) * t).exp() + real(2.0))
        * real(0.017453292519943295);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 1> = Vector::zero();
    let th1 = -(x1 * real(10.0));
    let zeta2: Vector<T, 1> = Vector::zero();
    let W2: Matrix<T, 6, 1> = Matrix::zero();
    let th2 = -(x2 * real(30.0));

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t26 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t26 * t26);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);

    // -- robust feedback of block 1 (31) --
    let t27 = real(10.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(8.0);
    let t28 = s1 * sec2E1 * real(0.5);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t27 + t28 + t28);

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = F1 - y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;
    State {
        zeta1,
        zeta2,
        th1,
        h1: alpha1,
        W2,
        th2,
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `F1`.
    pub F1_1: T,
    /// Part of `F2`.
    pub F2_1: T,
    /// `G_2(x_1 .. x_2)`
    pub G2: Matrix<T, 1, 1>,
    /// Part of `u`.
    pub u_1: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 5 multiplications, 1 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- known dynamics of block 2 (rate) (11) --
    let t1 = real(11.08751530287415) * params.fin_scale * real(-0.206)
        * real(57.29577951308232);
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t1]]);
    let F1_1 = real(0.06206968077555868) * params.CN_scale;
    let F2_1 = real(11.08751530287415) * params.CM_scale;
    let u_1 = real(1.0) / t1;
    Prepared { F1_1, F2_1, G2, u_1 }
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
/// Operations: 20 additions, 39 multiplications, 1 divisions, 0 square roots, 1 elementary
/// functions, 24 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = (t - real(0.2)) * real(2.0000000000000004);
    let t2 = t1.max(real(0.0)).min(real(1.0));
    let t3 = (t - real(1.5)) * real(1.6666666666666665);
    let t4 = t3.max(real(0.0)).min(real(1.0));
    let t5 = real(18.0) * (t4 * t4 * (real(3.0) - real(2.0) * t4));
    let t6 = real(12.0) * (t2 * t2 * (real(3.0) - real(2.0) * t2)) - t5;
    let t7 = (t - real(3.0)) * real(1.6666666666666665);
    let t8 = t7.max(real(0.0)).min(real(1.0));
    // y_r(t)
    let y_r = Vector([
        (t6 + real(14.0) * (t8 * t8 * (real(3.0) - real(2.0) * t8)))
            * real(0.017453292519943295),
    ]);
    let t9 = real(0.0).lt(t1);
    let t10 = T::select(t9, t1, real(0.0));
    let t11 = t10.lt(real(1.0));
    let t12 = T::select(t11, t10, real(1.0));
    let t13 = (real(3.0) - real(2.0) * t12) * ((t12 + t12) * real(2.0000000000000004))
        - t12 * t12 * real(4.000000000000001);
    let t14 = real(0.0).lt(t3);
    let t15 = T::select(t14, t3, real(0.0));
    let t16 = t15.lt(real(1.0));
    let t17 = T::select(t16, t15, real(1.0));
    let t18 = (real(3.0) - real(2.0) * t17) * ((t17 + t17) * real(1.6666666666666665))
        - t17 * t17 * real(3.333333333333333);
    let t19 = T::select(t16, T::select(t14, -(real(18.0) * t18), real(0.0)), real(0.0));
    let t20 = T::select(t11, T::select(t9, real(12.0) * t13, real(0.0)), real(0.0))
        + t19;
    let t21 = real(0.0).lt(t7);
    let t22 = T::select(t21, t7, real(0.0));
    let t23 = t22.lt(real(1.0));
    let t24 = T::select(t23, t22, real(1.0));
    let t25 = (real(3.0) - real(2.0) * t24) * ((t24 + t24) * real(1.6666666666666665))
        - t24 * t24 * real(3.333333333333333);
    // y_r'
    let y_r_dot = Vector([
        real(0.017453292519943295)
            * (t20
                + T::select(t23, T::select(t21, real(14.0) * t25, real(0.0)), real(0.0))),
    ]);
    // k_1(t)
    let k1 = (real(4.0) * (real(-3.0) * t).exp() + real(2.0))
        * real(0.017453292519943295);
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
    /// `D_hat_1 = th_1 + S_1 x_1`
    pub D_hat1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `D_hat_2 = th_2 + S_2 x_2`
    pub D_hat2: Vector<T, 1>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `incidence`, which are numbers in the formulas: `K = 8`, `kbar = 8`, `C = 20`,
/// `Fl = 0.02 s`, `S = 10`, `eta_1 = 1`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rate`, which are numbers in the formulas: `K = 20`, `kbar = 20`, `C = 50`,
/// `S = 30`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`.
///
/// Operations: 88 additions, 103 multiplications, 2 divisions, 0 square roots, 3 elementary
/// functions, 10 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    state: &mut State<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let alpha = x1[0];
    let q = x2[0];

    // -- known dynamics of block 1 (incidence) (11) --
    let at_alpha_mach = tables::at_alpha_mach(alpha, real(3.0));
    // F_1(x_1 .. x_1)
    let F1 = Vector([prepared.F1_1 * at_alpha_mach.CN * alpha.cos()]);

    // -- known dynamics of block 2 (rate) (11) --
    // F_2(x_1 .. x_2)
    let F2 = Vector([prepared.F2_1 * at_alpha_mach.CM]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t1 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t1 * t1);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t2 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t2;

    // -- disturbance observer of block 1 (20) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1 * real(10.0);

    // -- robust feedback of block 1 (31) --
    let t3 = real(10.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(8.0);
    let t4 = t2 * real(0.5);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t3 + t4 + t4);
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t5 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = F1 - clock.y_r_dot + t5 + D_hat1 + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t5;

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
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (20) --
    // D_hat_2 = th_2 + S_2 x_2
    let D_hat2 = state.th2 + x2 * real(30.0);

    // -- robust feedback of block 2 (63) --
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam2 = e2 * (real(45.0) + s2 * real(0.5) + s_c1 * s_c1 * real(0.25));

    // -- control (64) of block 2 --
    let t6 = F2 + A_hat2;
    let t7 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t6 - h1_dot + t7 + D_hat2 + Lam2;
    let t8 = bracket2 * prepared.u_1;
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t8;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::splat(real(-0.4363323129985824)))
        .min(Vector::splat(real(0.4363323129985824)));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = prepared.G2 * (u_sat + t8) - t7;

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.000990066334662235);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0009754115099857198);
    // th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 + F_1
    // + G_1 x_2 + A_hat_1)
    state.th1 = state.th1
        - (D_hat1 + F1 + x2) * real(10.0) * real(0.0009950166250831947);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0009754115099857198);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 (21): th_2' = -S_2 (D_hat_2 + F_2
    // + G_2 sat(u) + A_hat_2)
    state.th2 = state.th2
        - (D_hat2 + t6 + prepared.G2 * u_sat) * real(30.0) * real(0.0009851488817163943);
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(real(0.9999000049998333), P2, c2 * real(0.000999950001666625));
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
/// Gains of block 1, `incidence`, which are numbers in the formulas: `K = 8`, `kbar = 8`, `C = 20`,
/// `Fl = 0.02 s`, `S = 10`, `eta_1 = 1`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rate`, which are numbers in the formulas: `K = 20`, `kbar = 20`, `C = 50`,
/// `S = 30`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`.
///
/// Operations: 108 additions, 147 multiplications, 4 divisions, 0 square roots, 4 elementary
/// functions, 34 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    law(x1, x2, state, &prepared, &clock)
}
