//! What names mean: the border between expressions and the specification around them.

use std::sync::Arc;

use super::arena::{ConstantId, DefinitionId, ExprId, ParameterId, PolynomialId, TableId, Type};
use super::syntax::Expr;
use crate::diagnostic::Span;
use crate::unit::Dimension;

/// Names that an expression may use.
pub trait Scope {
    /// The meaning of a name (dotted for polynomial data, `t` included).
    fn resolve(&self, name: &str) -> Option<Symbol>;

    /// Every name that can be used here, for suggestions.
    fn names(&self) -> Vec<String>;

    /// Where a name is declared; `None` for those of the language.
    fn origin(&self, _name: &str) -> Option<Origin> {
        None
    }

    /// The derivative of polynomial data by its argument of that index, which is made if it is new.
    fn derivative(&mut self, polynomial: PolynomialId, argument: usize) -> PolynomialId;

    /// Takes so many operations from what calls and rounds of `each` may insert into the whole specification; false if there are
    /// not so many left.
    fn insert(&mut self, operations: usize) -> bool;
}

/// A function that stands for an expression of its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Defined {
    /// Its name.
    pub name: String,
    /// Names of its arguments.
    pub arguments: Vec<String>,
    /// What a call stands for.
    pub body: Expr,
}

/// What a lookup table takes and gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// Names and dimensions of the arguments.
    pub arguments: Vec<(String, Dimension)>,
    /// Dimension of the value.
    pub value: Dimension,
}

/// The declaration of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Where it is.
    pub span: Span,
    /// What it is: `constant`, `state` and so on.
    pub noun: &'static str,
    /// The names that it is defined by.
    pub uses: Vec<String>,
}

/// Meaning of a name.
#[derive(Clone, Debug, PartialEq)]
pub enum Symbol {
    /// A compile-time constant.
    Constant(ConstantId, Type),
    /// A run-time parameter.
    Parameter(ParameterId, Type),
    /// A state channel, with 0-based indices.
    State {
        /// Block.
        block: usize,
        /// Channel.
        channel: usize,
        /// Dimension.
        dimension: Dimension,
    },
    /// A further state of the flown plant, 0-based.
    Truth(usize, Dimension),
    /// A control input, 0-based.
    Input(usize, Dimension),
    /// Time since start.
    Time,
    /// A constant of the language, in SI.
    Number(f64, Dimension),
    /// A value bound to a name: an argument in the body of its function.
    Value(ExprId),
    /// What a loop has counted to: a number that may also be an index.
    Counter(u32),
    /// A function of the specification.
    Function(Arc<Defined>),
    /// A named definition.
    Definition(DefinitionId, Type),
    /// Polynomial data, with the names of its arguments.
    Polynomial(PolynomialId, Vec<String>),
    /// A lookup table.
    Table(TableId, Arc<Signature>),
    /// A name that exists but must not be used here; the text says why and becomes the help: `the reference depends on time only`.
    Unavailable(String),
    /// A name whose declaration has a fault of its own, already reported: its uses are passed over in silence.
    Faulty,
}
