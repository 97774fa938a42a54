//! Parts of sentences that many messages have: counts, articles, quotations, rounded numbers.

/// A count with its noun: `1 input`, `2 inputs`.
pub(crate) fn counted(count: usize, noun: &str) -> String {
    match (count, noun) {
        (1, _) => format!("1 {noun}"),
        (_, "axis") => format!("{count} axes"),
        (_, "index") => format!("{count} indices"),
        (_, "entry") => format!("{count} entries"),
        _ => format!("{count} {noun}s"),
    }
}

/// A noun with its article.
pub(crate) fn a(noun: &str) -> String {
    let vowel = noun.starts_with(['a', 'e', 'i', 'o']);
    format!("{} {noun}", if vowel { "an" } else { "a" })
}

/// A piece of source text between backquotes, cut after 48 characters.
pub(crate) fn quoted(text: &str) -> String {
    match text.char_indices().nth(48) {
        Some((cut, _)) => format!("`{}..`", &text[..cut]),
        None => format!("`{text}`"),
    }
}

/// A number with at most four significant digits, without zeros that say nothing.
pub(crate) fn rounded(value: f64) -> String {
    let short: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    // Adding 0 takes the sign from -0.
    let short = short + 0.0;
    match short.abs() {
        0.0 | 1e-4..1e7 => short.to_string(),
        _ => format!("{short:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_singular() {
        assert_eq!(counted(1, "cell"), "1 cell");
        assert_eq!(counted(0, "cell"), "0 cells");
        assert_eq!(counted(2, "axis"), "2 axes");
        assert_eq!(a("input"), "an input");
    }

    #[test]
    fn numbers_have_no_padding() {
        assert_eq!(rounded(1.0), "1");
        assert_eq!(rounded(-0.0), "0");
        assert_eq!(rounded(2.0 / 3.0), "0.6667");
        assert_eq!(rounded(1.0 / 3.0 * 1e-9), "3.333e-10");
        assert_eq!(rounded(f64::INFINITY), "inf");
    }
}
