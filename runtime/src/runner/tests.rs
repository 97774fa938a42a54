use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;
use std::{env, format, fs, process};

use super::{Failure, run};
use crate::mock::MockLoop;

fn runner(arguments: &[&str], output: &mut impl Write) -> Result<(), Failure> {
    run::<MockLoop<true>>(arguments.iter().map(OsString::from), output)
}

/// The text on standard output.
fn text(arguments: &[&str]) -> String {
    let mut output = Vec::new();
    runner(arguments, &mut output).expect("the runner succeeds");
    String::from_utf8(output).expect("output is text")
}

/// An empty directory of this test process.
fn directory(name: &str) -> PathBuf {
    let directory = env::temp_dir().join(format!("nsv-runner-{}-{name}", process::id()));
    fs::create_dir_all(&directory).expect("a temporary directory can be made");
    directory
}

/// Header and numbers of a table.
fn table(path: &Path) -> (String, Vec<f64>) {
    let bytes = fs::read(path).expect("the table was written");
    let end = bytes
        .iter()
        .position(|&b| b == b'\n')
        .expect("the header ends");
    let number = |chunk: &[u8]| f64::from_le_bytes(chunk.try_into().expect("rows are whole"));
    let numbers = bytes[end + 1..].chunks(8).map(number).collect();
    (String::from_utf8_lossy(&bytes[..end]).into_owned(), numbers)
}

