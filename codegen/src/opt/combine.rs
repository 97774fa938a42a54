//! Polynomials at one argument that are added, or multiplied by a number, are one polynomial.

use crate::ir::{FamilyMember, Function, Instruction, Op, Operator, Program, Shape, Type, ValueId};

use super::families::Families;
use super::rewrite::{Uses, limited, literal, rewrite_counting};

/// Largest number of terms that are looked at together.
const LARGEST: usize = 16;

/// Combines polynomials.
pub(super) fn run(program: Program) -> Program {
    let mut families = Families::of(&program);
    rewrite_counting(program, |program, instruction, uses| {
        if instruction.ty != Type::Real(Shape::Scalar) {
            return None;
        }
        sum(program, instruction, uses, &mut families)
            .or_else(|| multiple(program, instruction, uses, &mut families))
    })
}

/// A polynomial: the values of its family, and where it stands among them.
type Place = (ValueId, usize);

/// The polynomial that a value is, if nothing else uses it.
fn polynomial(program: &Program, id: ValueId, uses: &Uses) -> Option<Place> {
    match program.instruction(id).op {
        Op::Element(values, row, _)
            if uses.single(id) && matches!(program.instruction(values).op, Op::Family(..)) =>
        {
            Some((values, row))
        }
        _ => None,
    }
}

/// s f(z) + t g(z) + .. == (s f + t g)(z) + .. (a rounding of each coefficient for each polynomial, and as many fewer of the sum)
fn sum(
    program: &mut Program,
    instruction: &Instruction,
    uses: &Uses,
    families: &mut Families,
) -> Option<ValueId> {
    let Op::Binary(operator @ (Operator::Add | Operator::Sub), a, b) = instruction.op else {
        return None;
    };
    if limited(program, [a, b]) {
        return None;
    }
    let mut terms = Terms::default();
    terms.both(program, (operator, a, b), 1.0, uses);
    // The argument of most polynomials, the first of equals.
    let count = |values: ValueId| {
        let of = terms.polynomials.iter().filter(|(_, at)| at.0 == values);
        of.count()
    };
    let argument = terms
        .polynomials
        .iter()
        .map(|(_, at)| at.0)
        .rev()
        .max_by_key(|&values| count(values))?;
    if count(argument) < 2 {
        return None;
    }
    let (together, apart): (Vec<_>, Vec<_>) = terms
        .polynomials
        .into_iter()
        .partition(|(_, at)| at.0 == argument);
    let mut total = combined(program, families, &together)?;
    let apart = apart.into_iter().map(|(factor, (values, row))| {
        let value = program.push(Op::Element(values, row, 0));
        (factor, value)
    });
    let rest: Vec<(f64, ValueId)> = apart.collect();
    for (factor, term) in rest.into_iter().chain(terms.others) {
        let operator = if factor < 0.0 {
            Operator::Sub
        } else {
            Operator::Add
        };
        let magnitude = match factor.abs() {
            1.0 => term,
            other => {
                let other = program.scalar(other);
                program.binary(Operator::Mul, term, other)
            }
        };
        total = program.binary(operator, total, magnitude);
    }
    Some(total)
}

/// (f(z) x ..) c == (c f)(z) x .. (a rounding of each coefficient, and one fewer of the product)
fn multiple(
    program: &mut Program,
    instruction: &Instruction,
    uses: &Uses,
    families: &mut Families,
) -> Option<ValueId> {
    let Op::Binary(Operator::Mul, a, b) = instruction.op else {
        return None;
    };
    let number = |id: ValueId| literal(program, id).map(|data| data[0]);
    let (mut product, factor) = match (number(a), number(b)) {
        (Some(factor), None) => (b, factor),
        (None, Some(factor)) => (a, factor),
        _ => return None,
    };
    let mut others = Vec::new();
    while others.len() < LARGEST {
        if let Some(place) = polynomial(program, product, uses) {
            let scaled = combined(program, families, &[(factor, place)])?;
            let product = others.into_iter().rev().fold(scaled, |product, other| {
                program.binary(Operator::Mul, product, other)
            });
            return Some(product);
        }
        let Op::Binary(Operator::Mul, left, right) = program.instruction(product).op else {
            return None;
        };
        let scalar = |id: ValueId| program.ty(id) == Type::Real(Shape::Scalar);
        if !uses.single(product) || !scalar(left) || !scalar(right) {
            return None;
        }
        let leads = |id: ValueId| {
            polynomial(program, id, uses).is_some()
                || matches!(program.instruction(id).op, Op::Binary(Operator::Mul, ..))
        };
        let (next, other) = if leads(left) {
            (left, right)
        } else {
            (right, left)
        };
        others.push(other);
        product = next;
    }
    None
}

