//! Scalar definitions: elementary functions, operators, comparisons, integer powers.

use nsv_math::real::Real;

use crate::ir::{Comparison, Function, Operator};

/// A function of one real, in a fused program by fused arithmetic.
pub(super) fn function(function: Function, x: f64, fused: bool) -> f64 {
    match function {
        Function::Neg => -x,
        Function::Abs => x.abs(),
        Function::Sign => sign(x),
        Function::Sqrt => Real::sqrt(x),
        Function::Exp if fused => Real::exp_fused(x),
        Function::Exp => Real::exp(x),
        Function::Ln if fused => Real::ln_fused(x),
        Function::Ln => Real::ln(x),
        Function::Sin if fused => Real::sin_fused(x),
        Function::Sin => Real::sin(x),
        Function::Cos if fused => Real::cos_fused(x),
        Function::Cos => Real::cos(x),
        Function::Tan if fused => Real::tan_fused(x),
        Function::Tan => Real::tan(x),
        Function::Asin if fused => Real::asin_fused(x),
        Function::Asin => Real::asin(x),
        Function::Acos if fused => Real::acos_fused(x),
        Function::Acos => Real::acos(x),
        Function::Atan if fused => Real::atan_fused(x),
        Function::Atan => Real::atan(x),
        Function::Sinh if fused => Real::sinh_fused(x),
        Function::Sinh => Real::sinh(x),
        Function::Cosh if fused => Real::cosh_fused(x),
        Function::Cosh => Real::cosh(x),
        Function::Tanh if fused => Real::tanh_fused(x),
        Function::Tanh => Real::tanh(x),
    }
}

/// 1, -1, or the argument itself where it is a zero or NaN.
fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// An operator. `min` and `max` give the second operand unless the first is strictly smaller or larger.
pub(super) fn operator(operator: Operator, a: f64, b: f64, fused: bool) -> f64 {
    match operator {
        Operator::Add => a + b,
        Operator::Sub => a - b,
        Operator::Mul => a * b,
        Operator::Div => a / b,
        Operator::Pow if fused => Real::pow_fused(a, b),
        Operator::Pow => Real::pow(a, b),
        Operator::Min => {
            if a < b {
                a
            } else {
                b
            }
        }
        Operator::Max => {
            if a > b {
                a
            } else {
                b
            }
        }
        Operator::Atan2 if fused => Real::atan2_fused(a, b),
        Operator::Atan2 => Real::atan2(a, b),
    }
}

/// A comparison by IEEE 754: only `ne` holds with NaN.
pub(crate) fn comparison(comparison: Comparison, a: f64, b: f64) -> bool {
    match comparison {
        Comparison::Lt => a < b,
        Comparison::Le => a <= b,
        Comparison::Gt => a > b,
        Comparison::Ge => a >= b,
        Comparison::Eq => a == b,
        Comparison::Ne => a != b,
    }
}

/// x^n by left-to-right binary powering: r = x; for each lower bit of n from the top r = r*r, then r = r*x if the bit is set.
pub(super) fn power(x: f64, n: u32) -> f64 {
    let Some(highest) = n.checked_ilog2() else {
        return 1.0;
    };
    (0..highest).rev().fold(x, |r, bit| {
        let square = r * r;
        if n >> bit & 1 == 1 {
            square * x
        } else {
            square
        }
    })
}
