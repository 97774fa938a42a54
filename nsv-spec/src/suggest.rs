//! "Did you mean": the known name nearest to a mistyped one.

/// The candidate with the smallest edit distance to `name`, ignoring case, if it is near enough to be meant: one slip in
/// three characters. The first of equals.
pub(crate) fn nearest<S: AsRef<str>>(
    name: &str,
    candidates: impl IntoIterator<Item = S>,
) -> Option<String> {
    let mut best: Option<(usize, String)> = None;
    for candidate in candidates {
        let candidate = candidate.as_ref();
        let longer = name.len().max(candidate.len());
        if name == candidate || longer > 64 || name.len().abs_diff(candidate.len()) * 3 > longer {
            continue;
        }
        let distance = distance(&name.to_ascii_lowercase(), &candidate.to_ascii_lowercase());
        if distance * 3 <= longer && best.as_ref().is_none_or(|(least, _)| distance < *least) {
            best = Some((distance, candidate.to_owned()));
        }
    }
    best.map(|(_, candidate)| candidate)
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
        let names = ["alpha", "beta", "CL.alpha", "q_bar", "V"];
        let meant = |name| nearest(name, names);
        assert_eq!(meant("alhpa").as_deref(), Some("alpha"));
        assert_eq!(meant("Cl.alpha").as_deref(), Some("CL.alpha"));
        assert_eq!(meant("q_baar").as_deref(), Some("q_bar"));
        assert_eq!(meant("v").as_deref(), Some("V"));
        assert_eq!(meant("W"), None);
        assert_eq!(meant("gamma"), None);
    }

    #[test]
    fn distance_counts_swaps_once() {
        assert_eq!(distance("ab", "ba"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
    }
}
