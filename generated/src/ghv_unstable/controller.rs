// SHA-256 of the text below: 933fd8832385c52a5774bf4c2cd839740bff0a52dcb6b294946cb66680b0432b
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// initial: 59 additions, 101 multiplications, 6 divisions, 0 square roots, 20 elementary functions, 3 comparisons and selections
// control: 564 additions, 852 multiplications, 11 divisions, 4 square roots, 26 elementary functions, 18 comparisons and selections

//! `ghv_unstable`: control law and sampled controller.
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

/// Largest magnitude of each control: `M_x` in kg*m^2/s^2, `M_y` in kg*m^2/s^2, `M_z` in
/// kg*m^2/s^2.
pub const INPUT_LIMIT: [f64; 3] = [2000000.0, 20000000.0, 20000000.0];

/// Time between samples, s.
pub const SAMPLE_TIME: f64 = 0.002;

/// Control while a measurement is not finite.
pub const SAFE_INPUT: [f64; 3] = [0.0, 0.0, 0.0];

/// The controller's states, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct State<T> {
    /// Auxiliary anti-windup state zeta (13): attitude (alpha, beta, mu).
    ///
    /// `zeta_1' = -C_1 zeta_1 + G_1 zeta_2`
    pub zeta1: Vector<T, 3>,
    /// Auxiliary anti-windup state zeta (13): rates (p, q, r).
    ///
    /// `zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)`
    pub zeta2: Vector<T, 3>,
    /// Network weights W_hat, one row per monomial and one column per channel: attitude (alpha,
    /// beta, mu).
    ///
    /// `W_1(t + dt) = (1 - g Gamma_1 lambda_1) W_1 + g Gamma_1 P_1 c_1 I_1, g = (1 - exp(-a dt))/a,
    /// a = Gamma_1 lambda_1 (32): W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)`
    ///
    /// Rows: `one, alpha, beta, mu, alpha2, alpha_beta, alpha_mu, beta2, beta_mu, mu2, alpha3,
    /// alpha2_beta, alpha2_mu, alpha_beta2, alpha_mu2, beta3, beta2_mu, beta_mu2, mu3`.
    pub W1: Matrix<T, 19, 3>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// attitude (alpha, beta, mu).
    ///
    /// `th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 +
    /// F_1 + G_1 x_2 + A_hat_1)`
    pub th1: Vector<T, 3>,
    /// Filtered virtual control h (33): rates (p, q, r).
    ///
    /// `h_1' = (alpha_1 - h_1) / Fl_1`
    pub h1: Vector<T, 3>,
    /// Network weights W_hat, one row per monomial and one column per channel: rates (p, q, r).
    ///
    /// `W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a,
    /// a = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)`
    ///
    /// Rows: `one, p, q, r, p2, p_q, p_r, q2, q_r, r2, p3, p2_q, p2_r, p_q2, p_r2, q3, q2_r, q_r2,
    /// r3`.
    pub W2: Matrix<T, 19, 3>,
    /// Observer state theta_hat; with the measured part it gives the disturbance estimate D_hat:
    /// rates (p, q, r).
    ///
    /// `th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) =
    /// M_2 w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)`
    pub th2: Vector<T, 6>,
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
            W1: Matrix::zero(),
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
            W1: Matrix::select(mask, a.W1, b.W1),
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
            .and(self.W1.is_finite())
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
    /// `k_2(t)`
    pub k2: T,
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
            k2: T::zero(),
            D_hat2: Vector::zero(),
        }
    }
}

