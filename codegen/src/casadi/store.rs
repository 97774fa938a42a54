//! Exports in a directory, one file for each question: `<key>.json` holds the question and the answer.

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::document::{CASADI_VERSION, Export, Request, SCHEMA};
use super::error::Error;
use super::layout::render;
use super::request;
use crate::whole;

/// Largest export file that is read, in bytes.
pub(super) const MAX_BYTES: u64 = 128 << 20;

/// SHA-256 of a question, in hexadecimal.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key(String);

impl Key {
    pub(crate) fn from_digest(digest: &[u8]) -> Self {
        Self(digest.iter().map(|byte| format!("{byte:02x}")).collect())
    }

    /// The key of a file name `<key>.json`.
    fn from_file_name(name: &str) -> Option<Self> {
        let key = name.strip_suffix(".json")?;
        let hexadecimal = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
        (key.len() == 64 && key.bytes().all(hexadecimal)).then(|| Self(key.to_owned()))
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Export {
    /// The file that holds this export.
    pub fn file_text(&self) -> String {
        render(&serde_json::to_value(self).expect("invariant: an export is JSON"))
    }

    /// The key of the question.
    pub fn key(&self) -> Key {
        request::key(&self.request)
    }
}

/// A directory of exports.
#[derive(Clone, Debug)]
pub struct Store {
    directory: PathBuf,
}

impl Store {
    /// The store in `directory`, which need not exist.
    pub fn new(directory: impl Into<PathBuf>) -> Self {
        Self {
            directory: directory.into(),
        }
    }

    /// The file of a key.
    pub fn path(&self, key: &Key) -> PathBuf {
        self.directory.join(format!("{key}.json"))
    }

    /// The export of a question, if there is one. A file that holds anything else is an error.
    pub fn load(&self, key: &Key, request: &Request) -> Result<Option<Export>, Error> {
        let path = self.path(key);
        let text =
            match fs::metadata(&path).and_then(|metadata| read_bounded(&path, metadata.len())) {
                Ok(text) => text,
                Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
                Err(error) => return Err(Error::Storage { path, error }),
            };
        let invalid = |reason: String| Error::ExportInvalid {
            path: path.clone(),
            reason,
        };
        let export: Export =
            serde_json::from_str(&text).map_err(|error| invalid(error.to_string()))?;
        if export.schema != SCHEMA || export.casadi != CASADI_VERSION {
            return Err(invalid(format!(
                "written for {} with casadi {}",
                export.schema, export.casadi
            )));
        }
        if export.request != *request {
            return Err(invalid("it answers another request".to_owned()));
        }
        Ok(Some(export))
    }

    /// Writes an export under its key, whole or not at all; a file that already has these bytes is left alone.
    pub fn save(&self, export: &Export) -> Result<(), Error> {
        let path = self.path(&export.key());
        let text = export.file_text();
        if fs::read(&path).is_ok_and(|present| present == text.as_bytes()) {
            return Ok(());
        }
        whole::write(&path, text.as_bytes()).map_err(|error| Error::Storage { path, error })
    }

    /// Keys of the exports present.
    pub fn keys(&self) -> Result<BTreeSet<Key>, Error> {
        let storage = |error| Error::Storage {
            path: self.directory.clone(),
            error,
        };
        let entries = match fs::read_dir(&self.directory) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
            Err(error) => return Err(storage(error)),
        };
        let names = entries
            .map(|entry| entry.map(|entry| entry.file_name()))
            .collect::<io::Result<Vec<_>>>()
            .map_err(storage)?;
        Ok(names
            .iter()
            .filter_map(|name| Key::from_file_name(name.to_str()?))
            .collect())
    }
}

fn read_bounded(path: &Path, length: u64) -> io::Result<String> {
    if length > MAX_BYTES {
        return Err(io::Error::new(
            io::ErrorKind::FileTooLarge,
            "file is too large",
        ));
    }
    fs::read_to_string(path)
}
