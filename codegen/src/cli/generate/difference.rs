//! How generated files on disk differ from what their specifications give.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use nsv_codegen::seal::{Seal, inspect};

use crate::cli::failure::Failure;

/// How a file on disk differs from what its specification gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Difference {
    /// It is not there.
    Missing,
    /// nsv wrote it, from another specification.
    Stale,
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
pub(super) fn compare(
    wanted: &BTreeMap<PathBuf, String>,
    folders: &BTreeSet<PathBuf>,
) -> Result<BTreeMap<PathBuf, Difference>, Failure> {
    let mut differences = BTreeMap::new();
    for (path, text) in wanted {
        if !path.exists() {
            differences.insert(path.clone(), Difference::Missing);
            continue;
        }
        let found = read(path)?;
        let difference = match inspect(&found) {
            _ if found == *text => continue,
            Seal::Intact => Difference::Stale,
            Seal::Broken => Difference::Edited,
            // lib.rs is written by hand except for the line we add.
            Seal::Missing
                if path
                    .parent()
                    .is_some_and(|parent| !folders.contains(parent))
                    && path.ends_with("lib.rs") =>
            {
                Difference::Stale
            }
            Seal::Missing => Difference::Foreign,
        };
        differences.insert(path.clone(), difference);
    }
    for folder in folders {
        for path in sources_in(folder)? {
            if !wanted.contains_key(&path) {
                let difference = if inspect(&read(&path)?) == Seal::Intact {
                    Difference::LeftOver
                } else {
                    Difference::Foreign
                };
                differences.insert(path, difference);
            }
        }
    }
    Ok(differences)
}

fn sources_in(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let failed = |error: &std::io::Error| Failure::io("read", folder, error);
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|error| failed(&error))? {
        let path = entry.map_err(|error| failed(&error))?.path();
        if path.is_dir() {
            files.extend(sources_in(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}

/// The text of a file.
pub(super) fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| Failure::io("read", path, &error))
}
