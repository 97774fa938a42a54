//! The first line of a generated file: a hash of the rest, by which an edit by hand is noticed before it is overwritten.

use std::fmt::Write as _;

use sha2::{Digest, Sha256};

const MARK: &str = "// SHA-256 of the text below: ";

/// What the first line of a file says about the rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seal {
    /// The file is as nsv wrote it.
    Intact,
    /// nsv wrote the file, and somebody changed it.
    Broken,
    /// nsv did not write the file.
    Missing,
}

/// `body` under a first line with its hash.
pub fn seal(body: &str) -> String {
    format!("{MARK}{}\n{body}", hash(body))
}

/// Compares the first line of a file with the rest.
pub fn inspect(text: &str) -> Seal {
    match text
        .strip_prefix(MARK)
        .map(|rest| rest.split_once('\n').unwrap_or((rest, "")))
    {
        Some((recorded, body)) if recorded == hash(body) => Seal::Intact,
        Some(_) => Seal::Broken,
        None => Seal::Missing,
    }
}

fn hash(body: &str) -> String {
    let mut hex = String::new();
    for byte in Sha256::digest(body.as_bytes()) {
        let _ = write!(hex, "{byte:02x}");
    }
    hex
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_changed_character_breaks_the_seal() {
        let text = seal("//! Controller.\npub fn step() {}\n");
        assert_eq!(inspect(&text), Seal::Intact);
        assert_eq!(inspect(&text.replace("step", "stop")), Seal::Broken);
        assert_eq!(inspect(&format!("{text}\n")), Seal::Broken);
        assert_eq!(inspect(MARK), Seal::Broken);
        assert_eq!(inspect("//! Controller.\n"), Seal::Missing);
        assert_eq!(inspect(""), Seal::Missing);
    }
}
