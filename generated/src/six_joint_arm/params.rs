// SHA-256 of the text below: 7a045a473439e82233d16b4c9f309e2f9cd20279a08aa304e0d3df7d825292db
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `six_joint_arm`: run-time parameters.
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
    /// Unit: kg. Plant 1.0, dispersed uniformly between 0.0 and 2.0; controller 1.0. Source:
    /// chosen, at the wrist.
    pub load: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.5 and 1.5; controller 0.0.
    /// Source: chosen.
    pub dry_scale: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            load: T::from_f64(1.0),
            dry_scale: T::from_f64(1.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            load: T::from_f64(1.0),
            dry_scale: T::from_f64(0.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            load: T::from_f64(0.0) + T::from_f64(2.0 - 0.0) * noise.uniform(0, 0),
            dry_scale: T::from_f64(0.5) + T::from_f64(1.5 - 0.5) * noise.uniform(0, 1),
        }
    }
}
