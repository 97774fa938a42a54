//! The rules of shapes and dimensions: what type each operation makes of its operands' types.

mod equations;
mod linear;

use super::arena::{Function, Shape, Type};
use super::syntax::Name;
use crate::diagnostic::{Diagnostic, Rule, Suggestion};
use crate::suggest::Meant;
use crate::unit::Dimension;
pub(crate) use equations::MAX_UNKNOWNS;
pub(super) use equations::{inverse, solution};
pub(super) use linear::{cross, dot, matrix_product, transpose};

/// Why an operation has no type; the caller knows the place.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Fault {
    pub(super) rule: Rule,
    pub(super) message: String,
    pub(super) help: String,
    /// A change of the text that mends it.
    pub(super) suggestion: Option<Suggestion>,
}

impl Fault {
    pub(super) fn new(rule: Rule, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self {
            rule,
            message: message.into(),
            help: help.into(),
            suggestion: None,
        }
    }

    /// The fault of a name that nothing has, written at a place.
    pub(super) fn unknown(
        rule: Rule,
        message: String,
        name: &Name,
        meant: Option<Meant>,
        otherwise: impl FnOnce() -> String,
    ) -> Self {
        let fault = Diagnostic::error(rule, name.span, message);
        let fault = fault.did_you_mean(name.span, &name.text, meant, otherwise);
        Self {
            rule,
            message: fault.message,
            help: fault.help.unwrap_or_default(),
            suggestion: fault.suggestion,
        }
    }
}

/// Type of a real value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Real {
    pub(super) shape: Shape,
    /// Row-major.
    pub(super) dimensions: Vec<Dimension>,
}

impl From<Real> for Type {
    fn from(real: Real) -> Self {
        Type::Real {
            shape: real.shape,
            dimensions: real.dimensions,
        }
    }
}

impl Real {
    pub(super) fn scalar(dimension: Dimension) -> Self {
        Self {
            shape: Shape::Scalar,
            dimensions: vec![dimension],
        }
    }

    /// The type of numbers; `None` for truth values.
    pub(super) fn of(ty: &Type) -> Option<Self> {
        let Type::Real { shape, dimensions } = ty else {
            return None;
        };
        Some(Self {
            shape: *shape,
            dimensions: dimensions.clone(),
        })
    }

    /// Dimension at a row-major place; a scalar has the same everywhere.
    fn at(&self, entry: usize) -> Dimension {
        self.dimensions[if self.shape == Shape::Scalar {
            0
        } else {
            entry
        }]
    }

    /// What the value is, for labels: its dimension, or its shape.
    pub(super) fn described(&self) -> String {
        match self.shape {
            Shape::Scalar => self.dimensions[0].in_words(),
            array => array.to_string(),
        }
    }

    /// The value with its unit, or its shape and units: `in m/s`, `a vector of 3 in m`.
    pub(super) fn with_units(&self) -> String {
        let units = match self.dimensions.split_first() {
            Some((first, rest)) if rest.iter().any(|other| other != first) => {
                "in several units".to_owned()
            }
            Some((first, _)) => first.in_words(),
            None => String::new(),
        };
        match self.shape {
            Shape::Scalar => units,
            array => format!("{array} {units}"),
        }
    }
}

/// A dimension in words.
pub(crate) fn shown(dimension: Dimension) -> String {
    if dimension.is_dimensionless() {
        "a pure number".to_owned()
    } else {
        dimension.to_string()
    }
}

/// ` in entry 2`, or nothing for a scalar.
pub(super) fn in_entry(shape: Shape, entry: usize) -> String {
    match shape {
        Shape::Scalar => String::new(),
        Shape::Vector(_) => format!(" in entry {}", entry + 1),
        Shape::Matrix(_, cols) => format!(" in entry ({}, {})", entry / cols + 1, entry % cols + 1),
    }
}

