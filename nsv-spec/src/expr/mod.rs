//! Expressions: text to tokens, tokens to a syntax tree with spans, syntax tree to typed nodes in a hash-consed arena.
//!
//! ```text
//! text -- parse --> syntax::Expr -- elaborate (names from a Scope) --> ExprId in an arena::Arena -- evaluate --> numbers
//! ```

pub mod arena;
mod builtin;
mod elaborate;
mod evaluate;
mod expect;
mod lexer;
mod parser;
mod scope;
pub mod syntax;
mod typing;

pub use crate::diagnostic::Base;
pub use builtin::is_reserved;
pub(crate) use builtin::{CONSTANTS, Entry, entries};
pub(crate) use elaborate::MAX_CALLS;
pub use elaborate::elaborate;
pub(crate) use elaborate::with_origins;
pub use evaluate::{Environment, EvaluationError, evaluate};
pub use expect::{Expected, expect};
pub use parser::{MAX_DEPTH, MAX_INSERTED, MAX_NODES, MAX_ROUNDS, MAX_TEXT, parse};
pub(crate) use parser::{MAX_FAULTS, binding};
pub use scope::{Defined, Origin, Scope, Signature, Symbol};
pub(crate) use typing::{BY_MATRIX, MAX_UNKNOWNS, shown};

#[cfg(test)]
mod tests;
