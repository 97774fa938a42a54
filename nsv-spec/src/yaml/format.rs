//! One way to lay out a YAML text: two blanks for each level, blanks between the items of flow collections and none inside their
//! brackets, no trailing blanks, at most one empty line in a row. Comments, order, quotes and line breaks stay.

use super::{Kind, Node, read};
use crate::diagnostic::{Diagnostic, FileId, Span};

/// Why a text was not laid out.
#[derive(Clone, Debug)]
pub enum Unformatted {
    /// It is not YAML that a specification can be.
    Fault(Box<Diagnostic>),
    /// Its meaning would have changed, which is a fault of ours.
    Unsafe,
}

/// Lays out a text. What comes out holds the same characters but for white space, and is read as the same tree.
pub fn format(text: &str) -> Result<String, Unformatted> {
    let tree = read(text, FileId(0)).map_err(Unformatted::Fault)?;
    let mut layout = Layout::of(&tree, text);
    for line in text.split_inclusive('\n') {
        layout.line(line);
    }
    let new = layout.finish();
    let again = read(&new, FileId(0)).map_err(|_| Unformatted::Unsafe)?;
    match again.flow() == tree.flow() && letters(text).eq(letters(&new)) {
        true => Ok(new),
        false => Err(Unformatted::Unsafe),
    }
}

/// Everything but white space.
fn letters(text: &str) -> impl Iterator<Item = char> {
    text.chars().filter(|c| !c.is_whitespace())
}

/// What a byte of the text belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// White space, brackets, comments and other marks.
    Mark,
    Key,
    Scalar,
}

struct Layout {
    parts: Vec<Part>,
    /// First byte of the line at hand.
    at: usize,
    /// Open brackets of flow collections.
    brackets: usize,
    /// Indentation of the open levels, as written.
    levels: Vec<usize>,
    /// How far the last line that began something was moved: its old and new indentation.
    moved: (usize, usize),
    /// Comments and empty lines before the next line that begins something.
    waiting: Vec<String>,
    new: String,
}

impl Layout {
    fn of(tree: &Node, text: &str) -> Layout {
        let mut parts = vec![Part::Mark; text.len()];
        paint(tree, &mut parts);
        Layout {
            parts,
            at: 0,
            brackets: 0,
            levels: Vec::new(),
            moved: (0, 0),
            waiting: Vec::new(),
            new: String::new(),
        }
    }

    fn line(&mut self, line: &str) {
        let start = self.at;
        self.at += line.len();
        let body = line.trim_end_matches(['\n', '\r']);
        let inside =
            start > 0 && self.part(start - 1) == Part::Scalar && self.part(start) == Part::Scalar;
        let indent = body.len() - body.trim_start_matches(' ').len();
        let first = start + indent;
        let content = body.trim();
        if content.is_empty() && !inside {
            self.waiting.push(String::new());
        } else if content.starts_with('#') && self.part(first) == Part::Mark && self.brackets == 0 {
            self.waiting.push(body.trim_end().to_owned());
        } else if inside || self.brackets > 0 || self.part(first) == Part::Scalar {
            self.release(None);
            let text = self.spaced(first, &body[indent..]);
            self.push(shifted(indent, self.moved), &text);
        } else {
            let to = self.level(indent);
            self.release(Some((indent, to)));
            self.moved = (indent, to);
            let text = self.spaced(first, &body[indent..]);
            self.push(to, &text);
        }
    }

    fn part(&self, at: usize) -> Part {
        self.parts.get(at).copied().unwrap_or(Part::Mark)
    }

    /// The indentation of a line that begins a key or an item.
    fn level(&mut self, indent: usize) -> usize {
        while self.levels.last().is_some_and(|&last| last > indent) {
            self.levels.pop();
        }
        if self.levels.last().is_none_or(|&last| last < indent) {
            self.levels.push(indent);
        }
        2 * (self.levels.len() - 1)
    }

    /// Writes the waiting comments. Those that stand where the next line does, or the last one, move along; others, such as the
    /// second line of a comment at the end of a line, stay.
    fn release(&mut self, next: Option<(usize, usize)>) {
        let mut empty = self.new.is_empty();
        for line in std::mem::take(&mut self.waiting) {
            if line.is_empty() {
                if !empty {
                    self.new.push('\n');
                }
                empty = true;
                continue;
            }
            empty = false;
            let text = line.trim_start_matches(' ');
            let indent = line.len() - text.len();
            let moves = [next, Some(self.moved)].into_iter().flatten();
            let to = moves
                .filter(|(old, _)| *old == indent)
                .map(|(_, new)| new)
                .next();
            self.push(to.unwrap_or(indent), text);
        }
    }

    fn push(&mut self, indent: usize, text: &str) {
        if !text.is_empty() {
            self.new.extend(std::iter::repeat_n(' ', indent));
        }
        self.new.push_str(text);
        self.new.push('\n');
    }

