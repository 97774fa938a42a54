//! The page of limits: those of the reader, and those of what comes back from CasADi.

use crate::casadi::limits::{EXPORT_BYTES, OUTPUT_BYTES, SECONDS, TAPE_NODES};

/// The page in Markdown.
pub fn limits_reference() -> String {
    format!(
        "{}\n## What CasADi answers\n\nA tape is untrusted as a specification is: it is decoded node by node, and what does not fit its question is an \
         error.\n\n| what | most |\n|---|---|\n| bytes of a stored export | {EXPORT_BYTES} |\n| bytes of an answer | {OUTPUT_BYTES} |\n\
         | operations of a tape | {TAPE_NODES} |\n| seconds for an answer, unless `NSV_CASADI_TIMEOUT` says otherwise | {SECONDS} |\n",
        nsv_spec::limits::limits_reference()
    )
}
