//! Public ensemble benchmarks with nsv's runtime: its lanes, its noise and its one-step schemes.
//!
//! - Geometric Brownian motion of three states, 256 Euler-Maruyama steps: `du = 1.5 u dt + 0.01 u dW` from 0.1 over one second
//!   (DiffEqGPU's ensemble of SDEs).
//! - The Lorenz equations from (1, 0, 0) over one second in 1000 steps of fourth-order Runge-Kutta, the Rayleigh number from 0 to 21 over
//!   the ensemble (the parameter sweep of the same benchmarks, whose scheme is Tsitouras').

use std::slice;

use nsv_runtime::lanes::{self, Kernel, Width};
use nsv_runtime::linear::{Matrix, Vector};
use nsv_runtime::noise::Noise;
use nsv_runtime::real::Real;
use nsv_runtime::sde::{self, Scheme, Sde};

type Finals = [[f64; 3]];

struct Brownian<T> {
    growth: T,
    volatility: T,
}

impl<T: Real> Sde<T, 3, 3> for Brownian<T> {
    type Instant = ();

    #[inline(always)]
    fn drift(&self, (): &(), u: &Vector<T, 3>) -> Vector<T, 3> {
        *u * self.growth
    }

    #[inline(always)]
    fn diffusion(&self, (): &(), u: &Vector<T, 3>) -> Matrix<T, 3, 3> {
        let mut diagonal = Matrix::zero();
        for i in 0..3 {
            diagonal[(i, i)] = u[i] * self.volatility;
        }
        diagonal
    }

    #[inline(always)]
    fn drift_and_noise(&self, at: &(), u: &Vector<T, 3>, dw: &Vector<T, 3>) -> (Vector<T, 3>, Vector<T, 3>) {
        let mut noise = *u * self.volatility;
        for i in 0..3 {
            noise[i] = noise[i] * dw[i];
        }
        (self.drift(at, u), noise)
    }
}

struct BrownianRuns<'a> {
    seed: u64,
    finals: &'a mut Finals,
}

impl Kernel for BrownianRuns<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Real>(self) {
        const STEPS: u64 = 256;
        let real = T::from_f64;
        const DT: f64 = 1.0 / STEPS as f64;
        let root = real(DT.sqrt());
        let motion = Brownian { growth: real(1.5), volatility: real(0.01) };
        for (group, finals) in self.finals.chunks_mut(T::LANES).enumerate() {
            let noise = Noise::<T>::process(self.seed, (group * T::LANES) as u64);
            let mut u = Vector::splat(real(0.1));
            for step in 0..STEPS {
                let dw = noise.normals::<3>(step) * root;
                u = sde::step(Scheme::EulerMaruyama, &motion, [&(); 3], &u, DT, &dw);
            }
            store(&u, finals);
        }
    }
}

struct Lorenz<T> {
    rayleigh: T,
}

impl<T: Real> Sde<T, 3, 0> for Lorenz<T> {
    type Instant = ();

    #[inline(always)]
    fn drift(&self, (): &(), u: &Vector<T, 3>) -> Vector<T, 3> {
        let real = T::from_f64;
        Vector([real(10.0) * (u[1] - u[0]), u[0] * (self.rayleigh - u[2]) - u[1], u[0] * u[1] - real(8.0 / 3.0) * u[2]])
    }

    #[inline(always)]
    fn diffusion(&self, (): &(), _u: &Vector<T, 3>) -> Matrix<T, 3, 0> {
        Matrix::zero()
    }
}

struct LorenzRuns<'a> {
    finals: &'a mut Finals,
}

impl Kernel for LorenzRuns<'_> {
    type Output = ();

    #[inline(always)]
    fn run<T: Real>(self) {
        const STEPS: u64 = 1000;
        const STEP: f64 = 1.0 / STEPS as f64;
        let last = (self.finals.len() - 1) as f64;
        for (group, finals) in self.finals.chunks_mut(T::LANES).enumerate() {
            let rayleigh = T::from_lanes(|lane| 21.0 * ((group * T::LANES + lane) as f64 / last));
            let mut u = Vector::from_f64([1.0, 0.0, 0.0]);
            for _ in 0..STEPS {
                u = sde::step(Scheme::RungeKutta4, &Lorenz { rayleigh }, [&(); 3], &u, STEP, &Vector([]));
            }
            store(&u, finals);
        }
    }
}

#[inline(always)]
fn store<T: Real>(u: &Vector<T, 3>, finals: &mut Finals) {
    for (lane, last) in finals.iter_mut().enumerate() {
        *last = u.0.map(|entry| entry.lane(lane));
    }
}

/// Runs in the widest lanes; `f32` if `single`.
fn run<K: Kernel<Output = ()>>(single: bool, kernel: K) {
    let width = Width::widest();
    let done = if single { lanes::run_single(width, kernel) } else { lanes::run(width, kernel) };
    done.unwrap();
}

/// # Safety
/// `finals` has space for three numbers of each run.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn brownian(single: bool, seed: u64, runs: usize, finals: *mut [f64; 3]) {
    let finals = unsafe { slice::from_raw_parts_mut(finals, runs) };
    run(single, BrownianRuns { seed, finals });
}

/// # Safety
/// `finals` has space for three numbers of each run.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn lorenz(single: bool, _seed: u64, runs: usize, finals: *mut [f64; 3]) {
    let finals = unsafe { slice::from_raw_parts_mut(finals, runs) };
    run(single, LorenzRuns { finals });
}
