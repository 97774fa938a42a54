//! Numbers as people read them.

/// A number with four significant digits at most; powers of ten outside 0.001 .. 99999.
pub(crate) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "not finite".to_owned();
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-3..5).contains(&exponent) {
        return format!("{value:.2e}");
    }
    let decimals = usize::try_from(3 - exponent).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A fraction as a percentage with four significant digits at most, and four decimals.
pub(crate) fn percent(fraction: f64) -> String {
    let value = (fraction * 1e6).round() / 1e4;
    let text = if value.abs() < 1e-3 {
        format!("{value:.4}")
    } else {
        short(value)
    };
    format!("{} %", if value == 0.0 { "0" } else { &text })
}

/// A count with its thousands apart.
pub(crate) fn count(value: u64) -> String {
    let digits = value.to_string();
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .filter_map(|group| std::str::from_utf8(group).ok())
        .collect();
    groups.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (0.477_123, "0.4771"),
            (12.5, "12.5"),
            (20000.0, "20000"),
            (1.5e7, "1.50e7"),
            (f64::NAN, "not finite"),
        ] {
            assert_eq!(short(value), text);
        }
        for (fraction, text) in [
            (0.032, "3.2 %"),
            (0.0, "0 %"),
            (2e-6, "0.0002 %"),
            (1e-9, "0 %"),
            (1.0, "100 %"),
        ] {
            assert_eq!(percent(fraction), text);
        }
        assert_eq!(count(5_000_000), "5 000 000");
        assert_eq!(count(12), "12");
    }
}
