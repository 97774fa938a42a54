//! Guarantees that a disturbance is a function of time in the block's units, or one linear system for each channel.

use super::Context;
use crate::diagnostic::{Rule, Span, counted};
use crate::expr::Expected;
use crate::expr::arena::Shape;
use crate::model::{Disturbance, Exosystem, Matrix};
use crate::spec::{self, Formula, Located, Read, Unreadable};
use crate::unit::Dimension;

/// Most states and noise inputs of one exosystem.
pub(super) const MAX_EXOSYSTEM: usize = 16;

impl Context<'_> {
    /// d of a block.
    pub(super) fn disturbance(
        &mut self,
        written: Option<&Located<Read<spec::Disturbance>>>,
        rates: Option<&[Dimension]>,
        reasons: &[(Span, String)],
        what: &str,
    ) -> Option<Disturbance> {
        match written.map(|written| (&written.value, written.span)) {
            None => Some(Disturbance::None),
            Some((Err(Unreadable), _)) => None,
            Some((Ok(spec::Disturbance::Bounded(formula)), _)) => {
                let expected = rates.map(|rates| Expected {
                    what,
                    shape: Shape::Vector(rates.len()),
                    dimensions: rates,
                    reasons,
                    columns: &[],
                });
                let (id, parsed) = self.formula(formula, expected.as_ref())?;
                self.check_signal(&parsed, what)?;
                Some(Disturbance::Bounded(id))
            }
            Some((Ok(spec::Disturbance::Exosystem(channels)), span)) => {
                let wanted = rates.map_or(channels.len(), <[Dimension]>::len);
                if channels.len() != wanted {
                    let message = format!(
                        "{what} has {}, expected {wanted}, one for each state",
                        counted(channels.len(), "exosystem"),
                    );
                    self.fault(
                        Rule::E0503,
                        span,
                        message,
                        "write `{M: [[0]], L: [1]}` for a channel with a constant disturbance",
                    );
                    return None;
                }
                let channels: Vec<Option<Exosystem>> = channels
                    .iter()
                    .map(|channel| self.exosystem(channel))
                    .collect();
                channels
                    .into_iter()
                    .collect::<Option<_>>()
                    .map(Disturbance::Exosystem)
            }
        }
    }

    fn exosystem(&mut self, written: &spec::Exosystem) -> Option<Exosystem> {
        let m = self.bare_matrix(&written.m, "M");
        let l = self.bare_matrix(&written.l, "L");
        let n = written
            .n
            .as_ref()
            .map(|formula| self.bare_matrix(formula, "N"));
        let initial = written
            .initial
            .as_ref()
            .map(|formula| self.bare_matrix(formula, "initial"));
        let (m, l) = (m?, l?);
        let states = m.rows;
        let mut check =
            |found: &Matrix, (rows, cols): (usize, usize), what: &str, formula: &Formula| {
                let fits = (found.rows, found.cols) == (rows, cols);
                if !fits {
                    let message = format!(
                        "`{what}` of an exosystem is {} x {}, expected {rows} x {cols}",
                        found.rows, found.cols
                    );
                    self.fault(
                        Rule::E0503,
                        formula.span(),
                        message,
                        "M is square, N has as many rows, L one row of as many entries",
                    );
                }
                fits
            };
        // A list of numbers is a column; for L it stands for a row.
        let l = if l.cols == 1 {
            Matrix {
                rows: 1,
                cols: l.rows,
                data: l.data,
            }
        } else {
            l
        };
        let mut fits = check(
            &m,
            (states.min(MAX_EXOSYSTEM), states.min(MAX_EXOSYSTEM)),
            "M",
            &written.m,
        );
        fits &= check(&l, (1, states), "L", &written.l);
        let n = match (n, &written.n) {
            (Some(n), Some(formula)) => {
                let n = n?;
                fits &= check(&n, (states, n.cols.min(MAX_EXOSYSTEM)), "N", formula);
                n
            }
            _ => Matrix {
                rows: states,
                cols: 0,
                data: Vec::new(),
            },
        };
        let initial = match (initial, &written.initial) {
            (Some(initial), Some(formula)) => {
                let initial = initial?;
                fits &= check(&initial, (states, 1), "initial", formula);
                initial.data
            }
            _ => vec![0.0; states],
        };
        fits.then_some(Exosystem { m, n, l, initial })
    }

    /// A matrix of bare numbers in SI.
    fn bare_matrix(&mut self, formula: &Formula, what: &str) -> Option<Matrix> {
        let numbers = self.numbers_for(formula, &format!("`{what}`"))?;
        if let Some(found) = numbers
            .dimensions
            .iter()
            .find(|&&found| found != Dimension::ONE)
        {
            self.fault(
                Rule::E0604,
                numbers.span,
                format!(
                    "unit mismatch: `{what}` has an entry in {found}, expected bare numbers in SI"
                ),
                "remove the unit",
            );
            return None;
        }
        Some(numbers.matrix())
    }
}
