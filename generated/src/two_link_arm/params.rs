// SHA-256 of the text below: 221f5a6b2a9da8b705de83d4be584ee622d66f37b1496011889489f9a49764d7
// nsv 0.1.0: change the specification and run `nsv generate`, do not edit.

//! `two_link_arm`: run-time parameters.
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
    /// Unit: kg. Plant 2.0, dispersed uniformly between 1.5 and 2.5; controller 2.0. Source:
    /// Slotine and Li; the spread is chosen.
    pub m_e: T,
}

impl<T: Real> Params<T> {
    /// The plant's nominal values.
    #[inline(always)]
    pub fn plant() -> Self {
        Self { m_e: T::from_f64(2.0) }
    }

    /// The values that the controller is designed with.
    #[inline(always)]
    pub fn design() -> Self {
        Self { m_e: T::from_f64(2.0) }
    }

    /// The plant's values in each lane's run, drawn from the dispersions of the specification.
    #[inline(always)]
    pub fn dispersed(noise: &Noise<T>) -> Self {
        Self {
            m_e: T::from_f64(1.5) + T::from_f64(2.5 - 1.5) * noise.uniform(0, 0),
        }
    }
}
