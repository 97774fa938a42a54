// SHA-256 of the text below: 780062afd8ba9e69cb4ac47cdcd643aded420965554b55a9a081da8ad027e6fd
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 f70c25e1cbb23d7ad870996c7841812cb5fb39433bd2cc647b3a6463e631db02

//! `active_suspension`: run-time parameters.
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
    /// Unit: kg. Plant 300.0, dispersed uniformly between 270.0 and 380.0; controller 320.0.
    /// Source: MathWorks, mb; the spread is chosen.
    pub body_mass: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self {
            body_mass: T::from_f64(300.0),
        }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self {
            body_mass: T::from_f64(320.0),
        }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            body_mass: T::from_f64(270.0)
                + T::from_f64(380.0 - 270.0) * noise.uniform(0, 0),
        }
    }
}
