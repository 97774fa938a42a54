//! The functions and constants of the language: the one table that the elaborator, suggestions, the JSON Schema and the
//! reference page are made from.

mod atmosphere;
mod constants;
mod functions;

use crate::suggest::Meant;
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

use super::arena::{Function, Operator};
use super::parser::parse;
use super::scope::Defined;
use crate::diagnostic::{Base, FileId, Span};
use atmosphere::ATMOSPHERE;
pub(crate) use constants::{CONSTANTS, StandardConstant};
use functions::FUNCTIONS;

/// A function of the language.
#[derive(Debug)]
pub(crate) struct Entry {
    /// Its name.
    pub(crate) name: &'static str,
    /// Names of its arguments.
    pub(crate) arguments: &'static [&'static str],
    /// What it is.
    pub(crate) meaning: &'static str,
    /// Shapes and units of arguments and result.
    pub(crate) rule: &'static str,
    /// An expression that uses it.
    pub(crate) example: &'static str,
    /// How it is made.
    pub(super) builtin: Builtin,
}

impl Entry {
    /// `clamp(x, low, high)`
    pub(crate) fn signature(&self) -> String {
        format!("{}({})", self.name, self.arguments.join(", "))
    }

    /// What the function stands for, if it is defined in the language itself.
    pub(crate) fn definition(&self) -> Option<&'static str> {
        match self.builtin {
            Builtin::Defined { body, .. } => Some(body),
            _ => None,
        }
    }
}

/// What a function name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Builtin {
    /// Elementwise function.
    Apply(Function),
    /// Elementwise function of two arguments of one dimension.
    Binary(Operator),
    /// All entries joined by an operator, in order.
    Fold(Operator),
    /// The operator `^` as a function.
    Pow,
    /// `if(condition, a, b)`
    If,
    Dot,
    Cross,
    Solve,
    Inverse,
    Norm,
    Transpose,
    Diagonal,
    /// A form of the grammar, which the parser knows.
    Form,
    /// Another expression of the language.
    Defined {
        /// That expression.
        body: &'static str,
        /// Unit of the first argument, a scalar, where only one is right.
        unit: Option<&'static str>,
    },
}

/// Every function, in the order of the reference page.
pub(crate) fn entries() -> impl Iterator<Item = &'static Entry> {
    FUNCTIONS.iter().chain(ATMOSPHERE)
}

/// The function of that name.
pub(super) fn find(name: &str) -> Option<&'static Entry> {
    entries().find(|entry| entry.name == name && entry.builtin != Builtin::Form)
}

/// The constant of that name.
pub(super) fn constant(name: &str) -> Option<&'static StandardConstant> {
    CONSTANTS.iter().find(|constant| constant.name == name)
}

/// Arguments and parsed body of a function that is defined in the language itself.
pub(super) fn defined(name: &str) -> Option<Arc<Defined>> {
    static BODIES: LazyLock<BTreeMap<&'static str, Arc<Defined>>> = LazyLock::new(|| {
        let bodies = entries().filter_map(|entry| Some((entry.name, body(entry)?)));
        bodies.collect()
    });
    BODIES.get(name).cloned()
}

fn body(entry: &Entry) -> Option<Arc<Defined>> {
    // Faults in such a body are shown at its call, so that no place in it is ever looked up.
    let nowhere = Base::whole(Span {
        file: FileId(u32::MAX),
        start: 0,
        end: 0,
    });
    let body = parse(entry.definition()?, nowhere).expect("invariant: definitions are well formed");
    Some(Arc::new(Defined {
        name: entry.name.to_owned(),
        arguments: entry
            .arguments
            .iter()
            .map(|&name| name.to_owned())
            .collect(),
        body,
    }))
}

/// Whether `name` has a meaning of its own in expressions, so that nothing can be declared under it.
pub fn is_reserved(name: &str) -> bool {
    let group = |known: &str| {
        known
            .split_once('.')
            .is_some_and(|(group, _)| group == name)
    };
    let mut functions = entries().map(|entry| entry.name);
    let mut constants = CONSTANTS.iter().map(|constant| constant.name);
    matches!(name, "t" | "and" | "or" | "not")
        || functions.any(|known| known == name || group(known))
        || constants.any(|known| known == name || group(known))
}

/// Names of all functions.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    entries().map(|entry| entry.name)
}

/// What other languages call the functions of this one.
const ELSEWHERE: &[(&str, &str)] = &[
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("fabs", "abs"),
    ("inv", "inverse"),
    ("linsolve", "solve"),
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
