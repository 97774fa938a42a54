// SHA-256 of the text below: fe0c81001e56f8e44d8b694c0c9d9e5fb7fcd4137862dce5d02cf498e09d5835
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `missile_pitch`: run-time parameters.
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
    /// Unit: dimensionless. Plant 1.0, dispersed normally with mean 1.0 and standard deviation 0.1,
    /// cut off at 0.75 and 1.25; controller 1.0. Source: chosen.
    pub CN_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed normally with mean 1.0 and standard deviation 0.1,
    /// cut off at 0.75 and 1.25; controller 1.0. Source: chosen.
    pub CM_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.85 and 1.15; controller 1.0.
    /// Source: chosen.
    pub fin_scale: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            CN_scale: T::from_f64(1.0),
            CM_scale: T::from_f64(1.0),
            fin_scale: T::from_f64(1.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            CN_scale: T::from_f64(1.0),
            CM_scale: T::from_f64(1.0),
            fin_scale: T::from_f64(1.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            CN_scale: (T::from_f64(1.0)
                + T::from_f64(0.1)
                    * noise
                        .normal_between(0, 0, 0.006209665325776133, 0.9937903346742238))
                .max(T::from_f64(0.75))
                .min(T::from_f64(1.25)),
            CM_scale: (T::from_f64(1.0)
                + T::from_f64(0.1)
                    * noise
                        .normal_between(0, 1, 0.006209665325776133, 0.9937903346742238))
                .max(T::from_f64(0.75))
                .min(T::from_f64(1.25)),
            fin_scale: T::from_f64(0.85) + T::from_f64(1.15 - 0.85) * noise.uniform(0, 2),
        }
    }
}
