//! Says what is wrong with a YAML text in the words of this crate.

use serde_saphyr::Error;
use serde_saphyr::budget::BudgetBreach;

use super::read::{MAX_DEPTH, MAX_NODES, boundary};
use crate::diagnostic::{Applicability, Diagnostic, FileId, Rule, Span, quoted};

/// The diagnostic for an error of the YAML library.
pub(super) fn diagnostic(error: &Error, text: &str, file: FileId) -> Diagnostic {
    let error = error.without_snippet();
    let span = span(error, text, file);
    let fault =
        |rule, message: String, help: &str| Diagnostic::error(rule, span, message).with_help(help);
    match error {
        Error::AliasError { error: inner, .. } => diagnostic(inner, text, file),
        Error::Budget {
            breach: BudgetBreach::Depth { .. },
            ..
        } => too_deep(span),
        Error::Budget {
            breach: BudgetBreach::Documents { .. },
            ..
        }
        | Error::MultipleDocuments { .. } => fault(
            Rule::E0008,
            "found a second YAML document, expected one".into(),
            "remove the line `---` and what follows it",
        ),
        Error::Budget { .. }
        | Error::AliasReplayCounterOverflow { .. }
        | Error::AliasReplayLimitExceeded { .. }
        | Error::AliasExpansionLimitExceeded { .. }
        | Error::AliasReplayStackDepthExceeded { .. } => fault(
            Rule::E0006,
            format!(
                "file expands to too much data, expected at most {MAX_NODES} values and few aliases"
            ),
            "write the values out instead of nesting aliases",
        ),
        Error::RecursiveReferencesRequireWeakTypes { .. } => endless(text, span),
        Error::UnknownAnchor { .. } => fault(
            Rule::E0009,
            "alias refers to an anchor that does not exist".into(),
            "a value that starts with `*` is an alias in YAML; quote it if it is text",
        ),
        Error::MergeKeyNotAllowed { .. } => fault(
            Rule::E0009,
            "merge key `<<` is not supported".into(),
            "write the keys out, or move shared sections to an included file",
        ),
        Error::UnsupportedTag { tag, .. } => fault(
            Rule::E0007,
            format!("found tag `{tag}`, expected a value without tag"),
            "remove the tag; a value that starts with `!` must be quoted",
        ),
        Error::Unexpected { .. } | Error::NullIntoString { .. } => fault(
            Rule::E0010,
            "found a key that is not text".into(),
            "every key is a plain word",
        ),
        other => {
            let fault = syntax(other, text, span);
            without_colon(&fault, text).unwrap_or(fault)
        }
    }
}

/// The fault of a key without a colon, which the library finds where the next key has one, or where the line begins.
fn without_colon(fault: &Diagnostic, text: &str) -> Option<Diagnostic> {
    let span = fault.span?;
    let found = span.start as usize;
    let line = text.get(..found)?.rfind('\n').map_or(0, |at| at + 1);
    let indent = |line: &str| line.len() - line.trim_start_matches(' ').len();
    let (start, written) = if fault.message.contains("simple key expected") {
        (line, text[line..].lines().next()?)
    } else if fault.message.contains("mapping values are not allowed") {
        let before = text[..line].trim_end();
        let start = before.rfind('\n').map_or(0, |at| at + 1);
        (start, &before[start..])
    } else {
        return None;
    };
    if indent(written) != indent(&text[line..]) {
        return None;
    }
    let key = written.trim_start().split(' ').next()?;
    let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if key.is_empty() || !key.chars().all(word) || written.contains(": ") {
        return None;
    }
    let start = start + indent(written);
    let place = Span {
        start: start as u32,
        end: (start + key.len()) as u32,
        ..span
    };
    let message = format!("not valid YAML: key {} has no `:`", quoted(key));
    let fault = Diagnostic::error(Rule::E0004, place, message).with_help(format!("write `{key}:`"));
    Some(fault.with_suggestion(place, format!("{key}:"), Applicability::Possible))
}

