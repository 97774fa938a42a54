//! Reads maps by the keys that the vocabulary knows.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::spec::{Declared, Located, Named, Read, Unreadable, Word};
use crate::suggest::{abbreviated, nearest};
use crate::vocabulary::{Key as Known, Kind as Expects, Section, places_of};
use crate::yaml::{Entry, Key, Kind, Node, excerpt};

/// Keys that name files with further keys.
const JOINING: [&str; 2] = ["include", "extends"];

/// The known keys of one map.
pub(crate) struct Fields<'a> {
    section: &'static Section,
    entries: BTreeMap<&'static str, &'a Entry>,
    /// Whether every key that is given is among them.
    pub(crate) complete: bool,
    /// Whether those are that are given with a map or with files, which may declare names.
    pub(crate) maps_complete: bool,
    /// The whole map.
    pub(crate) span: Span,
}

impl<'a> Fields<'a> {
    /// The entry of a key, which must be in the section's vocabulary.
    pub(crate) fn entry(&self, name: &str) -> Option<&'a Entry> {
        debug_assert!(
            self.key(name).is_some(),
            "invariant: `{name}` is a key of {}",
            self.section.noun
        );
        self.entries.get(name).copied()
    }

    /// Whether a key may be left out and is.
    pub(crate) fn left_out(&self, name: &str) -> bool {
        let Some(key) = self.key(name) else {
            return false;
        };
        let complete = match key.has_map() {
            true => self.maps_complete,
            false => self.complete,
        };
        complete && !key.required && self.entry(name).is_none()
    }

    /// Places of the keys that are given.
    pub(crate) fn keys(&self) -> BTreeMap<&'static str, Span> {
        let entries = self.entries.iter();
        entries
            .map(|(name, entry)| (*name, entry.key.span))
            .collect()
    }

    /// What the vocabulary says of a key.
    pub(crate) fn key(&self, name: &str) -> Option<&'static Known> {
        self.section.keys.iter().find(|key| key.name == name)
    }
}

/// Collects the faults of a specification while it is read.
#[derive(Default)]
pub(crate) struct Reader {
    pub(crate) faults: Vec<Diagnostic>,
    /// Whether a file or a map could not be read: what is missing may stand there.
    pub(crate) partial: bool,
    /// The key of each value, by the place of the value.
    keys: BTreeMap<Span, Key>,
    /// Values that end at a comma of their own expression.
    pub(super) cut: BTreeSet<Span>,
}

impl Reader {
    pub(crate) fn fault(
        &mut self,
        rule: Rule,
        span: Span,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.faults
            .push(Diagnostic::error(rule, span, message).with_help(help));
    }

    /// The keys of a map: none unknown, none twice, all required ones there.
    pub(crate) fn fields<'a>(&mut self, node: &'a Node, section: &'static Section) -> Fields<'a> {
        let mut fields = Fields {
            section,
            entries: BTreeMap::new(),
            complete: !self.partial,
            maps_complete: !self.partial,
            span: node.span,
        };
        let Kind::Map(entries) = &node.kind else {
            let expected = format!("{}: a map", section.noun);
            self.kind(node, &expected, &in_words(section));
            (fields.complete, fields.maps_complete) = (false, false);
            return fields;
        };
        let mut unknown = Vec::new();
        for entry in self.unique(entries) {
            match fields.key(&entry.key.text) {
                Some(key) => drop(fields.entries.insert(key.name, entry)),
                None => unknown.push(entry),
            }
        }
        for entry in unknown {
            self.unknown(entry, &mut fields);
        }
        if !self.partial {
            let own = self.keys.get(&node.span);
            let first = entries.first().map(|first| first.key.span);
            let span = own.map(|key| key.span).or(first).unwrap_or(node.span);
            self.report_missing(&fields, span);
        }
        fields
    }

    fn report_missing(&mut self, fields: &Fields<'_>, span: Span) {
        let missing = |key: &&Known| key.required && !fields.entries.contains_key(key.name);
        for key in fields.section.keys.iter().filter(missing) {
            let message = format!("key `{}` is missing in {}", key.name, fields.section.noun);
            let help = format!("add `{}`: {}", key.name, key.doc);
            self.fault(Rule::E0104, span, message, help);
        }
    }

