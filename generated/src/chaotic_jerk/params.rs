// SHA-256 of the text below: 9aecea69f56d8ad3b5511c20ada0408ac43712fc8767547063061a9519ec0ed7
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `chaotic_jerk`: run-time parameters.
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
    /// Unit: 1/s. Plant 0.44, dispersed normally with mean 0.44 and standard deviation 0.02;
    /// controller 0.44. Source: usual number; the spread is chosen.
    pub a: T,
    /// Unit: 1/s^2. Plant 1.1, dispersed normally with mean 1.1 and standard deviation 0.05;
    /// controller 1.1. Source: usual number; the spread is chosen.
    pub b: T,
    /// Unit: 1/s^3. Plant 1.0, dispersed normally with mean 1.0 and standard deviation 0.05;
    /// controller 1.0. Source: usual number; the spread is chosen.
    pub c: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            a: T::from_f64(0.44),
            b: T::from_f64(1.1),
            c: T::from_f64(1.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            a: T::from_f64(0.44),
            b: T::from_f64(1.1),
            c: T::from_f64(1.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            a: T::from_f64(0.44) + T::from_f64(0.02) * noise.normal(0, 0),
            b: T::from_f64(1.1) + T::from_f64(0.05) * noise.normal(0, 1),
            c: T::from_f64(1.0) + T::from_f64(0.05) * noise.normal(0, 2),
        }
    }
}
