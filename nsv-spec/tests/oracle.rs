//! Every specification reads to the same tree as with `serde_yaml`, an independent implementation.

use std::fs;
use std::path::{Path, PathBuf};

use nsv_spec::diagnostic::FileId;
use nsv_spec::yaml::{self, Kind, Node};
use serde_yaml::Value;

fn specifications() -> Vec<PathBuf> {
    let mut files = Vec::new();
    for directory in [
        "tests/good",
        "tests/bad/fragments",
        "../specs",
        "../specs/models",
    ] {
        let Ok(entries) = fs::read_dir(directory) else {
            continue;
        };
        files.extend(
            entries
                .map(|entry| entry.expect("a directory entry").path())
                .filter(|path| path.extension().is_some_and(|end| end == "yaml")),
        );
    }
    files.retain(|path| !path.ends_with("broken.yaml"));
    files.sort();
    files
}

fn assert_same(ours: &Node, theirs: &Value, path: &Path) {
    let place = format!("{}: byte {}", path.display(), ours.span.start);
    match (&ours.kind, theirs) {
        (Kind::Null, Value::Null) => {}
        (Kind::Scalar(ours), Value::String(theirs)) => assert_eq!(ours.text, *theirs, "{place}"),
        (Kind::Scalar(ours), Value::Number(theirs)) => {
            let ours: f64 = ours.text.parse().expect(&place);
            assert_eq!(Some(ours), theirs.as_f64(), "{place}");
        }
        (Kind::Scalar(ours), Value::Bool(theirs)) => {
            assert_eq!(ours.text, theirs.to_string(), "{place}")
        }
        (Kind::Seq(ours), Value::Sequence(theirs)) => {
            assert_eq!(ours.len(), theirs.len(), "{place}");
            ours.iter()
                .zip(theirs)
                .for_each(|(ours, theirs)| assert_same(ours, theirs, path));
        }
        (Kind::Map(ours), Value::Mapping(theirs)) => {
            assert_eq!(ours.len(), theirs.len(), "{place}");
            for (ours, (key, value)) in ours.iter().zip(theirs) {
                assert_eq!(Some(ours.key.text.as_str()), key.as_str(), "{place}");
                assert_same(&ours.value, value, path);
            }
        }
        (ours, theirs) => panic!("{place}: {ours:?} is not {theirs:?}"),
    }
}

#[test]
fn both_readers_agree() {
    let files = specifications();
    assert!(!files.is_empty());
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        let ours = yaml::read(&text, FileId(0)).unwrap();
        assert_same(&ours, &serde_yaml::from_str(&text).unwrap(), &path);
    }
}
