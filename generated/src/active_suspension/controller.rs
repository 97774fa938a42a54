// SHA-256 of the text below: d71a64b1cc9e016271fdd285acfd322a036a3c338e66a93f0f885c3a61c5457d
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 20 additions, 46 multiplications, 5 divisions, 0 square roots, 6 elementary functions, 3 comparisons and selections
// control: 94 additions, 145 multiplications, 7 divisions, 2 square roots, 8 elementary functions, 9 comparisons and selections

//! `active_suspension`: control law and sampled controller.
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

/// Largest magnitude of each control: `command` in dimensionless.
pub const INPUT_LIMIT: [f64; 1] = [2.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.001;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 1] = [0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): height (z).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): speed (v).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 zeta_3`
    pub zeta2: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): actuator (f).
    ///
    /// `zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)`
    pub zeta3: Vector<T, 1>,
    /// Filtered virtual control h (33): speed (v).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 1>,
    /// Network weights W_hat, one row per monomial and one column per channel: speed (v).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (32): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, z, v, z2, z_v, v2, z3, z2_v, z_v2, v3`.
    pub W2: Matrix<T, 10, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// speed (v).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2) (50)`
    pub th2: Vector<T, 3>,
    /// Bound eps_hat of the approximation error (66): speed (v).
    ///
    /// `eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)`
    pub eps2: T,
    /// Filtered virtual control h (33): actuator (f).
    ///
    /// `h_2' = (alpha_2 - h_2) / Fl_2`
    pub h2: Vector<T, 1>,
    /// Bound sigma_hat of the noise intensity (67): actuator (f).
    ///
    /// `sigma_hat_3' = taubar_3 (||H_3||^2 ||Ybar_3|| s_3^2 / (cos^2 E_3 sqrt(s_3^2 +
    /// varsigma_3^2)) - lambda_sigma sigma_hat_3)`
    pub sigma3: T,
    /// Noise term phi (68), kept positive: actuator (f).
    ///
    /// `phi_3(t + dt) = phi_3 exp(-dt (Psi_3/(phi_3^2 + s_3^2) + kappa_phi)) if ||e_3|| >=
    /// iota_phi, else phi_3; at least phi_min (68), erratum 11`
    pub phi3: T,
}

impl<T: Real> State<T> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            zeta1: Vector::zero(),
            zeta2: Vector::zero(),
            zeta3: Vector::zero(),
            h1: Vector::zero(),
            W2: Matrix::zero(),
            th2: Vector::zero(),
            eps2: T::zero(),
            h2: Vector::zero(),
            sigma3: T::zero(),
            phi3: T::zero(),
        }
    }

    /// `a` where the mask is true, else `b`.
    #[inline(always)]
    pub fn select(mask: T::Mask, a: &Self, b: &Self) -> Self {
        Self {
            zeta1: Vector::select(mask, a.zeta1, b.zeta1),
            zeta2: Vector::select(mask, a.zeta2, b.zeta2),
            zeta3: Vector::select(mask, a.zeta3, b.zeta3),
            h1: Vector::select(mask, a.h1, b.h1),
            W2: Matrix::select(mask, a.W2, b.W2),
            th2: Vector::select(mask, a.th2, b.th2),
            eps2: T::select(mask, a.eps2, b.eps2),
            h2: Vector::select(mask, a.h2, b.h2),
            sigma3: T::select(mask, a.sigma3, b.sigma3),
            phi3: T::select(mask, a.phi3, b.phi3),
        }
    }

    /// Whether every entry is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> T::Mask {
        self.zeta1
            .is_finite()
            .and(self.zeta2.is_finite())
            .and(self.zeta3.is_finite())
            .and(self.h1.is_finite())
            .and(self.W2.is_finite())
            .and(self.th2.is_finite())
            .and(self.eps2.is_finite())
            .and(self.h2.is_finite())
            .and(self.sigma3.is_finite())
            .and(self.phi3.is_finite())
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
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
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
        }
    }
}

