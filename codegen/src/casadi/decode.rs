//! From a tape to a program. A tape is untrusted: everything about it is checked, and what does not hold is an error.
//!
//! Structural zeros (an entry that CasADi left out, a derivative of polynomial data that vanishes) are carried as zeros and follow CasADi's
//! own rules: 0 + x is x, 0 * x is 0. They are zeros of the mathematics, so x = inf does not make them NaN.

use std::collections::BTreeMap;
use std::fmt;

use super::document::{Node, Tape};
use super::hexfloat;
use super::job::MAX_ORDER;
use super::polynomial::differentiate;
use super::request::Question;
use super::sweep::sweep;
use crate::ir::build::size;
use crate::ir::{Comparison, Function, Kernel, Op, Operator, PolynomialId, Program, Shape, ValueId};

/// Largest tape that is read, in nodes.
const MAX_NODES: usize = 1_000_000;

/// Why a tape is not the answer to its question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TapeError {
    /// More nodes than are read.
    TooLarge {
        /// Number of nodes.
        nodes: usize,
    },
    /// A constant that is not finite hexadecimal floating point.
    Constant {
        /// As written.
        text: String,
    },
    /// Operands or integers that do not fit the operation.
    Malformed {
        /// Node.
        node: usize,
        /// Its operation.
        operation: String,
    },
    /// An operation that the compiler does not have.
    Unsupported {
        /// Node.
        node: usize,
        /// Its operation.
        operation: String,
    },
    /// Outputs other than those asked for.
    Outputs {
        /// Name of the first one that differs.
        name: String,
    },
}

impl fmt::Display for TapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TapeError::TooLarge { nodes } => write!(f, "{nodes} instructions, at most {MAX_NODES} are read"),
            TapeError::Constant { text } => write!(f, "`{text}` is not a finite constant"),
            TapeError::Malformed { node, operation } => write!(f, "instruction {node} (`{operation}`) has wrong operands"),
            TapeError::Unsupported { node, operation } => {
                write!(f, "instruction {node} is `{operation}`, an operation that nsv does not have")
            }
            TapeError::Outputs { name } => write!(f, "output `{name}` is not the one asked for"),
        }
    }
}

impl std::error::Error for TapeError {}

/// The program of a tape that answers `question`.
pub fn decode(question: &Question<'_>, tape: &Tape) -> Result<Program, TapeError> {
    let (formula, job) = (question.formula, &question.request.job);
    if tape.nodes.len() > MAX_NODES {
        return Err(TapeError::TooLarge { nodes: tape.nodes.len() });
    }
    let program =
        Program { name: format!("{}_{}", formula.name, job.suffix()), inputs: job.inputs(formula), ..Program::default() };
    let mut decoder = Decoder {
        question,
        tape,
        program,
        terms: Vec::with_capacity(tape.nodes.len()),
        scalars: BTreeMap::new(),
        inputs: BTreeMap::new(),
        polynomials: BTreeMap::new(),
    };
    for (number, node) in tape.nodes.iter().enumerate() {
        let term = decoder.node(number, node)?;
        decoder.terms.push(term);
    }
    decoder.outputs(&job.outputs(formula))?;
    sweep(&mut decoder.program);
    Ok(decoder.program)
}

/// What a node of the tape is.
#[derive(Clone, Copy)]
enum Term {
    /// Structural zero.
    Zero,
    /// Real scalar.
    Real(ValueId),
    /// Truth value, which CasADi counts as 0 or 1.
    Truth(ValueId),
}

struct Decoder<'a> {
    question: &'a Question<'a>,
    tape: &'a Tape,
    program: Program,
    terms: Vec<Term>,
    scalars: BTreeMap<u64, ValueId>,
    inputs: BTreeMap<(usize, usize), ValueId>,
    /// By index in the request and orders; `None` where the derivative vanishes.
    polynomials: BTreeMap<Vec<i64>, Option<PolynomialId>>,
}

