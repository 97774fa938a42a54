//! Guarantees that every gain has its shape, its unit and its sign.

use super::Context;
use super::linear;
use super::numbers::Numbers;
use crate::diagnostic::{Rule, Span, rounded};
use crate::expr::arena::Shape;
use crate::model::{ErrorBound, Matrix, NoiseBound, PhiFloor};
use crate::spec::{self, AutoCode, Code, Formula};
use crate::unit::Dimension;

const PER_SECOND: Dimension = Dimension::new(0, 0, -1, 0);

impl Context<'_> {
    /// A positive scalar gain.
    pub(super) fn positive_gain(
        &mut self,
        code: &Code,
        what: &str,
        dimension: impl Into<Option<Dimension>>,
    ) -> Option<f64> {
        let value = self.gain(code, what, dimension)?;
        self.positive(value, code.base.span, what)?;
        Some(value)
    }

    /// Reports a number that is not positive.
    pub(super) fn positive(&mut self, value: f64, span: Span, what: &str) -> Option<()> {
        if value > 0.0 {
            return Some(());
        }
        self.fault(
            Rule::E0601,
            span,
            format!("{what} is {value}, expected a positive number"),
            "write a number above 0",
        );
        None
    }

    /// A positive gain for each channel, given as one for all or as a list.
    pub(super) fn channel_gains(
        &mut self,
        formula: &Formula,
        what: &str,
        dimension: impl Into<Option<Dimension>>,
    ) -> Option<Vec<f64>> {
        let numbers = self.gain_numbers(formula, what, dimension.into())?;
        let width = self.width.unwrap_or(numbers.values.len());
        let gains = match numbers.shape {
            Shape::Scalar => vec![numbers.values[0]; width],
            Shape::Vector(rows) if rows == width => numbers.values,
            // It may be the block that has too many states.
            _ if !self.even => return None,
            shape => {
                let (message, help) = match width {
                    1 => (
                        format!(
                            "{what} is {shape}, expected one number, as the block has one state"
                        ),
                        "write one number".to_owned(),
                    ),
                    _ => (
                        format!(
                            "{what} is {shape}, expected a scalar or a vector of {width}, one number for each state"
                        ),
                        format!("write one number for all states, or a list of {width}"),
                    ),
                };
                self.fault(Rule::E0605, numbers.span, message, help);
                return None;
            }
        };
        for (channel, &gain) in gains.iter().enumerate() {
            let what = if numbers.shape == Shape::Scalar {
                what.to_owned()
            } else {
                format!("entry {} of {what}", channel + 1)
            };
            let place = numbers.places.get(channel).copied();
            self.positive(gain, place.unwrap_or(numbers.span), &what)?;
        }
        Some(gains)
    }

    /// A square gain, given as a scalar, its diagonal, or a matrix.
    pub(super) fn square_gain(&mut self, formula: &Formula, what: &str) -> Option<Matrix> {
        let numbers = self.gain_numbers(formula, what, Some(PER_SECOND))?;
        let width = self.width?;
        let diagonal = match numbers.shape {
            Shape::Scalar => vec![numbers.values[0]; width],
            Shape::Vector(rows) if rows == width => numbers.values,
            Shape::Matrix(rows, cols) if rows == width && cols == width => {
                return Some(numbers.matrix());
            }
            _ if !self.even => return None,
            shape => {
                let (message, help) = match width {
                    1 => (
                        format!(
                            "{what} is {shape}, expected one number, as the block has one state"
                        ),
                        "write one number".to_owned(),
                    ),
                    _ => (
                        format!(
                            "{what} is {shape}, expected a scalar, a vector of {width} or a {width} x {width} matrix"
                        ),
                        format!(
                            "write one number, a diagonal of {width}, or {width} rows of {width}"
                        ),
                    ),
                };
                self.fault(Rule::E0605, numbers.span, message, help);
                return None;
            }
        };
        let mut data = vec![0.0; width * width];
        diagonal
            .iter()
            .enumerate()
            .for_each(|(i, value)| data[i * (width + 1)] = *value);
        Some(Matrix {
            rows: width,
            cols: width,
            data,
        })
    }

    fn gain_numbers(
        &mut self,
        formula: &Formula,
        what: &str,
        dimension: Option<Dimension>,
    ) -> Option<Numbers> {
        let numbers = self.numbers_for(formula, what)?;
        let Some(dimension) = dimension else {
            return Some(numbers);
        };
        for (&found, &place) in numbers.dimensions.iter().zip(&numbers.places) {
            self.check_gain_unit(found, place, what, dimension)?;
        }
        self.check_no_angle(formula, what, dimension)?;
        Some(numbers)
    }

    /// C of the anti-windup system (13): its symmetric part is positive definite, so that zeta decays.
    pub(super) fn anti_windup(&mut self, formula: &Formula, block: &str) -> Option<Matrix> {
        let what = format!("`C` of block `{block}`");
        let c = self.square_gain(formula, &what)?;
        match linear::least_symmetric_eigenvalue(&c) {
            Some(least) if least > 0.0 => Some(c),
            Some(least) => {
                let (message, help) = match c.data.as_slice() {
                    [only] => (
                        format!("{what} is {}, expected more than 0", rounded(*only)),
                        "write a positive number",
                    ),
                    _ => (
                        format!(
                            "{what} is not positive definite: its symmetric part has the eigenvalue {}",
                            rounded(least)
                        ),
                        "choose positive diagonal entries that dominate the others",
                    ),
                };
                self.fault(Rule::E0608, formula.span(), message, help);
                None
            }
            None => {
                self.fault(
                    Rule::E0608,
                    formula.span(),
                    format!("{what} has no eigenvalues that can be computed"),
                    "scale its entries",
                );
                None
            }
        }
    }

    /// The law of eps_hat (66).
    pub(super) fn error_bound(
        &mut self,
        at: usize,
        written: &spec::ErrorBound,
    ) -> Option<ErrorBound> {
        let block = &self.spec.blocks[at].name.value;
        let rate = self.positive_gain(
            &written.iota,
            &format!("`error_bound.iota` of block `{block}`"),
            PER_SECOND,
        );
        let dimension = self.error_dimension(at);
        let b = self.channel_gains(
            &written.b,
            &format!("`error_bound.b` of block `{block}`"),
            dimension,
        );
        Some(ErrorBound { rate: rate?, b: b? })
    }

    /// The laws of sigma_hat (67) and phi (68).
    pub(super) fn noise_bound(
        &mut self,
        at: usize,
        written: &spec::NoiseBound,
    ) -> Option<NoiseBound> {
        let block = &self.spec.blocks[at].name.value;
        let mut bare = |code: &Code, key: &str| {
            self.positive_gain(
                code,
                &format!("`noise_bound.{key}` of block `{block}`"),
                Dimension::ONE,
            )
        };
        let tau = bare(&written.tau, "tau");
        let lambda = bare(&written.lambda, "lambda");
        let varsigma = bare(&written.varsigma, "varsigma");
        let phi_initial = bare(&written.phi_initial, "phi.initial");
        let phi_min = match &written.phi_min {
            Some(AutoCode::Code(code)) => bare(code, "phi.min").map(PhiFloor::Value),
            Some(AutoCode::Auto(_)) => Some(PhiFloor::Auto),
            None => {
                self.default(
                    format!("controller.blocks.{block}.noise_bound.phi.min"),
                    "auto",
                    "sqrt(Psi dt / 0.1) bounds the gain by 0.1 per sample",
                );
                Some(PhiFloor::Auto)
            }
        };
        let kappa = format!("`noise_bound.phi.kappa` of block `{block}`");
        let phi_kappa = self.positive_gain(&written.phi_kappa, &kappa, PER_SECOND);
        let threshold = format!("`noise_bound.phi.threshold` of block `{block}`");
        let dimension = self.error_dimension(at);
        let phi_threshold = self.positive_gain(&written.phi_threshold, &threshold, dimension);
        Some(NoiseBound {
            tau: tau?,
            lambda: lambda?,
            varsigma: varsigma?,
            phi_initial: phi_initial?,
            phi_kappa: phi_kappa?,
            phi_threshold: phi_threshold?,
            phi_min: phi_min?,
        })
    }

    /// The dimension of a block's error: that of its states if they share one, else a pure number of SI values; `None` where some
    /// are not known.
    pub(super) fn error_dimension(&self, at: usize) -> Option<Dimension> {
        let states = self.states.get(at)?.as_ref()?;
        let first = states.first()?.dimension;
        let shared = states.iter().all(|state| state.dimension == first);
        Some(if shared { first } else { Dimension::ONE })
    }
}
