//! JSON text.

use std::format;
use std::string::{String, ToString};

use crate::ensemble::{RatioQuantiles, Summary, WorstRun};

/// The result object of a campaign.
pub(super) fn summary(summary: &Summary) -> String {
    let steps = summary.samples - summary.runs.min(summary.samples);
    object([
        ("runs", summary.runs.to_string()),
        ("samples", summary.samples.to_string()),
        (
            "violations",
            optional(summary.violations, |count| count.to_string()),
        ),
        ("violated", optional(summary.violated, number)),
        (
            "violated_interval95",
            optional(summary.violated_interval95, |(low, high)| {
                array([low, high].map(number))
            }),
        ),
        ("ratio", optional(summary.ratio, quantiles)),
        ("settled_ratio", optional(summary.settled_ratio, quantiles)),
        ("worst", array(summary.worst.iter().map(worst))),
        (
            "rms_tracking",
            object(
                summary
                    .rms_tracking
                    .iter()
                    .map(|&(name, rms)| (name, number(rms))),
            ),
        ),
        (
            "saturated_fraction",
            object(
                summary
                    .saturated_fraction
                    .iter()
                    .map(|&(name, fraction)| (name, number(fraction))),
            ),
        ),
        ("nonfinite", summary.nonfinite.to_string()),
        ("wall_s", number(summary.wall_s)),
        ("steps_per_s", number(steps as f64 / summary.wall_s)),
    ])
}

fn quantiles(ratio: RatioQuantiles) -> String {
    let RatioQuantiles {
        median,
        p90,
        p99,
        max,
        accuracy,
    } = ratio;
    let fields = [
        ("median", median),
        ("p90", p90),
        ("p99", p99),
        ("max", max),
        ("accuracy", accuracy),
    ];
    object(fields.map(|(name, value)| (name, number(value))))
}

fn worst(worst: &WorstRun) -> String {
    object([
        ("run", worst.run.to_string()),
        ("ratio", number(worst.ratio)),
        ("diverged", worst.diverged.to_string()),
    ])
}

/// Shortest text that reads back as the same number; `null` for NaN and infinities, which JSON has not.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() {
        format!("{value:?}")
    } else {
        "null".to_string()
    }
}

/// A quoted string.
pub(super) fn string(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c < ' ' => quoted.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// An array of values already in JSON.
pub(super) fn array(values: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", separated(values))
}

fn object<'a>(fields: impl IntoIterator<Item = (&'a str, String)>) -> String {
    format!(
        "{{{}}}",
        separated(
            fields
                .into_iter()
                .map(|(name, value)| format!("{}: {value}", string(name)))
        )
    )
}

fn optional<T>(value: Option<T>, json: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "null".to_string(), json)
}

fn separated(values: impl IntoIterator<Item = String>) -> String {
    let mut text = String::new();
    for value in values {
        if !text.is_empty() {
            text.push_str(", ");
        }
        text.push_str(&value);
    }
    text
}

#[cfg(test)]
mod tests {
    use std::string::ToString;

    use super::{array, number, object, string};

    #[test]
    fn numbers_are_shortest_and_valid() {
        for (value, text) in [
            (0.1, "0.1"),
            (1.0, "1.0"),
            (-0.0, "-0.0"),
            (1e300, "1e300"),
            (5e-324, "5e-324"),
            (f64::NAN, "null"),
        ] {
            assert_eq!(number(value), text);
        }
        assert_eq!(number(f64::NEG_INFINITY), "null");
    }

    #[test]
    fn strings_are_escaped() {
        assert_eq!(string("a\"b\\c\n"), r#""a\"b\\c\u000a""#);
    }

    #[test]
    fn composites_are_separated_by_commas() {
        assert_eq!(
            object([
                ("a", "1".to_string()),
                ("b", array(["2".to_string(), "3".to_string()]))
            ]),
            r#"{"a": 1, "b": [2, 3]}"#
        );
        assert_eq!(array([]), "[]");
    }
}
