//! A small closed loop for tests: a noisy scalar plant under limited proportional control, which follows `sin t`. One run in ten or so has an
//! unstable plant that soon overflows.

use crate::closed_loop::{ClosedLoop, Options};
use crate::linear::{Matrix, Vector};
use crate::noise::Noise;
use crate::sde::{self, Scheme, Sde};
use crate::status::Status;

/// `dx = (a x^3 + u) dt + 0.1 dw`, a = -1 or, in unstable runs, 400.
pub(crate) struct MockLoop<const CONSTRAINED: bool> {
    plant: Plant,
    noise: Option<Noise>,
    sample: u64,
    x: Vector<f64, 1>,
    u: f64,
}

struct Plant {
    a: f64,
    u: f64,
}

impl Sde<f64, 1, 1> for Plant {
    fn drift(&self, _: f64, x: &Vector<f64, 1>) -> Vector<f64, 1> {
        x.map(|x| self.a * x * x * x + self.u)
    }

    fn diffusion(&self, _: f64, _: &Vector<f64, 1>) -> Matrix<f64, 1, 1> {
        Matrix([[0.1]])
    }
}

impl<const CONSTRAINED: bool> MockLoop<CONSTRAINED> {
    const LIMIT: f64 = 2.0;

    fn t(&self) -> f64 {
        self.sample as f64 * Self::SAMPLE_TIME
    }

    fn error(&self) -> f64 {
        self.x[0] - self.t().sin()
    }
}

impl<const CONSTRAINED: bool> ClosedLoop for MockLoop<CONSTRAINED> {
    const NAME: &'static str = "mock";
    const SAMPLE_TIME: f64 = 0.01;
    const OUTPUTS: &'static [&'static str] = &["x"];
    const INPUTS: &'static [&'static str] = &["u"];
    const SIGNALS: &'static [&'static str] = &["t", "x1.x", "e1.x", "ratio1", "u.u", "u_sat.u"];

    fn new(options: &Options) -> Self {
        let unstable =
            options.dispersion && Noise::dispersion(options.seed, options.run).uniform(0, 0) > 0.9;
        Self {
            plant: Plant {
                a: if unstable { 400.0 } else { -1.0 },
                u: 0.0,
            },
            noise: options
                .noise
                .then(|| Noise::process(options.seed, options.run)),
            sample: 0,
            x: Vector([0.5]),
            u: 0.0,
        }
    }

    fn control(&mut self) -> Status {
        self.u = -8.0 * self.error();
        self.plant.u = self.u.clamp(-Self::LIMIT, Self::LIMIT);
        Status::SATURATED.when(self.plant.u != self.u)
    }

    fn advance(&mut self) {
        let dt = Self::SAMPLE_TIME;
        let draw = self.noise.map_or(0.0, |noise| noise.normal(self.sample, 0));
        let dw = Vector([draw * dt.sqrt()]);
        self.x = sde::step(
            Scheme::EulerMaruyama,
            &self.plant,
            self.t(),
            &self.x,
            dt,
            &dw,
        );
        self.sample += 1;
    }

    fn telemetry(&self, row: &mut [f64]) {
        let ratio = self.constraint_ratio();
        row.copy_from_slice(&[
            self.t(),
            self.x[0],
            self.error(),
            ratio,
            self.u,
            self.plant.u,
        ]);
    }

    fn constraint_ratio(&self) -> f64 {
        if CONSTRAINED {
            self.error().abs() / (0.4 * (-4.0 * self.t()).exp() + 0.15)
        } else {
            f64::NAN
        }
    }

    fn tracking_error(&self, error: &mut [f64]) {
        error[0] = self.error();
    }

    fn saturated(&self, saturated: &mut [bool]) {
        saturated[0] = self.plant.u != self.u;
    }

    fn is_finite(&self) -> bool {
        self.x.is_finite() && self.u.is_finite()
    }
}
