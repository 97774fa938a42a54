//! Tokens to syntax, by precedence climbing over one table of binding powers.

mod forms;
mod power;

use std::ops::Range;

use super::lexer::{Token, TokenKind, tokens};
use super::syntax::{Expr, Infix, Kind, Name, Node, NodeId};
use crate::diagnostic::{Applicability, Base, Diagnostic, Rule, quoted};
pub(super) use forms::INDEX;
pub(crate) use power::binding;

/// Longest text of one expression, bytes.
pub const MAX_TEXT: usize = 64 * 1024;
/// Deepest nesting; brackets, prefixes and operators that wait for their right side all count.
pub const MAX_DEPTH: usize = 128;
/// Most operators, operands and calls in one expression.
pub const MAX_NODES: usize = 16 * 1024;

/// Most operations that calls and rounds of `each` insert into one specification.
pub const MAX_INSERTED: usize = 200_000;
/// Most rounds of one `each`.
pub const MAX_ROUNDS: u32 = 64;

/// Most faults reported in one expression; what comes after so many says little.
pub(crate) const MAX_FAULTS: usize = 32;

/// Reads the text of an expression; `base` tells where the text stands in its file.
pub fn parse(text: &str, base: Base) -> Result<Expr, Vec<Diagnostic>> {
    if text.len() > MAX_TEXT {
        let message = format!(
            "expression of {} bytes, expected at most {MAX_TEXT}",
            text.len()
        );
        let fault = Diagnostic::error(Rule::E0207, base.span_of(0..text.len()), message);
        return Err(vec![fault.with_help("split it into named definitions")]);
    }
    let tokens = tokens(text, &base)?;
    let mut parser = Parser {
        tokens: &tokens,
        next: 0,
        text,
        base,
        nodes: Vec::new(),
        made: 0,
        depth: 0,
    };
    match parser.whole() {
        Ok(()) => Ok(Expr {
            nodes: parser.nodes,
        }),
        Err(fault) => Err(vec![*fault]),
    }
}

/// A fault ends the parse; boxed, since every function here returns it through the deepest recursion.
type Parsed<T> = Result<T, Box<Diagnostic>>;

/// An operand with the bytes it takes, brackets included.
struct Operand {
    id: NodeId,
    range: Range<usize>,
}

struct Parser<'a> {
    tokens: &'a [Token],
    next: usize,
    text: &'a str,
    base: Base,
    nodes: Vec<Node>,
    /// Nodes made so far, those of the bodies of loops included.
    made: usize,
    depth: usize,
}

impl<'a> Parser<'a> {
    fn whole(&mut self) -> Parsed<()> {
        self.expression(power::NONE)?;
        if self.peek().kind == TokenKind::End {
            Ok(())
        } else {
            Err(self.unexpected("an operator or the end"))
        }
    }

    /// The longest expression whose operators all bind at least as strongly as `least`.
    fn expression(&mut self, least: u8) -> Parsed<Operand> {
        if self.depth == MAX_DEPTH {
            let message = format!("expression nested more than {MAX_DEPTH} deep");
            return Err(self.fault(
                Rule::E0206,
                self.peek().range.clone(),
                message,
                "name its parts in `definitions`",
            ));
        }
        self.depth += 1;
        let mut left = self.operand()?;
        while let TokenKind::Infix(operator) = self.peek().kind {
            let (binds_left, binds_right) = power::of(operator);
            if binds_left < least {
                break;
            }
            self.next += 1;
            let right = self.expression(binds_right)?;
            let range = left.range.start..right.range.end;
            left = self.push(range, Kind::Infix(operator, left.id, right.id))?;
            self.refuse_chain(operator)?;
        }
        self.depth -= 1;
        Ok(left)
    }

