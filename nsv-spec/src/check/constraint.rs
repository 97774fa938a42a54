//! Guarantees that a constraint stays positive over the horizon, and compares kbar with the bound that the theorem asks for.

use super::Context;
use super::initial::Point;
use super::plant::state_reason;
use crate::diagnostic::{Diagnostic, Rule, Span, rounded};
use crate::expr::Expected;
use crate::expr::arena::{ExprId, Shape};
use crate::spec::{AutoCode, Formula};
use crate::unit::Dimension;

/// Times at which functions of time are examined, evenly over the horizon; fewer if the model is so large that it would take long.
const SAMPLES: usize = 2000;
const SMALLEST_SAMPLES: usize = 20;
const EVALUATIONS: usize = 10_000_000;
/// v of the condition kbar >= sup sqrt((k'/k)^2 + v).
const V: f64 = 1e-6;
const PER_SECOND: Dimension = Dimension::new(0, 0, -1, 0);

impl Context<'_> {
    /// k(t) of a block.
    pub(super) fn constraint(&mut self, at: usize, formula: &Formula) -> Option<ExprId> {
        let what = format!("constraint of block `{}`", self.spec.blocks[at].name.value);
        let dimension = self.error_dimension(at);
        let reasons: Vec<_> = match (&*self.spec.blocks[at].value.states, dimension) {
            ([state], Some(dimension)) => vec![state_reason(&state.name, dimension)],
            _ => Vec::new(),
        };
        let expected = dimension.as_ref().map(|dimension| Expected {
            what: &what,
            shape: Shape::Scalar,
            dimensions: std::slice::from_ref(dimension),
            reasons: &reasons,
            columns: &[],
        });
        self.check_degrees_of((at, 0), &what, formula);
        let (id, parsed) = self.formula(formula, expected.as_ref())?;
        self.check_signal(&parsed, &what)?;
        dimension.map(|_| id)
    }

    /// The times at which functions of time are examined.
    pub(super) fn sample_times(&self, horizon: f64) -> Vec<f64> {
        let samples = (EVALUATIONS / self.arena.len().max(1)).clamp(SMALLEST_SAMPLES, SAMPLES);
        (0..=samples)
            .map(|sample| horizon * sample as f64 / samples as f64)
            .collect()
    }

    /// Reports the first time at which a constraint is not a positive number.
    pub(super) fn check_constraint(
        &mut self,
        id: ExprId,
        span: Span,
        block: &str,
        horizon: f64,
    ) -> Option<()> {
        for t in self.sample_times(horizon) {
            let k = self.evaluate(id, &Point::at(t))[0];
            if !(k > 0.0 && k.is_finite()) {
                let message = format!(
                    "constraint of block `{block}` is {k} at t = {t} s, expected a positive number"
                );
                self.fault(
                    Rule::E0708,
                    span,
                    message,
                    "choose a bound that stays positive over the whole horizon",
                );
                return None;
            }
        }
        Some(())
    }

    /// kbar, computed or compared with its bound.
    pub(super) fn kbar(
        &mut self,
        written: &AutoCode,
        constraint: Option<ExprId>,
        block: &str,
        horizon: Option<f64>,
    ) -> Option<f64> {
        let given = match written {
            AutoCode::Code(code) => {
                Some(self.positive_gain(code, &format!("`kbar` of block `{block}`"), PER_SECOND)?)
            }
            AutoCode::Auto(_) => None,
        };
        let rate = match constraint {
            Some(constraint) => self.fastest_shrinking(constraint, horizon?),
            None => 0.0,
        };
        let bound = libm::sqrt(rate * rate + V);
        let Some(kbar) = given else {
            let kbar = round_up(bound);
            let reason = if constraint.is_some() {
                "sup sqrt((k'/k)^2 + 1e-6) over the horizon, rounded up"
            } else {
                "sqrt(1e-6), there being no constraint"
            };
            self.default(
                format!("controller.blocks.{block}.kbar"),
                &format!("{kbar} 1/s"),
                reason,
            );
            return Some(kbar);
        };
        if let AutoCode::Code(code) = written
            && kbar < bound
        {
            let message = format!(
                "`kbar` of block `{block}` is {kbar}, below sup sqrt((k'/k)^2 + 1e-6) = {}",
                rounded(bound)
            );
            let warning = Diagnostic::warning(Rule::W0001, code.base.span, message);
            self.warnings.push(warning.with_help(
                "the theorem does not hold; write `kbar: auto` for the least value that it allows",
            ));
        }
        Some(kbar)
    }

    /// Largest |k'/k| over the horizon, by central differences.
    fn fastest_shrinking(&mut self, constraint: ExprId, horizon: f64) -> f64 {
        let half_step = horizon * 1e-6;
        let mut fastest: f64 = 0.0;
        for t in self.sample_times(horizon) {
            let t = t.max(half_step);
            let [before, now, after] = [t - half_step, t, t + half_step]
                .map(|t| self.evaluate(constraint, &Point::at(t))[0]);
            let rate = ((after - before) / (2.0 * half_step) / now).abs();
            fastest = if rate.is_finite() {
                fastest.max(rate)
            } else {
                fastest
            };
        }
        fastest
    }
}

/// The next number with three significant digits.
fn round_up(value: f64) -> f64 {
    let digits = format!("{value:.2e}");
    let rounded: f64 = digits
        .parse()
        .expect("invariant: a finite number reads back");
    if rounded >= value {
        return rounded;
    }
    // One more in the last place, in decimal, so that no binary noise shows.
    let (mantissa, exponent) = digits
        .split_once('e')
        .expect("invariant: scientific notation has an exponent");
    let hundredths: f64 = mantissa
        .replace('.', "")
        .parse()
        .expect("invariant: three digits");
    let exponent: i32 = exponent.parse().expect("invariant: an integer exponent");
    format!("{}e{}", hundredths + 1.0, exponent - 2)
        .parse()
        .expect("invariant: a finite number reads back")
}

#[cfg(test)]
mod tests {
    use super::round_up;

    #[test]
    fn rounding_goes_up_in_decimal() {
        assert_eq!(round_up(0.857_143), 0.858);
        assert_eq!(round_up(0.001), 0.001);
        assert_eq!(round_up(9.995), 10.0);
        assert_eq!(round_up(9.992), 10.0);
        assert_eq!(round_up(1234.0), 1240.0);
    }
}
