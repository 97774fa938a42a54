//! Polynomials at the same arguments that are added, or multiplied by a number, are one polynomial; literal arguments go into its
//! coefficients.

use std::collections::BTreeMap;

use crate::ir::{
    FamilyMember, Function, Instruction, Op, Operator, PolynomialData, PolynomialId, Program,
    Shape, Type, ValueId,
};

use super::families::Polynomials;
use super::rewrite::{Uses, limited, literal, rewrite, rewrite_counting};

/// Largest number of terms that are looked at together.
const LARGEST: usize = 16;

/// Most polynomials that the name of a sum tells.
const MOST_NAMES: usize = 8;

/// Combines polynomials, and folds literal arguments of those that are left.
pub(super) fn run(program: Program) -> Program {
    let mut known = Polynomials::of(&program);
    let program = rewrite_counting(program, |program, instruction, uses| {
        if instruction.ty != Type::Real(Shape::Scalar) {
            return None;
        }
        sum(program, instruction, uses, &mut known)
            .or_else(|| multiple(program, instruction, uses, &mut known))
    });
    rewrite(program, |program, instruction| match &instruction.op {
        Op::Polynomial(id, arguments) if literals_occur(program, *id, arguments) => {
            combined_data(program, &mut known, &[(1.0, *id, arguments.clone())])
        }
        _ => None,
    })
}

/// What polynomials have in common that can be one.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// They are of one family.
    Family(ValueId),
    /// They are data at these arguments, in whatever order, besides literals.
    Arguments(Vec<ValueId>),
}

/// The place of the polynomial that a value is, if nothing else uses it.
fn place(program: &Program, id: ValueId, uses: &Uses) -> Option<Place> {
    if !uses.single(id) {
        return None;
    }
    match &program.instruction(id).op {
        Op::Element(values, ..) => {
            let family = matches!(program.instruction(*values).op, Op::Family(..));
            family.then_some(Place::Family(*values))
        }
        Op::Polynomial(_, arguments) => {
            let mut variables = variables(program, arguments);
            variables.sort_unstable();
            Some(Place::Arguments(variables))
        }
        _ => None,
    }
}

/// The arguments that are no literals, each once.
fn variables(program: &Program, arguments: &[ValueId]) -> Vec<ValueId> {
    let mut variables = Vec::new();
    for &argument in arguments {
        if literal(program, argument).is_none() && !variables.contains(&argument) {
            variables.push(argument);
        }
    }
    variables
}

