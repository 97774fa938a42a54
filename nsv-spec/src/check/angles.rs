//! Warns where an angle in degrees is evidently used as a number: SI angles are numbers, so that the dimensions cannot tell.
//!
//! `alpha/(1 deg)` by itself is right, for polynomials fitted in degrees. The sine of it is not.

use super::Context;
use super::formula::Parsed;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::expr::syntax::{Expr, Infix, Kind, Node, NodeId};
use crate::spec::{Code, Formula, Unreadable};
use crate::unit::{Dimension, Unit};

/// Functions of an angle in radians.
const OF_ANGLES: [&str; 3] = ["sin", "cos", "tan"];
/// A turn, rad: nobody writes a larger bare number as an angle in radians.
const TURN: f64 = std::f64::consts::TAU;

impl Context<'_> {
    /// Warns of functions of an angle whose argument is a number of degrees.
    pub(super) fn check_angles(&mut self, parsed: &Parsed) {
        match parsed {
            Parsed::List(items, _) => items.iter().for_each(|item| self.check_angles(item)),
            Parsed::Expr(expr) => self.check_calls(expr),
        }
    }

    fn check_calls(&mut self, expr: &Expr) {
        for node in expr.nodes() {
            match &node.kind {
                Kind::Each { body, .. } => self.check_calls(body),
                Kind::Call(name, arguments) if OF_ANGLES.contains(&name.text.as_str()) => {
                    if let [argument] = arguments.as_slice() {
                        self.check_argument(&name.text, expr, *argument);
                    }
                }
                _ => {}
            }
        }
    }

    fn check_argument(&mut self, function: &str, expr: &Expr, argument: NodeId) {
        let node = expr.node(argument);
        let warning = |what: String, help: &str| {
            let message = format!("`{function}` takes radians, found {what}");
            Diagnostic::warning(Rule::W0010, node.span, message).with_help(help)
        };
        let found = match &node.kind {
            Kind::Number(number) if number.unit.is_none() && number.value > TURN => {
                let help = format!("write `{} deg`", number.value);
                warning(format!("the number {}", number.value), &help)
            }
            Kind::Name(name) => {
                let Some(&declared) = self.in_degrees.get(name) else {
                    return;
                };
                warning(
                    format!("`{name}`, a number of degrees"),
                    "use the angle itself, which nsv keeps in radians",
                )
                .with_related(declared, "divided by a degree here")
            }
            _ if is_count_of_degrees(expr, node) => warning(
                "a number of degrees".to_owned(),
                "leave out the division: nsv keeps angles in radians",
            ),
            _ => return,
        };
        let known = |warning: &Diagnostic| (warning.rule, warning.span) == (found.rule, found.span);
        if !self.warnings.iter().any(known) {
            self.warnings.push(found);
        }
    }

    /// Remembers a quantity that is an angle divided by a degree.
    pub(super) fn note_degrees(&mut self, name: &str, parsed: &Parsed) {
        if let Parsed::Expr(expr) = parsed
            && is_count_of_degrees(expr, expr.root())
        {
            self.in_degrees.insert(name.to_owned(), expr.span());
        }
    }

    /// Warns of a bare number for what belongs to a state whose initial value is written in degrees.
    pub(super) fn check_degrees_of(
        &mut self,
        state: (usize, usize),
        what: &str,
        formula: &Formula,
    ) {
        let (block, channel) = state;
        let Some(written) = self.spec.blocks[block].value.states.get(channel) else {
            return;
        };
        let declared = match &written.value.unit {
            Some(Ok(unit)) => unit.value.starts_with("deg").then_some(unit.span),
            Some(Err(Unreadable)) => None,
            None => written_in_degrees(&written.value.initial),
        };
        let Some(declared) = declared else {
            return;
        };
        let Formula::Code(code) = formula else {
            return;
        };
        let Some(value) = bare_number(code) else {
            return;
        };
        let message = format!(
            "{what} is {value} rad, though `{}` is declared in degrees",
            written.name.value
        );
        let warning = Diagnostic::warning(Rule::W0011, code.base.span, message)
            .with_related(declared, "degrees here")
            .with_help(format!(
                "write `{value} deg`, or `{value} rad` if radians are meant"
            ));
        self.warnings.push(warning);
    }
}

/// `x/(1 deg)`: the whole is a pure number that counts degrees.
fn is_count_of_degrees(expr: &Expr, node: &Node) -> bool {
    let Kind::Infix(Infix::Div, _, divisor) = &node.kind else {
        return false;
    };
    let Kind::Number(number) = &expr.node(*divisor).kind else {
        return false;
    };
    number.unit.as_ref().is_some_and(is_degree)
}

fn is_degree(unit: &Unit) -> bool {
    unit.dimension == Dimension::ONE && matches!(unit.text.as_str(), "deg" | "arcmin" | "arcsec")
}

/// The place of a number in degrees, or degrees in some time.
fn written_in_degrees(code: &Code) -> Option<Span> {
    let expr = code.parsed()?;
    let (_, unit) = expr.as_literal()?;
    let in_degrees = unit?.symbols().next() == Some("deg");
    in_degrees.then(|| expr.span())
}

/// A number other than 0 without a unit.
fn bare_number(code: &Code) -> Option<f64> {
    let expr = code.parsed()?;
    let (value, unit) = expr.as_literal()?;
    (unit.is_none() && value != 0.0).then_some(value)
}
