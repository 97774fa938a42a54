// SHA-256 of the text below: ff9550b1775bc387c64e595b1e3ac51e3890b25df2b449b19b6cd7047675cec9
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `flexible_joint`: run-time parameters.
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
    /// Unit: kg*m^2/s^2. Plant 0.8, dispersed uniformly between 0.6 and 1.0; controller 0.8.
    /// Source: Ghorbel et al., M g L; the spread is chosen.
    pub weight: T,
    /// Unit: kg*m^2/s^2. Plant 31.0, dispersed uniformly between 28.0 and 34.0; controller 31.0.
    /// Source: Ghorbel et al., k; the spread is chosen.
    pub stiffness: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            weight: T::from_f64(0.8),
            stiffness: T::from_f64(31.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            weight: T::from_f64(0.8),
            stiffness: T::from_f64(31.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            weight: T::from_f64(0.6) + T::from_f64(1.0 - 0.6) * noise.uniform(0, 0),
            stiffness: T::from_f64(28.0) + T::from_f64(34.0 - 28.0) * noise.uniform(0, 1),
        }
    }
}
