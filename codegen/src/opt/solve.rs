//! Solutions of linear equations by what is known of the matrix: its zeros, and that it stays the same for a run.
//!
//! | matrix | solution |
//! |---|---|
//! | diagonal | a quotient for each entry |
//! | zeros that leave several blocks on the diagonal | block by block, by substitution |
//! | three rows, two zeros or more | adjugate over determinant, without the zeros |
//! | written as adjugate over determinant, two rows | product with the matrix that it is the inverse of |
//! | of parameters or literals, other than the right side | product with the inverse, which is computed once for a run |

use crate::ir::build::size;
use crate::ir::{Op, Operator, Program, Shape, ValueId};

use super::blocks::{Block, blocks};
use super::dependence::{Dependence, Dependences};
use super::inverse::{Adjugate, adjugate, dot, inverse, of_inverse};
use super::rewrite::literal;
use super::sparse::Entries;

/// A^-1 b, other than by `Solve` with the whole matrix.
pub(super) fn solve(
    program: &mut Program,
    dependences: &mut Dependences,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    let entries = Entries::of(program, a);
    let fixed = dependences.of(program, a) <= Dependence::Parameters;
    if entries.are_known() {
        if let Some(solution) = diagonal(program, &entries, b, fixed) {
            return Some(solution);
        }
        let n = size(program.shape(b));
        let found = blocks(n, |row, column| !entries.is_zero(row * n + column))?;
        if found.len() > 1 {
            return Some(substitute(program, &entries, &found, b));
        }
    }
    if let Some(solution) = of_inverse(program, a, b) {
        return Some(solution);
    }
    if fixed && dependences.of(program, b) > Dependence::Parameters {
        // A^-1 b == (A^-1) b: off by a multiple of n^2 2^-53 ||A|| ||A^-1|| ||A^-1|| ||b||, where elimination has ||x|| in the place of the last two
        let inverse = inverse(program, &entries, a, b)?;
        return Some(program.push(Op::MatMul(inverse, b)));
    }
    let n = size(program.shape(b));
    let zeros = (0..n * n).filter(|&at| entries.is_zero(at)).count();
    (n == 3 && zeros > 1).then(|| by_adjugate(program, &entries, b))
}

/// A^-1 b for a diagonal matrix: b_i (1 / a_ii), by the reciprocal itself if that is known (one or two roundings instead of the four of
/// the adjugate or the elimination). A single entry that changes during a run stays with `Solve`, which divides by it.
fn diagonal(program: &mut Program, entries: &Entries, b: ValueId, fixed: bool) -> Option<ValueId> {
    let n = size(program.shape(b));
    let mut off_diagonal = (0..n * n).filter(|at| at / n != at % n);
    if !off_diagonal.all(|at| entries.is_zero(at)) {
        return None;
    }
    let items: Vec<ValueId> = (0..n)
        .map(|i| entries.value(program, i * (n + 1)))
        .collect();
    if let [item] = items[..] {
        return fixed.then(|| program.binary(Operator::Div, b, item));
    }
    let numbers = items
        .iter()
        .map(|&id| literal(program, id).map(|data| 1.0 / data[0]));
    if let Some(reciprocals) = numbers.collect::<Option<Vec<f64>>>() {
        // A singular matrix stays as it is.
        if reciprocals.iter().any(|reciprocal| !reciprocal.is_finite()) {
            return None;
        }
        let reciprocals = program.constant(Shape::Vector(n), reciprocals);
        return Some(program.binary(Operator::Mul, b, reciprocals));
    }
    let items = program.array(Shape::Vector(n), items);
    Some(program.binary(Operator::Div, b, items))
}

/// A^-1 b block by block: A_kk x_k = b_k - sum over blocks j before k of A_kj x_j. Each block is solved as it would be alone, and the sums
/// leave out nothing but zeros, so the error is that of the same elimination with the blocks' pivots.
fn substitute(program: &mut Program, entries: &Entries, blocks: &[Block], b: ValueId) -> ValueId {
    let n = size(program.shape(b));
    let mut x: Vec<Option<ValueId>> = vec![None; n];
    for Block { rows, columns } in blocks {
        let mut right = Vec::with_capacity(rows.len());
        for &row in rows {
            let mut rest = program.push(Op::Element(b, row, 0));
            for (column, known) in x.iter().enumerate() {
                if let (Some(known), false) = (*known, entries.is_zero(row * n + column)) {
                    let coupling = entries.value(program, row * n + column);
                    let moved = program.binary(Operator::Mul, coupling, known);
                    rest = program.binary(Operator::Sub, rest, moved);
                }
            }
            right.push(rest);
        }
        let mut inner = Vec::with_capacity(rows.len() * rows.len());
        for at in rows
            .iter()
            .flat_map(|row| columns.iter().map(move |column| row * n + column))
        {
            inner.push(entries.value(program, at));
        }
        if let ([right], [inner]) = (&right[..], &inner[..]) {
            x[columns[0]] = Some(program.binary(Operator::Div, *right, *inner));
            continue;
        }
        let inner = program.array(Shape::Matrix(rows.len(), rows.len()), inner);
        let right = program.array(Shape::Vector(rows.len()), right);
        let solution = program.push(Op::Solve(inner, right));
        for (at, &column) in columns.iter().enumerate() {
            x[column] = Some(program.push(Op::Element(solution, at, 0)));
        }
    }
    let items = x
        .into_iter()
        .map(|entry| entry.expect("invariant: each column is in a block"));
    let items = items.collect();
    program.array(Shape::Vector(n), items)
}

/// Adjugate over determinant, written out, so that the zeros in them can go (finite entries, up to the sign of zero).
fn by_adjugate(program: &mut Program, entries: &Entries, b: ValueId) -> ValueId {
    let n = size(program.shape(b));
    let Adjugate { rows, scale } = adjugate(program, entries, n);
    let right: Vec<ValueId> = (0..n).map(|i| program.push(Op::Element(b, i, 0))).collect();
    let mut items = Vec::with_capacity(n);
    for row in rows.chunks(n) {
        let numerator = dot(program, row, &right);
        items.push(program.binary(Operator::Mul, numerator, scale));
    }
    program.array(Shape::Vector(n), items)
}
