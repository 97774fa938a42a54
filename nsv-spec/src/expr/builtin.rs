//! The functions of the language.

use super::arena::{Function, Operator};
use crate::suggest::Meant;

/// What a function name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Builtin {
    /// Elementwise function.
    Apply(Function),
    /// Elementwise function of two arguments of one dimension.
    Binary(Operator),
    /// The operator `^` as a function.
    Pow,
    /// `if(condition, a, b)`
    If,
    Dot,
    Cross,
    Norm,
    Transpose,
}

const TABLE: &[(&str, Builtin)] = &[
    ("abs", Builtin::Apply(Function::Abs)),
    ("sign", Builtin::Apply(Function::Sign)),
    ("sqrt", Builtin::Apply(Function::Sqrt)),
    ("exp", Builtin::Apply(Function::Exp)),
    ("ln", Builtin::Apply(Function::Ln)),
    ("sin", Builtin::Apply(Function::Sin)),
    ("cos", Builtin::Apply(Function::Cos)),
    ("tan", Builtin::Apply(Function::Tan)),
    ("asin", Builtin::Apply(Function::Asin)),
    ("acos", Builtin::Apply(Function::Acos)),
    ("atan", Builtin::Apply(Function::Atan)),
    ("sinh", Builtin::Apply(Function::Sinh)),
    ("cosh", Builtin::Apply(Function::Cosh)),
    ("tanh", Builtin::Apply(Function::Tanh)),
    ("atan2", Builtin::Binary(Operator::Atan2)),
    ("min", Builtin::Binary(Operator::Min)),
    ("max", Builtin::Binary(Operator::Max)),
    ("pow", Builtin::Pow),
    ("if", Builtin::If),
    ("dot", Builtin::Dot),
    ("cross", Builtin::Cross),
    ("norm", Builtin::Norm),
    ("transpose", Builtin::Transpose),
];

impl Builtin {
    /// Number of arguments.
    pub(super) fn arity(self) -> usize {
        match self {
            Builtin::Apply(_) | Builtin::Norm | Builtin::Transpose => 1,
            Builtin::Binary(_) | Builtin::Pow | Builtin::Dot | Builtin::Cross => 2,
            Builtin::If => 3,
        }
    }
}

/// The function of that name.
pub(super) fn find(name: &str) -> Option<Builtin> {
    TABLE
        .iter()
        .find(|(known, _)| *known == name)
        .map(|(_, builtin)| *builtin)
}

/// Whether `name` has a meaning of its own in expressions, so that nothing can be declared under it.
pub fn is_reserved(name: &str) -> bool {
    matches!(name, "t" | "pi" | "and" | "or" | "not" | "partial") || find(name).is_some()
}

/// Names of all functions.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().map(|(name, _)| *name).chain(["partial"])
}

/// What other languages call the functions of this one.
const ELSEWHERE: &[(&str, &str)] = &[
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("fabs", "abs"),
    ("log", "ln"),
    ("power", "pow"),
    ("signum", "sign"),
    ("sgn", "sign"),
];

/// The function that goes by another name elsewhere.
pub(super) fn elsewhere(name: &str) -> Option<Meant> {
    let (_, native) = ELSEWHERE.iter().find(|(foreign, _)| *foreign == name)?;
    Some(Meant {
        name: (*native).to_owned(),
        sure: true,
    })
}
