//! The bytes of a file as text: UTF-8 of moderate size.

use std::sync::Arc;

use crate::diagnostic::{Applicability, Diagnostic, FileId, Rule, Span};

/// Largest file that is read, bytes. The flagship plant with all its aerodynamic data is 30 kB.
pub const MAX_BYTES: usize = 1 << 20;

/// The bytes of a file as text, or why they are none.
pub fn text(bytes: &[u8], file: FileId) -> Result<Arc<str>, Diagnostic> {
    let start = Span {
        file,
        start: 0,
        end: 0,
    };
    if bytes.len() > MAX_BYTES {
        let message = format!(
            "file has {} bytes, expected at most {MAX_BYTES}",
            bytes.len()
        );
        return Err(Diagnostic::error(Rule::E0001, start, message)
            .with_help("move data that is not part of the model out of the specification"));
    }
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(
            Diagnostic::error(Rule::E0002, start, "file is UTF-16, expected UTF-8")
                .with_help("save the file as UTF-8"),
        );
    }
    if bytes.starts_with(&[0xef, 0xbb, 0xbf]) {
        return Err(Diagnostic::error(
            Rule::E0003,
            start,
            "file starts with a byte order mark, expected plain UTF-8",
        )
        .with_help("save the file as UTF-8 without byte order mark")
        .with_suggestion(Span { end: 3, ..start }, "", Applicability::Certain));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.into()),
        Err(error) => {
            let at = error.valid_up_to();
            let message = format!("byte {at} (0x{:02x}) is not UTF-8", bytes[at]);
            let at = Span {
                file,
                start: at as u32,
                end: at as u32,
            };
            Err(Diagnostic::error(Rule::E0002, at, message).with_help("save the file as UTF-8"))
        }
    }
}
