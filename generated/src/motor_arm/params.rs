// SHA-256 of the text below: c710960aa2b424f2009eaa3bafb89f8d6dcec6ad260f5b1d25245ea94c0e0e1e
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 9b566d21e10b4a5e1287aa6d56b2ef282dc67247857e73edb28387ed4150de95

//! `motor_arm`: run-time parameters.
#![allow(non_snake_case, reason = "names are those of the equations")]
#![allow(clippy::too_many_arguments, reason = "as in the equations")]
#![allow(clippy::approx_constant, reason = "numbers are as specified")]
#![allow(clippy::eq_op, reason = "x - x is not 0 for every x")]

use nsv_runtime::noise::Noise;
use nsv_runtime::real::Real;

/// Run-time parameters, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Params<T> {
    /// Unit: kg. Plant 0.434, dispersed uniformly between 0.35 and 0.52; controller 0.434. Source:
    /// Dawson et al.; the spread is chosen.
    pub load_mass: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            load_mass: T::from_f64(0.434),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            load_mass: T::from_f64(0.434),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            load_mass: T::from_f64(0.35) + T::from_f64(0.52 - 0.35) * noise.uniform(0, 0),
        }
    }
}
