//! `--set`, sweeps, `nsv fmt` and `nsv new` from outside.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const PENDULUM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/pendulum.yaml");

fn nsv(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_nsv"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("nsv starts")
}

#[track_caller]
fn check(folder: &Path, arguments: &[&str], code: i32, said: &str) {
    let output = nsv(folder, arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {stderr}");
    assert!(stderr.contains(said), "{arguments:?}: {stderr}");
}

#[test]
fn values_can_be_set() {
    let here = Path::new(".");
    let set = |setting| ["check", PENDULUM, "--set", setting];
    check(here, &set("controller.blocks.speed.K=12"), 0, "ok");
    check(
        here,
        &set("controller.blocks.speed.K=12 m"),
        1,
        "command line:1:33",
    );
    check(
        here,
        &set("controller.bloks.speed.K=12"),
        1,
        "did you mean `blocks`?",
    );
    check(here, &set("controller.blocks.speed.K"), 2, "PATH=VALUE");
    check(here, &set("controller=@nowhere.yaml"), 1, "no such file");
    let whole = format!("controller=@{PENDULUM}");
    check(here, &set(&whole), 0, "ok");
}

#[test]
fn every_variant_is_checked_and_options_for_one_campaign_are_refused() {
    let here = Path::new(".");
    let sweep = "scenario.sweep={controller.blocks.speed.K: [12, -1]}";
    let bad = ["check", PENDULUM, "--set", sweep];
    check(here, &bad, 1, "with controller.blocks.speed.K=12: ok");
    check(here, &bad, 1, "with controller.blocks.speed.K=-1: 1 error");
    let output = nsv(
        here,
        &["check", PENDULUM, "--format", "json", "--set", sweep],
    );
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(
        document["specs"][2]["variant"],
        "controller.blocks.speed.K=-1"
    );
    check(here, &["simulate", PENDULUM, "--set", sweep], 1, "-1");
    let good = "scenario.sweep={controller.blocks.speed.K: [12, 14]}";
    let report = ["simulate", PENDULUM, "--set", good, "--report", "x.html"];
    check(here, &report, 2, "`--report` is for one variant");
}

#[test]
fn a_new_specification_checks_clean_and_is_never_overwritten() {
    let folder = tempfile::tempdir().expect("a folder");
    for template in ["arm", "chain", "attitude"] {
        let name = format!("my_{template}");
        let file = format!("{name}.yaml");
        check(
            folder.path(),
            &["new", &name, "--template", template],
            0,
            &file,
        );
        check(folder.path(), &["check", "--deny-warnings", &file], 0, "ok");
        check(folder.path(), &["fmt", "--check", &file], 0, "");
        check(folder.path(), &["new", &name], 2, "is there already");
    }
    check(folder.path(), &["new", "../up"], 2, "snake case");
    check(folder.path(), &["new", "fn"], 2, "fn");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 3);
}

#[test]
fn files_are_laid_out_all_or_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let text = "a:\n    b: [ 1,2 ]   # why\n";
    fs::write(at("a.yaml"), text).expect("a file");
    fs::write(at("bad.yaml"), "a: [").expect("a file");
    check(
        folder.path(),
        &["fmt", "--check", "a.yaml"],
        4,
        "would change",
    );
    check(
        folder.path(),
        &["fmt", "a.yaml", "bad.yaml"],
        1,
        "not valid YAML",
    );
    assert_eq!(fs::read_to_string(at("a.yaml")).expect("a file"), text);
    check(folder.path(), &["fmt", "a.yaml"], 0, "laid out");
    let new = fs::read_to_string(at("a.yaml")).expect("a file");
    assert_eq!(new, "a:\n  b: [1, 2]   # why\n");
}

#[test]
fn each_fault_of_a_sweep_is_told_once_beside_those_of_the_specification() {
    let sweep = "scenario.sweep={controller.blocks.speed.K: [12, -1], controller.blocks.speed.C: [20, fast]}";
    let arguments = [
        "check",
        PENDULUM,
        "--set",
        "plant.inputs.torque=1 N",
        "--set",
        sweep,
    ];
    let output = nsv(Path::new("."), &arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    for fault in ["error[E0407]", "error[E0601]", "error[E0301]"] {
        assert_eq!(stderr.matches(fault).count(), 1, "{fault}: {stderr}");
    }
}
