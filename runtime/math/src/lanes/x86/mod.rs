//! Vector registers of x86-64: SSE2, AVX2 and AVX-512.
//!
//! Every intrinsic here is one instruction, or a bitwise one, of the set that the type's `outlined` enables. A value of a type exists only
//! where [`super::run`] has found the set, which makes the calls sound; they become instructions once inlined there.

#![allow(
    unused_unsafe,
    reason = "the intrinsics of SSE2 are safe on x86-64, the others are not"
)]

mod bits;
mod choice;
mod mask;
mod number;

use core::arch::x86_64::*;

pub use number::{F32x4, F32x8, F32x16, F64x2, F64x4, F64x8};

/// Square root of a scalar as one instruction.
#[inline(always)]
pub(crate) fn sqrt_f64(x: f64) -> f64 {
    unsafe { _mm_cvtsd_f64(_mm_sqrt_pd(_mm_set_sd(x))) }
}

/// Square root of a scalar as one instruction.
#[inline(always)]
pub(crate) fn sqrt_f32(x: f32) -> f32 {
    unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
}
