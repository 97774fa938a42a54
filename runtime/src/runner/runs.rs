//! A row for each run of a campaign, in the order of the runs, whatever the order they are done in.
//!
//! The file has the form of a table, and every row its place in it from the beginning, so nothing waits in memory. It is written in
//! place, beside a checkpoint that says which rows are there; its header says of which campaign it is.

use std::format;
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::string::String;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::vec;

use super::arguments::Request;
use super::checkpoint::{Refusal, identity};
use super::{Failure, json};
use crate::closed_loop::ClosedLoop;
use crate::ensemble::{Rows, State, block_size};

/// The file, open for writing.
pub(super) struct RunTable {
    file: Mutex<File>,
    /// Bytes of the header.
    start: u64,
    /// Bytes of a block.
    block: u64,
}

impl RunTable {
    /// Opens the file of the part of `request`: a new one, or one that has the rows of a state.
    pub(super) fn open<L: ClosedLoop>(
        path: &Path,
        request: &Request,
        state: Option<&State>,
    ) -> Result<Self, Failure> {
        let (campaign, columns) = (&request.campaign, Rows::columns::<L>());
        let runs = request.shard.runs(campaign);
        let header = header(&columns, runs, &identity::<L>(request));
        let row = 8 * columns.len() as u64;
        let failed = |error: io::Error| Failure::File(path.into(), error);
        let file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(state.is_none())
            .truncate(state.is_none())
            .open(path);
        let file = match (file, state) {
            (Err(error), Some(_)) if error.kind() == io::ErrorKind::NotFound => {
                return Err(Failure::Refused(path.into(), Refusal::NoRows));
            }
            (file, _) => file.map_err(failed)?,
        };
        let table = Self {
            file: Mutex::new(file),
            start: header.len() as u64,
            block: row * block_size(campaign),
        };
        match state {
            None => table.begin(&header, row * runs).map_err(failed)?,
            Some(state) => {
                let whole = table.has(&header, request, state).map_err(failed)?;
                if !whole {
                    return Err(Failure::Refused(path.into(), Refusal::OtherRows));
                }
            }
        }
        Ok(table)
    }

    fn begin(&self, header: &str, rows: u64) -> io::Result<()> {
        let mut file = self.file();
        file.write_all(header.as_bytes())?;
        file.set_len(self.start + rows)
    }

    /// Whether the file has this header and a row for every run of a state.
    fn has(&self, header: &str, request: &Request, state: &State) -> io::Result<bool> {
        let (campaign, shard) = (&request.campaign, request.shard);
        let length = self.start + self.block / block_size(campaign) * shard.runs(campaign);
        let mut file = self.file();
        let mut found = vec![0; header.len()];
        if file.metadata()?.len() != length {
            return Ok(false);
        }
        file.read_exact(&mut found)?;
        if found != header.as_bytes() {
            return Ok(false);
        }
        let row = (self.block / block_size(campaign)) as usize;
        for block in (0..shard.blocks(campaign)).filter(|&block| state.has(block)) {
            let runs = shard.runs_of(block, campaign);
            let mut rows = vec![0; row * (runs.end - runs.start) as usize];
            file.seek(SeekFrom::Start(self.start + block * self.block))?;
            file.read_exact(&mut rows)?;
            let numbers = runs.map(|run| campaign.first_run.wrapping_add(run));
            if !rows
                .chunks_exact(row)
                .zip(numbers)
                .all(|(row, run)| is_of(row, run))
            {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Writes the rows of a block of the part.
    pub(super) fn write(&self, block: u64, rows: &Rows<'_>) -> io::Result<()> {
        let bytes = rows.bytes();
        let mut file = self.file();
        file.seek(SeekFrom::Start(self.start + block * self.block))?;
        file.write_all(&bytes)
    }

    /// Waits until everything written is on disk.
    pub(super) fn sync(&self) -> io::Result<()> {
        self.file().sync_data()
    }

    fn file(&self) -> MutexGuard<'_, File> {
        self.file.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn header(columns: &[String], rows: u64, campaign: &str) -> String {
    let columns = json::array(columns.iter().map(|name| json::string(name)));
    let campaign = json::string(campaign);
    format!("{{\"columns\": {columns}, \"rows\": {rows}, \"campaign\": {campaign}}}\n")
}

/// Whether a row was written for this run: a run that has no samples is one that diverged.
fn is_of(row: &[u8], run: u64) -> bool {
    let number = |at: usize| {
        let bytes = row[8 * at..8 * (at + 1)].try_into();
        u64::from_le_bytes(bytes.expect("invariant: eight bytes"))
    };
    number(0) == run && (number(1) > 0 || number(2) > 0)
}
