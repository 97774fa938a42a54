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
    let folder = tempfile::tempdir().expect("a folder");
    let rustc = folder.path().join("rustc");
    let cache = folder.path().join("cache");
    let mut command = Command::new(env!("CARGO_BIN_EXE_nsv"));
    command.arg("doctor").env("RUSTC", &rustc);
    let simulators = cache.join("simulators");
    let began = || assert_eq!(entries(&simulators), 1);
    interrupted(command.env("NSV_CACHE_DIR", &cache), &rustc, began);
    assert_eq!(entries(&simulators), 0);
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_casadi() {
    let folder = tempfile::tempdir().expect("a folder");
    let python = folder.path().join("python");
    let spec = changed(
        folder.path(),
        "damping*omega/inertia",
        "damping*omega^5/inertia/(1 rad/s)^4",
    );
    let mut command = Command::new(env!("CARGO_BIN_EXE_nsv"));
    command
        .args(["generate", "--out"])
        .arg(folder.path())
        .arg(spec)
        .env("NSV_PYTHON", &python)
        .env("NSV_CACHE_DIR", folder.path().join("cache"));
    interrupted(&mut command, &python, || {});
}

#[cfg(unix)]
#[test]
fn an_interrupt_removes_a_python_environment_that_is_not_complete() {
    let folder = tempfile::tempdir().expect("a folder");
    let bin = folder.path().join("bin");
    std::fs::create_dir(&bin).expect("a folder");
    let spec = changed(
        folder.path(),
        "damping*omega/inertia",
        "damping*omega^5/inertia/(1 rad/s)^4",
    );
    let mut path = std::ffi::OsString::from(&bin);
    path.push(":/usr/bin:/bin");
    let cache = folder.path().join("cache");
    let mut command = Command::new(env!("CARGO_BIN_EXE_nsv"));
    command
        .args(["generate", "--out"])
        .arg(folder.path())
        .arg(spec)
        .env_remove("NSV_PYTHON")
        .env("PATH", path)
        .env("NSV_CACHE_DIR", &cache);
    // The lock file stays.
    let python = cache.join("python");
    let began = || assert_eq!(entries(&python), 2);
    interrupted(&mut command, &bin.join("python3"), began);
    assert_eq!(entries(&python), 1);
}

