//! Faults of a specification as data: a code, a place, a message and its remedy. Rendering is the command line's business.

mod base;
pub mod explain;
mod fix;
mod rule;
mod words;

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

pub use base::Base;
pub use fix::Fixed;
pub use rule::Rule;
pub(crate) use words::{a, counted, quoted, rounded};

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
    /// Whether it is a file on the disk, not a part of the command line.
    pub on_disk: bool,
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
    /// What kind of fault.
    pub rule: Rule,
    /// Error or warning.
    pub severity: Severity,
    /// The place; `None` only when no file could be read.
    pub span: Option<Span>,
    /// What is at the place, where that says more than the message.
    pub label: Option<String>,
    /// Lower case, no full stop, found and expected.
    pub message: String,
    /// How to mend it.
    pub help: Option<String>,
    /// A change of the text that mends it.
    pub suggestion: Option<Suggestion>,
    /// Other places that explain this one.
    pub related: Vec<Related>,
}

/// A change of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// What is replaced; empty for an insertion.
    pub span: Span,
    /// What is put there.
    pub replacement: String,
    /// Whether it may be applied unseen.
    pub applicability: Applicability,
}

/// How far a suggestion can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Applicability {
    /// There is one thing that can have been meant: `nsv check --fix` applies it.
    Certain,
    /// It may be what was meant; a person decides.
    Possible,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(rule: Rule, span: Span, message: impl Into<String>) -> Self {
        Self {
            rule,
            severity: Severity::Error,
            span: Some(span),
            message: message.into(),
            label: None,
            help: None,
            suggestion: None,
            related: Vec::new(),
        }
    }

    /// A warning at a place.
    pub fn warning(rule: Rule, span: Span, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Warning,
            ..Self::error(rule, span, message)
        }
    }

    /// The same with a remedy.
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same with words at its place.
    pub fn with_label(mut self, label: impl Into<String>) -> Self {
        self.label = Some(label.into());
        self
    }

    /// The same with a change that mends it; the help says what the change does.
    pub fn with_suggestion(
        mut self,
        span: Span,
        replacement: impl Into<String>,
        applicability: Applicability,
    ) -> Self {
        self.suggestion = Some(Suggestion {
            span,
            replacement: replacement.into(),
            applicability,
        });
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
        self.push(Source {
            name: name.into(),
            text,
            on_disk: true,
        })
    }

    /// Adds a text that is in no file.
    pub fn add_virtual(&mut self, name: impl Into<String>, text: Arc<str>) -> FileId {
        self.push(Source {
            name: name.into(),
            text,
            on_disk: false,
        })
    }

    fn push(&mut self, source: Source) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).expect("invariant: fewer than 2^32 files"));
        self.files.push(source);
        id
    }

    /// The names of the files on disk.
    pub fn on_disk(&self) -> impl Iterator<Item = &str> {
        let files = self.files.iter().filter(|file| file.on_disk);
        files.map(|file| file.name.as_str())
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

    /// Every fault as `file:line:col: error[E0102]: message`, with labels, related places, help and change indented below it.
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
                item.severity, item.rule, item.message
            ));
            if let Some(label) = &item.label {
                text.push_str(&format!("  here: {label}\n"));
            }
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
            if let Some(suggestion) = &item.suggestion {
                text.push_str(&self.short_suggestion(suggestion));
            }
        }
        text
    }
}

impl Diagnostics {
    /// ``  fix: specs/a.yaml:3:5: `substep` -> `substeps` ``, with `possible fix` where a person should decide.
    fn short_suggestion(&self, suggestion: &Suggestion) -> String {
        let Suggestion {
            span, replacement, ..
        } = suggestion;
        let (line, column) = self.sources.location(*span);
        let source = self.sources.source(span.file);
        let old = source.text.get(span.start as usize..span.end as usize);
        let noun = match suggestion.applicability {
            Applicability::Certain => "fix",
            Applicability::Possible => "possible fix",
        };
        let (name, old) = (&source.name, old.unwrap_or_default());
        let change = match old {
            "" => format!("insert `{replacement}`"),
            "\u{feff}" => "remove the mark".to_owned(),
            old if replacement.is_empty() => format!("remove `{old}`"),
            old => format!("`{old}` -> `{replacement}`"),
        };
        format!("  {noun}: {name}:{line}:{column}: {change}\n")
    }
}
