//! CasADi's arithmetic in terms of the IR.

use super::decode::{Decoder, Term};
use super::document::Node;
use crate::ir::{Comparison, Function, Op, Operator};

impl Decoder<'_> {
    pub(super) fn unary(&mut self, name: &str, a: usize) -> Option<Term> {
        let zero = matches!(self.terms[a], Term::Zero);
        match name {
            "ASSIGN" => return Some(self.terms[a]),
            "NEG" | "SQ" | "TWICE" if zero => return Some(Term::Zero),
            "NOT" => {
                let a = self.truth(a);
                return Some(Term::Truth(self.program.push(Op::Not(a))));
            }
            _ => {}
        }
        let op = match name {
            "SQ" => Op::PowInt(self.real(a), 2),
            // x + x is 2 x exactly.
            "TWICE" => Op::Binary(Operator::Add, self.real(a), self.real(a)),
            "INV" => Op::Binary(Operator::Div, self.scalar(1.0), self.real(a)),
            _ => Op::Apply(function(name)?, self.real(a)),
        };
        Some(self.push(op))
    }

    pub(super) fn binary(&mut self, name: &str, a: usize, b: usize) -> Option<Term> {
        match name {
            "ADD" => return Some(self.add(a, b)),
            "IF_ELSE_ZERO" => return Some(self.choose(a, b, None)),
            "POW" | "CONSTPOW" => return Some(self.pow(a, b)),
            "AND" | "OR" => {
                let (a, b) = (self.truth(a), self.truth(b));
                let op = if name == "AND" {
                    Op::And(a, b)
                } else {
                    Op::Or(a, b)
                };
                return Some(Term::Truth(self.program.push(op)));
            }
            _ => {}
        }
        if let Some(comparison) = comparison(name) {
            let (a, b) = (self.real(a), self.real(b));
            return Some(Term::Truth(
                self.program.push(Op::Compare(comparison, a, b)),
            ));
        }
        match (name, self.terms[a], self.terms[b]) {
            ("MUL", Term::Zero, _) | ("MUL", _, Term::Zero) | ("DIV", Term::Zero, _) => {
                return Some(Term::Zero);
            }
            ("SUB", _, Term::Zero) => return Some(self.terms[a]),
            ("SUB", Term::Zero, _) => return self.unary("NEG", b),
            _ => {}
        }
        let (x, y) = (self.real(a), self.real(b));
        if name == "HYPOT" {
            let (x, y) = (
                self.program.push(Op::PowInt(x, 2)),
                self.program.push(Op::PowInt(y, 2)),
            );
            let sum = self.program.binary(Operator::Add, x, y);
            return Some(self.push(Op::Apply(Function::Sqrt, sum)));
        }
        Some(self.push(Op::Binary(operator(name)?, x, y)))
    }

    /// A sum. CasADi writes `if(c, x, y)` as `if_else_zero(c, x) + if_else_zero(not c, y)`.
    fn add(&mut self, a: usize, b: usize) -> Term {
        if let (Some((c, x)), Some((d, y))) = (self.masked(a), self.masked(b)) {
            if self.is_not(d, c) {
                return self.choose(c, x, Some(y));
            }
            if self.is_not(c, d) {
                return self.choose(d, y, Some(x));
            }
        }
        match (self.terms[a], self.terms[b]) {
            (Term::Zero, other) | (other, Term::Zero) => other,
            _ => {
                let op = Op::Binary(Operator::Add, self.real(a), self.real(b));
                self.push(op)
            }
        }
    }

    /// `x` if the condition holds, else `y` or 0: no arithmetic, so an arm that is not taken may be NaN.
    fn choose(&mut self, condition: usize, x: usize, y: Option<usize>) -> Term {
        let zero = |term: Term| matches!(term, Term::Zero);
        if zero(self.terms[x]) && y.is_none_or(|y| zero(self.terms[y])) {
            return Term::Zero;
        }
        let condition = self.truth(condition);
        let x = self.real(x);
        let y = self.entry(y);
        self.push(Op::Select(condition, x, y))
    }

    /// x^y; a constant integer exponent is a product, never `pow`.
    fn pow(&mut self, a: usize, b: usize) -> Term {
        let exponent = match &self.tape.nodes[b] {
            Node(name, _, data) if name == "const" => self.constant(data[0]).and_then(Result::ok),
            _ => None,
        };
        let integer =
            exponent.filter(|value| value.fract() == 0.0 && value.abs() <= f64::from(u16::MAX));
        let (x, one) = (self.real(a), self.scalar(1.0));
        let Some(n) = integer else {
            let y = self.real(b);
            return self.push(Op::Binary(Operator::Pow, x, y));
        };
        let positive = match n.abs() as u32 {
            0 => one,
            1 => x,
            n => self.program.push(Op::PowInt(x, n)),
        };
        if n < 0.0 {
            self.push(Op::Binary(Operator::Div, one, positive))
        } else {
            Term::Real(positive)
        }
    }

    fn masked(&self, node: usize) -> Option<(usize, usize)> {
        match &self.tape.nodes[node] {
            Node(name, operands, _) if name == "IF_ELSE_ZERO" => Some((operands[0], operands[1])),
            _ => None,
        }
    }

    fn is_not(&self, node: usize, of: usize) -> bool {
        let Node(name, operands, _) = &self.tape.nodes[node];
        name == "NOT" && operands[0] == of
    }
}

/// Whether CasADi's operation is decoded.
pub(super) fn is_known(name: &str) -> bool {
    let special = [
        "ASSIGN",
        "NOT",
        "SQ",
        "TWICE",
        "INV",
        "IF_ELSE_ZERO",
        "POW",
        "CONSTPOW",
        "AND",
        "OR",
        "HYPOT",
    ];
    special.contains(&name)
        || function(name).is_some()
        || comparison(name).is_some()
        || operator(name).is_some()
}

fn function(name: &str) -> Option<Function> {
    Some(match name {
        "NEG" => Function::Neg,
        "FABS" => Function::Abs,
        "SIGN" => Function::Sign,
        "SQRT" => Function::Sqrt,
        "EXP" => Function::Exp,
        "LOG" => Function::Ln,
        "SIN" => Function::Sin,
        "COS" => Function::Cos,
        "TAN" => Function::Tan,
        "ASIN" => Function::Asin,
        "ACOS" => Function::Acos,
        "ATAN" => Function::Atan,
        "SINH" => Function::Sinh,
        "COSH" => Function::Cosh,
        "TANH" => Function::Tanh,
        _ => return None,
    })
}

fn comparison(name: &str) -> Option<Comparison> {
    match name {
        "LT" => Some(Comparison::Lt),
        "LE" => Some(Comparison::Le),
        "EQ" => Some(Comparison::Eq),
        "NE" => Some(Comparison::Ne),
        _ => None,
    }
}

fn operator(name: &str) -> Option<Operator> {
    match name {
        "ADD" => Some(Operator::Add),
        "SUB" => Some(Operator::Sub),
        "MUL" => Some(Operator::Mul),
        "DIV" => Some(Operator::Div),
        "FMIN" => Some(Operator::Min),
        "FMAX" => Some(Operator::Max),
        "ATAN2" => Some(Operator::Atan2),
        _ => None,
    }
}
