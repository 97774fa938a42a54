//! Diagnostics as SARIF 2.1.0, which code hosts and editors read.
//!
//! Source: OASIS Standard "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", 27 March 2020.

use nsv_spec::diagnostic::{Diagnostic, Diagnostics, Rule, Severity, SourceMap, Span, Suggestion};
use serde_json::{Value, json};

use crate::cli::render::place;

const SCHEMA: &str =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// One log with one run for all specifications.
pub(super) fn log<'a>(all: impl Iterator<Item = &'a Diagnostics>) -> Value {
    let results: Vec<Value> = all
        .flat_map(|faults| {
            faults
                .items
                .iter()
                .map(|item| result(&faults.sources, item))
        })
        .collect();
    json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "nsv",
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": Rule::ALL.iter().map(rule).collect::<Vec<_>>(),
            }},
            // Ours count characters from 1, as this kind does.
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    })
}

fn rule(rule: &Rule) -> Value {
    json!({
        "id": rule.name(),
        "shortDescription": { "text": rule.title() },
        "fullDescription": { "text": rule.explanation().why },
        "defaultConfiguration": { "level": level(rule.severity()) },
    })
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

fn result(sources: &SourceMap, item: &Diagnostic) -> Value {
    let text = match &item.help {
        Some(help) => format!("{}; {help}", item.message),
        None => item.message.clone(),
    };
    let index = Rule::ALL.iter().position(|rule| *rule == item.rule);
    let mut result = json!({
        "ruleId": item.rule.name(),
        "ruleIndex": index,
        "level": level(item.severity),
        "message": { "text": text },
        "locations": [],
    });
    if let Some(span) = item.span {
        result["locations"] = json!([location(sources, span, item.label.as_deref())]);
    }
    if !item.related.is_empty() {
        let related = item
            .related
            .iter()
            .map(|other| location(sources, other.span, Some(&other.label)));
        result["relatedLocations"] = related.collect();
    }
    if let Some(suggestion) = &item.suggestion {
        result["fixes"] = json!([fix(sources, suggestion, item.help.as_deref())]);
    }
    result
}

fn location(sources: &SourceMap, span: Span, label: Option<&str>) -> Value {
    let mut location = json!({
        "physicalLocation": {
            "artifactLocation": artifact(&sources.source(span.file).name),
            "region": region(sources, span),
        },
    });
    if let Some(label) = label {
        location["message"] = json!({ "text": label });
    }
    location
}

fn region(sources: &SourceMap, span: Span) -> Value {
    let place = place(sources, span);
    json!({
        "startLine": place.start.line,
        "startColumn": place.start.column,
        "endLine": place.end.line,
        "endColumn": place.end.column,
    })
}

fn fix(sources: &SourceMap, suggestion: &Suggestion, help: Option<&str>) -> Value {
    json!({
        "description": { "text": help.unwrap_or("change this") },
        "artifactChanges": [{
            "artifactLocation": artifact(&sources.source(suggestion.span.file).name),
            "replacements": [{
                "deletedRegion": region(sources, suggestion.span),
                "insertedContent": { "text": suggestion.replacement },
            }],
        }],
    })
}

/// A path as a URI reference: what RFC 3986 does not allow in a path is written as `%XX`.
fn artifact(path: &str) -> Value {
    let mut uri = String::new();
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                uri.push(char::from(byte));
            }
            other => uri.push_str(&format!("%{other:02X}")),
        }
    }
    json!({ "uri": uri })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The objects of the standard that we use, each with the properties that it must have (section 3 of the standard).
    fn required(name: &str) -> &'static [&'static str] {
        match name {
            "log" => &["version", "runs"],
            "run" => &["tool", "results"],
            "driver" => &["name"],
            "rule" => &["id"],
            "result" => &["message", "ruleId"],
            "fix" => &["artifactChanges"],
            "change" => &["artifactLocation", "replacements"],
            "replacement" => &["deletedRegion"],
            _ => unreachable!(),
        }
    }

    #[track_caller]
    fn has(value: &Value, name: &str) {
        for key in required(name) {
            assert!(!value[key].is_null(), "{name} lacks {key}: {value}");
        }
    }

    fn check_region(region: &Value) {
        for key in ["startLine", "startColumn", "endLine", "endColumn"] {
            assert!(
                region[key].as_u64().is_some_and(|count| count > 0),
                "{region}"
            );
        }
    }

    #[test]
    fn a_log_has_what_the_standard_requires() {
        let text = "nsv: 1\nname: \u{e9}\nsubstep: 4\n";
        let faults = nsv_spec::load_str("specs/my plant.yaml", text).unwrap_err();
        let log = log([&faults].into_iter());
        has(&log, "log");
        assert_eq!(log["version"], "2.1.0");
        let run = &log["runs"][0];
        has(run, "run");
        has(&run["tool"]["driver"], "driver");
        let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
        rules.iter().for_each(|rule| has(rule, "rule"));
        let results = run["results"].as_array().unwrap();
        assert_eq!(results.len(), faults.items.len());
        for result in results {
            has(result, "result");
            let index = usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap();
            assert_eq!(rules[index]["id"], result["ruleId"]);
            assert!(["error", "warning"].contains(&result["level"].as_str().unwrap()));
            for location in result["locations"].as_array().unwrap() {
                let place = &location["physicalLocation"];
                assert_eq!(place["artifactLocation"]["uri"], "specs/my%20plant.yaml");
                check_region(&place["region"]);
            }
        }
    }

    #[test]
    fn a_change_says_what_it_replaces() {
        let text = std::fs::read_to_string("../specs/pendulum.yaml").unwrap();
        let text = text.replace("substeps:", "substep:");
        let faults = nsv_spec::load_str("pendulum.yaml", &text).unwrap_err();
        let log = log([&faults].into_iter());
        let fix = &log["runs"][0]["results"][0]["fixes"][0];
        has(fix, "fix");
        has(&fix["artifactChanges"][0], "change");
        let replacement = &fix["artifactChanges"][0]["replacements"][0];
        has(replacement, "replacement");
        check_region(&replacement["deletedRegion"]);
        assert_eq!(replacement["insertedContent"]["text"], "substeps");
    }
}
