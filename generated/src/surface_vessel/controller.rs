// SHA-256 of the text below: 3d9c0eab70be28461a4403858fb740d0caaef048ed9d4c3958a78ed4a5bb8f83
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 40 additions, 65 multiplications, 4 divisions, 0 square roots, 7 elementary functions, 3 comparisons and selections
// control: 274 additions, 386 multiplications, 8 divisions, 3 square roots, 11 elementary functions, 13 comparisons and selections

//! `surface_vessel`: control law and sampled controller.
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

/// Largest magnitude of each control: `surge_force` in kg*m/s^2, `sway_force` in kg*m/s^2,
/// `yaw_moment` in kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 3] = [2.0, 2.0, 1.5];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.02;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 3] = [0.0, 0.0, 0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): pose (north, east, psi).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 3>,
    /// Auxiliary anti-windup state zeta (13): velocity (surge, sway, r).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 3>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// pose (north, east, psi).
    ///
    /// `th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 +
    /// F_1 + G_1 x_2 + A_hat_1)`
    pub th1: Vector<T, 3>,
    /// Filtered virtual control h (33): velocity (surge, sway, r).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 3>,
    /// Network weights W_hat, one row per monomial and one column per channel: velocity (surge,
    /// sway, r).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, surge, sway, r, surge2, surge_sway, surge_r, sway2, sway_r, r2`.
    pub W2: Matrix<T, 10, 3>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// velocity (surge, sway, r).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
    /// M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)`
    pub th2: Vector<T, 6>,
    /// Bound eps_hat of the approximation error (66): velocity (surge, sway, r).
    ///
    /// `eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)`
    pub eps2: T,
    /// Bound sigma_hat of the noise intensity (67): velocity (surge, sway, r).
    ///
    /// `sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 +
    /// varsigma_2^2)) - lambda_sigma sigma_hat_2)`
    pub sigma2: T,
    /// Noise term phi (68), kept positive: velocity (surge, sway, r).
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
    /// `D_hat_1 = th_1 + S_1 x_1`
    pub D_hat1: Vector<T, 3>,
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
            D_hat1: Vector::zero(),
            e2: Vector::zero(),
            D_hat2: Vector::zero(),
        }
    }
}

