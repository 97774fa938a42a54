//! The true plant, its disturbances, and one Euler-Maruyama step.

use nalgebra::vector;

use crate::vehicle::{INERTIA, Scales, dynamics};
use crate::{DT, Pair, Vector3};

/// Amplitude of the shaking control surfaces, degrees.
const SHAKE: f64 = 0.05;

/// Attitude, rates and the exosystem of each moment.
#[derive(Clone, Copy)]
pub struct PlantState {
    pub attitude: Vector3,
    pub rates: Vector3,
    pub exosystems: [Pair; 3],
}

/// Increments of the noise.
#[derive(Clone, Copy)]
pub struct Noise {
    pub surfaces: Vector3,
    pub exosystems: [Pair; 3],
}

/// The state after one step.
#[inline]
pub fn step(t: f64, x: &PlantState, u_sat: &Vector3, scales: &Scales, noise: &Noise) -> PlantState {
    let vehicle = dynamics(&x.attitude, &x.rates, scales);
    let decay = 0.02 * (-0.1 * t).exp();
    let (fast, slow) = ((2.0 * t).sin() * decay, t.sin() * decay);
    let [w1, w2, w3] = x.exosystems;
    let d2 = vector![2.0 * w1.y, 3.0 * w2.x, w3.x + w3.y];
    let attitude_rate = vehicle.f1 + vehicle.g1 * x.rates + vector![fast, slow, fast];
    let acceleration = vehicle.f2 + u_sat.component_div(&INERTIA) + d2;
    PlantState {
        attitude: x.attitude + attitude_rate * DT,
        rates: x.rates + acceleration * DT + vehicle.h2 * noise.surfaces * SHAKE,
        exosystems: std::array::from_fn(|j| {
            let w = x.exosystems[j];
            w + vector![w.y, -w.x] * (3.0 * DT) + noise.exosystems[j]
        }),
    }
}