/// An alias within the value that it repeats.
fn endless(text: &str, span: Span) -> Diagnostic {
    let written = text.get(span.start as usize..).unwrap_or_default();
    let end = written.find(|c: char| c.is_whitespace() || ",[]{}".contains(c));
    let alias = &written[..end.unwrap_or(written.len())];
    let Some(name) = alias.strip_prefix('*').filter(|name| !name.is_empty()) else {
        let message = "alias stands inside the value that it repeats";
        return Diagnostic::error(Rule::E0009, span, message)
            .with_help("write the value that is meant in its place");
    };
    let place = |start: usize| Span {
        start: start as u32,
        end: (start + alias.len()) as u32,
        ..span
    };
    let message = format!(
        "alias {} stands inside the value that it repeats",
        quoted(alias)
    );
    let fault =
        Diagnostic::error(Rule::E0009, place(span.start as usize), message).with_help(format!(
            "write the value that is meant in place of {}",
            quoted(alias)
        ));
    // The mark of the same name that comes last before the alias.
    let mark = format!("&{name}");
    let before = text.get(..span.start as usize).unwrap_or_default();
    let mut marks = before.rmatch_indices(&mark).map(|(at, _)| at);
    let ends = |at: &usize| before[at + mark.len()..].starts_with([' ', '\n', '\r']);
    match marks.find(ends) {
        Some(at) => fault.with_related(place(at), "the value is marked here"),
        None => fault,
    }
}

/// Brackets nested too deep, which the library reports in two ways.
fn too_deep(span: Span) -> Diagnostic {
    Diagnostic::error(
        Rule::E0005,
        span,
        format!("values are nested too deep, expected at most {MAX_DEPTH} levels"),
    )
    .with_help("a specification needs eight levels; look for a bracket that is never closed")
}

fn syntax(error: &Error, text: &str, span: Span) -> Diagnostic {
    let mut message = error.to_string();
    if let Some(at) = message.rfind(" at line ") {
        message.truncate(at);
    }
    let message = message.replace("`:'", "`:`").replace('\'', "`");
    if message.contains("recursion limit") || message.contains("nesting") {
        return too_deep(span);
    }
    let unclosed = message.contains("did not find expected");
    let open = open_bracket(text, span.start as usize).filter(|_| unclosed);
    let help = if open.is_some() {
        "close the bracket before this, or quote text that contains one of `: # { } [ ] , & * ! | > % @`"
    } else if message.contains("mapping values are not allowed") {
        "put a blank after `:` only between key and value, indent keys of one map alike, and quote text that contains `: `"
    } else if message.contains("tabs disallowed") {
        "indent with blanks instead of tabs"
    } else if message.contains("unclosed bracket") {
        "close the bracket"
    } else if message.contains("unclosed quote") {
        "close the quote"
    } else {
        "quote text that contains one of `: # { } [ ] , & * ! | > % @`"
    };
    let fault =
        Diagnostic::error(Rule::E0004, span, format!("not valid YAML: {message}")).with_help(help);
    match open {
        Some(at) => {
            let (start, end) = (at as u32, at as u32 + 1);
            fault.with_related(Span { start, end, ..span }, "this bracket is open")
        }
        None => fault,
    }
}

/// The innermost bracket of YAML that is open at a byte.
fn open_bracket(text: &str, end: usize) -> Option<usize> {
    let mut open: Vec<usize> = Vec::new();
    let (mut quote, mut comment, mut before) = (None, false, ' ');
    for (at, c) in text.get(..end)?.char_indices() {
        match (quote, c) {
            _ if comment => comment = c != '\n',
            (Some(mark), c) => quote = (c != mark).then_some(mark),
            (None, '"' | '\'') if !before.is_alphanumeric() => quote = Some(c),
            (None, '#') if before.is_whitespace() => comment = true,
            (None, '{' | '[') => open.push(at),
            (None, '}' | ']') => drop(open.pop()),
            _ => {}
        }
        before = c;
    }
    open.pop()
}

fn span(error: &Error, text: &str, file: FileId) -> Span {
    let span = error.location().map(|location| location.span());
    // The scanner counts characters; only later stages know bytes.
    let start = span.map_or(0, |span| match span.byte_offset() {
        Some(byte) => usize::try_from(byte).unwrap_or(text.len()),
        None => text
            .char_indices()
            .nth(usize::try_from(span.offset()).unwrap_or(usize::MAX))
            .map_or(text.len(), |(byte, _)| byte),
    });
    let start = boundary(text, start);
    let end = text[start..]
        .chars()
        .next()
        .map_or(start, |c| start + c.len_utf8());
    Span {
        file,
        start: start as u32,
        end: end as u32,
    }
}
