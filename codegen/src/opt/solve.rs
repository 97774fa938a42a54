//! Solutions of linear equations by what is known of the matrix: its zeros, and that it stays the same for a run.
//!
//! | matrix | solution |
//! |---|---|
//! | diagonal | a quotient for each entry |
//! | zeros that leave several blocks on the diagonal | block by block, by substitution |
//! | three rows, two zeros or more | adjugate over determinant, without the zeros |
//! | two or three rows, the inverse itself | the same |
//! | of parameters or literals, other than the right side | product with the inverse, which is computed once for a run |

use crate::ir::build::size;
use crate::ir::{Op, Operator, Program, Shape, ValueId};

use super::blocks::{Block, blocks};
use super::dependence::{Dependence, Dependences};
use super::inverse::{Adjugate, adjugate, dot, inverse};
use super::rewrite::{is_all, literal};
use super::sparse::{Entries, without_zero};
use super::symmetric::matrix;

/// A^-1 b for a vector or matrix b, other than by `Solve` with the whole matrix or its factors.
pub(super) fn solve(
    program: &mut Program,
    dependences: &mut Dependences,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    let a = matrix(program, a);
    let entries = Entries::of(program, a);
    let fixed = dependences.of(program, a) <= Dependence::Parameters;
    let right = Right::of(program, b);
    if entries.are_known() {
        if let Some(solution) = diagonal(program, &entries, &right, fixed) {
            return Some(solution);
        }
        let found = blocks(right.rows, |row, column| {
            !entries.is_zero(row * right.rows + column)
        })?;
        if found.len() > 1 {
            return Some(substitute(program, &entries, &found, &right));
        }
    }
    let n = right.rows;
    if fixed && dependences.of(program, b) > Dependence::Parameters {
        // A^-1 b == (A^-1) b: off by a multiple of n^2 2^-53 ||A|| ||A^-1|| ||A^-1|| ||b||, where elimination has ||x|| in the place of the last two
        let inverse = inverse(program, &entries, a, n)?;
        return Some(program.push(Op::MatMul(inverse, b)));
    }
    let zeros = (0..n * n).filter(|&at| entries.is_zero(at)).count();
    let sparse = n == 3 && zeros > 1 || matches!(n, 2 | 3) && right.is_identity();
    sparse.then(|| by_adjugate(program, &entries, &right))
}

/// What equations are solved for: one right side, or several side by side.
struct Right {
    value: ValueId,
    rows: usize,
    /// How many.
    sides: usize,
    entries: Entries,
}

impl Right {
    fn of(program: &Program, value: ValueId) -> Right {
        let (rows, sides) = match program.shape(value) {
            Shape::Matrix(rows, columns) => (rows, columns),
            vector => (size(vector), 1),
        };
        let entries = Entries::of(program, value);
        Right {
            value,
            rows,
            sides,
            entries,
        }
    }

    fn entry(&self, program: &mut Program, row: usize, side: usize) -> ValueId {
        self.entries.value(program, row * self.sides + side)
    }

    fn is_identity(&self) -> bool {
        self.rows == self.sides && self.entries.are_identity(self.rows)
    }

    /// The shape of so many rows of right sides.
    fn shape(&self, program: &Program, rows: usize) -> Shape {
        match program.shape(self.value) {
            Shape::Matrix(_, sides) => Shape::Matrix(rows, sides),
            _ => Shape::Vector(rows),
        }
    }
}

/// A^-1 b for a diagonal matrix: b_i (1 / a_ii), by the reciprocal itself if that is known (one or two roundings instead of the four of
/// the adjugate or the elimination). A single entry that changes during a run stays with `Solve`, which divides by it.
fn diagonal(
    program: &mut Program,
    entries: &Entries,
    right: &Right,
    fixed: bool,
) -> Option<ValueId> {
    let (b, n) = (right.value, right.rows);
    let mut off_diagonal = (0..n * n).filter(|at| at / n != at % n);
    if !off_diagonal.all(|at| entries.is_zero(at)) {
        return None;
    }
    let mut items = Vec::with_capacity(n * right.sides);
    for at in 0..n * right.sides {
        items.push(entries.value(program, at / right.sides * (n + 1)));
    }
    if let [item] = items[..] {
        return fixed.then(|| program.binary(Operator::Div, b, item));
    }
    let shape = program.shape(b);
    let numbers = items
        .iter()
        .map(|&id| literal(program, id).map(|data| 1.0 / data[0]));
    if let Some(reciprocals) = numbers.collect::<Option<Vec<f64>>>() {
        // A singular matrix stays as it is.
        if reciprocals.iter().any(|reciprocal| !reciprocal.is_finite()) {
            return None;
        }
        let reciprocals = program.constant(shape, reciprocals);
        return Some(program.binary(Operator::Mul, b, reciprocals));
    }
    let items = program.array(shape, items);
    Some(program.binary(Operator::Div, b, items))
}

