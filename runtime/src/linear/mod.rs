//! Small dense vectors and matrices of fixed size, on the stack.
//!
//! Reductions run left to right, starting from the first product: `((a0 b0 + a1 b1) + a2 b2) + ...`, without a leading zero. Elementwise
//! operations are one operation per entry.
//!
//! Everything is inlined into its caller, which may be compiled for an instruction set that this crate is not. So entries are visited by
//! plain loops: closures and the functions of `core` that take them might be left outside.

/// Functions of each entry, by the method of the same name of the number type.
macro_rules! elementwise {
    ($($(#[$doc:meta])* $name:ident($($argument:ident: $type:ty),*);)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $name(self, $($argument: $type),*) -> Self {
            let mut result = self;
            for entry in result.entries_mut() {
                *entry = entry.$name($($argument),*);
            }
            result
        }
    )*};
}

/// Functions of the entries at each place, by the method or operator of the number type.
macro_rules! pairwise {
    ($($(#[$doc:meta])* $name:ident = $method:ident;)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        pub fn $name(self, other: Self) -> Self {
            let mut result = self;
            for (entry, &other) in result.entries_mut().iter_mut().zip(other.entries()) {
                *entry = entry.$method(other);
            }
            result
        }
    )*};
}

/// What vectors and matrices have in common: functions of their entries.
macro_rules! entries {
    () => {
        elementwise! {
            /// Absolute value of each entry.
            abs();
            /// Square root of each entry.
            sqrt();
            /// e^x of each entry.
            exp();
            /// Natural logarithm of each entry.
            ln();
            /// Sine of each entry, rad.
            sin();
            /// Cosine of each entry, rad.
            cos();
            /// Tangent of each entry, rad.
            tan();
            /// Inverse sine of each entry, rad.
            asin();
            /// Inverse cosine of each entry, rad.
            acos();
            /// Inverse tangent of each entry, rad.
            atan();
            /// Hyperbolic sine of each entry.
            sinh();
            /// Hyperbolic cosine of each entry.
            cosh();
            /// Hyperbolic tangent of each entry.
            tanh();
            /// Sign of each entry.
            sign();
            /// Integer power of each entry.
            powi(n: u32);
        }

        pairwise! {
            /// Elementwise product `a_i b_i`.
            hadamard = mul;
            /// Elementwise quotient `a_i / b_i`.
            quotient = div;
            /// Elementwise minimum.
            min = min;
            /// Elementwise maximum.
            max = max;
            /// Elementwise angle of the point (x = `other`, y = `self`), rad.
            atan2 = atan2;
            /// Elementwise power.
            pow = pow;
            /// Elementwise sum.
            plus = add;
            /// Elementwise difference.
            minus = sub;
        }

        /// `a_i s`.
        #[inline(always)]
        pub fn scale(self, factor: T) -> Self {
            self.hadamard(Self::splat(factor))
        }

        /// `a_i + s`.
        #[inline(always)]
        pub fn add_scalar(self, term: T) -> Self {
            self.plus(Self::splat(term))
        }

        /// Zeros.
        #[inline(always)]
        pub fn zero() -> Self {
            Self::splat(T::zero())
        }

        /// `a` where the mask is true, else `b`.
        #[inline(always)]
        pub fn select(mask: T::Mask, a: Self, b: Self) -> Self {
            let mut result = a;
            for (entry, &b) in result.entries_mut().iter_mut().zip(b.entries()) {
                *entry = T::select(mask, *entry, b);
            }
            result
        }

        /// `f` of each entry.
        #[inline(always)]
        pub fn map(self, f: impl Fn(T) -> T) -> Self {
            let mut result = self;
            for entry in result.entries_mut() {
                *entry = f(*entry);
            }
            result
        }

        /// Whether every entry is finite.
        #[inline(always)]
        pub fn is_finite(&self) -> T::Mask {
            all_finite(self.entries())
        }

        /// `a_0 a_0 + a_1 a_1 + ...`, left to right.
        #[inline(always)]
        pub fn sum_squares(self) -> T {
            dot(self.entries(), self.entries())
        }
    };
}

/// Operators of vectors and matrices.
macro_rules! operators {
    ($type:ty, $(const $size:ident: usize),*) => {
        impl<T: Real, $(const $size: usize),*> Add for $type {
            type Output = Self;

            #[inline(always)]
            fn add(self, other: Self) -> Self {
                self.plus(other)
            }
        }

        impl<T: Real, $(const $size: usize),*> Sub for $type {
            type Output = Self;

            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                self.minus(other)
            }
        }

        impl<T: Real, $(const $size: usize),*> Neg for $type {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                let mut result = self;
                for entry in result.entries_mut() {
                    *entry = -*entry;
                }
                result
            }
        }

        impl<T: Real, $(const $size: usize),*> Mul<T> for $type {
            type Output = Self;

            #[inline(always)]
            fn mul(self, factor: T) -> Self {
                self.scale(factor)
            }
        }

        impl<T: Real, $(const $size: usize),*> Div<T> for $type {
            type Output = Self;

            /// A division for each entry.
            #[inline(always)]
            fn div(self, divisor: T) -> Self {
                self.quotient(Self::splat(divisor))
            }
        }
    };
}

mod elimination;
mod matrix;
mod singular;
mod vector;

pub use matrix::Matrix;
pub use vector::Vector;

use crate::real::Real;

/// `a_0 b_0 + a_1 b_1 + ...`, left to right; 0 without entries.
#[inline(always)]
fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    if a.is_empty() {
        return T::zero();
    }
    let mut sum = a[0] * b[0];
    for i in 1..a.len() {
        sum = sum + a[i] * b[i];
    }
    sum
}

/// Whether every number is finite. `x - x` is 0 for a finite number and NaN else; four sums at a time do not wait for each other.
#[expect(clippy::eq_op, reason = "x - x is not 0 for every x")]
#[inline(always)]
fn all_finite<T: Real>(numbers: &[T]) -> T::Mask {
    let mut sums = [T::zero(); 4];
    for (i, &x) in numbers.iter().enumerate() {
        sums[i % 4] = sums[i % 4] + (x - x);
    }
    ((sums[0] + sums[1]) + (sums[2] + sums[3])).eq(T::zero())
}
