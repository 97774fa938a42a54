//! The state of a campaign in a file.
//!
//! Lines of text say which campaign it is: `nsv campaign state 2` with the version of the format, then a line `NAME VALUE` for each of its fields,
//! and an empty line. Then come the statistics as bytes, and a checksum of everything before it. A file is replaced as a whole.

use std::ffi::OsString;
use std::fmt;
use std::format;
use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::str::from_utf8;
use std::string::{String, ToString};
use std::vec::Vec;

use super::Failure;
use super::arguments::Request;
use super::json;
use super::table::temporary_name;
use crate::closed_loop::ClosedLoop;
use crate::ensemble::{Shard, State};

/// First line of a state without the version.
const MAGIC: &str = "nsv campaign state ";

/// Version of the format.
const VERSION: &str = "2";

/// Why a file is no state to go on from.
#[derive(Debug)]
pub(super) enum Refusal {
    Unreadable(io::Error),
    Foreign,
    Version(String),
    Damaged,
    /// Another program is at it.
    InUse,
    /// Fields that differ: name, found, expected.
    Other(Vec<(&'static str, String, String)>),
    /// A part that is to be merged has done so many of its runs.
    Incomplete(u64, u64),
    /// The rows of the state's runs are not there.
    NoRows,
    /// The rows are of another campaign, or some are missing.
    OtherRows,
}

impl Refusal {
    /// What the user can do, who simulates or merges parts.
    pub(super) fn remedy(&self, merges: bool) -> &'static str {
        match self {
            Self::Other(_) if merges => "give the options that it was flown with",
            Self::Incomplete(..) => "start its campaign again to go on",
            _ if merges => "fly this part again",
            Self::Unreadable(_) | Self::Foreign | Self::Damaged | Self::Version(_) => {
                "name another file to start anew"
            }
            Self::InUse => "wait for that program, or name another file",
            Self::Other(_) => {
                "repeat the campaign's own options, or name another file to start anew"
            }
            Self::NoRows | Self::OtherRows => {
                "put back the file of rows that was kept with this state, or name another state to start anew"
            }
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(error) => write!(f, "cannot be read: {error}"),
            Self::Foreign => write!(f, "is not the state of a campaign"),
            Self::Version(found) => write!(
                f,
                "has version {found} of the format, this program reads version {VERSION}"
            ),
            Self::Damaged => write!(f, "is damaged: its contents do not match its checksum"),
            Self::InUse => write!(f, "is in use by another program"),
            Self::Other(fields) => {
                write!(f, "is of another campaign:")?;
                for (index, field) in fields.iter().enumerate() {
                    let comma = if index > 0 { "," } else { "" };
                    write!(f, "{comma} {}", difference(field))?;
                }
                Ok(())
            }
            Self::Incomplete(done, runs) => {
                write!(f, "has only {done} of its {runs} runs")
            }
            Self::NoRows => write!(f, "is not there, with the rows of the runs that are done"),
            Self::OtherRows => write!(f, "does not have the rows of the runs that are done"),
        }
    }
}

/// A field that differs, in words.
fn difference((name, found, expected): &(&str, String, String)) -> String {
    match (*name, found.as_str()) {
        ("simulator", _) => {
            "specification, `--set`, `--math`, nsv or the Rust compiler is another".to_string()
        }
        ("band", "false") => "it was begun without `--bands` or `--report`".to_string(),
        ("band", _) => "it was begun with `--bands` or `--report`".to_string(),
        ("run_table", "false") => "it was begun without `--runs-out`".to_string(),
        ("run_table", _) => "it was begun with `--runs-out`".to_string(),
        _ => format!("{name} is {found}, expected {expected}"),
    }
}

/// The right to go on with a state, which one program has at a time. It ends with the program, however that ends.
#[derive(Debug)]
pub(super) struct Claim {
    path: PathBuf,
    _lock: File,
}

impl Claim {
    /// Claims the state in a file by a lock on a file beside it, for that of the state is replaced.
    pub(super) fn of(state: &Path) -> Result<Claim, Failure> {
        let mut name = OsString::from(state);
        name.push(".lock");
        let path = PathBuf::from(name);
        let lock = File::create(&path).map_err(|error| Failure::File(path.clone(), error))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(Failure::Refused(state.into(), Refusal::InUse));
            }
            // Some file systems have no locks; two programs at one state are then the user's affair.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {}
            Err(TryLockError::Error(error)) => return Err(Failure::File(path, error)),
        }
        Ok(Claim { path, _lock: lock })
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        // What stays behind does no harm.
        let _ = fs::remove_file(&self.path);
    }
}

/// Reads the state that `request` goes on from; `None` if there is no file.
pub(super) fn read<L: ClosedLoop>(
    path: &Path,
    request: &Request,
) -> Result<Option<State>, Refusal> {
    let bytes = match fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(Refusal::Unreadable(error)),
    };
    let (found, payload) = opened(&bytes)?;
    let expected = fields::<L>(request, request.shard);
    compare(&found, &expected, &[])?;
    State::decode::<L>(&request.campaign, request.shard, payload)
        .map(Some)
        .map_err(|_| Refusal::Damaged)
}

