//! Finds the operation that makes a value infinite or no number, so that the message can show it.

use super::Context;
use super::formula::Parsed;
use super::initial::Point;
use super::scope::{Names, Place};
use crate::diagnostic::{Diagnostic, Span, quoted, rounded};
use crate::expr::arena::Type;
use crate::expr::syntax::{Expr, Infix, Kind, NodeId};
use crate::expr::{self, Symbol};

/// Most faults that are explained so, and how much is evaluated for one of them: more would take long in a large specification.
const MOST_FAULTS: usize = 20;
const EVALUATIONS: usize = 1_000_000;
/// Longest expression that is searched, most definitions that are looked into, most values that are shown.
const LONGEST: usize = 200;
const DEEPEST: usize = 4;
const MOST: usize = 4;
const BY_ZERO: &str = "division by zero";
const SINGULAR: &str = "has no inverse, or its solution is too large for a number";

impl Context<'_> {
    /// The fault of a formula that is not finite at a point (or, without one, as a constant), with the operation that makes it so
    /// and the values of the states in it.
    pub(super) fn with_operation(
        &mut self,
        fault: Diagnostic,
        parsed: &Parsed,
        point: Option<Point>,
    ) -> Diagnostic {
        if self.faults.len() >= MOST_FAULTS {
            return fault;
        }
        let mut fault = fault;
        let mut all = Vec::new();
        parsed.expressions(&mut all);
        let mut all: Vec<Expr> = all.into_iter().cloned().collect();
        for depth in 0..DEEPEST {
            let found = (all.iter()).find_map(|expr| Some((expr, self.operation(expr, point)?)));
            let Some((expr, at)) = found else {
                return fault;
            };
            let node = &expr.nodes()[at];
            let definition = match &node.kind {
                Kind::Name(name) => self.parts_of(name),
                _ => None,
            };
            let label = self.reason(expr, at, point);
            if label.starts_with(BY_ZERO) {
                let elsewhere = match has_state(&self.names, expr, at) {
                    true => {
                        " wherever the plant goes; another start helps only if it never gets there"
                    }
                    false => "",
                };
                fault.help = Some(format!(
                    "write it so that the divisor is never 0{elsewhere}"
                ));
            }
            if label.ends_with(SINGULAR) {
                let help = "the equations depend on each other, or an unknown is in none of them";
                fault.help = Some(help.to_owned());
            }
            if depth == 0 {
                fault.span = Some(node.span);
                fault.label = Some(label);
            } else {
                fault = fault.with_related(node.span, label);
            }
            fault = self.with_values(fault, &expr.part(at), point);
            match definition {
                Some(parts) => all = parts,
                None => return fault,
            }
        }
        fault
    }

    /// From the whole expression down, the part whose value is not finite while those of its operands are.
    fn operation(&mut self, expr: &Expr, point: Option<Point>) -> Option<usize> {
        let mut at = expr.nodes().len() - 1;
        let most = EVALUATIONS / self.arena.len().max(1);
        if at >= LONGEST.min(most) || !self.is_infinite(&expr.part(at), point) {
            return None;
        }
        loop {
            let mut operands = expr.nodes()[at].kind.operands().into_iter();
            match operands.find(|id| self.is_infinite(&expr.part(id.index()), point)) {
                Some(operand) => at = operand.index(),
                None => return Some(at),
            }
        }
    }

    fn is_infinite(&mut self, expr: &Expr, point: Option<Point>) -> bool {
        let values = self.values_of(expr, point);
        values.is_some_and(|values| values.iter().any(|value| !value.is_finite()))
    }

    /// The numbers of an expression; `None` for truth values.
    fn values_of(&mut self, expr: &Expr, point: Option<Point>) -> Option<Vec<f64>> {
        let place = match point {
            Some(_) => Place::Model,
            None => Place::Constant,
        };
        let id = expr::elaborate(expr, &mut self.names.view(place), &mut self.arena).ok()?;
        let Type::Real { .. } = self.arena.ty(id) else {
            return None;
        };
        Some(match point {
            Some(point) => self.evaluate(id, &point),
            None => self.evaluate_constant(id),
        })
    }

    /// The expressions of a definition.
    fn parts_of(&mut self, name: &str) -> Option<Vec<Expr>> {
        let definitions = &self.spec.definitions;
        let written = definitions.iter().find(|one| one.name.value == name)?;
        let before = self.faults.len();
        let parsed = self.parse_formula(&written.value);
        self.faults.truncate(before);
        let parsed = parsed?;
        let mut all = Vec::new();
        parsed.expressions(&mut all);
        Some(all.into_iter().cloned().collect())
    }

    /// What an operation does to become infinite or no number.
    fn reason(&mut self, expr: &Expr, at: usize, point: Option<Point>) -> String {
        let mut operand = |id: NodeId| {
            let part = expr.part(id.index());
            let value = *self.values_of(&part, point)?.first()?;
            Some((self.text(part.span()), value))
        };
        let shown = match &expr.nodes()[at].kind {
            Kind::Infix(Infix::Div, _, divisor) => operand(*divisor)
                .filter(|(_, value)| *value == 0.0)
                .map(|(text, _)| format!("{BY_ZERO}: {text} is 0")),
            Kind::Call(name, arguments) => match arguments.as_slice() {
                [matrix] | [matrix, _] if matches!(name.text.as_str(), "solve" | "inverse") => {
                    let part = expr.part(matrix.index());
                    Some(format!("{} {SINGULAR}", self.text(part.span())))
                }
                [only] => operand(*only).map(|(text, value)| {
                    let value = rounded(value);
                    match text == format!("`{value}`") {
                        true => format!("`{}` of {value}", name.text),
                        false => format!("`{}` of {text}, which is {value}", name.text),
                    }
                }),
                _ => None,
            },
            _ => None,
        };
        shown.unwrap_or_else(|| {
            let values = self.values_of(&expr.part(at), point);
            let value = values.and_then(|values| values.into_iter().find(|one| !one.is_finite()));
            let value = value.unwrap_or(f64::NAN);
            match &expr.nodes()[at].kind {
                Kind::Name(name) => format!("`{name}` is {value}"),
                _ => format!("this is {value}"),
            }
        })
    }

    fn text(&self, span: Span) -> String {
        let text = &self.sources.source(span.file).text;
        quoted(
            text.get(span.start as usize..span.end as usize)
                .unwrap_or("the divisor"),
        )
    }

    /// The fault with the values that the states in an expression have at the start.
    fn with_values(&self, mut fault: Diagnostic, expr: &Expr, point: Option<Point>) -> Diagnostic {
        if point.is_none() {
            return fault;
        }
        let mut shown: Vec<&str> = Vec::new();
        for (name, _) in expr.free_names() {
            let state = match self.names.symbol(name) {
                Some(Symbol::State { block, channel, .. }) => {
                    let states = self.states[*block].as_ref();
                    states.map(|states| &states[*channel])
                }
                Some(Symbol::Truth(at, _)) => self.truth_states[*at].as_ref(),
                _ => None,
            };
            let (Some(state), Some(origin)) = (state, self.names.origin_of(name)) else {
                continue;
            };
            if shown.contains(&name) || shown.len() == MOST {
                continue;
            }
            shown.push(name);
            let value = state.shown(state.initial);
            let label = format!("state `{name}` is {value} at the start");
            fault = fault.with_related(origin.span, label);
        }
        fault
    }
}

/// Whether an initial value decides the value of a part.
fn has_state(names: &Names, expr: &Expr, at: usize) -> bool {
    let part = expr.part(at);
    let mut used = part.free_names().into_iter();
    used.any(|(name, _)| {
        matches!(
            names.symbol(name),
            Some(Symbol::State { .. } | Symbol::Truth(..))
        )
    })
}
