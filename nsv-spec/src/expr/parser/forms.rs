//! Forms with a grammar of their own: `partial`, `each` and indices.

use super::{MAX_ROUNDS, Operand, Parsed, Parser, power};
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::lexer::{Token, TokenKind};
use crate::expr::syntax::{Expr, Index, Infix, Kind, Name};

const PARTIAL: &str = "write `partial(polynomial, argument, values..)` with one value per argument";
const EACH: &str = "write `each(i, 1, 3, expression)`; the numbers are written out";
/// What an index may be.
pub(in crate::expr) const INDEX: &str = "indices are whole numbers from 1, known when the specification is read: `v[1]`, `M[1, 2]`, or the counter of an `each`";

impl Parser<'_> {
    /// `partial(polynomial, argument, at..)` behind its bracket.
    pub(super) fn partial(&mut self, start: usize, open: usize) -> Parsed<Operand> {
        let polynomial = self.bare_name("the name of polynomial data", PARTIAL)?;
        self.comma(PARTIAL)?;
        let argument = self.bare_name("the name of an argument of the polynomial data", PARTIAL)?;
        self.comma(PARTIAL)?;
        let (at, end) = self.list(&TokenKind::Close, open, "`,`, an operator or `)`")?;
        self.push(
            start..end,
            Kind::Partial {
                polynomial,
                argument,
                at,
            },
        )
    }

    /// `each(counter, first, last, body)` behind its bracket.
    pub(super) fn each(&mut self, start: usize, open: usize) -> Parsed<Operand> {
        let counter = self.bare_name("a name for the counter", EACH)?;
        self.comma(EACH)?;
        let from = self.next;
        let first = self.whole_number()?;
        self.comma(EACH)?;
        let last = self.whole_number()?;
        self.comma(EACH)?;
        if last < first || last - first >= MAX_ROUNDS {
            let message = format!("`each` counts from {first} to {last}");
            let help = format!("count upwards, at most {MAX_ROUNDS} rounds");
            let range = self.tokens[from].range.start..self.tokens[self.next - 2].range.end;
            return Err(self.fault(Rule::E0210, range, message, help));
        }
        let outer = std::mem::take(&mut self.nodes);
        let body = self.expression(power::NONE);
        let nodes = std::mem::replace(&mut self.nodes, outer);
        body?;
        let end = self.close(&TokenKind::Close, open, "an operator or `)`")?;
        let kind = Kind::Each {
            counter,
            range: (first, last),
            body: Box::new(Expr { nodes }),
        };
        self.push(start..end, kind)
    }

    fn whole_number(&mut self) -> Parsed<u32> {
        match &self.peek().kind {
            TokenKind::Number(literal) if literal.integer.is_some_and(|value| value > 0) => {
                self.next += 1;
                Ok(literal.integer.unwrap_or_default())
            }
            _ => Err(self.malformed("a whole number from 1", EACH)),
        }
    }

    fn bare_name(&mut self, expected: &str, help: &str) -> Parsed<Name> {
        let token = self.peek();
        let TokenKind::Name(text) = &token.kind else {
            return Err(self.malformed(expected, help));
        };
        self.next += 1;
        Ok(Name {
            text: text.clone(),
            span: self.base.span_of(token.range.clone()),
        })
    }

    fn comma(&mut self, help: &str) -> Parsed<()> {
        if self.peek().kind != TokenKind::Comma {
            return Err(self.malformed("`,`", help));
        }
        self.next += 1;
        Ok(())
    }

    fn malformed(&self, expected: &str, help: &str) -> Box<Diagnostic> {
        let token = self.peek();
        let message = format!("found {}, expected {expected}", self.named(token));
        self.fault(Rule::E0203, token.range.clone(), message, help)
    }

    /// `[i]` or `[i, j]` behind an operand.
    pub(super) fn index(&mut self, operand: Operand) -> Parsed<Operand> {
        let open = self.advance().range.start;
        let mut indices = vec![self.one_index()?];
        while self.peek().kind == TokenKind::Comma {
            self.next += 1;
            indices.push(self.one_index()?);
        }
        let end = self.close(&TokenKind::CloseArray, open, "`,` or `]`")?;
        self.push(operand.range.start..end, Kind::Index(operand.id, indices))
    }

    /// `2`, `i`, `i + 1` or `i - 1`.
    fn one_index(&mut self) -> Parsed<Index> {
        let token = self.advance();
        let mut range = token.range.clone();
        let (counter, offset) = match (&token.kind, positive(token)) {
            (_, Some(index)) => (None, index),
            (TokenKind::Name(text), _) => {
                let counter = Name {
                    text: text.clone(),
                    span: self.base.span_of(range.clone()),
                };
                let sign = match self.peek().kind {
                    TokenKind::Infix(Infix::Add) => 1,
                    TokenKind::Infix(Infix::Sub) => -1,
                    _ => 0,
                };
                let offset = self.tokens.get(self.next + 1).and_then(positive);
                match offset.filter(|_| sign != 0) {
                    Some(offset) => {
                        self.next += 2;
                        range.end = self.tokens[self.next - 1].range.end;
                        (Some(counter), sign * offset)
                    }
                    None => (Some(counter), 0),
                }
            }
            _ => {
                let message = format!("found {}, expected an index", self.named(token));
                return Err(self.fault(Rule::E0209, range, message, INDEX));
            }
        };
        Ok(Index {
            counter,
            offset,
            span: self.base.span_of(range),
        })
    }
}

/// The value of a plain whole number from 1.
fn positive(token: &Token) -> Option<i64> {
    match &token.kind {
        TokenKind::Number(literal) => literal.integer.filter(|&index| index > 0).map(i64::from),
        _ => None,
    }
}