/// Statically unstable hypersonic vehicle
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
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
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
/// Operations: 59 additions, 101 multiplications, 6 divisions, 0 square roots, 20 elementary
/// functions, 3 comparisons and selections.
#[inline(always)]
pub fn initial<T: Real>(
    t: T,
    x1: Vector<T, 3>,
    x2: Vector<T, 3>,
    params: &Params<T>,
) -> State<T> {
    let real = T::from_f64;

    // -- plant model --
    let alpha = x1[0];
    let alpha_deg = alpha * real(57.29577951308232);
    let at_alpha_deg = polynomials::at_alpha_deg_2(alpha_deg);
    let lift = real(97170193.3485195) * params.CL_scale
        * (at_alpha_deg.CL_alpha + at_alpha_deg.CL_LE + at_alpha_deg.CL_RE);
    let beta = x1[1];
    let side = real(97170193.3485195) * params.CY_scale
        * (at_alpha_deg.CY_beta * beta + at_alpha_deg.CY_LE + at_alpha_deg.CY_RE
            + at_alpha_deg.CY_RUD);

    // -- known dynamics of block 1 (attitude) (11) --
    let [sin_alpha, _, sin_x1_2] = x1.sin().0;
    let [cos_alpha, cos_beta, cos_x1_2] = x1.cos().0;
    let t1 = real(1332506.5352200002) * cos_x1_2;
    let [_, tan_beta, _] = x1.tan().0;
    // F_1(x_1 .. x_1)
    let F1 = Vector([
        (t1 - lift) / (real(410460000.0) * cos_beta),
        (side + real(1332506.5352200002) * sin_x1_2) * real(2.4362909905959168e-9),
        (lift * tan_beta - t1 * tan_beta) * real(2.4362909905959168e-9),
    ]);
    let t2 = -tan_beta;
    let t3 = t2 * cos_alpha;
    let t4 = t2 * sin_alpha;
    let t5 = -cos_alpha;
    let t6 = real(1.0) / cos_beta;
    let t7 = cos_alpha * t6;
    let t8 = sin_alpha * t6;
    // G_1(x_1 .. x_1)
    let G1 = Matrix::rows([
        [t3, real(1.0), t4],
        [sin_alpha, real(0.0), t5],
        [t7, real(0.0), t8],
    ]);

    // -- reference and constraints --
    let t9 = real(FRAC_PI_4) * t;
    let t10 = real(0.5) * t;
    let t11 = real(0.9424777960769379) * t;
    let t12 = Vector([t, t9, t11, t10]);
    let [cos_t, cos_t9, cos_t11, cos_t10] = t12.cos().0;
    let [sin_t, sin_t9, sin_t11, sin_t10] = t12.sin().0;
    // y_r(t)
    let y_r = Vector([
        (real(1.5) - real(2.0) * cos_t9) * real(0.017453292519943295),
        real(0.5) * sin_t11 * real(0.017453292519943295),
        (real(-2.0) * sin_t + real(0.5) * cos_t10) * real(0.017453292519943295),
    ]);
    // y_r'
    let y_r_dot = Vector([
        real(0.017453292519943295) * (real(2.0) * (sin_t9 * real(FRAC_PI_4))),
        real(0.017453292519943295) * (real(0.5) * (cos_t11 * real(0.9424777960769379))),
        real(0.017453292519943295)
            * (real(-2.0) * cos_t - real(0.5) * (sin_t10 * real(0.5))),
    ]);
    // k_1(t)
    let k1 = (real(3.0) * (-t).exp() + real(0.5)) * real(0.017453292519943295);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - y_r;

    // -- given --
    let zeta1: Vector<T, 3> = Vector::zero();
    let W1: Matrix<T, 19, 3> = Matrix::zero();
    let th1 = -(x1 * real(10.0));
    let zeta2: Vector<T, 3> = Vector::zero();
    let W2: Matrix<T, 19, 3> = Matrix::zero();
    let eps2 = real(0.0);
    let sigma2 = real(0.0);
    let phi2 = real(10.0);

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t13 = s1 * (real(1.0) / (k1 * k1));
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t13 * t13);
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
    let t14 = s1 * sec2E1;
    let t15 = real(2.375)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            E1.sin() * cosE1 * (real(1.0) / E1_free),
        ) + real(2.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t15 + t14 * real(0.5) + t14 * (real(0.5) * G_norm2_1));

    // -- virtual control (31) of block 1 --
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = F1 - y_r_dot + Lam1;
    let t16 = Matrix::rows([[sin_alpha, t5], [t7, t8]])
        .solve(Vector([bracket1[1], bracket1[2]]));
    let t17 = bracket1[0] - t3 * t16[0] - t4 * t16[1];
    let t18 = Vector([t16[0], t17, t16[1]]);
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -t18;

    // -- error variable of block 2 (14) --
    // e_2 = x_2 - h_1 - zeta_2
    let e2 = x2 + t18;

    // -- given --
    let t19 = real(-1.5) * e2[0];
    let t20 = real(1.5) * e2[0];
    let t21 = real(1.5) * e2[1];
    let t22 = real(-2.0) * e2[2];
    let t23 = real(4.0) * e2[2];
    let th2 = -Vector([t19, t20, t21, e2[1], t22, t23]);
    State {
        zeta1,
        zeta2,
        W1,
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
    /// Part of `lift`.
    pub lift_1: T,
    /// Part of `side`.
    pub side_1: T,
    /// Part of `roll`.
    pub roll_1: T,
    /// Part of `pitch`.
    pub pitch_1: T,
    /// Part of `drag`.
    pub drag_1: T,
    /// Part of `yaw`.
    pub yaw_1: T,
    /// Part of `pitch_delta`.
    pub pitch_delta_1: T,
    /// Part of `yaw_delta`.
    pub yaw_delta_1: T,
    /// Part of `yaw_delta`.
    pub yaw_delta_2: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 9 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;
    let lift_1 = real(97170193.3485195) * params.CL_scale;
    let side_1 = real(97170193.3485195) * params.CY_scale;
    let roll_1 = real(1777048495.9577248) * params.Cl_scale;
    let pitch_1 = real(2369397994.6102996) * params.Cm_scale;
    let drag_1 = real(97170193.3485195) * params.CD_scale;
    let yaw_1 = real(1777048495.9577248) * params.Cn_scale;
    let pitch_delta_1 = real(24.384) * params.Cm_scale;
    let yaw_delta_1 = real(18.288) * params.Cn_scale;
    let yaw_delta_2 = real(2.85) * params.CY_scale;
    Prepared {
        lift_1,
        side_1,
        roll_1,
        pitch_1,
        drag_1,
        yaw_1,
        pitch_delta_1,
        yaw_delta_1,
        yaw_delta_2,
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
    /// `k_2(t)`
    pub k2: T,
    /// `k_1(t)`
    pub k1: T,
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
            k2: self.k2.in_every_lane(lane),
            k1: self.k1.in_every_lane(lane),
            E1_free_1: self.E1_free_1.in_every_lane(lane),
            E2_free_1: self.E2_free_1.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 4 additions, 24 multiplications, 2 divisions, 0 square roots, 9 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- reference and constraints --
    let t1 = real(FRAC_PI_4) * t;
    let t2 = real(0.5) * t;
    let t3 = real(0.9424777960769379) * t;
    let t4 = Vector([t, t1, t3, t2]);
    let [cos_t, cos_t1, cos_t3, cos_t2] = t4.cos().0;
    let [sin_t, sin_t1, sin_t3, sin_t2] = t4.sin().0;
    // y_r(t)
    let y_r = Vector([
        (real(1.5) - real(2.0) * cos_t1) * real(0.017453292519943295),
        real(0.5) * sin_t3 * real(0.017453292519943295),
        (real(-2.0) * sin_t + real(0.5) * cos_t2) * real(0.017453292519943295),
    ]);
    // y_r'
    let y_r_dot = Vector([
        real(0.017453292519943295) * (real(2.0) * (sin_t1 * real(FRAC_PI_4))),
        real(0.017453292519943295) * (real(0.5) * (cos_t3 * real(0.9424777960769379))),
        real(0.017453292519943295)
            * (real(-2.0) * cos_t - real(0.5) * (sin_t2 * real(0.5))),
    ]);
    // k_2(t)
    let k2 = real(3.0) * (-t).exp() + real(0.5);
    // k_1(t)
    let k1 = k2 * real(0.017453292519943295);
    let E1_free_1 = real(1.0) / (k1 * k1);
    let E2_free_1 = real(1.0) / (k2 * k2);
    Clock {
        y_r,
        y_r_dot,
        k2,
        k1,
        E1_free_1,
        E2_free_1,
    }
}

/// Results of [`control`].
#[derive(Clone, Copy, Debug)]
pub struct ControlOutputs<T: Real> {
    /// `u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]`
    pub u: Vector<T, 3>,
    /// `sat(u), each component limited to +-u_max (8)`
    pub u_sat: Vector<T, 3>,
    /// `some E_i >= pi/2 - delta`
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
    /// `k_2(t)`
    pub k2: T,
    /// `D_hat_2 = L_2 w_hat_2`
    pub D_hat2: Vector<T, 3>,
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `attitude`, which are numbers in the formulas: `K = 1.5`, `kbar = 2`, `C = 20
/// I`, `Fl = 0.05 s`, `S = 10 I`, `eta_1 = 1`, `eta_2 = 1`, `eta_3 = 1`, `Gamma = 1`, `lambda = 0.1`,
/// `iota = 0.1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 2`, `kbar = 2`, `C = 50
/// I`, `S = (-1.5 0 0; 1.5 0 0; 0 1.5 0; 0 1 0; 0 0 -2; 0 0 4)`, `M = (-0.3 3; -3 -0.3) in each
/// channel`, `N = 0.05 I in each channel`, `L = diag((0 2), (2 0), (1 1))`, `eta_1 = 0.1`,
/// `Gamma = 1`, `lambda = 0.1`, `iota = 0.1`, `iota_0 = 0.1`, `b = 2`, `eta_noise = 0.1`,
/// `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 1`, `kappa_phi = 2`, `iota_phi = 0.01`.
///
/// Operations: 560 additions, 819 multiplications, 9 divisions, 4 square roots, 17 elementary
/// functions, 18 comparisons and selections.
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
    let alpha = x1[0];
    let alpha_deg = alpha * real(57.29577951308232);
    let at_alpha_deg = polynomials::at_alpha_deg(alpha_deg);
    let lift = prepared.lift_1
        * (at_alpha_deg.CL_alpha + at_alpha_deg.CL_LE + at_alpha_deg.CL_RE);
    let beta = x1[1];
    let side = prepared.side_1
        * (at_alpha_deg.CY_beta * beta + at_alpha_deg.CY_LE + at_alpha_deg.CY_RE
            + at_alpha_deg.CY_RUD);
    let q = x2[1];
    let r = x2[2];
    let p = x2[0];
    let t1 = at_alpha_deg.Cl_beta * beta + at_alpha_deg.Cl_LE + at_alpha_deg.Cl_RE
        + at_alpha_deg.Cl_RUD
        + at_alpha_deg.Cl_p * p * real(18.288) * real(0.00016666666666666666);
    let roll = prepared.roll_1
        * (t1 + at_alpha_deg.Cl_r * r * real(18.288) * real(0.00016666666666666666));
    let pitch = prepared.pitch_1
        * (at_alpha_deg.Cm_alpha + at_alpha_deg.Cm_LE + at_alpha_deg.Cm_RE
            + at_alpha_deg.Cm_RUD
            + at_alpha_deg.Cm_q * q * real(24.384) * real(0.00016666666666666666));
    let drag = prepared.drag_1
        * (at_alpha_deg.CD_alpha + at_alpha_deg.CD_LE + at_alpha_deg.CD_RE
            + at_alpha_deg.CD_RUD);
    let t2 = at_alpha_deg.Cn_beta * beta + at_alpha_deg.Cn_LE + at_alpha_deg.Cn_RE
        + at_alpha_deg.Cn_RUD
        + at_alpha_deg.Cn_p * p * real(18.288) * real(0.00016666666666666666);
    let yaw = prepared.yaw_1
        * (t2 + at_alpha_deg.Cn_r * r * real(18.288) * real(0.00016666666666666666));
    let dCl = Vector([
        at_alpha_deg.Cl_LE_d3,
        at_alpha_deg.Cl_RE_d3,
        at_alpha_deg.Cl_RUD_d3,
    ]);
    let roll_delta = dCl * prepared.roll_1;
    let dCm = Vector([at_alpha_deg.Cm_LE_d3, at_alpha_deg.Cm_RE_d3, real(0.0)]);
    let dCD = Vector([
        at_alpha_deg.CD_LE_d3,
        at_alpha_deg.CD_RE_d3,
        at_alpha_deg.CD_RUD_d3,
    ]);
    let dCL = Vector([at_alpha_deg.CL_LE_d3, at_alpha_deg.CL_RE_d3, real(0.0)]);
    let [sin_alpha, _, sin_x1_2] = x1.sin().0;
    let [cos_alpha, cos_beta, cos_x1_2] = x1.cos().0;
    let t3 = dCm * prepared.pitch_delta_1
        + (dCD * params.CD_scale * sin_alpha + dCL * params.CL_scale * cos_alpha)
            * real(2.85);
    let pitch_delta = t3 * real(97170193.3485195);
    let dCn = Vector([
        at_alpha_deg.Cn_LE_d3,
        at_alpha_deg.Cn_RE_d3,
        at_alpha_deg.Cn_RUD_d3,
    ]);
    let dCY = Vector([
        at_alpha_deg.CY_LE_d3,
        at_alpha_deg.CY_RE_d3,
        at_alpha_deg.CY_RUD_d3,
    ]);
    let yaw_delta = (dCn * prepared.yaw_delta_1 + dCY * prepared.yaw_delta_2)
        * real(97170193.3485195);

    // -- known dynamics of block 1 (attitude) (11) --
    let t4 = real(1332506.5352200002) * cos_x1_2;
    let [_, tan_beta, _] = x1.tan().0;
    // F_1(x_1 .. x_1)
    let F1 = Vector([
        (t4 - lift) / (real(410460000.0) * cos_beta),
        (side + real(1332506.5352200002) * sin_x1_2) * real(2.4362909905959168e-9),
        (lift * tan_beta - t4 * tan_beta) * real(2.4362909905959168e-9),
    ]);
    let t5 = -tan_beta;
    let t6 = t5 * cos_alpha;
    let t7 = t5 * sin_alpha;
    let t8 = -cos_alpha;
    let t9 = real(1.0) / cos_beta;
    let t10 = cos_alpha * t9;
    let t11 = sin_alpha * t9;
    // G_1(x_1 .. x_1)
    let G1 = Matrix::rows([
        [t6, real(1.0), t7],
        [sin_alpha, real(0.0), t8],
        [t10, real(0.0), t11],
    ]);

    // -- known dynamics of block 2 (rates) (11) --
    let t12 = real(12202362.0) * p * r + pitch
        + real(2.85) * (drag * sin_alpha + lift * cos_alpha);
    // F_2(x_1 .. x_2)
    let F2 = Vector([
        roll * real(7.375621211696555e-7),
        t12 * real(7.375621211696555e-8),
        (real(-12202362.0) * p * q + yaw + real(2.85) * side)
            * real(7.375621211696555e-8),
    ]);
    let t13 = roll_delta[0] * real(7.375621211696555e-7);
    let t14 = roll_delta[1] * real(7.375621211696555e-7);
    let t15 = roll_delta[2] * real(7.375621211696555e-7);
    let t16 = pitch_delta[0] * real(7.375621211696555e-8);
    let t17 = pitch_delta[1] * real(7.375621211696555e-8);
    let t18 = pitch_delta[2] * real(7.375621211696555e-8);
    let t19 = yaw_delta[0] * real(7.375621211696555e-8);
    let t20 = yaw_delta[1] * real(7.375621211696555e-8);
    let t21 = yaw_delta[2] * real(7.375621211696555e-8);
    // H_2(x_1 .. x_2)
    let H2 = Matrix::rows([[t13, t14, t15], [t16, t17, t18], [t19, t20, t21]]);

    // -- error variable of block 1 (14) --
    // e_1 = x_1 - y_r - zeta_1
    let e1 = x1 - clock.y_r - state.zeta1;

    // -- barrier of block 1 (23) (26) --
    // s_1 = e_1^T e_1
    let s1 = e1.sum_squares();
    let t22 = s1 * clock.E1_free_1;
    // pi s_1^2 / (2 k_1^4), before the clamp
    let E1_free = real(FRAC_PI_2) * (t22 * t22);
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
    let t23 = s2 * clock.E2_free_1;
    // pi s_2^2 / (2 k_2^4), before the clamp
    let E2_free = real(FRAC_PI_2) * (t23 * t23);
    // E_2 = pi s_2^2 / (2 k_2^4), at most pi/2 - delta
    let E2 = E2_free.min(real(1.5697963267948967));
    let t24 = Vector([E1, E2]);
    let [cos_E1, cos_E2] = t24.cos().0;
    // cos E_2
    let cosE2 = cos_E2;
    // E_2 >= pi/2 - delta
    let violated2 = E2_free.ge(real(1.5697963267948967));
    let t25 = cosE2 * cosE2;
    // 1 / cos^2 E_2
    let sec2E2 = real(1.0) / t25;
    let t26 = s2 * sec2E2;
    // c_2 = s_2 e_2^T / cos^2 E_2
    let c2 = e2 * t26;

    // -- barrier of block 1 (23) (26) --
    // cos E_1
    let cosE1 = cos_E1;
    // 1 / cos^2 E_1
    let sec2E1 = real(1.0) / (cosE1 * cosE1);
    let t27 = s1 * sec2E1;
    // c_1 = s_1 e_1^T / cos^2 E_1
    let c1 = e1 * t27;

    // -- MTPN of block 1 (4) (16) --
    // P_1 = P_m(z_1), 19 nodes
    let P1 = polynomials::basis1(x1);
    // A_hat_1 = iota_1 W_1^T P_1
    let A_hat1 = state.W1.transpose_mul(P1) * real(0.1);

    // -- disturbance observer of block 1 (20) --
    // D_hat_1 = th_1 + S_1 x_1
    let D_hat1 = state.th1 + x1 * real(10.0);

    // -- norms of block 1 --
    // ||G_1||^2
    let G_norm2_1 = G1.sum_squares();

    // -- robust feedback of block 1 (31) --
    let [sin_E1, sin_E2] = t24.sin().0;
    let t28 = real(2.375)
        * T::select(
            E1_free.lt(real(1e-300)),
            real(1.0),
            sin_E1 * cosE1 * (real(1.0) / E1_free),
        ) + real(2.0);
    // Lam_1 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + eta_1/2 c^T (36) + eta_2/2 ||G||^2 c^T (37)
    let Lam1 = e1 * (t28 + t27 * real(0.5) + t27 * (real(0.5) * G_norm2_1));
    // ||c_1||^2
    let s_c1 = c1.sum_squares();

    // -- virtual control (31) of block 1 --
    let t29 = F1 + A_hat1;
    let t30 = state.zeta1 * real(20.0);
    // F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1
    let bracket1 = t29 - clock.y_r_dot + t30 + D_hat1 + Lam1;
    let t31 = Matrix::rows([[sin_alpha, t8], [t10, t11]])
        .solve(Vector([bracket1[1], bracket1[2]]));
    let t32 = bracket1[0] - t6 * t31[0] - t7 * t31[1];
    // alpha_1 = -G_1^-1 [ F_1 + A_hat_1 - y_r' + C_1 zeta_1 + D_hat_1 + Lam_1 ]
    let alpha1 = -Vector([t31[0], t32, t31[1]]);

    // -- auxiliary system of block 1 (13), erratum 1 --
    // zeta_1' = -C_1 zeta_1 + G_1 zeta_2
    let zeta1_dot = G1 * state.zeta2 - t30;

    // -- dynamic surface filter of block 1 (33) --
    // h_1' = (alpha_1 - h_1) / Fl_1
    let h1_dot = (alpha1 - state.h1) * real(20.0);

    // -- MTPN of block 2 (4) (16) --
    // P_2 = P_m(z_2), 19 nodes
    let P2 = polynomials::basis2(x2);
    // A_hat_2 = iota_2 W_2^T P_2
    let A_hat2 = state.W2.transpose_mul(P2) * real(0.1);

    // -- disturbance observer of block 2 (49) --
    let t33 = Vector([
        real(-1.5) * e2[0],
        real(1.5) * e2[0],
        real(1.5) * e2[1],
        e2[1],
        real(-2.0) * e2[2],
        real(4.0) * e2[2],
    ]);
    // w_hat_2 = th_2 + S_2 e_2
    let w_hat2 = state.th2 + t33;
    // D_hat_2 = L_2 w_hat_2
    let D_hat2 = Vector([
        real(2.0) * w_hat2[1],
        real(2.0) * w_hat2[2],
        w_hat2[4] + w_hat2[5],
    ]);

    // -- noise terms of block 2 (58) (62) --
    // ||H_2||^2
    let H_norm2_2 = H2.sum_squares();
    let t34 = real(3.0) * sec2E2;
    let t35 = real(8.0) * E2_free * sin_E2 * (cosE2 * (sec2E2 * sec2E2)) + t34;
    // ||Ybar_2||^2
    let Ybar_square2 = t35 * t35 + real(2.0) * (t34 * t34);
    // ||Ybar_2||, Ybar_2 = (4 pi/k_2^4) (sin E_2/cos^3 E_2) s_2 e_2 e_2^T + (3/cos^2 E_2) I (58)
    let Ybar_norm2 = Ybar_square2.sqrt();
    // S_2 H_2
    let SH2 = Matrix::rows([
        [real(-1.5) * t13, real(-1.5) * t14, real(-1.5) * t15],
        [real(1.5) * t13, real(1.5) * t14, real(1.5) * t15],
        [real(1.5) * t16, real(1.5) * t17, real(1.5) * t18],
        [t16, t17, t18],
        [real(-2.0) * t19, real(-2.0) * t20, real(-2.0) * t21],
        [real(4.0) * t19, real(4.0) * t20, real(4.0) * t21],
    ]);
    // ||S_2 H_2||^2
    let SH_norm2_2 = SH2.sum_squares();
    // Psi_2 = ||H_2||^4 ||Ybar_2||^2 varsigma_2^2/2 + 2 ||N_2||^2 + eta_noise ||S_2 H_2||^4 (62)
    let Psi2 = H_norm2_2 * H_norm2_2 * Ybar_square2 * real(0.5)
        + real(0.030000000000000006) + real(0.1) * (SH_norm2_2 * SH_norm2_2);

    // -- robust feedback of block 2 (63) --
    let t36 = (e2 * real(0.5)).tanh();
    // eps_hat Tanh(e / b) (64)
    let Lam2_error_bound = t36 * state.eps2;
    let t37 = s2 * s2;
    // 1 / sqrt(s_2^2 + varsigma_2^2)
    let s_scale2 = real(1.0) / (t37 + real(1.0)).sqrt();
    let t38 = real(2.5)
        * T::select(
            E2_free.lt(real(1e-300)),
            real(1.0),
            sin_E2 * cosE2 * (real(1.0) / E2_free),
        ) + real(2.0);
    let t39 = G_norm2_1 * s_c1;
    let t40 = H_norm2_2 * Ybar_norm2;
    let t41 = Psi2 / (state.phi2 * state.phi2 + t37);
    let t42 = t38 + t26 * real(50.0) + real(0.5) * sec2E2 + t39 * t39 * real(0.25) * t25;
    // Lam_2 = (4 kbar + K) k^4/(2 pi s^2) sin E cos E e + kbar e, k^4/(2 pi s^2) = 1/(4 E) before
    // the clamp of E (31) + ||L||^2/(2 eta_1) c^T (63) + e / (2 cos^2 E) (63) + eps_hat Tanh(e / b)
    // (64) + ||G||^4 ||c||^4 cos^2(E) e / (4 eta_3^4), G, c, eta_3 of the outer block (38) +
    // ||H||^2 ||Ybar|| sigma_hat e / sqrt(s^2 + varsigma^2) (64), errata 4 and 7 + e Psi cos^2 E /
    // (phi^2 + s^2) (64)
    let Lam2 = e2 * (t42 + t40 * state.sigma2 * s_scale2 + t41 * t25) + Lam2_error_bound;

    // -- control (64) of block 2 --
    let t43 = state.zeta2 * real(50.0);
    // F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2
    let bracket2 = F2 + A_hat2 - h1_dot + t43 + D_hat2 + Lam2;
    let t44 = bracket2
        .hadamard(Vector::<T, 3>::from_f64([1355818.0, 13558180.0, 13558180.0]));
    // u = -G_2^-1 [ F_2 + A_hat_2 - h_1' + C_2 zeta_2 + D_hat_2 + Lam_2 ]
    let u = -t44;
    // sat(u), each component limited to +-u_max (8)
    let u_sat = u
        .max(Vector::<T, 3>::from_f64([-2000000.0, -20000000.0, -20000000.0]))
        .min(Vector::<T, 3>::from_f64([2000000.0, 20000000.0, 20000000.0]));

    // -- auxiliary system of block 2 (13), erratum 1 --
    // zeta_2' = -C_2 zeta_2 + G_2 (sat(u) - u)
    let zeta2_dot = Vector::<
        T,
        3,
    >::from_f64([7.375621211696555e-7, 7.375621211696555e-8, 7.375621211696555e-8])
        .hadamard(u_sat + t44) - t43;

    // -- observer dynamics of block 2 (50) --
    let t45 = Vector([
        real(-0.3) * w_hat2[0] + real(3.0) * w_hat2[1],
        real(-3.0) * w_hat2[0] + real(-0.3) * w_hat2[1],
        real(-0.3) * w_hat2[2] + real(3.0) * w_hat2[3],
        real(-3.0) * w_hat2[2] + real(-0.3) * w_hat2[3],
        real(-0.3) * w_hat2[4] + real(3.0) * w_hat2[5],
        real(-3.0) * w_hat2[4] + real(-0.3) * w_hat2[5],
    ]);
    let t46 = Vector([
        real(-1.5) * Lam2[0],
        real(1.5) * Lam2[0],
        real(1.5) * Lam2[1],
        Lam2[1],
        real(-2.0) * Lam2[2],
        real(4.0) * Lam2[2],
    ]);
    // th_2' = (M_2 - S_2 L_2) w_hat_2 - S_2 (F_2 + G_2 u - h_1' + C_2 zeta_2 + A_hat_2) (50) = M_2
    // w_hat_2 + S_2 Lam_2, since the sum in brackets is -(D_hat_2 + Lam_2) under (64)
    let th2_dot = t45 + t46;

    // -- network error bound of block 2 (66) --
    // eps_hat_2' = iota_20 (s_2/cos^2 E_2 sum_j e_2j tanh(e_2j/b_2j) - eps_hat_2)
    let eps2_dot = real(0.1) * (t26 * e2.dot(t36) - state.eps2);

    // -- noise bound of block 2 (67) --
    // sigma_hat_2' = taubar_2 (||H_2||^2 ||Ybar_2|| s_2^2 / (cos^2 E_2 sqrt(s_2^2 + varsigma_2^2))
    // - lambda_sigma sigma_hat_2)
    let sigma2_dot = t40 * t37 * sec2E2 * s_scale2 - real(0.1) * state.sigma2;

    // -- compensation of block 2 (68) --
    // Psi_2/(phi_2^2 + s_2^2) + kappa_phi
    let phi2_decay = t41 + real(2.0);

    // -- status --
    // some E_i >= pi/2 - delta
    let violated = violated1.or(violated2);

    // -- states of block 2, one sample later --
    // g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    let th2_step = Vector([
        real(0.001999376166805184) * th2_dot[0]
            + real(1.197117602400319e-5) * th2_dot[1],
        real(-5.985588012001595e-6) * th2_dot[0]
            + real(0.0019933905787931825) * th2_dot[1],
        real(0.0019933945649946256) * th2_dot[2]
            + real(5.985593994724759e-6) * th2_dot[3],
        real(-9.97598999120793e-6) * th2_dot[2] + real(0.00199938015898935) * th2_dot[3],
        real(0.00200335721115358) * th2_dot[4] + real(9.982597068660308e-6) * th2_dot[5],
        real(-1.3975635896124432e-5) * th2_dot[4]
            + real(0.001991378094671188) * th2_dot[5],
    ]);
    // phi_min = sqrt(Psi_2 dt / 0.1), erratum 11
    let phi2_min = (Psi2 * real(0.02)).sqrt();

    // -- states of block 1, one sample later --
    // zeta1(t + dt) = zeta1 + g zeta1', g = (1 - exp(-a dt))/a, a = C_1 (13)
    state.zeta1 = state.zeta1 + zeta1_dot * real(0.0019605280423838395);
    // h1(t + dt) = h1 + g h1', g = (1 - exp(-a dt))/a, a = 1/Fl_1 (33)
    state.h1 = state.h1 + h1_dot * real(0.0019605280423838395);
    // th1(t + dt) = th1 + g th1', g = (1 - exp(-a dt))/a, a = S_1 (21): th_1' = -S_1 (D_hat_1 + F_1
    // + G_1 x_2 + A_hat_1)
    state.th1 = state.th1
        - (D_hat1 + t29 + G1 * x2) * real(10.0) * real(0.00198013266932447);
    // W_1(t + dt) = (1 - g Gamma_1 lambda_1) W_1 + g Gamma_1 P_1 c_1 I_1, g = (1 - exp(-a dt))/a, a
    // = Gamma_1 lambda_1 (32): W_1' = Gamma_1 (P_1 c_1 I_1 - lambda_1 W_1)
    state
        .W1
        .scale_add_outer(
            real(0.9998000199986667),
            P1,
            c1 * real(0.00019998000133326671),
        );

    // -- states of block 2, one sample later --
    // zeta2(t + dt) = zeta2 + g zeta2', g = (1 - exp(-a dt))/a, a = C_2 (13)
    state.zeta2 = state.zeta2 + zeta2_dot * real(0.0019032516392808085);
    // th2(t + dt) = th2 + g th2', g = (1 - exp(-a dt))/a, a = S_2 L_2 - M_2 (50)
    state.th2 = state.th2 + th2_step;
    // W_2(t + dt) = (1 - g Gamma_2 lambda_2) W_2 + g Gamma_2 P_2 c_2 I_2, g = (1 - exp(-a dt))/a, a
    // = Gamma_2 lambda_2 (65): W_2' = Gamma_2 (P_2 c_2 I_2 - lambda_2 W_2)
    state
        .W2
        .scale_add_outer(
            real(0.9998000199986667),
            P2,
            c2 * real(0.00019998000133326671),
        );
    // eps2(t + dt) = eps2 + g eps2', g = (1 - exp(-a dt))/a, a = iota_20 (66)
    state.eps2 = state.eps2 + real(0.001999800013332667) * eps2_dot;
    // sigma2(t + dt) = sigma2 + g sigma2', g = (1 - exp(-a dt))/a, a = taubar_2 lambda_sigma (67)
    state.sigma2 = state.sigma2 + real(0.001999800013332667) * sigma2_dot;
    // phi_2(t + dt) = phi_2 exp(-dt (Psi_2/(phi_2^2 + s_2^2) + kappa_phi)) if ||e_2|| >= iota_phi,
    // else phi_2; at least phi_min (68), erratum 11
    state.phi2 = T::select(
            s2.sqrt().ge(real(0.01)),
            state.phi2 * (-(real(0.002) * phi2_decay)).exp(),
            state.phi2,
        )
        .max(phi2_min);
    ControlOutputs {
        u,
        u_sat,
        violated,
        y_r: clock.y_r,
        e1,
        k1: clock.k1,
        alpha1,
        D_hat1,
        e2,
        k2: clock.k2,
        D_hat2,
    }
}

