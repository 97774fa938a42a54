//! Reads YAML with `serde-saphyr`: text to a tree, within limits that no honest file comes near.

use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde_saphyr::options::{DuplicateKeyPolicy, MergeKeyPolicy, NonFiniteFloatPolicy};
use serde_saphyr::{Location, Options, Spanned};

use super::escape;
use super::fault;
use super::{Entry, Key, Kind, Node, Scalar};
use crate::diagnostic::{Base, Diagnostic, FileId, Span};

/// Deepest nesting; a specification needs eight levels.
pub(crate) const MAX_DEPTH: usize = 32;
/// Most maps, lists and scalars in one file, aliases expanded.
pub(crate) const MAX_NODES: usize = 100_000;
/// Most aliases in one file.
pub(crate) const MAX_ALIASES: usize = 1_000;

/// The tree of a YAML text.
pub fn read(text: &str, file: FileId) -> Result<Node, Box<Diagnostic>> {
    match serde_saphyr::from_str_with_options::<Spanned<Raw>>(text, options()) {
        Ok(raw) => Ok(Placer { text, file }.node(raw)),
        Err(error) => Err(Box::new(fault::diagnostic(&error, text, file))),
    }
}

fn options() -> Options {
    serde_saphyr::options! {
        strict_booleans: true,
        reject_unsupported_tags: true,
        leading_zero_numbers_as_strings: true,
        underscored_numbers_as_strings: true,
        merge_keys: MergeKeyPolicy::Error,
        // Duplicates are reported by the parser of the specification, with both places.
        duplicate_keys: DuplicateKeyPolicy::PassThrough,
        // `1e999` is refused where a number is expected, not here.
        non_finite_float_policy: NonFiniteFloatPolicy::AsString,
        with_snippet: false,
        budget: serde_saphyr::budget! {
            flow_nesting_limit: MAX_DEPTH,
            max_depth: MAX_DEPTH,
            max_nodes: MAX_NODES,
            max_events: 4 * MAX_NODES,
            max_aliases: MAX_ALIASES,
            max_anchors: MAX_ALIASES,
            max_documents: 1,
            max_recorded_anchor_events: MAX_NODES,
            max_recorded_anchor_bytes: 4 * super::MAX_BYTES,
        },
        alias_limits: serde_saphyr::alias_limits! {
            max_total_replayed_events: MAX_NODES,
            max_replay_stack_depth: MAX_DEPTH,
        },
    }
}

/// What the library hands over; numbers lose their spelling, which the source text gives back.
enum Raw {
    Null,
    Text(String),
    Literal,
    Seq(Vec<Spanned<Raw>>),
    Map(Vec<(Spanned<String>, Spanned<Raw>)>),
}

impl<'de> Deserialize<'de> for Raw {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RawVisitor)
    }
}

struct RawVisitor;

impl<'de> Visitor<'de> for RawVisitor {
    type Value = Raw;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a map, a list, text or a number")
    }
    fn visit_unit<E>(self) -> Result<Raw, E> {
        Ok(Raw::Null)
    }
    fn visit_none<E>(self) -> Result<Raw, E> {
        Ok(Raw::Null)
    }
    fn visit_bool<E>(self, _: bool) -> Result<Raw, E> {
        Ok(Raw::Literal)
    }
    fn visit_i64<E>(self, _: i64) -> Result<Raw, E> {
        Ok(Raw::Literal)
    }
    fn visit_u64<E>(self, _: u64) -> Result<Raw, E> {
        Ok(Raw::Literal)
    }
    fn visit_i128<E>(self, _: i128) -> Result<Raw, E> {
        Ok(Raw::Literal)
    }
    fn visit_u128<E>(self, _: u128) -> Result<Raw, E> {
        Ok(Raw::Literal)
    }
    fn visit_f64<E>(self, _: f64) -> Result<Raw, E> {
        Ok(Raw::Literal)
    }
    fn visit_str<E>(self, text: &str) -> Result<Raw, E> {
        Ok(Raw::Text(text.into()))
    }
    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Raw, D::Error> {
        Raw::deserialize(deserializer)
    }
    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Raw, A::Error> {
        let mut all = Vec::new();
        while let Some(item) = items.next_element()? {
            all.push(item);
        }
        Ok(Raw::Seq(all))
    }
    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Raw, A::Error> {
        let mut all = Vec::new();
        while let Some(entry) = entries.next_entry()? {
            all.push(entry);
        }
        Ok(Raw::Map(all))
    }
}