impl Decoder<'_> {
    fn node(&mut self, number: usize, node: &Node) -> Result<Term, TapeError> {
        let Node(name, operands, data) = node;
        let malformed = || TapeError::Malformed { node: number, operation: name.clone() };
        if operands.iter().any(|operand| *operand >= number) {
            return Err(malformed());
        }
        match (name.as_str(), operands.as_slice(), data.as_slice()) {
            ("const", [], [position]) => self.constant(*position).ok_or_else(malformed)?.map(|value| self.scalar_term(value)),
            ("input", [], [position, entry]) => self.input(*position, *entry).map(Term::Real).ok_or_else(malformed),
            ("power", [a], [n]) => u32::try_from(*n).ok().and_then(|n| self.power(*a, n)).ok_or_else(malformed),
            ("polynomial", arguments, data) => self.polynomial(arguments, data).ok_or_else(malformed),
            ("sin_cos_over" | "tan_over", [a], [order]) => {
                let kernel = kernel(name, *order).ok_or_else(malformed)?;
                let a = self.real(*a);
                Ok(self.push(Op::Kernel(kernel, a)))
            }
            (name, [a], []) => self.unary(name, *a).ok_or_else(|| unsupported(number, name)),
            (name, [a, b], []) => self.binary(name, *a, *b).ok_or_else(|| unsupported(number, name)),
            (name, ..) if is_known(name) => Err(malformed()),
            (name, ..) => Err(unsupported(number, name)),
        }
    }

    fn constant(&self, position: i64) -> Option<Result<f64, TapeError>> {
        let text = self.tape.constants.get(usize::try_from(position).ok()?)?;
        Some(hexfloat::parse(text).ok_or_else(|| TapeError::Constant { text: text.clone() }))
    }

    fn scalar_term(&mut self, value: f64) -> Term {
        if value == 0.0 { Term::Zero } else { Term::Real(self.scalar(value)) }
    }

    fn input(&mut self, position: i64, entry: i64) -> Option<ValueId> {
        let (position, entry) = (usize::try_from(position).ok()?, usize::try_from(entry).ok()?);
        let shape = self.program.inputs.get(position)?.shape;
        if entry >= size(shape) {
            return None;
        }
        if let Some(id) = self.inputs.get(&(position, entry)) {
            return Some(*id);
        }
        // The whole array is kept under an entry number that no array has.
        let whole = (position, usize::MAX);
        let array = self.inputs.get(&whole).copied().unwrap_or_else(|| self.program.push(Op::Input(position)));
        self.inputs.insert(whole, array);
        let id = match shape {
            Shape::Scalar => array,
            Shape::Vector(_) => self.program.push(Op::Element(array, entry, 0)),
            Shape::Matrix(_, columns) => self.program.push(Op::Element(array, entry / columns, entry % columns)),
        };
        self.inputs.insert((position, entry), id);
        Some(id)
    }

    fn polynomial(&mut self, arguments: &[usize], data: &[i64]) -> Option<Term> {
        let (index, orders) = data.split_first()?;
        let orders: Vec<u32> = orders.iter().map(|order| u32::try_from(*order).ok()).collect::<Option<_>>()?;
        let source = self.question.polynomials.get(usize::try_from(*index).ok()?)?;
        let source = &self.question.formula.polynomials[source.0 as usize];
        let fits = arguments.len() == source.arguments.len() && orders.len() == arguments.len();
        if !fits || orders.iter().any(|order| *order > MAX_ORDER as u32) {
            return None;
        }
        let known = self.polynomials.get(data).copied();
        let id = known.unwrap_or_else(|| {
            let derived = differentiate(source, &orders);
            let next = PolynomialId(u32::try_from(self.program.polynomials.len()).expect("invariant: few polynomials"));
            let id = (!derived.terms.is_empty()).then_some(next);
            self.program.polynomials.extend(id.map(|_| derived));
            self.polynomials.insert(data.to_vec(), id);
            id
        });
        let Some(id) = id else { return Some(Term::Zero) };
        let arguments = arguments.iter().map(|argument| self.real(*argument)).collect();
        Some(self.push(Op::Polynomial(id, arguments)))
    }

    fn power(&mut self, a: usize, n: u32) -> Option<Term> {
        if n < 2 {
            return None;
        }
        if let Term::Zero = self.terms[a] {
            return Some(Term::Zero);
        }
        let a = self.real(a);
        Some(self.push(Op::PowInt(a, n)))
    }

    fn unary(&mut self, name: &str, a: usize) -> Option<Term> {
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

    fn binary(&mut self, name: &str, a: usize, b: usize) -> Option<Term> {
        match name {
            "ADD" => return Some(self.add(a, b)),
            "IF_ELSE_ZERO" => return Some(self.choose(a, b, None)),
            "POW" | "CONSTPOW" => return Some(self.pow(a, b)),
            "AND" | "OR" => {
                let (a, b) = (self.truth(a), self.truth(b));
                let op = if name == "AND" { Op::And(a, b) } else { Op::Or(a, b) };
                return Some(Term::Truth(self.program.push(op)));
            }
            _ => {}
        }
        if let Some(comparison) = comparison(name) {
            let (a, b) = (self.real(a), self.real(b));
            return Some(Term::Truth(self.program.push(Op::Compare(comparison, a, b))));
        }
        match (name, self.terms[a], self.terms[b]) {
            ("MUL", Term::Zero, _) | ("MUL", _, Term::Zero) | ("DIV", Term::Zero, _) => return Some(Term::Zero),
            ("SUB", _, Term::Zero) => return Some(self.terms[a]),
            ("SUB", Term::Zero, _) => return self.unary("NEG", b),
            _ => {}
        }
        let (x, y) = (self.real(a), self.real(b));
        if name == "HYPOT" {
            let (x, y) = (self.program.push(Op::PowInt(x, 2)), self.program.push(Op::PowInt(y, 2)));
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
        let integer = exponent.filter(|value| value.fract() == 0.0 && value.abs() <= f64::from(u16::MAX));
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
        if n < 0.0 { self.push(Op::Binary(Operator::Div, one, positive)) } else { Term::Real(positive) }
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

    fn real(&mut self, node: usize) -> ValueId {
        match self.terms[node] {
            Term::Zero => self.scalar(0.0),
            Term::Real(id) => id,
            Term::Truth(id) => {
                let (one, zero) = (self.scalar(1.0), self.scalar(0.0));
                self.program.push(Op::Select(id, one, zero))
            }
        }
    }

    /// The value of a node, 0 where there is none.
    fn entry(&mut self, node: Option<usize>) -> ValueId {
        match node {
            Some(node) => self.real(node),
            None => self.scalar(0.0),
        }
    }

    fn truth(&mut self, node: usize) -> ValueId {
        match self.terms[node] {
            Term::Truth(id) => id,
            Term::Zero | Term::Real(_) => {
                let (value, zero) = (self.real(node), self.scalar(0.0));
                self.program.push(Op::Compare(Comparison::Ne, value, zero))
            }
        }
    }

    fn scalar(&mut self, value: f64) -> ValueId {
        *self.scalars.entry(value.to_bits()).or_insert_with(|| self.program.scalar(value))
    }

    fn push(&mut self, op: Op) -> Term {
        Term::Real(self.program.push(op))
    }

    fn outputs(&mut self, expected: &[(String, Shape)]) -> Result<(), TapeError> {
        let extra = self.tape.outputs.get(expected.len());
        if let Some((name, _)) = extra {
            return Err(TapeError::Outputs { name: name.clone() });
        }
        for (position, (name, shape)) in expected.iter().enumerate() {
            let wrong = || TapeError::Outputs { name: name.clone() };
            let (found, entries) = self.tape.outputs.get(position).ok_or_else(wrong)?;
            let in_range = entries.iter().flatten().all(|node| *node < self.terms.len());
            if found != name || entries.len() != size(*shape) || !in_range {
                return Err(wrong());
            }
            let id = self.assemble(*shape, entries);
            self.program.outputs.push((name.clone(), id));
        }
        Ok(())
    }

    /// An output from its scalar entries.
    fn assemble(&mut self, shape: Shape, entries: &[Option<usize>]) -> ValueId {
        let zero = |entry: &Option<usize>| entry.is_none_or(|node| matches!(self.terms[node], Term::Zero));
        if entries.iter().all(zero) {
            return self.program.constant(shape, vec![0.0; size(shape)]);
        }
        let items: Vec<ValueId> = entries.iter().map(|entry| self.entry(*entry)).collect();
        if shape == Shape::Scalar { items[0] } else { self.program.array(shape, items) }
    }
}

fn unsupported(node: usize, operation: &str) -> TapeError {
    TapeError::Unsupported { node, operation: operation.to_owned() }
}

fn is_known(name: &str) -> bool {
    let calls = ["const", "input", "power", "polynomial", "sin_cos_over", "tan_over"];
    let special = ["ASSIGN", "NOT", "SQ", "TWICE", "INV", "ADD", "IF_ELSE_ZERO", "POW", "CONSTPOW", "AND", "OR", "HYPOT"];
    calls.contains(&name)
        || special.contains(&name)
        || function(name).is_some()
        || comparison(name).is_some()
        || operator(name).is_some()
}

fn kernel(name: &str, order: i64) -> Option<Kernel> {
    match (name, order) {
        ("sin_cos_over", 0) => Some(Kernel::SinCosOver),
        ("sin_cos_over", 1) => Some(Kernel::SinCosOverD1),
        ("sin_cos_over", 2) => Some(Kernel::SinCosOverD2),
        ("sin_cos_over", 3) => Some(Kernel::SinCosOverD3),
        ("tan_over", 0) => Some(Kernel::TanOver),
        _ => None,
    }
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
