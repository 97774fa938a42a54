//! The fingerprint of a specification, which generated files open with.

use sha2::{Digest, Sha256};

use crate::diagnostic::SourceMap;

/// SHA-256 over the names and texts of all files, each preceded by its length, in lower-case hex. The first file is named by
/// its last component, so that the fingerprint does not depend on where the specification lies.
pub(crate) fn of(sources: &SourceMap) -> String {
    let mut hasher = Sha256::new();
    for source in &sources.files {
        let name = source.name.rsplit(['/', '\\']).next().unwrap_or_default();
        for part in [name, &source.text] {
            hasher.update((part.len() as u64).to_le_bytes());
            hasher.update(part.as_bytes());
        }
    }
    hasher
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
