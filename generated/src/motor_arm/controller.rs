// SHA-256 of the text below: 68f5cc05c515608a583af09475d8df0f2a52641b5f86baab4bfa75ef81bbab89
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 21 additions, 58 multiplications, 6 divisions, 0 square roots, 7 elementary functions, 3 comparisons and selections
// control: 78 additions, 127 multiplications, 7 divisions, 3 square roots, 9 elementary functions, 9 comparisons and selections

//! `motor_arm`: control law and sampled controller.
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

/// Largest magnitude of each control: `voltage` in kg*m^2/(s^3*A).
pub const INPUT_LIMIT: [f64; 1] = [40.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.001;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 1] = [0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): position (angle).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): speed (rate).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 zeta_3`
    pub zeta2: Vector<T, 1>,
    /// Auxiliary anti-windup state zeta (13): current (amps).
    ///
    /// `zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)`
    pub zeta3: Vector<T, 1>,
    /// Filtered virtual control h (33): speed (rate).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 1>,
    /// Network weights W_hat, one row per monomial and one column per channel: speed (rate).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (32): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, z1, rate, z12, z1_rate, rate2`.
    pub W2: Matrix<T, 6, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// speed (rate).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2) (50)`
    pub th2: Vector<T, 1>,
    /// Bound eps_hat of the approximation error (66): speed (rate).
    ///
    /// `eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)`
    pub eps2: T,
    /// Bound sigma_hat of the noise intensity (67): speed (rate).
    ///
    /// `sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
    /// varsigma_2^2)) - lambda_sigma sigma_hat_2)`
    pub sigma2: T,
    /// Noise term phi (68), kept positive: speed (rate).
    ///
    /// `phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >=
    /// iota_phi, else phi_2; at least phi_min (68), erratum 11`
    pub phi2: T,
    /// Filtered virtual control h (33): current (amps).
    ///
    /// `h_2' = (alpha_2 - h_2) / Fl_2`
    pub h2: Vector<T, 1>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// current (amps).
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
            h1: Vector::zero(),
            W2: Matrix::zero(),
            th2: Vector::zero(),
            eps2: T::zero(),
            sigma2: T::zero(),
            phi2: T::zero(),
            h2: Vector::zero(),
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
            h1: Vector::select(mask, a.h1, b.h1),
            W2: Matrix::select(mask, a.W2, b.W2),
            th2: Vector::select(mask, a.th2, b.th2),
            eps2: T::select(mask, a.eps2, b.eps2),
            sigma2: T::select(mask, a.sigma2, b.sigma2),
            phi2: T::select(mask, a.phi2, b.phi2),
            h2: Vector::select(mask, a.h2, b.h2),
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
            .and(self.h1.is_finite())
            .and(self.W2.is_finite())
            .and(self.th2.is_finite())
            .and(self.eps2.is_finite())
            .and(self.sigma2.is_finite())
            .and(self.phi2.is_finite())
            .and(self.h2.is_finite())
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
    /// `k_1(t)`
    pub k1: T,
    /// `alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]`
    pub alpha1: Vector<T, 1>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 1>,
    /// `alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub alpha2: Vector<T, 1>,
    /// `w_hat_2 = th_2 + S_2 e_2`
    pub D_hat2: Vector<T, 1>,
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
            k1: T::zero(),
            alpha1: Vector::zero(),
            e2: Vector::zero(),
            alpha2: Vector::zero(),
            D_hat2: Vector::zero(),
            e3: Vector::zero(),
            D_hat3: Vector::zero(),
        }
    }
}

