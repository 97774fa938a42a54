//! Guarantees that a distribution has finite values in the unit of its quantity, in order, with probabilities that add up.

use super::Context;
use crate::diagnostic::{Rule, Span};
use crate::model::{Dispersion, Truncated};
use crate::spec::{self, Code};
use crate::unit::{Dimension, Unit};

/// How far from its mean, in standard deviations, a normal distribution may be cut off: beyond it nothing is left to draw from.
const FARTHEST: f64 = 5.0;
/// Rounding that probabilities may add up with.
const ROUNDING: f64 = 1e-9;

/// What a distribution is of.
pub(super) struct Dispersed<'a> {
    /// In words.
    pub(super) what: &'a str,
    /// Its dimension.
    pub(super) dimension: Dimension,
    /// The unit that is given beside it, for numbers without one.
    pub(super) unit: Option<&'a Unit>,
}

impl Context<'_> {
    /// A distribution in SI.
    pub(super) fn dispersion(
        &mut self,
        written: &spec::Dispersion,
        of: &Dispersed<'_>,
    ) -> Option<Dispersion> {
        match written {
            spec::Dispersion::Uniform(ends) => {
                let [least, largest] = self.dispersed(ends, of)?;
                self.ordered(least, largest, &ends[1], of.what)?;
                Some(Dispersion::Uniform(least, largest))
            }
            spec::Dispersion::Normal(moments) => {
                let [mean, deviation] = self.dispersed(moments, of)?;
                let what = format!("standard deviation of {}", of.what);
                self.at_least_zero(deviation, &moments[1], &what)?;
                Some(Dispersion::Normal(mean, deviation))
            }
            spec::Dispersion::TruncatedNormal(numbers) => self.truncated(numbers, of),
            spec::Dispersion::Lognormal(numbers) => self.lognormal(numbers, of),
            spec::Dispersion::Discrete(values) => self.discrete(values, of),
        }
    }

    fn truncated(&mut self, written: &[Code; 4], of: &Dispersed<'_>) -> Option<Dispersion> {
        let [mean, deviation, least, largest] = self.dispersed(written, of)?;
        let what = format!("standard deviation of {}", of.what);
        self.positive(deviation, written[1].base.span, &what)?;
        self.ordered(least, largest, &written[3], of.what)?;
        let far = FARTHEST * deviation;
        if least > mean + far || largest < mean - far {
            let message = format!(
                "dispersion of {} is cut off more than {FARTHEST} standard deviations from its mean",
                of.what
            );
            let help = "nothing is left to draw from: move the mean or the ends";
            self.fault(Rule::E0607, written[2].base.span, message, help);
            return None;
        }
        // Of a standard normal distribution.
        let below =
            |end: f64| 0.5 * libm::erfc((mean - end) / deviation * std::f64::consts::FRAC_1_SQRT_2);
        Some(Dispersion::TruncatedNormal(Truncated {
            mean,
            deviation,
            least,
            largest,
            quantiles: (below(least), below(largest)),
        }))
    }

    fn lognormal(&mut self, written: &[Code; 2], of: &Dispersed<'_>) -> Option<Dispersion> {
        let [median] = self.dispersed(std::slice::from_ref(&written[0]).try_into().ok()?, of)?;
        let sigma = self.pure(
            &written[1],
            &format!("standard deviation of the logarithm of {}", of.what),
        )?;
        self.positive(
            median,
            written[0].base.span,
            &format!("median of {}", of.what),
        )?;
        self.at_least_zero(
            sigma,
            &written[1],
            &format!("standard deviation of the logarithm of {}", of.what),
        )?;
        Some(Dispersion::Lognormal { median, sigma })
    }

    fn discrete(&mut self, written: &[[Code; 2]], of: &Dispersed<'_>) -> Option<Dispersion> {
        let mut values = Vec::new();
        for [value, probability] in written {
            let [value] = self.dispersed(std::slice::from_ref(value).try_into().ok()?, of)?;
            let share = self.probability(
                probability,
                &format!("probability in the dispersion of {}", of.what),
            )?;
            values.push((value, share));
        }
        let total: f64 = values.iter().map(|(_, share)| share).sum();
        let last = &written.last()?[1];
        if (total - 1.0).abs() > ROUNDING {
            let message = format!("probabilities of {} add up to {total}, expected 1", of.what);
            self.fault(Rule::E0607, last.base.span, message, "change one of them");
            return None;
        }
        Some(Dispersion::Discrete(values))
    }

    /// Values in the unit of the dispersed quantity.
    fn dispersed<const N: usize>(
        &mut self,
        codes: &[Code; N],
        of: &Dispersed<'_>,
    ) -> Option<[f64; N]> {
        let what = format!("dispersion of {}", of.what);
        let mut values = [Some(0.0); N];
        for (value, code) in values.iter_mut().zip(codes) {
            *value = self
                .value_in(code, of.unit, &what)
                .and_then(|(value, found)| {
                    if found == of.dimension {
                        return Some(value);
                    }
                    self.code_mismatch(code, &what, found, of.dimension);
                    None
                });
        }
        let known: Option<Vec<f64>> = values.into_iter().collect();
        known?.try_into().ok()
    }

    /// A number without dimension.
    pub(super) fn pure(&mut self, code: &Code, what: &str) -> Option<f64> {
        self.quantity(code, what, Dimension::ONE)
    }

    /// A number from 0 to 1.
    pub(super) fn probability(&mut self, code: &Code, what: &str) -> Option<f64> {
        let value = self.pure(code, what)?;
        if (0.0..=1.0).contains(&value) {
            return Some(value);
        }
        let message = format!("{what} is {value}, expected 0 to 1");
        self.fault(Rule::E0602, code.base.span, message, "write a share of 1");
        None
    }

    fn ordered(&mut self, least: f64, largest: f64, end: &Code, what: &str) -> Option<()> {
        if least <= largest {
            return Some(());
        }
        let message = format!("dispersion of {what} ends at {largest} before it starts at {least}");
        self.fault(
            Rule::E0607,
            end.base.span,
            message,
            "write the least value first",
        );
        None
    }

    fn at_least_zero(&mut self, value: f64, code: &Code, what: &str) -> Option<()> {
        self.not_negative(value, code.base.span, what)
    }

    /// Reports a negative number.
    pub(super) fn not_negative(&mut self, value: f64, span: Span, what: &str) -> Option<()> {
        if value >= 0.0 {
            return Some(());
        }
        let message = format!("{what} is {value}, expected at least 0");
        self.fault(Rule::E0602, span, message, "write a number from 0");
        None
    }
}