/// Sums, differences, `min`, `max`, and what compares or chooses: both sides have one dimension.
pub(super) fn agreeing(symbol: &str, left: &Real, right: &Real) -> Result<Real, Fault> {
    elementwise(symbol, left, right, |at, a, b| {
        a.agree(b).ok_or_else(|| mismatch(symbol, at, a, b))
    })
}

/// `atan2`: both sides have one dimension, the result is an angle.
pub(super) fn angle(left: &Real, right: &Real) -> Result<Real, Fault> {
    elementwise("atan2", left, right, |at, a, b| {
        a.agree(b)
            .map(|_| Dimension::ONE)
            .ok_or_else(|| mismatch("atan2", at, a, b))
    })
}

/// Elementwise products.
pub(super) fn product(left: &Real, right: &Real) -> Result<Real, Fault> {
    elementwise("*", left, right, |_, a, b| {
        a.checked_mul(b).ok_or_else(out_of_range)
    })
}

/// What is meant by a quotient with a matrix below.
pub(crate) const BY_MATRIX: &str = "`/` goes entry by entry: write `inverse(M)` for `1/M`, and `solve(M, b)` for the solution of `M*x = b`";

/// Elementwise quotients.
pub(super) fn quotient(left: &Real, right: &Real) -> Result<Real, Fault> {
    elementwise("/", left, right, |at, a, b| {
        if b == Dimension::ANY {
            let help = match right.shape {
                Shape::Matrix(rows, columns) if rows == columns => BY_MATRIX,
                _ => "divide by something that is not 0",
            };
            let message = format!("division by the literal 0{at}");
            return Err(Fault::new(Rule::E0408, message, help));
        }
        a.checked_div(b).ok_or_else(out_of_range)
    })
}

fn elementwise(
    symbol: &str,
    left: &Real,
    right: &Real,
    rule: impl Fn(&str, Dimension, Dimension) -> Result<Dimension, Fault>,
) -> Result<Real, Fault> {
    let shape = match (left.shape, right.shape) {
        (Shape::Scalar, shape) | (shape, Shape::Scalar) => shape,
        (a, b) if a == b => a,
        (a, b) => {
            let message = format!("shape mismatch: `{symbol}` between {a} and {b}");
            let help = match b {
                Shape::Matrix(rows, columns) if symbol == "/" && rows == columns => BY_MATRIX,
                _ => "operands are of one shape, or one of them is a scalar",
            };
            return Err(Fault::new(Rule::E0501, message, help));
        }
    };
    let entry = |entry| rule(&in_entry(shape, entry), left.at(entry), right.at(entry));
    let dimensions = (0..shape.entries()).map(entry).collect::<Result<_, _>>()?;
    Ok(Real { shape, dimensions })
}

/// Elementwise functions of one argument.
pub(super) fn apply(name: &str, function: Function, argument: &Real) -> Result<Real, Fault> {
    let shape = argument.shape;
    let rule = |(entry, &dimension): (usize, &Dimension)| match function {
        Function::Neg | Function::Abs => Ok(dimension),
        Function::Sign => Ok(Dimension::ONE),
        Function::Sqrt => dimension.checked_sqrt().ok_or_else(|| {
            let message = format!("no square root of a quantity in {dimension}");
            Fault::new(Rule::E0406, message, "exponents of units go in halves")
        }),
        _ => {
            let place = in_entry(shape, entry);
            dimensionless(&format!("argument of `{name}`{place}"), dimension)
                .map(|()| Dimension::ONE)
        }
    };
    let dimensions = argument
        .dimensions
        .iter()
        .enumerate()
        .map(rule)
        .collect::<Result<_, _>>()?;
    Ok(Real { shape, dimensions })
}

/// A pure number.
pub(super) fn dimensionless(what: &str, dimension: Dimension) -> Result<(), Fault> {
    if dimension.is_dimensionless() {
        return Ok(());
    }
    let message = format!("unit mismatch: {what} is in {dimension}, expected a pure number");
    Err(Fault::new(
        Rule::E0404,
        message,
        format!("divide it by a quantity in {dimension}, such as `/(1 {dimension})`"),
    ))
}

