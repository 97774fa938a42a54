//! Numbers of the model's expressions, at a time and at the initial state.

use super::Context;
use super::initial::Point;
use crate::expr::arena::{ConstantId, DefinitionId, ExprId, ParameterId, PolynomialId, TableId};
use crate::expr::{self, Environment};
use crate::interpolation::Interpolant;
use crate::model::Polynomial;

/// What the leaves of an expression are worth; `None` for a point where only constants are known.
struct Known<'a> {
    context: &'a Context<'a>,
    point: Option<Point>,
}

impl Environment for Known<'_> {
    fn constant(&self, id: ConstantId) -> Option<Vec<f64>> {
        Some(
            self.context
                .constants
                .get(id.0 as usize)?
                .as_ref()?
                .value
                .data
                .clone(),
        )
    }

    fn parameter(&self, id: ParameterId) -> Option<f64> {
        let parameter = self.context.parameters.get(id.0 as usize)?.as_ref()?;
        Some(if self.point?.design {
            parameter.design_value
        } else {
            parameter.value
        })
    }

    fn state(&self, block: usize, channel: usize) -> Option<f64> {
        self.point?;
        Some(self.context.states.get(block)?.as_ref()?[channel].initial)
    }

    fn truth(&self, at: usize) -> Option<f64> {
        self.point?;
        Some(self.context.truth_states.get(at)?.as_ref()?.initial)
    }

    fn input(&self, at: usize) -> Option<f64> {
        self.point?;
        self.context
            .inputs
            .as_ref()?
            .get(at)
            .map(|input| input.safe)
    }

    fn time(&self) -> Option<f64> {
        Some(self.point?.time)
    }

    fn definition(&self, id: DefinitionId) -> Option<ExprId> {
        Some(self.context.definitions[id.0 as usize].expr)
    }

    fn table(&self, id: TableId) -> Option<&Interpolant> {
        let table = self.context.names.tables.get(id.0 as usize)?;
        Some(&table.as_ref()?.interpolant)
    }

    fn polynomial(&self, id: PolynomialId) -> Option<&Polynomial> {
        self.context.names.polynomials.get(id.0 as usize)
    }
}

impl Context<'_> {
    /// Value of an expression of the model, entries row-major.
    pub(super) fn evaluate(&self, id: ExprId, point: &Point) -> Vec<f64> {
        self.value(id, Some(*point))
    }

    /// Value of an expression of constants.
    pub(super) fn evaluate_constant(&self, id: ExprId) -> Vec<f64> {
        self.value(id, None)
    }

    fn value(&self, id: ExprId, point: Option<Point>) -> Vec<f64> {
        expr::evaluate(
            &self.arena,
            id,
            &Known {
                context: self,
                point,
            },
        )
        .expect("invariant: every leaf has been checked")
    }
}
