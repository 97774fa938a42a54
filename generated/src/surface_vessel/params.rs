// SHA-256 of the text below: 8c714e9062be46647f8fc0557647558baa6a8637e7f2e6f81ef1df2806b60cbf
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `surface_vessel`: run-time parameters.
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
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0.
    /// Source: chosen.
    pub added_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed normally with mean 1.0 and standard deviation 0.15;
    /// controller 1.0. Source: chosen.
    pub damping_scale: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            added_scale: T::from_f64(1.0),
            damping_scale: T::from_f64(1.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            added_scale: T::from_f64(1.0),
            damping_scale: T::from_f64(1.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            added_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 0),
            damping_scale: T::from_f64(1.0) + T::from_f64(0.15) * noise.normal(0, 1),
        }
    }
}