/// The text of a quoted scalar that has escapes, with its place. `text` is what the library made of it: should the two differ
/// in more than blanks, the library is right and the places are unknown.
fn code_with_escapes(written: &str, double: bool, text: &str, span: Span) -> (String, Base) {
    let (code, places) = escape::decode(written, double);
    match code.split_whitespace().eq(text.split_whitespace()) {
        true => (code, Base::escaped(span, places.into())),
        false => (text.to_owned(), Base::whole(span)),
    }
}

/// The last border of a character up to a byte.
pub(super) fn boundary(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

/// Turns the library's locations into spans.
struct Placer<'a> {
    text: &'a str,
    file: FileId,
}

impl Placer<'_> {
    fn node(&self, raw: Spanned<Raw>) -> Node {
        let span = self.span(raw.defined);
        let spanning = |last: Option<Span>| {
            let end = last.map_or(span.end, |last| last.end.max(span.end));
            self.closed(Span { end, ..span })
        };
        match raw.value {
            Raw::Null => Node {
                kind: Kind::Null,
                span,
            },
            Raw::Text(text) => self.scalar(Some(text), span),
            Raw::Literal => self.scalar(None, span),
            Raw::Seq(items) => {
                let items: Vec<Node> = items.into_iter().map(|item| self.node(item)).collect();
                Node {
                    span: spanning(items.last().map(|last| last.span)),
                    kind: Kind::Seq(items),
                }
            }
            Raw::Map(entries) => {
                let entries: Vec<Entry> = entries
                    .into_iter()
                    .map(|(key, value)| self.entry(key, value))
                    .collect();
                Node {
                    span: spanning(entries.last().map(|last| last.value.span)),
                    kind: Kind::Map(entries),
                }
            }
        }
    }

    /// A list or map with the bracket that closes it, if it is written in brackets.
    fn closed(&self, span: Span) -> Span {
        let (start, end) = (span.start as usize, span.end as usize);
        let close = match self.text.get(start..start + 1) {
            Some("[") => ']',
            Some("{") => '}',
            _ => return span,
        };
        let rest = self.text.get(end..).unwrap_or_default();
        // What may stand behind the content of the last part: its closing quote, blanks, a comma.
        let before = rest.find(|c: char| !matches!(c, '"' | '\'' | ' ' | '\n' | '\r' | ','));
        let last = before.filter(|&at| rest[at..].starts_with(close));
        last.map_or(span, |at| Span {
            end: (end + at + 1) as u32,
            ..span
        })
    }

    fn entry(&self, key: Spanned<String>, value: Spanned<Raw>) -> Entry {
        Entry {
            key: Key {
                text: key.value,
                span: self.span(key.defined),
            },
            value: self.node(value),
        }
    }

    fn scalar(&self, decoded: Option<String>, span: Span) -> Node {
        let written = self.text[span.start as usize..span.end as usize].trim_end();
        let span = Span {
            end: span.start + written.len() as u32,
            ..span
        };
        let quotes = ['"', '\''];
        let inner = written.strip_prefix(quotes);
        let inner = inner.and_then(|rest| rest.strip_suffix(quotes));
        let quoted = inner.is_some();
        let (code, span) = match inner {
            Some(inner) => (
                inner,
                Span {
                    start: span.start + 1,
                    end: span.end - 1,
                    ..span
                },
            ),
            None => (written, span),
        };
        // Lines of block and folded scalars are joined by the library; everything else is as written, `1e999` and `.nan` included.
        let text = decoded
            .filter(|_| quoted || code.contains('\n'))
            .unwrap_or_else(|| code.into());
        let escaped = quoted && (code.contains('\\') || code.contains("''"));
        let (code, base) = if escaped {
            code_with_escapes(code, written.starts_with('"'), &text, span)
        } else {
            (code.to_owned(), Base::verbatim(span))
        };
        Node {
            kind: Kind::Scalar(Scalar {
                text,
                code,
                base,
                quoted,
            }),
            span,
        }
    }

    fn span(&self, location: Location) -> Span {
        let span = location.span();
        let byte = |at: Option<u64>| at.and_then(|at| usize::try_from(at).ok()).unwrap_or(0);
        // The library counts a byte order mark within the text as one byte.
        let start = boundary(self.text, byte(span.byte_offset()));
        let end = boundary(self.text, start.saturating_add(byte(span.byte_len())));
        Span {
            file: self.file,
            start: start as u32,
            end: end as u32,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tree(text: &str) -> Node {
        read(text, FileId(0)).unwrap()
    }

    /// Keys and scalars of a tree with the text at their spans, in order.
    fn leaves(node: &Node, text: &str, all: &mut Vec<(String, String)>) {
        let at = |span: Span| text[span.start as usize..span.end as usize].to_owned();
        match &node.kind {
            Kind::Null => {}
            Kind::Scalar(scalar) => all.push((scalar.text.clone(), at(node.span))),
            Kind::Seq(items) => items.iter().for_each(|item| leaves(item, text, all)),
            Kind::Map(entries) => {
                for entry in entries {
                    all.push((entry.key.text.clone(), at(entry.key.span)));
                    leaves(&entry.value, text, all);
                }
            }
        }
    }

    #[track_caller]
    fn check(text: &str, expected: &[(&str, &str)]) {
        let mut all = Vec::new();
        leaves(&tree(text), text, &mut all);
        let found: Vec<(&str, &str)> = all
            .iter()
            .map(|(text, at)| (text.as_str(), at.as_str()))
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn spans_cover_keys_and_scalars() {
        check(
            "a: 1.50\n\"b c\": 'x y'  # note\n",
            &[
                ("a", "a"),
                ("1.50", "1.50"),
                ("b c", "\"b c\""),
                ("x y", "x y"),
            ],
        );
        check(
            "\u{3b1}\u{3b2}: [\u{3b3}, {d: 2 m}]",
            &[
                ("\u{3b1}\u{3b2}", "\u{3b1}\u{3b2}"),
                ("\u{3b3}", "\u{3b3}"),
                ("d", "d"),
                ("2 m", "2 m"),
            ],
        );
        check(
            "a: &x {b: 1}\nc: *x",
            &[
                ("a", "a"),
                ("b", "b"),
                ("1", "1"),
                ("c", "c"),
                ("b", "b"),
                ("1", "1"),
            ],
        );
    }

    #[test]
    fn block_scalars_point_at_their_first_line() {
        check(
            "a: |\n  x +\n    y\nb: >-\n  p\n  q\n",
            &[
                ("a", "a"),
                ("x +\n  y\n", "x +\n    y"),
                ("b", "b"),
                ("p q", "p\n  q"),
            ],
        );
    }

    #[test]
    fn code_is_the_text_of_the_file_where_it_can_be() {
        let text = "a: |\n  x +\n    y\nb: 'it''s'\n";
        let Kind::Map(entries) = tree(text).kind else {
            panic!("a map")
        };
        let code = |at: usize| match &entries[at].value.kind {
            Kind::Scalar(scalar) => (scalar.code.clone(), scalar.quoted),
            other => panic!("{other:?}"),
        };
        assert_eq!(code(0), ("x +\n    y".into(), false));
        assert_eq!(code(1), ("it's".into(), true));
    }

    #[test]
    fn numbers_and_words_keep_their_spelling() {
        check(
            "[1e999, .nan, 0x1F, 1_000, no, 014, True, !!str 5]",
            &["1e999", ".nan", "0x1F", "1_000", "no", "014", "True", "5"].map(|word| (word, word)),
        );
    }

    /// What is not there has no bytes, what is written as nothing has.
    #[test]
    fn nothing_written_differs_from_nothing_there() {
        let Kind::Map(entries) = tree("a: ~\nb:\nc: null\nd: {e: , f: ~}\n").kind else {
            panic!("a map")
        };
        let length = |node: &Node| node.span.end - node.span.start;
        let lengths: Vec<u32> = entries
            .iter()
            .take(3)
            .map(|entry| length(&entry.value))
            .collect();
        assert_eq!(lengths, [1, 0, 4]);
        let Kind::Map(inner) = &entries[3].value.kind else {
            panic!("a map")
        };
        assert_eq!(
            inner
                .iter()
                .map(|entry| length(&entry.value))
                .collect::<Vec<_>>(),
            [0, 1]
        );
    }

    #[test]
    fn a_byte_order_mark_within_the_text_moves_places_by_whole_characters() {
        for text in [
            "|\r\r'dr'ns'''\r%d\u{feff}",
            "a: '\u{feff}'",
            "a: \"\u{feff}x\u{e9}\"",
            "\u{feff}a: \u{feff}b",
        ] {
            _ = read(text, FileId(0));
        }
    }

    #[test]
    fn duplicate_keys_survive() {
        check(
            "a: 1\na: 2\n",
            &[("a", "a"), ("1", "1"), ("a", "a"), ("2", "2")],
        );
    }
}
