//! Convergence orders of the integrators, measured against exact solutions driven by the same Wiener paths.

use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;
use nsv_runtime::sde::{Scheme, Sde, stages, step};

/// `dx_i = mu_i x_i dt + s_i x_i dw_i`, each channel drives a state of its own.
struct GeometricBrownianMotion {
    drift: [f64; 3],
    volatility: [f64; 3],
}

impl Sde<f64, 3, 3> for GeometricBrownianMotion {
    type Instant = f64;

    fn drift(&self, _: &f64, x: &Vector<f64, 3>) -> Vector<f64, 3> {
        Vector(self.drift).hadamard(*x)
    }

    fn diffusion(&self, _: &f64, x: &Vector<f64, 3>) -> Matrix<f64, 3, 3> {
        let column = Vector(self.volatility).hadamard(*x);
        Matrix::rows(std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { column[i] } else { 0.0 })
        }))
    }
}

/// `dx = -theta x dt + s dw`.
struct OrnsteinUhlenbeck {
    theta: f64,
    intensity: f64,
}

impl Sde<f64, 1, 1> for OrnsteinUhlenbeck {
    type Instant = f64;

    fn drift(&self, _: &f64, x: &Vector<f64, 1>) -> Vector<f64, 1> {
        *x * -self.theta
    }

    fn diffusion(&self, _: &f64, _: &Vector<f64, 1>) -> Matrix<f64, 1, 1> {
        Matrix::rows([[self.intensity]])
    }
}

/// `x_1' = x_2, x_2' = -x_1, x_3' = -2 t x_3`: solution `(cos t, -sin t, exp(-t^2))`. No noise.
struct Deterministic;

impl Sde<f64, 3, 0> for Deterministic {
    type Instant = f64;

    fn drift(&self, t: &f64, x: &Vector<f64, 3>) -> Vector<f64, 3> {
        Vector([x[1], -x[0], -2.0 * t * x[2]])
    }

    fn diffusion(&self, _: &f64, _: &Vector<f64, 3>) -> Matrix<f64, 3, 0> {
        Matrix::rows([[]; 3])
    }
}

/// Least-squares slope of log2 error over log2 step.
fn order(errors: &[(f64, f64)]) -> f64 {
    let n = errors.len() as f64;
    let points = errors.iter().map(|&(dt, error)| (dt.log2(), error.log2()));
    let (mean_x, mean_y) = points
        .clone()
        .fold((0.0, 0.0), |(a, b), (x, y)| (a + x / n, b + y / n));
    let (covariance, variance) = points.fold((0.0, 0.0), |(c, v), (x, y)| {
        (c + (x - mean_x) * (y - mean_y), v + (x - mean_x).powi(2))
    });
    covariance / variance
}

/// Finest level of the Wiener paths on [0, 1]: 2^10 increments; steps use 2^4 to 2^9.
const FINE: usize = 1024;
const PATHS: u64 = 1000;
const LEVELS: [usize; 6] = [16, 32, 64, 128, 256, 512];

/// End point of one path with `steps` equal steps over [0, 1], increments summed from the fine ones.
fn integrate<const N: usize, const Q: usize>(
    scheme: Scheme,
    sde: &impl Sde<f64, N, Q, Instant = f64>,
    initial: Vector<f64, N>,
    steps: usize,
    fine: &[Vector<f64, Q>],
) -> Vector<f64, N> {
    let dt = 1.0 / steps as f64;
    let mut x = initial;
    for k in 0..steps {
        let width = fine.len() / steps;
        let dw = fine[k * width..(k + 1) * width]
            .iter()
            .fold(Vector::zero(), |sum, &dw| sum + dw);
        x = step(
            scheme,
            sde,
            stages(k as f64 * dt, dt).each_ref(),
            &x,
            dt,
            &dw,
        );
    }
    x
}

/// Mean norm of the error at the end for each step size.
fn strong_errors<const N: usize, const Q: usize>(
    scheme: Scheme,
    sde: &impl Sde<f64, N, Q, Instant = f64>,
    initial: Vector<f64, N>,
    path: impl Fn(u64) -> (Vec<Vector<f64, Q>>, Vector<f64, N>),
) -> Vec<(f64, f64)> {
    let mut errors = LEVELS.map(|steps| (1.0 / steps as f64, 0.0));
    for run in 0..PATHS {
        let (fine, exact) = path(run);
        for (steps, (_, error)) in LEVELS.into_iter().zip(&mut errors) {
            let found = integrate(scheme, sde, initial, steps, &fine);
            *error += (found - exact).sum_squares().sqrt() / PATHS as f64;
        }
    }
    errors.to_vec()
}

/// The tolerance covers the sampling error of 1000 paths and the curvature over six step sizes.
fn assert_order(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() < 0.1,
        "order {found:.3}, expected {expected}"
    );
}

