//! What names mean: the border between expressions and the specification around them.

use super::arena::{ConstantId, DefinitionId, ParameterId, PolynomialId, Type};
use crate::diagnostic::Span;
use crate::unit::Dimension;

/// Names that an expression may use.
pub trait Scope {
    /// The meaning of a name (dotted for polynomial data, `t` and `pi` included).
    fn resolve(&self, name: &str) -> Option<Symbol>;

    /// Every name that can be used here, for suggestions.
    fn names(&self) -> Vec<String>;

    /// Where a name is declared; `None` for those of the language.
    fn origin(&self, _name: &str) -> Option<Origin> {
        None
    }

    /// The derivative of polynomial data by its argument of that index, which is made if it is new.
    fn derivative(&mut self, polynomial: PolynomialId, argument: usize) -> PolynomialId;
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
#[derive(Clone, Debug, PartialEq, Eq)]
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
    /// Time since start.
    Time,
    /// The number pi.
    Pi,
    /// A named definition.
    Definition(DefinitionId, Type),
    /// Polynomial data, with the names of its arguments.
    Polynomial(PolynomialId, Vec<String>),
    /// A name that exists but must not be used here; the text says why and becomes the help: `the reference depends on time only`.
    Unavailable(String),
    /// A name whose declaration has a fault of its own, already reported: its uses are passed over in silence.
    Faulty,
}
