//! `nsv simulate` on a test specification, and what it writes.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

/// Columns of a table by name.
pub(super) type Columns = BTreeMap<String, Vec<f64>>;

/// Runs of a campaign.
const RUNS: usize = 40;

/// The program with a cache that lives as long as the tests' target folder.
fn simulate(name: &str, arguments: &[&str]) {
    let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/specs");
    let cache = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cache");
    let output = Command::new(env!("CARGO_BIN_EXE_nsv"))
        .arg("simulate")
        .arg(specs.join(name).with_extension("yaml"))
        .args(arguments)
        .env("NSV_CACHE_DIR", cache)
        .output()
        .expect("nsv starts");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
}

/// The table that the program writes to the file that follows the arguments.
fn written(name: &str, arguments: &[&str]) -> Columns {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("table.csv");
    let out = path.to_str().expect("a path in UTF-8");
    simulate(name, &[arguments, &[out]].concat());
    columns(&path)
}

/// Columns of a table in CSV.
fn columns(path: &Path) -> Columns {
    let mut reader = csv::Reader::from_path(path).expect("a table");
    let names: Vec<String> = reader
        .headers()
        .expect("a header")
        .iter()
        .map(String::from)
        .collect();
    let mut columns = Columns::new();
    for record in reader.records() {
        for (name, value) in names.iter().zip(&record.expect("a row")) {
            let column = columns.entry(name.clone()).or_default();
            column.push(match value {
                "false" => 0.0,
                number => number.parse().expect("a number"),
            });
        }
    }
    columns
}

/// The telemetry of one run.
pub(super) fn flown(name: &str, run: u64, arguments: &[&str]) -> Columns {
    let run = run.to_string();
    written(name, &[arguments, &["--run", &run, "--out"]].concat())
}

/// The runs of a campaign.
pub(super) fn campaign(name: &str, arguments: &[&str]) -> Columns {
    let runs = RUNS.to_string();
    written(
        name,
        &[arguments, &["--runs", &runs, "--runs-out"]].concat(),
    )
}

/// Panics unless runs of a campaign, which share lanes, have the largest ratios of the runs alone.
pub(super) fn check_campaign(name: &str, arguments: &[&str]) {
    let rows = campaign(name, arguments);
    for at in [0, 7, RUNS - 1] {
        let alone = flown(name, at as u64, arguments);
        let largest = alone["ratio1"].iter().copied().fold(0.0, f64::max);
        assert_eq!(rows["ratio"][at].to_bits(), largest.to_bits(), "run {at}");
    }
}
