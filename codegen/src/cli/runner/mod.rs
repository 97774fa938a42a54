//! Generated code as a program: built once for each text, kept in the cache, run as a child process.

mod build;
mod cache;
mod job;
mod package;
mod protocol;
mod toolchain;

pub(crate) use build::{Program, key, prepare};
pub(crate) use cache::Cache;
pub(crate) use job::{Campaign, Job, Part, Recordings, Work};
pub(crate) use package::Package;
pub(crate) use protocol::{Event, Replay, perform};
pub(crate) use toolchain::{INSTALL, Toolchain};
