//! Text that is safe inside HTML and SVG, and typeset numbers.

use super::number::short;

/// `text` with the characters that mean something in HTML replaced, in content and attributes alike.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// A unit such as `kN*m` or `deg/s^2`, escaped and typeset.
pub(crate) fn unit(text: &str) -> String {
    escape(text)
        .replace("^2", "&sup2;")
        .replace("^3", "&sup3;")
        .replace('*', "&middot;")
}

/// A number as [`short`] writes it, its power of ten typeset.
pub(crate) fn number(value: f64) -> String {
    match short(value).split_once('e') {
        Some((mantissa, power)) if value.is_finite() => {
            format!("{mantissa}&middot;10<sup>{power}</sup>")
        }
        _ => short(value),
    }
}

/// A fraction as a percentage.
pub(crate) fn percent(fraction: f64) -> String {
    super::number::percent(fraction).replace(' ', "&nbsp;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_escaped() {
        assert_eq!(
            escape("<b a=\"1\" c='2'>&\n"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp; "
        );
        assert_eq!(unit("kN*m/s^2<"), "kN&middot;m/s&sup2;&lt;");
    }

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.477_123, "0.4771"),
            (12.5, "12.5"),
            (20000.0, "20000"),
            (-3.0, "-3"),
            (1.5e7, "1.50&middot;10<sup>7</sup>"),
            (2.5e-9, "2.50&middot;10<sup>-9</sup>"),
            (f64::NAN, "not finite"),
        ] {
            assert_eq!(number(value), text);
        }
        assert_eq!(percent(0.032), "3.2&nbsp;%");
    }
}
