//! Arrays whose structure has zeros, such as a gain matrix with absent couplings: operations on them are written out entry by entry without
//! the zeros. Only where at least half of the work goes: an operation on whole arrays is packed where it is emitted, one on entries is not.
//! `x * 0 == 0` and `x + 0 == x` for finite x, up to the sign of a zero; nothing else changes while a sum has at most seven terms, since
//! the order of terms is that of the whole operation.

use crate::ir::build::size;
use crate::ir::{Function, Op, Operator, Program, Shape, Type, ValueId};

use super::rewrite::literal;

/// Most products of entries that a matrix product is written out in.
const LARGEST: usize = 256;

/// An array by what is known of its entries.
pub(super) struct Entries {
    array: ValueId,
    columns: usize,
    /// Its entries, if it is an array of scalars or a literal.
    known: Option<Vec<Entry>>,
}

#[derive(Clone, Copy, PartialEq)]
enum Entry {
    Number(f64),
    Value(ValueId),
}

impl Entries {
    pub(super) fn of(program: &Program, array: ValueId) -> Entries {
        let entry = |&item: &ValueId| match literal(program, item) {
            Some(data) => Entry::Number(data[0]),
            None => Entry::Value(item),
        };
        let known = match &program.instruction(array).op {
            Op::Array(items) => Some(items.iter().map(entry).collect()),
            Op::Const(data) => Some(data.iter().copied().map(Entry::Number).collect()),
            _ => None,
        };
        let columns = match program.ty(array) {
            Type::Real(Shape::Matrix(_, columns)) => columns,
            Type::Real(_) | Type::Bool | Type::Ldlt(_) => 1,
        };
        Entries {
            array,
            columns,
            known,
        }
    }

    /// Whether the entries themselves are known, zeros or not.
    pub(super) fn are_known(&self) -> bool {
        self.known.is_some()
    }

    /// Whether the entry at a row-major position is the literal 0.
    pub(super) fn is_zero(&self, at: usize) -> bool {
        self.is_number(at, 0.0)
    }

    /// Whether the entries are those of the identity of so many rows.
    pub(super) fn are_identity(&self, rows: usize) -> bool {
        let unit = |at: usize| f64::from(at / rows == at % rows);
        self.columns == rows && (0..rows * rows).all(|at| self.is_number(at, unit(at)))
    }

    fn is_number(&self, at: usize, number: f64) -> bool {
        let known = self.known.as_ref();
        known.is_some_and(|entries| entries[at] == Entry::Number(number))
    }

    /// The value of the entry at a row-major position.
    pub(super) fn value(&self, program: &mut Program, at: usize) -> ValueId {
        match self.known.as_ref().map(|entries| entries[at]) {
            Some(Entry::Number(number)) => program.scalar(number),
            Some(Entry::Value(value)) => value,
            None if program.shape(self.array) == Shape::Scalar => self.array,
            None => program.push(Op::Element(
                self.array,
                at / self.columns,
                at % self.columns,
            )),
        }
    }

    /// Whether at least half of the entries are zeros.
    fn are_sparse(&self, program: &Program) -> bool {
        let zeros = (0..size(program.shape(self.array))).filter(|&at| self.is_zero(at));
        self.columns > 0 && 2 * zeros.count() >= size(program.shape(self.array))
    }
}

/// A x or A B, if at least half of the products have a zero: each entry is the sum of the others, left to right.
pub(super) fn product(program: &mut Program, a: ValueId, b: ValueId) -> Option<ValueId> {
    let (left, right) = (Entries::of(program, a), Entries::of(program, b));
    let (inner, columns) = (left.columns, right.columns);
    let rows = size(program.shape(a)).checked_div(inner)?;
    let terms = |at: usize| {
        let (row, column) = (at / columns, at % columns);
        let pairs = (0..inner).map(move |k| (row * inner + k, k * columns + column));
        pairs.filter(|&(i, j)| !left.is_zero(i) && !right.is_zero(j))
    };
    let kept: usize = (0..rows * columns).map(|at| terms(at).count()).sum();
    if 2 * kept > rows * inner * columns || kept > LARGEST {
        return None;
    }
    let shape = match program.shape(b) {
        Shape::Matrix(..) => Shape::Matrix(rows, columns),
        _ => Shape::Vector(rows),
    };
    let mut items = Vec::with_capacity(rows * columns);
    for at in 0..rows * columns {
        let mut products = Vec::new();
        for (i, j) in terms(at) {
            let y = right.value(program, j);
            let x = left.value(program, i);
            products.push(program.binary(Operator::Mul, x, y));
        }
        items.push(sum(program, products));
    }
    Some(program.array(shape, items))
}