const MOTION: GeometricBrownianMotion = GeometricBrownianMotion {
    drift: [0.5, -0.3, 0.1],
    volatility: [0.6, 0.9, 0.4],
};
const START: Vector<f64, 3> = Vector([1.0, 2.0, 0.5]);

/// `x_i(1) = x_i(0) exp(mu_i - s_i^2/2 + s_i w_i(1))`.
fn motion_path(run: u64) -> (Vec<Vector<f64, 3>>, Vector<f64, 3>) {
    let noise = Noise::<f64>::process(1, run);
    let root = (1.0 / FINE as f64).sqrt();
    let fine: Vec<_> = (0..FINE)
        .map(|k| {
            Vector(std::array::from_fn(|j| {
                noise.normal(k as u64, j as u32) * root
            }))
        })
        .collect();
    let end = fine.iter().fold(Vector::zero(), |sum, &dw| sum + dw);
    let exact = Vector(std::array::from_fn(|i| {
        let (mu, s): (f64, f64) = (MOTION.drift[i], MOTION.volatility[i]);
        START[i] * (mu - 0.5 * s * s + s * end[i]).exp()
    }));
    (fine, exact)
}

#[test]
fn euler_maruyama_has_order_one_half_for_multiplicative_noise() {
    assert_order(
        order(&strong_errors(
            Scheme::EulerMaruyama,
            &MOTION,
            START,
            motion_path,
        )),
        0.5,
    );
}

#[test]
fn platen_has_order_one_for_diagonal_noise() {
    assert_order(
        order(&strong_errors(Scheme::Platen, &MOTION, START, motion_path)),
        1.0,
    );
}

const PROCESS: OrnsteinUhlenbeck = OrnsteinUhlenbeck {
    theta: 2.0,
    intensity: 0.7,
};

/// The exact solution over a fine step of length h is `x exp(-theta h) + s I` with `I = int exp(-theta (h - r)) dw_r`; `dw` and `I` are drawn
/// jointly from `Var I = (1 - exp(-2 theta h)) / (2 theta)`, `Cov(I, dw) = (1 - exp(-theta h)) / theta`.
fn process_path(run: u64) -> (Vec<Vector<f64, 1>>, Vector<f64, 1>) {
    let noise = Noise::<f64>::process(2, run);
    let OrnsteinUhlenbeck { theta, intensity } = PROCESS;
    let h = 1.0 / FINE as f64;
    let covariance = -(-theta * h).exp_m1() / theta;
    let variance = -(-2.0 * theta * h).exp_m1() / (2.0 * theta);
    let residual = (variance - covariance * covariance / h).sqrt();
    let mut exact = 1.0;
    let mut fine = Vec::with_capacity(FINE);
    for k in 0..FINE as u64 {
        let dw = noise.normal(k, 0) * h.sqrt();
        exact = exact * (-theta * h).exp()
            + intensity * (covariance / h * dw + residual * noise.normal(k, 1));
        fine.push(Vector([dw]));
    }
    (fine, Vector([exact]))
}

#[test]
fn both_schemes_have_order_one_for_additive_noise() {
    for scheme in [Scheme::EulerMaruyama, Scheme::Platen] {
        assert_order(
            order(&strong_errors(
                scheme,
                &PROCESS,
                Vector([1.0]),
                process_path,
            )),
            1.0,
        );
    }
}

#[test]
fn platen_is_euler_maruyama_for_additive_noise() {
    let x = Vector([0.3]);
    let [a, b] = [Scheme::EulerMaruyama, Scheme::Platen].map(|scheme| {
        step(
            scheme,
            &PROCESS,
            stages(0.0, 0.01).each_ref(),
            &x,
            0.01,
            &Vector([0.05]),
        )
    });
    assert_eq!(a, b);
}

#[test]
fn runge_kutta_has_order_four_in_state_and_time() {
    let exact = Vector([1.0_f64.cos(), -1.0_f64.sin(), (-1.0_f64).exp()]);
    let errors = [8, 16, 32, 64, 128].map(|steps| {
        let fine = vec![Vector([]); steps];
        let found = integrate(
            Scheme::RungeKutta4,
            &Deterministic,
            Vector([1.0, 0.0, 1.0]),
            steps,
            &fine,
        );
        (1.0 / steps as f64, (found - exact).sum_squares().sqrt())
    });
    assert_order(order(&errors), 4.0);
}

#[test]
fn euler_without_noise_has_order_one() {
    let exact = Vector([1.0_f64.cos(), -1.0_f64.sin(), (-1.0_f64).exp()]);
    let errors = [64, 128, 256, 512].map(|steps| {
        let fine = vec![Vector([]); steps];
        let found = integrate(
            Scheme::EulerMaruyama,
            &Deterministic,
            Vector([1.0, 0.0, 1.0]),
            steps,
            &fine,
        );
        (1.0 / steps as f64, (found - exact).sum_squares().sqrt())
    });
    assert_order(order(&errors), 1.0);
}
