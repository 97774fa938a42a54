//! Numeric types of nsv's generated code: scalars and SIMD lanes, with one set of elementary functions.
//!
//! Every function of [`real::Real`] gives the same bits in a scalar and in each lane of a vector, on every instruction set and with every
//! compiler flag: arithmetic is IEEE 754, fused by [`real::Real::mul_add`] alone, and elementary functions are sequences of such arithmetic without a
//! branch in lanes, written once for all types. [`lanes`] chooses the widest vectors of the processor at run time.

#![no_std]
#![deny(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

mod elementary;
pub mod entries;
mod fused;
pub mod lanes;
pub mod rare;
pub mod real;
mod scalar;
mod sqrt;
