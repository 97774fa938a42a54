//! What the operations are called in the runtime.

use crate::ir::{Comparison, Function, Kernel, Operator};

/// The method of a function.
pub(crate) fn function_name(function: Function, fused: bool) -> &'static str {
    match function {
        Function::Neg => "neg",
        Function::Abs => "abs",
        Function::Sign => "sign",
        Function::Sqrt => "sqrt",
        Function::Exp if fused => "exp_fused",
        Function::Exp => "exp",
        Function::Ln if fused => "ln_fused",
        Function::Ln => "ln",
        Function::Sin if fused => "sin_fused",
        Function::Sin => "sin",
        Function::Cos if fused => "cos_fused",
        Function::Cos => "cos",
        Function::Tan if fused => "tan_fused",
        Function::Tan => "tan",
        Function::Asin if fused => "asin_fused",
        Function::Asin => "asin",
        Function::Acos if fused => "acos_fused",
        Function::Acos => "acos",
        Function::Atan if fused => "atan_fused",
        Function::Atan => "atan",
        Function::Sinh if fused => "sinh_fused",
        Function::Sinh => "sinh",
        Function::Cosh if fused => "cosh_fused",
        Function::Cosh => "cosh",
        Function::Tanh if fused => "tanh_fused",
        Function::Tanh => "tanh",
    }
}

/// The method of an operator.
pub(crate) fn operator_name(operator: Operator, fused: bool) -> &'static str {
    match operator {
        Operator::Add => "add",
        Operator::Sub => "sub",
        Operator::Mul => "mul",
        Operator::Div => "div",
        Operator::Pow if fused => "pow_fused",
        Operator::Pow => "pow",
        Operator::Min => "min",
        Operator::Max => "max",
        Operator::Atan2 if fused => "atan2_fused",
        Operator::Atan2 => "atan2",
    }
}

/// The method of a comparison.
pub(crate) fn comparison_name(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Lt => "lt",
        Comparison::Le => "le",
        Comparison::Gt => "gt",
        Comparison::Ge => "ge",
        Comparison::Eq => "eq",
        Comparison::Ne => "ne",
    }
}

/// The function of a kernel.
pub(crate) fn kernel_name(kernel: Kernel) -> &'static str {
    match kernel {
        Kernel::SinCosOver => "sin_cos_over",
        Kernel::SinCosOverD1 => "sin_cos_over_d1",
        Kernel::SinCosOverD2 => "sin_cos_over_d2",
        Kernel::SinCosOverD3 => "sin_cos_over_d3",
        Kernel::TanOver => "tan_over",
    }
}
