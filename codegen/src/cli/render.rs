//! Diagnostics for people and programs.

use std::collections::BTreeSet;

use annotate_snippets::{AnnotationKind, Group, Level, Patch, Renderer, Snippet};
use nsv_spec::diagnostic::{
    Applicability, Diagnostic, Diagnostics, FileId, Rule, Severity, SourceMap, Span,
};
use serde::Serialize;

/// Pictures of the faults in their sources, and a last line that counts them.
pub(crate) fn human(diagnostics: &Diagnostics, colour: bool) -> String {
    let renderer = if colour {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let sources = &diagnostics.sources;
    let pictures = diagnostics
        .items
        .iter()
        .map(|item| renderer.render(&groups(sources, item)) + "\n\n");
    pictures.collect()
}

/// Where to read more about faults: the last line for people; nothing where there are none.
pub(crate) fn more<'a>(faults: impl IntoIterator<Item = &'a Diagnostic>) -> Option<String> {
    // A file that cannot be read needs no explanation.
    let placed = faults.into_iter().filter(|fault| fault.span.is_some());
    let rules: BTreeSet<Rule> = placed.map(|fault| fault.rule).collect();
    let names: Vec<&str> = rules.iter().map(|rule| rule.name()).collect();
    match names.as_slice() {
        [] => None,
        [only] => Some(format!("`nsv explain {only}` says more")),
        several => Some(format!(
            "`nsv explain CODE` says more, CODE being one of {}",
            several.join(", ")
        )),
    }
}

/// The fault, then the change that mends it as the lines before and after.
fn groups<'a>(sources: &'a SourceMap, item: &'a Diagnostic) -> Vec<Group<'a>> {
    let fault = group(sources, item);
    let help = item.help.as_deref();
    let Some(suggestion) = &item.suggestion else {
        return vec![match help {
            Some(help) => fault.element(Level::HELP.message(help)),
            None => fault,
        }];
    };
    let source = sources.source(suggestion.span.file);
    let patch = Patch::new(
        within(&source.text, suggestion.span),
        suggestion.replacement.as_str(),
    );
    let snippet = Snippet::source(&*source.text)
        .path(source.name.as_str())
        .patch(patch);
    let title = Level::HELP.secondary_title(help.unwrap_or("change this"));
    vec![fault, title.element(snippet)]
}

fn group<'a>(sources: &'a SourceMap, item: &'a Diagnostic) -> Group<'a> {
    let level = match item.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let title = level
        .primary_title(item.message.as_str())
        .id(item.rule.name());
    let mut group = Group::with_title(title);
    for (file, places) in by_file(sources, item) {
        let source = sources.source(file);
        let places = places.into_iter().map(|(span, label, kind)| {
            let span = within(&source.text, span);
            kind.span(span).label(label)
        });
        group = group.element(
            Snippet::source(&*source.text)
                .path(source.name.as_str())
                .annotations(places),
        );
    }
    group
}

type Place<'a> = (Span, Option<&'a str>, AnnotationKind);

/// The places of a diagnostic by file, the primary one's file first.
fn by_file<'a>(sources: &SourceMap, item: &'a Diagnostic) -> Vec<(FileId, Vec<Place<'a>>)> {
    let primary = item.span.map(|span| {
        let span = drawn(sources, item, span);
        (span, item.label.as_deref(), AnnotationKind::Primary)
    });
    let related = item.related.iter().map(|related| {
        (
            related.span,
            Some(related.label.as_str()),
            AnnotationKind::Context,
        )
    });
    let mut files: Vec<(FileId, Vec<Place<'a>>)> = Vec::new();
    for place in primary.into_iter().chain(related) {
        match files.iter_mut().find(|(file, _)| *file == place.0.file) {
            Some((_, places)) => places.push(place),
            None => files.push((place.0.file, vec![place])),
        }
    }
    files
}

/// The part of the primary place that is drawn: its first line, if it has several and labels within would cross its frame.
fn drawn(sources: &SourceMap, item: &Diagnostic, span: Span) -> Span {
    let inside =
        |other: Span| other.file == span.file && span.start <= other.start && other.end <= span.end;
    let text = &sources.source(span.file).text;
    let first = text[within(text, span)].find('\n');
    match first {
        Some(length) if item.related.iter().any(|related| inside(related.span)) => Span {
            end: span.start + u32::try_from(length).unwrap_or(0),
            ..span
        },
        _ => span,
    }
}

/// A span as a range that surely lies in the text.
fn within(text: &str, span: Span) -> std::ops::Range<usize> {
    let end = (span.end as usize).min(text.len());
    (span.start as usize).min(end)..end
}

/// A diagnostic for programs.
#[derive(Serialize)]
pub(crate) struct Record<'a> {
    code: &'a str,
    severity: String,
    message: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    label: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    help: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    suggestion: Option<SuggestionRecord<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<PlaceRecord<'a>>,
    related: Vec<RelatedRecord<'a>>,
}

#[derive(Serialize)]
pub(super) struct PlaceRecord<'a> {
    pub(super) file: &'a str,
    pub(super) start: Position,
    pub(super) end: Position,
}

/// A change; `applicability` is `certain` where `nsv check --fix` makes it.
#[derive(Serialize)]
struct SuggestionRecord<'a> {
    place: PlaceRecord<'a>,
    replacement: &'a str,
    applicability: &'static str,
}

