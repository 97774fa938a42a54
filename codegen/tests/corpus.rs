//! The committed corpus of the fuzzer, past crashes included, through the entry points that are fuzzed (`tests/fuzz`): nothing panics, nothing takes
//! long.

#[path = "../../tests/fuzz/src/entry.rs"]
mod entry;

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// Longest time for one input, several times what the fuzzer allows in an optimised build on an idle machine.
const MOMENT: Duration = Duration::from_secs(5);

fn replay(target: &str, read: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../tests/fuzz/corpus")
        .join(target);
    let files: Vec<_> = fs::read_dir(&folder).expect("a corpus").collect();
    assert!(files.len() >= 5, "{} has no corpus", folder.display());
    for file in files {
        let path = file.expect("an entry").path();
        let bytes = fs::read(&path).expect("a file");
        let start = Instant::now();
        read(&bytes);
        assert!(start.elapsed() < MOMENT, "{}", path.display());
    }
}

#[test]
fn yaml_is_read() {
    replay("yaml", entry::yaml);
}

#[test]
fn specifications_are_checked() {
    replay("spec", entry::spec);
}

#[test]
fn expressions_are_elaborated() {
    replay("expression", entry::expression);
}

#[test]
fn units_are_converted() {
    replay("unit", entry::unit);
}

#[test]
fn tables_are_loaded() {
    replay("table", entry::table);
}

#[test]
fn exports_are_decoded() {
    replay("export", entry::export);
}

#[test]
fn programs_are_read() {
    replay("program", entry::program);
}
