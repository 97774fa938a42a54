//! Sums of multiples: equal terms are collected and literal factors multiplied out, where that leaves fewer operations. A decay
//! `w + (p - w l) d` becomes `w (1 - l d) + p d`.

use crate::ir::{Function, Instruction, Op, Operator, Program, Shape, ValueId};

use super::rewrite::{Uses, limited, literal, rewrite_counting};

/// Largest number of terms that are collected.
const LARGEST: usize = 8;

/// Collects terms.
pub(super) fn run(program: Program) -> Program {
    rewrite_counting(program, |program, instruction, uses| {
        scaled(program, instruction, uses).or_else(|| collected(program, instruction, uses))
    })
}

/// A literal factor where it takes the fewest products.
fn scaled(program: &mut Program, instruction: &Instruction, uses: &Uses) -> Option<ValueId> {
    let Op::Binary(Operator::Mul, a, b) = instruction.op else {
        return None;
    };
    let (x, factor) = match (factor(program, a), factor(program, b)) {
        (None, Some(factor)) => (a, factor),
        (Some(factor), None) => (b, factor),
        _ => return None,
    };
    if !uses.single(x) || program.ty(x) != instruction.ty {
        return None;
    }
    match program.instruction(x).op {
        // (a b^T) c == a (b c)^T (the same number of roundings, in another order)
        Op::Outer(left, right) => {
            let factor = program.scalar(factor);
            let right = program.binary(Operator::Mul, right, factor);
            Some(program.push(Op::Outer(left, right)))
        }
        // (x s) c == x (s c) for a scalar s (the same number of roundings, in another order)
        Op::Binary(Operator::Mul, array, scalar)
            if program.shape(scalar) == Shape::Scalar && program.shape(array) != Shape::Scalar =>
        {
            let factor = program.scalar(factor);
            let scalar = program.binary(Operator::Mul, scalar, factor);
            Some(program.binary(Operator::Mul, array, scalar))
        }
        _ => None,
    }
}

/// The sum of multiples that an instruction is, if its terms can be collected in fewer operations.
fn collected(program: &mut Program, instruction: &Instruction, uses: &Uses) -> Option<ValueId> {
    let mut sum = Sum {
        terms: Vec::new(),
        operations: 0,
    };
    sum.expand(program, &instruction.op, instruction, 1.0, uses);
    let Sum {
        mut terms,
        operations,
    } = sum;
    terms.retain(|(factor, _)| *factor != 0.0);
    let normal = terms.iter().all(|(factor, _)| factor.is_normal());
    if terms.is_empty() || terms.len() > LARGEST || !normal {
        return None;
    }
    let products = terms
        .iter()
        .filter(|(factor, _)| factor.abs() != 1.0)
        .count();
    if products + terms.len() > operations {
        return None;
    }
    // A term that is added first, so that no sign has to be changed.
    let first = terms
        .iter()
        .position(|(factor, _)| *factor > 0.0)
        .unwrap_or(0);
    terms.swap(0, first);
    let mut total = None;
    for (factor, term) in terms {
        let magnitude = product(program, factor.abs(), term);
        total = Some(match total {
            None if factor < 0.0 => program.push(Op::Apply(Function::Neg, magnitude)),
            None => magnitude,
            Some(total) if factor < 0.0 => program.binary(Operator::Sub, total, magnitude),
            Some(total) => program.binary(Operator::Add, total, magnitude),
        });
    }
    total
}

fn product(program: &mut Program, factor: f64, term: ValueId) -> ValueId {
    if factor == 1.0 {
        return term;
    }
    let factor = program.scalar(factor);
    program.binary(Operator::Mul, term, factor)
}

/// A sum on its way apart.
struct Sum {
    /// Factor and value of each term, each value once.
    terms: Vec<(f64, ValueId)>,
    /// Additions and products, each of a value of the sum's type, that it takes as it is.
    operations: usize,
}

impl Sum {
    /// Takes an operation of the sum's type apart: sums, changes of sign and products with a literal.
    fn expand(
        &mut self,
        program: &Program,
        op: &Op,
        whole: &Instruction,
        scale: f64,
        uses: &Uses,
    ) -> bool {
        match *op {
            // c (a + b) == c a + c b, collected: each coefficient has at most as many roundings as it has factors, and each term one
            Op::Binary(Operator::Add | Operator::Sub, a, b) => {
                let fits = |id| program.ty(id) == whole.ty;
                let kept = !fits(a) || !fits(b) || limited(program, [a, b]);
                if kept || self.terms.len() >= LARGEST {
                    return false;
                }
                let sign = if matches!(op, Op::Binary(Operator::Sub, ..)) {
                    -1.0
                } else {
                    1.0
                };
                self.operations += 1;
                self.part(program, a, whole, scale, uses);
                self.part(program, b, whole, sign * scale, uses);
                true
            }
            Op::Apply(Function::Neg, a) => {
                self.part(program, a, whole, -scale, uses);
                true
            }
            Op::Binary(Operator::Mul, a, b) => {
                let (x, factor) = match (factor(program, a), factor(program, b)) {
                    (None, Some(factor)) => (a, factor),
                    (Some(factor), None) => (b, factor),
                    _ => return false,
                };
                if program.ty(x) != whole.ty {
                    return false;
                }
                self.operations += 1;
                self.part(program, x, whole, scale * factor, uses);
                true
            }
            _ => false,
        }
    }

    fn part(
        &mut self,
        program: &Program,
        id: ValueId,
        whole: &Instruction,
        scale: f64,
        uses: &Uses,
    ) {
        let op = &program.instruction(id).op;
        if uses.single(id) && self.expand(program, op, whole, scale, uses) {
            return;
        }
        match self.terms.iter_mut().find(|(_, term)| *term == id) {
            Some((factor, _)) => *factor += scale,
            None => self.terms.push((scale, id)),
        }
    }
}

/// The number that a literal has in every entry.
fn factor(program: &Program, id: ValueId) -> Option<f64> {
    let data = literal(program, id)?;
    let first = *data.first()?;
    data.iter().all(|entry| *entry == first).then_some(first)
}
