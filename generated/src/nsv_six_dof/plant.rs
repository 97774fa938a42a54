// SHA-256 of the text below: 32dfd018e196a27cd9fbebfba56073744cc575afbdb5d9dbc90f40709ce6b06d
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// plant: 350 additions, 507 multiplications, 10 divisions, 1 square roots, 20 elementary functions, 47 comparisons and selections

//! `nsv_six_dof`: plant and disturbances.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use super::params::Params;
use super::polynomials;
use nsv_runtime::ahead::OfTime;
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::real::{Part, Real};
use nsv_runtime::sde::Sde;

/// Number of plant states: `alpha` (dimensionless), `beta` (dimensionless), `mu`
/// (dimensionless), `p` (1/s), `q` (1/s), `r` (1/s), `airspeed` (m/s), `climb` (dimensionless),
/// `heading` (dimensionless), `height` (m), `north` (m), `east` (m), then 6 states of the
/// exosystems of block 2.
pub const STATES: usize = 18;

/// Number of noise channels.
pub const NOISE_CHANNELS: usize = 9;

/// Initial state, SI.
pub const INITIAL_STATE: [f64; STATES] = [
    0.008726646259971648,
    0.008726646259971648,
    0.0,
    0.0,
    0.0,
    0.0,
    3000.0,
    0.0,
    0.0,
    22000.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
];

/// The plant under a control that is held between samples.
#[derive(Clone, Copy, Debug)]
pub struct Plant<T> {
    /// Parameters.
    pub params: Params<T>,
    /// Values of [`prepare`] for these parameters.
    pub prepared: Prepared<T>,
    /// Control, held between samples.
    pub u_sat: Vector<T, 3>,
    /// Noise, standard normal, held between samples.
    pub xi: Vector<T, NOISE_CHANNELS>,
}

impl<T: Real> Sde<T, STATES, 0> for Plant<T> {
    type Instant = Clock<T>;
    #[inline(always)]
    fn drift(&self, at: &Self::Instant, x: &Vector<T, STATES>) -> Vector<T, STATES> {
        T::outlined(Drift { plant: self, clock: at, x })
    }

    #[inline(always)]
    fn diffusion(
        &self,
        _at: &Self::Instant,
        _x: &Vector<T, STATES>,
    ) -> Matrix<T, STATES, 0> {
        Matrix::zero()
    }
}
/// Drift, with the noise that is held between samples.
struct Drift<'a, T> {
    plant: &'a Plant<T>,
    clock: &'a Clock<T>,
    x: &'a Vector<T, STATES>,
}
impl<T: Real> Part for Drift<'_, T> {
    type Output = Vector<T, STATES>;
    #[inline(always)]
    fn run(self) -> Vector<T, STATES> {
        let rate = dynamics(
            *self.x,
            self.plant.u_sat,
            &self.plant.params,
            self.clock,
            &self.plant.prepared,
        );
        rate.drift + diffuse(&rate.diffusion, &self.plant.xi)
    }
}

/// Diffusion times noise, without the entries that are always 0.
#[inline(always)]
fn diffuse<T: Real>(
    diffusion: &Matrix<T, STATES, NOISE_CHANNELS>,
    noise: &Vector<T, NOISE_CHANNELS>,
) -> Vector<T, STATES> {
    Vector([
        T::zero(),
        T::zero(),
        T::zero(),
        diffusion[(3, 0)] * noise[0] + diffusion[(3, 1)] * noise[1]
            + diffusion[(3, 2)] * noise[2],
        diffusion[(4, 0)] * noise[0] + diffusion[(4, 1)] * noise[1]
            + diffusion[(4, 2)] * noise[2],
        diffusion[(5, 0)] * noise[0] + diffusion[(5, 1)] * noise[1]
            + diffusion[(5, 2)] * noise[2],
        T::zero(),
        T::zero(),
        T::zero(),
        T::zero(),
        T::zero(),
        T::zero(),
        diffusion[(12, 3)] * noise[3],
        diffusion[(13, 4)] * noise[4],
        diffusion[(14, 5)] * noise[5],
        diffusion[(15, 6)] * noise[6],
        diffusion[(16, 7)] * noise[7],
        diffusion[(17, 8)] * noise[8],
    ])
}

