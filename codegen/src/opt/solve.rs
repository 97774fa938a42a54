//! Solutions of linear equations by what is known of the matrix: its zeros, and that it stays the same for a run.
//!
//! | matrix | solution |
//! |---|---|
//! | diagonal | a quotient for each entry |
//! | zeros that leave several blocks on the diagonal | block by block, by substitution |
//! | three rows, two zeros or more | adjugate over determinant, without the zeros |
//! | of parameters or literals, other than the right side | product with the inverse, which is computed once for a run |

use crate::ir::build::size;
use crate::ir::eval::Tables;
use crate::ir::{Function, Op, Operator, Program, Shape, ValueId};

use super::blocks::{Block, blocks};
use super::dependence::{Dependence, Dependences};
use super::rewrite::literal;
use super::sparse::{Entries, without_zero};

/// Most rows of an inverse that is written out: its columns take n eliminations of n^3/3 products in `prepare`.
const LARGEST_INVERSE: usize = 8;

/// Largest ||A|| ||A^-1||, by rows, of a literal that is inverted.
const WELL_CONDITIONED: f64 = 4096.0;

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

/// The inverse of a matrix that does not change during a run: adjugate over determinant of two and three rows, else column by column. That
/// of a literal only if it is well conditioned, otherwise none.
fn inverse(program: &mut Program, entries: &Entries, a: ValueId, b: ValueId) -> Option<ValueId> {
    let n = size(program.shape(b));
    if literal(program, a).is_some() {
        return literal_inverse(program, a, n);
    }
    if n > LARGEST_INVERSE {
        return None;
    }
    let mut items = vec![None; n * n];
    if n == 2 || n == 3 {
        let Adjugate { rows, scale } = adjugate(program, entries, n);
        for (item, minor) in items.iter_mut().zip(rows) {
            *item = Some(program.binary(Operator::Mul, minor, scale));
        }
    } else {
        for column in 0..n {
            let unit = (0..n).map(|row| f64::from(row == column)).collect();
            let unit = program.constant(Shape::Vector(n), unit);
            let solution = program.push(Op::Solve(a, unit));
            for row in 0..n {
                items[row * n + column] = Some(program.push(Op::Element(solution, row, 0)));
            }
        }
    }
    let items = items.into_iter().collect::<Option<Vec<ValueId>>>()?;
    Some(program.array(Shape::Matrix(n, n), items))
}

/// The inverse of a literal, if the product of its norm with that of the inverse is small, so that the inverse costs at most twelve bits of
/// the solution.
fn literal_inverse(program: &mut Program, a: ValueId, n: usize) -> Option<ValueId> {
    let tables = Tables::of(program);
    let mut inverse = vec![0.0; n * n];
    for column in 0..n {
        let unit = (0..n).map(|row| f64::from(row == column)).collect();
        let unit = program.constant(Shape::Vector(n), unit);
        let value = |id| literal(program, id).expect("invariant: both are literals");
        let mut solution = vec![0.0; n];
        tables.apply(program, &Op::Solve(a, unit), value, &mut solution);
        for (row, entry) in solution.into_iter().enumerate() {
            inverse[row * n + column] = entry;
        }
    }
    let norm = |data: &[f64]| {
        let rows = data
            .chunks(n)
            .map(|row| row.iter().map(|x| x.abs()).sum::<f64>());
        rows.fold(0.0, f64::max)
    };
    let condition = norm(literal(program, a)?) * norm(&inverse);
    (inverse.iter().all(|x| x.is_finite()) && condition <= WELL_CONDITIONED)
        .then(|| program.constant(Shape::Matrix(n, n), inverse))
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

/// The adjugate of two or three rows, row-major, and the reciprocal of the determinant.
struct Adjugate {
    rows: Vec<ValueId>,
    scale: ValueId,
}

/// In the order of operations of `Solve`: cofactors of cyclic neighbours, and the determinant by the first row.
fn adjugate(program: &mut Program, entries: &Entries, n: usize) -> Adjugate {
    let items: Vec<ValueId> = (0..n * n).map(|at| entries.value(program, at)).collect();
    let mut difference = |i: usize, j: usize, k: usize, l: usize| {
        // a_i a_j - a_k a_l
        let first = without_zero(program, Operator::Mul, items[i], items[j]);
        let second = without_zero(program, Operator::Mul, items[k], items[l]);
        without_zero(program, Operator::Sub, first, second)
    };
    let (rows, determinant) = if n == 2 {
        let determinant = difference(0, 3, 1, 2);
        let [b, c] = [1, 2].map(|at| program.push(Op::Apply(Function::Neg, items[at])));
        (vec![items[3], b, c, items[0]], determinant)
    } else {
        let next = |i: usize, by: usize| (i + by) % 3;
        let cofactor = |at: usize| {
            let (row, column) = (at % 3, at / 3);
            let [r1, r2] = [next(row, 1) * 3, next(row, 2) * 3];
            let [c1, c2] = [next(column, 1), next(column, 2)];
            difference(r1 + c1, r2 + c2, r1 + c2, r2 + c1)
        };
        let rows: Vec<ValueId> = (0..9).map(cofactor).collect();
        let first_column = [rows[0], rows[3], rows[6]];
        let determinant = dot(program, &items[..3], &first_column);
        (rows, determinant)
    };
    let one = program.scalar(1.0);
    let scale = program.binary(Operator::Div, one, determinant);
    Adjugate { rows, scale }
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