/// The value of a sum of multiples of polynomials at one argument, if its coefficients are finite.
fn combined(
    program: &mut Program,
    families: &mut Families,
    parts: &[(f64, Place)],
) -> Option<ValueId> {
    let (_, (values, _)) = parts.first()?;
    let Op::Family(family, z) = program.instruction(*values).op else {
        return None;
    };
    let family = &program.families[family.0 as usize];
    let argument = family.argument.clone();
    let members = parts
        .iter()
        .map(|(factor, (_, row))| (*factor, &family.members[*row]));
    let length = members
        .clone()
        .map(|(_, member)| member.coefficients.len())
        .max()?;
    // What adds nothing to any number, for powers that no polynomial has.
    let mut coefficients = vec![-0.0; length];
    for (factor, member) in members.clone() {
        let lower = coefficients.len() - member.coefficients.len();
        for (sum, c) in coefficients[lower..].iter_mut().zip(&member.coefficients) {
            if c.to_bits() != (-0.0f64).to_bits() {
                *sum += factor * c;
            }
        }
    }
    if coefficients.iter().any(|c| !c.is_finite()) {
        return None;
    }
    let leading = coefficients.iter().take_while(|c| **c == 0.0).count();
    coefficients.drain(..leading.min(length - 1));
    let names: Vec<&str> = members.map(|(_, member)| member.name.as_str()).collect();
    let member = FamilyMember {
        name: names.join("_and_"),
        coefficients,
    };
    let id = families.add(program, &argument, vec![member]);
    let values = program.push(Op::Family(id, z));
    Some(program.push(Op::Element(values, 0, 0)))
}

/// A sum taken apart.
#[derive(Default)]
struct Terms {
    polynomials: Vec<(f64, Place)>,
    others: Vec<(f64, ValueId)>,
}

impl Terms {
    /// Takes both terms of a sum apart.
    fn both(
        &mut self,
        program: &Program,
        (operator, a, b): (Operator, ValueId, ValueId),
        scale: f64,
        uses: &Uses,
    ) {
        let sign = if operator == Operator::Sub { -1.0 } else { 1.0 };
        self.part(program, a, scale, uses);
        self.part(program, b, sign * scale, uses);
    }

    /// Takes sums, changes of sign and multiples that nothing else uses apart.
    fn part(&mut self, program: &Program, id: ValueId, scale: f64, uses: &Uses) {
        if let Some(place) = polynomial(program, id, uses) {
            self.polynomials.push((scale, place));
            return;
        }
        let number = |id: ValueId| literal(program, id).map(|data| data[0]);
        match program.instruction(id).op {
            Op::Binary(operator @ (Operator::Add | Operator::Sub), a, b)
                if uses.single(id)
                    && !limited(program, [a, b])
                    && self.polynomials.len() + self.others.len() < LARGEST =>
            {
                self.both(program, (operator, a, b), scale, uses);
            }
            Op::Apply(Function::Neg, a) if uses.single(id) => self.part(program, a, -scale, uses),
            Op::Binary(Operator::Mul, a, b) if uses.single(id) => {
                let of = match (number(a), number(b)) {
                    (Some(factor), None) => polynomial(program, b, uses).map(|at| (factor, at)),
                    (None, Some(factor)) => polynomial(program, a, uses).map(|at| (factor, at)),
                    _ => None,
                };
                match of {
                    Some((factor, place)) => self.polynomials.push((scale * factor, place)),
                    None => self.others.push((scale, id)),
                }
            }
            _ => self.others.push((scale, id)),
        }
    }
}