/// Values of [`prepare`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Prepared<T> {
    /// Part of `roll_delta`.
    pub roll_delta_1: T,
    /// Part of `pitch_delta`.
    pub pitch_delta_1: T,
    /// Part of `yaw_delta`.
    pub yaw_delta_1: T,
}

/// What depends on the parameters alone: needed once for a run. See [`Prepared`].
///
/// Operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 0 elementary
/// functions, 0 comparisons and selections.
#[inline(always)]
pub fn prepare<T: Real>(params: &Params<T>) -> Prepared<T> {
    let real = T::from_f64;
    let roll_delta_1 = real(1777048495.9577248) * params.Cl_scale;
    let pitch_delta_1 = real(24.384) * params.Cm_scale;
    let yaw_delta_1 = real(18.288) * params.Cn_scale;
    Prepared {
        roll_delta_1,
        pitch_delta_1,
        yaw_delta_1,
    }
}

/// Values of [`clock`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Clock<T> {
    /// `d_1(t)`
    pub d1: Vector<T, 3>,
    /// `speed_aim`.
    pub speed_aim: T,
    /// Part of `drift`.
    pub drift_1: Vector<T, 1>,
    /// Part of `drift`.
    pub drift_2: Vector<T, 1>,
}

impl<T: Real> OfTime<T> for Clock<T> {
    #[inline(always)]
    fn at(t: T) -> Self {
        clock(t)
    }

    #[inline(always)]
    fn of_lane(&self, lane: usize) -> Self {
        Self {
            d1: self.d1.in_every_lane(lane),
            speed_aim: self.speed_aim.in_every_lane(lane),
            drift_1: self.drift_1.in_every_lane(lane),
            drift_2: self.drift_2.in_every_lane(lane),
        }
    }
}

/// What depends on time and parameters alone: needed once for a sample of all runs with these
/// parameters. See [`Clock`].
///
/// Operations: 3 additions, 11 multiplications, 0 divisions, 0 square roots, 3 elementary
/// functions, 2 comparisons and selections.
#[inline(always)]
pub fn clock<T: Real>(t: T) -> Clock<T> {
    let real = T::from_f64;

    // -- true dynamics of block 1 (attitude) (11) --
    let t1 = real(2.0) * t;
    let [sin_t, sin_t1] = Vector([t, t1]).sin().0;
    let t2 = (real(-0.1) * t).exp();
    let t3 = real(0.02) * sin_t1 * t2;
    let t4 = real(0.02) * sin_t * t2;
    // d_1(t)
    let d1 = Vector([t3, t4, t3]);

    // -- plant model --
    let t5 = ((t - real(5.0)) * real(0.025)).max(real(0.0)).min(real(1.0));
    let speed_aim = real(3000.0)
        + real(150.0) * (t5 * t5 * (real(3.0) - real(2.0) * t5));
    let drift_1 = Vector([t3]);
    let drift_2 = Vector([t4]);
    Clock {
        d1,
        speed_aim,
        drift_1,
        drift_2,
    }
}

