//! Binary tables: one line of JSON `{"columns": [..], "rows": n}`, then rows of `f64`, little endian.
//!
//! A table is written under a temporary name beside its own and renamed when it is complete, so an interrupted program leaves no file that
//! looks whole.

use std::ffi::OsString;
use std::format;
use std::fs::{self, File};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::string::String;
use std::vec::Vec;

use super::json;

/// A table on its way to disk. Dropped unfinished, it removes what it wrote.
pub(super) struct Table {
    path: PathBuf,
    temporary: PathBuf,
    file: BufWriter<File>,
    columns: String,
    width: usize,
    rows: u64,
}

impl Table {
    /// Opens a table with the given columns.
    pub(super) fn create<S: AsRef<str>>(path: &Path, columns: &[S]) -> io::Result<Self> {
        let temporary = temporary_name(path)?;
        let file = BufWriter::new(File::create(&temporary)?);
        let mut table = Self {
            path: path.to_path_buf(),
            temporary,
            file,
            columns: json::array(columns.iter().map(|name| json::string(name.as_ref()))),
            width: columns.len(),
            rows: 0,
        };
        table.write_header()?;
        Ok(table)
    }

    /// Appends a row.
    pub(super) fn push(&mut self, row: &[f64]) -> io::Result<()> {
        debug_assert_eq!(row.len(), self.width, "invariant: a row fills the columns");
        let bytes: Vec<u8> = row.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.rows += 1;
        self.file.write_all(&bytes)
    }

    /// Completes the header and gives the file its name.
    pub(super) fn finish(mut self) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(0))?;
        self.write_header()?;
        self.file.flush()?;
        fs::rename(&self.temporary, &self.path)
    }

    /// The number of rows is padded, so that its length does not depend on it.
    fn write_header(&mut self) -> io::Result<()> {
        writeln!(
            self.file,
            "{{\"columns\": {}, \"rows\": {:<20}}}",
            self.columns, self.rows
        )
    }
}

impl Drop for Table {
    fn drop(&mut self) {
        // After a rename there is nothing of that name; after a failure the file is of no use, and neither is a second error.
        let _ = fs::remove_file(&self.temporary);
    }
}

/// A name in the same directory, so that the rename stays on one file system; unique among processes.
pub(super) fn temporary_name(path: &Path) -> io::Result<PathBuf> {
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "not a file name"))?;
    let mut temporary = OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.part", process::id()));
    Ok(path.with_file_name(temporary))
}
