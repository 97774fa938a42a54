//! Equations in a matrix that is symmetric by its form, such as a mass matrix, are solved by its lower triangle. Part of lowering; as exact as
//! elimination of the whole matrix.

use std::cell::Cell;
use std::collections::BTreeMap;

use crate::ir::{Function, Op, Operator, Program, Shape, Type, ValueId};

use super::rewrite::rewrite;

/// Rows from which on it is less work: up to three rows the adjugate is.
const FEWEST: usize = 4;

/// Most operations of a matrix that are looked at.
const LONGEST: usize = 4096;

/// Solves symmetric equations as such.
pub(super) fn run(program: Program) -> Program {
    let mut known = BTreeMap::new();
    rewrite(program, |program, instruction| {
        let Op::Solve(a, b) = instruction.op else {
            return None;
        };
        let Type::Real(Shape::Matrix(rows, _)) = program.ty(a) else {
            return None;
        };
        let factors = *known.entry(a).or_insert_with(|| {
            let form = Form {
                program,
                left: Cell::new(LONGEST),
            };
            let symmetric = rows >= FEWEST && form.is_symmetric(a);
            symmetric.then(|| program.push(Op::Ldlt(a)))
        });
        Some(program.push(Op::Solve(factors?, b)))
    })
}

/// The matrix of equations, which may be given by its factors.
pub(super) fn matrix(program: &Program, a: ValueId) -> ValueId {
    match program.instruction(a).op {
        Op::Ldlt(matrix) => matrix,
        _ => a,
    }
}

/// How values are computed, seen up to the order of terms and factors, and so to roundings.
struct Form<'a> {
    program: &'a Program,
    /// How many more operations are looked at; what lies beyond counts as different.
    left: Cell<usize>,
}

impl Form<'_> {
    fn op(&self, value: ValueId) -> Option<&Op> {
        self.left.set(self.left.get().checked_sub(1)?);
        Some(&self.program.instruction(value).op)
    }

    fn is_scalar(&self, value: ValueId) -> bool {
        self.program.shape(value) == Shape::Scalar
    }

    /// Whether a matrix equals its transpose: its entries do, or it is a sum of such matrices, a multiple of one, or `B^T S B`.
    fn is_symmetric(&self, matrix: ValueId) -> bool {
        let Some(op) = self.op(matrix) else {
            return false;
        };
        match (op, self.program.shape(matrix)) {
            (Op::Array(items), Shape::Matrix(rows, columns)) if rows == columns => {
                pairs(rows).all(|(at, other)| self.same(items[at], items[other]))
            }
            (Op::Const(data), Shape::Matrix(rows, columns)) if rows == columns => {
                pairs(rows).all(|(at, other)| data[at] == data[other])
            }
            (Op::Transpose(x) | Op::Apply(Function::Neg, x), _) => self.is_symmetric(*x),
            (Op::Binary(Operator::Add | Operator::Sub | Operator::Mul, x, y), _) => [x, y]
                .iter()
                .all(|&&x| self.is_scalar(x) || self.is_symmetric(x)),
            (Op::Binary(Operator::Div, x, y), _) => self.is_scalar(*y) && self.is_symmetric(*x),
            (Op::Outer(x, y), _) => self.same(*x, *y),
            (Op::MatMul(..), _) => self.is_congruence(matrix),
            _ => false,
        }
    }

    /// A product of matrices, of which the first is the transpose of the last, the second that of the last but one, and so on; in the middle
    /// stands a symmetric matrix or none. Scalar factors do not count.
    fn is_congruence(&self, product: ValueId) -> bool {
        let mut factors = Vec::new();
        self.matrix_factors(product, &mut factors);
        let count = factors.len();
        let mut pairs = (0..count / 2).map(|at| (factors[at], factors[count - 1 - at]));
        count > 1
            && pairs.all(|(x, y)| self.are_transposes(x, y) || x == y && self.is_symmetric(x))
            && (count % 2 == 0 || self.is_symmetric(factors[count / 2]))
    }

    fn matrix_factors(&self, value: ValueId, factors: &mut Vec<ValueId>) {
        match self.op(value) {
            Some(&Op::MatMul(x, y)) => {
                self.matrix_factors(x, factors);
                self.matrix_factors(y, factors);
            }
            Some(&Op::Apply(Function::Neg, x)) => self.matrix_factors(x, factors),
            Some(&Op::Binary(Operator::Mul, x, y)) if self.is_scalar(x) => {
                self.matrix_factors(y, factors);
            }
            Some(&Op::Binary(Operator::Mul | Operator::Div, x, y)) if self.is_scalar(y) => {
                self.matrix_factors(x, factors);
            }
            _ => factors.push(value),
        }
    }

    fn are_transposes(&self, x: ValueId, y: ValueId) -> bool {
        let of = |x: ValueId, y: ValueId| matches!(self.op(x), Some(&Op::Transpose(x)) if x == y);
        of(x, y) || of(y, x)
    }

    /// Whether two values are equal.
    fn same(&self, x: ValueId, y: ValueId) -> bool {
        if x == y {
            return true;
        }
        // Arrays of the same entries can differ in shape.
        if self.program.ty(x) != self.program.ty(y) {
            return false;
        }
        let (Some(left), Some(right)) = (self.op(x), self.op(y)) else {
            return false;
        };
        match (left, right) {
            (Op::Const(a), Op::Const(b)) => a == b,
            (Op::Element(a, row, column), Op::Element(b, other, place)) => {
                (row, column) == (other, place) && self.same(*a, *b)
            }
            (Op::Apply(f, a), Op::Apply(g, b)) => {
                let even = matches!(f, Function::Cos | Function::Cosh | Function::Abs);
                f == g && (self.same(*a, *b) || even && self.opposite(*a, *b))
            }
            (Op::PowInt(a, n), Op::PowInt(b, m)) => {
                n == m && (self.same(*a, *b) || n % 2 == 0 && self.opposite(*a, *b))
            }
            (&Op::Binary(f, ..), &Op::Binary(g, ..))
                if f == g && matches!(f, Operator::Add | Operator::Mul) =>
            {
                let (mut left, mut right) = (Vec::new(), Vec::new());
                self.terms(f, x, &mut left);
                self.terms(f, y, &mut right);
                self.are_same(&left, right)
            }
            (Op::Binary(f, a, b), Op::Binary(g, c, d)) if f == g => {
                let crossed = matches!(f, Operator::Min | Operator::Max);
                self.same(*a, *c) && self.same(*b, *d)
                    || crossed && self.same(*a, *d) && self.same(*b, *c)
            }
            _ => false,
        }
    }

    /// The terms of a sum or the factors of a product.
    fn terms(&self, of: Operator, value: ValueId, terms: &mut Vec<ValueId>) {
        match self.op(value) {
            Some(&Op::Binary(operator, x, y)) if operator == of => {
                self.terms(of, x, terms);
                self.terms(of, y, terms);
            }
            _ => terms.push(value),
        }
    }

    /// Whether values are the same but for their order.
    fn are_same(&self, left: &[ValueId], mut right: Vec<ValueId>) -> bool {
        left.len() == right.len()
            && left.iter().all(|&x| {
                let found = right.iter().position(|&y| self.same(x, y));
                found.map(|at| right.swap_remove(at)).is_some()
            })
    }

    /// Whether one value is the other with its sign turned.
    fn opposite(&self, x: ValueId, y: ValueId) -> bool {
        match (self.op(x), self.op(y)) {
            (Some(&Op::Binary(Operator::Sub, a, b)), Some(&Op::Binary(Operator::Sub, c, d))) => {
                self.same(a, d) && self.same(b, c)
            }
            (Some(&Op::Apply(Function::Neg, a)), _) => self.same(a, y),
            (_, Some(&Op::Apply(Function::Neg, b))) => self.same(x, b),
            _ => false,
        }
    }
}