/// Results of [`plant`].
#[derive(Clone, Copy, Debug)]
pub struct PlantOutputs<T: Real> {
    /// `dx/dt without noise`
    pub drift: Vector<T, 18>,
    /// `columns: one per Wiener process`
    pub diffusion: Matrix<T, 18, 9>,
    /// `d_1(t)`
    pub d1: Vector<T, 3>,
    /// `d_2 = L_2 w_2 (12)`
    pub d2: Vector<T, 3>,
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 347 additions, 493 multiplications, 10 divisions, 1 square roots, 17 elementary
/// functions, 45 comparisons and selections.
#[inline(always)]
pub fn dynamics<T: Real>(
    x: Vector<T, 18>,
    u_sat: Vector<T, 3>,
    params: &Params<T>,
    clock: &Clock<T>,
    prepared: &Prepared<T>,
) -> PlantOutputs<T> {
    let real = T::from_f64;

    // -- true dynamics of block 2 (rates) (11) --
    let t1 = real(2.0) * x[13];
    let t2 = real(3.0) * x[14];
    let t3 = x[16] + x[17];
    // d_2 = L_2 w_2 (12)
    let d2 = Vector([t1, t2, t3]);

    // -- plant model --
    let alpha = x[0];
    let beta = x[1];
    let mu = x[2];
    let alpha_deg = alpha * real(57.29577951308232);
    let at_alpha_deg_2 = polynomials::at_alpha_deg_2_2(alpha_deg);
    let dCl = Vector([
        at_alpha_deg_2.Cl_LE_d3,
        at_alpha_deg_2.Cl_RE_d3,
        at_alpha_deg_2.Cl_RUD_d3,
    ]);
    let roll_delta = dCl * prepared.roll_delta_1;
    let dCm = Vector([at_alpha_deg_2.Cm_LE_d3, at_alpha_deg_2.Cm_RE_d3, real(0.0)]);
    let heading = x[8];
    let climb = x[7];
    let pitch_delta = dCm * prepared.pitch_delta_1 * real(97170193.3485195);
    let dCn = Vector([
        at_alpha_deg_2.Cn_LE_d3,
        at_alpha_deg_2.Cn_RE_d3,
        at_alpha_deg_2.Cn_RUD_d3,
    ]);
    let yaw_delta = dCn * prepared.yaw_delta_1 * real(97170193.3485195);
    let p = x[3];
    let q = x[4];
    let r = x[5];
    let airspeed = x[6];
    let height = x[9];
    let t4 = height.max(real(-5000.0)).min(real(86000.0));
    let t5 = real(6356766.0) * t4 / (real(6356766.0) + t4);
    let t6 = t5.lt(real(11000.0));
    let t7 = t5.lt(real(20000.0));
    let t8 = t5.lt(real(32000.0));
    let t9 = t5.lt(real(47000.0));
    let t10 = t5.lt(real(51000.0));
    let t11 = t5.lt(real(71000.0));
    let t12 = T::select(
        t7,
        real(22632.06397346293),
        T::select(
            t8,
            real(5474.88866967778),
            T::select(
                t9,
                real(868.0186847552274),
                T::select(
                    t10,
                    real(110.90630555496588),
                    T::select(t11, real(66.93887311868727), real(3.9564204280407287)),
                ),
            ),
        ),
    );
    let t13 = T::select(
        t7,
        real(0.0),
        T::select(
            t8,
            real(1000.0),
            T::select(
                t9,
                real(357.14285714285717),
                T::select(
                    t10,
                    real(0.0),
                    T::select(t11, real(-357.14285714285717), real(-500.0)),
                ),
            ),
        ),
    );
    let t14 = T::select(
        t7,
        real(216.65),
        T::select(
            t8,
            real(216.65),
            T::select(
                t9,
                real(228.65),
                T::select(t10, real(270.65), T::select(t11, real(270.65), real(214.65))),
            ),
        ),
    );
    let t15 = T::select(t6, real(288.15), t14);
    let t16 = T::select(
        t7,
        real(0.0),
        T::select(
            t8,
            real(0.001),
            T::select(
                t9,
                real(0.0028),
                T::select(t10, real(0.0), T::select(t11, real(-0.0028), real(-0.002))),
            ),
        ),
    );
    let t17 = T::select(
        t7,
        real(11000.0),
        T::select(
            t8,
            real(20000.0),
            T::select(
                t9,
                real(32000.0),
                T::select(
                    t10,
                    real(47000.0),
                    T::select(t11, real(51000.0), real(71000.0)),
                ),
            ),
        ),
    );
    let t18 = t5 - T::select(t6, real(0.0), t17);
    let t19 = t15 + T::select(t6, real(-0.0065), t16) * t18;
    let t20 = T::select(
        t6,
        real(0.0),
        T::select(
            t7,
            real(0.004615739672282483),
            T::select(
                t8,
                real(0.0),
                T::select(
                    t9,
                    real(0.0),
                    T::select(t10, real(0.0036948087936449292), real(0.0)),
                ),
            ),
        ),
    ) * t18;
    let t21 = (real(-0.03416319473631036)
        * (T::select(t6, real(-153.84615384615384), t13) * (t19 / t15).ln() + t20))
        .exp();
    let t22 = real(0.5)
        * (T::select(t6, real(101325.0), t12) * t21 * real(0.0289644)
            / (real(8.31432) * t19)) * (airspeed * airspeed);
    let qs_now = t22 * real(334.73);
    let mach_now = airspeed / (real(11.640048) * t19 * real(34.52514120782754)).sqrt();
    let lift_now = qs_now * params.CL_scale
        * (polynomials::CL_alpha(alpha_deg, mach_now, real(0.0))
            + polynomials::CL_LE(alpha_deg, mach_now, real(0.0))
            + polynomials::CL_RE(alpha_deg, mach_now, real(0.0)));
    let t23 = polynomials::CD_alpha(alpha_deg, mach_now, real(0.0))
        + polynomials::CD_LE(alpha_deg, mach_now, real(0.0))
        + polynomials::CD_RE(alpha_deg, mach_now, real(0.0));
    let drag_now = qs_now * params.CD_scale
        * (t23 + polynomials::CD_RUD(alpha_deg, mach_now, real(0.0)));
    let push = (drag_now + real(136820.0) * (clock.speed_aim - airspeed) * real(0.25))
        .max(real(0.0))
        .min(real(1500000.0));
    let t24 = real(6378137.0) / (real(6378137.0) + height);
    let weight = real(1341745.853) * (t24 * t24);
    let t25 = polynomials::CY_beta(alpha_deg, mach_now, real(0.0)) * beta
        + polynomials::CY_LE(alpha_deg, mach_now, real(0.0))
        + polynomials::CY_RE(alpha_deg, mach_now, real(0.0));
    let side_now = qs_now * params.CY_scale
        * (t25 + polynomials::CY_RUD(alpha_deg, mach_now, real(0.0)));
    let M_x = u_sat[0];
    let M_y = u_sat[1];
    let M_z = u_sat[2];

    // -- true dynamics of block 2 (rates) (11) --
    let t26 = Matrix::rows([
        [
            roll_delta[0] * real(7.375621211696555e-7),
            roll_delta[1] * real(7.375621211696555e-7),
            roll_delta[2] * real(7.375621211696555e-7),
        ],
        [
            pitch_delta[0] * real(7.375621211696555e-8),
            pitch_delta[1] * real(7.375621211696555e-8),
            pitch_delta[2] * real(7.375621211696555e-8),
        ],
        [
            yaw_delta[0] * real(7.375621211696555e-8),
            yaw_delta[1] * real(7.375621211696555e-8),
            yaw_delta[2] * real(7.375621211696555e-8),
        ],
    ]);
    // H_2 Sigma_2
    let HSigma2 = t26 * real(0.05);

    // -- packed plant state: x_1 .. x_n, further states, then the exosystems --
    let t27 = Vector([alpha, beta, mu, climb, heading]);
    let [sin_alpha, sin_beta, sin_mu, sin_climb, sin_heading] = t27.sin().0;
    let [cos_alpha, cos_beta, cos_mu, cos_climb, cos_heading] = t27.cos().0;
    let [_, tan_beta, _, tan_climb, _] = t27.tan().0;
    let t28 = p * cos_alpha + r * sin_alpha;
    let t29 = weight * cos_climb;
    let t30 = t29 * cos_mu;
    let t31 = real(136820.0) * airspeed;
    let t32 = Vector([
        q - tan_beta * t28 + (-lift_now - push * sin_alpha + t30) / (t31 * cos_beta),
    ]);
    let t33 = t32 + clock.drift_1;
    let t34 = push * cos_alpha;
    let t35 = real(1.0) / t31;
    let t36 = (side_now - t34 * sin_beta + t29 * sin_mu) * t35;
    let t37 = Vector([p * sin_alpha - r * cos_alpha + t36]) + clock.drift_2;
    let t38 = tan_beta + tan_climb * sin_mu;
    let t39 = lift_now * t38 + side_now * tan_climb * cos_mu - t30 * tan_beta;
    let t40 = cos_alpha * sin_beta;
    let t41 = (t39 + push * (sin_alpha * t38 - t40 * tan_climb * cos_mu)) * t35;
    let t42 = Vector([t28 / cos_beta + t41]) + clock.drift_1;
    let t43 = qs_now * real(18.288);
    let t44 = polynomials::Cl_beta(alpha_deg, mach_now, real(0.0)) * beta
        + polynomials::Cl_LE(alpha_deg, mach_now, real(0.0))
        + polynomials::Cl_RE(alpha_deg, mach_now, real(0.0));
    let t45 = real(1.0) / (real(2.0) * airspeed);
    let t46 = t44 + polynomials::Cl_RUD(alpha_deg, mach_now, real(0.0))
        + polynomials::Cl_p(alpha_deg, mach_now, real(0.0)) * p * real(18.288) * t45;
    let t47 = t43 * params.Cl_scale
        * (t46
            + polynomials::Cl_r(alpha_deg, mach_now, real(0.0)) * r * real(18.288) * t45)
        + M_x;
    let t48 = Vector([t47 * real(7.375621211696555e-7)]) + Vector([t1]);
    let t49 = polynomials::Cm_alpha(alpha_deg, mach_now, real(0.0))
        + polynomials::Cm_LE(alpha_deg, mach_now, real(0.0))
        + polynomials::Cm_RE(alpha_deg, mach_now, real(0.0));
    let t50 = t49 + polynomials::Cm_RUD(alpha_deg, mach_now, real(0.0))
        + polynomials::Cm_q(alpha_deg, mach_now, real(0.0)) * q * real(24.384) * t45;
    let t51 = Vector([
        (real(12202362.0) * p * r + qs_now * real(24.384) * params.Cm_scale * t50 + M_y)
            * real(7.375621211696555e-8),
    ]);
    let t52 = t51 + Vector([t2]);
    let t53 = polynomials::Cn_beta(alpha_deg, mach_now, real(0.0)) * beta
        + polynomials::Cn_LE(alpha_deg, mach_now, real(0.0))
        + polynomials::Cn_RE(alpha_deg, mach_now, real(0.0));
    let t54 = t53 + polynomials::Cn_RUD(alpha_deg, mach_now, real(0.0))
        + polynomials::Cn_p(alpha_deg, mach_now, real(0.0)) * p * real(18.288) * t45;
    let t55 = t43 * params.Cn_scale
        * (t54
            + polynomials::Cn_r(alpha_deg, mach_now, real(0.0)) * r * real(18.288)
                * t45);
    let t56 = Vector([
        (real(-12202362.0) * p * q + t55 + M_z) * real(7.375621211696555e-8),
    ]) + Vector([t3]);
    let t57 = lift_now * cos_mu - side_now * sin_mu
        + push * (sin_alpha * cos_mu + t40 * sin_mu);
    let t58 = lift_now * sin_mu + side_now * cos_mu
        + push * (sin_alpha * sin_mu - t40 * cos_mu);
    let t59 = airspeed * cos_climb;
    // dx/dt without noise
    let drift = Vector([
        t33[0],
        t37[0],
        t42[0],
        t48[0],
        t52[0],
        t56[0],
        (t34 * cos_beta - drag_now) * real(7.308872971787751e-6)
            - weight * sin_climb * real(7.308872971787751e-6),
        (t57 - t29) * t35,
        t58 / (t31 * cos_climb),
        airspeed * sin_climb,
        t59 * cos_heading,
        t59 * sin_heading,
        real(3.0) * x[13],
        real(-3.0) * x[12],
        real(3.0) * x[15],
        real(-3.0) * x[14],
        real(3.0) * x[17],
        real(-3.0) * x[16],
    ]);
    // columns: one per Wiener process
    let diffusion = {
        let mut sparse = Matrix::<T, 18, 9>::zero();
        sparse[(3, 0)] = HSigma2[(0, 0)];
        sparse[(3, 1)] = HSigma2[(0, 1)];
        sparse[(3, 2)] = HSigma2[(0, 2)];
        sparse[(4, 0)] = HSigma2[(1, 0)];
        sparse[(4, 1)] = HSigma2[(1, 1)];
        sparse[(4, 2)] = HSigma2[(1, 2)];
        sparse[(5, 0)] = HSigma2[(2, 0)];
        sparse[(5, 1)] = HSigma2[(2, 1)];
        sparse[(5, 2)] = HSigma2[(2, 2)];
        sparse[(12, 3)] = real(0.5);
        sparse[(13, 4)] = real(0.5);
        sparse[(14, 5)] = real(0.5);
        sparse[(15, 6)] = real(0.5);
        sparse[(16, 7)] = real(0.5);
        sparse[(17, 8)] = real(0.5);
        sparse
    };
    PlantOutputs {
        drift,
        diffusion,
        d1: clock.d1,
        d2,
    }
}

/// Drift and diffusion of the plant and its disturbances.
///
/// Operations: 350 additions, 507 multiplications, 10 divisions, 1 square roots, 20 elementary
/// functions, 47 comparisons and selections.
#[inline(always)]
pub fn plant<T: Real>(
    t: T,
    x: Vector<T, 18>,
    u_sat: Vector<T, 3>,
    params: &Params<T>,
) -> PlantOutputs<T> {
    let prepared = prepare(params);
    let clock = clock(t);
    dynamics(x, u_sat, params, &clock, &prepared)
}
