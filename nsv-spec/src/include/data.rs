//! Reads the files of lookup tables, so that the fingerprint covers them and faults can show their text.

use std::path::Path;

use super::{Joiner, read_capped, reason};
use crate::diagnostic::{Diagnostic, FileId, Rule, Span};
use crate::yaml::{self, Kind, Node, excerpt};

/// Most data files of one specification.
pub(crate) const MAX_DATA_FILES: usize = 64;

impl Joiner<'_> {
    /// Reads every `tables.<name>.file` of one file's tree, which lies in the directory `below`.
    pub(super) fn read_data(&mut self, tree: &Node, below: &Path) {
        for table in values(value(tree, "tables")) {
            let Some(Node {
                kind: Kind::Scalar(scalar),
                span,
            }) = value(table, "file")
            else {
                continue;
            };
            if let Some(file) = self.data_file(&scalar.text, *span, below) {
                self.sources.data.insert(*span, file);
            }
        }
    }

    fn data_file(&mut self, name: &str, span: Span, below: &Path) -> Option<FileId> {
        let path = self.resolve(name, span, below)?;
        if let Some(&file) = self.data.get(&path) {
            return Some(file);
        }
        if self.data.len() >= MAX_DATA_FILES {
            let message = format!("specification has more than {MAX_DATA_FILES} data files");
            self.fault(
                Rule::E0023,
                span,
                message,
                "put several columns into one file",
            );
            return None;
        }
        let bytes = match read_capped(&path) {
            Ok(bytes) => bytes,
            Err(error) => {
                let message = format!("cannot read `{}`: {}", excerpt(name), reason(&error));
                self.fault(
                    Rule::E0021,
                    span,
                    message,
                    "check the name and the permissions of the file",
                );
                return None;
            }
        };
        let file = FileId(u32::try_from(self.sources.files.len()).expect("invariant: few files"));
        let place = self.root.clone().unwrap_or_default().join(below).join(name);
        let text = yaml::text(&bytes, file);
        let shown = text
            .as_ref()
            .map_or_else(|_| "".into(), |text| text.clone());
        self.sources.add(place.display().to_string(), shown);
        match text {
            Ok(_) => {
                self.data.insert(path, file);
                Some(file)
            }
            Err(fault) => {
                // The text is not there to be shown.
                let fault = Diagnostic {
                    span: Some(span),
                    ..*fault
                };
                self.faults.push(fault);
                None
            }
        }
    }
}

/// The value under a key; duplicates are reported when the tree is read.
fn value<'a>(node: &'a Node, key: &str) -> Option<&'a Node> {
    let Kind::Map(entries) = &node.kind else {
        return None;
    };
    let entry = entries.iter().find(|entry| entry.key.text == key)?;
    Some(&entry.value)
}

fn values(node: Option<&Node>) -> Vec<&Node> {
    match node.map(|node| &node.kind) {
        Some(Kind::Map(entries)) => entries.iter().map(|entry| &entry.value).collect(),
        _ => Vec::new(),
    }
}
