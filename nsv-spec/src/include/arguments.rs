//! `include: [{file: .., with: {..}}]`: a file with values for what it declares.

use super::Joiner;
use crate::compose::overlay::overlay;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::parse::Reader;
use crate::suggest::nearest;
use crate::vocabulary::INCLUDE;
use crate::yaml::{Entry, Kind, Node, excerpt};

/// Sections whose entries may be given another value.
pub(super) const DECLARING: [&str; 2] = ["constants", "parameters"];

/// One file to include.
pub(super) struct Included {
    /// Its name, relative to the file that includes it.
    pub(super) name: String,
    /// Where that stands.
    pub(super) span: Span,
    /// Values for what it declares.
    pub(super) arguments: Vec<Entry>,
}

impl Joiner<'_> {
    /// The long form of an entry of `include`.
    pub(super) fn long_form(&mut self, node: &Node) -> Option<Included> {
        let mut reader = Reader::default();
        let fields = reader.fields(node, &INCLUDE);
        let arguments = match fields.entry("with") {
            Some(entry) => reader.entries(&entry.value, "a map from names to values"),
            None => Ok(Vec::new()),
        };
        let name = reader.text(&fields, "file");
        self.faults.extend(reader.faults);
        let name = name?.ok()?;
        let arguments = arguments.into_iter().flatten().cloned().collect();
        Some(Included {
            name: name.value,
            span: name.span,
            arguments,
        })
    }

    /// Gives what a joined file declares the values of the arguments.
    pub(super) fn give(&mut self, file: &str, fragment: &mut Node, arguments: Vec<Entry>) {
        let given: Vec<String> = arguments.iter().map(|one| one.key.text.clone()).collect();
        for argument in arguments {
            let (name, span) = (argument.key.text.clone(), argument.key.span);
            if let Some(entry) = declarations(fragment).find(|entry| entry.key.text == name) {
                overlay(&mut entry.value, argument.value, &mut self.faults);
                continue;
            }
            let known: Vec<String> = declarations(fragment)
                .map(|entry| entry.key.text.clone())
                .collect();
            let (shown, file) = (excerpt(&name), excerpt(file));
            let message = format!("`{shown}` is no constant or parameter of `{file}`");
            let otherwise = || match known.is_empty() {
                true => "it declares none".into(),
                false => format!("it declares {}", known.join(", ")),
            };
            self.faults
                .push(Diagnostic::error(Rule::E0031, span, message).did_you_mean(
                    span,
                    &name,
                    nearest(&name, known.iter().filter(|known| !given.contains(known))),
                    otherwise,
                ));
        }
    }
}

/// The constants and parameters of a file.
fn declarations(tree: &mut Node) -> impl Iterator<Item = &mut Entry> {
    let sections = match &mut tree.kind {
        Kind::Map(entries) => entries.as_mut_slice(),
        _ => &mut [],
    };
    sections
        .iter_mut()
        .filter(|section| DECLARING.contains(&section.key.text.as_str()))
        .flat_map(|section| match &mut section.value.kind {
            Kind::Map(entries) => entries.as_mut_slice(),
            _ => &mut [],
        })
}
