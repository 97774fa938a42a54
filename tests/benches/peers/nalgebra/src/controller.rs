//! The controller (13)-(68) of both blocks, sampled.

use nalgebra::{matrix, vector};

use crate::adaptive::{barrier, basis, bound, reference};
use crate::vehicle::{INERTIA, Scales, dynamics};
use crate::{DT, Pair, Vector3, Weights};

const DEGREE: f64 = std::f64::consts::PI / 180.0;
const LIMIT: Vector3 = vector![2e6, 2e7, 2e7];
const IOTA: f64 = 0.1;
const LEAK: f64 = 0.1;
/// `(1 - exp(-a dt))/a` for the linear decay a of each state.
const STEP_WEIGHTS: f64 = 0.001999800013332667;
const STEP_ZETA1: f64 = 0.0019605280423838395;
const STEP_ZETA2: f64 = 0.0019032516392808085;
const STEP_FILTER: f64 = 0.00198013266932447;

type Matrix2 = nalgebra::Matrix2<f64>;

/// The exosystem observer of one channel: `L`, column of `S`, `M - S L`, and the integral of its exponential over a sample.
struct Channel {
    l: Pair,
    s: Pair,
    closed: Matrix2,
    step: Matrix2,
}

const CHANNELS: [Channel; 3] = [
    Channel {
        l: vector![0.0, 2.0],
        s: vector![-1.5, 1.5],
        closed: matrix![0.0, 6.0; -3.0, -3.0],
        step: matrix![0.0019999760360430705, 1.1975964129556617e-5; -5.9879820647783075e-6, 0.0019939880539782922],
    },
    Channel {
        l: vector![3.0, 0.0],
        s: vector![1.5, 1.0],
        closed: matrix![-4.5, 3.0; -6.0, 0.0],
        step: matrix![0.0019910030471541806, 5.982004556604176e-6; -1.1964009113208353e-5, 0.0019999760539890867],
    },
    Channel {
        l: vector![1.0, 1.0],
        s: vector![-2.0, 4.0],
        closed: matrix![2.0, 5.0; -7.0, -4.0],
        step: matrix![0.0020039586722187678, 9.986590133519995e-6; -1.3981226186927993e-5, 0.0019919747640585435],
    },
];

/// The controller's states.
#[derive(Clone, Copy)]
pub struct State {
    pub zeta1: Vector3,
    pub zeta2: Vector3,
    pub w1: Weights,
    pub th1: Vector3,
    pub h1: Vector3,
    pub w2: Weights,
    pub th2: [Pair; 3],
    pub eps2: f64,
    pub sigma2: f64,
    pub phi2: f64,
}

/// Saturated control and next states.
#[inline]
pub fn step(t: f64, x1: &Vector3, x2: &Vector3, state: &State, scales: &Scales) -> (Vector3, State) {
    let State { zeta1, zeta2, th1, h1, th2, eps2, sigma2, phi2, .. } = *state;
    let vehicle = dynamics(x1, x2, scales);
    let (y_r, y_r_dot) = reference(t);
    let k = bound(t);

    // Attitude.
    let e1 = x1 - y_r - zeta1;
    let b1 = barrier(&e1, k * DEGREE, 1.5, 2.0);
    let p1 = basis(x1);
    let known1 = vehicle.f1 + state.w1.tr_mul(&p1) * IOTA;
    let d_hat1 = th1 + x1 * 10.0;
    let gain_norm2 = vehicle.g1.norm_squared();
    let lam1 = b1.lam0 + b1.c * (0.5 + 0.5 * gain_norm2);
    let bracket1 = known1 - y_r_dot + zeta1 * 20.0 + d_hat1 + lam1;
    // G_1^-1 from its structure: det G_1 = -1/cos(beta)
    let alpha1 = -vehicle.g1.try_inverse().unwrap_or_default() * bracket1;
    let h1_dot = (alpha1 - h1) * 10.0;

    // Rates.
    let e2 = x2 - h1 - zeta2;
    let b2 = barrier(&e2, k, 2.0, 2.0);
    let p2 = basis(x2);
    let known2 = vehicle.f2 + state.w2.tr_mul(&p2) * IOTA;
    let w_hat: [Pair; 3] = std::array::from_fn(|j| th2[j] + CHANNELS[j].s * e2[j]);
    let d_hat2 = Vector3::from_fn(|j, _| CHANNELS[j].l.dot(&w_hat[j]));
    let (s2, s2_squared) = (b2.s, b2.s * b2.s);
    let noise_norm2 = vehicle.h2.norm_squared();
    let noise_gain = noise_norm2 * b2.ybar_norm();
    let sh_norm2: f64 = (0..3).map(|j| CHANNELS[j].s.norm_squared() * vehicle.h2.row(j).norm_squared()).sum();
    let psi = 0.5 * noise_gain * noise_gain + 2.0 * 6.0 + 0.1 * sh_norm2 * sh_norm2;
    let tanh = (e2 * 0.5).map(f64::tanh);
    let root = (s2_squared + 1.0).sqrt();
    let damping = psi / (phi2 * phi2 + s2_squared);
    let coupling = gain_norm2 * b1.c.norm_squared();
    let direct = 0.5 / b2.cos2 + 0.25 * b2.cos2 * coupling * coupling + noise_gain * sigma2 / root + damping * b2.cos2;
    let lam2 = b2.lam0 + b2.c * (15.0 / 0.2) + e2 * direct + tanh * eps2;
    let rest2 = known2 - h1_dot + zeta2 * 50.0;
    let bracket2 = rest2 + d_hat2 + lam2;
    let u = -bracket2.component_mul(&INERTIA);
    let u_sat = u.sup(&-LIMIT).inf(&LIMIT);

    // States of the next sample.
    let zeta1_dot = vehicle.g1 * zeta2 - zeta1 * 20.0;
    let zeta2_dot = (u_sat - u).component_div(&INERTIA) - zeta2 * 50.0;
    let th1_dot = -(known1 + d_hat1 + vehicle.g1 * x2) * 10.0;
    let effect = rest2 - bracket2;
    let eps2_dot = 0.1 * (s2 / b2.cos2 * e2.dot(&tanh) - eps2);
    let sigma2_dot = noise_gain * s2_squared / (b2.cos2 * root) - LEAK * sigma2;
    let decayed = if s2.sqrt() >= 0.01 { phi2 * (-DT * (damping + 2.0)).exp() } else { phi2 };
    let next = State {
        zeta1: zeta1 + zeta1_dot * STEP_ZETA1,
        zeta2: zeta2 + zeta2_dot * STEP_ZETA2,
        w1: updated(&state.w1, &p1, &b1.c),
        th1: th1 + th1_dot * STEP_FILTER,
        h1: h1 + h1_dot * STEP_FILTER,
        w2: updated(&state.w2, &p2, &b2.c),
        th2: std::array::from_fn(|j| th2[j] + CHANNELS[j].step * (CHANNELS[j].closed * w_hat[j] - CHANNELS[j].s * effect[j])),
        eps2: eps2 + eps2_dot * STEP_WEIGHTS,
        sigma2: sigma2 + sigma2_dot * STEP_WEIGHTS,
        phi2: decayed.max((psi * DT / 0.1).sqrt()),
    };
    (u_sat, next)
}

/// `W + dt (P c iota - lambda W)` (65)
#[inline]
fn updated(w: &Weights, p: &crate::Basis, c: &Vector3) -> Weights {
    let mut next = w * (1.0 - STEP_WEIGHTS * LEAK);
    next.ger(STEP_WEIGHTS * IOTA, p, c, 1.0);
    next
}
