//! The explanation of a code as text and as a page of the documentation.

use std::fs;
use std::path::Path;

use nsv_spec::diagnostic::Rule;
use nsv_spec::diagnostic::explain::{BASE, Example, Twist};
use nsv_spec::diagnostic::{Diagnostics, Severity};

use crate::cli::failure::Failure;
use crate::cli::render::human;

/// What a file of an example is called.
const NAME: &str = "example.yaml";
/// Longest line of a diagnostic that is shown.
const WIDEST: usize = 160;

/// Every page with its name, the list of all codes among them.
pub(super) fn all() -> Result<Vec<(String, String)>, Failure> {
    let mut pages = vec![("README.md".to_owned(), index())];
    for &rule in Rule::ALL {
        pages.push((format!("{rule}.md"), page(rule)?));
    }
    Ok(pages)
}

fn index() -> String {
    let mut text = String::from(
        "# Codes of diagnostics\n\n\
         `nsv explain CODE` shows these pages in the terminal. They are made by `cargo nsv explain --pages docs/diagnostics`; a test\n\
         finds one that is out of date. The examples are changes of this specification, which checks clean:\n\n",
    );
    text.push_str(&format!("```yaml\n{BASE}```\n\n| code | |\n|---|---|\n"));
    for rule in Rule::ALL {
        text.push_str(&format!("| [{rule}]({rule}.md) | {} |\n", rule.title()));
    }
    text
}

fn page(rule: Rule) -> Result<String, Failure> {
    let explanation = rule.explanation();
    let severity = match rule.severity() {
        Severity::Error => "Error",
        Severity::Warning => "Warning",
    };
    let mut text = format!(
        "# {rule}: {}\n\n{severity}. {}\n\n",
        rule.title(),
        explanation.why
    );
    for (heading, body) in sections(&explanation.example)? {
        text.push_str(&format!("{heading}\n\n{body}\n"));
    }
    text.push_str(&format!(
        "`nsv explain {rule} --example broken` prints the whole specification, `--example mended` its mend. \
         [All codes](README.md)\n"
    ));
    Ok(text)
}

/// The explanation for a terminal.
pub(super) fn text(rule: Rule) -> Result<String, Failure> {
    let explanation = rule.explanation();
    let mut text = format!(
        "{rule}: {}\n\n{}\n\n",
        rule.title(),
        wrapped(explanation.why)
    );
    for (heading, body) in sections(&explanation.example)? {
        let body: String = body
            .lines()
            .filter(|line| !line.starts_with("```"))
            .map(|line| format!("    {line}").trim_end().to_owned() + "\n")
            .collect();
        text.push_str(&format!("{heading}\n\n{body}\n"));
    }
    Ok(text)
}

/// Words in lines of at most 100 characters.
fn wrapped(text: &str) -> String {
    let mut lines = String::new();
    let mut width = 0;
    for word in text.split(' ') {
        if width > 0 && width + 1 + word.len() > 100 {
            lines.push('\n');
            width = 0;
        } else if width > 0 {
            lines.push(' ');
            width += 1;
        }
        lines.push_str(word);
        width += word.len();
    }
    lines
}

/// The parts of an example: what is wrong, what nsv says, how to mend it.
fn sections(example: &Example) -> Result<Vec<(String, String)>, Failure> {
    let said = format!("```text\n{}```\n", said(example)?);
    if example.twist == Twist::Absent {
        return Ok(vec![("nsv says:".into(), said)]);
    }
    let note = match example.twist {
        Twist::Latin1 => ", saved in Latin-1".to_owned(),
        Twist::Long(part, times) => format!(", where `\u{2026}` stands for {times} times `{part}`"),
        _ => String::new(),
    };
    let broken = changes(example, false);
    let mended = changes(example, true);
    // A mend that takes everything back leaves nothing to show.
    let right = match (example.twist, mended.is_empty()) {
        (_, true) => "Without that it is right.",
        (Twist::Latin1, _) => "This is right, saved in UTF-8:",
        _ => "This is right:",
    };
    Ok(vec![
        (format!("This breaks the rule{note}:"), broken),
        ("nsv says:".into(), said),
        (right.to_owned(), mended),
    ])
}

