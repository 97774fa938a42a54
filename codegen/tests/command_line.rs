//! The `nsv` program from outside: exit codes, streams, interruption.

use std::path::Path;
use std::process::{Command, Output, Stdio};

fn nsv(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_nsv"))
        .args(arguments)
        .output()
        .expect("nsv starts")
}

fn check(arguments: &[&str], code: i32, said: &str) {
    let output = nsv(arguments);
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
    check(&["eval", "x.yaml"], 2, "--at");
}

#[test]
fn the_schema_is_json_on_standard_output() {
    let output = nsv(&["schema"]);
    assert!(output.status.success() && output.stderr.is_empty());
    serde_json::from_slice::<serde_json::Value>(&output.stdout).expect("a JSON document");
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_is_quiet() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_nsv"))
        .arg("schema")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("nsv starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("nsv ends");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}

/// A program made of a shell script, written by another process so that no fork of ours holds it open.
#[cfg(unix)]
fn script(path: &Path, body: &str) {
    let writer = r#"printf '#!/bin/sh\n%s\n' "$1" > "$2" && chmod +x "$2""#;
    assert!(
        Command::new("sh")
            .args(["-c", writer, "sh", body])
            .arg(path)
            .status()
            .expect("sh starts")
            .success()
    );
}

#[cfg(unix)]
#[test]
fn doctor_says_what_is_missing() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(env!("CARGO_BIN_EXE_nsv"))
        .arg("doctor")
        .env("NSV_CACHE_DIR", folder.path())
        .env("RUSTC", "/no/such/rustc")
        .output()
        .expect("nsv starts");
    let stdout = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(3), "{stdout}");
    assert!(
        stdout.contains("MISSING")
            && stdout.contains("/no/such/rustc")
            && stdout.contains("rustup"),
        "{stdout}"
    );
}

#[test]
fn doctor_finds_the_toolchain_of_this_test() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(env!("CARGO_BIN_EXE_nsv"))
        .arg("doctor")
        .env("NSV_CACHE_DIR", folder.path())
        .output()
        .expect("nsv starts");
    let stdout = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{stdout}");
    for what in ["cache", "rustc", "cargo", "casadi"] {
        assert!(stdout.contains(what), "{stdout}");
    }
    assert_eq!(
        entries(&folder.path().join("simulators")),
        0,
        "scratch folders are removed"
    );
}

fn entries(folder: &Path) -> usize {
    std::fs::read_dir(folder).map_or(0, |entries| entries.count())
}

/// A compiler that answers `-vV` and then hangs stands for any long work of a child.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_the_children_and_removes_scratch_folders() {
    use rustix::process::{Pid, Signal, kill_process, test_kill_process};
    let folder = tempfile::tempdir().expect("a folder");
    let (rustc, told) = (folder.path().join("rustc"), folder.path().join("pid"));
    script(
        &rustc,
        &format!(
            "[ \"$1\" = -vV ] && {{ echo rustc 1; exit; }}\necho $$ > '{}.part'\nmv '{0}.part' '{0}'\nexec sleep 600",
            told.display()
        ),
    );
    let cache = folder.path().join("cache");
    let mut child = Command::new(env!("CARGO_BIN_EXE_nsv"))
        .arg("doctor")
        .env("NSV_CACHE_DIR", &cache)
        .env("RUSTC", &rustc)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("nsv starts");
    while !told.exists() {
        assert!(
            child.try_wait().expect("nsv can be asked").is_none(),
            "nsv ended early"
        );
        std::thread::yield_now();
    }
    assert_eq!(entries(&cache.join("simulators")), 1);
    let pid =
        |text: &str| Pid::from_raw(text.trim().parse().expect("a process id")).expect("not zero");
    let hanging = pid(&std::fs::read_to_string(&told).expect("the script tells its process id"));
    kill_process(pid(&child.id().to_string()), Signal::INT).expect("nsv gets the signal");
    assert_eq!(child.wait().expect("nsv ends").code(), Some(130));
    assert_eq!(entries(&cache.join("simulators")), 0);
    // The orphan is reaped by init a moment after it is killed.
    while test_kill_process(hanging).is_ok() && alive(hanging.as_raw_nonzero().get()) {
        std::thread::yield_now();
    }
}

/// Whether a process runs, as opposed to waiting for somebody to ask how it ended.
#[cfg(unix)]
fn alive(pid: i32) -> bool {
    let state = std::fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
    state
        .rsplit(") ")
        .next()
        .is_some_and(|rest| !rest.is_empty() && !rest.starts_with('Z'))
}