/// s f(z) + t g(z) + .. == (s f + t g)(z) + .. (a rounding of each coefficient for each polynomial, and as many fewer of the sum)
fn sum(
    program: &mut Program,
    instruction: &Instruction,
    uses: &Uses,
    known: &mut Polynomials,
) -> Option<ValueId> {
    let Op::Binary(operator @ (Operator::Add | Operator::Sub), a, b) = instruction.op else {
        return None;
    };
    if limited(program, [a, b]) {
        return None;
    }
    let mut terms = Terms::default();
    terms.both(program, (operator, a, b), 1.0, uses);
    // Where most polynomials are, the first of equals.
    let count = |place: &Place| {
        let there = terms.polynomials.iter().filter(|(_, _, at)| at == place);
        there.count()
    };
    let place = terms
        .polynomials
        .iter()
        .map(|(_, _, at)| at)
        .rev()
        .max_by_key(|place| count(place))?
        .clone();
    if count(&place) < 2 {
        return None;
    }
    let (together, apart): (Vec<_>, Vec<_>) = terms
        .polynomials
        .into_iter()
        .partition(|(_, _, at)| *at == place);
    let together: Vec<(f64, ValueId)> = together.into_iter().map(|(c, id, _)| (c, id)).collect();
    let mut total = combined(program, known, &together, &place)?;
    let rest = apart.into_iter().map(|(factor, id, _)| (factor, id));
    for (factor, term) in rest.chain(terms.others) {
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
    known: &mut Polynomials,
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
        if let Some(place) = place(program, product, uses) {
            let scaled = combined(program, known, &[(factor, product)], &place)?;
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
            place(program, id, uses).is_some()
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

/// The value of a sum of multiples of polynomials at one place, if its coefficients are finite.
fn combined(
    program: &mut Program,
    known: &mut Polynomials,
    parts: &[(f64, ValueId)],
    place: &Place,
) -> Option<ValueId> {
    let values = match place {
        Place::Family(values) => *values,
        Place::Arguments(_) => {
            let parts = parts.iter().map(|&(factor, id)| {
                let Op::Polynomial(data, arguments) = &program.instruction(id).op else {
                    unreachable!("invariant: polynomial data is at these arguments")
                };
                (factor, *data, arguments.clone())
            });
            let parts: Vec<Part> = parts.collect();
            return combined_data(program, known, &parts);
        }
    };
    let Op::Family(family, z) = program.instruction(values).op else {
        return None;
    };
    let family = &program.families[family.0 as usize];
    let argument = family.argument.clone();
    let members = parts
        .iter()
        .map(|&(factor, id)| match program.instruction(id).op {
            Op::Element(_, row, _) => (factor, &family.members[row]),
            _ => unreachable!("invariant: a member of the family"),
        });
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
        name: joined(&names),
        coefficients,
    };
    let id = known.add_family(program, &argument, vec![member]);
    let values = program.push(Op::Family(id, z));
    Some(program.push(Op::Element(values, 0, 0)))
}

/// The name of a sum: all names, or the first of many.
fn joined(names: &[&str]) -> String {
    let all = names.join("_and_");
    match all.split("_and_").count() {
        ..=MOST_NAMES => all,
        _ => format!(
            "{}_and_others",
            names[0].split("_and_").next().unwrap_or_default()
        ),
    }
}

/// Polynomial data in a sum: its factor and its arguments.
type Part = (f64, PolynomialId, Vec<ValueId>);

/// Whether an argument that is a literal occurs in a term.
fn literals_occur(program: &Program, id: PolynomialId, arguments: &[ValueId]) -> bool {
    let terms = &program.polynomials[id.0 as usize].terms;
    let occurs = |at: usize| terms.iter().any(|(_, exponents)| exponents[at] > 0);
    (0..arguments.len()).any(|at| literal(program, arguments[at]).is_some() && occurs(at))
}

/// The value of a sum of multiples of polynomial data whose arguments are the same besides literals, if its coefficients are finite.
///
/// f(z, m) == f_m(z), with c m^i for each coefficient c of f (a rounding of the coefficient for each product)
fn combined_data(
    program: &mut Program,
    known: &mut Polynomials,
    parts: &[Part],
) -> Option<ValueId> {
    let variables = variables(program, &parts.first()?.2);
    let mut names = vec![String::new(); variables.len()];
    let mut sums: BTreeMap<Vec<u32>, f64> = BTreeMap::new();
    for (factor, id, arguments) in parts {
        let data = &program.polynomials[id.0 as usize];
        for (c, exponents) in &data.terms {
            let (mut c, mut of) = (factor * c, vec![0; variables.len()]);
            for (at, (&argument, &exponent)) in arguments.iter().zip(exponents).enumerate() {
                match literal(program, argument) {
                    Some(m) => c = (0..exponent).fold(c, |product, _| product * m[0]),
                    None => {
                        let variable = variables.iter().position(|&known| known == argument)?;
                        of[variable] += exponent;
                        names[variable].clone_from(&data.arguments[at]);
                    }
                }
            }
            *sums.entry(of).or_insert(0.0) += c;
        }
    }
    if sums.values().any(|c| !c.is_finite()) {
        return None;
    }
    sums.retain(|_, c| *c != 0.0);
    let occurring: Vec<usize> = (0..variables.len())
        .filter(|&at| sums.keys().any(|exponents| exponents[at] > 0))
        .collect();
    if occurring.is_empty() {
        let value = sums.into_values().next().unwrap_or(0.0);
        return Some(program.scalar(value));
    }
    let of = parts
        .iter()
        .map(|(_, id, _)| program.polynomials[id.0 as usize].name.as_str());
    let data = PolynomialData {
        name: joined(&of.collect::<Vec<_>>()),
        arguments: occurring.iter().map(|&at| names[at].clone()).collect(),
        terms: sums
            .into_iter()
            .map(|(exponents, c)| (c, occurring.iter().map(|&at| exponents[at]).collect()))
            .collect(),
    };
    let id = known.add(program, data);
    let arguments = occurring.into_iter().map(|at| variables[at]).collect();
    Some(program.push(Op::Polynomial(id, arguments)))
}

/// A sum taken apart.
#[derive(Default)]
struct Terms {
    polynomials: Vec<(f64, ValueId, Place)>,
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
        if let Some(place) = place(program, id, uses) {
            self.polynomials.push((scale, id, place));
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
                let of = |factor: f64, id: ValueId| Some((factor, id, place(program, id, uses)?));
                let multiple = match (number(a), number(b)) {
                    (Some(factor), None) => of(scale * factor, b),
                    (None, Some(factor)) => of(scale * factor, a),
                    _ => None,
                };
                match multiple {
                    Some(multiple) => self.polynomials.push(multiple),
                    None => self.others.push((scale, id)),
                }
            }
            _ => self.others.push((scale, id)),
        }
    }
}
