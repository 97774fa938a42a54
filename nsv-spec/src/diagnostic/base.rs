//! Where a text stands in its file.

use std::ops::Range;
use std::sync::Arc;

use super::{FileId, Span};

/// Where a piece of text, such as an expression in a YAML scalar, stands in its file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Base {
    /// The whole text.
    pub span: Span,
    places: Places,
}

/// How bytes of the text and of the file belong together.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Places {
    /// The file holds the text byte for byte.
    Verbatim,
    /// Bytes of the text, in order, with the bytes of the file that they stand for, both from the start: between two such
    /// places the file holds the text byte for byte.
    Escaped(Arc<[(u32, u32)]>),
    /// Nobody knows; everything is reported at the whole span.
    Unknown,
}

impl Base {
    /// A text of `length` bytes that the file holds verbatim from byte `start`.
    pub fn exact(file: FileId, start: u32, length: usize) -> Self {
        let end = start.saturating_add(u32::try_from(length).unwrap_or(u32::MAX));
        Self::verbatim(Span { file, start, end })
    }

    /// A text that the file holds verbatim at `span`.
    pub fn verbatim(span: Span) -> Self {
        Self {
            span,
            places: Places::Verbatim,
        }
    }

    /// A text that the file holds within `span` with escapes: `places` are bytes of the text after which something else than
    /// that byte follows in the file, each with its byte there.
    pub fn escaped(span: Span, places: Arc<[(u32, u32)]>) -> Self {
        Self {
            span,
            places: Places::Escaped(places),
        }
    }

    /// A text that the file holds in some encoded form within `span`.
    pub fn whole(span: Span) -> Self {
        Self {
            span,
            places: Places::Unknown,
        }
    }

    /// The place in the file of a byte range of the text.
    pub fn span_of(&self, range: Range<usize>) -> Span {
        if self.places == Places::Unknown {
            return self.span;
        }
        let place = |offset: usize| {
            let offset = self.offset(u32::try_from(offset).unwrap_or(u32::MAX));
            self.span.start.saturating_add(offset).min(self.span.end)
        };
        Span {
            file: self.span.file,
            start: place(range.start),
            end: place(range.end),
        }
    }

    /// Whether a byte range of the text stands in the file as it is, so that it may be replaced there.
    pub fn holds(&self, range: Range<usize>) -> bool {
        let Span { start, end, .. } = self.span_of(range.clone());
        self.places != Places::Unknown && (end - start) as usize == range.len()
    }

    /// Bytes from the start of the span to the one that stands for byte `at` of the text.
    fn offset(&self, at: u32) -> u32 {
        let Places::Escaped(places) = &self.places else {
            return at;
        };
        let next = places.partition_point(|(text, _)| *text <= at);
        match next.checked_sub(1).map(|before| places[before]) {
            Some((text, file)) => file.saturating_add(at - text),
            None => at,
        }
    }
}
