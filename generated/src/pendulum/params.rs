// SHA-256 of the text below: aa5cb081fee09033e8f886fea0a4582b8cfcc2a9ee728ef265b4ba889070e653
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.
// specification sha256 1a4dc31c8b8f80dd213e6bd36beee0e688e8525cc62b205874fb23a2869e509d

//! `pendulum`: run-time parameters.
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
    /// Unit: kg. Plant 1.0, dispersed uniformly between 0.8 and 1.2; controller 1.0. Source: drake
    /// pendulum example; the spread is chosen.
    pub mass: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self { mass: T::from_f64(1.0) }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self { mass: T::from_f64(1.0) }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            mass: T::from_f64(0.8) + T::from_f64(1.2 - 0.8) * noise.uniform(0, 0),
        }
    }
}
