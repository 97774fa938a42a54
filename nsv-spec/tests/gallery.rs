//! Bad specifications: each is refused with exactly the faults that its first line announces, in a moment, and in words that
//! are kept in a snapshot.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use nsv_spec::diagnostic::{Diagnostics, Rule, Severity};
use nsv_spec::{load, load_bytes};

/// Longest time to refuse anything, several times what an unoptimised build takes on an idle machine: this finds hangs, not slowness.
const MOMENT: Duration = Duration::from_secs(5);

/// Faults of a hostile text that is too large to keep in a file.
fn refuse(name: &str, bytes: &[u8], expected: &[&str]) {
    let start = Instant::now();
    let faults = load_bytes(name, bytes).expect_err(name);
    check(name, &faults, start.elapsed(), expected);
}

fn check(name: &str, faults: &Diagnostics, elapsed: Duration, expected: &[&str]) {
    assert!(elapsed < MOMENT, "{name} took {elapsed:?}");
    assert_eq!(codes(faults), expected, "{name}\n{}", faults.short());
    for item in &faults.items {
        assert_eq!(item.severity, Severity::Error);
        assert!(item.help.is_some(), "{name}: every fault has a remedy");
        assert!(
            !item.message.ends_with('.') && !item.message.starts_with(char::is_uppercase),
            "{name}: {}",
            item.message
        );
    }
    insta::assert_snapshot!(name.trim_end_matches(".yaml"), faults.short());
}

fn codes(faults: &Diagnostics) -> Vec<&str> {
    faults.items.iter().map(|item| item.rule.name()).collect()
}

fn gallery() -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = fs::read_dir("tests/bad")
        .expect("the gallery")
        .map(|entry| entry.expect("a directory entry").path())
        .collect();
    files.retain(|path| path.is_file());
    files.sort();
    files
}

#[test]
fn every_bad_specification_is_refused_for_its_own_reason() {
    let files = gallery();
    assert!(files.len() >= 120);
    let mut surprises = String::new();
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        let expected = text
            .lines()
            .next()
            .and_then(|line| line.strip_prefix("# expected: "))
            .expect("an announcement");
        let start = Instant::now();
        let faults = load(&path).expect_err(&path.display().to_string());
        let expected: Vec<&str> = expected.split(' ').collect();
        let name = path.file_name().unwrap().to_str().unwrap();
        match codes(&faults) == expected {
            true => check(name, &faults, start.elapsed(), &expected),
            false => surprises.push_str(&format!(
                "{name}, expected {expected:?}:\n{}",
                faults.short()
            )),
        }
    }
    assert!(surprises.is_empty(), "{surprises}");
}

#[test]
fn a_missing_file_is_reported_without_a_place() {
    let faults = load(Path::new("tests/bad/nowhere.yaml")).unwrap_err();
    assert_eq!(
        faults.short(),
        "error[E0011]: cannot read `tests/bad/nowhere.yaml`: no such file\n"
    );
}

#[test]
fn ten_megabytes_are_refused() {
    refuse(
        "ten_megabytes.yaml",
        "a: 1\n".repeat(2_000_000).as_bytes(),
        &["E0001"],
    );
}

#[test]
fn a_hundred_thousand_brackets_are_refused() {
    refuse("brackets.yaml", "[".repeat(100_000).as_bytes(), &["E0005"]);
    refuse("braces.yaml", "{a: ".repeat(20_000).as_bytes(), &["E0005"]);
    refuse("dashes.yaml", "- ".repeat(100_000).as_bytes(), &["E0005"]);
}

#[test]
fn an_alias_bomb_is_refused() {
    let mut text = String::from("a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n");
    for level in 1..12 {
        let below = format!("*a{}, ", level - 1).repeat(10);
        text.push_str(&format!(
            "a{level}: &a{level} [{}]\n",
            below.trim_end_matches(", ")
        ));
    }
    refuse("alias_bomb.yaml", text.as_bytes(), &["E0006"]);
}

#[test]
fn what_is_not_utf8_is_refused() {
    refuse("byte_order_mark.yaml", b"\xef\xbb\xbfnsv: 1\n", &["E0003"]);
    refuse("utf16.yaml", b"\xff\xfen\0s\0v\0", &["E0002"]);
    refuse("latin1.yaml", b"nsv: 1\ntitle: caf\xe9\n", &["E0002"]);
    refuse("nul.yaml", b"nsv: 1\ntitle: \0\n", &["E0004"]);
}