/// The sections of the example that are not as in the base, and its files.
fn changes(example: &Example, mended: bool) -> String {
    let (mut whole, mut changed) = (BASE.to_owned(), Vec::new());
    for edit in example.edits {
        whole = whole.replacen(edit.from, if mended { edit.good } else { edit.bad }, 1);
        changed.push(edit.from);
    }
    let mut text = match relevant(&whole, example, mended).as_str() {
        "" => String::new(),
        sections => format!("```yaml\n{sections}```\n"),
    };
    for (name, bad, good) in example.files {
        let body = if mended { good } else { bad };
        if !body.is_empty() {
            text.push_str(&format!(
                "\nwith the file `{name}`:\n\n```yaml\n{body}```\n"
            ));
        }
    }
    text
}

/// The top-level sections in which a side of the example differs from the base or from the other side.
fn relevant(whole: &str, example: &Example, mended: bool) -> String {
    let other = example.edits.iter().fold(BASE.to_owned(), |text, edit| {
        text.replacen(edit.from, if mended { edit.bad } else { edit.good }, 1)
    });
    let base = chunks(BASE);
    let other = chunks(&other);
    let shown = |chunk: &&str| !(base.contains(chunk) && other.contains(chunk));
    chunks(whole).into_iter().filter(shown).collect()
}

/// A specification by its top-level keys.
fn chunks(text: &str) -> Vec<&str> {
    let mut starts: Vec<usize> = vec![0];
    for (at, _) in text.match_indices('\n') {
        let next = text[at + 1..].chars().next();
        if next.is_some_and(|c| c != ' ') {
            starts.push(at + 1);
        }
    }
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    starts
        .iter()
        .zip(ends)
        .map(|(&start, end)| &text[start..end])
        .collect()
}

/// What nsv says of the broken side.
fn said(example: &Example) -> Result<String, Failure> {
    let directory = tempfile::tempdir()
        .map_err(|error| Failure::io("make a folder in", &std::env::temp_dir(), &error))?;
    let write = |name: &str, bytes: &[u8]| {
        let path = directory.path().join(name);
        fs::write(&path, bytes).map_err(|error| Failure::io("write", &path, &error))
    };
    for (name, bad, _) in example.files {
        write(name, bad.as_bytes())?;
    }
    if let Some(text) = example.broken() {
        write(NAME, &text)?;
    }
    let path = directory.path().join(NAME);
    let faults = match nsv_spec::load(&path) {
        Ok((model, items)) => Diagnostics {
            sources: model.sources,
            items,
        },
        Err(faults) => faults,
    };
    Ok(shortened(&human(&faults, false), directory.path()))
}

/// A picture without the folder of the example, and without lines that are too long to read.
fn shortened(picture: &str, directory: &Path) -> String {
    let folder = format!("{}/", directory.display());
    let cut = |line: &str| {
        let line = line.replace(&folder, "").replace('\u{feff}', "");
        match line.char_indices().nth(WIDEST) {
            Some((at, _)) => format!("{}..\n", line[..at].trim_end()),
            None => format!("{}\n", line.trim_end()),
        }
    };
    picture.trim_end().lines().map(cut).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_in_the_documentation_are_fresh() {
        let pages = all().unwrap();
        let directory = Path::new("../docs/diagnostics");
        for (name, text) in &pages {
            let found = fs::read_to_string(directory.join(name)).unwrap_or_default();
            assert!(
                found == *text,
                "docs/diagnostics/{name} is out of date: run `cargo nsv explain --pages docs/diagnostics`"
            );
        }
        let there = fs::read_dir(directory).unwrap().count();
        assert_eq!(there, pages.len(), "a page without code");
    }

    #[test]
    fn every_page_shows_its_own_code() {
        for &rule in Rule::ALL {
            let level = rule.severity();
            assert!(
                page(rule).unwrap().contains(&format!("{level}[{rule}]: ")),
                "{rule}"
            );
        }
    }
}
