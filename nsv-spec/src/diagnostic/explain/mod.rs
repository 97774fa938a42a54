//! What every rule is for, with a small specification that breaks it and its mend: the source of `nsv explain`, of the pages in
//! `docs/diagnostics`, and of the tests that hold each of them true.

mod composition;
mod expressions;
mod files;
mod flight;
mod keys;
mod names;
mod tables;
mod theory;
mod units;
mod values;

use super::Rule;

/// The smallest specification that checks clean; the examples are changes of it.
pub const BASE: &str = include_str!("base.yaml");

/// Stands in an example for a text that is too long to show.
const LONG: char = '\u{2026}';

/// Why a rule is there, and an example of breaking it.
#[derive(Clone, Copy, Debug)]
pub struct Explanation {
    /// One paragraph.
    pub why: &'static str,
    /// The example.
    pub example: Example,
}

/// Changes of [`BASE`] that break one rule, and their mend.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The changes.
    pub edits: &'static [Edit],
    /// Included files: name, text that breaks the rule, mended text.
    pub files: &'static [(&'static str, &'static str, &'static str)],
    /// What text cannot show.
    pub twist: Twist,
}

/// Part of [`BASE`], what the example writes in its place, and what it should have written.
#[derive(Clone, Copy, Debug)]
pub struct Edit {
    /// What stands there.
    pub from: &'static str,
    /// What breaks the rule.
    pub bad: &'static str,
    /// The mend.
    pub good: &'static str,
}

/// What makes an example more than its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Twist {
    /// Nothing.
    None,
    /// The file is not there.
    Absent,
    /// The file is saved in Latin-1.
    Latin1,
    /// The three dots stand for this text so many times.
    Long(&'static str, usize),
}

impl Rule {
    /// Why the rule is there.
    pub fn explanation(self) -> &'static Explanation {
        let families = [
            files::ALL,
            composition::ALL,
            keys::ALL,
            names::ALL,
            expressions::ALL,
            tables::ALL,
            units::ALL,
            values::ALL,
            theory::ALL,
            flight::ALL,
        ];
        let found = families
            .into_iter()
            .flatten()
            .find(|(rule, _)| *rule == self);
        let (_, explanation) = found.expect("invariant: a test finds an explanation of every rule");
        explanation
    }
}

impl Example {
    /// The specification that breaks the rule, as bytes of a file; `None` where there is no file.
    pub fn broken(&self) -> Option<Vec<u8>> {
        let text = self.applied(|edit| edit.bad);
        match self.twist {
            Twist::Absent => None,
            Twist::Latin1 => Some(
                text.chars()
                    .map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?'))
                    .collect(),
            ),
            Twist::Long(part, times) => Some(text.replace(LONG, &part.repeat(times)).into_bytes()),
            Twist::None => Some(text.into_bytes()),
        }
    }

    /// The mended specification.
    pub fn mended(&self) -> String {
        self.applied(|edit| edit.good)
    }

    fn applied(&self, side: fn(&Edit) -> &'static str) -> String {
        self.edits.iter().fold(BASE.to_owned(), |text, edit| {
            text.replacen(edit.from, side(edit), 1)
        })
    }
}

/// An explanation with an example that is plain text.
const fn plain(why: &'static str, edits: &'static [Edit]) -> Explanation {
    Explanation {
        why,
        example: Example {
            edits,
            files: &[],
            twist: Twist::None,
        },
    }
}

/// An explanation with included files.
const fn with_files(
    why: &'static str,
    edits: &'static [Edit],
    files: &'static [(&'static str, &'static str, &'static str)],
) -> Explanation {
    Explanation {
        why,
        example: Example {
            edits,
            files,
            twist: Twist::None,
        },
    }
}

/// An explanation whose example is more than text.
const fn twisted(why: &'static str, edits: &'static [Edit], twist: Twist) -> Explanation {
    Explanation {
        why,
        example: Example {
            edits,
            files: &[],
            twist,
        },
    }
}

/// A change with its mend.
const fn edit(from: &'static str, bad: &'static str, good: &'static str) -> Edit {
    Edit { from, bad, good }
}

/// A change whose mend is to take it back.
const fn undo(from: &'static str, bad: &'static str) -> Edit {
    edit(from, bad, from)
}