#[derive(Serialize)]
struct RelatedRecord<'a> {
    label: &'a str,
    place: PlaceRecord<'a>,
}

/// A position in every way that editors count: bytes from 0; lines and columns from 1, columns in characters and UTF-16 units.
#[derive(Serialize)]
pub(super) struct Position {
    pub(super) byte: usize,
    pub(super) line: usize,
    pub(super) column: usize,
    pub(super) utf16_column: usize,
}

/// Diagnostics as records.
pub(crate) fn records<'a>(diagnostics: &'a Diagnostics) -> Vec<Record<'a>> {
    let place = |span| place(&diagnostics.sources, span);
    let record = |item: &'a Diagnostic| {
        let Diagnostic {
            rule,
            severity,
            span,
            label,
            message,
            help,
            suggestion,
            related,
            ..
        } = item;
        let related = related.iter().map(|other| RelatedRecord {
            label: &other.label,
            place: place(other.span),
        });
        Record {
            code: rule.name(),
            severity: severity.to_string(),
            message,
            label: label.as_deref(),
            help: help.as_deref(),
            suggestion: suggestion.as_ref().map(|suggestion| SuggestionRecord {
                place: place(suggestion.span),
                replacement: &suggestion.replacement,
                applicability: match suggestion.applicability {
                    Applicability::Certain => "certain",
                    Applicability::Possible => "possible",
                },
            }),
            place: span.map(place),
            related: related.collect(),
        }
    };
    diagnostics.items.iter().map(record).collect()
}

/// A span as a place.
pub(super) fn place(sources: &SourceMap, span: Span) -> PlaceRecord<'_> {
    let source = sources.source(span.file);
    let range = within(&source.text, span);
    PlaceRecord {
        file: &source.name,
        start: position(&source.text, range.start),
        end: position(&source.text, range.end),
    }
}

fn position(text: &str, byte: usize) -> Position {
    let before = text.get(..byte).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = &before[line_start..];
    Position {
        byte,
        line: before.matches('\n').count() + 1,
        column: line.chars().count() + 1,
        utf16_column: line.encode_utf16().count() + 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagnostics() -> Diagnostics {
        let mut sources = SourceMap::default();
        let text = "nsv: 1\ntitle: \u{e9}\u{1f680} b\u{f6}se\nmass: 3 kg\n";
        let spec = sources.add("specs/bad.yaml", text.into());
        let model = sources.add("specs/models/plant.yaml", "mass: 2 kg\n".into());
        let at = |file, start, end| Span { file, start, end };
        let mass = u32::try_from(text.find("mass").unwrap()).unwrap();
        let title = u32::try_from(text.find("title").unwrap()).unwrap();
        let twice = Diagnostic::error(
            Rule::E0102,
            at(spec, mass, mass + 4),
            "`mass` is declared twice",
        )
        .with_label("declared again")
        .with_related(at(model, 0, 4), "first declared here")
        .with_help("write `mass_2`")
        .with_suggestion(at(spec, mass, mass + 4), "mass_2", Applicability::Possible);
        let odd = Diagnostic::warning(
            Rule::W0001,
            at(spec, title + 7, title + 20),
            "title is not plain",
        );
        let lost = Diagnostic {
            span: None,
            ..Diagnostic::error(
                Rule::E0001,
                at(spec, 0, 0),
                "cannot read `x.yaml`: no such file",
            )
        };
        Diagnostics {
            sources,
            items: vec![twice, odd, lost],
        }
    }

    #[test]
    fn faults_are_shown_in_their_sources() {
        insta::assert_snapshot!(human(&diagnostics(), false));
    }

    #[test]
    fn the_last_line_names_each_code_once() {
        let Diagnostics { items, .. } = diagnostics();
        assert_eq!(more(&items[2..]), None);
        assert_eq!(more(&items[..1]).unwrap(), "`nsv explain E0102` says more");
        let twice = items.iter().chain(&items);
        assert_eq!(
            more(twice).unwrap(),
            "`nsv explain CODE` says more, CODE being one of E0102, W0001"
        );
    }

    #[test]
    fn records_count_as_editors_do() {
        let diagnostics = diagnostics();
        insta::assert_json_snapshot!(records(&diagnostics));
    }

    #[test]
    fn labels_within_several_lines_cross_no_frame() {
        let mut sources = SourceMap::default();
        let file = sources.add("a.yaml", "drift: >\n  -v\n  + push\n".into());
        let at = |start, end| Span { file, start, end };
        let item = Diagnostic::error(Rule::E0403, at(11, 22), "unit mismatch")
            .with_related(at(11, 13), "this is in m")
            .with_related(at(18, 22), "this is in s");
        let items = vec![item];
        insta::assert_snapshot!(human(&Diagnostics { sources, items }, false));
    }

    #[test]
    fn a_span_outside_the_text_is_cut() {
        let mut diagnostics = diagnostics();
        diagnostics.items[0].span = Some(Span {
            file: FileId(1),
            start: 5,
            end: 4000,
        });
        assert!(human(&diagnostics, false).contains("declared twice"));
        assert!(serde_json::to_string(&records(&diagnostics)).is_ok());
    }
}