/// An argument of a dimension.
pub(super) fn argument(what: &str, found: Dimension, wanted: Dimension) -> Result<(), Fault> {
    if wanted == Dimension::ONE {
        return dimensionless(what, found);
    }
    if found.agree(wanted).is_some() {
        return Ok(());
    }
    let message = format!(
        "unit mismatch: {what} is {}, expected {wanted}",
        found.in_words()
    );
    let help = match wanted.checked_div(found) {
        Some(factor) => format!("multiply it by a quantity in {factor}, such as `*(1 {factor})`"),
        None => format!("give it in {wanted}"),
    };
    Err(Fault::new(Rule::E0404, message, help))
}

/// Whole power of a scalar.
pub(super) fn power(base: &Real, exponent: i32) -> Result<Real, Fault> {
    if base.shape != Shape::Scalar {
        return Err(power_of_array(base.shape));
    }
    if exponent == 0 {
        return Ok(Real::scalar(Dimension::ONE));
    }
    base.dimensions[0]
        .checked_powi(exponent)
        .map(Real::scalar)
        .ok_or_else(out_of_range)
}

/// Power with an exponent that is no whole literal.
pub(super) fn real_power(base: &Real, exponent: &Real) -> Result<Real, Fault> {
    if base.shape != Shape::Scalar {
        return Err(power_of_array(base.shape));
    }
    if exponent.shape != Shape::Scalar {
        let message = format!(
            "shape mismatch: exponent is {}, expected a scalar",
            exponent.shape
        );
        return Err(Fault::new(
            Rule::E0501,
            message,
            "take one entry of the array",
        ));
    }
    dimensionless("exponent", exponent.dimensions[0])?;
    let dimension = base.dimensions[0];
    if dimension.is_dimensionless() {
        return Ok(Real::scalar(Dimension::ONE));
    }
    let message =
        format!("unit mismatch: base is in {dimension}, but its exponent is not a whole number");
    Err(Fault::new(
        Rule::E0405,
        message,
        "write the exponent as a literal, a half with `sqrt(..)`, or divide the base by its unit",
    ))
}

fn power_of_array(shape: Shape) -> Fault {
    let message = format!("shape mismatch: power of {shape}, expected a scalar");
    Fault::new(
        Rule::E0501,
        message,
        "write `v*v` for squares of entries, `M*M` for a matrix product, `inverse(M)` for a matrix to the power -1, `dot(v, v)` for a sum of squares",
    )
}

fn mismatch(symbol: &str, at: &str, left: Dimension, right: Dimension) -> Fault {
    let message = format!(
        "unit mismatch{at}: `{symbol}` between {} and {}",
        shown(left),
        shown(right)
    );
    let help = match right.checked_div(left) {
        Some(missing) if left == Dimension::ONE => {
            format!("give the pure number its unit: `1 {missing}`")
        }
        Some(missing) if right == Dimension::ONE => match Dimension::ONE.checked_div(missing) {
            Some(unit) => format!("give the pure number its unit: `1 {unit}`"),
            None => "both sides must have one unit".to_owned(),
        },
        Some(missing) => match missing.checked_powi(-1) {
            // A unit above the line reads better than one below it.
            Some(inverse) if missing.to_string().starts_with("1/") => format!(
                "divide the left side by a quantity in {inverse}, or multiply the right side by one"
            ),
            _ => format!(
                "multiply the left side by a quantity in {missing}, or divide the right side by one"
            ),
        },
        None => "both sides must have one unit".to_owned(),
    };
    Fault::new(Rule::E0403, message, help)
}

fn out_of_range() -> Fault {
    Fault::new(
        Rule::E0406,
        "exponent of a unit out of range",
        "exponents go from -63 to 63",
    )
}
