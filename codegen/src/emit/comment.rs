//! Comments and rustdoc of emitted code. Text of the specification is cleaned before it gets here or here at the latest: one line, no
//! control or direction characters, bounded length, and nothing that rustdoc would run, so it cannot leave its comment.
//!
//! Token streams carry no `//` comments. A comment therefore travels through the printer as a numbered placeholder statement, which
//! contains nothing but the number, and becomes text after printing.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Longest text taken from the specification.
const LENGTH: usize = 400;

/// Width of a comment line, indentation included.
const WIDTH: usize = 100;

/// The placeholder's macro name.
const PLACEHOLDER: &str = "nsv_comment!(";

/// `text` on one line: letters of any script, digits, ASCII punctuation and single blanks; other characters become `?`; backticks become
/// quotes, because a code fence in rustdoc is a test that runs.
pub(crate) fn clean(text: &str) -> String {
    let visible = |c: char| match c {
        '`' => '\'',
        '~' => '-',
        c if c.is_whitespace() => ' ',
        c if c.is_alphanumeric() || c.is_ascii_graphic() => c,
        _ => '?',
    };
    let line: String = text.chars().map(visible).collect();
    let mut line = line.split_whitespace().collect::<Vec<_>>().join(" ");
    if let Some((cut, _)) = line.char_indices().nth(LENGTH) {
        line.truncate(cut);
        line.push_str("...");
    }
    line.replace("*/", "* /").replace("/*", "/ *")
}

/// Cleaned `text` as rustdoc prose: markup that would link or embed is escaped.
pub(crate) fn prose(text: &str) -> String {
    let mut escaped = String::new();
    for c in clean(text).chars() {
        if matches!(c, '[' | ']' | '<' | '>' | '\\') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// Cleaned `text` as code in rustdoc prose.
pub(crate) fn code(text: &str) -> String {
    format!("`{}`", clean(text))
}

/// `#[doc]` attributes for lines of prose that were made with [`prose`], [`code`] and text of the compiler's own. An empty line parts
/// paragraphs; long lines are wrapped.
pub(crate) fn docs<S: AsRef<str>>(lines: &[S]) -> TokenStream {
    let wrapped = lines
        .iter()
        .flat_map(|line| wrap(line.as_ref(), WIDTH - 8, false));
    let lines = wrapped.map(|line| {
        if line.is_empty() {
            line
        } else {
            format!(" {line}")
        }
    });
    quote!(#(#[doc = #lines])*)
}

/// As [`docs`], for the module itself.
pub(crate) fn module_docs<S: AsRef<str>>(lines: &[S]) -> TokenStream {
    let wrapped = lines
        .iter()
        .flat_map(|line| wrap(line.as_ref(), WIDTH - 8, false));
    let lines = wrapped.map(|line| {
        if line.is_empty() {
            line
        } else {
            format!(" {line}")
        }
    });
    quote!(#(#![doc = #lines])*)
}

/// `text` in lines of at most `width` characters where blanks allow it. With `anywhere` unset, a line starts with a letter or a
/// bracket, because markdown reads `-`, `+` and `1.` at the start of a line as a list.
fn wrap(text: &str, width: usize, anywhere: bool) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut length = 0;
    for word in text.split(' ') {
        let breakable =
            anywhere || word.starts_with(|c: char| c.is_alphabetic() || c == '`' || c == '(');
        let word_length = word.chars().count();
        let line = lines.last_mut().expect("invariant: there is a first line");
        if line.is_empty() {
            line.push_str(word);
            length = word_length;
        } else if breakable && length + 1 + word_length > width {
            lines.push(word.to_owned());
            length = word_length;
        } else {
            line.push(' ');
            line.push_str(word);
            length += 1 + word_length;
        }
    }
    lines
}

/// One comment inside a function.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Comment {
    /// Opens a group of statements: a blank line comes before it.
    Heading(String),
    /// Belongs to the next statement.
    Note(String),
}

/// The comments of a file, in the order of their placeholders.
#[derive(Clone, Debug, Default)]
pub(crate) struct Comments {
    list: Vec<Comment>,
}

impl Comments {
    /// A statement that stands for a group heading.
    pub(crate) fn heading(&mut self, text: &str) -> TokenStream {
        self.push(Comment::Heading(clean(text)))
    }

    /// A statement that stands for a comment on the next statement.
    pub(crate) fn note(&mut self, text: &str) -> TokenStream {
        self.push(Comment::Note(clean(text)))
    }

    fn push(&mut self, comment: Comment) -> TokenStream {
        let number = Literal::usize_unsuffixed(self.list.len());
        self.list.push(comment);
        quote!(nsv_comment!(#number);)
    }

    /// `text` with each placeholder line replaced by its comment.
    pub(crate) fn restore(&self, text: &str) -> String {
        let mut restored = String::with_capacity(text.len());
        let mut after_opening = true;
        for line in text.lines() {
            match self.placeholder(line) {
                Some(comment) => write(
                    &mut restored,
                    comment,
                    line.len() - line.trim_start().len(),
                    after_opening,
                ),
                None => {
                    restored.push_str(line);
                    restored.push('\n');
                }
            }
            after_opening = line.ends_with('{');
        }
        restored
    }

    fn placeholder(&self, line: &str) -> Option<&Comment> {
        let number = line
            .trim_start()
            .strip_prefix(PLACEHOLDER)?
            .strip_suffix(");")?;
        self.list.get(number.parse::<usize>().ok()?)
    }
}

fn write(text: &mut String, comment: &Comment, indent: usize, after_opening: bool) {
    let (heading, content) = match comment {
        Comment::Heading(content) => (true, format!("-- {content} --")),
        Comment::Note(content) => (false, content.clone()),
    };
    if heading && !after_opening {
        text.push('\n');
    }
    for line in wrap(&content, WIDTH.saturating_sub(indent + 3), true) {
        text.push_str(&" ".repeat(indent));
        text.push_str("// ");
        text.push_str(&line);
        text.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_cannot_leave_its_line() {
        assert_eq!(
            clean("a\nfn evil() {}\r\u{2028}b\u{202e}c\0"),
            "a fn evil() {} b?c?"
        );
        assert_eq!(clean("*/ x /* y"), "* / x / * y");
        assert_eq!(clean("```rust\nexit()\n```"), "'''rust exit() '''");
        assert_eq!(clean(&"x".repeat(1000)).len(), LENGTH + 3);
        assert_eq!(
            prose("[a](http://x) <script>"),
            "\\[a\\](http://x) \\<script\\>"
        );
    }

    #[test]
    fn placeholders_become_comments_with_their_indentation() {
        let mut comments = Comments::default();
        comments.heading("group \n injected();");
        comments.note("e_1 = x_1 - y_r  (14)");
        let text = "fn f() {\n    a();\n    nsv_comment!(0);\n    nsv_comment!(1);\n    let x = \"nsv_comment!(1);\";\n}\n";
        let expected = "fn f() {\n    a();\n\n    // -- group injected(); --\n    // e_1 = x_1 - y_r (14)\n    \
                        let x = \"nsv_comment!(1);\";\n}\n";
        assert_eq!(comments.restore(text), expected);
    }

    #[test]
    fn rustdoc_lines_do_not_start_a_list() {
        let text = format!("{} - 1. + x", "word ".repeat(30).trim());
        for line in wrap(&text, 40, false) {
            assert!(line.starts_with(char::is_alphabetic), "{line}");
        }
    }
}
