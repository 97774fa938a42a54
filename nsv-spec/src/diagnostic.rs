//! Faults of a specification as data: a code, a place, a message and its remedy. Rendering is the command line's business.

use std::sync::Arc;

/// Index of a file in a [`SourceMap`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileId(pub u32);

/// A byte range of one source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The file.
    pub file: FileId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

/// One source file: its name as the user would type it, and its text.
#[derive(Clone, Debug)]
pub struct Source {
    /// Path as given on the command line or in `include`.
    pub name: String,
    /// Whole text.
    pub text: Arc<str>,
}

/// All files that make up one specification, in order of reading; the specification itself is first.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    /// The files.
    pub files: Vec<Source>,
}

/// How bad a diagnostic is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The specification is rejected.
    Error,
    /// The specification is accepted, but something looks wrong.
    Warning,
}

/// A labelled place beside the primary one, such as the first definition of a name that is defined twice.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// The place.
    pub span: Span,
    /// What is there.
    pub label: String,
}

/// One fault: what is wrong, where, and how to mend it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Stable code, such as `E0102`.
    pub code: &'static str,
    /// Error or warning.
    pub severity: Severity,
    /// The place; `None` only when no file could be read.
    pub span: Option<Span>,
    /// Lower case, no full stop, found and expected.
    pub message: String,
    /// How to mend it.
    pub help: Option<String>,
    /// Other places that explain this one.
    pub related: Vec<Related>,
}

/// Every fault found in one run, with the sources they point into.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    /// The files.
    pub sources: SourceMap,
    /// The faults, in order of place.
    pub items: Vec<Diagnostic>,
}
