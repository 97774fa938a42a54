//! What a command line or an environment asks that cannot be done: exit code and message.

use std::path::Path;
use std::process::Command;

const PENDULUM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/pendulum.yaml");

fn check(arguments: &[&str], code: i32, said: &str) {
    let output = Command::new(env!("CARGO_BIN_EXE_nsv"))
        .args(arguments)
        .output()
        .expect("nsv starts");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {stderr}");
    assert!(stderr.contains(said), "{arguments:?}: {stderr}");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "", "{arguments:?}");
}

#[test]
fn wrong_usage_is_two() {
    check(&[], 2, "Usage: nsv");
    check(&["simulate"], 2, "SPEC");
    check(&["simulate", "x.yaml", "--runs", "0"], 2, "--runs");
    check(&["simulate", "x.yaml", "--horizon", "-1"], 2, "positive");
    check(&["simulate", "x.yaml", "--out", "run.txt"], 2, ".parquet");
    check(&["simulate", PENDULUM, "--horizon", "1e12"], 2, "steps");
    check(
        &["simulate", PENDULUM, "--out", "/no/such/x.csv"],
        3,
        "/no/such",
    );
    check(&["eval", "x.yaml"], 2, "--at");
    let (most, more) = ("1000000000", "1000000001");
    check(&["simulate", "x.yaml", "--runs", more], 2, "1..=1000000000");
    check(&["simulate", "x.yaml", "--run", most], 2, "0..1000000000");
}

#[test]
fn a_time_to_wait_that_cannot_be_used_is_an_environment_failure() {
    for (arguments, value) in [
        (&["simulate", PENDULUM][..], "1e19"),
        (&["simulate", PENDULUM], "2min"),
        (&["doctor"], "0"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_nsv"))
            .args(arguments)
            .env("NSV_CASADI_TIMEOUT", value)
            .output()
            .expect("nsv starts");
        let said = [output.stdout, output.stderr].concat();
        let said = String::from_utf8_lossy(&said);
        assert_eq!(output.status.code(), Some(3), "{value}: {said}");
        let named = format!("NSV_CASADI_TIMEOUT is `{value}`, expected seconds");
        assert!(said.contains(&named), "{said}");
    }
}

#[test]
fn an_option_without_effect_is_two_and_says_what_is_missing() {
    let missing = "no `--out` or `--report`";
    check(
        &["simulate", "x.yaml", "--runs", "3", "--run", "1"],
        2,
        missing,
    );
    check(&["merge", "x.state", "--run", "1"], 2, missing);
    let example = [
        "explain",
        "E0403",
        "--example",
        "broken",
        "--format",
        "json",
    ];
    check(&example, 2, "without `--example`");
    let defaults = ["check", PENDULUM, "-v", "--format", "sarif"];
    check(&defaults, 2, "no place for the defaults");
}

#[cfg(unix)]
#[test]
fn no_output_replaces_what_is_read() {
    let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let folder = tempfile::tempdir().expect("a folder");
    let link = folder.path().join("link.csv");
    std::os::unix::fs::symlink(specs.join("data/missile_moment.csv"), &link).expect("a link");
    let spec = specs.join("missile_pitch.yaml");
    let [spec, link] = [&spec, &link].map(|path| path.to_str().expect("UTF-8"));
    let arguments = ["simulate", spec, "--runs", "1", "--out", link];
    check(
        &arguments,
        2,
        "which is read, and `--out` are the same file",
    );
}

#[test]
fn a_negative_number_is_told_as_one() {
    for option in ["--seed", "--runs", "--run", "--threads", "--horizon"] {
        check(
            &["simulate", PENDULUM, option, "-1"],
            2,
            "invalid value '-1'",
        );
    }
    let shard = ["simulate", PENDULUM, "--checkpoint", "s", "--shard", "-1/3"];
    check(&shard, 2, "expected K/N");
}
