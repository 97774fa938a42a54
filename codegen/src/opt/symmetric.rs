//! Equations in a matrix that is symmetric by its form, such as a mass matrix, are solved by its lower triangle. Part of lowering; as exact as
//! elimination of the whole matrix.

use std::cell::Cell;

use crate::ir::{Function, Op, Operator, Program, Shape, ValueId};

use super::rewrite::rewrite;

/// Rows from which on it is less work: up to three rows the adjugate is.
const FEWEST: usize = 4;

/// Most operations of a matrix that are looked at.
const LONGEST: usize = 4096;

/// Solves symmetric equations as such.
pub(super) fn run(program: Program) -> Program {
    rewrite(program, |program, instruction| {
        let Op::Solve(a, b) = instruction.op else {
            return None;
        };
        let Shape::Matrix(rows, _) = program.shape(a) else {
            return None;
        };
        let form = Form {
            program,
            left: Cell::new(LONGEST),
        };
        (rows >= FEWEST && form.is_symmetric(a)).then(|| {
            let factors = program.push(Op::Ldlt(a));
            program.push(Op::Solve(factors, b))
        })
    })
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
            (Op::MatMul(x, y), _) => self.is_congruence(*x, *y),
            _ => false,
        }
    }

    /// `B^T B`, `B^T (S B)` or `(B^T S) B`.
    fn is_congruence(&self, x: ValueId, y: ValueId) -> bool {
        let around =
            |x: ValueId, s: ValueId, y: ValueId| self.are_transposes(x, y) && self.is_symmetric(s);
        self.are_transposes(x, y)
            || matches!(self.op(y), Some(&Op::MatMul(s, y)) if around(x, s, y))
            || matches!(self.op(x), Some(&Op::MatMul(x, s)) if around(x, s, y))
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
            (Op::Binary(f, a, b), Op::Binary(g, c, d)) if f == g => {
                let crossed = matches!(f, Operator::Add | Operator::Mul);
                self.same(*a, *c) && self.same(*b, *d)
                    || crossed && self.same(*a, *d) && self.same(*b, *c)
            }
            _ => false,
        }
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
