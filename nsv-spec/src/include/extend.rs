//! `extends`: a specification that is another one with changes.

use std::path::Path;

use super::Joiner;
use crate::compose::overlay::overlay;
use crate::diagnostic::{Applicability, Diagnostic, Rule};
use crate::yaml::{Entry, Kind, Node};

/// What every specification says for itself.
const OWN: [&str; 2] = ["name", "title"];

impl Joiner<'_> {
    /// Lays a tree, joined with what it includes, over the specification that it extends.
    pub(super) fn extend(&mut self, tree: &mut Node, extends: Option<Node>, below: &Path) {
        let Some(node) = extends else {
            return;
        };
        let Some(base) = self.base(&node, below) else {
            self.partial = true;
            return;
        };
        let top = std::mem::replace(tree, base);
        overlay(tree, top, &mut self.faults);
    }

    /// The extended specification, joined with what it includes.
    fn base(&mut self, node: &Node, below: &Path) -> Option<Node> {
        let Kind::Scalar(scalar) = &node.kind else {
            self.faults.push(not_one_name(node));
            return None;
        };
        let path = self.resolve(&scalar.text, node.span, below)?;
        let name = below.join(&scalar.text);
        let mut base = self.file(&name.display().to_string(), &path, node.span)?;
        let Kind::Map(entries) = &mut base.kind else {
            let message = format!("found {}, expected a specification", base.describe());
            let fault = Diagnostic::error(Rule::E0103, base.span, message)
                .with_related(node.span, "extended here")
                .with_help("extend a file with sections such as `plant:`");
            self.faults.push(fault);
            return None;
        };
        entries.retain(|entry| !OWN.contains(&entry.key.text.as_str()));
        self.open.push(path);
        self.join(&mut base, name.parent().unwrap_or(below));
        self.open.pop();
        Some(base)
    }
}

/// The fault of `extends` with something else than a name, mended with the names that it holds.
fn not_one_name(node: &Node) -> Diagnostic {
    let message = format!(
        "found {}, expected the name of one specification",
        node.describe()
    );
    let fault = Diagnostic::error(Rule::E0020, node.span, message);
    let items = match &node.kind {
        Kind::Seq(items) => items.as_slice(),
        _ => &[],
    };
    let name = |item: &Node| matches!(item.kind, Kind::Scalar(_)).then(|| item.flow());
    match items
        .iter()
        .map(name)
        .collect::<Option<Vec<_>>>()
        .as_deref()
    {
        Some([only]) => fault
            .with_help(format!("write `extends: {only}`"))
            .with_suggestion(node.span, only, Applicability::Certain),
        Some([first, ..]) => fault.with_help(format!(
            "write one of them, as in `extends: {first}`; that one may extend another"
        )),
        _ => fault.with_help("write its path, as in `extends: models/base.yaml`"),
    }
}

/// Takes a key out of a tree; a second one stays, and is reported as a duplicate.
pub(super) fn take(tree: &mut Node, key: &str) -> Option<Entry> {
    let Kind::Map(entries) = &mut tree.kind else {
        return None;
    };
    let at = entries.iter().position(|entry| entry.key.text == key)?;
    Some(entries.remove(at))
}
