//! Every change that a diagnostic suggests mends its fault and makes no other: each is applied alone to a copy of the gallery.

use std::fs;
use std::path::Path;

use nsv_spec::diagnostic::{Diagnostic, Diagnostics, Rule, Suggestion};
use nsv_spec::load;

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("the gallery") {
        let path = entry.expect("a directory entry").path();
        let target = to.join(path.file_name().expect("a name"));
        match path.is_dir() {
            true => copy(&path, &target),
            false => drop(fs::copy(&path, &target).expect("a copy")),
        }
    }
}

/// The faults of a specification after one change.
fn after(path: &Path, before: &Diagnostics, suggestion: &Suggestion) -> Vec<Diagnostic> {
    let source = before.sources.source(suggestion.span.file);
    let (start, end) = (suggestion.span.start as usize, suggestion.span.end as usize);
    let text = &source.text;
    let changed = format!(
        "{}{}{}",
        &text[..start],
        suggestion.replacement,
        &text[end..]
    );
    fs::write(&source.name, changed).expect("a changed file");
    let faults = match load(path) {
        Ok((_, warnings)) => warnings,
        Err(faults) => faults.items,
    };
    fs::write(&source.name, &**text).expect("the file as it was");
    faults
}

fn start_of(item: &Diagnostic) -> Option<u32> {
    item.span.map(|span| span.start)
}

#[test]
fn every_suggestion_mends_its_fault_and_makes_no_other() {
    let directory = tempfile::tempdir().expect("a folder");
    copy(Path::new("tests/bad"), directory.path());
    let (mut tried, mut surprises) = (0, String::new());
    let mut paths: Vec<_> = fs::read_dir(directory.path())
        .expect("the copy")
        .map(|entry| entry.expect("a directory entry").path())
        .filter(|path| path.is_file())
        .collect();
    paths.sort();
    for path in paths {
        let before = load(&path).expect_err("a bad specification");
        for item in &before.items {
            let Some(suggestion) = &item.suggestion else {
                continue;
            };
            tried += 1;
            // A declaration that nothing uses, or the same slip elsewhere, was there before, unseen behind the fault.
            let known = |fault: &Diagnostic| {
                let same = |other: &&Diagnostic| {
                    (other.rule, &other.message) == (fault.rule, &fault.message)
                };
                let mended = same(&item) && start_of(fault) == start_of(item);
                fault.rule == Rule::W0002
                    || !mended && before.items.iter().any(|other| same(&other))
            };
            let new: Vec<String> = after(&path, &before, suggestion)
                .iter()
                .filter(|fault| !known(fault))
                .map(|fault| format!("{}: {}\n", fault.rule, fault.message))
                .collect();
            if !new.is_empty() {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                surprises.push_str(&format!(
                    "{name}: `{}` for {} leads to\n{}",
                    suggestion.replacement,
                    item.message,
                    new.concat()
                ));
            }
        }
    }
    assert!(tried >= 30, "{tried}");
    assert!(surprises.is_empty(), "{surprises}");
}