    /// The keys of the map under a key; none where that is missing, which has been reported if it is required.
    pub(crate) fn section<'a>(&mut self, parent: &Fields<'a>, name: &str) -> Fields<'a> {
        let Some(Known {
            kind: Expects::Section(section),
            ..
        }) = parent.key(name)
        else {
            unreachable!(
                "invariant: `{name}` is a section of {}",
                parent.section.noun
            )
        };
        match parent.entry(name) {
            Some(entry) => self.fields(&entry.value, section),
            None => Fields {
                section,
                entries: BTreeMap::new(),
                complete: false,
                maps_complete: false,
                span: parent.span,
            },
        }
    }

    /// Reports an unknown key. If it is meant for one that is not given, its value is read as that key's, so that the missing
    /// key is no second fault.
    fn unknown<'a>(&mut self, entry: &'a Entry, fields: &mut Fields<'a>) {
        let (section, text) = (fields.section, &entry.key.text);
        // A key that another file gives can be meant too: that is what the two are laid over each other for.
        let open = section.keys.iter().filter(|key| {
            let given = fields.entries.get(key.name);
            given.is_none_or(|given| given.key.span.file != entry.key.span.file)
        });
        let open: Vec<&str> = open.map(|key| key.name).collect();
        let short = abbreviated(text, open.iter().copied());
        let mut meant = short.or_else(|| nearest(text, &open));
        let key = meant.as_ref().and_then(|meant| fields.key(&meant.name));
        // `eta_1` and `eta_4` are two things.
        let digits = |text: &str| -> String { text.chars().filter(char::is_ascii_digit).collect() };
        let key = key.filter(|key| digits(key.name) == digits(text));
        if let (Some(meant), Some(key)) = (&mut meant, key) {
            meant.sure |= key.required;
            fields.entries.entry(key.name).or_insert(entry);
        }
        // A map with names, or files that have some.
        let joins = section.keys.iter().any(|key| JOINING.contains(&key.name));
        let holds_names = match &entry.value.kind {
            Kind::Scalar(scalar) => joins && scalar.text.ends_with(".yaml"),
            Kind::Seq(_) => joins,
            Kind::Map(_) => section.keys.iter().any(Known::has_map),
            Kind::Null => false,
        };
        fields.complete &= key.is_some();
        fields.maps_complete &= key.is_some() || !holds_names;
        // Files are joined before keys are read.
        self.partial |= key.map_or(holds_names, |key| JOINING.contains(&key.name));
        let message = format!("unknown key `{}` in {}", excerpt(text), section.noun);
        let fault = Diagnostic::error(Rule::E0101, entry.key.span, message);
        let names: Vec<&str> = section.keys.iter().map(|key| key.name).collect();
        let otherwise = || {
            let keys = format!("{} has the keys {}", section.noun, list(&names));
            match places_of(text).as_slice() {
                [] if section.keys.iter().any(|key| key.required) => {
                    format!("remove it, or make it a comment; {keys}")
                }
                [] => keys,
                places => format!("it is a key of {}; {keys}", places.join(" or ")),
            }
        };
        self.faults
            .push(fault.did_you_mean(entry.key.span, text, meant, otherwise));
    }

    /// The entries of a map with names chosen by the user.
    pub(crate) fn entries<'a>(&mut self, node: &'a Node, expected: &str) -> Read<Vec<&'a Entry>> {
        let Kind::Map(entries) = &node.kind else {
            self.kind(node, expected, "write one `name: value` on each line");
            return Err(Unreadable);
        };
        Ok(self.unique(entries))
    }

    /// A map from names to values that `read` reads.
    pub(crate) fn map<T>(
        &mut self,
        fields: &Fields<'_>,
        key: &str,
        mut read: impl FnMut(&mut Self, &Node) -> T,
    ) -> Declared<T> {
        let Some(entry) = fields.entry(key) else {
            return Declared {
                all: Vec::new(),
                complete: fields.left_out(key),
                span: fields.span,
            };
        };
        let entries = self.entries(&entry.value, &format!("a map from names to {key}"));
        let complete = entries.is_ok() && !self.partial;
        let declared = |entry: &Entry| Named {
            name: name(entry),
            value: read(self, &entry.value),
        };
        Declared {
            all: entries.into_iter().flatten().map(declared).collect(),
            complete,
            span: entry.key.span,
        }
    }

    /// A nested map, read by `read`, with the place of its key.
    pub(crate) fn nested<T>(
        &mut self,
        fields: &Fields<'_>,
        key: &str,
        read: fn(&mut Self, &Node) -> T,
    ) -> Option<Located<T>> {
        let entry = fields.entry(key)?;
        Some(Located {
            value: read(self, &entry.value),
            span: entry.key.span,
        })
    }

    /// The items of a list; none where it may be left out and is.
    pub(crate) fn items<'a>(
        &mut self,
        fields: &Fields<'a>,
        key: &str,
        expected: &str,
    ) -> Read<&'a [Node]> {
        match fields.entry(key).map(|entry| &entry.value) {
            None if fields.left_out(key) => Ok(&[]),
            None => Err(Unreadable),
            Some(Node {
                kind: Kind::Seq(items),
                ..
            }) => match self.in_pieces(items) {
                false => Ok(items),
                true => Err(Unreadable),
            },
            Some(other) => {
                self.kind(
                    other,
                    expected,
                    "write `[.., ..]`, or one `- item` on each line",
                );
                Err(Unreadable)
            }
        }
    }

    /// Each key once; repeated ones are reported with both places.
    fn unique<'a>(&mut self, entries: &'a [Entry]) -> Vec<&'a Entry> {
        let mut first: BTreeMap<&str, Span> = BTreeMap::new();
        let mut kept = Vec::new();
        let mut cut = false;
        for (at, entry) in entries.iter().enumerate() {
            let is_empty = |entry: &Entry| entry.value.kind == Kind::Null;
            if cut && is_empty(entry) {
                cut = depth(&entry.key.text) >= 0;
                continue;
            }
            let mut rest = entries[at + 1..].iter().take_while(|entry| is_empty(entry));
            cut = is_open(&entry.value) && rest.any(|entry| depth(&entry.key.text) < 0);
            if cut {
                self.report_cut(&entry.value);
            }
            self.keys.insert(entry.value.span, entry.key.clone());
            match first.get(entry.key.text.as_str()) {
                None => {
                    first.insert(&entry.key.text, entry.key.span);
                    kept.push(entry);
                }
                Some(earlier) => self.faults.push(
                    Diagnostic::error(
                        Rule::E0102,
                        entry.key.span,
                        format!("key `{}` is given twice", excerpt(&entry.key.text)),
                    )
                    .with_related(*earlier, "first given here")
                    .with_help("remove one of them"),
                ),
            }
        }
        kept
    }

    /// Reports an expression that ends at a comma within its brackets, whose rest looks like something else.
    fn report_cut(&mut self, node: &Node) {
        self.cut.insert(node.span);
        let message = "expression ends at a comma within its brackets";
        let help = "write it in quotes: within `{}` and `[]` a comma ends a value";
        self.fault(Rule::E0204, node.span, message, help);
    }

    /// Whether a list is an expression in pieces, which is reported.
    pub(super) fn in_pieces(&mut self, items: &[Node]) -> bool {
        let ends = |node: &Node| match &node.kind {
            Kind::Scalar(scalar) => !scalar.quoted && depth(&scalar.text) < 0,
            _ => false,
        };
        let open = items.iter().position(is_open);
        let Some(open) = open.filter(|&open| items[open..].iter().any(ends)) else {
            return false;
        };
        self.report_cut(&items[open]);
        true
    }

    /// Reports a value of a wrong kind.
    pub(crate) fn kind(&mut self, node: &Node, expected: &str, help: &str) {
        let message = match self.keys.get(&node.span) {
            Some(key) if node.kind == Kind::Null => {
                format!("`{}` has no value, expected {expected}", excerpt(&key.text))
            }
            _ => format!("found {}, expected {expected}", node.describe()),
        };
        self.fault(Rule::E0103, node.span, message, help);
    }
}

