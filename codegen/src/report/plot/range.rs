//! The part of the number line that an axis shows.

use super::Plot;

/// Ends of an axis, in the coordinate that is drawn (the logarithm on a logarithmic axis).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    /// Lower end.
    pub low: f64,
    /// Upper end, above `low`.
    pub high: f64,
}

impl Range {
    /// Position of a coordinate: 0 at the lower end, 1 at the upper.
    pub(super) fn position(self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }
}

/// The whole time axis.
pub(super) fn time(t: &[f64]) -> Range {
    let (low, high) = extent(t.iter().copied()).unwrap_or((0.0, 1.0));
    Range {
        low,
        high: if high > low { high } else { low + 1.0 },
    }
}

/// All ordinates with a little air; whole decades on a logarithmic axis.
pub(super) fn ordinate(plot: &Plot) -> Range {
    let values = plot
        .marks
        .iter()
        .flat_map(|mark| mark.values())
        .map(|value| coordinate(plot, value));
    let (low, high) = extent(values).unwrap_or((0.0, 1.0));
    if plot.log {
        // Fifteen decades below the top is rounding noise of the quantity's own scale.
        let high = high.ceil();
        let low = low.floor().max(high - 15.0);
        return Range {
            low,
            high: if high > low { high } else { low + 1.0 },
        };
    }
    let air = if high > low {
        0.05 * (high - low)
    } else {
        (0.1 * high.abs()).max(f64::MIN_POSITIVE.sqrt())
    };
    let air = if high == 0.0 && low == 0.0 { 1.0 } else { air };
    Range {
        low: low - air,
        high: high + air,
    }
}

/// The coordinate that is drawn for an ordinate; NaN where there is none.
pub(super) fn coordinate(plot: &Plot, value: f64) -> f64 {
    match plot.log {
        true if value > 0.0 => value.log10(),
        true => f64::NAN,
        false => value,
    }
}

fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values
        .filter(|value| value.is_finite())
        .fold(None, |seen, value| match seen {
            None => Some((value, value)),
            Some((low, high)) => Some((low.min(value), high.max(value))),
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::plot::{Ink, Mark};

    fn plot(log: bool, y: &[f64]) -> Plot {
        let mark = Mark::Line {
            label: String::new(),
            ink: Ink::Actual,
            y: y.to_vec(),
        };
        Plot {
            title: String::new(),
            unit: String::new(),
            log,
            t: vec![0.0; y.len()],
            marks: vec![mark],
        }
    }

    #[test]
    fn a_range_is_never_empty() {
        for y in [
            &[][..],
            &[0.0],
            &[2.0, 2.0],
            &[f64::NAN],
            &[-1e300, 1e300],
            &[f64::INFINITY, 1.0],
        ] {
            for log in [false, true] {
                let range = ordinate(&plot(log, y));
                assert!(
                    range.low.is_finite() && range.high > range.low,
                    "{y:?} {log}: {range:?}"
                );
            }
        }
    }

    #[test]
    fn a_logarithmic_axis_shows_whole_decades() {
        assert_eq!(
            ordinate(&plot(true, &[0.002, 30.0, 0.0])),
            Range {
                low: -3.0,
                high: 2.0
            }
        );
    }
}
