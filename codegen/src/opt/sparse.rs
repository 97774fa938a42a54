//! Products and solutions with matrices whose structure has zeros, written out entry by entry without them.

use crate::ir::build::size;
use crate::ir::{Op, Operator, Program, Shape, ValueId};

use super::rewrite::literal;

/// Largest product that is written out, in entries.
const LARGEST: usize = 64;

/// A x or A B of a literal matrix of which at least half are zeros: each entry is the sum of its products with the others (finite entries,
/// up to the sign of zero).
pub(super) fn product(program: &mut Program, a: ValueId, b: ValueId) -> Option<ValueId> {
    let entries = literal(program, a)?.to_vec();
    let zeros = entries.iter().filter(|&&entry| entry == 0.0).count();
    let (inner, columns) = (columns(program, a), columns(program, b));
    let rows = entries.len() / inner;
    if 2 * zeros < entries.len() || rows * columns > LARGEST {
        return None;
    }
    let shape = match program.shape(b) {
        Shape::Matrix(_, columns) => Shape::Matrix(rows, columns),
        _ => Shape::Vector(rows),
    };
    let mut items = Vec::with_capacity(rows * columns);
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let terms: Vec<(f64, ValueId)> = (0..inner)
            .filter(|k| entries[row * inner + k] != 0.0)
            .map(|k| {
                let entry = program.push(Op::Element(b, k, column));
                (entries[row * inner + k], entry)
            })
            .collect();
        items.push(sum(program, terms));
    }
    Some(program.array(shape, items))
}

fn sum(program: &mut Program, terms: Vec<(f64, ValueId)>) -> ValueId {
    let mut total = None;
    for (factor, entry) in terms {
        let factor = program.scalar(factor);
        let term = program.binary(Operator::Mul, factor, entry);
        total = Some(match total {
            None => term,
            Some(total) => program.binary(Operator::Add, total, term),
        });
    }
    total.unwrap_or_else(|| program.scalar(0.0))
}

/// A^-1 b for a diagonal matrix: b_i (1 / a_ii), by the reciprocal itself if that is known (one or two roundings instead of the four of
/// the adjugate or the elimination).
fn solve_diagonal(program: &mut Program, entries: &[ValueId], b: ValueId) -> Option<ValueId> {
    let n = size(program.shape(b));
    let is_zero = |id: ValueId| literal(program, id).is_some_and(|data| data == [0.0]);
    let off_diagonal = (0..entries.len()).filter(|at| at / n != at % n);
    if n < 2 || !off_diagonal.map(|at| entries[at]).all(is_zero) {
        return None;
    }
    let diagonal: Vec<ValueId> = entries.iter().step_by(n + 1).copied().collect();
    let numbers = diagonal
        .iter()
        .map(|&id| literal(program, id).map(|data| 1.0 / data[0]));
    if let Some(reciprocals) = numbers.collect::<Option<Vec<f64>>>() {
        let reciprocals = program.constant(Shape::Vector(n), reciprocals);
        return Some(program.binary(Operator::Mul, b, reciprocals));
    }
    let diagonal = program.array(Shape::Vector(n), diagonal);
    Some(program.binary(Operator::Div, b, diagonal))
}

/// A^-1 b for a diagonal matrix, and for two or three rows of which at least two entries are zeros: adjugate over determinant, written out, so that the zeros in
/// them can go (finite entries, up to the sign of zero).
pub(super) fn solve(program: &mut Program, a: ValueId, b: ValueId) -> Option<ValueId> {
    let entries = entries(program, a)?;
    if let Some(solution) = solve_diagonal(program, &entries, b) {
        return Some(solution);
    }
    let is_zero = |id: ValueId| literal(program, id).is_some_and(|data| data == [0.0]);
    let zeros = entries.iter().filter(|&&entry| is_zero(entry)).count();
    let n = size(program.shape(b));
    if zeros < 2 || !(2..=3).contains(&n) {
        return None;
    }
    let mut minors = Minors {
        program,
        entries,
        n,
    };
    let adjugate: Vec<ValueId> = match n {
        2 => minors.adjugate_of_two(),
        _ => (0..9).map(|at| minors.cofactor(at % 3, at / 3)).collect(),
    };
    let first_row = minors.entries[..n].to_vec();
    let first_column: Vec<ValueId> = (0..n).map(|i| adjugate[i * n]).collect();
    let determinant = match n {
        2 => minors.difference(0, 3, 1, 2),
        _ => dot(program, &first_row, &first_column),
    };
    let right: Vec<ValueId> = (0..n).map(|i| program.push(Op::Element(b, i, 0))).collect();
    let one = program.scalar(1.0);
    let scale = program.binary(Operator::Div, one, determinant);
    let mut items = Vec::with_capacity(n);
    for row in adjugate.chunks(n) {
        let numerator = dot(program, row, &right);
        items.push(program.binary(Operator::Mul, numerator, scale));
    }
    Some(program.array(Shape::Vector(n), items))
}

