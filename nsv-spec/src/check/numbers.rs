//! Guarantees that what must be known when the code is generated is a finite number in its unit.

use super::Context;
use super::formula::Parsed;
use super::scope::Place;
use crate::diagnostic::{Rule, Span};
use crate::expr::arena::{Shape, Type};
use crate::model::Matrix;
use crate::spec::{Code, Formula};
use crate::unit::Dimension;

/// A constant expression as numbers.
#[derive(Clone, Debug)]
pub(super) struct Numbers {
    /// Shape.
    pub(super) shape: Shape,
    /// SI values, row-major.
    pub(super) values: Vec<f64>,
    /// Dimension of each.
    pub(super) dimensions: Vec<Dimension>,
    /// Where it is written.
    pub(super) span: Span,
}

impl Numbers {
    /// As a matrix: a vector is a column.
    pub(super) fn matrix(&self) -> Matrix {
        let (rows, cols) = self.shape.size();
        Matrix {
            rows,
            cols,
            data: self.values.clone(),
        }
    }
}

impl Context<'_> {
    /// The numbers of a constant formula.
    pub(super) fn numbers(&mut self, formula: &Formula) -> Option<Numbers> {
        let parsed = self.parse_formula(formula)?;
        self.numbers_of(&parsed)
    }

    /// The numbers of a parsed constant formula, all finite.
    pub(super) fn numbers_of(&mut self, parsed: &Parsed) -> Option<Numbers> {
        let id = self.elaborate(parsed, Place::Constant)?;
        let span = parsed.span();
        let Type::Real { shape, dimensions } = self.arena.ty(id).clone() else {
            self.fault(
                Rule::E0502,
                span,
                "value is a truth value, expected a number",
                "choose numbers with `if(condition, a, b)`",
            );
            return None;
        };
        let values = self.evaluate_constant(id);
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            self.fault(
                Rule::E0603,
                span,
                format!("value is {value}, expected a finite number"),
                "look for a division by zero or a root of a negative number",
            );
            return None;
        }
        let dimensions = dimensions.into_iter().map(Dimension::or_one).collect();
        Some(Numbers {
            shape,
            values,
            dimensions,
            span,
        })
    }

    /// A scalar quantity of a dimension that must be written.
    pub(super) fn quantity(
        &mut self,
        code: &Code,
        what: &str,
        dimension: Dimension,
    ) -> Option<f64> {
        let (value, found) = self.scalar(code, what)?;
        if found == dimension || value == 0.0 && found == Dimension::ONE {
            return Some(value);
        }
        self.unit_mismatch(
            code.base.span,
            what,
            found,
            dimension,
            written_in(dimension),
        );
        None
    }

    /// A scalar gain: in its own dimension, or a bare number in SI.
    pub(super) fn gain(&mut self, code: &Code, what: &str, dimension: Dimension) -> Option<f64> {
        let (value, found) = self.scalar(code, what)?;
        self.check_gain_unit(found, code.base.span, what, dimension)?;
        Some(value)
    }

    pub(super) fn check_gain_unit(
        &mut self,
        found: Dimension,
        span: Span,
        what: &str,
        dimension: Dimension,
    ) -> Option<()> {
        if found == dimension || found == Dimension::ONE {
            return Some(());
        }
        let help = match dimension {
            Dimension::ONE => written_in(dimension),
            _ => format!("write it in {dimension}, or as a bare number in SI"),
        };
        self.unit_mismatch(span, what, found, dimension, help);
        None
    }

    pub(super) fn unit_mismatch(
        &mut self,
        span: Span,
        what: &str,
        found: Dimension,
        expected: Dimension,
        help: impl Into<String>,
    ) {
        let pure = |dimension, otherwise: String| {
            if dimension == Dimension::ONE {
                "a pure number".into()
            } else {
                otherwise
            }
        };
        let (found, expected) = (
            pure(found, format!("in {found}")),
            pure(expected, expected.to_string()),
        );
        let message = format!("unit mismatch: {what} is {found}, expected {expected}");
        self.fault(Rule::E0604, span, message, help);
    }

    /// A constant scalar with its dimension.
    pub(super) fn scalar(&mut self, code: &Code, what: &str) -> Option<(f64, Dimension)> {
        let numbers = self.numbers(&Formula::Code(code.clone()))?;
        if numbers.shape != Shape::Scalar {
            self.fault(
                Rule::E0605,
                numbers.span,
                format!("{what} is {}, expected a scalar", numbers.shape),
                "write one number",
            );
            return None;
        }
        Some((numbers.values[0], numbers.dimensions[0]))
    }
}

/// How to write a quantity of a dimension.
pub(super) fn written_in(dimension: Dimension) -> String {
    if dimension == Dimension::ONE {
        "write it without a unit".into()
    } else {
        format!("write it with its unit, as in `5 {dimension}`")
    }
}