    /// `a < b < c` has no meaning here.
    fn refuse_chain(&self, operator: Infix) -> Parsed<()> {
        let next = self.peek();
        match (operator, &next.kind) {
            (Infix::Compare(_), TokenKind::Infix(Infix::Compare(_))) => {
                let message = format!(
                    "chained comparison: found `{}` after a comparison",
                    self.shown(next)
                );
                Err(self.fault(
                    Rule::E0205,
                    next.range.clone(),
                    message,
                    "join two comparisons: `a < b and b < c`",
                ))
            }
            _ => Ok(()),
        }
    }

    /// An operand with its indices: everything that stands between two operators.
    fn operand(&mut self) -> Parsed<Operand> {
        let token = self.advance();
        let start = token.range.start;
        let mut operand = match &token.kind {
            TokenKind::Number(literal) => {
                self.push(token.range.clone(), Kind::Number(literal.clone()))?
            }
            TokenKind::Name(name) if self.peek().kind == TokenKind::Open => {
                self.call(name, token.range.clone())?
            }
            TokenKind::Name(name) => self.push(token.range.clone(), Kind::Name(name.clone()))?,
            TokenKind::Infix(Infix::Sub) => return self.prefix(start, power::NEGATE, Kind::Negate),
            TokenKind::Not => return self.prefix(start, power::NOT, Kind::Not),
            TokenKind::Open => {
                let inner = self.expression(power::NONE)?;
                let end = self.close(&TokenKind::Close, start, "an operator or `)`")?;
                Operand {
                    id: inner.id,
                    range: start..end,
                }
            }
            TokenKind::OpenArray => {
                let (items, end) =
                    self.list(&TokenKind::CloseArray, start, "`,`, an operator or `]`")?;
                self.push(start..end, Kind::Array(items))?
            }
            _ => {
                self.next -= 1;
                return Err(self.unexpected("an expression"));
            }
        };
        while self.peek().kind == TokenKind::OpenArray {
            operand = self.index(operand)?;
        }
        self.refuse_juxtaposition(&operand)?;
        Ok(operand)
    }

    fn prefix(&mut self, start: usize, binds: u8, kind: fn(NodeId) -> Kind) -> Parsed<Operand> {
        let operand = self.expression(binds)?;
        self.push(start..operand.range.end, kind(operand.id))
    }

    /// `2 (x)`, `x y`: most often a forgotten `*`.
    fn refuse_juxtaposition(&self, operand: &Operand) -> Parsed<()> {
        let next = self.peek();
        if !matches!(
            next.kind,
            TokenKind::Number(_) | TokenKind::Name(_) | TokenKind::Not | TokenKind::Open
        ) {
            return Ok(());
        }
        let message = format!(
            "missing operator between {} and {}",
            self.quoted(&operand.range),
            self.quoted(&next.range)
        );
        let between = operand.range.end..next.range.start;
        let fault = self.fault(
            Rule::E0208,
            operand.range.start..next.range.end,
            message,
            "write `*` to multiply; a unit follows its number after at most one blank",
        );
        if !self.base.holds(between.clone()) {
            return Err(fault);
        }
        let span = self.base.span_of(between);
        Err(Box::new(fault.with_suggestion(
            span,
            "*",
            Applicability::Possible,
        )))
    }

    /// `name(..)`, the name just read.
    fn call(&mut self, name: &str, range: Range<usize>) -> Parsed<Operand> {
        let start = range.start;
        let open = self.advance().range.start;
        match name {
            "partial" => return self.partial(start, open),
            "each" => return self.each(start, open),
            _ => {}
        }
        let name = Name {
            text: name.to_owned(),
            span: self.base.span_of(range),
        };
        let (arguments, end) = self.list(&TokenKind::Close, open, "`,`, an operator or `)`")?;
        self.push(start..end, Kind::Call(name, arguments))
    }

    /// One or more expressions up to the closing bracket, and the byte after that.
    fn list(
        &mut self,
        closing: &TokenKind,
        open: usize,
        expected: &str,
    ) -> Parsed<(Vec<NodeId>, usize)> {
        let mut items = vec![self.expression(power::NONE)?.id];
        while self.peek().kind == TokenKind::Comma {
            self.next += 1;
            items.push(self.expression(power::NONE)?.id);
        }
        let end = self.close(closing, open, expected)?;
        Ok((items, end))
    }

