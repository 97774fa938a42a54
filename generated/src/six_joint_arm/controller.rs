// SHA-256 of the text below: 4191134b845fc7ca1480f66e347436af8e9d0517746246740dd00ffe70a61a79
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 27 additions, 65 multiplications, 3 divisions, 0 square roots, 10 elementary functions, 3 comparisons and selections
// control: 229 additions, 295 multiplications, 4 divisions, 0 square roots, 27 elementary functions, 16 comparisons and selections

//! `six_joint_arm`: control law and sampled controller.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::Vector;
use nsv_runtime::real::{Mask, Part, Real};
use nsv_runtime::status::Status;

/// Largest magnitude of each control: `u1` in kg*m^2/s^2, `u2` in kg*m^2/s^2, `u3` in
/// kg*m^2/s^2, `u4` in kg*m^2/s^2, `u5` in kg*m^2/s^2, `u6` in kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 6] = [97.6, 186.4, 89.4, 24.2, 20.1, 21.3];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.001;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): joints (q1, q2, q3, q4, q5, q6).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 6>,
    /// Auxiliary anti-windup state zeta (13): rates (v1, v2, v3, v4, v5, v6).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 6>,
    /// Filtered virtual control h (33): rates (v1, v2, v3, v4, v5, v6).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 6>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// rates (v1, v2, v3, v4, v5, v6).
    ///
    /// `th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 (21): th_2' = -S_2 (D_hat_2 +
    /// F_2 + G_2 sat(u) + A_hat_2)`
    pub th2: Vector<T, 6>,
}

impl<T: Real> State<T> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            zeta1: Vector::zero(),
            zeta2: Vector::zero(),
            h1: Vector::zero(),
            th2: Vector::zero(),
        }
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: &Self, b: &Self) -> Self {
        Self {
            zeta1: Vector::select(mask, a.zeta1, b.zeta1),
            zeta2: Vector::select(mask, a.zeta2, b.zeta2),
            h1: Vector::select(mask, a.h1, b.h1),
            th2: Vector::select(mask, a.th2, b.th2),
        }
    }

    /// Whether every entry is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        self.zeta1
            .is_finite()
            .and(self.zeta2.is_finite())
            .and(self.h1.is_finite())
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
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 6>,
    /// `D_hat_2 = th_2 + S_2 x_2`
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
            e2: Vector::zero(),
            D_hat2: Vector::zero(),
        }
    }
}