/// Arm driven by a DC motor with current dynamics
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
/// Operations: 21 additions, 58 multiplications, 6 divisions, 0 square roots, 7 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(
    t: T,
    x1: Vector<T, 1>,
    x2: Vector<T, 1>,
    x3: Vector<T, 1>,
    params: &Params<T>,
) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let rate = x2[0];
    let weight = (real(0.253) + params.load_mass) * real(0.305) * real(9.81);
    let angle = x1[0];
    let inertia = real(0.017315216666666668) + params.load_mass * real(0.093025)
        + real(2.0) * params.load_mass * real(0.000529) * real(0.2);

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = real(1.0) / inertia;
    // F_2(x_1 .. x_2)
    let F2 = Vector([-(real(0.01625) * rate + weight * angle.sin()) * t1]);
    let t2 = real(0.9) * t1;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t2]]);
    // H_2(x_1 .. x_2)
    let H2 = Matrix::rows([[real(0.01) * t1]]);

    // -- reference and constraints --
    let t3 = real(FRAC_PI_2) * t.sin();
    let t4 = t * t;
    let t5 = (real(-0.1) * (t4 * t)).exp();
    let t6 = real(1.0) - t5;
    // y_r(t)
    let y_r = Vector([t3 * t6]);
    // y_r'
    let y_r_dot = Vector([
        t6 * (real(FRAC_PI_2) * t.cos()) - t3 * (t5 * (real(-0.1) * (real(3.0) * t4))),
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
    let eps2 = real(0.0);
    let sigma2 = real(0.0);
    let phi2 = real(10.0);
    let zeta3: Vector<T, 1> = Vector::zero();
    let th3 = -(x3 * real(50.0));

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t7 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t7 * t7);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t8 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t8;

    // -- robust feedback of block 1 (31) --
    let t9 = real(3.2199999999999998)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(1.72);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t9 + t8 * real(0.5));
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

    // -- given --
    let th2 = -(e2 * real(10.0));

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // ||Ybar_2||^2
    let Ybar_square2 = real(9.0);
    // S_2
    let S2: Matrix<T, 1, 1> = Matrix::from_f64([[10.0]]);
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(0.5)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (31) --
    let t10 = real(45.0) + s2 * real(0.5) + s2 * (real(0.05) * G_norm2_2) + real(0.5);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + eta_2/2 ||G||^2 c^T (37) + e / (2 cos^2 E)
    // (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of
    // the outer block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4
    // and 7 + e Psi cos^2 E / (phi^2 ...
    let Lam2 = e2 * (t10 + s_c1 * s_c1 * real(0.25) + Psi2 / (real(100.0) + s2 * s2));

    // -- virtual control (31) of block 2 --
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + Lam2;
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
        sigma2,
        phi2,
        h2: alpha2,
        th3,
    }
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// `weight`.
    pub weight: T,
    /// Part of `F2`.
    pub F2_1: T,
    /// `G_2(x_1 .. x_2)`
    pub G2: Matrix<T, 1, 1>,
    /// `||G_2||^2`
    pub G_norm2_2: T,
    /// `Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)`
    pub Psi2: T,
    /// Part of `Lam2`.
    pub Lam2_1: T,
    /// Part of `Lam2`.
    pub Lam2_2: T,
    /// Part of `alpha2`.
    pub alpha2_1: T,
    /// `phi_min = sqrt(Psi_2 dt / 0.1), erratum 11`
    pub phi2_min: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 5 additions, 20 multiplications, 2 divisions, 1 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let weight = (real(0.253) + params.load_mass) * real(0.305) * real(9.81);
    let inertia = real(0.017315216666666668) + params.load_mass * real(0.093025)
        + real(2.0) * params.load_mass * real(0.000529) * real(0.2);

    // -- noise terms of block 2 (58) (62) --
    // ||Ybar_2||^2
    let Ybar_square2 = real(9.0);
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(3.0);
    // S_2
    let S2: Matrix<T, 1, 1> = Matrix::from_f64([[10.0]]);
    let F2_1 = real(1.0) / inertia;

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = real(0.9) * F2_1;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([[t1]]);
    // H_2(x_1 .. x_2)
    let H2 = Matrix::rows([[real(0.01) * F2_1]]);

    // -- norms of block 2 --
    // ||G_2||^2
    let G_norm2_2 = G2.sum_squares();

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // S_2 H_2
    let SH2 = S2 * H2;
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5) + real(0.5)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- states of block 2, one sample later --
    // phi_min = sqrt(Psi_2 dt / 0.1), erratum 11
    let phi2_min = (Psi2 * real(0.01)).sqrt();
    let Lam2_1 = real(0.05) * G_norm2_2;
    let Lam2_2 = H_norm2_2 * Ybar_norm2;
    let alpha2_1 = real(1.0) / t1;
    Prepared {
        weight,
        F2_1,
        G2,
        G_norm2_2,
        Psi2,
        Lam2_1,
        Lam2_2,
        alpha2_1,
        phi2_min,
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
    let t1 = real(FRAC_PI_2) * t.sin();
    let t2 = t * t;
    let t3 = (real(-0.1) * (t2 * t)).exp();
    let t4 = real(1.0) - t3;
    // y_r(t)
    let y_r = Vector([t1 * t4]);
    // y_r'
    let y_r_dot = Vector([
        t4 * (real(FRAC_PI_2) * t.cos()) - t1 * (t3 * (real(-0.1) * (real(3.0) * t2))),
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
    /// `w_hat_2 = th_2 + S_2 e_2`
    pub D_hat2: Vector<T, 1>,
    /// `e_3 = x_3 - h_2 - zeta_3`
    pub e3: Vector<T, 1>,
    /// `D_hat_3 = th_3 + S_3 x_3`
    pub D_hat3: Vector<T, 1>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `position`, which are numbers in the formulas: `K = 6`, `kbar = 1.72`, `C = 20`,
/// `Fl = 0.02 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `speed`, which are numbers in the formulas: `K = 20`, `kbar = 20`, `C = 50`,
/// `Fl = 0.005 s`, `S = 10`, `M = -2`, `N = 0.5`, `L = 1`, `eta_1 = 1`, `eta_2 = 0.1`, `eta_3 = 2`,
/// `Gamma = 1`, `lambda = 0.1`, `iota = 1`, `iota_0 = 0.1`, `b = 1`, `eta_noise = 0.1`, `taubar = 1`,
/// `lambda_sigma = 0.1`, `varsigma = 1`, `kappa_phi = 0.5`, `iota_phi = 0.2`.
///
/// Gains of block 3, `current`, which are numbers in the formulas: `K = 100`, `kbar = 100`, `C = 100`,
/// `S = 50`, `eta_1 = 1`.
///
/// Operations: 70 additions, 93 multiplications, 4 divisions, 2 square roots, 5 elementary
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
    let rate = x2[0];
    let angle = x1[0];
    let amps = x3[0];

    // -- known dynamics of block 2 (speed) (11) --
    let t1 = angle.sin();
    // F_2(x_1 .. x_2)
    let F2 = Vector([-(real(0.01625) * rate + prepared.weight * t1) * prepared.F2_1]);

    // -- known dynamics of block 3 (current) (11) --
    // F_3(x_1 .. x_3)
    let F3 = Vector([-(real(5.0) * amps + real(0.9) * rate) * real(40.0)]);

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
    let t4 = real(3.2199999999999998)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(1.72);
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
    let z2 = Vector([t1, rate]);
    // P_2 = P_m(z_2), 6 nodes
    let P2 = polynomials::basis2(z2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2);

    // -- disturbance observer of block 2 (49) --
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + e2 * real(10.0);

    // -- robust feedback of block 2 (31) --
    let t6 = e2.tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t6 * state.eps2;
    let t7 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t7 + real(1.0)).sqrt();
    let t8 = prepared.Psi2 / (state.phi2 * state.phi2 + t7);
    let t9 = real(45.0) + s2 * real(0.5) + s2 * prepared.Lam2_1 + real(0.5)
        + s_c1 * s_c1 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + eta_2/2 ||G||^2 c^T (37) + e / (2 cos^2 E)
    // (63) + eps_hat Tanh(e / b) (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of
    // the outer block (38) + ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4
    // and 7 + e Psi cos^2 E / (phi^2 ...
    let Lam2 = e2 * (t9 + prepared.Lam2_2 * state.sigma2 * s_scale2 + t8)
        + Lam2_error_bound;
    // ||c_2||^2
    let s_c2 = c2.sum_squares();

    // -- virtual control (31) of block 2 --
    let t10 = F2 + A_hat2;
    let t11 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = t10 - h1_dot + t11 + w_hat2 + Lam2;
    // alpha_2 = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let alpha2 = -(bracket2 * prepared.alpha2_1);

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 zeta_3
    let zeta2_dot = prepared.G2 * state.zeta3 - t11;

    // -- observer dynamics of block 2 (50) --
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 v_2 - h_1' + C_2 zeta_2 + A_hat_2) (50)
    let th2_dot = w_hat2 * real(-12.0)
        - (t10 + prepared.G2 * (x3 - state.zeta3) - h1_dot + t11) * real(10.0);

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t6) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = prepared.Lam2_2 * t7 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t8 + real(0.5);

    // -- dynamic surface filter of block 2 (33) --
    // h_2' = (alpha_2 - h_2) / Fl_2
    let h2_dot = (alpha2 - state.h2) * real(200.0);

    // -- error variable of block 3 (14) --
    // e_3 = x_3 - h_2 - zeta_3
    let e3 = x3 - state.h2 - state.zeta3;

    // -- barrier of block 3 (23) (26) --
    // s_3 = e_3^T e_3
    let s3 = e3.sum_squares();

    // -- disturbance observer of block 3 (20) --
    // D_hat_3 = th_3 + S_3 x_3
    let D_hat3 = state.th3 + x3 * real(50.0);

    // -- robust feedback of block 3 (63) --
    let t12 = prepared.G_norm2_2 * s_c2;
    // Lam_3 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c,
    // eta_3 of the outer block (38)
    let Lam3 = e3 * (real(225.0) + s3 * real(0.5) + t12 * t12 * real(0.015625));

    // -- control (64) of block 3 --
    let t13 = state.zeta3 * real(100.0);
    // F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3
    let bracket3 = F3 - h2_dot + t13 + D_hat3 + Lam3;
    let t14 = bracket3 * real(0.025);
    // u = -G_3^-1 [ F_3 + A_hat_3 - h_2' + C_3 zeta_3 + D_hat_3 + Lam_3 ]
    let u = -t14;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u.max(Vector::splat(real(-40.0))).min(Vector::splat(real(40.0)));

    // -- auxiliary system of block 3 (13), erratum 1 --
    // zeta_3' = -C_3 zeta_3 + G_3 (sat(u) - u)
    let zeta3_dot = (u_sat + t14) * real(40.0) - t13;

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.000990066334662235);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0009754115099857198);

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0009754115099857198);
    // h2(t + dt) = h2 + g h2', g = (1 - exp(-a dt))/a, a = 1/Fl_2 (33)
    state.h2 = state.h2 + h2_dot * real(0.0009063462346100907);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    state.th2 = state.th2 + th2_dot * real(0.000994023928172455);
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (32): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(real(0.9999000049998333), P2, c2 * real(0.000999950001666625));
    // eps2(t + dt) = eps2 + g eps2', g = (1 - exp(-a dt))/a, a = iota_20 (66)
    state.eps2 = state.eps2 + real(0.000999950001666625) * eps2_dot;
    // sigma2(t + dt) = sigma2 + g sigma2', g = (1 - exp(-a dt))/a, a = taubar_2 lambda_sigma (67)
    state.sigma2 = state.sigma2 + real(0.000999950001666625) * sigma2_dot;
    // phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >= iota_phi,
    // else phi_2; at least phi_min (68), erratum 11
    state.phi2 = T::select(
            s2.sqrt().ge(real(0.2)),
            state.phi2 * (-(real(0.001) * phi2_decay)).exp(),
            state.phi2,
        )
        .max(prepared.phi2_min);

    // -- states of block 3, one sample later --
    // zeta3(t + dt) = zeta3 + g zeta3', g = (1 - exp(-a dt))/a, a = C_3 (13)
    state.zeta3 = state.zeta3 + zeta3_dot * real(0.0009516258196404043);
    // th3(t + dt) = th3 + g th3', g = (1 - exp(-a dt))/a, a = S_3 (21): th_3' = -S_3 (D_hat_3 + F_3
    // + G_3 sat(u) + A_hat_3)
    state.th3 = state.th3
        - (D_hat3 + F3 + u_sat * real(40.0)) * real(50.0) * real(0.0009754115099857198);
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
        D_hat2: w_hat2,
        e3,
        D_hat3,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `position`, which are numbers in the formulas: `K = 6`, `kbar = 1.72`, `C = 20`,
/// `Fl = 0.02 s`, `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `speed`, which are numbers in the formulas: `K = 20`, `kbar = 20`, `C = 50`,
/// `Fl = 0.005 s`, `S = 10`, `M = -2`, `N = 0.5`, `L = 1`, `eta_1 = 1`, `eta_2 = 0.1`, `eta_3 = 2`,
/// `Gamma = 1`, `lambda = 0.1`, `iota = 1`, `iota_0 = 0.1`, `b = 1`, `eta_noise = 0.1`, `taubar = 1`,
/// `lambda_sigma = 0.1`, `varsigma = 1`, `kappa_phi = 0.5`, `iota_phi = 0.2`.
///
/// Gains of block 3, `current`, which are numbers in the formulas: `K = 100`, `kbar = 100`, `C = 100`,
/// `S = 50`, `eta_1 = 1`.
///
/// Operations: 78 additions, 127 multiplications, 7 divisions, 3 square roots, 9 elementary
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
