//! What is done with each entry of an array, and the methods and operators of vectors and matrices that do it.

use crate::entries::{Each, Each2, Each3};
use crate::real::Real;

/// Functions of one number, by its method.
macro_rules! functions {
    ($($type:ident = $method:ident, long $long:literal;)*) => {$(
        #[derive(Clone, Copy)]
        pub(super) struct $type;

        impl Each for $type {
            const LONG: bool = $long;

            #[inline(always)]
            fn of<T: Real>(self, x: T) -> T {
                x.$method()
            }
        }
    )*};
}

functions! {
    Negative = neg, long false;
    Abs = abs, long false;
    Sqrt = sqrt, long true;
    Exp = exp, long true;
    Ln = ln, long true;
    Asin = asin, long true;
    Acos = acos, long true;
    Atan = atan, long true;
    Sinh = sinh, long true;
    Cosh = cosh, long true;
    Tanh = tanh, long true;
    Sign = sign, long false;
    ExpFused = exp_fused, long true;
    LnFused = ln_fused, long true;
    AsinFused = asin_fused, long true;
    AcosFused = acos_fused, long true;
    AtanFused = atan_fused, long true;
    SinhFused = sinh_fused, long true;
    CoshFused = cosh_fused, long true;
    TanhFused = tanh_fused, long true;
}

/// Functions of an angle, by their methods: for any angle, and for one that is not large.
macro_rules! angular {
    ($($type:ident = $method:ident, $usual:ident;)*) => {$(
        #[derive(Clone, Copy)]
        pub(super) struct $type;

        impl Each for $type {
            const LONG: bool = true;
            const BRANCHES: bool = true;

            #[inline(always)]
            fn of<T: Real>(self, x: T) -> T {
                x.$method()
            }

            #[inline(always)]
            fn is_rare<T: Real>(self, x: T) -> T::Mask {
                x.is_large_angle()
            }

            #[inline(always)]
            fn usual<T: Real>(self, x: T) -> T {
                x.$usual()
            }
        }
    )*};
}

angular! {
    Sin = sin, usual_sin;
    Cos = cos, usual_cos;
    Tan = tan, usual_tan;
    SinFused = sin_fused, usual_sin_fused;
    CosFused = cos_fused, usual_cos_fused;
    TanFused = tan_fused, usual_tan_fused;
}

/// An integer power.
#[derive(Clone, Copy)]
pub(super) struct PowerInt(pub(super) u32);

impl Each for PowerInt {
    #[inline(always)]
    fn of<T: Real>(self, x: T) -> T {
        x.powi(self.0)
    }
}

/// Functions of two numbers.
macro_rules! functions2 {
    ($($type:ident = |$x:ident, $y:ident| $value:expr;)*) => {$(
        #[derive(Clone, Copy)]
        pub(super) struct $type;

        impl Each2 for $type {
            #[inline(always)]
            fn of<T: Real>(self, $x: T, $y: T) -> T {
                $value
            }
        }
    )*};
}

functions2! {
    Plus = |x, y| x + y;
    Minus = |x, y| x - y;
    Mul = |x, y| x * y;
    Div = |x, y| x / y;
    Min = |x, y| x.min(y);
    Max = |x, y| x.max(y);
    Atan2 = |x, y| x.atan2(y);
    Pow = |x, y| x.pow(y);
    Atan2Fused = |x, y| x.atan2_fused(y);
    PowFused = |x, y| x.pow_fused(y);
}

/// Functions of three numbers.
macro_rules! functions3 {
    ($($type:ident = |$x:ident, $y:ident, $z:ident| $value:expr;)*) => {$(
        #[derive(Clone, Copy)]
        pub(super) struct $type;

        impl Each3 for $type {
            #[inline(always)]
            fn of<T: Real>(self, $x: T, $y: T, $z: T) -> T {
                $value
            }
        }
    )*};
}

functions3! {
    MulAdd = |x, y, z| x.mul_add(y, z);
    AddProduct = |x, y, z| y.mul_add(z, x);
}