/// Reads the complete state of a part of the campaign of `request`.
pub(super) fn read_part<L: ClosedLoop>(path: &Path, request: &Request) -> Result<State, Refusal> {
    let bytes = fs::read(path).map_err(Refusal::Unreadable)?;
    let (found, payload) = opened(&bytes)?;
    compare(
        &found,
        &fields::<L>(request, Shard::WHOLE),
        &["shard", "run_table"],
    )?;
    let shard = found
        .iter()
        .find_map(|(name, value)| (*name == "shard").then(|| shard(value)));
    let shard = shard.flatten().ok_or(Refusal::Damaged)?;
    let state =
        State::decode::<L>(&request.campaign, shard, payload).map_err(|_| Refusal::Damaged)?;
    match (state.runs(), shard.runs(&request.campaign)) {
        (done, runs) if done == runs => Ok(state),
        (done, runs) => Err(Refusal::Incomplete(done, runs)),
    }
}

/// Replaces the file of the state of `request`.
pub(super) fn write<L: ClosedLoop>(
    path: &Path,
    request: &Request,
    state: &mut State,
) -> io::Result<()> {
    let mut text = format!(
        "{MAGIC}{VERSION}\nspecification {}\n",
        json::string(&request.specification)
    );
    for (name, value) in fields::<L>(request, request.shard) {
        text.push_str(&format!("{name} {value}\n"));
    }
    text.push('\n');
    let mut bytes = text.into_bytes();
    bytes.extend(state.encode());
    bytes.extend(checksum(&bytes).to_le_bytes());
    let temporary = temporary_name(path)?;
    let written = File::create(&temporary)
        .and_then(|mut file| file.write_all(&bytes).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        // The file is of no use, and neither is a second error.
        let _ = fs::remove_file(&temporary);
    }
    written
}

/// What tells the campaign of `request` from others, in a few characters.
pub(super) fn identity<L: ClosedLoop>(request: &Request) -> String {
    let mut text = String::new();
    for (name, value) in fields::<L>(request, request.shard) {
        text.push_str(&format!("{name} {value}\n"));
    }
    format!("{:016x}", checksum(text.as_bytes()))
}

/// What makes a campaign the same one. Threads do not.
fn fields<L: ClosedLoop>(request: &Request, shard: Shard) -> Vec<(&'static str, String)> {
    let campaign = &request.campaign;
    [
        ("name", L::NAME.to_string()),
        ("simulator", request.key.clone()),
        ("seed", campaign.seed.to_string()),
        ("first_run", campaign.first_run.to_string()),
        ("runs", campaign.runs.to_string()),
        ("horizon", format!("{:?}", campaign.horizon)),
        ("settle", format!("{:?}", campaign.settle)),
        ("noise", campaign.noise.to_string()),
        ("dispersion", campaign.dispersion.to_string()),
        ("band", campaign.band.to_string()),
        ("run_table", request.run_table.is_some().to_string()),
        ("shard", format!("{}/{}", shard.index + 1, shard.of)),
    ]
    .into()
}

fn shard(text: &str) -> Option<Shard> {
    let (k, of) = text.split_once('/')?;
    let (k, of): (u64, u64) = (k.parse().ok()?, of.parse().ok()?);
    (1..=of).contains(&k).then_some(Shard { index: k - 1, of })
}

/// Names and values at the head of a state.
type Fields<'a> = Vec<(&'a str, &'a str)>;

/// Fields and statistics of a file whose version and checksum are right.
fn opened(bytes: &[u8]) -> Result<(Fields<'_>, &[u8]), Refusal> {
    let rest = bytes
        .strip_prefix(MAGIC.as_bytes())
        .ok_or(Refusal::Foreign)?;
    let version = rest.split(|byte| *byte == b'\n').next().unwrap_or(rest);
    if version != VERSION.as_bytes() {
        return Err(match from_utf8(version) {
            Ok(version) if version.bytes().all(|byte| byte.is_ascii_digit()) => {
                Refusal::Version(version.to_string())
            }
            _ => Refusal::Foreign,
        });
    }
    let (body, sum) = bytes.split_last_chunk().ok_or(Refusal::Damaged)?;
    if u64::from_le_bytes(*sum) != checksum(body) {
        return Err(Refusal::Damaged);
    }
    let end = body.windows(2).position(|pair| pair == b"\n\n");
    let end = end.ok_or(Refusal::Damaged)?;
    let text = from_utf8(&body[..end]).map_err(|_| Refusal::Damaged)?;
    let fields = text.lines().skip(1).filter_map(|line| line.split_once(' '));
    Ok((fields.collect(), &body[end + 2..]))
}

/// The fields must agree, apart from those that may differ.
fn compare(
    found: &[(&str, &str)],
    expected: &[(&'static str, String)],
    free: &[&str],
) -> Result<(), Refusal> {
    let mut other = Vec::new();
    for (name, expected) in expected.iter().filter(|(name, _)| !free.contains(name)) {
        let value = found.iter().find(|(other, _)| other == name);
        let value = value.map_or("missing", |(_, value)| value);
        if value != expected {
            other.push((*name, value.to_string(), expected.clone()));
        }
    }
    if other.is_empty() {
        Ok(())
    } else {
        Err(Refusal::Other(other))
    }
}

/// FNV-1a, 64 bits.
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