#[test]
fn the_last_line_is_the_result() {
    let output = text(&[
        "--horizon",
        "1",
        "--runs",
        "20",
        "--settle",
        "0.3",
        "--threads",
        "2",
    ]);
    let last = output.lines().last().expect("there is output");
    assert!(
        last.starts_with(r#"{"result": {"runs": 20, "samples": "#),
        "{last}"
    );
    for field in [
        "violated",
        "violated_interval95",
        "ratio",
        "settled_ratio",
        "rms_tracking",
        "saturated_fraction",
        "nonfinite",
        "wall_s",
        "steps_per_s",
    ] {
        assert!(
            last.contains(&format!("\"{field}\": ")),
            "{field} in {last}"
        );
    }
    assert!(last.ends_with("}}") && !last.contains("NaN") && !last.contains("inf"));
    assert!(
        output
            .lines()
            .rev()
            .skip(1)
            .all(|line| line.starts_with(r#"{"progress": ["#))
    );
}

#[test]
fn trajectory_is_a_table_of_the_run() {
    let directory = directory("trajectory");
    let path = directory.join("run.bin");
    text(&[
        "--horizon",
        "0.5",
        "--no-dispersion",
        "--trajectory",
        &path.to_string_lossy(),
        "--trajectory-run",
        "3",
    ]);
    let (header, numbers) = table(&path);
    assert_eq!(
        header.trim_end(),
        r#"{"columns": ["t", "x1.x", "error.x", "ratio1", "u.u", "u_sat.u"], "rows": 51                  }"#
    );
    assert_eq!(numbers.len(), 51 * 6);
    assert_eq!((numbers[0], numbers[1], numbers[50 * 6]), (0.0, 0.5, 0.5));
    assert_eq!(
        fs::read_dir(&directory).expect("it exists").count(),
        1,
        "the temporary file is gone"
    );
    fs::remove_dir_all(directory).expect("it can be removed");
}

#[test]
fn band_is_a_table_over_time() {
    let directory = directory("band");
    let path = directory.join("band.bin");
    text(&[
        "--horizon",
        "0.5",
        "--runs",
        "5",
        "--no-dispersion",
        "--band",
        &path.to_string_lossy(),
    ]);
    let (header, numbers) = table(&path);
    assert!(
        header.contains(
            r#""x1.x:min", "x1.x:p05", "x1.x:p50", "x1.x:p95", "x1.x:max", "x1.x:mean", "error.x:min""#
        ),
        "{header}"
    );
    assert_eq!(numbers.len(), 51 * 25);
    fs::remove_dir_all(directory).expect("it can be removed");
}

#[test]
fn a_file_that_cannot_be_written_is_named() {
    let directory = directory("missing");
    let path = directory.join("no/such.bin");
    let failure = runner(
        &["--horizon", "0.1", "--trajectory", &path.to_string_lossy()],
        &mut Vec::new(),
    )
    .expect_err("the folder does not exist");
    assert_eq!(failure.exit_code(), 1);
    assert!(format!("{failure}").contains("such.bin"));
    assert_eq!(fs::read_dir(&directory).expect("it exists").count(), 0);
    fs::remove_dir_all(directory).expect("it can be removed");
}

#[test]
fn wrong_arguments_exit_with_two() {
    let failure = runner(&["--runs", "x"], &mut Vec::new()).expect_err("x is not a number");
    assert_eq!(failure.exit_code(), 2);
    assert_eq!(
        format!("{failure}"),
        "`--runs` is `x`, expected a whole number of at least 1; --help lists the options"
    );
    assert!(text(&["--help"]).starts_with("Simulates mock."));
}

/// A reader that went away.
struct Closed;

impl Write for Closed {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_closed_pipe_ends_the_campaign() {
    // Far more runs than anyone could wait for: only the first progress line ends them.
    let runs = crate::noise::RUNS.to_string();
    let failure =
        runner(&["--horizon", "1", "--runs", &runs], &mut Closed).expect_err("nobody reads");
    assert!(failure.is_closed_pipe() && failure.exit_code() == 1);
}

const CAMPAIGN: [&str; 9] = [
    "--horizon",
    "0.5",
    "--runs",
    "300",
    "--settle",
    "0.2",
    "--keep-band",
    "--key",
    "k1",
];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&CAMPAIGN[..], more].concat()
}

/// The result line without the time it took.
fn result(arguments: &[&str]) -> String {
    let output = text(arguments);
    let last = output.lines().last().expect("there is output");
    let (statistics, _) = last.split_once(", \"wall_s\"").expect("times come last");
    statistics.to_string()
}

fn refusal(arguments: &[&str]) -> String {
    let mut output = Vec::new();
    let failure = runner(arguments, &mut output).expect_err("it does not fit");
    assert_eq!(failure.exit_code(), 2);
    assert!(String::from_utf8_lossy(&output).starts_with(r#"{"refused": [""#));
    format!("{failure}")
}

#[test]
fn a_checkpoint_is_gone_on_from_or_refused() {
    let directory = directory("checkpoint");
    let path = directory.join("state");
    let state = path.to_string_lossy().into_owned();
    let first = result(&with(&["--checkpoint", &state]));
    assert_eq!(first, result(&CAMPAIGN));
    let output = text(&with(&["--checkpoint", &state]));
    assert!(output.starts_with("{\"resumed\": 300}\n"), "{output}");
    assert_eq!(result(&with(&["--checkpoint", &state])), first);
    let file = fs::read(&path).expect("it was written");
    assert!(file.starts_with(
        b"nsv campaign state 2\nspecification \"\"\nname mock\nsimulator k1\nseed 1\n"
    ));

    let other = with(&["--checkpoint", &state, "--seed", "2", "--no-noise"]);
    let said = refusal(&other);
    assert!(
        said.ends_with(
            "` is of another campaign: seed is 1, expected 2, noise is true, expected false"
        ),
        "{said}"
    );
    for place in [200, file.len() / 2, file.len() - 1] {
        let mut damaged = file.clone();
        damaged[place] ^= 1;
        fs::write(&path, damaged).expect("it can be written");
        assert!(refusal(&with(&["--checkpoint", &state])).contains("is damaged"));
    }
    for (contents, said) in [
        (&file[..file.len() / 2], "is damaged"),
        (b"hello", "is not the state of a campaign"),
        (
            b"nsv campaign state 7\n\n",
            "has version 7 of the format, this program reads version 2",
        ),
    ] {
        fs::write(&path, contents).expect("it can be written");
        assert!(refusal(&with(&["--checkpoint", &state])).contains(said));
    }
    fs::remove_dir_all(directory).expect("it can be removed");
}

#[test]
fn a_state_is_gone_on_with_by_one_program_at_a_time() {
    let directory = directory("claim");
    let path = directory.join("state");
    let state = path.to_string_lossy().into_owned();
    let claim = super::checkpoint::Claim::of(&path).expect("nobody has it");
    let refused = runner(&with(&["--checkpoint", &state]), &mut Vec::new());
    let refused = format!("{}", refused.expect_err("it is claimed"));
    assert!(
        refused.ends_with("is in use by another program"),
        "{refused}"
    );
    drop(claim);
    text(&with(&["--checkpoint", &state]));
    assert!(!directory.join("state.lock").exists());
    fs::remove_dir_all(directory).expect("it can be removed");
}

#[test]
fn shards_merge_to_the_campaign() {
    let directory = directory("shards");
    let parts: Vec<String> = (1..=3)
        .map(|k| {
            directory
                .join(format!("{k}"))
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    for (k, part) in (1..).zip(&parts) {
        text(&with(&["--shard", &format!("{k}/3"), "--checkpoint", part]));
    }
    let merge = |order: &[usize]| {
        let files = order.iter().flat_map(|&k| ["--merge", parts[k].as_str()]);
        with(&files.collect::<Vec<_>>())
    };
    let whole = result(&CAMPAIGN);
    assert_eq!(result(&merge(&[0, 1, 2])), whole);
    assert_eq!(result(&merge(&[2, 0, 1])), whole);
    let missing = runner(&merge(&[0, 2]), &mut Vec::new()).expect_err("a part is missing");
    assert_eq!(
        format!("{missing}"),
        "the parts have 200 runs, the campaign has 300"
    );
    fs::remove_dir_all(directory).expect("it can be removed");
}

#[test]
fn each_run_has_its_row() {
    // What is not a number is equal by its bits.
    let bits = |path: &str| {
        let (header, numbers) = table(Path::new(path));
        (
            header,
            numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>(),
        )
    };
    let directory = directory("rows");
    let [whole, part, again] =
        ["whole", "part", "again"].map(|name| directory.join(name).to_string_lossy().into_owned());
    text(&with(&["--run-table", &whole, "--threads", "3"]));
    let (header, rows) = bits(&whole);
    let expected = r#"{"columns": ["run", "samples", "diverged", "ratio", "settled_ratio", "rms.x", "saturated.u"], "rows": 300, "campaign": ""#;
    assert!(header.starts_with(expected), "{header}");
    assert_eq!(rows.len(), 300 * 7);
    for run in [0, 7, 299] {
        let number = run.to_string();
        let alone = [
            "--horizon",
            "0.5",
            "--settle",
            "0.2",
            "--first-run",
            &number,
            "--run-table",
            &again,
        ];
        text(&alone);
        let (_, row) = bits(&again);
        assert_eq!(row, rows[run * 7..][..7], "run {run}");
    }
    // The second of two parts has every other block of eight.
    let state = directory.join("state").to_string_lossy().into_owned();
    let shard = with(&[
        "--shard",
        "2/2",
        "--checkpoint",
        &state,
        "--run-table",
        &part,
    ]);
    text(&shard);
    let (_, of_part) = bits(&part);
    assert_eq!(of_part[..56], rows[56..112]);
    assert_eq!(of_part[56..112], rows[168..224]);
    // Complete, it stays as it is; gone, it is missed.
    text(&shard);
    assert_eq!(bits(&part).1, of_part);
    fs::remove_file(&part).expect("it can be removed");
    let failure = runner(&shard, &mut Vec::new()).expect_err("its rows are gone");
    assert!(format!("{failure}").contains("part"), "{failure}");
    fs::remove_dir_all(directory).expect("it can be removed");
}
