//! Guarantees that a disturbance observer fits its block and converges.

use super::Context;
use super::linear::{minus_product, rightmost_eigenvalue};
use super::numbers::Numbers;
use crate::diagnostic::Rule;
use crate::expr::arena::Shape;
use crate::model::{Disturbance, Exosystem, Matrix};
use crate::spec::Formula;
use crate::unit::Dimension;

impl Context<'_> {
    /// S of a block, with which the observer's error decays.
    pub(super) fn observer(
        &mut self,
        formula: &Formula,
        disturbance: &Disturbance,
        block: &str,
    ) -> Option<Matrix> {
        let what = format!("observer of block `{block}`");
        let (gain, error_dynamics, name) = match disturbance {
            Disturbance::None => return None,
            // (20): the estimate follows at the rate S
            Disturbance::Bounded(_) => {
                let gain = self.square_gain(formula, &what)?;
                let negative = gain.data.iter().map(|entry| -entry).collect();
                (
                    gain.clone(),
                    Matrix {
                        data: negative,
                        ..gain
                    },
                    "-S",
                )
            }
            // (49): the error of w_hat follows M - S L
            Disturbance::Exosystem(channels) => {
                let gain = self.exosystem_gain(formula, channels, &what)?;
                let (m, l) = block_diagonal(channels);
                let closed = minus_product(&m, &gain, &l);
                (gain, closed, "M - S L")
            }
        };
        match rightmost_eigenvalue(&error_dynamics) {
            Some((re, _)) if re < 0.0 => Some(gain),
            Some((re, im)) => {
                let eigenvalue = if im > 0.0 {
                    format!("{re:.4} +- {im:.4}i")
                } else {
                    format!("{re:.4}")
                };
                let message =
                    format!("{what} does not converge: {name} has the eigenvalue {eigenvalue}");
                self.fault(
                    Rule::E0707,
                    formula.span(),
                    message,
                    format!("choose S so that every eigenvalue of {name} has a negative real part"),
                );
                None
            }
            None => {
                self.fault(
                    Rule::E0707,
                    formula.span(),
                    format!("eigenvalues of {name} of the {what} cannot be computed"),
                    "scale its entries",
                );
                None
            }
        }
    }

    fn exosystem_gain(
        &mut self,
        formula: &Formula,
        channels: &[Exosystem],
        what: &str,
    ) -> Option<Matrix> {
        let Numbers {
            shape,
            values,
            dimensions,
            span,
            places: _,
        } = self.numbers(formula)?;
        let rows: usize = channels.iter().map(|channel| channel.m.rows).sum();
        let cols = channels.len();
        // A list of numbers is a column, the whole of S for a block with one channel.
        if shape.size() != (rows, cols) {
            let message = format!("{what} is {shape}, expected a {rows} x {cols} matrix");
            self.fault(
                Rule::E0605,
                span,
                message,
                "S has a row for each exosystem state and a column for each channel",
            );
            return None;
        }
        if let Some(found) = dimensions.iter().find(|&&found| found != Dimension::ONE) {
            self.fault(
                Rule::E0604,
                span,
                format!(
                    "unit mismatch: {what} has an entry in {found}, expected bare numbers in SI"
                ),
                "remove the unit",
            );
            return None;
        }
        debug_assert_eq!(Shape::Matrix(rows, cols).entries(), values.len());
        Some(Matrix {
            rows,
            cols,
            data: values,
        })
    }
}

/// M and L of all channels together.
fn block_diagonal(channels: &[Exosystem]) -> (Matrix, Matrix) {
    let states: usize = channels.iter().map(|channel| channel.m.rows).sum();
    let mut m = Matrix {
        rows: states,
        cols: states,
        data: vec![0.0; states * states],
    };
    let mut l = Matrix {
        rows: channels.len(),
        cols: states,
        data: vec![0.0; channels.len() * states],
    };
    let mut first = 0;
    for (row, channel) in channels.iter().enumerate() {
        let own = channel.m.rows;
        for i in 0..own {
            for j in 0..own {
                m.data[(first + i) * states + first + j] = channel.m.data[i * own + j];
            }
            l.data[row * states + first + i] = channel.l.data[i];
        }
        first += own;
    }
    (m, l)
}
