//! Hexadecimal floating point, as Python's `float.hex` writes it: exact, and independent of any decimal parser.

/// The finite value of `text`, such as `0x1.8p+1` or `-0x0.0p+0`; `None` if it is written otherwise.
pub(crate) fn parse(text: &str) -> Option<f64> {
    let (negative, rest) = text
        .strip_prefix('-')
        .map_or((false, text), |rest| (true, rest));
    let (mantissa, exponent) = rest.strip_prefix("0x")?.split_once('p')?;
    let (lead, digits) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if digits.len() > 13 || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
        return None;
    }
    let fraction = u64::from_str_radix(&format!("{digits:0<13}"), 16).ok()?;
    let exponent: i64 = exponent.parse().ok()?;
    let biased = match lead {
        "1" if (-1022..=1023).contains(&exponent) => u64::try_from(exponent + 1023).ok()?,
        "0" if fraction == 0 || exponent == -1022 => 0,
        _ => return None,
    };
    Some(f64::from_bits(
        u64::from(negative) << 63 | biased << 52 | fraction,
    ))
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn values_are_exact() {
        let cases = [
            ("0x1.8000000000000p+1", 3.0),
            ("-0x1.921fb54442d18p+1", -std::f64::consts::PI),
            ("0x0.0p+0", 0.0),
            ("0x0.0000000000001p-1022", f64::from_bits(1)),
            ("0x1.fffffffffffffp+1023", f64::MAX),
        ];
        for (text, value) in cases {
            assert_eq!(
                parse(text).map(f64::to_bits),
                Some(value.to_bits()),
                "{text}"
            );
        }
    }

    #[test]
    fn anything_else_is_refused() {
        for text in [
            "",
            "1.5",
            "0x2.0p+0",
            "0x1.0p+1024",
            "0x1.00000000000000p+0",
            "inf",
            "nan",
            "0x1.+p+0",
            "0x1.0p",
            "--0x1.0p+0",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
