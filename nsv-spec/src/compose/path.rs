//! Puts a value where a path of keys leads, such as `controller.blocks.attitude.K`.

use super::overlay::{absent, is_written};
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::suggest::nearest;
use crate::vocabulary::{Kind as Expects, SPECIFICATION, Section, places_of};
use crate::yaml::{Entry, Key, Kind, Node, excerpt};

/// The keys of a path, each with its place. A piece of text that the file holds with escapes has the place of the whole.
pub(super) fn keys(text: &str, span: Span) -> Vec<Key> {
    let verbatim = (span.end - span.start) as usize == text.len();
    let mut start = span.start;
    let key = |part: &str| {
        let end = start + part.len() as u32;
        let place = Span { start, end, ..span };
        start = end + 1;
        Key {
            text: part.to_owned(),
            span: if verbatim { place } else { span },
        }
    };
    text.split('.').map(key).collect()
}

/// Puts `value` into the tree of a specification, or takes away what is there if it is `~`. Where a path leads is what the
/// vocabulary knows; names that a specification declares must be in the tree.
pub(super) fn set(tree: &mut Node, path: &[Key], value: Node) -> Result<(), Box<Diagnostic>> {
    if let Some(first) = path
        .first()
        .filter(|key| ["include", "extends"].contains(&&*key.text))
    {
        let message = format!("`{}` cannot be set", first.text);
        let help = "files are joined before values are set; write it into the specification";
        return Err(refusal(first, message, help));
    }
    static ROOT: Expects = Expects::Section(&SPECIFICATION);
    place(tree, &ROOT, "", path, value)
}

/// The value that a path leads to, if there is one.
pub(super) fn get<'a>(tree: &'a Node, path: &[Key]) -> Option<&'a Node> {
    path.iter().try_fold(tree, |node, key| match &node.kind {
        Kind::Map(entries) => entries
            .iter()
            .find(|entry| entry.key.text == key.text)
            .map(|entry| &entry.value),
        _ => None,
    })
}

fn place(
    node: &mut Node,
    kind: &'static Expects,
    above: &str,
    path: &[Key],
    value: Node,
) -> Result<(), Box<Diagnostic>> {
    let Some((key, rest)) = path.split_first() else {
        *node = value;
        return Ok(());
    };
    let inner = match shape(kind) {
        Shape::Section(section) => {
            lengthen(node, section);
            let found = section.keys.iter().find(|known| known.name == key.text);
            let names = section.keys.iter().map(|known| known.name).collect();
            &found.ok_or_else(|| unknown(key, section.noun, names))?.kind
        }
        Shape::Names(inner, declared) => {
            let names: Vec<&str> = names(node);
            if !declared && !names.contains(&&*key.text) {
                return Err(unknown(key, &format!("`{}`", excerpt(above)), names));
            }
            inner
        }
        Shape::Leaf => {
            let message = format!(
                "`{}` leads nowhere: what is there has no keys",
                excerpt(&key.text)
            );
            let help = "a path ends at a value; lists and expressions are given whole";
            return Err(refusal(key, message, help));
        }
    };
    if matches!(node.kind, Kind::Null) {
        node.kind = Kind::Map(Vec::new());
    }
    let Kind::Map(entries) = &mut node.kind else {
        let message = format!(
            "found {}, expected a map with `{}`",
            node.describe(),
            excerpt(&key.text)
        );
        return Err(refusal(key, message, "give the whole value"));
    };
    put(entries, key, inner, rest, value)
}

/// Goes on at the entry of a key, which is made if it is not there and is made again if it is set.
fn put(
    entries: &mut Vec<Entry>,
    key: &Key,
    kind: &'static Expects,
    rest: &[Key],
    value: Node,
) -> Result<(), Box<Diagnostic>> {
    let at = entries.iter().position(|entry| entry.key.text == key.text);
    let new = |value| Entry {
        key: key.clone(),
        value,
    };
    if rest.is_empty() && matches!(value.kind, Kind::Null) && is_written(&value) {
        let at = at.ok_or_else(|| Box::new(absent(&new(value), entries)))?;
        entries.remove(at);
        return Ok(());
    }
    match at {
        Some(at) if rest.is_empty() => entries[at] = new(value),
        Some(at) => return place(&mut entries[at].value, kind, &key.text, rest, value),
        None => {
            let mut fresh = Node {
                kind: Kind::Null,
                span: key.span,
            };
            place(&mut fresh, kind, &key.text, rest, value)?;
            entries.push(new(fresh));
        }
    }
    Ok(())
}

/// How keys lead on from a place.
enum Shape {
    Section(&'static Section),
    /// Names with values of a kind; whether names may be new because they are declared elsewhere.
    Names(&'static Expects, bool),
    Leaf,
}

fn shape(kind: &'static Expects) -> Shape {
    match kind {
        Expects::Section(section) => Shape::Section(section),
        Expects::Named(inner) => Shape::Names(inner, false),
        Expects::ByName(inner) => Shape::Names(inner, true),
        Expects::Either(kinds) => kinds
            .iter()
            .map(shape)
            .find(|shape| !matches!(shape, Shape::Leaf))
            .unwrap_or(Shape::Leaf),
        _ => Shape::Leaf,
    }
}

/// Turns the short form of a value (`mass: 1 kg`) into the long one (`mass: {value: 1 kg}`), so that a key can join it: the first
/// key of such a section is what the short form gives.
fn lengthen(node: &mut Node, section: &'static Section) {
    let first = section.keys.first().filter(|first| first.required);
    if let (Some(first), Kind::Scalar(_) | Kind::Seq(_)) = (first, &node.kind) {
        let key = Key {
            text: first.name.into(),
            span: node.span,
        };
        let long = Node {
            kind: Kind::Map(Vec::new()),
            span: node.span,
        };
        let value = std::mem::replace(node, long);
        node.kind = Kind::Map(vec![Entry { key, value }]);
    }
}

fn names(node: &Node) -> Vec<&str> {
    match &node.kind {
        Kind::Map(entries) => entries.iter().map(|entry| &*entry.key.text).collect(),
        _ => Vec::new(),
    }
}

fn refusal(key: &Key, message: String, help: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(Rule::E0030, key.span, message).with_help(help))
}

fn unknown(key: &Key, place: &str, known: Vec<&str>) -> Box<Diagnostic> {
    const SHOWN: usize = 24;
    if let Some((list, _)) = key.text.split_once('[')
        && known.contains(&list)
    {
        let message = format!(
            "path leads nowhere: `{}` is an item of a list",
            excerpt(&key.text)
        );
        return refusal(
            key,
            message,
            &format!("lists are given whole: set `{list}` itself"),
        );
    }
    let message = format!("path leads nowhere: no `{}` in {place}", excerpt(&key.text));
    let meant = nearest(&key.text, &known);
    let names: Vec<String> = known
        .iter()
        .take(SHOWN)
        .map(|name| format!("`{name}`"))
        .collect();
    let more = if known.len() > SHOWN { ", .." } else { "" };
    let fault = Diagnostic::error(Rule::E0030, key.span, message);
    Box::new(
        fault.did_you_mean(key.span, &key.text, meant, || match names.is_empty() {
            true => "nothing is there; give the whole map".into(),
            false => match places_of(&key.text).as_slice() {
                [] => format!("there are {}{more}", names.join(", ")),
                places => format!(
                    "it is a key of {}; here are {}{more}",
                    places.join(" or "),
                    names.join(", ")
                ),
            },
        }),
    )
}