/// Surface vessel in waves and a current
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
/// Operations: 40 additions, 65 multiplications, 4 divisions, 0 square roots, 7 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(t: T, x1: Vector<T, 3>, x2: Vector<T, 3>) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let psi = x1[2];
    let t1 = (real(-0.1) * t).exp();
    let turn = real(0.05) * (t - real(10.0) * (real(1.0) - t1));

    // -- known dynamics of block 1 (pose) (11) --
    let t2 = psi.cos();
    let t3 = psi.sin();
    let t4 = -t3;
    // G_1(x_1 .. x_1)
    let G1 = Matrix::rows([
        [t2, t4, real(0.0)],
        [t3, t2, real(0.0)],
        [real(0.0), real(0.0), real(1.0)],
    ]);

    // -- reference and constraints --
    // t'
    let one = real(1.0);
    let t5 = turn.sin();
    let t6 = turn.cos();
    // y_r(t)
    let y_r = Vector([real(4.0) * t5, real(4.0) * (real(1.0) - t6), turn]);
    let t7 = real(0.05) * (one + real(10.0) * (t1 * real(-0.1)));
    // y_r'
    let y_r_dot = Vector([real(4.0) * (t6 * t7), real(4.0) * (t5 * t7), t7]);
    // k_1(t)
    let k1 = real(0.25) * t1 + real(0.02);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 3> = Vector::zero();
    let t8 = Vector::<T, 3>::from_f64([0.5, 0.5, 1.0]).hadamard(x1);
    let th1 = -t8;
    let zeta2: Vector<T, 3> = Vector::zero();
    let W2: Matrix<T, 10, 3> = Matrix::zero();
    let eps2 = real(0.0);
    let sigma2 = real(0.0);
    let phi2 = real(2.0);

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t9 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t9 * t9);
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);

    // -- disturbance observer of block 1 (20) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = t8 - t8;

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) --
    let t10 = T::select(
        E1_free.lt(real(1e-300)),
        real(1.0),
        E1.sin() * cosE1 * (real(1.0) / E1_free),
    );
    // Lam0 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31)
    let Lam0_1 = Vector::<T, 3>::from_f64([0.55, 0.55, 0.75]).hadamard(e1) * t10
        + e1 * real(0.25);
    let t11 = s1 * sec2E1;
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = Lam0_1 + e1 * (t11 * real(0.5) + t11 * (real(0.5) * G_norm2_1));

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = D_hat1 - y_r_dot + Lam1;
    let t12 = Matrix::rows([[t2, t4], [t3, t2]])
        .solve(Vector([bracket1[0], bracket1[1]]));
    let t13 = Vector([t12[0], t12[1], bracket1[2]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t13;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + t13;

    // -- given --
    let t14 = real(-3.0) * e2[0];
    let t15 = real(22.8) * e2[0];
    let t16 = real(-3.0) * e2[1];
    let t17 = real(22.8) * e2[1];
    let t18 = real(-3.0) * e2[2];
    let t19 = real(22.8) * e2[2];
    let th2 = -Vector([t14, t15, t16, t17, t18, t19]);
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
    /// `m_11`.
    pub m_11: T,
    /// `m_22`.
    pub m_22: T,
    /// `M`.
    pub M: Matrix<T, 3, 3>,
    /// `G_2(x_1 .. x_2)`
    pub G2: Matrix<T, 3, 3>,
    /// `Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)`
    pub Psi2: T,
    /// Part of `Lam2`.
    pub Lam2_1: T,
    /// `phi_min = sqrt(Psi_2 dt / 0.1), erratum 11`
    pub phi2_min: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 31 additions, 56 multiplications, 2 divisions, 1 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;

    // -- plant model --
    let m_11 = real(23.8) + params.added_scale * real(2.0);
    let m_22 = real(23.8) + params.added_scale * real(10.0);
    let m_23 = real(1.0948);
    let m_33 = real(1.76) + params.added_scale;
    let M = Matrix::rows([
        [m_11, real(0.0), real(0.0)],
        [real(0.0), m_22, m_23],
        [real(0.0), m_23, m_33],
    ]);

    // -- known dynamics of block 2 (velocity) (11) --
    let t1 = real(1.0) / m_11;
    let t2 = real(1.0) / (m_22 * m_33 - real(1.19858704));
    let t3 = m_33 * t2;
    let t4 = real(-1.0948) * t2;
    let t5 = m_22 * t2;
    // G_2(x_1 .. x_2)
    let G2 = Matrix::rows([
        [t1, real(0.0), real(0.0)],
        [real(0.0), t3, t4],
        [real(0.0), t4, t5],
    ]);
    let t6 = t1 * real(0.02);
    let t7 = t3 * real(0.02);
    let t8 = t4 * real(0.005);
    let t9 = t4 * real(0.02);
    let t10 = t5 * real(0.005);
    // H_2(x_1 .. x_2)
    let H2 = Matrix::rows([
        [t6, real(0.0), real(0.0)],
        [real(0.0), t7, t8],
        [real(0.0), t9, t10],
    ]);

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    // ||Ybar_2||^2
    let Ybar_square2 = real(27.0);
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = real(5.196152422706632);
    // S_2 H_2
    let SH2 = Matrix::rows([
        [real(-3.0) * t6, real(0.0), real(0.0)],
        [real(22.8) * t6, real(0.0), real(0.0)],
        [real(0.0), real(-3.0) * t7, real(-3.0) * t8],
        [real(0.0), real(22.8) * t7, real(22.8) * t8],
        [real(0.0), real(-3.0) * t9, real(-3.0) * t10],
        [real(0.0), real(22.8) * t9, real(22.8) * t10],
    ]);
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    let t11 = H_norm2_2 * real(0.1);
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = t11 * t11 * Ybar_square2 * real(0.5) + real(0.019200000000000002)
        + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- states of block 2, one sample later --
    // phi_min = sqrt(Psi_2 dt / 0.1), erratum 11
    let phi2_min = (Psi2 * real(0.19999999999999998)).sqrt();
    let Lam2_1 = H_norm2_2 * Ybar_norm2;
    Prepared {
        m_11,
        m_22,
        M,
        G2,
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
/// Operations: 5 additions, 14 multiplications, 1 divisions, 0 square roots, 3 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    // t'
    let one = real(1.0);
    let t1 = (real(-0.1) * t).exp();
    // k_1(t)
    let k1 = real(0.25) * t1 + real(0.02);

    // -- plant model --
    let turn = real(0.05) * (t - real(10.0) * (real(1.0) - t1));

    // -- reference and constraints --
    let t2 = turn.sin();
    let t3 = turn.cos();
    // y_r(t)
    let y_r = Vector([real(4.0) * t2, real(4.0) * (real(1.0) - t3), turn]);
    let t4 = real(0.05) * (one + real(10.0) * (t1 * real(-0.1)));
    // y_r'
    let y_r_dot = Vector([real(4.0) * (t3 * t4), real(4.0) * (t2 * t4), t4]);
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
    /// `D_hat_1 = th_1 + S_1 x_1`
    pub D_hat1: Vector<T, 3>,
    /// `e_2 = x_2 - h_1 - zeta_2`
    pub e2: Vector<T, 3>,
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 3>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `pose`, which are numbers in the formulas: `K = diag(1.2, 1.2, 2)`, `kbar = 0.25`,
/// `C = diag(2, 2, 4)`, `Fl = diag(0.2, 0.2, 0.1) s`, `S = diag(0.5, 0.5, 1)`, `eta_1 = 1`,
/// `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `velocity`, which are numbers in the formulas: `K = 6`, `kbar = 1`, `C = 10
/// I`, `S = (-3 0 0; 22.8 0 0; 0 -3 0; 0 22.8 0; 0 0 -3; 0 0 22.8)`, `M = (0 1; -36 -1.2) in
/// each channel`, `N = diag((0; 0.04), (0; 0.04), (0; 0.08))`, `L = (0 1) in each channel`,
/// `eta_1 = 1`, `Gamma = 10`, `lambda = 0.1`, `iota = diag(0.02, 0.02, 0.1)`, `iota_0 = 0.1`,
/// `b = 0.1`, `eta_noise = 0.1`, `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 0.1`,
/// `kappa_phi = 0.5`, `iota_phi = 0.02`.
///
/// Operations: 238 additions, 316 multiplications, 5 divisions, 2 square roots, 8 elementary
/// functions, 13 comparisons and selections.
#[inline(always)]
pub fn law<T: Real>(
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    state: &mut State<T>,
    params: &Params<T>,
    prepared: &Prepared<T>,
    clock: &Clock<T>,
) -> ControlOutputs<T> {
    let real = T::from_f64;

    // -- plant model --
    let psi = x1[2];
    let m_23 = real(1.0948);
    let sway = x2[1];
    let r = x2[2];
    let sway_momentum = prepared.m_22 * sway + m_23 * r;
    let surge = x2[0];
    let d_11 = real(0.72253) - real(-1.32742) * surge.abs()
        - real(-5.86643) * (surge * surge);
    let t1 = sway.abs();
    let t2 = r.abs();
    let d_22 = real(0.88965) - real(-36.47287) * t1 - real(-0.805) * t2;
    let d_23 = real(7.25) - real(-0.845) * t1 - real(-3.45) * t2;
    let d_32 = real(-0.0313) - real(3.95645) * t1 - real(0.13) * t2;
    let d_33 = real(1.9) - real(0.08) * t1 - real(-0.75) * t2;
    let t3 = prepared.m_11 * surge;
    let resistance = Vector([
        params.damping_scale * d_11 * surge - sway_momentum * r,
        t3 * r + params.damping_scale * (d_22 * sway + d_23 * r),
        sway_momentum * surge - t3 * sway
            + params.damping_scale * (d_32 * sway + d_33 * r),
    ]);

    // -- known dynamics of block 1 (pose) (11) --
    let t4 = psi.cos();
    let t5 = psi.sin();
    let t6 = -t5;
    // G_1(x_1 .. x_1)
    let G1 = Matrix::rows([
        [t4, t6, real(0.0)],
        [t5, t4, real(0.0)],
        [real(0.0), real(0.0), real(1.0)],
    ]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t7 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t7 * t7);
    // E_1 >= pi/2 - delta
    let violated1 = E1_free.ge(real(1.5697963267948967));
    // E_1 = pi s_1^2 / (2 k_1^4), at most pi/2 - delta
    let E1 = E1_free.min(real(1.5697963267948967));
    // cos E_1
    let cosE1 = E1.cos();
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t8 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t8;

    // -- disturbance observer of block 1 (20) --
    let t9: Vector<T, 3> = Vector::from_f64([0.5, 0.5, 1.0]);
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + t9.hadamard(x1);

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) --
    let t10 = T::select(
        E1_free.lt(real(1e-300)),
        real(1.0),
        E1.sin() * cosE1 * (real(1.0) / E1_free),
    );
    // Lam0 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31)
    let Lam0_1 = Vector::<T, 3>::from_f64([0.55, 0.55, 0.75]).hadamard(e1) * t10
        + e1 * real(0.25);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = Lam0_1 + e1 * (t8 * real(0.5) + t8 * (real(0.5) * G_norm2_1));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t11 = Vector::<T, 3>::from_f64([2.0, 2.0, 4.0]).hadamard(state.zeta1);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t11 - clock.y_r_dot + D_hat1 + Lam1;
    let t12 = Matrix::rows([[t4, t6], [t5, t4]])
        .solve(Vector([bracket1[0], bracket1[1]]));
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -Vector([t12[0], t12[1], bracket1[2]]);

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = G1 * state.zeta2 - t11;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = Vector::<T, 3>::from_f64([5.0, 5.0, 10.0]).hadamard(alpha1 - state.h1);

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
    let z2 = Vector([surge * real(5.0), sway * real(10.0), r * real(10.0)]);
    // P_2 = P_m(z_2), 10 nodes
    let P2 = polynomials::basis2(z2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = Vector::<T, 3>::from_f64([0.02, 0.02, 0.1])
        .hadamard(state.W2.transpose_mul(P2));

    // -- disturbance observer of block 2 (49) --
    let t13 = Vector([
        real(-3.0) * e2[0],
        real(22.8) * e2[0],
        real(-3.0) * e2[1],
        real(22.8) * e2[1],
        real(-3.0) * e2[2],
        real(22.8) * e2[2],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + t13;
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([w_hat2[1], w_hat2[3], w_hat2[5]]);

    // -- robust feedback of block 2 (63) --
    let t14 = (e2 * real(10.0)).tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t14 * state.eps2;
    let t15 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t15 + real(0.010000000000000002)).sqrt();
    let t16 = G_norm2_1 * s_c1;
    let t17 = prepared.Psi2 / (state.phi2 * state.phi2 + t15);
    let t18 = real(3.5) + s2 * real(1.5) + real(0.5) + t16 * t16 * real(0.25);
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b)
    // (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38) +
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 + e Psi cos^2 E /
    // (phi^2 + s^2) (64)
    let Lam2 = e2 * (t18 + prepared.Lam2_1 * state.sigma2 * s_scale2 + t17)
        + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t19 = state.zeta2 * real(10.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = A_hat2 - prepared.G2 * resistance - h1_dot + t19 + D_hat2 + Lam2;
    let t20 = prepared.M * bracket2;
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t20;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 3>::from_f64([-2.0, -2.0, -1.5]))
        .min(Vector::<T, 3>::from_f64([2.0, 2.0, 1.5]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = prepared.G2 * (u_sat + t20) - t19;

    // -- observer dynamics of block 2 (50) --
    let t21 = Vector([
        w_hat2[1],
        real(-36.0) * w_hat2[0] + real(-1.2) * w_hat2[1],
        w_hat2[3],
        real(-36.0) * w_hat2[2] + real(-1.2) * w_hat2[3],
        w_hat2[5],
        real(-36.0) * w_hat2[4] + real(-1.2) * w_hat2[5],
    ]);
    let t22 = Vector([
        real(-3.0) * Lam2[0],
        real(22.8) * Lam2[0],
        real(-3.0) * Lam2[1],
        real(22.8) * Lam2[1],
        real(-3.0) * Lam2[2],
        real(22.8) * Lam2[2],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = t21 + t22;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (s2 * e2.dot(t14) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = prepared.Lam2_1 * t15 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t17 + real(0.5);

    // -- states of block 2, one sample later --
    // g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    let th2_step = Vector([
        real(0.019829465934243364) * th2_dot[0]
            + real(0.000682818118818716) * th2_dot[1],
        real(-0.006145363069368444) * th2_dot[0]
            + real(0.015732557221331073) * th2_dot[1],
        real(0.019829465934243364) * th2_dot[2]
            + real(0.000682818118818716) * th2_dot[3],
        real(-0.006145363069368444) * th2_dot[2]
            + real(0.015732557221331073) * th2_dot[3],
        real(0.019829465934243364) * th2_dot[4]
            + real(0.000682818118818716) * th2_dot[5],
        real(-0.006145363069368444) * th2_dot[4]
            + real(0.015732557221331073) * th2_dot[5],
    ]);

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1
        + Vector::<
            T,
            3,
        >::from_f64([0.019605280423838398, 0.019605280423838398, 0.019220913403341054])
            .hadamard(zeta1_dot);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1
        + Vector::<
            T,
            3,
        >::from_f64([0.019032516392808087, 0.019032516392808087, 0.018126924692201812])
            .hadamard(h1_dot);
    // th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 + F_1
    // + G_1 x_2 + A_hat_1)
    state.th1 = state.th1
        - Vector::<
            T,
            3,
        >::from_f64([0.019900332501663894, 0.019900332501663894, 0.0198013266932447])
            .hadamard(t9.hadamard(D_hat1 + G1 * x2));

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.018126924692201812);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    state.th2 = state.th2 + th2_step;
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(
            real(0.9801986733067553),
            P2,
            Vector::<
                T,
                3,
            >::from_f64([0.00396026533864894, 0.00396026533864894, 0.0198013266932447])
                .hadamard(c2),
        );
    // eps2(t + dt) = eps2 + g eps2', g = (1 - exp(-a dt))/a, a = iota_20 (66)
    state.eps2 = state.eps2 + real(0.019980013326669332) * eps2_dot;
    // sigma2(t + dt) = sigma2 + g sigma2', g = (1 - exp(-a dt))/a, a = taubar_2 lambda_sigma (67)
    state.sigma2 = state.sigma2 + real(0.019980013326669332) * sigma2_dot;
    // phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >= iota_phi,
    // else phi_2; at least phi_min (68), erratum 11
    state.phi2 = T::select(
            s2.sqrt().ge(real(0.02)),
            state.phi2 * (-(real(0.02) * phi2_decay)).exp(),
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
/// Gains of block 1, `pose`, which are numbers in the formulas: `K = diag(1.2, 1.2, 2)`, `kbar = 0.25`,
/// `C = diag(2, 2, 4)`, `Fl = diag(0.2, 0.2, 0.1) s`, `S = diag(0.5, 0.5, 1)`, `eta_1 = 1`,
/// `eta_2 = 1`, `eta_3 = 1`.
///
/// Gains of block 2, `velocity`, which are numbers in the formulas: `K = 6`, `kbar = 1`, `C = 10
/// I`, `S = (-3 0 0; 22.8 0 0; 0 -3 0; 0 22.8 0; 0 0 -3; 0 0 22.8)`, `M = (0 1; -36 -1.2) in
/// each channel`, `N = diag((0; 0.04), (0; 0.04), (0; 0.08))`, `L = (0 1) in each channel`,
/// `eta_1 = 1`, `Gamma = 10`, `lambda = 0.1`, `iota = diag(0.02, 0.02, 0.1)`, `iota_0 = 0.1`,
/// `b = 0.1`, `eta_noise = 0.1`, `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 0.1`,
/// `kappa_phi = 0.5`, `iota_phi = 0.02`.
///
/// Operations: 274 additions, 386 multiplications, 8 divisions, 3 square roots, 11 elementary
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
    law(x1, x2, state, params, &prepared, &clock)
}
