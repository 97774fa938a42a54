//! The bytes of a file as text: UTF-8 of moderate size.

use std::sync::Arc;

use crate::diagnostic::{Applicability, Diagnostic, FileId, Rule, Span};

/// Largest file that is read, bytes. The flagship plant with all its aerodynamic data is 30 kB.
pub const MAX_BYTES: usize = 1 << 20;

/// The bytes of a file as text, or why they are none.
pub fn text(bytes: &[u8], file: FileId) -> Result<Arc<str>, Box<Diagnostic>> {
    let at = |byte: usize| {
        let byte = u32::try_from(byte).unwrap_or(u32::MAX);
        Span {
            file,
            start: byte,
            end: byte,
        }
    };
    let fault = |rule, byte, message: String, help: &str| {
        Box::new(Diagnostic::error(rule, at(byte), message).with_help(help))
    };
    if bytes.len() > MAX_BYTES {
        let length = bytes.len();
        return Err(fault(
            Rule::E0001,
            0,
            format!("file has {length} bytes, expected at most {MAX_BYTES}"),
            "move data that is not part of the model out of the specification",
        ));
    }
    let utf8 = "save the file as UTF-8";
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        let message = "file is UTF-16, expected UTF-8".into();
        return Err(fault(Rule::E0002, 0, message, utf8));
    }
    if bytes.starts_with(&[0xef, 0xbb, 0xbf]) {
        let message = "file starts with a byte order mark, expected plain UTF-8".into();
        let help = "save the file as UTF-8 without byte order mark";
        let mark = Span { end: 3, ..at(0) };
        return Err(Box::new(
            fault(Rule::E0003, 0, message, help).with_suggestion(mark, "", Applicability::Certain),
        ));
    }
    std::str::from_utf8(bytes).map(Arc::from).map_err(|error| {
        let byte = error.valid_up_to();
        let message = format!("byte {byte} (0x{:02x}) is not UTF-8", bytes[byte]);
        fault(Rule::E0002, byte, message, utf8)
    })
}