/// Positions below the diagonal, row-major, each with the one that mirrors it.
fn pairs(rows: usize) -> impl Iterator<Item = (usize, usize)> {
    let places = (0..rows).flat_map(|row| (0..row).map(move |column| (row, column)));
    places.map(move |(row, column)| (row * rows + column, column * rows + row))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{eval, random};

    #[test]
    fn what_is_called_symmetric_is() {
        let (mut found, mut compared) = (0, 0);
        for seed in 0..400 {
            let mut program = random::program(seed, 200);
            let count = u32::try_from(program.instructions.len()).unwrap();
            let square = |id: &ValueId| matches!(program.ty(*id), Type::Real(Shape::Matrix(rows, columns)) if rows == columns);
            let matrices: Vec<ValueId> = (0..count).map(ValueId).filter(square).collect();
            let form = |id: &ValueId| {
                let form = Form {
                    program: &program,
                    left: Cell::new(LONGEST),
                };
                form.is_symmetric(*id)
            };
            let symmetric: Vec<ValueId> = matrices.into_iter().filter(form).collect();
            found += symmetric.len();
            let outputs = symmetric.iter().map(|id| (format!("m{}", id.0), *id));
            program.outputs = outputs.collect();
            for draw in 0..3 {
                let values = eval::eval(&program, &random::inputs(&program, draw)).unwrap();
                for data in values.values() {
                    let rows = data.len().isqrt();
                    let size = data.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
                    if !size.is_finite() || data.iter().any(|x| x.is_nan()) {
                        continue;
                    }
                    compared += 1;
                    for (at, other) in pairs(rows) {
                        let difference = (data[at] - data[other]).abs();
                        assert!(
                            difference <= 1e-11 * size,
                            "seed {seed}: {data:?}\n{program}"
                        );
                    }
                }
            }
        }
        assert!(found > 400 && compared > 600, "{found}, {compared}");
    }
}
