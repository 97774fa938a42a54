//! The shape of the repository: who may depend on whom, how long a file may be, and what code may not contain.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use nsv_tests::specification::{repository, specifications};
use serde_json::Value;

/// Longest hand-written file, in lines.
const LONGEST_FILE: usize = 500;

/// Packages of the workspace with what they declare to depend on.
fn packages() -> Vec<(String, Vec<(String, String)>)> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args([
            "metadata",
            "--no-deps",
            "--offline",
            "--format-version",
            "1",
        ])
        .current_dir(repository(""));
    let output = cargo.output().unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let metadata: Value = serde_json::from_slice(&output.stdout).unwrap();
    let text = |value: &Value| value.as_str().unwrap_or("normal").to_owned();
    let dependency = |value: &Value| (text(&value["name"]), text(&value["kind"]));
    let package = |value: &Value| {
        (
            text(&value["name"]),
            value["dependencies"]
                .as_array()
                .unwrap()
                .iter()
                .map(dependency)
                .collect::<Vec<_>>(),
        )
    };
    metadata["packages"]
        .as_array()
        .unwrap()
        .iter()
        .map(package)
        .collect()
}

/// The Rust files below a folder of the repository.
fn sources(folder: &str) -> Vec<(PathBuf, String)> {
    let mut pending = vec![repository(folder)];
    let mut sources = Vec::new();
    while let Some(path) = pending.pop() {
        if path.is_dir() {
            pending.extend(path.read_dir().unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            sources.push((path, text));
        }
    }
    assert!(!sources.is_empty(), "{folder} has sources");
    sources
}

/// The code of a line, without its comment.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap()
}

/// Panics if a line of a file contains one of the words.
fn check_absent(path: &Path, text: &str, part: fn(&str) -> &str, words: &[String]) {
    for (number, line) in (1..).zip(text.lines()) {
        for word in words {
            assert!(
                !part(line).contains(word.as_str()),
                "{}:{number} contains `{word}`",
                path.display()
            );
        }
    }
}

#[test]
fn dependencies_point_in_one_direction() {
    let allowed = [
        ("nsv-spec", vec!["nsv-math"]),
        ("nsv-math", vec![]),
        ("nsv-codegen", vec!["nsv-spec", "nsv-math"]),
        ("nsv-runtime", vec!["nsv-math"]),
        ("nsv-generated", vec!["nsv-runtime"]),
        (
            "nsv-tests",
            vec!["nsv-spec", "nsv-codegen", "nsv-runtime", "nsv-generated"],
        ),
    ];
    let packages = packages();
    let own: BTreeSet<&str> = packages.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(own, allowed.iter().map(|(name, _)| *name).collect());
    for (name, dependencies) in &packages {
        let (_, allowed) = allowed.iter().find(|(package, _)| package == name).unwrap();
        for (dependency, kind) in dependencies
            .iter()
            .filter(|(dependency, _)| own.contains(dependency.as_str()))
        {
            assert!(
                allowed.contains(&dependency.as_str()),
                "{name} must not depend on {dependency} ({kind})"
            );
        }
    }
}

/// Flight code needs nothing from a registry.
#[test]
fn flight_code_stands_alone() {
    for (name, dependencies) in packages() {
        let external: Vec<&str> = dependencies
            .iter()
            .filter(|(_, kind)| kind != "dev")
            .map(|(dependency, _)| dependency.as_str())
            .collect();
        match name.as_str() {
            "nsv-math" => assert!(external.is_empty(), "{external:?}"),
            "nsv-runtime" => assert_eq!(external, ["nsv-math"]),
            "nsv-generated" => assert_eq!(external, ["nsv-runtime"]),
            _ => {}
        }
    }
    for library in ["runtime/src/lib.rs", "generated/src/lib.rs"] {
        let text = fs::read_to_string(repository(library)).unwrap();
        for attribute in ["#![no_std]", "#![forbid(unsafe_code)]"] {
            assert!(text.contains(attribute), "{library} has {attribute}");
        }
    }
    let manifest = fs::read_to_string(repository("runtime/Cargo.toml")).unwrap();
    assert!(manifest.contains("default = []"), "std is a choice");
}

#[test]
fn files_are_short_and_finished() {
    // Put together here, so that this file does not contain them.
    let unfinished = [
        "to|do!",
        "unimple|mented!",
        "FIX|ME",
        "TO|DO",
        "X|XX",
        "d|bg!",
    ]
    .map(|word| word.replace('|', ""));
    for folder in ["nsv-spec", "codegen", "runtime", "tests"] {
        for (path, text) in sources(folder) {
            let lines = text.lines().count();
            assert!(
                lines <= LONGEST_FILE,
                "{} has {lines} lines",
                path.display()
            );
            check_absent(&path, &text, |line| line, &unfinished);
        }
    }
}

/// Folders whose code is a function of its arguments.
#[test]
fn disk_processes_and_environment_have_their_places() {
    let outside = [
        "std::fs",
        "fs::",
        "std::process",
        "Command::new",
        "env::var",
        "std::net",
    ];
    let outside = outside.map(str::to_owned);
    let folders = ["derive", "lower", "ir", "opt", "emit", "report"];
    let folders = folders.map(|folder| format!("codegen/src/{folder}"));
    for folder in folders.into_iter().chain(["nsv-spec/src".to_owned()]) {
        for (path, text) in sources(&folder) {
            let tests = path.file_name().is_some_and(|name| name == "tests.rs");
            let tests = tests || path.components().any(|part| part.as_os_str() == "include");
            let compiled = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            if !tests {
                check_absent(&path, compiled, code, &outside);
            }
        }
    }
}

/// Files and folders that the map of the code names are there.
#[test]
fn the_map_of_the_code_leads_somewhere() {
    let map = fs::read_to_string(repository("ARCHITECTURE.md")).unwrap();
    let folders = [
        "nsv-spec/",
        "codegen/",
        "runtime/",
        "generated/",
        "tests/",
        "docs/",
    ];
    let paths: Vec<&str> = map
        .split('`')
        .filter(|part| folders.iter().any(|folder| part.starts_with(folder)) && !part.contains(' '))
        .collect();
    assert!(paths.len() > 20);
    for path in paths {
        assert!(repository(path).exists(), "ARCHITECTURE.md names `{path}`");
    }
}

/// The compiler knows no specification by name.
#[test]
fn the_compiler_has_no_favourite() {
    let names = specifications("specs")
        .into_iter()
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned());
    let names: Vec<String> = names.collect();
    for folder in ["nsv-spec/src", "codegen/src", "runtime/src"] {
        for (path, text) in sources(folder) {
            let compiled = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            check_absent(&path, compiled, code, &names);
        }
    }
}

#[test]
fn emitted_code_cannot_panic_or_allocate() {
    let forbidden = [
        "unsafe",
        "std::",
        "alloc",
        "unwrap",
        "expect(",
        "panic!",
        "assert",
        "unreachable!",
        "Vec",
        "Box",
        "String",
        " as u",
    ];
    let forbidden = forbidden.map(str::to_owned);
    for (path, text) in sources("generated/src") {
        // `Vector` is an array, `SUBSTEPS as f64` a constant; `forbid(unsafe_code)` heads the library.
        let text = text
            .replace("Vector", "")
            .replace("forbid(unsafe_code)", "");
        check_absent(&path, &text, code, &forbidden);
    }
}
