//! How generated files on disk differ from what their specifications give.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use nsv_codegen::seal::{Seal, inspect};

use super::target::{Target, read};
use crate::cli::failure::Failure;

/// How a file on disk differs from what its specification gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Difference {
    /// It is not there.
    Missing,
    /// nsv wrote it, from another specification.
    Stale,
    /// nsv wrote it, with the other `--math`.
    OtherMath,
    /// nsv wrote it, and no longer does.
    LeftOver,
    /// nsv wrote it, and somebody changed it.
    Edited,
    /// Somebody else wrote it.
    Foreign,
}

impl Difference {
    /// What is wrong with the file.
    pub(super) fn words(self) -> &'static str {
        match self {
            Difference::Missing => "is missing",
            Difference::Stale => "is stale",
            Difference::OtherMath => "was generated with the other `--math`",
            Difference::LeftOver => "is left over from another version of the specification",
            Difference::Edited => "was edited by hand",
            Difference::Foreign => "was not written by nsv",
        }
    }

    /// Whether overwriting loses somebody's work.
    pub(super) fn precious(self) -> bool {
        matches!(self, Difference::Edited | Difference::Foreign)
    }
}

/// Every file that is not as it should be.
pub(super) fn compare(target: &Target) -> Result<BTreeMap<PathBuf, Difference>, Failure> {
    let mut differences = BTreeMap::new();
    for (path, text) in &target.files {
        let found = if path.exists() {
            Some(read(path)?)
        } else {
            None
        };
        let difference = match found {
            None => Difference::Missing,
            Some(found) if found == *text => continue,
            Some(found) => match inspect(&found) {
                Seal::Intact if is_fast(&found) != is_fast(text) => Difference::OtherMath,
                Seal::Intact => Difference::Stale,
                Seal::Broken => Difference::Edited,
                Seal::Missing if target.blank.contains(path) => Difference::Stale,
                Seal::Missing => Difference::Foreign,
            },
        };
        differences.insert(path.clone(), difference);
    }
    for folder in &target.folders {
        for path in sources(folder)?
            .into_iter()
            .filter(|path| !target.files.contains_key(path))
        {
            let difference = match inspect(&read(&path)?) {
                Seal::Intact => Difference::LeftOver,
                Seal::Broken => Difference::Edited,
                Seal::Missing => Difference::Foreign,
            };
            differences.insert(path, difference);
        }
    }
    Ok(differences)
}

/// Whether the header of a generated file says that its arithmetic is `--math fast`.
fn is_fast(text: &str) -> bool {
    let mut header = text.lines().take_while(|line| line.starts_with("//"));
    header.any(|line| line.starts_with("// math fast"))
}

/// Every Rust file below a folder that may not be there.
fn sources(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let failed = |error: std::io::Error| Failure::io("read", folder, &error);
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_dir() {
            files.extend(sources(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}