/// A^-1 b block by block: A_kk x_k = b_k - sum over blocks j before k of A_kj x_j. Each block is solved as it would be alone, and the sums
/// leave out nothing but zeros, so the error is that of the same elimination with the blocks' pivots.
fn substitute(
    program: &mut Program,
    entries: &Entries,
    blocks: &[Block],
    right: &Right,
) -> ValueId {
    let (n, sides) = (right.rows, right.sides);
    let mut x: Vec<Option<ValueId>> = vec![None; n * sides];
    for Block { rows, columns } in blocks {
        let mut rest = Vec::with_capacity(rows.len() * sides);
        for (&row, side) in rows
            .iter()
            .flat_map(|row| (0..sides).map(move |side| (row, side)))
        {
            let mut entry = right.entry(program, row, side);
            for column in 0..n {
                if let (Some(known), false) =
                    (x[column * sides + side], entries.is_zero(row * n + column))
                {
                    let coupling = entries.value(program, row * n + column);
                    let moved = without_zero(program, Operator::Mul, coupling, known);
                    entry = without_zero(program, Operator::Sub, entry, moved);
                }
            }
            rest.push(entry);
        }
        let mut inner = Vec::with_capacity(rows.len() * rows.len());
        for at in rows
            .iter()
            .flat_map(|row| columns.iter().map(move |column| row * n + column))
        {
            inner.push(entries.value(program, at));
        }
        let solution = match inner[..] {
            [inner] => rest
                .into_iter()
                .map(|rest| without_zero(program, Operator::Div, rest, inner))
                .collect(),
            _ => solve_block(program, inner, rest, right, columns.len()),
        };
        for (at, entry) in solution.into_iter().enumerate() {
            x[columns[at / sides] * sides + at % sides] = Some(entry);
        }
    }
    let items = x
        .into_iter()
        .map(|entry| entry.expect("invariant: each column is in a block"));
    let items = items.collect();
    program.array(program.shape(right.value), items)
}

/// The entries of the solution of a block of so many rows.
fn solve_block(
    program: &mut Program,
    inner: Vec<ValueId>,
    rest: Vec<ValueId>,
    right: &Right,
    rows: usize,
) -> Vec<ValueId> {
    // A right side of zeros has the solution 0.
    let sides: Vec<usize> = (0..right.sides)
        .filter(|side| {
            let mut column = rest.iter().skip(*side).step_by(right.sides);
            !column.all(|&entry| is_all(program, entry, 0.0))
        })
        .collect();
    let inner = program.array(Shape::Matrix(rows, rows), inner);
    let shape = match right.shape(program, rows) {
        Shape::Matrix(rows, _) if sides.len() > 1 => Shape::Matrix(rows, sides.len()),
        _ => Shape::Vector(rows),
    };
    let mut x = vec![program.scalar(0.0); rest.len()];
    if sides.is_empty() {
        return x;
    }
    let kept = (0..rows).flat_map(|row| sides.iter().map(move |side| row * right.sides + side));
    let kept: Vec<usize> = kept.collect();
    let rest = program.array(shape, kept.iter().map(|&at| rest[at]).collect());
    let solution = program.push(Op::Solve(inner, rest));
    for (at, place) in kept.into_iter().enumerate() {
        x[place] = program.push(Op::Element(solution, at / sides.len(), at % sides.len()));
    }
    x
}

/// Adjugate over determinant, written out, so that the zeros in them can go (finite entries, up to the sign of zero).
fn by_adjugate(program: &mut Program, entries: &Entries, right: &Right) -> ValueId {
    let n = right.rows;
    let Adjugate { rows, scale } = adjugate(program, entries, n);
    let mut items = Vec::with_capacity(n * right.sides);
    for row in rows.chunks(n) {
        for side in 0..right.sides {
            let column: Vec<ValueId> = (0..n).map(|i| right.entry(program, i, side)).collect();
            let numerator = dot(program, row, &column);
            items.push(without_zero(program, Operator::Mul, numerator, scale));
        }
    }
    program.array(program.shape(right.value), items)
}
