//! Campaigns that are interrupted, shared out and merged: the statistics are those of one undisturbed run, to the last bit.

use std::path::Path;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

const PENDULUM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/pendulum.yaml");

/// The program with a cache that lives as long as the tests' target folder.
fn nsv(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_nsv"));
    let cache = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cache");
    command.args(arguments).env("NSV_CACHE_DIR", cache);
    command
}

fn output(arguments: &[&str]) -> Output {
    nsv(arguments).output().expect("nsv starts")
}

/// The statistics without the time they took.
fn statistics(arguments: &[&str]) -> Value {
    let output = output(&[arguments, &["--format", "json"]].concat());
    let stderr = String::from_utf8_lossy(&output.stderr);
    let mut document: Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{arguments:?}: {error}: {stderr}"));
    let fields = document.as_object_mut().expect("an object");
    for time in ["wall_s", "steps_per_s"] {
        assert!(fields.remove(time).is_some(), "{time}");
    }
    document
}

/// What is said when it is not done, with exit code 2.
fn refused(arguments: &[&str]) -> String {
    let output = output(arguments);
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty());
    stderr
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in UTF-8")
}

#[test]
fn a_killed_campaign_goes_on_to_the_same_statistics() {
    let folder = tempfile::tempdir().expect("a folder");
    let (state, rows, whole_rows) = (
        folder.path().join("state"),
        folder.path().join("rows.parquet"),
        folder.path().join("whole.parquet"),
    );
    let campaign = ["simulate", PENDULUM, "--runs", "10000", "--horizon", "2"];
    let resumable = [
        &campaign[..],
        &["--checkpoint", text(&state), "--runs-out", text(&rows)],
    ]
    .concat();
    let mut child = nsv(&resumable)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("nsv starts");
    while !state.exists() {
        assert!(child.try_wait().expect("nsv can be asked").is_none());
        std::thread::yield_now();
    }
    child.kill().expect("nsv is killed");
    child.wait().expect("nsv is dead");
    assert!(!rows.exists());

    let again = output(&[&resumable[..], &["--threads", "1"]].concat());
    let said = String::from_utf8_lossy(&again.stderr);
    assert!(again.status.success(), "{said}");
    let done = said
        .split_once("going on after ")
        .and_then(|(_, rest)| rest.split_once(" runs in `"))
        .unwrap_or_else(|| panic!("{said}"));
    let done: u64 = done.0.replace(' ', "").parse().expect("a count");
    assert!((1..10_000).contains(&done), "killed in the middle: {done}");
    // Complete, it only tells what came out.
    let resumed = statistics(&resumable);
    let whole = statistics(&[&campaign[..], &["--runs-out", text(&whole_rows)]].concat());
    assert_eq!(resumed, whole);
    let bytes = |path: &Path| std::fs::read(path).expect("a file");
    assert_eq!(bytes(&rows), bytes(&whole_rows));

    let kept = folder.path().join("state.runs");
    let all = bytes(&kept);
    let mut other = all.clone();
    let header = all.iter().position(|&byte| byte == b'\n').expect("a line");
    other[header - 3] ^= 1;
    let mut missing = all.clone();
    let end = missing.len();
    missing[end - 100..].fill(0);
    for rows in [&other[..], &missing, &all[..end - 1]] {
        std::fs::write(&kept, rows).expect("a file");
        let said = refused(&resumable);
        assert!(
            said.contains("does not have the rows of the runs that are done"),
            "{said}"
        );
        assert!(said.contains("put back the file of rows"), "{said}");
    }
    std::fs::remove_file(&kept).expect("a file");
    assert!(refused(&resumable).contains("is not there"));
    std::fs::write(&kept, &all).expect("a file");

    let other = [&resumable[..], &["--seed", "9"]].concat();
    assert!(refused(&other).contains("is of another campaign: seed is 1, expected 9"));
    let mut damaged = bytes(&state);
    let middle = damaged.len() / 2;
    damaged[middle] ^= 1;
    std::fs::write(&state, damaged).expect("a file");
    assert!(refused(&resumable).contains("is damaged"));
}

#[test]
fn parts_merge_to_the_campaign() {
    let folder = tempfile::tempdir().expect("a folder");
    let parts: Vec<_> = (1..=3)
        .map(|k| folder.path().join(format!("{k}.state")))
        .collect();
    let parts: Vec<&str> = parts.iter().map(|path| text(path)).collect();
    let campaign = ["simulate", PENDULUM, "--runs", "300", "--horizon", "4"];
    for (k, part) in (1..).zip(&parts) {
        let shard = format!("{k}/3");
        let more = ["--shard", &shard, "--checkpoint", part, "--bands"];
        let document = statistics(&[&campaign[..], &more].concat());
        assert_eq!(document["shard"]["part"], k);
    }
    let merge = |order: &[usize]| {
        let files = order.iter().map(|&k| parts[k]);
        ["merge"].into_iter().chain(files).collect::<Vec<_>>()
    };
    let whole = statistics(&campaign);
    assert_eq!(whole["runs"], 300);
    for order in [[0, 1, 2], [2, 0, 1]] {
        assert_eq!(statistics(&merge(&order)), whole);
    }
    assert!(refused(&merge(&[0, 2])).contains("part 2 of 3 is missing"));
    assert!(refused(&merge(&[0, 1, 1, 2])).contains("are both part 2 of 3"));

    // The reports differ only in the command that made them.
    let [one, other] = ["one.html", "other.html"].map(|name| folder.path().join(name));
    statistics(&[&campaign[..], &["--report", text(&one)]].concat());
    statistics(&[&merge(&[1, 0, 2])[..], &["--report", text(&other)]].concat());
    let page = |path: &Path| {
        let page = std::fs::read_to_string(path).expect("a page");
        let (before, rest) = page.split_once("<dt>command</dt>").expect("a command");
        let (_, after) = rest.split_once("</dd>").expect("its end");
        (before.to_owned(), after.to_owned())
    };
    assert_eq!(page(&one), page(&other));
    assert!(page(&one).1.contains("Over 300 runs"));

    let alien = folder.path().join("alien.state");
    let more = [
        "--shard",
        "2/3",
        "--checkpoint",
        text(&alien),
        "--seed",
        "4",
    ];
    statistics(&[&campaign[..], &more].concat());
    let mixed = refused(&["merge", parts[0], text(&alien), parts[2]]);
    assert!(
        mixed.contains("is of another campaign than") && mixed.contains("seed is 4, not 1"),
        "{mixed}"
    );
}

#[test]
fn the_worst_run_replays_as_told() {
    let campaign = ["simulate", PENDULUM, "--runs", "40", "--horizon", "4"];
    let document = statistics(&campaign);
    let worst = &document["worst"][0];
    let replay = document["replay_worst"].as_str().expect("a command");
    let words: Vec<&str> = replay.split(' ').skip(1).collect();
    let alone = statistics(&words);
    assert_eq!(alone["runs"], 1);
    assert_eq!(alone["worst"][0], *worst);
    assert_eq!(alone["ratio"]["max"], worst["ratio"]);
    assert_eq!(document["ratio"]["max"], worst["ratio"]);
}

#[test]
fn options_that_need_each_other_are_named() {
    let shard = ["simulate", PENDULUM, "--shard", "1/2"];
    assert!(refused(&shard).contains("--checkpoint"));
    let wrong = ["simulate", PENDULUM, "--checkpoint", "c", "--shard", "3/2"];
    assert!(refused(&wrong).contains("expected K/N"));
    assert!(refused(&["merge"]).contains("<FILE>"));
    assert!(refused(&["merge", PENDULUM]).contains("is not a checkpoint"));
}
