//! Applies suggestions to texts.

use super::{Applicability, Diagnostic, Diagnostics, FileId, Span, Suggestion};

/// A file with suggestions applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fixed {
    /// The file.
    pub file: FileId,
    /// Its text afterwards.
    pub text: String,
    /// What was done, in order of place.
    pub applied: Vec<Suggestion>,
}

impl Diagnostics {
    /// Every file in which something is certain to be mended, mended. Of suggestions that overlap only the first is applied, and
    /// one that several faults make is applied once.
    pub fn fix(&self) -> Vec<Fixed> {
        let mut certain: Vec<&Suggestion> = self.items.iter().filter_map(certain).collect();
        certain.sort_by_key(|suggestion| suggestion.span);
        let mut fixed: Vec<Fixed> = Vec::new();
        for suggestion in certain {
            let Span { file, start, end } = suggestion.span;
            let source = self.sources.source(file);
            let range = start as usize..end as usize;
            if !source.on_disk || source.text.get(range).is_none() {
                continue;
            }
            let last = match fixed.last_mut() {
                Some(last) if last.file == file => last,
                _ => {
                    fixed.push(Fixed {
                        file,
                        text: String::new(),
                        applied: Vec::new(),
                    });
                    fixed.last_mut().expect("invariant: just pushed")
                }
            };
            let before = last.applied.last().map(|other| other.span);
            // Two insertions at one place overlap too: nobody knows which comes first.
            let free = before.is_none_or(|other| {
                other.end <= start && (other.end < start || other.start < other.end && start < end)
            });
            if free {
                last.applied.push(suggestion.clone());
            }
        }
        for file in &mut fixed {
            file.text = replaced(&self.sources.source(file.file).text, &file.applied);
        }
        fixed
    }
}

fn certain(item: &Diagnostic) -> Option<&Suggestion> {
    let suggestion = item.suggestion.as_ref()?;
    (suggestion.applicability == Applicability::Certain).then_some(suggestion)
}

/// A text with replacements that are in order and do not overlap.
fn replaced(text: &str, suggestions: &[Suggestion]) -> String {
    let mut new = String::with_capacity(text.len());
    let mut at = 0;
    for suggestion in suggestions {
        new.push_str(&text[at..suggestion.span.start as usize]);
        new.push_str(&suggestion.replacement);
        at = suggestion.span.end as usize;
    }
    new.push_str(&text[at..]);
    new
}

#[cfg(test)]
mod tests {
    use super::super::{Rule, SourceMap};
    use super::*;

    fn fixed(edits: &[(u32, u32, &str)]) -> String {
        let mut sources = SourceMap::default();
        let file = sources.add("a.yaml", "abc def".into());
        let fault = |&(start, end, text): &(u32, u32, &str)| {
            let span = Span { file, start, end };
            Diagnostic::error(Rule::E0101, span, "x").with_suggestion(
                span,
                text,
                Applicability::Certain,
            )
        };
        let items = edits.iter().map(fault).collect();
        let fixed = Diagnostics { sources, items }.fix();
        fixed
            .first()
            .map_or("abc def".into(), |file| file.text.clone())
    }

    #[test]
    fn replacements_apply_from_left_to_right_in_any_order() {
        assert_eq!(fixed(&[(4, 7, "z"), (0, 1, "xy")]), "xybc z");
        assert_eq!(fixed(&[(3, 3, "!"), (0, 1, "xy")]), "xybc! def");
    }

    #[test]
    fn of_overlapping_ones_the_first_is_applied() {
        assert_eq!(fixed(&[(0, 3, "x"), (2, 5, "y")]), "x def");
        assert_eq!(fixed(&[(0, 3, "x"), (0, 3, "x")]), "x def");
        assert_eq!(fixed(&[(3, 3, "x"), (3, 3, "y")]), "abcx def");
    }

    #[test]
    fn a_place_outside_the_text_is_passed_over() {
        assert_eq!(fixed(&[(5, 9, "x")]), "abc def");
    }
}