/// Active suspension on a rough road
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
        let law = law(x1, x2, x3, &mut self.state, &self.prepared, clock);
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
        let start = initial(self.t, self.x1, self.x2, self.x3, &self.controller.params);
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
/// Operations: 20 additions, 46 multiplications, 5 divisions, 0 square roots, 6 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    _x3: Vector<T, 1>,
    params: &Params<T>,
) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let z = x1[0];
    let v = x2[0];

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = real(1.0) / params.body_mass;
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        -(real(16000.0) * z + real(400000.0) * (z * z * z) + real(1000.0) * v) * t1,
    ]);
    let t2 = real(1000.0) * t1;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t2]]);

    // -- reference and constraints --
    let t3 = real(0.8) * t;
    let t4 = (real(3.0) * t3.sin()).tanh();
    // y_r(t)
    let y_r = Vector([real(0.05) * t4]);
    // y_r'
    let y_r_dot = Vector([
        real(0.05) * ((real(1.0) - t4 * t4) * (real(3.0) * (t3.cos() * real(0.8)))),
    ]);
    // k_1(t)
    let k1 = real(0.03) * (real(-2.0) * t).exp() + real(0.002);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 1> = Vector::zero();
    let zeta2: Vector<T, 1> = Vector::zero();
    let W2: Matrix<T, 10, 1> = Matrix::zero();
    let eps2 = real(0.0);
    let zeta3: Vector<T, 1> = Vector::zero();
    let sigma3 = real(0.0);
    let phi3 = real(2.0);

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t5 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t5 * t5);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t6 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t6;

    // -- robust feedback of block 1 (31) --
    let t7 = real(6.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(4.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t7 + t6 * real(0.5));
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

    // -- disturbance observer of block 2 (49) --
    // S_2, observer gain
    let S2: Matrix<T, 3, 1> = Matrix::from_f64([[2.0], [-0.18], [14.0]]);
    let t8 = S2 * e2;
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = t8 - t8;
    // L_2
    let L2: Matrix<T, 1, 3> = Matrix::from_f64([[53.3, 53.3, 3.33]]);
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = L2 * w_hat2;

    // -- given --
    let th2 = -t8;

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();

    // -- robust feedback of block 2 (31) --
    let t9 = real(30.0) + s2 * real(2846.4344499999997) + s2 * (real(0.05) * G_norm2_2)
        + real(0.5);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + eta_2/2 ||G||^2 c^T (37) + e / (2 cos^2 E)
    // (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of
    // the outer block (38)
    let Lam2 = e2 * (t9 + s_c1 * s_c1 * real(0.25));

    // -- virtual control (31) of block 2 --
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + D_hat2 + Lam2;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -(bracket2 * (real(1.0) / t2));
    State {
        zeta1,
        zeta2,
        zeta3,
        h1: alpha1,
        W2,
        th2,
        eps2,
        h2: alpha2,
        sigma3,
        phi3,
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `F2`.
    pub F2_1: T,
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
/// Operations: 0 additions, 3 multiplications, 2 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;
    let F2_1 = real(1.0) / params.body_mass;

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = real(1000.0) * F2_1;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t1]]);

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();
    let Lam2_1 = real(0.05) * G_norm2_2;
    let alpha2_1 = real(1.0) / t1;
    Prepared {
        F2_1,
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
/// Operations: 2 additions, 11 multiplications, 1 divisions, 0 square roots, 4 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(0.8) * t;
    let t2 = (real(3.0) * t1.sin()).tanh();
    // y_r(t)
    let y_r = Vector([real(0.05) * t2]);
    // y_r'
    let y_r_dot = Vector([
        real(0.05) * ((real(1.0) - t2 * t2) * (real(3.0) * (t1.cos() * real(0.8)))),
    ]);
    // k_1(t)
    let k1 = real(0.03) * (real(-2.0) * t).exp() + real(0.002);
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
    /// `u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]`
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
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `height`, which are numbers in the formulas: `K = 8`, `kbar = 4`, `C = 20`,
/// `Fl = 0.005 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `speed`, which are numbers in the formulas: `K = 40`, `kbar = 10`, `C = 50`,
/// `Fl = 0.001 s`, `S = (2; -0.18; 14)`, `M = (-0.5 0 0; 0 0 1; 0 -3167 -5.6)`, `N = (0.02 0; 0 0; 0 0.4)`,
/// `L = (53.3 53.3 3.33)`, `eta_1 = 1`, `eta_2 = 0.1`, `eta_3 = 1`, `Gamma = 1`, `lambda = 0.1`,
/// `iota = 1`, `iota_0 = 0.1`, `b = 0.1`.
///
/// Gains of block 3, `actuator`, which are numbers in the formulas: `K = 200`, `kbar = 50`, `C = 100`,
/// `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 0.1`, `kappa_phi = 0.5`, `iota_phi = 0.02`.
///
/// Operations: 92 additions, 131 multiplications, 4 divisions, 2 square roots, 4 elementary
/// functions, 9 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    state: &mut State<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let z = x1[0];
    let v = x2[0];
    let f = x3[0];

    // -- known dynamics of block 2 (speed) (11) --
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        -(real(16000.0) * z + real(400000.0) * (z * z * z) + real(1000.0) * v)
            * prepared.F2_1,
    ]);

    // -- known dynamics of block 3 (actuator) (11) --
    // F_3(x_1 .. x_3)
    let F3 = Vector([real(-60.0) * f]);

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

    // -- robust feedback of block 1 (31) --
    let t3 = real(6.0)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(4.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t3 + t2 * real(0.5));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t4 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t4 - clock.y_r_dot + Lam1;
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -bracket1;

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = state.zeta2 - t4;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(200.0);

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
    let z2 = Vector([z * real(20.0), v * real(5.0)]);
    // P_2 = P_m(z_2), 10 nodes
    let P2 = polynomials::basis2(z2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (49) --
    // S_2, observer gain
    let S2: Matrix<T, 3, 1> = Matrix::from_f64([[2.0], [-0.18], [14.0]]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + S2 * e2;
    // L_2
    let L2: Matrix<T, 1, 3> = Matrix::from_f64([[53.3, 53.3, 3.33]]);
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = L2 * w_hat2;

    // -- robust feedback of block 2 (31) --
    let t5 = (e2 * real(10.0)).tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t5 * state.eps2;
    let t6 = real(30.0) + s2 * real(2846.4344499999997) + s2 * prepared.Lam2_1
        + real(0.5) + s_c1 * s_c1 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + eta_2/2 ||G||^2 c^T (37) + e / (2 cos^2 E)
    // (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of
    // the outer block (38)
    let Lam2 = e2 * t6 + Lam2_error_bound;
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t7 = F2 + A_hat2;
    let t8 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t7 - h1_dot + t8 + D_hat2 + Lam2;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -(bracket2 * prepared.alpha2_1);

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = prepared.G2 * state.zeta3 - t8;

    // -- observer dynamics of block 2 (50) --
    // M_2 - S_2 L_2
    let w2_closed: Matrix<T, 3, 3> = Matrix::from_f64([
        [-107.1, -106.6, -6.66],
        [9.594, 9.594, 1.5994000000000002],
        [-746.1999999999999, -3913.2, -52.220000000000006],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2) (50)
    let th2_dot = w2_closed * w_hat2
        - S2 * (t7 + prepared.G2 * (x3 - state.zeta3) - h1_dot + t8);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t5) - state.eps2);

    // -- dynamic surface filter of block 2 (33) --
    // h_2' = (alpha_2 - h_2) / Fl_2
    let h2_dot = (alpha2 - state.h2) * real(1000.0);

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 - state.h2 - state.zeta3;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();

    // -- noise terms of block 3 (58) (62) --
    // Psi_3 = ||H_3||^4 ||Ybar_3||^2 varsigma_3^2/2 + 2 ||N_3||^2 + eta_noise ||S_3 H_3||^4 (62)
    let Psi3 = real(0.09331199999999999);

    // -- robust feedback of block 3 (63) --
    let t9 = s3 * s3;
    // 1 / sqrt(s_3^2 + varsigma_3^2)
    let s_scale3 = real(1.0) / (t9 + real(0.010000000000000002)).sqrt();
    let t10 = prepared.G_norm2_2 * s_c2;
    let t11 = Psi3 / (state.phi3 * state.phi3 + t9);
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer
    // block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 + e
    // Psi cos^2 E / (phi^2 + s^2) (64)
    let Lam3 = e3
        * (real(150.0) + t10 * t10 * real(0.25) + real(4.32) * state.sigma3 * s_scale3
            + t11);

    // -- control (64) of block 3 --
    let t12 = state.zeta3 * real(100.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = F3 - h2_dot + t12 + Lam3;
    let t13 = bracket3 * real(0.016666666666666666);
    // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let u = -t13;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-2.0))).min(Vector::splat(real(2.0)));

    // -- auxiliary system of block 3 (13), erratum 1 --
    // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
    let zeta3_dot = (u_sat + t13) * real(60.0) - t12;

    // -- noise bound of block 3 (67) --
    // sigma_hat_3' = taubar_3 (||H_3||^2 ||Ybar_3|| s_3^2 / (cos^2 E_3 sqrt(s_3^2 + varsigma_3^2))
    // - lambda_sigma sigma_hat_3)
    let sigma3_dot = real(4.32) * t9 * s_scale3 - real(0.1) * state.sigma3;

    // -- compensation of block 3 (68) --
    // Psi_3/(phi_3^2 + s_3^2) + kappa_phi
    let phi3_decay = t11 + real(0.5);

    // -- states of block 2, one sample later --
    // g(S_2 L_2 - M_2)
    let th2_weight: Matrix<T, 3, 3> = Matrix::from_f64([
        [0.0009489395474816429, -4.7418858827792715e-5, -3.1852741210029903e-6],
        [4.452677660265132e-6, 0.0010036263973934641, 7.780777620487019e-7],
        [-0.0003598454138262539, -0.001916026513342128, 0.00097412070020468],
    ]);
    // g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    let th2_step = th2_weight * th2_dot;

    // -- states of block 3, one sample later --
    // phi_min = sqrt(Psi_3 dt / 0.1), erratum 11
    let phi3_min = real(0.030547012947258853);

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.000990066334662235);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0009063462346100907);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0009754115099857198);
    // h2(t + dt) = h2 + g h2', g = (1 - exp(-a dt))/a, a = 1/Fl_2 (33)
    state.h2 = state.h2 + h2_dot * real(0.0006321205588285577);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    state.th2 = state.th2 + th2_step;
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (32): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(real(0.9999000049998333), P2, c2 * real(0.000999950001666625));
    // eps2(t + dt) = eps2 + g eps2', g = (1 - exp(-a dt))/a, a = iota_20 (66)
    state.eps2 = state.eps2 + real(0.000999950001666625) * eps2_dot;

    // -- states of block 3, one sample later --
    // zeta3(t + dt) = zeta3 + g zeta3', g = (1 - exp(-a dt))/a, a = C_3 (13)
    state.zeta3 = state.zeta3 + zeta3_dot * real(0.0009516258196404043);
    // sigma3(t + dt) = sigma3 + g sigma3', g = (1 - exp(-a dt))/a, a = taubar_3 lambda_sigma (67)
    state.sigma3 = state.sigma3 + real(0.000999950001666625) * sigma3_dot;
    // phi_3(t + dt) = phi_3 exp(-dt (Psi_3/(phi_3^2 + s_3^2) + kappa_phi)) if ||e_3|| >= iota_phi,
    // else phi_3; at least phi_min (68), erratum 11
    state.phi3 = T::select(
            s3.sqrt().ge(real(0.02)),
            state.phi3 * (-(real(0.001) * phi3_decay)).exp(),
            state.phi3,
        )
        .max(phi3_min);
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
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `height`, which are numbers in the formulas: `K = 8`, `kbar = 4`, `C = 20`,
/// `Fl = 0.005 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `speed`, which are numbers in the formulas: `K = 40`, `kbar = 10`, `C = 50`,
/// `Fl = 0.001 s`, `S = (2; -0.18; 14)`, `M = (-0.5 0 0; 0 0 1; 0 -3167 -5.6)`, `N = (0.02 0; 0 0; 0 0.4)`,
/// `L = (53.3 53.3 3.33)`, `eta_1 = 1`, `eta_2 = 0.1`, `eta_3 = 1`, `Gamma = 1`, `lambda = 0.1`,
/// `iota = 1`, `iota_0 = 0.1`, `b = 0.1`.
///
/// Gains of block 3, `actuator`, which are numbers in the formulas: `K = 200`, `kbar = 50`, `C = 100`,
/// `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 0.1`, `kappa_phi = 0.5`, `iota_phi = 0.02`.
///
/// Operations: 94 additions, 145 multiplications, 7 divisions, 2 square roots, 8 elementary
/// functions, 9 comparisons and selections.
#[inline(always)]
pub fn control<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    state: &mut State<T>,
    params: &Params<T>,
) -> ControlOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    law(x1, x2, x3, state, &prepared, &clock)
}