/// Far more than anyone writes, and thousands of slips.
#[test]
fn ten_thousand_definitions_are_read_in_a_moment() {
    let spec = |definitions: String| {
        let text = fs::read_to_string("tests/bad/wrong_unit.yaml").unwrap();
        text.replace(
            "name: bad\n",
            &format!("name: bad\ndefinitions:\n{definitions}"),
        )
    };
    let chain: String = (1..10_000)
        .map(|i| format!("  a{i}: a{} + x\n", i - 1))
        .collect();
    let texts = [
        spec(format!("  a0: x\n{chain}")),
        spec((0..2_000).map(|i| format!("  a{i}: b{i} + x\n")).collect()),
        spec((0..2_000).map(|i| format!("  a{i}: x +\n")).collect()),
        spec((0..2_000).map(|_| "  a: x\n").collect()),
        spec(format!("  a0: a9999\n{chain}")),
    ];
    for text in texts {
        let start = Instant::now();
        let faults = load_bytes("large.yaml", text.as_bytes()).unwrap_err();
        assert!(
            start.elapsed() < MOMENT,
            "{:?} for {}",
            start.elapsed(),
            faults.items[0].message
        );
    }
}

#[test]
fn deep_and_long_expressions_are_refused() {
    let spec = |drift: &str| {
        fs::read_to_string("tests/bad/wrong_unit.yaml")
            .unwrap()
            .replace("drift: x", &format!("drift: \"{drift}\""))
    };
    let deep = format!("{}x{}", "(".repeat(100_000), ")".repeat(100_000));
    for text in [
        spec(&deep),
        spec(&"x + ".repeat(100_000)),
        spec(&"-".repeat(100_000)),
    ] {
        let start = Instant::now();
        let faults = load_bytes("deep.yaml", text.as_bytes()).unwrap_err();
        assert!(start.elapsed() < MOMENT);
        assert_eq!(faults.items.len(), 1, "{}", faults.short());
    }
}

#[cfg(unix)]
#[test]
fn a_link_out_of_the_directory_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    let inside = directory.path().join("inside");
    fs::create_dir(&inside).unwrap();
    fs::write(directory.path().join("secret.yaml"), "constants: {a: 1}\n").unwrap();
    std::os::unix::fs::symlink(
        directory.path().join("secret.yaml"),
        inside.join("link.yaml"),
    )
    .unwrap();
    let text = fs::read_to_string("tests/bad/include_missing.yaml")
        .unwrap()
        .replace("fragments/nothing.yaml", "link.yaml");
    let path = inside.join("spec.yaml");
    fs::write(&path, text).unwrap();
    let faults = load(&path).unwrap_err();
    assert_eq!(faults.items[0].rule, Rule::E0020);
    assert_eq!(
        faults.items[0].message,
        "path `link.yaml` leads out of the specification's directory through a link"
    );
}

/// A specification cut off anywhere is refused, not fatal.
#[test]
fn no_prefix_of_a_specification_panics() {
    let text = fs::read_to_string("tests/good/pendulum.yaml").unwrap();
    for end in (0..text.len())
        .step_by(7)
        .filter(|&end| text.is_char_boundary(end))
    {
        drop(load_bytes("prefix.yaml", &text.as_bytes()[..end]));
    }
}

/// Neither is one with pieces moved about: each piece makes sense somewhere, which gets it deep into the checks.
#[test]
fn no_shuffled_specification_panics() {
    let rounds = std::env::var("NSV_FUZZ_ROUNDS")
        .ok()
        .and_then(|rounds| rounds.parse().ok())
        .unwrap_or(400);
    let mut texts: Vec<String> = gallery()
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    texts.push(fs::read_to_string("tests/good/pendulum.yaml").unwrap());
    let pieces: Vec<&str> = texts
        .iter()
        .flat_map(|text| text.split_inclusive([' ', ',', '\n', ']', '}', '(']))
        .collect();
    let mut state: u64 = 1;
    let mut below = |bound: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % bound
    };
    for _ in 0..rounds {
        let mut parts: Vec<&str> = texts[below(texts.len())]
            .split_inclusive([' ', ',', '\n', ']', '}', '('])
            .collect();
        for _ in 0..=below(3) {
            let at = below(parts.len());
            parts[at] = pieces[below(pieces.len())];
        }
        drop(load_bytes("shuffled.yaml", parts.concat().as_bytes()));
    }
}
