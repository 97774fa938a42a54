//! One-step integrators for Ito equations `dx = f(t, x) dt + G(t, x) dw`.
//!
//! | scheme | strong order | for |
//! |---|---|---|
//! | [`Scheme::EulerMaruyama`] | 1/2; 1 if `G` does not depend on x | any noise |
//! | [`Scheme::Platen`] | 1 | diagonal or additive noise, see there |
//! | [`Scheme::RungeKutta4`] | 4, without noise | noise that is part of the drift |

use crate::linear::{Matrix, Vector};
use crate::real::Real;

/// An Ito equation with `N` states and `Q` Wiener processes.
pub trait Sde<T: Real, const N: usize, const Q: usize> {
    /// What `f` and `G` take of a time: the time itself in seconds, values that depend on it alone, or nothing.
    type Instant: Copy;
    /// Whether each column of `G` depends on `x`; as far as it is not known to, it does.
    const STATE_DEPENDENT: [bool; Q] = [true; Q];
    /// `f(t, x)`.
    fn drift(&self, at: &Self::Instant, x: &Vector<T, N>) -> Vector<T, N>;
    /// `G(t, x)`.
    fn diffusion(&self, at: &Self::Instant, x: &Vector<T, N>) -> Matrix<T, N, Q>;
    /// Column `j` of `G(t, x)`.
    #[inline(always)]
    fn diffusion_column(&self, at: &Self::Instant, x: &Vector<T, N>, j: usize) -> Vector<T, N> {
        self.diffusion(at, x).column(j)
    }
    /// `f(t, x)` and `G(t, x) dw`.
    #[inline(always)]
    fn drift_and_noise(
        &self,
        at: &Self::Instant,
        x: &Vector<T, N>,
        dw: &Vector<T, Q>,
    ) -> (Vector<T, N>, Vector<T, N>) {
        (self.drift(at, x), self.diffusion(at, x) * *dw)
    }
}

/// How a step is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// `(x + f dt) + G dw`.
    EulerMaruyama,
    /// Platen's derivative-free scheme of strong order 1 (Kloeden and Platen, 1992, (11.1.7)) with the diagonal of its double integrals,
    /// `I_jj = (dw_j^2 - dt) / 2`:
    ///
    /// `x' = ((x + f dt) + G dw) + r_1 + r_2 + ...`, `r_j = (g_j(t, (x + f dt) + g_j h) - g_j(t, x)) ((dw_j dw_j - dt) / (h + h))`,
    ///
    /// with `g_j` column j of `G` and `h = sqrt(dt)`; `r_j` is 0, and is left out, where [`Sde::STATE_DEPENDENT`] is false. Order 1 needs
    /// that no channel changes another's diffusion: the derivative of `g_j` along `g_i` is zero for i != j. So it is if each channel drives
    /// a state of its own and its column depends on no other noisy state (diagonal noise), or if no column depends on a state that noise
    /// drives (additive noise). Otherwise the order is 1/2.
    Platen,
    /// The classical Runge-Kutta scheme on the drift; `dw` is ignored. With `k_1..k_4` at `(t, x)`, `(t + dt/2, x + k_1 (dt/2))`,
    /// `(t + dt/2, x + k_2 (dt/2))`, `(t + dt, x + k_3 dt)`: `x' = x + (((k_1 + k_2 2) + k_3 2) + k_4) (dt/6)`.
    RungeKutta4,
}

/// The start, the middle and the end of a step of length `dt` from `t`, s.
#[inline(always)]
pub fn stages(t: f64, dt: f64) -> [f64; 3] {
    [t, t + dt / 2.0, t + dt]
}

/// The state after a step of length `dt` (s) from `x`, with the increments `dw` of the Wiener processes (variance `dt` each). `at` are the
/// [`stages`] of the step, of which only [`Scheme::RungeKutta4`] reads the last two.
#[inline(always)]
pub fn step<T: Real, S: Sde<T, N, Q>, const N: usize, const Q: usize>(
    scheme: Scheme,
    sde: &S,
    at: [&S::Instant; 3],
    x: &Vector<T, N>,
    dt: f64,
    dw: &Vector<T, Q>,
) -> Vector<T, N> {
    let [start, _, _] = at;
    match scheme {
        Scheme::EulerMaruyama => {
            let (drift, noise) = sde.drift_and_noise(start, x, dw);
            (*x + drift * T::from_f64(dt)) + noise
        }
        Scheme::Platen => platen(sde, start, x, dt, dw),
        Scheme::RungeKutta4 => runge_kutta4(sde, at, x, dt),
    }
}

#[inline(always)]
fn platen<T: Real, S: Sde<T, N, Q>, const N: usize, const Q: usize>(
    sde: &S,
    at: &S::Instant,
    x: &Vector<T, N>,
    dt: f64,
    dw: &Vector<T, Q>,
) -> Vector<T, N> {
    let (drift, noise) = sde.drift_and_noise(at, x, dw);
    let dt = T::from_f64(dt);
    let drifted = *x + drift * dt;
    let mut next = drifted + noise;
    if !S::STATE_DEPENDENT.contains(&true) {
        return next;
    }
    let diffusion = sde.diffusion(at, x);
    let h = dt.sqrt();
    for j in (0..Q).filter(|&j| S::STATE_DEPENDENT[j]) {
        let column = diffusion.column(j);
        let moved = sde.diffusion_column(at, &(drifted + column * h), j);
        next = next + (moved - column) * ((dw[j] * dw[j] - dt) / (h + h));
    }
    next
}

#[inline(always)]
fn runge_kutta4<T: Real, S: Sde<T, N, Q>, const N: usize, const Q: usize>(
    sde: &S,
    [start, middle, end]: [&S::Instant; 3],
    x: &Vector<T, N>,
    dt: f64,
) -> Vector<T, N> {
    let two = T::from_f64(2.0);
    let (whole, half) = (T::from_f64(dt), T::from_f64(dt / 2.0));
    let k1 = sde.drift(start, x);
    let k2 = sde.drift(middle, &(*x + k1 * half));
    let k3 = sde.drift(middle, &(*x + k2 * half));
    let k4 = sde.drift(end, &(*x + k3 * whole));
    *x + (((k1 + k2 * two) + k3 * two) + k4) * T::from_f64(dt / 6.0)
}
