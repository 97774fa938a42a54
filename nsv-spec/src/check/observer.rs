//! Guarantees that a disturbance observer fits its block and converges.

use super::Context;
use super::linear::{minus_product, rightmost_eigenvalue};
use super::numbers::Numbers;
use crate::diagnostic::{Rule, rounded};
use crate::expr::arena::Shape;
use crate::model::{Disturbance, Exosystem, Matrix};
use crate::spec::{self, Formula, Named};
use crate::unit::Dimension;

impl Context<'_> {
    /// S of a block, with which the observer's error decays; `None` for a disturbance with a fault.
    pub(super) fn observer(
        &mut self,
        formula: &Formula,
        at: usize,
        disturbance: Option<&Disturbance>,
    ) -> Option<Matrix> {
        let Named { name, value: block } = &self.spec.blocks[at];
        let what = format!("observer of block `{}`", name.value);
        let written = block.disturbance.as_ref().map(|given| &given.value);
        let bounded = matches!(written, Some(Ok(spec::Disturbance::Bounded(_))));
        let (gain, error_dynamics, remedy) = match disturbance {
            // (20): the estimate follows at the rate S
            _ if bounded => {
                let gain = self.square_gain(formula, &what)?;
                let negative = gain.data.iter().map(|entry| -entry).collect();
                let error_dynamics = Matrix {
                    data: negative,
                    ..gain
                };
                let remedy = match gain.data.len() {
                    1 => "write a positive number",
                    _ => {
                        "write positive numbers on the diagonal that dominate the others: every eigenvalue of `observer` (S) has a positive real part"
                    }
                };
                (gain, error_dynamics, remedy)
            }
            // (49): the error of w_hat follows M - S L
            Some(Disturbance::Exosystem(channels)) => {
                let gain = self.exosystem_gain(formula, channels, &what)?;
                let (m, l) = block_diagonal(channels);
                let closed = minus_product(&m, &gain, &l);
                let remedy = "choose `observer` (S) so that every eigenvalue of M - S L has a negative real part, with `M` and `L` of the exosystems";
                (gain, closed, remedy)
            }
            _ => {
                self.numbers_for(formula, &what);
                return None;
            }
        };
        let span = formula.span();
        let Some((re, im)) = rightmost_eigenvalue(&error_dynamics) else {
            let message = format!("eigenvalues of the error of the {what} cannot be computed");
            self.fault(Rule::E0707, span, message, "scale its entries");
            return None;
        };
        if re < 0.0 {
            return Some(gain);
        }
        let swings = match im > 0.0 {
            true => format!(", swinging at {} rad/s", rounded(im)),
            false => String::new(),
        };
        let error = match re > 0.0 {
            true => format!("its error grows as exp({} t){swings}", rounded(re)),
            false => format!("its error does not decay{swings}"),
        };
        let message = match gain.data.as_slice() {
            [only] if bounded => {
                format!(
                    "{what} is {}, expected more than 0: {error}",
                    rounded(*only)
                )
            }
            _ => format!("{what} does not converge: {error}"),
        };
        self.fault(Rule::E0707, span, message, remedy);
        None
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
            ..
        } = self.numbers_for(formula, what)?;
        let rows: usize = channels.iter().map(|channel| channel.m.rows).sum();
        let cols = channels.len();
        // A list of numbers is a column, the whole of S for a block with one channel.
        if shape.size() != (rows, cols) {
            let message = format!("{what} is {shape}, expected a {rows} x {cols} matrix");
            self.fault(
                Rule::E0605,
                span,
                message,
                "`observer` (S) has a row for each exosystem state and a column for each state of the block",
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
