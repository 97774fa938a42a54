//! One specification written in many ways: keys in any order, in blocks or in brackets, with or without quotes.

use super::draw::Draw;

/// A specification before it is text.
#[derive(Clone)]
pub enum Tree {
    /// Keys whose order has no meaning.
    Keys(Vec<(String, Tree)>),
    /// Declarations, whose order is that of states, channels or arguments.
    Ordered(Vec<(String, Tree)>),
    List(Vec<Tree>),
    Text(String),
    /// What must be a number to YAML, and so is never in quotes.
    Number(String),
}

pub fn text(text: impl Into<String>) -> Tree {
    Tree::Text(text.into())
}

pub fn number(digits: impl Into<String>) -> Tree {
    Tree::Number(digits.into())
}

pub fn keys<const N: usize>(entries: [(&str, Tree); N]) -> Tree {
    Tree::Keys(entries.map(|(key, value)| (key.to_owned(), value)).into())
}

/// The specification as YAML in a style of the draw's choice.
pub fn write(tree: &Tree, draw: &mut Draw) -> String {
    let mut out = String::new();
    block(tree, 0, draw, &mut out);
    out
}

fn entries(tree: &Tree, draw: &mut Draw) -> Option<Vec<(String, Tree)>> {
    match tree {
        Tree::Ordered(entries) => Some(entries.clone()),
        Tree::Keys(entries) => {
            let mut entries = entries.clone();
            for at in (1..entries.len()).rev() {
                let other = draw.below(at + 1);
                entries.swap(at, other);
            }
            Some(entries)
        }
        Tree::List(_) | Tree::Text(_) | Tree::Number(_) => None,
    }
}

fn block(tree: &Tree, indent: usize, draw: &mut Draw, out: &mut String) {
    let Some(entries) = entries(tree, draw) else {
        return;
    };
    for (key, value) in entries {
        if draw.chance(10) {
            out.push_str("# a comment: {not, read]\n");
        }
        out.push_str(&" ".repeat(indent));
        out.push_str(&quoted(&key, false, draw));
        out.push(':');
        let nested =
            matches!(&value, Tree::Keys(entries) | Tree::Ordered(entries) if !entries.is_empty());
        if nested && (indent == 0 || draw.chance(60)) {
            out.push('\n');
            block(&value, indent + 2, draw, out);
        } else if let (Tree::List(items), true) = (&value, draw.chance(40)) {
            out.push('\n');
            for item in items {
                let shown = flow(item, draw);
                out.push_str(&format!("{}- {shown}\n", " ".repeat(indent + 2)));
            }
        } else if let (Tree::Text(code), 0) = (&value, draw.below(5)) {
            let mark = draw.of(&["|", ">-", "|-"]);
            out.push_str(&format!(" {mark}\n{}{code}\n", " ".repeat(indent + 2)));
        } else {
            let shown = flow(&value, draw);
            out.push_str(&format!(" {shown}{}\n", draw.of(&["", "", "   # why"])));
        }
    }
}

fn flow(tree: &Tree, draw: &mut Draw) -> String {
    match tree {
        Tree::Number(digits) => digits.clone(),
        Tree::Text(code) => quoted(code, true, draw),
        Tree::List(items) => {
            let items: Vec<String> = items.iter().map(|item| flow(item, draw)).collect();
            format!("[{}]", items.join(draw.of(&[", ", " , "])))
        }
        Tree::Keys(_) | Tree::Ordered(_) => {
            let entries = entries(tree, draw).unwrap_or_default().into_iter();
            let shown: Vec<String> = entries
                .map(|(key, value)| format!("{}: {}", quoted(&key, true, draw), flow(&value, draw)))
                .collect();
            format!("{{{}}}", shown.join(", "))
        }
    }
}

/// Plain where YAML allows it, else in either kind of quotes.
fn quoted(code: &str, in_flow: bool, draw: &mut Draw) -> String {
    let ends_flow = in_flow && code.contains([',', '[', ']', '{', '}']);
    let special = code.starts_with(['[', '-', '"']) || code.contains(": ");
    let plain = !(ends_flow || special);
    match draw.below(3) {
        0 if plain => code.to_owned(),
        1 => format!("'{code}'"),
        _ => format!("\"{code}\""),
    }
}