    /// A line without its indentation, with the blanks of flow collections in order.
    fn spaced(&mut self, first: usize, text: &str) -> String {
        let mut new = String::with_capacity(text.len());
        let mut rest = text.char_indices().peekable();
        while let Some((at, c)) = rest.next() {
            if self.part(first + at) != Part::Mark {
                new.push(c);
                continue;
            }
            let blank = |c: Option<char>| c.is_none_or(char::is_whitespace);
            match c {
                '#' if blank(new.chars().last()) => {
                    new.push_str(&text[at..]);
                    break;
                }
                '[' | '{' => {
                    self.brackets += 1;
                    new.push(c);
                    let after = &text[at + 1..];
                    let skipped = after.len() - after.trim_start().len();
                    if skipped < after.len() && !after.trim_start().starts_with('#') {
                        for _ in 0..skipped {
                            rest.next();
                        }
                    }
                }
                ']' | '}' => {
                    self.brackets = self.brackets.saturating_sub(1);
                    let kept = new.trim_end_matches(' ');
                    if !kept.is_empty() && !kept.ends_with(',') {
                        new.truncate(kept.len());
                    }
                    new.push(c);
                }
                ',' if self.brackets > 0 => {
                    new.push(c);
                    if rest.peek().is_some_and(|(_, next)| !next.is_whitespace()) {
                        new.push(' ');
                    }
                }
                c => new.push(c),
            }
        }
        // The end of a line inside a scalar belongs to the scalar.
        let end = first + text.len();
        match end > 0 && self.part(end - 1) == Part::Scalar && self.part(end) == Part::Scalar {
            true => new,
            false => new.trim_end().to_owned(),
        }
    }

    fn finish(mut self) -> String {
        while self.waiting.last().is_some_and(String::is_empty) {
            self.waiting.pop();
        }
        self.release(None);
        self.new
    }
}

/// An indentation moved as that of the line it belongs to.
fn shifted(indent: usize, (from, to): (usize, usize)) -> usize {
    (indent + to).saturating_sub(from)
}

/// Marks the bytes of keys and scalars.
fn paint(node: &Node, parts: &mut [Part]) {
    match &node.kind {
        Kind::Null => {}
        Kind::Scalar(_) => fill(node.span, Part::Scalar, parts),
        Kind::Seq(items) => items.iter().for_each(|item| paint(item, parts)),
        Kind::Map(entries) => {
            for entry in entries {
                fill(entry.key.span, Part::Key, parts);
                paint(&entry.value, parts);
            }
        }
    }
}

fn fill(span: Span, part: Part, parts: &mut [Part]) {
    if let Some(parts) = parts.get_mut(span.start as usize..span.end as usize) {
        parts.fill(part);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        assert_eq!(format(text).expect("YAML"), expected);
        assert_eq!(format(expected).expect("YAML"), expected, "twice");
    }

    #[test]
    fn levels_are_two_blanks_apart() {
        check(
            "a:\n    b: 1\n    c:\n         d: 2\n",
            "a:\n  b: 1\n  c:\n    d: 2\n",
        );
        check(
            "a:\n   - x: 1\n     y: 2\n   - z\n",
            "a:\n  - x: 1\n    y: 2\n  - z\n",
        );
        check("a:\n- x\n- y\nb: 1\n", "a:\n- x\n- y\nb: 1\n");
    }

    #[test]
    fn flow_collections_have_one_look() {
        check("a: { b: 1,c: [ 1,2 ] }\n", "a: {b: 1, c: [1, 2]}\n");
        check(
            "a: [[1,  0],\n    [10, 2]]\n",
            "a: [[1,  0],\n    [10, 2]]\n",
        );
        check(
            "a: {b: '{ x,y }', c: \"[ 1,2 ]\"}\n",
            "a: {b: '{ x,y }', c: \"[ 1,2 ]\"}\n",
        );
    }

    #[test]
    fn comments_stay_with_what_they_are_about() {
        check(
            "#  head\n\n\n\na:\n    # of b\n    b: 1    # why\n            # and how\n# end  \n\n",
            "#  head\n\na:\n  # of b\n  b: 1    # why\n            # and how\n# end\n",
        );
        check("a: [1,  # one\n    2]\n", "a: [1,  # one\n    2]\n");
    }

    #[test]
    fn scalars_of_many_lines_move_as_a_whole() {
        check(
            "a:\n    b: |\n        x +\n\n          y\n    c: 1\n",
            "a:\n  b: |\n      x +\n\n        y\n  c: 1\n",
        );
        check("a:\n    b: \"x\n      y\"\n", "a:\n  b: \"x\n    y\"\n");
    }

    #[test]
    fn what_is_not_yaml_is_left_alone() {
        assert!(matches!(format("a: [1"), Err(Unformatted::Fault(_))));
    }
}
