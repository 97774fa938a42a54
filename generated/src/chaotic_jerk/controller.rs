// SHA-256 of the text below: 34f635f62a68017fc344bfb149c4681b50f1448bf52832d4bd1c4ed16cb0d515
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 0 additions, 1 multiplications, 0 divisions, 0 square roots, 0 elementary functions, 0 comparisons and selections
// control: 98 additions, 120 multiplications, 0 divisions, 0 square roots, 3 elementary functions, 2 comparisons and selections

//! `chaotic_jerk`: control law and sampled controller.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Mask, Part, Real};
use nsv_runtime::status::Status;

/// Largest magnitude of each control: `force` in 1/s^2.
pub const INPUT_LIMIT: [f64; 1] = [20.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.005;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 1] = [0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): position (x).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): velocity (v).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 zeta_3`
    pub zeta2: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): acceleration (w).
    ///
    /// `zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)`
    pub zeta3: Vector<T, 1>,
    /// Network weights W_hat, one row per monomial and one column per channel: acceleration (w).
    ///
    /// `W_3(t + dt) = (1 - g Gamma_3 lambda_3) W_3 + g Gamma_3 P_3 c_3 I_3, g = (1 - exp(-a dt))/a,
    /// a = Gamma_3 lambda_3 (65): W_3' = Gamma_3 (P_3 c_3 I_3 - lambda_3 W_3)`
    ///
    /// Rows: `one, x, v, w, x2, x_v, x_w, v2, v_w, w2`.
    pub W3: Matrix<T, 10, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// acceleration (w).
    ///
    /// `th3(t + dt) = th3 + g th3', g = (1 - exp(-a dt))/a, a = S_3 (21): th_3' = -S_3 (D_hat_3 +
    /// F_3 + G_3 sat(u) + A_hat_3)`
    pub th3: Vector<T, 1>,
}

impl<T: Real> State<T> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            zeta1: Vector::zero(),
            zeta2: Vector::zero(),
            zeta3: Vector::zero(),
            W3: Matrix::zero(),
            th3: Vector::zero(),
        }
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: &Self, b: &Self) -> Self {
        Self {
            zeta1: Vector::select(mask, a.zeta1, b.zeta1),
            zeta2: Vector::select(mask, a.zeta2, b.zeta2),
            zeta3: Vector::select(mask, a.zeta3, b.zeta3),
            W3: Matrix::select(mask, a.W3, b.W3),
            th3: Vector::select(mask, a.th3, b.th3),
        }
    }

    /// Whether every entry is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        self.zeta1
            .is_finite()
            .and(self.zeta2.is_finite())
            .and(self.zeta3.is_finite())
            .and(self.W3.is_finite())
            .and(self.th3.is_finite())
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
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub alpha2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
    /// `D_hat_3 = th_3 + S_3 x_3`
    pub D_hat3: Vector<T, 1>,
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
            alpha1: Vector::zero(),
            e2: Vector::zero(),
            alpha2: Vector::zero(),
            e3: Vector::zero(),
            D_hat3: Vector::zero(),
        }
    }
}

/// Chaotic system of Genesio and Tesi following a sine
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
    pub fn reset(&mut self, t: T, x1: Vector<T, 1>, x2: Vector<T, 1>, x3: Vector<T, 1>) {
        self.state = State::zero();
        self.started = T::Mask::splat(false);
        let mask = t
            .is_finite()
            .and(x1.is_finite())
            .and(x2.is_finite())
            .and(x3.is_finite());
        T::outlined(Begin {
            controller: self,
            mask,
            t,
            x1,
            x2,
            x3,
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
    ) -> Output<T> {
        let clock = clock(t);
        self.step_at(t, &clock, x1, x2, x3)
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
    ) -> Output<T> {
        let measured = t
            .is_finite()
            .and(x1.is_finite())
            .and(x2.is_finite())
            .and(x3.is_finite());
        let starting = measured.and(self.started.not());
        if starting.any() {
            T::outlined(Begin {
                controller: self,
                mask: starting,
                t,
                x1,
                x2,
                x3,
            });
        }
        let before = if measured.all() { None } else { Some(self.state) };
        let law = law(x1, x2, x3, &mut self.state, &self.params, clock);
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
            | Status::SATURATED.when(saturated.any());
        Output {
            status,
            valid,
            u,
            u_sat,
            y_r: law.y_r,
            e1: law.e1,
            alpha1: law.alpha1,
            e2: law.e2,
            alpha2: law.alpha2,
            e3: law.e3,
            D_hat3: law.D_hat3,
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
}
impl<T: Real> Part for Begin<'_, T> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let start = initial(self.t, self.x1, self.x2, self.x3);
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
        });
        controller.started = controller.started.and(mask.not());
    }
}