/// Interrupts `command` when it runs `program`, which hangs; `began` looks at what is there by then.
#[cfg(unix)]
fn interrupted(command: &mut Command, program: &Path, began: impl FnOnce()) {
    use rustix::process::{Pid, Signal, kill_process, test_kill_process};
    let told = program.with_file_name("pid");
    script(
        program,
        &format!(
            "[ \"$1\" = -vV ] && {{ echo rustc 1; exit; }}\necho $$ > '{}.part'\nmv '{0}.part' '{0}'\nexec sleep 600",
            told.display()
        ),
    );
    let mut child = command
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("nsv starts");
    while !told.exists() {
        assert!(
            child.try_wait().expect("nsv can be asked").is_none(),
            "nsv ended early"
        );
        std::thread::yield_now();
    }
    began();
    let pid =
        |text: &str| Pid::from_raw(text.trim().parse().expect("a process id")).expect("not zero");
    let hanging = pid(&std::fs::read_to_string(&told).expect("the script tells its process id"));
    kill_process(pid(&child.id().to_string()), Signal::INT).expect("nsv gets the signal");
    let output = child.wait_with_output().expect("nsv ends");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{stderr}");
    assert!(stderr.contains("whole or as it was"), "{stderr}");
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

/// The pendulum with one text instead of another, in `folder`, beside the stored derivatives.
#[cfg(unix)]
fn changed(folder: &Path, old: &str, new: &str) -> std::path::PathBuf {
    let text = std::fs::read_to_string(PENDULUM).expect("the pendulum");
    assert!(text.contains(old));
    let partials = Path::new(PENDULUM).with_file_name("partials");
    std::os::unix::fs::symlink(partials, folder.join("partials")).expect("a link");
    let path = folder.join("changed.yaml");
    std::fs::write(&path, text.replace(old, new)).expect("a file");
    path
}

#[cfg(unix)]
#[test]
fn a_state_may_have_the_name_of_the_packed_states() {
    let folder = tempfile::tempdir().expect("a folder");
    let spec = changed(folder.path(), "omega", "x");
    let output = with_cache(&[
        "simulate",
        "--horizon=4",
        spec.to_str().expect("a path in UTF-8"),
    ]);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{stderr}");
}

#[cfg(unix)]
#[test]
fn a_pipe_is_no_specification() {
    let folder = tempfile::tempdir().expect("a folder");
    let pipe = folder.path().join("pipe.yaml");
    assert!(
        Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .expect("mkfifo")
            .success()
    );
    let pipe = pipe.to_str().expect("a path in UTF-8");
    check(&["check", pipe], 1, "not a regular file");
}

const PENDULUM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/pendulum.yaml");

/// What nsv says with a cache that lives as long as the tests' target folder.
fn with_cache(arguments: &[&str]) -> Output {
    let cache = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cache");
    let mut command = Command::new(env!("CARGO_BIN_EXE_nsv"));
    command
        .args(arguments)
        .env("NSV_CACHE_DIR", cache)
        .output()
        .expect("nsv starts")
}

fn document(output: &Output) -> serde_json::Value {
    let stderr = String::from_utf8_lossy(&output.stderr);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {stderr}"))
}

#[test]
fn a_sound_specification_is_zero_and_a_faulty_one_is_one() {
    check(&["check", PENDULUM], 0, "ok, 2 blocks of 1 channel");
    let folder = tempfile::tempdir().expect("a folder");
    let faulty = folder.path().join("faulty.yaml");
    std::fs::write(&faulty, "nsv: 1\nname: faulty\nname: again\n").expect("a file");
    let faulty = faulty.to_str().expect("a path in UTF-8");
    check(&["check", faulty], 1, "error[");
    check(
        &["check", "--format", "short", faulty],
        1,
        "faulty.yaml:3:1: error[",
    );
    check(&["simulate", faulty], 1, "error[");
    check(&["check", "/no/such.yaml"], 1, "/no/such.yaml");
    let output = nsv(&["check", "--format", "json", PENDULUM, faulty]);
    assert_eq!((output.status.code(), output.stderr.len()), (Some(1), 0));
    let specs = &document(&output)["specs"];
    assert_eq!(
        (&specs[0]["ok"], &specs[1]["ok"]),
        (&true.into(), &false.into())
    );
    let places = specs[1]["diagnostics"].as_array().expect("a list").iter();
    let mut lines = places.map(|diagnostic| &diagnostic["place"]["start"]["line"]);
    assert!(lines.any(|line| *line == 3), "{specs}");
}

#[test]
fn a_campaign_replays_and_its_runs_stand_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| {
        folder
            .path()
            .join(name)
            .to_str()
            .expect("a path in UTF-8")
            .to_owned()
    };
    let common = ["simulate", PENDULUM, "--horizon", "4", "--format", "json"];
    let run = |more: &[&str]| document(&with_cache(&[&common[..], more].concat()));
    let all = run(&[
        "--runs",
        "20",
        "--run",
        "7",
        "--out",
        &at("all.csv"),
        "--report",
        &at("all.html"),
    ]);
    assert_eq!(
        (&all["spec"], &all["runs"], &all["nonfinite"]),
        (&"pendulum".into(), &20.into(), &0.into())
    );
    assert_eq!(all["horizon_s"], 4.0);
    assert!(
        all["rms_tracking"]["theta"]
            .as_f64()
            .is_some_and(|rms| rms < 0.02),
        "{all}"
    );
    let one = run(&["--run", "7", "--out", &at("one.csv")]);
    assert_eq!(one["runs"], 1);
    assert_eq!(
        std::fs::read(at("all.csv")).expect("a file"),
        std::fs::read(at("one.csv")).expect("a file")
    );
    let page = std::fs::read_to_string(at("all.html")).expect("a file");
    assert!(page.contains("Figure 9") && page.contains("Single-link arm"));
    let threads =
        ["1", "3"].map(|threads| run(&["--runs", "5", "--threads", threads])["ratio"].clone());
    assert_eq!(threads[0], threads[1]);
}

