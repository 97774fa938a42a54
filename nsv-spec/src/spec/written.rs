//! Values with their places, and what stands for those that could not be read.

use std::ops::Deref;

use crate::diagnostic::{Base, Span};
use crate::expr::{self, syntax::Expr};

/// A value with its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Located<T> {
    /// The value.
    pub value: T,
    /// Where it is written.
    pub span: Span,
}

/// In place of what is missing or of a wrong kind; that has been reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unreadable;

/// A value, if it could be read.
pub type Read<T> = Result<T, Unreadable>;

/// A name or a text for people.
pub type Word = Located<String>;

/// One of some words; `None` for what the language chooses.
pub type Choice<T> = Read<Option<Located<T>>>;

/// One expression, not yet parsed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Code {
    /// Its text.
    pub text: Read<String>,
    /// Where the text stands.
    pub base: Base,
}

impl Code {
    /// What stands for an expression that is missing at a place, or could not be read there.
    pub(crate) fn unreadable(span: Span) -> Self {
        Code {
            text: Err(Unreadable),
            base: Base::whole(span),
        }
    }

    /// The expression, if it can be read and parsed.
    pub(crate) fn parsed(&self) -> Option<Expr> {
        expr::parse(self.text.as_ref().ok()?, self.base.clone()).ok()
    }
}

/// An expression, or an array of them written as a YAML list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// One expression.
    Code(Code),
    /// A list.
    List(Vec<Formula>, Span),
}

impl Formula {
    /// Where it is written.
    pub fn span(&self) -> Span {
        match self {
            Formula::Code(code) => code.base.span,
            Formula::List(_, span) => *span,
        }
    }
}

/// A quantity, or the word `auto`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AutoCode {
    /// `auto`
    Auto(Span),
    /// A quantity.
    Code(Code),
}

/// A name with what is declared under it.
#[derive(Clone, Debug, PartialEq)]
pub struct Named<T> {
    /// The name.
    pub name: Word,
    /// Its declaration.
    pub value: T,
}

/// Everything that a map declares, in its order.
#[derive(Clone, Debug, PartialEq)]
pub struct Declared<T> {
    /// The declarations.
    pub all: Vec<Named<T>>,
    /// Whether there are no others: the map could be read.
    pub complete: bool,
    /// Its key, or what the key is missing in.
    pub span: Span,
}

impl<T> Deref for Declared<T> {
    type Target = [Named<T>];

    fn deref(&self) -> &[Named<T>] {
        &self.all
    }
}

impl<'a, T> IntoIterator for &'a Declared<T> {
    type Item = &'a Named<T>;
    type IntoIter = std::slice::Iter<'a, Named<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.all.iter()
    }
}
