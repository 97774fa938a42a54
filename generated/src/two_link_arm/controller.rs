// SHA-256 of the text below: b8a3ea7098ed22553750341d8ca5b4b5301bfce9a1fdf91e5e93fdcf3f61a060
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 11 additions, 27 multiplications, 3 divisions, 0 square roots, 5 elementary functions, 3 comparisons and selections
// control: 184 additions, 275 multiplications, 7 divisions, 0 square roots, 11 elementary functions, 13 comparisons and selections

//! `two_link_arm`: control law and sampled controller.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Mask, Part, Real};
use nsv_runtime::status::Status;

/// Largest magnitude of each control: `shoulder` in kg*m^2/s^2, `elbow` in kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 2] = [60.0, 30.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.002;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 2] = [0.0, 0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): joints (q1, q2).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 2>,
    /// Auxiliary anti-windup state zeta (13): rates (v1, v2).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 2>,
    /// Filtered virtual control h (33): rates (v1, v2).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 2>,
    /// Network weights W_hat, one row per monomial and one column per channel: rates (v1, v2).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, v1, v2, q2, v12, v1_v2, v1_q2, v22, v2_q2, q22, v13, v12_v2, v12_q2, v1_v22,
    /// v1_v2_q2, v1_q22, v23, v22_q2, v2_q22, q23`.
    pub W2: Matrix<T, 20, 2>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// rates (v1, v2).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
    /// M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)`
    pub th2: Vector<T, 5>,
    /// Bound eps_hat of the approximation error (66): rates (v1, v2).
    ///
    /// `eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)`
    pub eps2: T,
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
    pub u: Vector<T, 2>,
    /// Control to apply: within its limits, always finite.
    pub u_sat: Vector<T, 2>,
    /// `y_r(t)`
    pub y_r: Vector<T, 2>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 2>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 2>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 2>,
    /// `k_2(t)`
    pub k2: T,
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 2>,
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
            k2: T::zero(),
            D_hat2: Vector::zero(),
        }
    }
}

