//! Guarantees that what must be known when the code is generated is a finite number in its unit.

use super::Context;
use super::formula::Parsed;
use super::scope::Place;
use crate::diagnostic::{Applicability, Diagnostic, Rule, Span, rounded};
use crate::expr::arena::{Shape, Type};
use crate::expr::shown;
use crate::model::Matrix;
use crate::spec::{Code, Formula};
use crate::unit::Dimension;

/// Largest magnitude in SI of a gain, parameter, limit or other number that stands alone under its key, and smallest besides 0. Constants,
/// and numbers inside formulas, may be beyond: formulas are checked to be finite at the start.
pub(super) const LARGEST: f64 = 1e50;
const SMALLEST: f64 = 1e-50;

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
    /// Where each entry is.
    pub(super) places: Vec<Span>,
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

    /// The same for a place with a name, which messages tell: numbers that a law can be computed with.
    pub(super) fn numbers_for(&mut self, formula: &Formula, what: &str) -> Option<Numbers> {
        self.names.subject = Some(what.to_owned());
        let numbers = self.numbers(formula);
        self.names.subject = None;
        let numbers = numbers?;
        let mut all = true;
        for (&value, &place) in numbers.values.iter().zip(&numbers.places) {
            all &= self.is_moderate(value, place, what);
        }
        all.then_some(numbers)
    }

    /// Reports a number so large or small that powers and quotients of it, as in the gains of a law, overflow.
    fn is_moderate(&mut self, value: f64, place: Span, what: &str) -> bool {
        let magnitude = value.abs();
        let expected = if magnitude > LARGEST {
            format!("at most {LARGEST:e}")
        } else if magnitude > 0.0 && magnitude < SMALLEST {
            format!("0 or at least {SMALLEST:e}")
        } else {
            return true;
        };
        self.fault(
            Rule::E0602,
            place,
            format!(
                "{what} is {} in SI, expected a magnitude of {expected}",
                rounded(value)
            ),
            "look for a wrong unit or exponent",
        );
        false
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
            let message = format!("value is {value}, expected a finite number");
            let fault = Diagnostic::error(Rule::E0603, span, message)
                .with_help("look for a division by zero or a root of a negative number");
            let fault = self.with_operation(fault, parsed, None);
            self.faults.push(fault);
            return None;
        }
        let dimensions = dimensions.into_iter().map(Dimension::or_one).collect();
        Some(Numbers {
            shape,
            values,
            dimensions,
            span,
            places: parsed.places(shape),
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
        self.code_mismatch(code, what, found, dimension);
        None
    }

    /// A scalar gain: in its own dimension, where that is known, or a bare number in SI.
    pub(super) fn gain(
        &mut self,
        code: &Code,
        what: &str,
        dimension: impl Into<Option<Dimension>>,
    ) -> Option<f64> {
        let (value, found) = self.scalar(code, what)?;
        let Some(dimension) = dimension.into() else {
            return Some(value);
        };
        self.check_gain_unit(found, code.base.span, what, dimension)?;
        self.check_no_angle(&Formula::Code(code.clone()), what, dimension)?;
        Some(value)
    }

    /// A gain with a dimension is no angle, though the dimension of an angle is that of a bare number.
    pub(super) fn check_no_angle(
        &mut self,
        formula: &Formula,
        what: &str,
        dimension: Dimension,
    ) -> Option<()> {
        if dimension == Dimension::ONE {
            return Some(());
        }
        let code = match formula {
            Formula::List(items, _) => {
                return items
                    .iter()
                    .try_for_each(|item| self.check_no_angle(item, what, dimension));
            }
            Formula::Code(code) => code,
        };
        let expr = code.parsed()?;
        let Some((_, Some(unit))) = expr.as_literal() else {
            return Some(());
        };
        if unit.dimension != Dimension::ONE {
            return Some(());
        }
        let message = format!(
            "unit mismatch: {what} is in {}, expected {}",
            unit.text,
            shown(dimension)
        );
        let help = format!("write it in {dimension}, or as a bare number in SI");
        self.fault(Rule::E0604, code.base.span, message, help);
        None
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

    /// Reports a quantity of a wrong unit.
    pub(super) fn code_mismatch(
        &mut self,
        code: &Code,
        what: &str,
        found: Dimension,
        expected: Dimension,
    ) {
        self.unit_mismatch(code.base.span, what, found, expected, written_in(expected));
        if let Some(fault) = self.faults.pop() {
            self.faults.push(with_unit(fault, code, expected));
        }
    }

    pub(super) fn unit_mismatch(
        &mut self,
        span: Span,
        what: &str,
        found: Dimension,
        expected: Dimension,
        help: impl Into<String>,
    ) {
        let message = format!(
            "unit mismatch: {what} is {}, expected {}",
            found.in_words(),
            shown(expected)
        );
        self.fault(Rule::E0604, span, message, help);
    }

    /// A constant scalar with its dimension.
    pub(super) fn scalar(&mut self, code: &Code, what: &str) -> Option<(f64, Dimension)> {
        let numbers = self.numbers_for(&Formula::Code(code.clone()), what)?;
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
        format!("write it with its unit, as in `1 {dimension}`")
    }
}

/// The fault of a number of a wrong unit, whose remedy shows the number that is written with the unit that is expected. A bare
/// number is changed so; of one with another unit nobody knows which of the two was meant.
pub(super) fn with_unit(fault: Diagnostic, code: &Code, expected: Dimension) -> Diagnostic {
    let expr = code.parsed();
    let literal = expr.as_ref().and_then(|expr| expr.as_literal());
    let written = literal.and_then(|(_, unit)| unit);
    let text = code.text.as_ref().map_or("", |text| text.trim());
    let digits = text.find(|c: char| c.is_whitespace() || c.is_ascii_alphabetic() && c != 'e');
    let number = text[..digits.unwrap_or(text.len())].trim();
    if literal.is_none() || number.parse::<f64>().is_err() {
        return fault;
    }
    if expected.is_dimensionless() {
        return fault.with_help(format!("write it without a unit: `{number}`"));
    }
    // An angle is a number: what is missing is the rest of its unit.
    let angle = written.filter(|unit| unit.dimension == Dimension::ONE);
    let unit = match (angle, expected.to_string().strip_prefix("1/")) {
        (Some(angle), Some(below)) => format!("{}/{below}", angle.text),
        (Some(angle), None) => format!("{}*{expected}", angle.text),
        (None, _) => expected.to_string(),
    };
    let change = format!("{number} {unit}");
    if digits.is_some() {
        return fault.with_help(format!("write it in {unit}, as in `{change}`"));
    }
    let fault = fault.with_help(format!("write it with its unit: `{change}`"));
    match code.base.holds(0..text.len()) {
        true => fault.with_suggestion(code.base.span, change, Applicability::Possible),
        false => fault,
    }
}

/// A number with its SI unit.
pub(super) fn in_unit(value: f64, dimension: Dimension) -> String {
    match dimension.is_dimensionless() {
        true => rounded(value),
        false => format!("{} {dimension}", rounded(value)),
    }
}