/// Whether an expression without quotes ends before its brackets do.
fn is_open(node: &Node) -> bool {
    match &node.kind {
        Kind::Scalar(scalar) => !scalar.quoted && depth(&scalar.text) > 0,
        _ => false,
    }
}

/// Brackets that are opened, less those that are closed.
fn depth(text: &str) -> isize {
    let brackets = text.chars().map(|c| match c {
        '(' => 1,
        ')' => -1,
        _ => 0,
    });
    brackets.sum()
}

/// The keys of a section, those that it needs first.
fn in_words(section: &Section) -> String {
    let (needed, other): (Vec<&Known>, Vec<&Known>) =
        section.keys.iter().partition(|key| key.required);
    let names = |keys: &[&Known]| -> String {
        let names: Vec<String> = keys.iter().map(|key| format!("`{}`", key.name)).collect();
        names.join(", ")
    };
    match (needed.as_slice(), other.as_slice()) {
        ([], other) => format!("its keys are {}", names(other)),
        (needed, []) => format!("it needs the keys {}", names(needed)),
        (needed, other) => format!(
            "it needs the keys {}, and may have {}",
            names(needed),
            names(other)
        ),
    }
}

/// The name under which an entry stands.
pub(crate) fn name(entry: &Entry) -> Word {
    Located {
        value: entry.key.text.clone(),
        span: entry.key.span,
    }
}

/// `a`, `b` or `c`.
pub(crate) fn list(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}
