//! From a tape to a program. A tape is untrusted: everything about it is checked, and what does not hold is an error.
//!
//! Structural zeros (an entry that CasADi left out, a derivative of polynomial data that vanishes) are carried as zeros and follow CasADi's
//! own rules: 0 + x is x, 0 * x is 0. They are zeros of the mathematics, so x = inf does not make them NaN.

use std::collections::BTreeMap;

use super::arithmetic;
use super::document::{Node, Tape};
use super::error::TapeError;
use super::hexfloat;
use super::request::Question;
use crate::ir::build::size;
use crate::ir::{Comparison, Kernel, Op, PolynomialId, Program, Shape, ValueId};
use crate::opt::dead_code;

/// Largest tape that is read, in nodes.
pub(super) const MAX_NODES: usize = 1_000_000;

/// The program of a tape that answers `question`.
pub fn decode(question: &Question<'_>, tape: &Tape) -> Result<Program, TapeError> {
    let (formula, job) = (question.formula, &question.request.job);
    if tape.nodes.len() > MAX_NODES {
        return Err(TapeError::TooLarge {
            nodes: tape.nodes.len(),
        });
    }
    let program = Program {
        name: format!("{}_{}", formula.name, job.suffix()),
        inputs: job.inputs(formula),
        ..Program::default()
    };
    let mut decoder = Decoder {
        question,
        tape,
        program,
        terms: Vec::with_capacity(tape.nodes.len()),
        scalars: BTreeMap::new(),
        inputs: BTreeMap::new(),
        solutions: BTreeMap::new(),
        polynomials: BTreeMap::new(),
    };
    for (number, node) in tape.nodes.iter().enumerate() {
        let term = decoder.node(number, node)?;
        decoder.terms.push(term);
    }
    decoder.outputs(&job.outputs(formula))?;
    Ok(dead_code::run(decoder.program))
}

/// What a node of the tape is.
#[derive(Clone, Copy)]
pub(super) enum Term {
    /// Structural zero.
    Zero,
    /// Real scalar.
    Real(ValueId),
    /// Truth value, which CasADi counts as 0 or 1.
    Truth(ValueId),
}

pub(super) struct Decoder<'a> {
    pub(super) question: &'a Question<'a>,
    pub(super) tape: &'a Tape,
    pub(super) program: Program,
    pub(super) terms: Vec<Term>,
    scalars: BTreeMap<u64, ValueId>,
    inputs: BTreeMap<(usize, usize), ValueId>,
    /// By matrix and right side.
    solutions: BTreeMap<Vec<usize>, ValueId>,
    /// By index in the request and orders; `None` where the derivative vanishes.
    pub(super) polynomials: BTreeMap<Vec<i64>, Option<PolynomialId>>,
}

