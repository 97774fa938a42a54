//! YAML text as a tree in which every key and every scalar knows its bytes in the file.
//!
//! All dealings with the YAML library are in `read`; the rest of the crate sees this tree only.

mod escape;
mod fault;
mod flow;
mod format;
mod read;
mod text;

pub use format::{Unformatted, format};
pub use read::read;
pub(crate) use read::{MAX_ALIASES, MAX_DEPTH, MAX_NODES};
pub use text::{MAX_BYTES, text};

use crate::diagnostic::{Base, Span, counted};

/// A value in a YAML file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// What it is.
    pub kind: Kind,
    /// Its bytes: for a scalar its content, for a map or list from its first to its last part.
    pub span: Span,
}

/// The kinds of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing, `~` or `null`.
    Null,
    /// Keys with values in order of the file; duplicates are still there.
    Map(Vec<Entry>),
    /// A list.
    Seq(Vec<Node>),
    /// Text, number or truth value, as written.
    Scalar(Scalar),
}

/// One key with its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The key.
    pub key: Key,
    /// The value.
    pub value: Node,
}

/// The key of a map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Key {
    /// Its text.
    pub text: String,
    /// Its bytes.
    pub span: Span,
}

/// A scalar.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scalar {
    /// The text for people: quotes, escapes, folding and indentation removed.
    pub text: String,
    /// The text for the expression parser: line breaks and indentation as in the file, escapes decoded.
    pub code: String,
    /// Where that text stands.
    pub base: Base,
    /// Whether it was in quotes: text even if it looks like a number.
    pub quoted: bool,
}

impl Node {
    /// The kind in words, for messages.
    pub fn describe(&self) -> String {
        match &self.kind {
            Kind::Null => "nothing".into(),
            Kind::Map(_) => "a map".into(),
            Kind::Seq(items) if items.is_empty() => "an empty list".into(),
            Kind::Seq(items) => format!("a list of {}", counted(items.len(), "item")),
            Kind::Scalar(scalar) => format!("`{}`", excerpt(&scalar.text)),
        }
    }
}

/// The beginning of a text on one line, short enough to stand in a message.
pub fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    let clean: String = text
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    if clean.chars().count() <= LONGEST {
        return clean;
    }
    let head: String = clean.chars().take(LONGEST - 3).collect();
    format!("{head}...")
}
