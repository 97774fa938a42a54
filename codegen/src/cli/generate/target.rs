//! What generated folders shall hold.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use nsv_codegen::driver::library;
use nsv_codegen::seal::{Seal, inspect};

use super::library::declared;
use crate::cli::failure::{Exit, Failure};

/// Files by path, and the folders in which nothing else may be.
#[derive(Debug, Default)]
pub(super) struct Target {
    /// Every text.
    pub(super) files: BTreeMap<PathBuf, String>,
    /// One folder for each module.
    pub(super) folders: BTreeSet<PathBuf>,
    /// Libraries that are not sealed yet and hold nothing that could be lost.
    pub(super) blank: BTreeSet<PathBuf>,
}

impl Target {
    /// Adds a module below `out`, and declares it in the library there if that is ours.
    pub(super) fn add(
        &mut self,
        out: &Path,
        name: &str,
        title: &str,
        files: BTreeMap<String, String>,
    ) -> Result<(), Failure> {
        let folder = out.join(name);
        self.files.extend(
            files
                .into_iter()
                .map(|(path, text)| (folder.join(path), text)),
        );
        if !self.folders.insert(folder) {
            return Err(Failure::new(
                Exit::Usage,
                format_args!("two specifications are named `{name}`"),
            ));
        }
        let path = out.join("lib.rs");
        let text = match self.files.get(&path) {
            Some(text) => text.clone(),
            None if path.is_file() => read(&path)?,
            None => return Ok(()),
        };
        let Some(mut modules) = declared(&text) else {
            return Ok(());
        };
        match inspect(&text) {
            Seal::Missing if !modules.is_empty() => return Ok(()),
            Seal::Missing => drop(self.blank.insert(path.clone())),
            Seal::Intact | Seal::Broken => {}
        }
        modules.insert(name.to_owned(), title.to_owned());
        self.files.insert(path, library(&modules));
        Ok(())
    }
}

/// The text of a file.
pub(super) fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| Failure::io("read", path, &error))
}
