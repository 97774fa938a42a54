//! Faults of a specification as data: a code, a place, a message and its remedy. Rendering is the command line's business.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;
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

/// Where a piece of text, such as an expression in a YAML scalar, stands in its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Base {
    /// The whole text.
    pub span: Span,
    /// Whether the file holds the text byte for byte from the start of `span`; a quoted scalar with escapes or a folded one
    /// does not, and everything in it is then reported at the whole span.
    pub exact: bool,
}

impl Base {
    /// A text of `length` bytes that the file holds verbatim from byte `start`.
    pub fn exact(file: FileId, start: u32, length: usize) -> Self {
        let end = start.saturating_add(u32::try_from(length).unwrap_or(u32::MAX));
        Self {
            span: Span { file, start, end },
            exact: true,
        }
    }

    /// A text that the file holds in some encoded form within `span`.
    pub fn whole(span: Span) -> Self {
        Self { span, exact: false }
    }

    /// The place in the file of a byte range of the text.
    pub fn span_of(&self, range: Range<usize>) -> Span {
        if !self.exact {
            return self.span;
        }
        let place = |offset: usize| {
            let offset = u32::try_from(offset).unwrap_or(u32::MAX);
            self.span.start.saturating_add(offset).min(self.span.end)
        };
        Span {
            file: self.span.file,
            start: place(range.start),
            end: place(range.end),
        }
    }
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
    /// Data files by the place that names them.
    pub(crate) data: BTreeMap<Span, FileId>,
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

impl Diagnostic {
    /// An error at a place.
    pub fn error(code: &'static str, span: Span, message: impl Into<String>) -> Self {
        Self {
            code,
            severity: Severity::Error,
            span: Some(span),
            message: message.into(),
            help: None,
            related: Vec::new(),
        }
    }

    /// A warning at a place.
    pub fn warning(code: &'static str, span: Span, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Warning,
            ..Self::error(code, span, message)
        }
    }

    /// The same with a remedy.
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same with a further place.
    pub fn with_related(mut self, span: Span, label: impl Into<String>) -> Self {
        self.related.push(Related {
            span,
            label: label.into(),
        });
        self
    }
}

/// Every fault found in one run, with the sources they point into.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    /// The files.
    pub sources: SourceMap,
    /// The faults, in order of place.
    pub items: Vec<Diagnostic>,
}

impl SourceMap {
    /// Adds a file.
    pub fn add(&mut self, name: impl Into<String>, text: Arc<str>) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).expect("invariant: fewer than 2^32 files"));
        self.files.push(Source {
            name: name.into(),
            text,
        });
        id
    }

    /// The file of a span.
    pub fn source(&self, file: FileId) -> &Source {
        &self.files[file.0 as usize]
    }

    /// Line and column of the first character of a span, both from 1, the column in characters.
    pub fn location(&self, span: Span) -> (usize, usize) {
        let before = &self.source(span.file).text.as_bytes()[..span.start as usize];
        let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
        let line_start = before
            .iter()
            .rposition(|&byte| byte == b'\n')
            .map_or(0, |newline| newline + 1);
        // Continuation bytes of UTF-8 start no character.
        let column = before[line_start..]
            .iter()
            .filter(|&&byte| byte & 0xc0 != 0x80)
            .count()
            + 1;
        (line, column)
    }
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
        })
    }
}

impl Diagnostics {
    /// Whether any of them rejects the specification.
    pub fn has_errors(&self) -> bool {
        self.items
            .iter()
            .any(|item| item.severity == Severity::Error)
    }

    /// Every fault as `file:line:col: error[E0102]: message`, related places and help indented below it.
    pub fn short(&self) -> String {
        let place = |span: Span| {
            let (line, column) = self.sources.location(span);
            format!("{}:{line}:{column}: ", self.sources.source(span.file).name)
        };
        let mut text = String::new();
        for item in &self.items {
            let at = item.span.map(place).unwrap_or_default();
            text.push_str(&format!(
                "{at}{}[{}]: {}\n",
                item.severity, item.code, item.message
            ));
            for related in &item.related {
                text.push_str(&format!(
                    "  {}note: {}\n",
                    place(related.span),
                    related.label
                ));
            }
            if let Some(help) = &item.help {
                text.push_str(&format!("  help: {help}\n"));
            }
        }
        text
    }
}

/// A piece of source text between backquotes for a message, cut after 48 characters.
pub(crate) fn quoted(text: &str) -> String {
    match text.char_indices().nth(48) {
        Some((cut, _)) => format!("`{}..`", &text[..cut]),
        None => format!("`{text}`"),
    }
}
