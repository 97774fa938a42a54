//! Arrays taken apart and put together again.

use crate::ir::{Op, Program, Shape, Type, ValueId};

use super::rewrite::rewrite;

/// Looks through arrays of scalars and entries of arrays.
pub(super) fn run(program: Program) -> Program {
    rewrite(program, |program, instruction| match &instruction.op {
        Op::Element(a, row, column) => element(program, *a, *row, *column),
        // [x] as a scalar == x (exact)
        Op::Array(items) if instruction.ty == Type::Real(Shape::Scalar) => Some(items[0]),
        Op::Array(items) => whole(program, items, instruction.ty),
        _ => None,
    })
}

fn element(program: &mut Program, a: ValueId, row: usize, column: usize) -> Option<ValueId> {
    match &program.instruction(a).op {
        // [.., x_ij, ..]_ij == x_ij (exact)
        Op::Array(items) => Some(items[row * columns(program, a) + column]),
        // (M^T)_ij == M_ji (exact)
        &Op::Transpose(m) => Some(program.push(Op::Element(m, column, row))),
        _ => None,
    }
}

/// [a_11, a_12, ..] == a (exact), for all entries of one array of the same type
fn whole(program: &Program, items: &[ValueId], ty: Type) -> Option<ValueId> {
    let Op::Element(array, 0, 0) = program.instruction(*items.first()?).op else {
        return None;
    };
    if program.ty(array) != ty {
        return None;
    }
    let columns = columns(program, array);
    let in_order = |(index, &item): (usize, &ValueId)| {
        program.instruction(item).op == Op::Element(array, index / columns, index % columns)
    };
    items.iter().enumerate().all(in_order).then_some(array)
}

fn columns(program: &Program, array: ValueId) -> usize {
    match program.shape(array) {
        Shape::Matrix(_, columns) => columns,
        Shape::Scalar | Shape::Vector(_) => 1,
    }
}
