//! `nsv generate` that shows what the optimiser does instead of writing code.

use std::process::{Command, Output};

use nsv_codegen::ir::Program;

const PENDULUM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/pendulum.yaml");

fn generate(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_nsv"))
        .arg("generate")
        .args(arguments)
        .output()
        .expect("nsv starts")
}

fn shown(arguments: &[&str]) -> String {
    let output = generate(arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
    String::from_utf8(output.stdout).expect("text")
}

fn refused(arguments: &[&str], said: &str) {
    let output = generate(arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains(said), "{stderr}");
}

#[test]
fn any_program_is_shown_at_any_stage_and_reads_back() {
    for which in ["control", "plant", "initial", "lyapunov", "quantities"] {
        for stage in ["lowered", "value_numbering", "optimised"] {
            let text = shown(&[PENDULUM, "--emit=ir", "--program", which, "--stage", stage]);
            let program: Program = text.parse().expect("a program");
            program.assert_sound();
            assert_eq!(program.name, which);
            assert_eq!(program.to_string(), text);
        }
    }
}

#[test]
fn fewer_operations_are_left_from_stage_to_stage() {
    let lines = |more: &[&str]| {
        let text = shown(&[&[PENDULUM, "--emit=ir"], more].concat());
        let statements = text.lines().filter(|line| line.starts_with('%'));
        statements
            .filter(|line| !line.contains(" = const "))
            .count()
    };
    let (lowered, strict) = (lines(&["--stage=lowered"]), lines(&[]));
    assert!(strict < lowered, "{strict} {lowered}");
    assert!(lines(&["--math=fast"]) <= strict);
}

#[test]
fn a_stage_that_does_not_exist_is_refused_with_a_list_of_those_that_do() {
    let unknown = ["--emit=ir", "--stage=inline"];
    refused(&[&[PENDULUM], &unknown[..]].concat(), "lowered, fold, ");
    let only_fast = [PENDULUM, "--emit=ir", "--stage=structural_zeros"];
    refused(&only_fast, "no stage `structural_zeros`");
    shown(&[&only_fast[..], &["--math=fast"]].concat());
    refused(
        &[PENDULUM, PENDULUM, "--emit=ir"],
        "expected one specification",
    );
    refused(&[PENDULUM, "--emit=ir", "--check"], "--check");
    refused(&[PENDULUM, "--stage=lowered"], "--emit");
}

#[test]
fn code_of_another_arithmetic_is_stale() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a path in UTF-8");
    let run = |more: &[&str]| generate(&[&[PENDULUM, "--out", out], more].concat());
    assert_eq!(run(&["--math=fast"]).status.code(), Some(0));
    assert_eq!(run(&["--math=fast", "--check"]).status.code(), Some(0));
    assert_eq!(run(&["--check"]).status.code(), Some(4));
}

#[test]
fn operations_are_explained_by_pass_and_by_equation() {
    let table = shown(&[PENDULUM, "--explain-cost"]);
    for said in [
        "program control",
        "value_numbering (1)",
        "e_1 = x_1 - y_r",
        "by line of the specification",
    ] {
        assert!(table.contains(said), "{said}: {table}");
    }
    let json = shown(&[PENDULUM, "--explain-cost", "--format=json", "--math=fast"]);
    let document: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(document["math"], "fast");
    let control = &document["programs"][0];
    let sum = |when: &str| -> u64 {
        let equations = control["equations"].as_array().expect("a list").iter();
        equations
            .map(|equation| equation[when]["mul"].as_u64().expect("a count"))
            .sum()
    };
    let place = |quantity: &str| {
        let mut equations = control["equations"].as_array().expect("a list").iter();
        let equation = equations.find(|equation| equation["quantity"] == quantity);
        equation.expect("an equation")["spec"]
            .as_str()
            .expect("a place")
    };
    let text = std::fs::read_to_string(PENDULUM).expect("the pendulum");
    let line = |key: &str, nth: usize| {
        let mut found =
            (text.lines().enumerate()).filter(|(_, line)| line.trim_start().starts_with(key));
        found.nth(nth).expect("a key").0 + 1
    };
    for (quantity, key, nth) in [
        ("inertia", "inertia:", 0),
        ("F2", "drift:", 1),
        ("y_r_dot", "reference:", 0),
        ("E1_free", "constraint:", 0),
        ("Lam2_coupling", "eta_3:", 0),
        ("zeta2_next", "C:", 1),
    ] {
        assert!(
            place(quantity).ends_with(&format!("pendulum.yaml:{}", line(key, nth))),
            "{quantity}"
        );
    }
    assert_eq!(control["lowered"]["mul"], sum("before"));
    assert_eq!(control["optimised"]["mul"], sum("after"));
}

/// A quantity that the derivation gains has its line, or is named here.
#[test]
fn every_quantity_of_a_law_has_its_line_in_the_specification() {
    for name in ["nsv_attitude", "chaotic_jerk", "missile_pitch"] {
        let spec = PENDULUM.replace("pendulum", name);
        let json = shown(&[&spec, "--explain-cost", "--format=json"]);
        let document: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        let equations = document["programs"][0]["equations"]
            .as_array()
            .expect("a list");
        for equation in equations
            .iter()
            .filter(|equation| equation["spec"].is_null())
        {
            let quantity = equation["quantity"].as_str().expect("a name");
            assert!(
                ["one", "violated", ""].contains(&quantity),
                "{name}: {quantity}"
            );
        }
    }
}
