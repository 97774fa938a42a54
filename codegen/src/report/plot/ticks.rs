//! Tick marks at round numbers.

/// Tick positions with their labels, and the power of ten that the labels leave out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ticks {
    /// Value and label.
    pub marks: Vec<(f64, String)>,
    /// Labels are values divided by ten to this power.
    pub exponent: i32,
}

/// Ticks at multiples of 1, 2 or 5 times a power of ten inside `low..=high`, about `count` of them.
pub(super) fn linear(low: f64, high: f64, count: u32) -> Ticks {
    let step = round_step((high - low) / f64::from(count));
    let largest = low.abs().max(high.abs());
    let magnitude = power_of(largest);
    let exponent = if (-2..5).contains(&magnitude) {
        0
    } else {
        magnitude
    };
    let decimals = usize::try_from(exponent - power_of(step)).unwrap_or(0);
    let (first, last) = (
        (low / step - 1e-9).ceil() as i64,
        (high / step + 1e-9).floor() as i64,
    );
    let marks = (first..=last).map(|i| {
        let value = i as f64 * step;
        (
            value,
            format!("{:.decimals$}", value / 10f64.powi(exponent) + 0.0),
        )
    });
    Ticks {
        marks: marks.collect(),
        exponent,
    }
}

/// Ticks at powers of ten between two exponents, thinned to about `count`.
pub(super) fn logarithmic(low: i32, high: i32, count: u32) -> Ticks {
    let stride = (high - low).unsigned_abs().div_ceil(count).max(1) as usize;
    let marks = (low..=high)
        .step_by(stride)
        .map(|power| (f64::from(power), format!("1e{power}")));
    Ticks {
        marks: marks.collect(),
        exponent: 0,
    }
}

/// The power of ten of the leading digit.
fn power_of(value: f64) -> i32 {
    if value == 0.0 {
        0
    } else {
        (value.abs().log10() + 1e-12).floor() as i32
    }
}

fn round_step(raw: f64) -> f64 {
    let unit = 10f64.powi(power_of(raw));
    let digit = raw / unit;
    let round = if digit < 1.5 {
        1.0
    } else if digit < 3.5 {
        2.0
    } else if digit < 7.5 {
        5.0
    } else {
        10.0
    };
    round * unit
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64) -> (Vec<String>, i32) {
        let ticks = linear(low, high, 5);
        (
            ticks.marks.into_iter().map(|(_, label)| label).collect(),
            ticks.exponent,
        )
    }

    #[test]
    fn steps_are_one_two_or_five() {
        assert_eq!(labels(0.0, 20.0).0, ["0", "5", "10", "15", "20"]);
        assert_eq!(
            labels(-0.31, 0.29).0,
            ["-0.3", "-0.2", "-0.1", "0.0", "0.1", "0.2"]
        );
        assert_eq!(labels(-1.04, 4.1).0, ["-1", "0", "1", "2", "3", "4"]);
    }

    #[test]
    fn a_common_power_of_ten_is_left_out() {
        assert_eq!(
            labels(-2.0e7, 2.0e7),
            (
                vec!["-2".into(), "-1".into(), "0".into(), "1".into(), "2".into()],
                7
            )
        );
        assert_eq!(labels(0.0, 4e-6).1, -6);
        assert_eq!(labels(0.0, 0.04).1, 0);
    }

    #[test]
    fn zero_has_no_sign() {
        assert!(labels(-1.0, 1.0).0.iter().all(|label| label != "-0.0"));
    }

    #[test]
    fn powers_are_thinned() {
        let ticks = logarithmic(-12, 3, 5);
        assert_eq!(
            ticks
                .marks
                .iter()
                .map(|(_, label)| label.as_str())
                .collect::<Vec<_>>(),
            ["1e-12", "1e-9", "1e-6", "1e-3", "1e0", "1e3"]
        );
    }
}
