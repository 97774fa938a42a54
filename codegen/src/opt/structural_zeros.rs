//! Zeros and identities in the structure of the equations, such as absent couplings in a gain matrix. `x * 0 == 0` for finite x only,
//! and `x + 0 == x` up to the sign of a zero, so the pass is not exact. It is part of lowering all the same: a coupling that is absent is no operation of
//! the law, as it is none on paper. The emitted step refuses non-finite inputs, so it shows only where something overflows inside the step.

use crate::ir::build::size;
use crate::ir::{Function, Instruction, Op, Operator, Program, Shape, Type, ValueId};

use super::dependence::Dependences;
use super::rewrite::{literal, negated, of_type, rewrite};
use super::{solve, sparse};

/// Removes arithmetic with structural zeros.
pub(super) fn run(program: Program) -> Program {
    let mut dependences = Dependences::default();
    rewrite(program, |program, instruction| match instruction.op {
        Op::Binary(operator, a, b) => elementwise(program, instruction, operator, a, b),
        Op::Apply(Function::Neg, a) => sparse::negation(program, a),
        Op::Transpose(a) => sparse::transpose(program, a),
        Op::MatMul(a, b) => matrix_product(program, instruction, a, b),
        Op::SumSquares(a) => sparse::sum_squares(program, a),
        Op::Solve(a, b) => solve::solve(program, &mut dependences, a, b),
        // 0 . x == 0, 0 x^T == 0 (finite x)
        Op::Dot(a, b) | Op::Outer(a, b) if is_zero(program, a) || is_zero(program, b) => {
            Some(zero(program, instruction))
        }
        Op::Dot(a, b) => sparse::dot(program, a, b),
        _ => None,
    })
}

fn elementwise(
    program: &mut Program,
    instruction: &Instruction,
    operator: Operator,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    match operator {
        // x * 0 == 0, 0 * x == 0 (finite x, up to the sign of zero)
        Operator::Mul if is_zero(program, a) || is_zero(program, b) => {
            Some(zero(program, instruction))
        }
        // 0 / x == 0 (finite x other than 0, up to the sign of zero)
        Operator::Div if is_zero(program, a) => Some(zero(program, instruction)),
        // x + 0 == x, x - 0 == x (up to the sign of zero)
        Operator::Add | Operator::Sub if is_zero(program, b) => of_type(program, a, instruction.ty),
        // 0 + x == x (up to the sign of zero)
        Operator::Add if is_zero(program, a) => of_type(program, b, instruction.ty),
        // 0 - x == -x (up to the sign of zero)
        Operator::Sub if is_zero(program, a) => {
            let b = of_type(program, b, instruction.ty)?;
            Some(program.push(Op::Apply(Function::Neg, b)))
        }
        _ => {
            let Type::Real(shape) = instruction.ty else {
                return None;
            };
            sparse::elementwise(program, operator, a, b, shape)
        }
    }
}

fn matrix_product(
    program: &mut Program,
    instruction: &Instruction,
    a: ValueId,
    b: ValueId,
) -> Option<ValueId> {
    // 0 B == 0, A 0 == 0 (finite entries)
    if is_zero(program, a) || is_zero(program, b) {
        return Some(zero(program, instruction));
    }
    // A I == A (finite entries, up to the sign of zero)
    if diagonal(program, b).is_some_and(|d| d.iter().all(|&entry| entry == 1.0)) {
        return Some(a);
    }
    // (-A) B == -(A B) (up to the sign of zero)
    if let Some(a) = negated(program, a) {
        let product = program.push(Op::MatMul(a, b));
        return Some(program.push(Op::Apply(Function::Neg, product)));
    }
    let Some(diagonal) = diagonal(program, a) else {
        return sparse::product(program, a, b);
    };
    // I B == B (finite entries, up to the sign of zero)
    if diagonal.iter().all(|&entry| entry == 1.0) {
        return Some(b);
    }
    // diag(d) x == d * x elementwise (finite entries, up to the sign of zero)
    let shape @ Shape::Vector(_) = program.shape(b) else {
        return sparse::product(program, a, b);
    };
    let diagonal = program.constant(shape, diagonal);
    Some(program.binary(Operator::Mul, diagonal, b))
}

fn is_zero(program: &Program, id: ValueId) -> bool {
    literal(program, id).is_some_and(|data| data.iter().all(|&entry| entry == 0.0))
}

/// The literal 0 of the instruction's shape.
fn zero(program: &mut Program, instruction: &Instruction) -> ValueId {
    let Type::Real(shape) = instruction.ty else {
        panic!("invariant: arithmetic gives a real value")
    };
    program.constant(shape, vec![0.0; size(shape)])
}

/// The diagonal of a literal square matrix whose other entries are 0.
fn diagonal(program: &Program, id: ValueId) -> Option<Vec<f64>> {
    let Shape::Matrix(rows, columns) = program.shape(id) else {
        return None;
    };
    let data = literal(program, id).filter(|_| rows == columns)?;
    let off = |(index, &entry): (usize, &f64)| index / columns == index % columns || entry == 0.0;
    data.iter()
        .enumerate()
        .all(off)
        .then(|| data.iter().step_by(columns + 1).copied().collect())
}