/// Methods that apply a function to each entry, or to the entries at each place. The type has `each`, `each2` and `splat`.
macro_rules! methods {
    ($($(#[$doc:meta])* $name:ident = $function:ident;)*; $($(#[$doc2:meta])* $name2:ident = $function2:ident;)*) => {
        $(
            $(#[$doc])*
            #[inline(always)]
            pub fn $name(self) -> Self {
                self.each(super::elementwise::$function)
            }
        )*
        $(
            $(#[$doc2])*
            #[inline(always)]
            pub fn $name2(self, other: Self) -> Self {
                self.each2(super::elementwise::$function2, &other)
            }
        )*
    };
}

/// What vectors and matrices have in common.
macro_rules! elementwise {
    () => {
        super::elementwise::methods! {
            /// Absolute value of each entry.
            abs = Abs;
            /// Square root of each entry.
            sqrt = Sqrt;
            /// e^x of each entry.
            exp = Exp;
            /// Natural logarithm of each entry.
            ln = Ln;
            /// Sine of each entry, rad.
            sin = Sin;
            /// Cosine of each entry, rad.
            cos = Cos;
            /// Tangent of each entry, rad.
            tan = Tan;
            /// Inverse sine of each entry, rad.
            asin = Asin;
            /// Inverse cosine of each entry, rad.
            acos = Acos;
            /// Inverse tangent of each entry, rad.
            atan = Atan;
            /// Hyperbolic sine of each entry.
            sinh = Sinh;
            /// Hyperbolic cosine of each entry.
            cosh = Cosh;
            /// Hyperbolic tangent of each entry.
            tanh = Tanh;
            /// Sign of each entry.
            sign = Sign;
            /// [`Self::exp`], whose products are fused with sums.
            exp_fused = ExpFused;
            /// [`Self::ln`], whose products are fused with sums.
            ln_fused = LnFused;
            /// [`Self::sin`], whose products are fused with sums.
            sin_fused = SinFused;
            /// [`Self::cos`], whose products are fused with sums.
            cos_fused = CosFused;
            /// [`Self::tan`], whose products are fused with sums.
            tan_fused = TanFused;
            /// [`Self::asin`], whose products are fused with sums.
            asin_fused = AsinFused;
            /// [`Self::acos`], whose products are fused with sums.
            acos_fused = AcosFused;
            /// [`Self::atan`], whose products are fused with sums.
            atan_fused = AtanFused;
            /// [`Self::sinh`], whose products are fused with sums.
            sinh_fused = SinhFused;
            /// [`Self::cosh`], whose products are fused with sums.
            cosh_fused = CoshFused;
            /// [`Self::tanh`], whose products are fused with sums.
            tanh_fused = TanhFused;
            ;
            /// Elementwise product `a_i b_i`.
            hadamard = Mul;
            /// Elementwise quotient `a_i / b_i`.
            quotient = Div;
            /// Elementwise minimum.
            min = Min;
            /// Elementwise maximum.
            max = Max;
            /// Elementwise angle of the point (x = `other`, y = `self`), rad.
            atan2 = Atan2;
            /// Elementwise power.
            pow = Pow;
            /// [`Self::atan2`], whose products are fused with sums.
            atan2_fused = Atan2Fused;
            /// [`Self::pow`], whose products are fused with sums.
            pow_fused = PowFused;
        }

        /// `a_i^n` by binary powering.
        #[inline(always)]
        pub fn powi(self, n: u32) -> Self {
            self.each(super::elementwise::PowerInt(n))
        }

        /// `a_i s`.
        #[inline(always)]
        pub fn scale(self, factor: T) -> Self {
            self.hadamard(Self::splat(factor))
        }

        /// `a_i b_i + c_i`, rounded once.
        #[inline(always)]
        pub fn mul_add(self, factor: Self, term: Self) -> Self {
            self.each3(super::elementwise::MulAdd, &factor, &term)
        }

        /// `a_i s + c_i`, rounded once.
        #[inline(always)]
        pub fn scale_add(self, factor: T, term: Self) -> Self {
            self.mul_add(Self::splat(factor), term)
        }

        /// `a_i + s`.
        #[inline(always)]
        pub fn add_scalar(self, term: T) -> Self {
            self + Self::splat(term)
        }

        /// Zeros.
        #[inline(always)]
        pub fn zero() -> Self {
            Self::splat(T::zero())
        }
    };
}

/// Operators of vectors and matrices.
macro_rules! operators {
    ($type:ty, $(const $size:ident: usize),*) => {
        impl<T: Real, $(const $size: usize),*> core::ops::Add for $type {
            type Output = Self;

            #[inline(always)]
            fn add(self, other: Self) -> Self {
                self.each2(super::elementwise::Plus, &other)
            }
        }

        impl<T: Real, $(const $size: usize),*> core::ops::Sub for $type {
            type Output = Self;

            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                self.each2(super::elementwise::Minus, &other)
            }
        }

        impl<T: Real, $(const $size: usize),*> core::ops::Neg for $type {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                self.each(super::elementwise::Negative)
            }
        }

        impl<T: Real, $(const $size: usize),*> core::ops::Mul<T> for $type {
            type Output = Self;

            #[inline(always)]
            fn mul(self, factor: T) -> Self {
                self.scale(factor)
            }
        }

        impl<T: Real, $(const $size: usize),*> core::ops::Div<T> for $type {
            type Output = Self;

            /// A division for each entry.
            #[inline(always)]
            fn div(self, divisor: T) -> Self {
                self.quotient(Self::splat(divisor))
            }
        }
    };
}

pub(super) use {elementwise, methods, operators};
