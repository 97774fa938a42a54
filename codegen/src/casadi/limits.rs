//! The limits on what CasADi answers, for the page that lists them.

use super::{decode, environment, exporter, store};

pub(crate) const EXPORT_BYTES: u64 = store::MAX_BYTES;
pub(crate) const OUTPUT_BYTES: usize = exporter::MAX_OUTPUT;
pub(crate) const TAPE_NODES: usize = decode::MAX_NODES;
pub(crate) const SECONDS: u64 = environment::TIMEOUT.as_secs();