/// A matrix by its entries, of which some are literals.
struct Minors<'p> {
    program: &'p mut Program,
    entries: Vec<ValueId>,
    n: usize,
}

impl Minors<'_> {
    /// a_i a_j - a_k a_l, by position.
    fn difference(&mut self, i: usize, j: usize, k: usize, l: usize) -> ValueId {
        let at = |position: usize| self.entries[position];
        let (i, j, k, l) = (at(i), at(j), at(k), at(l));
        let first = without_zero(self.program, Operator::Mul, i, j);
        let second = without_zero(self.program, Operator::Mul, k, l);
        without_zero(self.program, Operator::Sub, first, second)
    }

    /// Entry (column, row) of the adjugate of a 3x3 matrix, in the order of operations of `Solve`: cofactors of cyclic neighbours.
    fn cofactor(&mut self, row: usize, column: usize) -> ValueId {
        let n = self.n;
        let (r1, r2) = ((row + 1) % n, (row + 2) % n);
        let (c1, c2) = ((column + 1) % n, (column + 2) % n);
        self.difference(r1 * n + c1, r2 * n + c2, r1 * n + c2, r2 * n + c1)
    }

    /// [[d, -b], [-c, a]] of [[a, b], [c, d]].
    fn adjugate_of_two(&mut self) -> Vec<ValueId> {
        let entries = self.entries.clone();
        let mut negated = |id: ValueId| self.program.push(Op::Apply(crate::ir::Function::Neg, id));
        vec![
            entries[3],
            negated(entries[1]),
            negated(entries[2]),
            entries[0],
        ]
    }
}

/// Sum of products, left to right.
fn dot(program: &mut Program, a: &[ValueId], b: &[ValueId]) -> ValueId {
    let mut total = None;
    for (&a, &b) in a.iter().zip(b) {
        let term = without_zero(program, Operator::Mul, a, b);
        total = Some(match total {
            None => term,
            Some(total) => without_zero(program, Operator::Add, total, term),
        });
    }
    total.expect("invariant: at least one row")
}

/// An operation on scalars, left out where a zero decides it.
fn without_zero(program: &mut Program, operator: Operator, a: ValueId, b: ValueId) -> ValueId {
    let zero = |id: ValueId| literal(program, id).is_some_and(|data| data == [0.0]);
    match (operator, zero(a), zero(b)) {
        (Operator::Mul, true, _) | (Operator::Add | Operator::Sub, _, true) => a,
        (Operator::Mul, _, true) | (Operator::Add, true, _) => b,
        (Operator::Sub, true, _) => program.push(Op::Apply(crate::ir::Function::Neg, b)),
        _ => program.binary(operator, a, b),
    }
}

/// The entries of an array of scalars or of a literal.
fn entries(program: &mut Program, a: ValueId) -> Option<Vec<ValueId>> {
    match program.instruction(a).op.clone() {
        Op::Array(items) => Some(items),
        Op::Const(data) => Some(
            data.into_iter()
                .map(|entry| program.scalar(entry))
                .collect(),
        ),
        _ => None,
    }
}

fn columns(program: &Program, array: ValueId) -> usize {
    match program.shape(array) {
        Shape::Matrix(_, columns) => columns,
        Shape::Scalar | Shape::Vector(_) => 1,
    }
}