/// One sample of the control law: control and the signals on the way; the states become those
/// of the next sample.
///
/// Gains of block 1, `attitude`, which are numbers in the formulas: `K = 1.5`, `kbar = 2`, `C = 20
/// I`, `Fl = 0.05 s`, `S = 10 I`, `eta_1 = 1`, `eta_2 = 1`, `eta_3 = 1`, `Gamma = 1`, `lambda = 0.1`,
/// `iota = 0.1`.
///
/// Gains of block 2, `rates`, which are numbers in the formulas: `K = 2`, `kbar = 2`, `C = 50
/// I`, `S = (-1.5 0 0; 1.5 0 0; 0 1.5 0; 0 1 0; 0 0 -2; 0 0 4)`, `M = (-0.3 3; -3 -0.3) in each
/// channel`, `N = 0.05 I in each channel`, `L = diag((0 2), (2 0), (1 1))`, `eta_1 = 0.1`,
/// `Gamma = 1`, `lambda = 0.1`, `iota = 0.1`, `iota_0 = 0.1`, `b = 2`, `eta_noise = 0.1`,
/// `taubar = 1`, `lambda_sigma = 0.1`, `varsigma = 1`, `kappa_phi = 2`, `iota_phi = 0.01`.
///
/// Operations: 564 additions, 852 multiplications, 11 divisions, 4 square roots, 26 elementary
/// functions, 18 comparisons and selections.
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
