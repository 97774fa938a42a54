//! Inverses that are computed once for a run, and the adjugates of small matrices.

use crate::ir::eval::Tables;
use crate::ir::{Function, Op, Operator, Program, Shape, ValueId};

use super::rewrite::literal;
use super::sparse::{Entries, without_zero};

/// Most rows of an inverse that is written out: its columns take n eliminations of n^3/3 products in `prepare`.
const LARGEST_INVERSE: usize = 16;

/// Largest ||A|| ||A^-1||, by rows, of a literal that is inverted.
const WELL_CONDITIONED: f64 = 4096.0;

/// The inverse of a matrix that does not change during a run: adjugate over determinant of two and three rows, else column by column. That
/// of a literal only if it is well conditioned, otherwise none.
pub(super) fn inverse(
    program: &mut Program,
    entries: &Entries,
    a: ValueId,
    n: usize,
) -> Option<ValueId> {
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

/// The adjugate of two or three rows, row-major, and the reciprocal of the determinant.
pub(super) struct Adjugate {
    pub(super) rows: Vec<ValueId>,
    pub(super) scale: ValueId,
}

/// In the order of operations of `Solve`: cofactors of cyclic neighbours, and the determinant by the first row.
pub(super) fn adjugate(program: &mut Program, entries: &Entries, n: usize) -> Adjugate {
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
pub(super) fn dot(program: &mut Program, a: &[ValueId], b: &[ValueId]) -> ValueId {
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
