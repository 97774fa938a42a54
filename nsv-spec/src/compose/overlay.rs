//! Lays one tree over another: what `extends` means.

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Rule};
use crate::suggest::nearest;
use crate::yaml::{Entry, Kind, Node, excerpt};

/// Lays `top` over `base`: maps merge key by key, `~` takes a key away, anything else replaces what is there. Keys of the base
/// keep their order, new ones follow.
pub(crate) fn overlay(base: &mut Node, top: Node, faults: &mut Vec<Diagnostic>) {
    if !matches!((&base.kind, &top.kind), (Kind::Map(_), Kind::Map(_))) {
        *base = top;
        return;
    }
    let (Kind::Map(into), Kind::Map(from)) = (&mut base.kind, top.kind) else {
        return;
    };
    let mut seen = BTreeSet::new();
    for entry in from {
        // A key that is given twice stays so, and is reported where the tree is read.
        if !seen.insert(entry.key.text.clone()) {
            into.push(entry);
            continue;
        }
        let at = into.iter().position(|old| old.key.text == entry.key.text);
        match (at, &entry.value.kind) {
            (Some(at), Kind::Null) if is_written(&entry.value) => drop(into.remove(at)),
            (None, Kind::Null) if is_written(&entry.value) => faults.push(absent(&entry, into)),
            (Some(at), Kind::Map(_)) if matches!(into[at].value.kind, Kind::Map(_)) => {
                overlay(&mut into[at].value, entry.value, faults);
            }
            (Some(at), _) => into[at] = entry,
            (None, _) => into.push(entry),
        }
    }
}

/// Whether nothing is written as `~` or `null`, not merely left out.
pub(crate) fn is_written(null: &Node) -> bool {
    null.span.start < null.span.end
}

/// A key that is taken away from where it is not.
pub(crate) fn absent(entry: &Entry, known: &[Entry]) -> Diagnostic {
    let (name, span) = (&entry.key.text, entry.key.span);
    let message = format!("`{}` is removed, but it is not there", excerpt(name));
    let meant = nearest(name, known.iter().map(|entry| &entry.key.text));
    Diagnostic::error(Rule::E0032, span, message)
        .did_you_mean(span, name, meant, || "remove the line".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::FileId;
    use crate::yaml::read;

    fn check(base: &str, top: &str, expected: &str) {
        let tree = |text| read(text, FileId(0)).unwrap();
        let (mut base, mut faults) = (tree(base), Vec::new());
        overlay(&mut base, tree(top), &mut faults);
        assert_eq!((base.flow().as_str(), faults.len()), (expected, 0));
    }

    #[test]
    fn maps_merge_and_everything_else_is_replaced() {
        check(
            "{a: {b: 1, c: 2}, d: 3}",
            "{a: {c: 4}, e: 5}",
            "{a: {b: 1, c: 4}, d: 3, e: 5}",
        );
        check("{a: [1, 2, 3]}", "{a: [4]}", "{a: [4]}");
        check("{a: {value: 1, unit: m}}", "{a: 2 m}", "{a: 2 m}");
        check("{a: 1 m}", "{a: {value: 2 m}}", "{a: {value: 2 m}}");
    }

    #[test]
    fn a_tilde_takes_a_key_away_and_a_gap_does_not() {
        check("{a: {b: 1, c: 2}}", "{a: {b: ~}}", "{a: {c: 2}}");
        check("{a: 1, b: 2}", "a: null", "{b: 2}");
        check("{a: 1, b: 2}", "a:", "{a: ~, b: 2}");
    }

    #[test]
    fn a_key_given_twice_stays_so() {
        check("{a: 1}", "{a: 2, a: 3}", "{a: 2, a: 3}");
    }

    #[test]
    fn what_is_not_there_cannot_be_removed() {
        let (mut base, mut faults) = (read("{mass: 1}", FileId(0)).unwrap(), Vec::new());
        overlay(&mut base, read("{mas: ~}", FileId(0)).unwrap(), &mut faults);
        assert_eq!(faults[0].rule, Rule::E0032);
        assert_eq!(faults[0].help.as_deref(), Some("did you mean `mass`?"));
    }
}
