//! Generated code as a program: built once for each text, kept in the cache, run as a child process.

mod build;
mod cache;
mod package;
mod protocol;
mod toolchain;

pub(crate) use build::prepare;
pub(crate) use cache::Cache;
pub(crate) use package::Package;
pub(crate) use protocol::{Campaign, Recordings, Replay, simulate};
pub(crate) use toolchain::{INSTALL, Toolchain};
