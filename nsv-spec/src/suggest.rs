//! "Did you mean": the known name nearest to a mistyped one.

use crate::diagnostic::{Applicability, Diagnostic, Span};

/// A known name in place of a mistyped one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Meant {
    /// The known name.
    pub(crate) name: String,
    /// Whether nothing else can have been meant: there is no second candidate as near, one slip (two in long names) is all that
    /// is different, and no digit is, for `x1` and `x2` are two things.
    pub(crate) sure: bool,
}

impl Meant {
    /// How far to trust it.
    pub(crate) fn applicability(&self) -> Applicability {
        match self.sure {
            true => Applicability::Certain,
            false => Applicability::Possible,
        }
    }
}

/// The candidate with the smallest edit distance to `name`, ignoring case, if it is near enough to be meant: one slip in
/// three characters, or one character too many or too few at the end. The first of equals.
pub(crate) fn nearest<S: AsRef<str>>(
    name: &str,
    candidates: impl IntoIterator<Item = S>,
) -> Option<Meant> {
    let mut best: Option<((usize, usize), String)> = None;
    let mut unique = true;
    let lower = name.to_ascii_lowercase();
    for candidate in candidates {
        let candidate = candidate.as_ref();
        let longer = name.len().max(candidate.len());
        let shorter = name.len().min(candidate.len());
        if name == candidate || longer > 64 || (longer - shorter) * 3 > longer.max(3) {
            continue;
        }
        let distance = distance(&lower, &candidate.to_ascii_lowercase());
        let letter_more = longer > shorter && shorter > 0 && {
            let other = candidate.to_ascii_lowercase();
            distance == 1 && (lower.starts_with(&other) || other.starts_with(&lower))
        };
        if distance * 3 > longer && !letter_more {
            continue;
        }
        // Of two as near, the one of the same length: neighbours were swapped.
        let rank = (distance, longer - shorter);
        let least = best.as_ref().map(|(least, _)| *least);
        if least.is_none_or(|least| rank < least) {
            best = Some((rank, candidate.to_owned()));
        }
        match least {
            Some((before, _)) if before == distance => unique = false,
            Some((before, _)) if before < distance => {}
            _ => unique = true,
        }
    }
    best.map(|((distance, _), candidate)| Meant {
        sure: unique && slip(name, &candidate, distance),
        name: candidate,
    })
}

/// The only candidate that a text abbreviates, with or without an `s` behind it, as in `init` and `args`.
pub(crate) fn abbreviated<'a>(
    text: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<Meant> {
    let stem = text.strip_suffix('s').unwrap_or(text);
    let begins = |candidate: &str, stem: &str| {
        candidate.starts_with(stem) && candidate.len() > stem.len() + 1
    };
    let mut long = (candidates.into_iter())
        .filter(|candidate| begins(candidate, text) || begins(candidate, stem));
    let only = long
        .next()
        .filter(|_| stem.len() >= 3 && long.next().is_none())?;
    Some(Meant {
        name: only.to_owned(),
        sure: false,
    })
}

/// How to mend a name that nothing has, where those that are given already cannot have been meant.
pub(crate) fn beside<S: AsRef<str>>(
    name: &str,
    given: impl IntoIterator<Item = S>,
    otherwise: &str,
) -> String {
    match nearest(name, given) {
        Some(like) => format!(
            "remove it, as `{}` is there already, or {otherwise}",
            like.name
        ),
        None => otherwise.to_owned(),
    }
}

/// Whether a distance is a slip of the finger.
fn slip(name: &str, candidate: &str, distance: usize) -> bool {
    let digits = |text: &str| -> Vec<char> { text.chars().filter(char::is_ascii_digit).collect() };
    let length = name.len().min(candidate.len());
    let allowed = match length {
        0..4 => 0,
        4..8 => 1,
        _ => 2,
    };
    distance <= allowed && digits(name) == digits(candidate)
}

impl Diagnostic {
    /// The same with `did you mean ..?` for the name written at `span`, or else with another help.
    pub(crate) fn did_you_mean(
        self,
        span: Span,
        name: &str,
        meant: Option<Meant>,
        otherwise: impl FnOnce() -> String,
    ) -> Self {
        let Some(meant) = meant else {
            return self.with_help(otherwise());
        };
        let fault = self.with_help(format!("did you mean `{}`?", meant.name));
        // A name in quotes or with escapes is not at its span letter by letter.
        match (span.end - span.start) as usize == name.len() {
            true => fault.with_suggestion(span, meant.name.clone(), meant.applicability()),
            false => fault,
        }
    }
}

/// Fewest insertions, deletions, substitutions and swaps of neighbours that turn one text into the other.
fn distance(from: &str, to: &str) -> usize {
    let (from, to) = (from.as_bytes(), to.as_bytes());
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=to.len()).collect();
    for i in 1..=from.len() {
        let mut row = vec![i];
        for j in 1..=to.len() {
            let substitution = last[j - 1] + usize::from(from[i - 1] != to[j - 1]);
            let mut least = substitution.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1] {
                least = least.min(before[j - 2] + 1);
            }
            row.push(least);
        }
        before = std::mem::replace(&mut last, row);
    }
    last[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_slip_in_three_characters_is_forgiven() {
        let names = ["alpha", "beta", "CL.alpha", "q_bar", "V", "K", "kbar"];
        let meant = |name| nearest(name, names).map(|meant| meant.name);
        assert_eq!(meant("alhpa").as_deref(), Some("alpha"));
        assert_eq!(meant("Cl.alpha").as_deref(), Some("CL.alpha"));
        assert_eq!(meant("q_baar").as_deref(), Some("q_bar"));
        assert_eq!(meant("v").as_deref(), Some("V"));
        assert_eq!(meant("Kp").as_deref(), Some("K"));
        assert_eq!(meant("W"), None);
        assert_eq!(meant("gamma"), None);
    }

    #[test]
    fn only_a_slip_in_a_name_that_is_like_no_other_is_sure() {
        let sure = |name: &str, known: &[&str]| nearest(name, known).unwrap().sure;
        assert!(sure("lenght", &["length", "mass"]));
        assert!(sure("Length", &["length"]));
        assert!(sure("v", &["V"]));
        assert!(!sure("rate", &["rate_1", "rate_x"]));
        assert!(!sure("speed1", &["speed2"]));
        assert!(!sure("Kp", &["K"]));
        assert!(!sure("mas", &["mass"]));
        assert!(!sure("substeps", &["substep", "substepz"]));
    }

    #[test]
    fn an_abbreviation_stands_for_one_word_only() {
        let keys = ["initial", "unit", "controller", "constants", "arguments"];
        let meant = |text| abbreviated(text, keys).map(|meant| meant.name);
        assert_eq!(meant("init").as_deref(), Some("initial"));
        assert_eq!(meant("args").as_deref(), Some("arguments"));
        assert_eq!(meant("con"), None);
        assert_eq!(meant("u"), None);
    }

    #[test]
    fn distance_counts_swaps_once() {
        assert_eq!(distance("ab", "ba"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
    }
}
