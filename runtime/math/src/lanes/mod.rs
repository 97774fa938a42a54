//! Lanes of numbers that advance together, and the choice of the widest ones at run time.
//!
//! A [`Kernel`] is written once over [`Real`]. [`run`] calls it with the lanes of a [`Width`], inside a function that is compiled for the
//! instruction set of those lanes. For this to be fast everything between the kernel and the arithmetic must be inlined there, so it is
//! `#[inline(always)]`, and no closure with two calls, which may stay a function of its own; a part that should be one goes through
//! [`Real::outlined`]. The lane types cannot be named outside, so no value of a type exists on a processor that lacks its instructions.

mod portable;
#[cfg(target_arch = "x86_64")]
#[expect(
    unsafe_code,
    reason = "vector intrinsics; sound because lanes exist only behind `run`"
)]
pub(crate) mod x86;

use core::marker::PhantomData;

use crate::real::{Part, Real};

/// Work that is done in lanes of `f64`, or of `f32` by [`run_single`].
pub trait Kernel {
    /// What it gives.
    type Output;
    /// The widths that it is compiled for, the scalar one among them: fewer for work that takes the compiler long.
    const WIDTHS: &'static [Width] = &Width::ALL;
    /// The work; `#[inline(always)]` in every implementation.
    fn run<T: Real>(self) -> Self::Output;
}

/// Size of a vector register.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Width {
    /// One number: scalar arithmetic.
    Scalar,
    /// 128 bits: SSE2 on x86-64, where every processor has it; pairs of scalars elsewhere.
    Bits128,
    /// 256 bits: AVX2 and FMA.
    Bits256,
    /// 512 bits: AVX-512 F and DQ.
    Bits512,
}

impl Width {
    /// All widths, narrowest first.
    pub const ALL: [Width; 4] = [
        Width::Scalar,
        Width::Bits128,
        Width::Bits256,
        Width::Bits512,
    ];

    /// Lanes of `f64`.
    pub const fn lanes(self) -> usize {
        match self {
            Width::Scalar => 1,
            Width::Bits128 => 2,
            Width::Bits256 => 4,
            Width::Bits512 => 8,
        }
    }

    /// Whether this processor has it. Without the feature `std`, what the program is compiled for.
    pub fn is_available(self) -> bool {
        match self {
            Width::Scalar | Width::Bits128 => true,
            Width::Bits256 => has_avx2(),
            Width::Bits512 => has_avx512(),
        }
    }

    /// The widest that this processor has.
    pub fn widest() -> Width {
        Self::widest_of(&Self::ALL)
    }

    /// The widest of some, narrowest first, that this processor has; scalar if it has none of them.
    pub fn widest_of(widths: &[Width]) -> Width {
        let mut widest_first = widths.iter().rev().copied();
        let available = widest_first.find(|width| width.is_available());
        available.unwrap_or(Width::Scalar)
    }
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
fn has_avx512() -> bool {
    std::arch::is_x86_feature_detected!("avx512f")
        && std::arch::is_x86_feature_detected!("avx512dq")
}

#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
const fn has_avx2() -> bool {
    cfg!(all(target_feature = "avx2", target_feature = "fma"))
}

#[cfg(not(all(target_arch = "x86_64", feature = "std")))]
const fn has_avx512() -> bool {
    cfg!(all(target_feature = "avx512f", target_feature = "avx512dq"))
}

/// A kernel in lanes of a type.
struct InLanes<T, K>(K, PhantomData<T>);

impl<T: Real, K: Kernel> Part for InLanes<T, K> {
    type Output = K::Output;

    #[inline(always)]
    fn run(self) -> K::Output {
        self.0.run::<T>()
    }
}

#[inline(always)]
fn in_lanes<T: Real, K: Kernel>(kernel: K) -> K::Output {
    T::outlined(InLanes::<T, K>(kernel, PhantomData))
}

/// Whether a width is among some, for the compiler to leave out what is not.
const fn contains(widths: &[Width], width: Width) -> bool {
    let mut i = 0;
    while i < widths.len() {
        if widths[i] as u8 == width as u8 {
            return true;
        }
        i += 1;
    }
    false
}

/// Runs a kernel in lanes of `f64`; `None` if the processor lacks the width, or the kernel is not compiled for it.
#[inline]
pub fn run<K: Kernel>(width: Width, kernel: K) -> Option<K::Output> {
    if !width.is_available() {
        return None;
    }
    Some(match width {
        Width::Scalar if const { contains(K::WIDTHS, Width::Scalar) } => in_lanes::<f64, K>(kernel),
        #[cfg(target_arch = "x86_64")]
        Width::Bits128 if const { contains(K::WIDTHS, Width::Bits128) } => {
            in_lanes::<x86::F64x2, K>(kernel)
        }
        #[cfg(target_arch = "x86_64")]
        Width::Bits256 if const { contains(K::WIDTHS, Width::Bits256) } => {
            in_lanes::<x86::F64x4, K>(kernel)
        }
        #[cfg(target_arch = "x86_64")]
        Width::Bits512 if const { contains(K::WIDTHS, Width::Bits512) } => {
            in_lanes::<x86::F64x8, K>(kernel)
        }
        #[cfg(not(target_arch = "x86_64"))]
        Width::Bits128 if const { contains(K::WIDTHS, Width::Bits128) } => {
            in_lanes::<portable::F64x2, K>(kernel)
        }
        _ => return None,
    })
}

/// Runs a kernel in lanes of `f32`, twice as many; `None` if the processor lacks the width.
#[inline]
pub fn run_single<K: Kernel>(width: Width, kernel: K) -> Option<K::Output> {
    if !width.is_available() {
        return None;
    }
    Some(match width {
        Width::Scalar => in_lanes::<f32, K>(kernel),
        #[cfg(target_arch = "x86_64")]
        Width::Bits128 => in_lanes::<x86::F32x4, K>(kernel),
        #[cfg(target_arch = "x86_64")]
        Width::Bits256 => in_lanes::<x86::F32x8, K>(kernel),
        #[cfg(target_arch = "x86_64")]
        Width::Bits512 => in_lanes::<x86::F32x16, K>(kernel),
        #[cfg(not(target_arch = "x86_64"))]
        _ => in_lanes::<portable::F32x4, K>(kernel),
    })
}

/// Runs a kernel in pairs of `f64` that use no vector instruction: what other processors than x86-64 do, for tests on any of them.
#[inline]
pub fn run_portable<K: Kernel>(kernel: K) -> K::Output {
    in_lanes::<portable::F64x2, K>(kernel)
}

/// Runs a kernel in lanes of `f32` that use no vector instruction, as [`run_portable`].
#[inline]
pub fn run_portable_single<K: Kernel>(kernel: K) -> K::Output {
    in_lanes::<portable::F32x4, K>(kernel)
}
