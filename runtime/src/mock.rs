//! A small closed loop for tests: a noisy scalar plant under limited proportional control, which follows `sin t`. One run in ten or so has an
//! unstable plant that soon overflows.

use crate::closed_loop::{ClosedLoop, Options, Runs};
use crate::linear::{Matrix, Vector};
use crate::noise::Noise;
use crate::real::{Mask, Real};
use crate::sde::{self, Scheme, Sde};

/// `dx = (a x^3 + u) dt + 0.1 dw`, a = -1 or, in unstable runs, 400.
pub(crate) struct MockLoop<const CONSTRAINED: bool, T: Real = f64> {
    plant: Plant<T>,
    noise: Option<Noise<T>>,
    sample: u64,
    x: Vector<T, 1>,
    u: T,
}

struct Plant<T> {
    a: T,
    u: T,
}

impl<T: Real> Sde<T, 1, 1> for Plant<T> {
    type Instant = ();

    #[inline(always)]
    fn drift(&self, _: &(), x: &Vector<T, 1>) -> Vector<T, 1> {
        Vector([self.a * x[0] * x[0] * x[0] + self.u])
    }

    #[inline(always)]
    fn diffusion(&self, _: &(), _: &Vector<T, 1>) -> Matrix<T, 1, 1> {
        Matrix::rows([[T::from_f64(0.1)]])
    }
}

const SAMPLE_TIME: f64 = 0.01;

const LIMIT: f64 = 2.0;

impl<const CONSTRAINED: bool, T: Real> MockLoop<CONSTRAINED, T> {
    fn t(&self) -> T {
        T::from_f64(self.sample as f64 * SAMPLE_TIME)
    }

    fn error(&self) -> T {
        self.x[0] - self.t().sin()
    }
}

impl<const CONSTRAINED: bool> ClosedLoop for MockLoop<CONSTRAINED> {
    const NAME: &'static str = "mock";
    const SAMPLE_TIME: f64 = SAMPLE_TIME;
    const OUTPUTS: &'static [&'static str] = &["x"];
    const INPUTS: &'static [&'static str] = &["u"];
    const SIGNALS: &'static [&'static str] = &["t", "x1.x", "error.x", "ratio1", "u.u", "u_sat.u"];

    type Runs<T: Real> = MockLoop<CONSTRAINED, T>;
}

impl<const CONSTRAINED: bool, T: Real> Runs<T> for MockLoop<CONSTRAINED, T> {
    #[inline(always)]
    fn new(options: &Options) -> Self {
        let draw = Noise::<T>::dispersion(options.seed, options.run).uniform(0, 0);
        let unstable = draw
            .gt(T::from_f64(0.9))
            .and(T::Mask::splat(options.dispersion));
        Self {
            plant: Plant {
                a: T::select(unstable, T::from_f64(400.0), T::from_f64(-1.0)),
                u: T::zero(),
            },
            noise: options
                .noise
                .then(|| Noise::process(options.seed, options.run)),
            sample: 0,
            x: Vector([T::from_f64(0.5)]),
            u: T::zero(),
        }
    }

    #[inline(always)]
    fn observe(&mut self) {}

    #[inline(always)]
    fn control(&mut self) {
        self.u = T::from_f64(-8.0) * self.error();
        self.plant.u = self.u.max(T::from_f64(-LIMIT)).min(T::from_f64(LIMIT));
    }

    #[inline(always)]
    fn advance(&mut self) {
        let draw = match &self.noise {
            Some(noise) => noise.normal(self.sample, 0),
            None => T::zero(),
        };
        self.x = sde::step(
            Scheme::EulerMaruyama,
            &self.plant,
            [&(); 3],
            &self.x,
            SAMPLE_TIME,
            &Vector([draw * T::from_f64(SAMPLE_TIME).sqrt()]),
        );
        self.sample += 1;
    }

    fn telemetry(&self, row: &mut [T]) {
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

    #[inline(always)]
    fn constraint_ratio(&self) -> T {
        if CONSTRAINED {
            let bound = T::from_f64(0.4) * (T::from_f64(-4.0) * self.t()).exp();
            self.error().abs() / (bound + T::from_f64(0.15))
        } else {
            T::from_f64(f64::NAN)
        }
    }

    #[inline(always)]
    fn tracking_error(&self, error: &mut [T]) {
        error[0] = self.error();
    }

    #[inline(always)]
    fn saturated(&self, saturated: &mut [T::Mask]) {
        saturated[0] = self.plant.u.ne(self.u);
    }

    #[inline(always)]
    fn is_finite(&self) -> T::Mask {
        self.x.is_finite().and(self.u.is_finite())
    }
}
