//! Every rule is explained by an example that breaks it and nothing else, and by a mend that works.

use std::fs;
use std::path::Path;

use nsv_spec::diagnostic::explain::Example;
use nsv_spec::diagnostic::{Diagnostic, Rule};
use nsv_spec::load;

/// The diagnostics of an example as a file with its included files; those of its mend if `mended`.
fn diagnostics(directory: &Path, example: &Example, mended: bool) -> (Vec<Diagnostic>, String) {
    for (name, bad, good) in example.files {
        fs::write(directory.join(name), if mended { good } else { bad }).expect("an included file");
    }
    let path = directory.join("example.yaml");
    let text = match mended {
        true => Some(example.mended().into_bytes()),
        false => example.broken(),
    };
    match text {
        Some(text) => fs::write(&path, text).expect("an example"),
        None => drop(fs::remove_file(&path)),
    }
    match load(&path) {
        Ok((model, warnings)) => {
            let text = format!("{} warnings of {}", warnings.len(), model.name);
            (warnings, text)
        }
        Err(faults) => {
            let text = faults.short();
            (faults.items, text)
        }
    }
}

#[test]
fn every_example_breaks_its_rule_alone() {
    let mut surprises = String::new();
    for &rule in Rule::ALL {
        let directory = tempfile::tempdir().unwrap();
        let (found, text) = diagnostics(directory.path(), &rule.explanation().example, false);
        let rules: Vec<Rule> = found.iter().map(|item| item.rule).collect();
        if rules != [rule] {
            surprises.push_str(&format!("{rule}: {rules:?}\n{text}\n"));
        }
    }
    assert!(surprises.is_empty(), "{surprises}");
}

#[test]
fn every_mend_checks_clean() {
    let mut surprises = String::new();
    for &rule in Rule::ALL {
        let directory = tempfile::tempdir().unwrap();
        let (found, text) = diagnostics(directory.path(), &rule.explanation().example, true);
        if !found.is_empty() {
            surprises.push_str(&format!("{rule}: {text}\n"));
        }
    }
    assert!(surprises.is_empty(), "{surprises}");
}

#[test]
fn every_edit_of_an_example_has_its_place() {
    for &rule in Rule::ALL {
        for edit in rule.explanation().example.edits {
            let there = nsv_spec::diagnostic::explain::BASE
                .matches(edit.from)
                .count();
            assert!(there >= 1, "{rule}: {}", edit.from);
        }
    }
}

#[test]
fn every_certain_change_of_an_example_mends_it() {
    let mut changed = Vec::new();
    for &rule in Rule::ALL {
        let directory = tempfile::tempdir().unwrap();
        let example = &rule.explanation().example;
        diagnostics(directory.path(), example, false);
        let path = directory.path().join("example.yaml");
        let Err(faults) = load(&path) else { continue };
        for fixed in faults.fix() {
            fs::write(&faults.sources.source(fixed.file).name, &fixed.text).unwrap();
            load(&path).unwrap_or_else(|left| panic!("{rule}: {}", left.short()));
            changed.push(rule);
        }
    }
    assert!(changed.len() >= 10, "{changed:?}");
}
