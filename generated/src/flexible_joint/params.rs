// SHA-256 of the text below: be272572cb43de6ade80d423293c730e0af48d10a23b8d71d0322cf28c6271cd
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 4291bb3902fdc079d1e752f7589df333a1602f816fcc1424487d9d6fe0aaca25

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