/// Two-link arm with an unknown load
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
    pub fn reset(&mut self, t: T, x1: Vector<T, 2>, x2: Vector<T, 2>) {
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
    pub fn step(&mut self, t: T, x1: Vector<T, 2>, x2: Vector<T, 2>) -> Output<T> {
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
        x1: Vector<T, 2>,
        x2: Vector<T, 2>,
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
        let saturated = u[0].ne(u_sat[0]).or(u[1].ne(u_sat[1]));
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
            k2: law.k2,
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
    x1: Vector<T, 2>,
    x2: Vector<T, 2>,
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
/// Operations: 11 additions, 27 multiplications, 3 divisions, 0 square roots, 5 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(t: T, x1: Vector<T, 2>, x2: Vector<T, 2>) -> State<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(2.0) * t;
    let t2 = real(1.0) - t1.cos();
    // y_r(t)
    let y_r = Vector([real(0.5235987755982989) * t2, real(FRAC_PI_4) * t2]);
    let t3 = t1.sin() * real(2.0);
    // y_r'
    let y_r_dot = Vector([real(0.5235987755982989) * t3, real(FRAC_PI_4) * t3]);
    // k_1(t)
    let k1 = real(0.3) * (real(-2.0) * t).exp() + real(0.05);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 2> = Vector::zero();
    let zeta2: Vector<T, 2> = Vector::zero();
    let W2: Matrix<T, 20, 2> = Matrix::zero();
    let eps2 = real(0.0);

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t4 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t4 * t4);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);

    // -- robust feedback of block 1 (31) --
    let t5 = real(5.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(4.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t5 + s1 * sec2E1 * real(0.5));

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = Lam1 - y_r_dot;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + bracket1;

    // -- given --
    let t6 = real(12.0) * e2[0];
    let t7 = real(36.0) * e2[0];
    let t8 = real(8.0) * e2[1];
    let t9 = real(2.0) * e2[1];
    let t10 = real(11.0) * e2[1];
    let th2 = -Vector([t6, t7, t8, t9, t10]);
    State {
        zeta1,
        zeta2,
        h1: alpha1,
        W2,
        th2,
        eps2,
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `a_1`.
    pub a_1: T,
    /// `a_3`.
    pub a_3: T,
    /// Part of `M_11`.
    pub M_11_1: T,
    /// `a_4`.
    pub a_4: T,
    /// Part of `M_11`.
    pub M_11_2: T,
    /// `a_2`.
    pub a_2: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 3 additions, 6 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let t1 = params.m_e * real(0.36);
    let a_1 = real(0.62) + t1 + params.m_e;
    let t2 = params.m_e * real(0.6);
    let a_3 = t2 * real(0.8660254037844386);
    let a_4 = t2 * real(0.5);
    let a_2 = real(0.25) + t1;
    let M_11_1 = real(2.0) * a_3;
    let M_11_2 = real(2.0) * a_4;
    Prepared {
        a_1,
        a_3,
        M_11_1,
        a_4,
        M_11_2,
        a_2,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `y_r(t)`
    pub y_r: Vector<T, 2>,
    /// `y_r'`
    pub y_r_dot: Vector<T, 2>,
    /// `k_1(t)`
    pub k1: T,
    /// `k_2(t)`
    pub k2: T,
    /// Part of `E1_free`.
    pub E1_free_1: T,
    /// Part of `E2_free`.
    pub E2_free_1: T,
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
            k2: self.k2.in_every_lane(lane),
            E1_free_1: self.E1_free_1.in_every_lane(lane),
            E2_free_1: self.E2_free_1.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 3 additions, 11 multiplications, 2 divisions, 0 square roots, 3 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(2.0) * t;
    let t2 = real(1.0) - t1.cos();
    // y_r(t)
    let y_r = Vector([real(0.5235987755982989) * t2, real(FRAC_PI_4) * t2]);
    let t3 = t1.sin() * real(2.0);
    // y_r'
    let y_r_dot = Vector([real(0.5235987755982989) * t3, real(FRAC_PI_4) * t3]);
    let t4 = (real(-2.0) * t).exp();
    // k_1(t)
    let k1 = real(0.3) * t4 + real(0.05);
    // k_2(t)
    let k2 = real(4.0) * t4 + real(1.0);
    let E1_free_1 = real(1.0) / (k1 * k1);
    let E2_free_1 = real(1.0) / (k2 * k2);
    Clock {
        y_r,
        y_r_dot,
        k1,
        k2,
        E1_free_1,
        E2_free_1,
    }
}

/// Results of [`control`].
#[derive(Clone, Copy, Debug)]
pub struct ControlOutputs<T: Real> {
    /// `u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub u: Vector<T, 2>,
    /// `sat(u), each component limited to +-u_max (8)`
    pub u_sat: Vector<T, 2>,
    /// `some E_i >= pi/2 - delta`
    pub violated: T::Mask,
    /// `y_r(t)`
    pub y_r: Vector<T, 2>,
    /// `e_1 = x_1 - y_r - zeta_1`
    pub e1: Vector<T, 2>,
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 2>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 2>,
    /// `k_2(t)`
    pub k2: T,
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 2>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `joints`, which are numbers in the formulas: `K = 4`, `kbar = 4`, `C = 20
/// I`, `Fl = 0.02 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 8`, `kbar = 8`, `C = 50
/// I`, `S = (12 0; 36 0; 0 8; 0 2; 0 11)`, `M = diag((0 1; 0 0), (0 0 0; 0 0 3; 0 -3 0))`, `L =
/// diag((1 0), (1 1 0))`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`, `iota_0 = 0.1`,
/// `b = 1`.
///
/// Operations: 178 additions, 258 multiplications, 5 divisions, 0 square roots, 8 elementary
/// functions, 13 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 2>,
    x2: Vector<T, 2>,
    state: &mut State<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let q2 = x1[1];
    let t1 = q2.cos();
    let t2 = q2.sin();
    let M_11 = prepared.a_1 + prepared.M_11_1 * t1 + prepared.M_11_2 * t2;
    let M_12 = prepared.a_2 + prepared.a_3 * t1 + prepared.a_4 * t2;
    let M = Matrix::rows([[M_11, M_12], [M_12, prepared.a_2]]);
    let coriolis = prepared.a_3 * t2 - prepared.a_4 * t1;
    let v2 = x2[1];
    let v1 = x2[0];
    let torque = Vector([-v2 * v1 - (v1 + v2) * v2, v1 * v1]) * coriolis;

    // -- known dynamics of block 2 (rates) (11) --
    let t3 = real(1.0) / (M_11 * prepared.a_2 - M_12 * M_12);
    let t4 = -M_12 * t3;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[prepared.a_2 * t3, t4], [t4, M_11 * t3]]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t5 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t5 * t5);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 - state.h1 - state.zeta2;

    // -- barrier of block 2 (23) (26) --
    // s_2 = e_2^T e_2
    let s2 = e2.sum_squares();
    let t6 = s2 * clock.E2_free_1;
    // pi s_2^2 / (2 k_2^4), before the clamp
    let E2_free = real(FRAC_PI_2) * (t6 * t6);
    // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
    let E2 = E2_free.min(real(1.5697963267948967));
    let t7 = Vector([E1, E2]);
    let [cos_E1, cos_E2] = t7.cos().0;
    // cos E_2
    let cosE2 = cos_E2;
    // E_2 >= pi/2 - delta
    let violated2 = E2_free.ge(real(1.5697963267948967));
    let t8 = cosE2 * cosE2;
    // 1 / cos^2 E_2
    let sec2E2 = real(1.0) / t8;
    let t9 = s2 * sec2E2;
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * t9;

    // -- barrier of block 1 (23) (26) --
    // cos E_1
    let cosE1 = cos_E1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t10 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t10;

    // -- robust feedback of block 1 (31) --
    let [sin_E1, sin_E2] = t7.sin().0;
    let t11 = real(5.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            sin_E1 * cosE1 * (real(1.0) / E1_free),
        ) + real(4.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t11 + t10 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t12 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t12 - clock.y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t12;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(50.0);

    // -- MTPN of block 2 (4) (16) --
    // z_2, network inputs
    let z2 = Vector([v1, v2, q2]);
    // P_2 = P_m(z_2), 20 nodes
    let P2 = polynomials::basis2(z2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (49) --
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2
        + Vector([
            real(12.0) * e2[0],
            real(36.0) * e2[0],
            real(8.0) * e2[1],
            real(2.0) * e2[1],
            real(11.0) * e2[1],
        ]);
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([w_hat2[0], w_hat2[2] + w_hat2[3]]);

    // -- robust feedback of block 2 (63) --
    let t13 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t13 * state.eps2;
    let t14 = real(10.0)
        * T::select(
            E2_free.lt(real(1e-300)),
            real(1.0),
            sin_E2 * cosE2 * (real(1.0) / E2_free),
        ) + real(8.0);
    let t15 = t14 + t9 * real(0.9999999999999998) + real(0.5) * sec2E2
        + s_c1 * s_c1 * real(0.25) * t8;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b)
    // (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38)
    let Lam2 = e2 * t15 + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t16 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = A_hat2 - G2 * torque - h1_dot + t16 + D_hat2 + Lam2;
    let t17 = M * bracket2;
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t17;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 2>::from_f64([-60.0, -30.0]))
        .min(Vector::<T, 2>::from_f64([60.0, 30.0]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = G2 * (u_sat + t17) - t16;

    // -- observer dynamics of block 2 (50) --
    let t18 = Vector([
        real(12.0) * Lam2[0],
        real(36.0) * Lam2[0],
        real(8.0) * Lam2[1],
        real(2.0) * Lam2[1],
        real(11.0) * Lam2[1],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = Vector([
        w_hat2[1],
        real(0.0),
        real(0.0),
        real(3.0) * w_hat2[4],
        real(-3.0) * w_hat2[3],
    ]) + t18;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (t9 * e2.dot(t13) - state.eps2);

    // -- status --
    // some E_i >= pi/2 - delta
    let violated = violated1.or(violated2);

    // -- states of block 2, one sample later --
    // g(S_2 L_2 - M_2)
    let th2_weight: Matrix<T, 5, 5> = Matrix::from_f64([
        [0.001976143425723861, 1.984071770174817e-6, 0.0, 0.0, 0.0],
        [-7.142658372629343e-5, 0.001999952286965959, 0.0, 0.0, 0.0],
        [
            0.0,
            0.0,
            0.0019841063100194665,
            -1.5893642172162748e-5,
            -3.1840370705434745e-8,
        ],
        [0.0, 0.0, -4.0171910527606606e-6, 0.001995970820999854, 5.991956185266466e-6],
        [0.0, 0.0, -2.1845797894047418e-5, -2.784571417199025e-5, 0.0019999442315428947],
    ]);
    // g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    let th2_step = th2_weight * th2_dot;

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.0019605280423838395);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0019032516392808085);

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
    ControlOutputs {
        u,
        u_sat,
        violated,
        y_r: clock.y_r,
        e1,
        k1: clock.k1,
        alpha1,
        e2,
        k2: clock.k2,
        D_hat2,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `joints`, which are numbers in the formulas: `K = 4`, `kbar = 4`, `C = 20
/// I`, `Fl = 0.02 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 8`, `kbar = 8`, `C = 50
/// I`, `S = (12 0; 36 0; 0 8; 0 2; 0 11)`, `M = diag((0 1; 0 0), (0 0 0; 0 0 3; 0 -3 0))`, `L =
/// diag((1 0), (1 1 0))`, `eta_1 = 1`, `Gamma = 1`, `lambda = 0.1`, `iota = 1`, `iota_0 = 0.1`,
/// `b = 1`.
///
/// Operations: 184 additions, 275 multiplications, 7 divisions, 0 square roots, 11 elementary
/// functions, 13 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 2>,
    x2: Vector<T, 2>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    law(x1, x2, state, &prepared, &clock)
}
