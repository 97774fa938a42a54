//! Warns where something is divided by a square matrix: `/` goes entry by entry, and nearly always the inverse is meant.

use super::Context;
use super::formula::Parsed;
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::arena::{Shape, Type};
use crate::expr::syntax::{Expr, Infix, Kind, NodeId};
use crate::expr::{BY_MATRIX, Symbol};

impl Context<'_> {
    /// Warns of quotients by matrices.
    pub(super) fn check_quotients(&mut self, parsed: &Parsed) {
        match parsed {
            Parsed::List(items, _) => items.iter().for_each(|item| self.check_quotients(item)),
            Parsed::Expr(expr) => self.check_divisors(expr),
        }
    }

    fn check_divisors(&mut self, expr: &Expr) {
        for node in expr.nodes() {
            match node.kind {
                Kind::Each { ref body, .. } => self.check_divisors(body),
                Kind::Infix(Infix::Div, _, divisor) if self.is_square(expr, divisor) => {
                    let warning =
                        Diagnostic::warning(Rule::W0012, node.span, "quotient by a matrix")
                            .with_help(BY_MATRIX);
                    let known = |other: &Diagnostic| {
                        (other.rule, other.span) == (warning.rule, warning.span)
                    };
                    if !self.warnings.iter().any(known) {
                        self.warnings.push(warning);
                    }
                }
                _ => {}
            }
        }
    }

    /// Whether a part is the name of a square matrix of two rows or more, or one that is written out.
    fn is_square(&self, expr: &Expr, part: NodeId) -> bool {
        match &expr.node(part).kind {
            Kind::Name(name) => match self.names.symbol(name) {
                Some(
                    Symbol::Constant(_, ty) | Symbol::Parameter(_, ty) | Symbol::Definition(_, ty),
                ) => matches!(
                    ty,
                    Type::Real { shape: Shape::Matrix(rows, columns), .. } if rows == columns && *rows > 1
                ),
                _ => false,
            },
            Kind::Array(rows) => {
                let square = |row: &NodeId| matches!(&expr.node(*row).kind, Kind::Array(items) if items.len() == rows.len());
                rows.len() > 1 && rows.iter().all(square)
            }
            _ => false,
        }
    }
}
