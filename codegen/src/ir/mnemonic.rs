//! The word of each function, operator, comparison and kernel in the textual form, for printing and reading.

use super::{Comparison, Function, Kernel, Operator};

/// Elementwise functions.
pub(crate) const FUNCTIONS: [(Function, &str); 15] = [
    (Function::Neg, "neg"),
    (Function::Abs, "abs"),
    (Function::Sign, "sign"),
    (Function::Sqrt, "sqrt"),
    (Function::Exp, "exp"),
    (Function::Ln, "ln"),
    (Function::Sin, "sin"),
    (Function::Cos, "cos"),
    (Function::Tan, "tan"),
    (Function::Asin, "asin"),
    (Function::Acos, "acos"),
    (Function::Atan, "atan"),
    (Function::Sinh, "sinh"),
    (Function::Cosh, "cosh"),
    (Function::Tanh, "tanh"),
];

/// Elementwise operators.
pub(crate) const OPERATORS: [(Operator, &str); 8] = [
    (Operator::Add, "add"),
    (Operator::Sub, "sub"),
    (Operator::Mul, "mul"),
    (Operator::Div, "div"),
    (Operator::Pow, "pow"),
    (Operator::Min, "min"),
    (Operator::Max, "max"),
    (Operator::Atan2, "atan2"),
];

/// Comparisons.
pub(crate) const COMPARISONS: [(Comparison, &str); 6] = [
    (Comparison::Lt, "lt"),
    (Comparison::Le, "le"),
    (Comparison::Gt, "gt"),
    (Comparison::Ge, "ge"),
    (Comparison::Eq, "eq"),
    (Comparison::Ne, "ne"),
];

/// Kernels.
pub(crate) const KERNELS: [(Kernel, &str); 5] = [
    (Kernel::SinCosOver, "sin_cos_over"),
    (Kernel::SinCosOverD1, "sin_cos_over_d1"),
    (Kernel::SinCosOverD2, "sin_cos_over_d2"),
    (Kernel::SinCosOverD3, "sin_cos_over_d3"),
    (Kernel::TanOver, "tan_over"),
];

/// The word of `item`.
pub(crate) fn word<T: Copy + PartialEq>(table: &[(T, &'static str)], item: T) -> &'static str {
    table
        .iter()
        .find(|(entry, _)| *entry == item)
        .expect("invariant: the table names every item")
        .1
}

/// The item of a word.
pub(crate) fn item<T: Copy>(table: &[(T, &'static str)], word: &str) -> Option<T> {
    table
        .iter()
        .find(|(_, entry)| *entry == word)
        .map(|&(item, _)| item)
}
