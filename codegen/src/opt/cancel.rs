//! Inverses that need not be computed: `(M^-1 B) b == M^-1 (B b)` is solved for, unless the inverse is needed anyway, and
//! `(M^-1 B)^-1 b == B^-1 (M b)`, in which `M (x + M^-1 c) == M x + c`; `M^-1 (M x) == x`. Part of lowering: the roundings of a product or of
//! one solution instead of those of an inverse. So a controller that inverts the gain `M^-1` of a plant multiplies by the mass matrix, as by
//! hand.

use std::collections::BTreeSet;

use crate::ir::{Function, Op, Operator, Program, Shape, ValueId};

use super::dead_code::live;
use super::dependence::{Dependence, dependences};
use super::rewrite::rewrite;
use super::sparse::Entries;
use super::symmetric::matrix;

/// Most terms that are looked at for a solution that a product cancels.
const LONGEST_SUM: usize = 64;

/// Cancels inverses.
pub(super) fn run(program: Program) -> Program {
    let staying = staying(&program);
    let mut place = 0..staying.len();
    let mut kept = BTreeSet::new();
    rewrite(program, |program, instruction| {
        let stays = place.next().is_some_and(|place| staying[place]);
        match instruction.op {
            Op::MatMul(a, b) if !kept.contains(&a) => {
                let (equations, right) = solution(program, a)?;
                let right = product(program, right, b);
                let solution = program.push(Op::Solve(equations, right));
                kept.extend(stays.then_some(solution));
                Some(solution)
            }
            Op::Solve(a, b) => {
                if let Op::MatMul(of, x) = program.instruction(b).op
                    && of == matrix(program, a)
                {
                    return Some(x);
                }
                if let Some((equations, right)) = solution(program, matrix(program, a)) {
                    let matrix = matrix(program, equations);
                    let image = image(program, matrix, b)?;
                    return Some(match is_identity(program, right) {
                        true => image,
                        false => program.push(Op::Solve(right, image)),
                    });
                }
                let solution = program.push(Op::Solve(a, b));
                kept.extend(stays.then_some(solution));
                Some(solution)
            }
            _ => None,
        }
    })
}

/// Which values are needed for more than products with them and solutions in them, or are computed once for a run.
fn staying(program: &Program) -> Vec<bool> {
    let dependences = dependences(program);
    let dependence = |value: ValueId| dependences[value.0 as usize];
    let mut staying = vec![false; program.instructions.len()];
    for (_, output) in &program.outputs {
        staying[output.0 as usize] = true;
    }
    let needed = live(program);
    let users = program.instructions.iter().zip(needed);
    for (user, _) in users.filter(|(_, needed)| *needed) {
        let cancelled = match user.op {
            Op::MatMul(a, b) => {
                let fixed = dependence(a) <= Dependence::Parameters;
                (!fixed || dependence(b) <= Dependence::Parameters).then_some(a)
            }
            Op::Solve(a, _) => Some(a),
            _ => None,
        };
        let operands = user.op.operands().into_iter();
        for operand in operands.filter(|&operand| Some(operand) != cancelled) {
            staying[operand.0 as usize] = true;
        }
    }
    staying
}

/// M or its factors, and B, for M^-1 B.
fn solution(program: &Program, value: ValueId) -> Option<(ValueId, ValueId)> {
    match program.instruction(value).op {
        Op::Solve(matrix, right) => Some((matrix, right)),
        _ => None,
    }
}

fn is_identity(program: &Program, matrix: ValueId) -> bool {
    matches!(program.shape(matrix), Shape::Matrix(rows, _) if Entries::of(program, matrix).are_identity(rows))
}

/// A b, with I b == b.
fn product(program: &mut Program, a: ValueId, b: ValueId) -> ValueId {
    match is_identity(program, a) {
        true => b,
        false => program.push(Op::MatMul(a, b)),
    }
}

/// M b, without the solutions in M of which b is a sum.
fn image(program: &mut Program, matrix: ValueId, b: ValueId) -> Option<ValueId> {
    let mut sum = Sum {
        matrix,
        left: LONGEST_SUM,
        cancelled: Vec::new(),
    };
    let rest = sum.without_solutions(program, b, false);
    let product = rest.map(|rest| program.push(Op::MatMul(matrix, rest)));
    sum.cancelled
        .into_iter()
        .fold(product, |sum, (negative, c)| {
            Some(match sum {
                None if negative => program.push(Op::Apply(Function::Neg, c)),
                None => c,
                Some(sum) if negative => program.binary(Operator::Sub, sum, c),
                Some(sum) => program.binary(Operator::Add, sum, c),
            })
        })
}

/// A sum that is multiplied by a matrix.
struct Sum {
    matrix: ValueId,
    /// How many more terms are looked at.
    left: usize,
    /// Right sides c of the terms M^-1 c, and whether they are subtracted.
    cancelled: Vec<(bool, ValueId)>,
}

impl Sum {
    /// c, for a term M^-1 c.
    fn right(&self, program: &mut Program, term: ValueId) -> Option<ValueId> {
        match program.instruction(term).op {
            Op::Solve(of, c) if matrix(program, of) == self.matrix => Some(c),
            Op::MatMul(a, c) => {
                let (_, right) =
                    solution(program, a).filter(|&(of, _)| matrix(program, of) == self.matrix)?;
                Some(product(program, right, c))
            }
            _ => None,
        }
    }

    /// The other terms; nothing if there are none.
    fn without_solutions(
        &mut self,
        program: &mut Program,
        sum: ValueId,
        negative: bool,
    ) -> Option<ValueId> {
        if self.left == 0 {
            return Some(sum);
        }
        self.left -= 1;
        if let Some(right) = self.right(program, sum) {
            self.cancelled.push((negative, right));
            return None;
        }
        match program.instruction(sum).op {
            Op::Apply(Function::Neg, x) => {
                let rest = self.without_solutions(program, x, !negative)?;
                Some(match rest == x {
                    true => sum,
                    false => program.push(Op::Apply(Function::Neg, rest)),
                })
            }
            Op::Binary(operator @ (Operator::Add | Operator::Sub), x, y)
                if program.ty(x) == program.ty(y) =>
            {
                let subtracts = operator == Operator::Sub;
                let left = self.without_solutions(program, x, negative);
                let right = self.without_solutions(program, y, negative != subtracts);
                match (left, right) {
                    (Some(left), Some(right)) if (left, right) == (x, y) => Some(sum),
                    (Some(left), Some(right)) => Some(program.binary(operator, left, right)),
                    (None, Some(right)) if subtracts => {
                        Some(program.push(Op::Apply(Function::Neg, right)))
                    }
                    (left, right) => left.or(right),
                }
            }
            _ => Some(sum),
        }
    }
}
