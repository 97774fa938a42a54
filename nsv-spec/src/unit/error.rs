//! Faults of a unit expression.

use std::ops::Range;

use crate::diagnostic::{Base, Diagnostic, Rule, quoted};
use crate::suggest::Meant;

/// What is wrong with a unit expression, and where in its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    /// The faulty bytes.
    pub range: Range<usize>,
    /// What is wrong there.
    pub(crate) fault: UnitFault,
}

/// What is wrong with a unit expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum UnitFault {
    /// A name that is no unit, with the unit that was probably meant.
    Unknown {
        /// The name.
        name: String,
        /// What to write instead.
        suggestion: Option<Meant>,
    },
    /// Something else than the grammar allows.
    Malformed {
        /// What could stand there.
        expected: &'static str,
        /// What stands there.
        found: String,
    },
    /// An exponent or factor too large to represent, or a root of an odd power of a root.
    Range,
}

impl UnitError {
    /// The same fault of a unit that begins at byte `offset` of a longer text.
    pub(crate) fn shifted(mut self, offset: usize) -> Self {
        self.range = self.range.start + offset..self.range.end + offset;
        self
    }

    /// The fault as a diagnostic; `base` places the unit's text in its file.
    pub fn diagnostic(&self, base: &Base) -> Diagnostic {
        let span = base.span_of(self.range.clone());
        match &self.fault {
            UnitFault::Unknown { name, suggestion } => {
                let fault =
                    Diagnostic::error(Rule::E0401, span, format!("unknown unit {}", quoted(name)));
                match suggestion {
                    Some(meant) => {
                        let fault = fault.with_help(format!("did you mean `{}`?", meant.name));
                        match base.holds(self.range.clone()) {
                            true => fault.with_suggestion(
                                span,
                                meant.name.clone(),
                                meant.applicability(),
                            ),
                            false => fault,
                        }
                    }
                    None => fault.with_help(
                        "units are SI symbols with their prefixes, joined by `*`, `/` and `^`",
                    ),
                }
            }
            UnitFault::Malformed { expected, found } => {
                let message = format!("malformed unit: found {found}, expected {expected}");
                Diagnostic::error(Rule::E0402, span, message)
                    .with_help("write units like `kN*m`, `rad/s`, `1/s` or `m/s^2`")
            }
            UnitFault::Range => Diagnostic::error(
                Rule::E0402,
                span,
                "unit with a factor or an exponent out of range",
            )
            .with_help("exponents go up to 63 in steps of a half, factors up to about 1e300"),
        }
    }
}
