// SHA-256 of the text below: 718c9bbaf40d694100475b339c409c75bd6a03f6864d2d3e76544f516fe940d7
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `nsv_six_dof`: run-time parameters.
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
    /// Source: paper, section 5.
    pub CL_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0.
    /// Source: paper, section 5.
    pub CD_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0.
    /// Source: paper, section 5.
    pub CY_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0.
    /// Source: paper, section 5.
    pub Cl_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0.
    /// Source: paper, section 5.
    pub Cm_scale: T,
    /// Unit: dimensionless. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0.
    /// Source: paper, section 5.
    pub Cn_scale: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            CL_scale: T::from_f64(1.0),
            CD_scale: T::from_f64(1.0),
            CY_scale: T::from_f64(1.0),
            Cl_scale: T::from_f64(1.0),
            Cm_scale: T::from_f64(1.0),
            Cn_scale: T::from_f64(1.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            CL_scale: T::from_f64(1.0),
            CD_scale: T::from_f64(1.0),
            CY_scale: T::from_f64(1.0),
            Cl_scale: T::from_f64(1.0),
            Cm_scale: T::from_f64(1.0),
            Cn_scale: T::from_f64(1.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            CL_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 0),
            CD_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 1),
            CY_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 2),
            Cl_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 3),
            Cm_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 4),
            Cn_scale: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 5),
        }
    }
}
