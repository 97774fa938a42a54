//! Diagnostics from outside: formats, changes applied to files, explanations.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn nsv(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_nsv"))
        .args(arguments)
        .output()
        .expect("nsv starts")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// The smallest specification with changes, in a file.
fn write(directory: &Path, changes: &[(&str, &str)]) -> String {
    let base = nsv_spec::diagnostic::explain::BASE.to_owned();
    let spec = changes.iter().fold(base, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let path = directory.join("cart.yaml");
    fs::write(&path, spec).expect("a specification");
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn what_is_certain_is_mended_in_every_file() {
    let directory = tempfile::tempdir().unwrap();
    let path = write(
        directory.path(),
        &[
            (
                "name: cart\n",
                "name: Cart # \u{fc}\ninclude: [data.yaml]\n",
            ),
            ("1 m/s}", "lenght/(2 s)}"),
            ("{K: 1,", "{Kp: 1_0,"),
        ],
    );
    let data = directory.path().join("data.yaml");
    fs::write(&data, "constants: {length: 2 meters}\n").unwrap();
    let output = nsv(&["check", "--fix", &path]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert_eq!(said.matches(": fixed `").count(), 5, "{said}");
    assert_eq!(
        fs::read_to_string(&data).unwrap(),
        "constants: {length: 2 m}\n"
    );
    let mended = fs::read_to_string(&path).unwrap();
    assert!(
        mended.contains("name: cart # \u{fc}\n") && mended.contains("{K: 10,"),
        "{mended}"
    );
    assert!(mended.contains("{v: length/(2 s)}"), "{mended}");
    assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 2);
}

#[test]
fn what_is_only_possible_is_left_and_shown() {
    let directory = tempfile::tempdir().unwrap();
    let path = write(
        directory.path(),
        &[
            ("substeps", "substep"),
            ("reference: {v:", "reference: {x:"),
        ],
    );
    let output = nsv(&["check", "--fix", "--format", "short", &path]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("fixed `substep` -> `substeps`"), "{said}");
    assert!(
        said.contains("possible fix: ") && said.contains("`x` -> `v`"),
        "{said}"
    );
    assert!(
        fs::read_to_string(&path)
            .unwrap()
            .contains("reference: {x:")
    );
}

#[test]
fn a_sound_file_is_not_touched() {
    let directory = tempfile::tempdir().unwrap();
    let path = write(directory.path(), &[]);
    let before = fs::metadata(&path).unwrap().modified().unwrap();
    assert_eq!(nsv(&["check", "--fix", &path]).status.code(), Some(0));
    assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), before);
}

#[cfg(unix)]
#[test]
fn permissions_survive_a_fix() {
    use std::os::unix::fs::PermissionsExt as _;
    let directory = tempfile::tempdir().unwrap();
    let path = write(directory.path(), &[("substeps", "substep")]);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    assert_eq!(nsv(&["check", "--fix", &path]).status.code(), Some(0));
    let mode = fs::metadata(&path).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[test]
fn programs_get_places_labels_and_changes() {
    let directory = tempfile::tempdir().unwrap();
    let path = write(directory.path(), &[("limit: 5 N", "limit: 5 KN")]);
    let output = nsv(&["check", "--format", "json", &path]);
    assert_eq!(output.status.code(), Some(1));
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    let fault = &document["specs"][0]["diagnostics"][0];
    assert_eq!(fault["code"], "E0401");
    assert_eq!(fault["suggestion"]["replacement"], "kN");
    assert_eq!(fault["suggestion"]["applicability"], "certain");
    assert_eq!(fault["place"]["start"]["line"], 10);
    let output = nsv(&["check", "--format", "sarif", &path]);
    assert_eq!(output.status.code(), Some(1));
    let log: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(log["runs"][0]["results"][0]["ruleId"], "E0401");
}

#[test]
fn warnings_fail_on_request_only() {
    let directory = tempfile::tempdir().unwrap();
    let path = write(
        directory.path(),
        &[("plant:\n", "constants: {mass: 2 kg}\nplant:\n")],
    );
    let output = nsv(&["check", &path]);
    assert_eq!(output.status.code(), Some(0));
    assert!(text(&output.stderr).contains("warning[W0002]"));
    let denied = nsv(&["check", "--deny-warnings", &path]);
    assert_eq!(denied.status.code(), Some(1));
}

#[test]
fn codes_are_explained_and_listed() {
    let output = nsv(&["explain", "e0403"]);
    assert!(output.status.success());
    assert!(text(&output.stdout).starts_with("E0403: operands of different units\n"));
    let list = text(&nsv(&["explain"]).stdout);
    assert!(
        list.contains("E0101  unknown key\n") && list.contains("W0002"),
        "{list}"
    );
    let output = nsv(&["explain", "E0101", "--format", "json"]);
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(document["severity"], "error");
    let unknown = nsv(&["explain", "E0403x"]);
    assert_eq!(unknown.status.code(), Some(2));
    assert!(text(&unknown.stderr).contains("did you mean `E0403`?"));
}
