// SHA-256 of the text below: 75fe1cf968baa65259be71f1bd6d5f4331c6c05bbe6fddddd37749581f77b3ef
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `underwater_vehicle`: run-time parameters.
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
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.7 and 1.3; controller 1.0.
    /// Source: chosen.
    pub drag_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.7 and 1.3; controller 1.0.
    /// Source: chosen.
    pub torque_scale: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            added_scale: T::from_f64(1.0),
            drag_scale: T::from_f64(1.0),
            torque_scale: T::from_f64(1.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            added_scale: T::from_f64(1.0),
            drag_scale: T::from_f64(1.0),
            torque_scale: T::from_f64(1.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            added_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 0),
            drag_scale: T::from_f64(0.7) + T::from_f64(1.3 - 0.7) * noise.uniform(0, 1),
            torque_scale: T::from_f64(0.7) + T::from_f64(1.3 - 0.7) * noise.uniform(0, 2),
        }
    }
}