#[test]
fn quantities_are_evaluated_or_the_missing_ones_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("at.json");
    let state = r#"{"t": 0, "x1": [0.1], "x2": [0], "zeta1": [0], "zeta2": [0], "h1": [0], "th2": [0], "W2": [[0], [0], [0], [0], [0], [0]]}"#;
    std::fs::write(&path, state).expect("a file");
    let output = with_cache(&[
        "eval",
        PENDULUM,
        "--at",
        path.to_str().expect("a path in UTF-8"),
    ]);
    let found = document(&output);
    assert_eq!(found["e1"], serde_json::json!([0.1]));
    assert!(found["V"].as_f64().is_some_and(|v| v > 0.0), "{found}");
    let text = String::from_utf8_lossy(&output.stdout);
    let inner = ["e1", "Lam1_filter", "bracket1", "alpha1", "u", "V_W2", "LV"];
    let places = inner.map(|name| text.find(&format!("\n  \"{name}\"")).expect(name));
    assert!(places.is_sorted(), "in the order of the equations: {text}");
    std::fs::write(&path, r#"{"t": 0, "y9": 1}"#).expect("a file");
    let output = with_cache(&[
        "eval",
        PENDULUM,
        "--at",
        path.to_str().expect("a path in UTF-8"),
    ]);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(
        stderr.contains("x1 (a list of 1)") && stderr.contains("unknown: y9"),
        "{stderr}"
    );
}

#[test]
fn generated_code_is_checked_against_its_specification() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a path in UTF-8");
    // A copy: what is generated keeps its derivatives beside the specification.
    let spec = folder.path().join("pendulum.yaml");
    let partials = Path::new(PENDULUM).with_file_name("partials");
    std::fs::copy(PENDULUM, &spec).expect("a copy");
    std::fs::create_dir(folder.path().join("partials")).expect("a folder");
    for entry in std::fs::read_dir(partials).into_iter().flatten().flatten() {
        std::fs::copy(
            entry.path(),
            folder.path().join("partials").join(entry.file_name()),
        )
        .expect("a copy");
    }
    let spec = spec.to_str().expect("a path in UTF-8");
    let run = |more: &[&str]| with_cache(&[&["generate", spec, "--out", out], more].concat());
    assert_eq!(run(&["--check"]).status.code(), Some(4));
    assert_eq!(run(&[]).status.code(), Some(0));
    assert_eq!(run(&["--check"]).status.code(), Some(0));
    let plant = folder.path().join("pendulum/plant.rs");
    let edited = std::fs::read_to_string(&plant).expect("a file") + "// mine\n";
    std::fs::write(&plant, &edited).expect("a file");
    for more in [&["--check"][..], &[]] {
        let output = run(more);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(4), "{stderr}");
        assert!(stderr.contains("plant.rs` was edited by hand"), "{stderr}");
    }
    assert_eq!(std::fs::read_to_string(&plant).expect("a file"), edited);
}

/// Numbers of a table reach neither CasADi nor any file but that of the tables and the one that has the specification's hash.
#[cfg(unix)]
#[test]
fn a_changed_cell_of_a_table_changes_the_tables_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = Path::new(PENDULUM).with_file_name("");
    std::os::unix::fs::symlink(specs.join("partials"), folder.path().join("partials"))
        .expect("a link");
    let data = folder.path().join("data");
    std::fs::create_dir(&data).expect("a folder");
    for file in [
        "missile_pitch.yaml",
        "data/missile_moment.csv",
        "data/missile_normal_force.csv",
    ] {
        std::fs::copy(specs.join(file), folder.path().join(file)).expect("a copy");
    }
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let (spec, out) = (path("missile_pitch.yaml"), path("out"));
    let written = |count: &str| {
        let output = with_cache(&["generate", &spec, "--out", &out]);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(stderr.contains(count), "{stderr}");
    };
    written("8 files, 8 of them written now");
    let table = data.join("missile_moment.csv");
    let text = std::fs::read_to_string(&table).expect("a table");
    std::fs::write(&table, text.replacen("10.215", "10.216", 1)).expect("a table");
    written("8 files, 2 of them written now");
    for name in ["mod.rs", "tables.rs"] {
        let file = Path::new(&out).join("missile_pitch").join(name);
        let generated = Path::new(PENDULUM).with_file_name("../generated/src/missile_pitch");
        let old = std::fs::read_to_string(generated.join(name)).expect("a generated file");
        assert_ne!(
            std::fs::read_to_string(file).expect("a file"),
            old,
            "{name}"
        );
    }
}
