//! A row for each run of a campaign, in the order of the runs, whatever the order they are done in.
//!
//! The file has the form of a table, and every row its place in it from the beginning, so nothing waits in memory. It is written in
//! place, beside a checkpoint that says which rows are there.

use std::format;
use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;
use std::string::String;
use std::sync::{Mutex, PoisonError};
use std::vec;

use super::json;
use crate::closed_loop::ClosedLoop;
use crate::ensemble::{Campaign, Rows, Shard, block_size};

/// The file, open for writing.
pub(super) struct RunTable {
    file: Mutex<File>,
    /// Bytes of the header.
    start: u64,
    /// Bytes of a block.
    block: u64,
}

impl RunTable {
    /// Opens the file of a part of a campaign: a new one, or one that already has rows.
    pub(super) fn open<L: ClosedLoop>(
        path: &Path,
        campaign: &Campaign,
        shard: Shard,
        has_rows: bool,
    ) -> io::Result<Self> {
        let columns = Rows::columns::<L>();
        let header = header(&columns, shard.runs(campaign));
        let row = 8 * columns.len() as u64;
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(!has_rows)
            .truncate(!has_rows)
            .open(path)?;
        if has_rows {
            let mut found = vec![0; header.len()];
            io::Read::read_exact(&mut file, &mut found)?;
            if found != header.as_bytes() {
                return Err(io::Error::other("it has the rows of another campaign"));
            }
        } else {
            file.write_all(header.as_bytes())?;
            file.set_len(header.len() as u64 + row * shard.runs(campaign))?;
        }
        Ok(Self {
            file: Mutex::new(file),
            start: header.len() as u64,
            block: row * block_size(campaign),
        })
    }

    /// Writes the rows of a block of the part.
    pub(super) fn write(&self, block: u64, rows: &Rows<'_>) -> io::Result<()> {
        let bytes = rows.bytes();
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(self.start + block * self.block))?;
        file.write_all(&bytes)
    }

    /// Waits until everything written is on disk.
    pub(super) fn sync(&self) -> io::Result<()> {
        let file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.sync_data()
    }
}

fn header(columns: &[String], rows: u64) -> String {
    let columns = json::array(columns.iter().map(|name| json::string(name)));
    format!("{{\"columns\": {columns}, \"rows\": {rows}}}\n")
}