/// Six-joint arm with an unknown load
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
/// Operations: 27 additions, 65 multiplications, 3 divisions, 0 square roots, 10 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(t: T, x1: Vector<T, 6>, x2: Vector<T, 6>) -> State<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(1.5) * t;
    let t2 = real(2.0) * t;
    let t3 = Vector([t, t1, t2]);
    let [sin_t, sin_t1, sin_t2] = t3.sin().0;
    let t4 = real(1.0471975511965979) * sin_t1;
    let t5 = t * t;
    let t6 = (real(-0.1) * (t5 * t)).exp();
    let t7 = real(1.0) - t6;
    let t8 = real(0.6981317007977318) * sin_t;
    let t9 = real(0.8726646259971648) * sin_t1;
    let t10 = real(1.0471975511965979) * sin_t2;
    let t11 = t10 * t7;
    let t12 = real(FRAC_PI_4) * sin_t2;
    // y_r(t)
    let y_r = Vector([
        t4 * t7,
        real(-0.5235987755982989) + t8 * t7,
        t9 * t7,
        t11,
        t12 * t7,
        t11,
    ]);
    let [cos_t, cos_t1, cos_t2] = t3.cos().0;
    let t13 = cos_t1 * real(1.5);
    let t14 = t6 * (real(-0.1) * (real(3.0) * t5));
    let t15 = cos_t2 * real(2.0);
    let t16 = t7 * (real(1.0471975511965979) * t15) - t10 * t14;
    // y_r'
    let y_r_dot = Vector([
        t7 * (real(1.0471975511965979) * t13) - t4 * t14,
        t7 * (real(0.6981317007977318) * cos_t) - t8 * t14,
        t7 * (real(0.8726646259971648) * t13) - t9 * t14,
        t16,
        t7 * (real(FRAC_PI_4) * t15) - t12 * t14,
        t16,
    ]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.02);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 6> = Vector::zero();
    let zeta2: Vector<T, 6> = Vector::zero();
    let th2 = -(x2 * real(100.0));

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t17 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t17 * t17);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);

    // -- robust feedback of block 1 (31) --
    let t18 = real(3.5)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(2.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t18 + s1 * sec2E1 * real(3.0));

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = Lam1 - y_r_dot;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;
    State {
        zeta1,
        zeta2,
        h1: alpha1,
        th2,
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `k_1`.
    pub k_1: T,
    /// `k_2`.
    pub k_2: T,
    /// `k_3`.
    pub k_3: T,
    /// `k_4`.
    pub k_4: T,
    /// `k_5`.
    pub k_5: T,
    /// `k_7`.
    pub k_7: T,
    /// Part of `M_13`.
    pub M_13_1: T,
    /// `k_8`.
    pub k_8: T,
    /// `k_9`.
    pub k_9: T,
    /// Part of `M_23`.
    pub M_23_1: T,
    /// `M_33`.
    pub M_33: T,
    /// Part of `M_11_2`.
    pub M_11_2_1: T,
    /// Part of `M_11_2`.
    pub M_11_2_2: T,
    /// Part of `F2`.
    pub F2_1: T,
    /// `pull_2`.
    pub pull_2: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 11 additions, 16 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let k_1 = real(2.57) + params.load * real(0.022530010000000003);
    let k_2 = real(1.38) + params.load * real(0.18645124000000002);
    let t1 = params.load * real(0.18757560999999998);
    let k_3 = real(0.3) + t1;
    let k_4 = real(0.744) + real(2.0) * params.load * real(0.4318) * real(0.4331);
    let t2 = params.load * real(0.1501);
    let k_5 = real(0.69) + t2 * real(0.4318);
    let k_7 = real(0.134) + t2 * real(0.4331);
    let k_8 = real(6.79) + params.load * real(0.37402685);
    let k_9 = real(0.333) + t1;
    let M_33 = real(1.16) + t1;
    let t3 = params.load * real(9.81);
    let pull_2 = real(8.4) + t3 * real(0.4331);
    let M_13_1 = -k_7;
    let M_23_1 = real(0.5) * k_4;
    let M_11_2_1 = real(-2.0) * k_2;
    let M_11_2_2 = real(2.0) * k_3;
    let F2_1 = -(real(37.2) + t3 * real(0.4318));
    Prepared {
        k_1,
        k_2,
        k_3,
        k_4,
        k_5,
        k_7,
        M_13_1,
        k_8,
        k_9,
        M_23_1,
        M_33,
        M_11_2_1,
        M_11_2_2,
        F2_1,
        pull_2,
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
/// Operations: 8 additions, 38 multiplications, 1 divisions, 0 square roots, 8 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(1.5) * t;
    let t2 = real(2.0) * t;
    let t3 = Vector([t, t1, t2]);
    let [sin_t, sin_t1, sin_t2] = t3.sin().0;
    let t4 = real(1.0471975511965979) * sin_t1;
    let t5 = t * t;
    let t6 = (real(-0.1) * (t5 * t)).exp();
    let t7 = real(1.0) - t6;
    let t8 = real(0.6981317007977318) * sin_t;
    let t9 = real(0.8726646259971648) * sin_t1;
    let t10 = real(1.0471975511965979) * sin_t2;
    let t11 = t10 * t7;
    let t12 = real(FRAC_PI_4) * sin_t2;
    // y_r(t)
    let y_r = Vector([
        t4 * t7,
        real(-0.5235987755982989) + t8 * t7,
        t9 * t7,
        t11,
        t12 * t7,
        t11,
    ]);
    let [cos_t, cos_t1, cos_t2] = t3.cos().0;
    let t13 = cos_t1 * real(1.5);
    let t14 = t6 * (real(-0.1) * (real(3.0) * t5));
    let t15 = cos_t2 * real(2.0);
    let t16 = t7 * (real(1.0471975511965979) * t15) - t10 * t14;
    // y_r'
    let y_r_dot = Vector([
        t7 * (real(1.0471975511965979) * t13) - t4 * t14,
        t7 * (real(0.6981317007977318) * cos_t) - t8 * t14,
        t7 * (real(0.8726646259971648) * t13) - t9 * t14,
        t16,
        t7 * (real(FRAC_PI_4) * t15) - t12 * t14,
        t16,
    ]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.02);
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
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 6>,
    /// `D_hat_2 = th_2 + S_2 x_2`
    pub D_hat2: Vector<T, 6>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `joints`, which are numbers in the formulas: `K = 6`, `kbar = 2`, `C = 20
/// I`, `Fl = 0.005 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 40`, `kbar = 20`, `C = 50
/// I`, `S = 100 I`, `eta_1 = 1`.
///
/// Operations: 210 additions, 241 multiplications, 3 divisions, 0 square roots, 19 elementary
/// functions, 16 comparisons and selections.
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
    let q2 = x1[1];
    let q5 = x1[4];
    let q4 = x1[3];
    let q3 = x1[2];
    let t1 = q2 + q3;
    let t2 = Vector([t1, q2, q3, q4, q5]);
    let [cos_t1, cos_q2, cos_q3, cos_q4, cos_q5] = t2.cos().0;
    let c_2 = cos_q2;
    let c_23 = cos_t1;
    let [sin_t1, sin_q2, sin_q3, sin_q4, sin_q5] = t2.sin().0;
    let s_23 = sin_t1;
    let s_2 = sin_q2;
    let t3 = prepared.k_4 * c_2;
    let M_11 = prepared.k_1 + prepared.k_2 * (c_2 * c_2) + prepared.k_3 * (s_23 * s_23)
        + t3 * s_23;
    let k_6 = real(0.0238);
    let M_12 = prepared.k_5 * s_2 + k_6 * c_2 - prepared.k_7 * c_23;
    let M_13 = prepared.M_13_1 * c_23;
    let M_22 = prepared.k_8 + prepared.k_4 * sin_q3;
    let M_23 = prepared.k_9 + prepared.M_23_1 * sin_q3;
    let t4 = prepared.M_11_2_2 * s_23 * c_23;
    let M_11_2 = prepared.M_11_2_1 * s_2 * c_2 + t4
        + prepared.k_4 * (real(2.0) * q2 + q3).cos();
    let v2 = x2[1];
    let M_11_3 = t4 + t3 * c_23;
    let v3 = x2[2];
    let v1 = x2[0];
    let t5 = prepared.k_7 * s_23;
    let M_12_2 = prepared.k_5 * c_2 - k_6 * s_2 + t5;
    let v6 = x2[5];
    let v5 = x2[4];
    let v4 = x2[3];
    let t6 = v1 * real(10.0);
    let t7 = v6 * real(10.0);
    let t8 = v5 * real(10.0);
    let t9 = v4 * real(10.0);
    let t10 = v3 * real(10.0);
    let t11 = v2 * real(10.0);
    let [tanh_t6, tanh_t11, tanh_t10, tanh_t9, tanh_t8, tanh_t7] = Vector([
            t6,
            t11,
            t10,
            t9,
            t8,
            t7,
        ])
        .tanh()
        .0;
    let t12 = Vector([
        real(6.3) * tanh_t6,
        real(5.5) * tanh_t11,
        real(2.6) * tanh_t10,
        real(1.3) * tanh_t9,
        tanh_t8,
        real(1.2) * tanh_t7,
    ]);
    let dry = t12 * params.dry_scale;

    // -- known dynamics of block 2 (rates) (11) --
    let t13 = M_22 * prepared.M_33 - M_23 * M_23;
    let t14 = M_23 * M_13 - prepared.M_33 * M_12;
    let t15 = M_12 * M_23 - M_13 * M_22;
    let t16 = real(1.0) / (M_11 * t13 + M_12 * t14 + M_13 * t15);
    let t17 = t13 * t16;
    let t18 = t14 * t16;
    let t19 = t15 * t16;
    let t20 = (prepared.M_33 * M_11 - M_13 * M_13) * t16;
    let t21 = (M_13 * M_12 - M_11 * M_23) * t16;
    let t22 = (M_11 * M_22 - M_12 * M_12) * t16;
    let t23 = v2 * v2;
    let t24 = (M_11_2 * v2 + M_11_3 * v3) * v1 + M_12_2 * t23;
    let t25 = v1 * v1;
    let t26 = prepared.k_4 * cos_q3 * (v2 + real(0.5) * v3) * v3
        - real(0.5) * M_11_2 * t25;
    let t27 = prepared.pull_2 * s_23;
    let t28 = Vector([
        t24 + t5 * (real(2.0) * v2 + v3) * v3,
        t26 + (prepared.F2_1 * c_2 - t27 + real(1.02) * s_2),
        real(-0.5) * M_11_3 * t25 - prepared.M_23_1 * cos_q3 * t23
            + (real(0.25) * c_23 - t27),
        real(0.028) * s_23 * sin_q4 * sin_q5,
        real(-0.028) * (c_23 * sin_q5 + s_23 * cos_q4 * cos_q5),
        real(0.0),
    ]);
    let t29 = t28 + dry;
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        -t17 * t29[0] - t18 * t29[1] - t19 * t29[2],
        -t18 * t29[0] - t20 * t29[1] - t21 * t29[2],
        -t19 * t29[0] - t21 * t29[1] - t22 * t29[2],
        real(-5.0) * t29[3],
        real(-5.555555555555555) * t29[4],
        real(-5.2631578947368425) * t29[5],
    ]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t30 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t30 * t30);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t31 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t31;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = real(6.0);

    // -- robust feedback of block 1 (31) --
    let t32 = real(3.5)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(2.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t32 + t31 * real(3.0));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t33 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t33 - clock.y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t33;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(200.0);

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();

    // -- disturbance observer of block 2 (20) --
    // D_hat_2 = th_2 + S_2 x_2
    let D_hat2 = state.th2 + x2 * real(100.0);

    // -- robust feedback of block 2 (63) --
    let t34 = G_norm2_1 * s_c1;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam2 = e2 * (real(50.0) + s2 * real(0.5) + t34 * t34 * real(0.25));

    // -- control (64) of block 2 --
    let t35 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 - h1_dot + t35 + D_hat2 + Lam2;
    let t36 = M_11 * bracket2[0] + M_12 * bracket2[1] + M_13 * bracket2[2];
    let t37 = M_12 * bracket2[0] + M_22 * bracket2[1] + M_23 * bracket2[2];
    let t38 = M_13 * bracket2[0] + M_23 * bracket2[1] + prepared.M_33 * bracket2[2];
    let t39 = real(0.2) * bracket2[3];
    let t40 = real(0.18) * bracket2[4];
    let t41 = real(0.19) * bracket2[5];
    let t42 = Vector([t36, t37, t38, t39, t40, t41]);
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t42;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 6>::from_f64([-97.6, -186.4, -89.4, -24.2, -20.1, -21.3]))
        .min(Vector::<T, 6>::from_f64([97.6, 186.4, 89.4, 24.2, 20.1, 21.3]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    let t43 = u_sat + t42;
    let t44 = Vector([
        t17 * t43[0] + t18 * t43[1] + t19 * t43[2],
        t18 * t43[0] + t20 * t43[1] + t21 * t43[2],
        t19 * t43[0] + t21 * t43[1] + t22 * t43[2],
        real(5.0) * t43[3],
        real(5.555555555555555) * t43[4],
        real(5.2631578947368425) * t43[5],
    ]);
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = t44 - t35;

    // -- states of block 2, one sample later --
    let t45 = Vector([
        t17 * u_sat[0] + t18 * u_sat[1] + t19 * u_sat[2],
        t18 * u_sat[0] + t20 * u_sat[1] + t21 * u_sat[2],
        t19 * u_sat[0] + t21 * u_sat[1] + t22 * u_sat[2],
        real(5.0) * u_sat[3],
        real(5.555555555555555) * u_sat[4],
        real(5.2631578947368425) * u_sat[5],
    ]);

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.000990066334662235);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0009063462346100907);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0009754115099857198);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 (21): th_2' = -S_2 (D_hat_2 + F_2
    // + G_2 sat(u) + A_hat_2)
    state.th2 = state.th2
        - (D_hat2 + F2 + t45) * real(100.0) * real(0.0009516258196404043);
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
/// Gains of block 1, `joints`, which are numbers in the formulas: `K = 6`, `kbar = 2`, `C = 20
/// I`, `Fl = 0.005 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 40`, `kbar = 20`, `C = 50
/// I`, `S = 100 I`, `eta_1 = 1`.
///
/// Operations: 229 additions, 295 multiplications, 4 divisions, 0 square roots, 27 elementary
/// functions, 16 comparisons and selections.
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