impl Decoder<'_> {
    fn node(&mut self, number: usize, node: &Node) -> Result<Term, TapeError> {
        let Node(name, operands, data) = node;
        let malformed = || TapeError::Malformed {
            node: number,
            operation: name.clone(),
        };
        if operands.iter().any(|operand| *operand >= number) {
            return Err(malformed());
        }
        match (name.as_str(), operands.as_slice(), data.as_slice()) {
            ("const", [], [position]) => self
                .constant(*position)
                .ok_or_else(malformed)?
                .map(|value| self.scalar_term(value)),
            ("input", [], [position, entry]) => self
                .input(*position, *entry)
                .map(Term::Real)
                .ok_or_else(malformed),
            ("powi", [a], [n]) => u32::try_from(*n)
                .ok()
                .and_then(|n| self.power(*a, n))
                .ok_or_else(malformed),
            ("solve", arguments, [rows, entry]) => self
                .solution(arguments, *rows, *entry)
                .ok_or_else(malformed),
            ("polynomial", arguments, data) => self.data(arguments, data).ok_or_else(malformed),
            ("sin_cos_over" | "tan_over", [a], [order]) => {
                let kernel = kernel(name, *order).ok_or_else(malformed)?;
                let a = self.real(*a);
                Ok(self.push(Op::Kernel(kernel, a)))
            }
            (name, [a], []) => self.unary(name, *a).ok_or_else(|| unfit(number, name)),
            (name, [a, b], []) => self.binary(name, *a, *b).ok_or_else(|| unfit(number, name)),
            (name, ..) => Err(unfit(number, name)),
        }
    }

    pub(super) fn constant(&self, position: i64) -> Option<Result<f64, TapeError>> {
        let text = self.tape.constants.get(usize::try_from(position).ok()?)?;
        Some(hexfloat::parse(text).ok_or_else(|| TapeError::Constant { text: text.clone() }))
    }

    fn scalar_term(&mut self, value: f64) -> Term {
        if value == 0.0 {
            Term::Zero
        } else {
            Term::Real(self.scalar(value))
        }
    }

    fn input(&mut self, position: i64, entry: i64) -> Option<ValueId> {
        let (position, entry) = (
            usize::try_from(position).ok()?,
            usize::try_from(entry).ok()?,
        );
        let shape = self.program.inputs.get(position)?.shape;
        if entry >= size(shape) {
            return None;
        }
        if let Some(id) = self.inputs.get(&(position, entry)) {
            return Some(*id);
        }
        // The whole array is kept under an entry number that no array has.
        let whole = (position, usize::MAX);
        let array = self
            .inputs
            .get(&whole)
            .copied()
            .unwrap_or_else(|| self.program.push(Op::Input(position)));
        self.inputs.insert(whole, array);
        let id = match shape {
            Shape::Scalar => array,
            Shape::Vector(_) => self.program.push(Op::Element(array, entry, 0)),
            Shape::Matrix(_, columns) => {
                self.program
                    .push(Op::Element(array, entry / columns, entry % columns))
            }
        };
        self.inputs.insert((position, entry), id);
        Some(id)
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

    /// An entry of the solution of equations, whose matrix stands before the right side.
    fn solution(&mut self, arguments: &[usize], rows: i64, entry: i64) -> Option<Term> {
        let rows = usize::try_from(rows).ok().filter(|&rows| rows > 0)?;
        let entry = usize::try_from(entry).ok().filter(|&entry| entry < rows)?;
        if rows.checked_mul(rows + 1)? != arguments.len() {
            return None;
        }
        let solution = match self.solutions.get(arguments) {
            Some(&solution) => solution,
            None => {
                let mut items: Vec<ValueId> = arguments.iter().map(|&a| self.real(a)).collect();
                let right = items.split_off(rows * rows);
                let matrix = self.program.array(Shape::Matrix(rows, rows), items);
                let right = self.program.array(Shape::Vector(rows), right);
                let solution = self.program.push(Op::Solve(matrix, right));
                self.solutions.insert(arguments.to_vec(), solution);
                solution
            }
        };
        Some(self.push(Op::Element(solution, entry, 0)))
    }

    pub(super) fn real(&mut self, node: usize) -> ValueId {
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
    pub(super) fn entry(&mut self, node: Option<usize>) -> ValueId {
        match node {
            Some(node) => self.real(node),
            None => self.scalar(0.0),
        }
    }

    pub(super) fn truth(&mut self, node: usize) -> ValueId {
        match self.terms[node] {
            Term::Truth(id) => id,
            Term::Zero | Term::Real(_) => {
                let (value, zero) = (self.real(node), self.scalar(0.0));
                self.program.push(Op::Compare(Comparison::Ne, value, zero))
            }
        }
    }

    pub(super) fn scalar(&mut self, value: f64) -> ValueId {
        *self
            .scalars
            .entry(value.to_bits())
            .or_insert_with(|| self.program.scalar(value))
    }

    pub(super) fn push(&mut self, op: Op) -> Term {
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
            let in_range = entries
                .iter()
                .flatten()
                .all(|node| *node < self.terms.len());
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
        let zero =
            |entry: &Option<usize>| entry.is_none_or(|node| matches!(self.terms[node], Term::Zero));
        if entries.iter().all(zero) {
            return self.program.constant(shape, vec![0.0; size(shape)]);
        }
        let items: Vec<ValueId> = entries.iter().map(|entry| self.entry(*entry)).collect();
        if shape == Shape::Scalar {
            items[0]
        } else {
            self.program.array(shape, items)
        }
    }
}

/// The error of a node that no operation fits.
fn unfit(node: usize, operation: &str) -> TapeError {
    let calls = [
        "const",
        "input",
        "powi",
        "solve",
        "polynomial",
        "sin_cos_over",
        "tan_over",
    ];
    let known = calls.contains(&operation) || arithmetic::is_known(operation);
    let operation = operation.to_owned();
    if known {
        TapeError::Malformed { node, operation }
    } else {
        TapeError::Unsupported { node, operation }
    }
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