    /// The byte after the bracket that must come next.
    fn close(&mut self, closing: &TokenKind, open: usize, expected: &str) -> Parsed<usize> {
        let token = self.peek();
        if token.kind == *closing {
            self.next += 1;
            return Ok(token.range.end);
        }
        let message = format!("found {}, expected {expected}", self.named(token));
        let help = match token.kind {
            TokenKind::Comma => "write a vector in square brackets: `[a, b]`",
            _ => "every bracket that opens must close",
        };
        let fault = self
            .fault(Rule::E0204, token.range.clone(), message, help)
            .with_related(self.base.span_of(open..open + 1), "the bracket opens here");
        let missing = match closing {
            TokenKind::Close => ")",
            _ => "]",
        };
        let end = self.text.trim_end().len();
        if token.kind == TokenKind::End && self.base.holds(end..end) {
            let span = self.base.span_of(end..end);
            let fault = fault.with_suggestion(span, missing, Applicability::Possible);
            return Err(Box::new(fault));
        }
        Err(Box::new(fault))
    }

    fn push(&mut self, range: Range<usize>, kind: Kind) -> Parsed<Operand> {
        if self.made == MAX_NODES {
            let message = format!("expression of more than {MAX_NODES} terms");
            return Err(self.fault(
                Rule::E0207,
                range,
                message,
                "split it into named definitions",
            ));
        }
        self.made += 1;
        let id = NodeId(u32::try_from(self.nodes.len()).expect("invariant: MAX_NODES fits u32"));
        self.nodes.push(Node {
            span: self.base.span_of(range.clone()),
            kind,
        });
        Ok(Operand { id, range })
    }

    fn peek(&self) -> &'a Token {
        &self.tokens[self.next]
    }

    /// The next token, which is consumed unless it is the end.
    fn advance(&mut self) -> &'a Token {
        let token = self.peek();
        self.next += 1;
        token
    }

    fn unexpected(&self, expected: &str) -> Box<Diagnostic> {
        let token = self.peek();
        let message = format!("found {}, expected {expected}", self.named(token));
        let help = match &token.kind {
            TokenKind::Infix(Infix::Add) => "leave out a `+` in front of a number",
            TokenKind::Close | TokenKind::CloseArray => {
                "check that every bracket that closes was opened and is not empty"
            }
            TokenKind::End => "the expression stops too early",
            _ => "an expression is made of operands with operators between them",
        };
        let fault = self.fault(Rule::E0203, token.range.clone(), message, help);
        match &token.kind {
            TokenKind::Infix(Infix::Add) => self.with_change(fault, token.range.clone(), ""),
            _ => fault,
        }
    }

    /// The fault with a change that certainly mends it.
    fn with_change(
        &self,
        fault: Box<Diagnostic>,
        range: Range<usize>,
        replacement: &str,
    ) -> Box<Diagnostic> {
        if !self.base.holds(range.clone()) {
            return fault;
        }
        let span = self.base.span_of(range);
        Box::new(fault.with_suggestion(span, replacement, Applicability::Certain))
    }

    fn fault(
        &self,
        rule: Rule,
        range: Range<usize>,
        message: String,
        help: impl Into<String>,
    ) -> Box<Diagnostic> {
        Box::new(Diagnostic::error(rule, self.base.span_of(range), message).with_help(help))
    }

    fn named(&self, token: &Token) -> String {
        if token.kind == TokenKind::End {
            "the end".to_owned()
        } else {
            self.quoted(&token.range)
        }
    }

    fn shown(&self, token: &Token) -> &'a str {
        &self.text[token.range.clone()]
    }

    fn quoted(&self, range: &Range<usize>) -> String {
        quoted(&self.text[range.clone()])
    }
}