/// a . b, if at least half of the products have a zero.
pub(super) fn dot(program: &mut Program, a: ValueId, b: ValueId) -> Option<ValueId> {
    let (left, right) = (Entries::of(program, a), Entries::of(program, b));
    let length = size(program.shape(a));
    let kept: Vec<usize> = (0..length)
        .filter(|&at| !left.is_zero(at) && !right.is_zero(at))
        .collect();
    if 2 * kept.len() > length {
        return None;
    }
    let mut products = Vec::new();
    for at in kept {
        let (x, y) = (left.value(program, at), right.value(program, at));
        products.push(program.binary(Operator::Mul, x, y));
    }
    Some(sum(program, products))
}

/// Sum of squares, if at least half of the entries are zeros: along each row, then of the rows' sums.
pub(super) fn sum_squares(program: &mut Program, a: ValueId) -> Option<ValueId> {
    let entries = Entries::of(program, a);
    if !entries.are_sparse(program) {
        return None;
    }
    let mut rows = Vec::new();
    for row in 0..size(program.shape(a)) / entries.columns {
        let row = row * entries.columns..(row + 1) * entries.columns;
        let mut squares = Vec::new();
        for at in row.filter(|&at| !entries.is_zero(at)) {
            let entry = entries.value(program, at);
            squares.push(program.binary(Operator::Mul, entry, entry));
        }
        if !squares.is_empty() {
            rows.push(sum(program, squares));
        }
    }
    Some(sum(program, rows))
}

/// a op b elementwise, if a zero decides it for at least half of the entries. Sums of which the entries of one part are not known stay whole.
pub(super) fn elementwise(
    program: &mut Program,
    operator: Operator,
    a: ValueId,
    b: ValueId,
    shape: Shape,
) -> Option<ValueId> {
    let (left, right) = (Entries::of(program, a), Entries::of(program, b));
    let (broadcast_left, broadcast_right) = (
        program.shape(a) == Shape::Scalar,
        program.shape(b) == Shape::Scalar,
    );
    let (of_left, of_right) = (
        |at: usize| if broadcast_left { 0 } else { at },
        |at: usize| if broadcast_right { 0 } else { at },
    );
    let (left_zero, right_zero) = (
        |at: usize| left.is_zero(of_left(at)),
        |at: usize| right.is_zero(of_right(at)),
    );
    let decided = |at: usize| match operator {
        Operator::Mul => left_zero(at) || right_zero(at),
        Operator::Div => left_zero(at),
        Operator::Add | Operator::Sub if left.are_known() && right.are_known() => {
            left_zero(at) || right_zero(at)
        }
        _ => false,
    };
    let entries = size(shape);
    if shape == Shape::Scalar || 2 * (0..entries).filter(|&at| decided(at)).count() < entries {
        return None;
    }
    let mut items = Vec::with_capacity(entries);
    for at in 0..entries {
        let x = left.value(program, of_left(at));
        let y = right.value(program, of_right(at));
        items.push(without_zero(program, operator, x, y));
    }
    Some(program.array(shape, items))
}

/// -A, if at least half of the entries are zeros.
pub(super) fn negation(program: &mut Program, a: ValueId) -> Option<ValueId> {
    let (entries, shape) = (Entries::of(program, a), program.shape(a));
    if shape == Shape::Scalar || !entries.are_sparse(program) {
        return None;
    }
    let mut items = Vec::with_capacity(size(shape));
    for at in 0..size(shape) {
        let entry = entries.value(program, at);
        items.push(if entries.is_zero(at) {
            entry
        } else {
            program.push(Op::Apply(Function::Neg, entry))
        });
    }
    Some(program.array(shape, items))
}

/// A^T, if at least half of the entries are zeros (exact).
pub(super) fn transpose(program: &mut Program, a: ValueId) -> Option<ValueId> {
    let entries = Entries::of(program, a);
    let Shape::Matrix(rows, columns) = program.shape(a) else {
        return None;
    };
    if !entries.are_sparse(program) {
        return None;
    }
    let positions = (0..rows * columns).map(|at| at % rows * columns + at / rows);
    let items = positions.map(|at| entries.value(program, at)).collect();
    Some(program.array(Shape::Matrix(columns, rows), items))
}

/// Sum of scalars, left to right; 0 without any.
fn sum(program: &mut Program, terms: Vec<ValueId>) -> ValueId {
    terms
        .into_iter()
        .reduce(|total, term| program.binary(Operator::Add, total, term))
        .unwrap_or_else(|| program.scalar(0.0))
}

/// An operation on scalars, left out where a zero decides it.
pub(super) fn without_zero(
    program: &mut Program,
    operator: Operator,
    a: ValueId,
    b: ValueId,
) -> ValueId {
    let zero = |id: ValueId| literal(program, id).is_some_and(|data| data == [0.0]);
    match (operator, zero(a), zero(b)) {
        (Operator::Mul | Operator::Div, true, _) | (Operator::Add | Operator::Sub, _, true) => a,
        (Operator::Mul, _, true) | (Operator::Add, true, _) => b,
        (Operator::Sub, true, _) => program.push(Op::Apply(Function::Neg, b)),
        _ => program.binary(operator, a, b),
    }
}