/// The controller's states at its first sample.
///
/// Operations: 0 additions, 1 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(
    _t: T,
    _x1: Vector<T, 1>,
    _x2: Vector<T, 1>,
    x3: Vector<T, 1>,
) -> State<T> {
    let real = T::from_f64;

    // -- given --
    let zeta1: Vector<T, 1> = Vector::zero();
    let zeta2: Vector<T, 1> = Vector::zero();
    let zeta3: Vector<T, 1> = Vector::zero();
    let W3: Matrix<T, 10, 1> = Matrix::zero();
    let th3 = -(x3 * real(10.0));
    State {
        zeta1,
        zeta2,
        zeta3,
        W3,
        th3,
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
    /// `y_r''`
    pub y_r_dot2: Vector<T, 1>,
    /// `y_r'''`
    pub y_r_dot3: Vector<T, 1>,
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
            y_r_dot2: self.y_r_dot2.in_every_lane(lane),
            y_r_dot3: self.y_r_dot3.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 16 additions, 27 multiplications, 0 divisions, 0 square roots, 3 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = t.sin();
    let t2 = real(2.0) * t1;
    let t3 = t * t;
    let t4 = (real(-0.1) * (t3 * t)).exp();
    let t5 = real(1.0) - t4;
    // y_r(t)
    let y_r = Vector([t2 * t5]);
    let t6 = t.cos();
    let t7 = real(2.0) * t6;
    let t8 = real(-0.1) * (real(3.0) * t3);
    let t9 = t4 * t8;
    // y_r'
    let y_r_dot = Vector([t5 * t7 - t2 * t9]);

    // -- exact derivative of the virtual control of block 1 (34) --
    let t10 = real(2.0) * -t1;
    let t11 = t7 * t9;
    let t12 = real(-0.1) * (real(3.0) * (t + t));
    let t13 = t8 * t9 + t4 * t12;
    // y_r''
    let y_r_dot2 = Vector([t5 * t10 - t11 - (t11 + t2 * t13)]);

    // -- exact derivative of the virtual control of block 2 (34) --
    let t14 = t10 * t9;
    let t15 = t7 * t13;
    let t16 = t14 + t15;
    let t17 = t9 * t12;
    let t18 = t16
        + (t15 + t2 * (t17 + t8 * t13 + (t17 + t4 * real(-0.6000000000000001))));
    // y_r'''
    let y_r_dot3 = Vector([t5 * (real(2.0) * -t6) - t14 - t16 - t18]);
    Clock {
        y_r,
        y_r_dot,
        y_r_dot2,
        y_r_dot3,
    }
}

/// Results of [`control`].
#[derive(Clone, Copy, Debug)]
pub struct ControlOutputs<T: Real> {
    /// `u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]`
    pub u: Vector<T, 1>,
    /// `sat(u), each component limited to +-u_max (8)`
    pub u_sat: Vector<T, 1>,
    /// `y_r(t)`
    pub y_r: Vector<T, 1>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 1>,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub alpha2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
    /// `D_hat_3 = th_3 + S_3 x_3`
    pub D_hat3: Vector<T, 1>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `position`, which are numbers in the formulas: `K = 4`, `kbar = 1`, `C = 10`,
/// `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `velocity`, which are numbers in the formulas: `K = 4`, `kbar = 1`, `C = 10`,
/// `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 3, `acceleration`, which are numbers in the formulas: `K = 4`, `kbar = 1`, `C = 20`,
/// `S = 10`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`.
///
/// Operations: 82 additions, 93 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 2 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    state: &mut State<T>,
    params: &Params<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let x = x1[0];
    let v = x2[0];
    let w = x3[0];

    // -- known dynamics of block 3 (acceleration) (11) --
    // F_3(x_1 .. x_3)
    let F3 = Vector([-params.c * x - params.b * v - params.a * w + x * x]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

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
    let t1 = state.zeta1 * real(10.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t1 - clock.y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t1;

    // -- exact derivative of the virtual control of block 1 (34) --
    // e1'
    let e1_dot = x2 - clock.y_r_dot - zeta1_dot;
    // Lam0_1'
    let Lam0_1_dot = e1_dot * real(3.0);
    let t2 = e1_dot.dot(e1);
    // s1'
    let s1_dot = t2 + t2;
    // c1'
    let c1_dot = e1 * s1_dot + e1_dot * s1;
    // Lam1_filter'
    let Lam1_filter_dot = c1_dot * real(0.5);
    // Lam1'
    let Lam1_dot = Lam0_1_dot + Lam1_filter_dot;
    let t3 = zeta1_dot * real(10.0);
    // bracket1'
    let bracket1_dot = t3 - clock.y_r_dot2 + Lam1_dot;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + bracket1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * s2;

    // -- robust feedback of block 2 (31) --
    let t4 = s_c1 * s_c1;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G,
    // c, eta_3 of the outer block (38)
    let Lam2 = e2 * (real(3.0) + s2 * real(0.5) + t4 * real(0.25));
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t5 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = bracket1_dot + t5 + Lam2;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -bracket2;

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = state.zeta3 - t5;

    // -- exact derivative of the virtual control of block 2 (34) --
    // zeta1_dot'
    let zeta1_dot_dot = zeta2_dot - t3;
    // e1''
    let e1_dot2 = x3 - clock.y_r_dot2 - zeta1_dot_dot;
    // Lam0_1''
    let Lam0_1_dot2 = e1_dot2 * real(3.0);
    let t6 = e1_dot2.dot(e1) + e1_dot.sum_squares();
    // s1''
    let s1_dot2 = t6 + t6;
    // c1''
    let c1_dot2 = e1 * s1_dot2 + e1_dot * (s1_dot + s1_dot) + e1_dot2 * s1;
    // Lam1_filter''
    let Lam1_filter_dot2 = c1_dot2 * real(0.5);
    // Lam1''
    let Lam1_dot2 = Lam0_1_dot2 + Lam1_filter_dot2;
    // bracket1''
    let bracket1_dot2 = zeta1_dot_dot * real(10.0) - clock.y_r_dot3 + Lam1_dot2;
    // e2'
    let e2_dot = x3 + bracket1_dot - zeta2_dot;
    // Lam0_2'
    let Lam0_2_dot = e2_dot * real(3.0);
    let t7 = e2_dot.dot(e2);
    // s2'
    let s2_dot = t7 + t7;
    // c2'
    let c2_dot = e2 * s2_dot + e2_dot * s2;
    // Lam2_filter'
    let Lam2_filter_dot = c2_dot * real(0.5);
    let t8 = c1_dot.dot(c1);
    // s_c1'
    let s_c1_dot = t8 + t8;
    // Lam2_coupling'
    let Lam2_coupling_dot = Vector([
        (e2[0] * ((s_c1 + s_c1) * s_c1_dot) + t4 * e2_dot[0]) * real(0.25),
    ]);
    // Lam2'
    let Lam2_dot = Lam0_2_dot + Lam2_filter_dot + Lam2_coupling_dot;
    // bracket2'
    let bracket2_dot = bracket1_dot2 + zeta2_dot * real(10.0) + Lam2_dot;

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
    // A_hat_3 = iota_3 W_3^T P_3
    let A_hat3 = state.W3.transpose_mul(P3);

    // -- disturbance observer of block 3 (20) --
    // D_hat_3 = th_3 + S_3 x_3
    let D_hat3 = state.th3 + x3 * real(10.0);

    // -- robust feedback of block 3 (63) --
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam3 = e3 * (real(3.0) + s3 * real(0.5) + s_c2 * s_c2 * real(0.25));

    // -- control (64) of block 3 --
    let t9 = F3 + A_hat3;
    let t10 = state.zeta3 * real(20.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = t9 + bracket2_dot + t10 + D_hat3 + Lam3;
    // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let u = -bracket3;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-20.0))).min(Vector::splat(real(20.0)));

    // -- auxiliary system of block 3 (13), erratum 1 --
    // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
    let zeta3_dot = u_sat + bracket3 - t10;

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.004877057549928599);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.004877057549928599);

    // -- states of block 3, one sample later --
    // zeta3(t + dt) = zeta3 + g zeta3', g = (1 - exp(-a dt))/a, a = C_3 (13)
    state.zeta3 = state.zeta3 + zeta3_dot * real(0.004758129098202022);
    // th3(t + dt) = th3 + g th3', g = (1 - exp(-a dt))/a, a = S_3 (21): th_3' = -S_3 (D_hat_3 + F_3
    // + G_3 sat(u) + A_hat_3)
    state.th3 = state.th3
        - (D_hat3 + t9 + u_sat) * real(10.0) * real(0.004877057549928599);
    // W_3(t + dt) = (1 - g Gamma_3 lambda_3) W_3 + g Gamma_3 P_3 c_3 I_3, g = (1 - exp(-a dt))/a, a
    // = Gamma_3 lambda_3 (65): W_3' = Gamma_3 (P_3 c_3 I_3 - lambda_3 W_3)
    state
        .W3
        .scale_add_outer(real(0.9995001249791693), P3, c3 * real(0.004998750208307295));
    ControlOutputs {
        u,
        u_sat,
        y_r: clock.y_r,
        e1,
        alpha1,
        e2,
        alpha2,
        e3,
        D_hat3,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `position`, which are numbers in the formulas: `K = 4`, `kbar = 1`, `C = 10`,
/// `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `velocity`, which are numbers in the formulas: `K = 4`, `kbar = 1`, `C = 10`,
/// `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 3, `acceleration`, which are numbers in the formulas: `K = 4`, `kbar = 1`, `C = 20`,
/// `S = 10`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`.
///
/// Operations: 98 additions, 120 multiplications, 0 divisions, 0 square roots, 3 elementary
/// functions, 2 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let clock = clock(t);
    law(x1, x2, x3, state, params, &clock)
}
