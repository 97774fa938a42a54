//! `x s + x t == x (s + t)`: terms of a sum of arrays that are one array times different scalars become one term, and so do the images of two
//! vectors under one matrix or its inverse, `A x + A y == A (x + y)`. Also part of lowering: the damping of a block is a sum of many multiples
//! of its error. A sum of n terms is off by at most (n + 2) 2^-53 of the sum of their magnitudes before and after, each with the roundings of
//! its own factors.

use crate::ir::{Function, Op, Operator, Program, Shape, ValueId};

use super::rewrite::{Uses, is_all, rewrite_counting};

/// Most terms of a sum that are looked at together, so that the work for an instruction is bounded.
const LONGEST: usize = 16;

/// A term of a sum: an array, its scalar factors, and whether it is subtracted.
struct Term {
    base: ValueId,
    factors: Vec<ValueId>,
    negative: bool,
    /// Whether it takes a product that nothing else needs.
    own: bool,
}

/// Merges terms.
pub(super) fn run(program: Program) -> Program {
    rewrite_counting(program, |program, instruction, uses| {
        let Op::Binary(operator @ (Operator::Add | Operator::Sub), a, b) = instruction.op else {
            return None;
        };
        if program.ty(a) != program.ty(b) || program.shape(a) == Shape::Scalar {
            return None;
        }
        let mut terms = Vec::new();
        collect(program, uses, a, false, &mut terms);
        collect(program, uses, b, operator == Operator::Sub, &mut terms);
        let changed = join_images(program, uses, &mut terms) | join_multiples(program, &mut terms);
        changed.then(|| total(program, &terms))
    })
}

/// A x + A y == A (x + y), A^-1 x - A^-1 y == A^-1 (x - y), for the first two such terms that nothing else needs; whether there are any.
fn join_images(program: &mut Program, uses: &Uses, terms: &mut Vec<Term>) -> bool {
    let image = |term: &Term| match program.instruction(term.base).op {
        Op::MatMul(a, x) if term.factors.is_empty() => Some((false, a, x)),
        Op::Solve(a, x) if term.factors.is_empty() => Some((true, a, x)),
        _ => None,
    };
    let images: Vec<_> = terms.iter().map(image).collect();
    let alike = |first: usize, second: usize| {
        let (a, b) = (images[first]?, images[second]?);
        let own = [first, second]
            .iter()
            .all(|&at| uses.single(terms[at].base));
        (a.0 == b.0 && a.1 == b.1 && own && terms[first].base != terms[second].base)
            .then_some((first, second, a, b.2))
    };
    let mut pairs =
        (0..terms.len()).flat_map(|second| (0..second).map(move |first| (first, second)));
    let Some((first, second, (inverse, a, x), y)) = pairs.find_map(|(i, j)| alike(i, j)) else {
        return false;
    };
    let opposite = terms[first].negative != terms[second].negative;
    let sum = program.binary(sign(opposite), x, y);
    terms[first].base = program.push(match inverse {
        true => Op::Solve(a, sum),
        false => Op::MatMul(a, sum),
    });
    terms.remove(second);
    true
}

/// The terms of a sum, through the sums without a name that it alone uses.
fn collect(program: &Program, uses: &Uses, id: ValueId, negative: bool, terms: &mut Vec<Term>) {
    let instruction = program.instruction(id);
    let inner = instruction.name.is_none() && uses.single(id) && terms.len() < LONGEST;
    match instruction.op {
        Op::Binary(operator @ (Operator::Add | Operator::Sub), a, b)
            if inner && program.ty(a) == program.ty(b) =>
        {
            collect(program, uses, a, negative, terms);
            let turned = operator == Operator::Sub;
            collect(program, uses, b, negative != turned, terms);
        }
        Op::Apply(Function::Neg, a) if inner => collect(program, uses, a, !negative, terms),
        _ => terms.push(term(program, uses, id, negative)),
    }
}

/// A value as an array times scalars.
fn term(program: &Program, uses: &Uses, id: ValueId, negative: bool) -> Term {
    let (mut base, mut factors) = (id, Vec::new());
    while let Op::Binary(Operator::Mul, a, b) = program.instruction(base).op {
        let (array, factor) = match (program.shape(a), program.shape(b)) {
            (_, Shape::Scalar) => (a, b),
            (Shape::Scalar, _) => (b, a),
            _ => break,
        };
        base = array;
        factors.push(factor);
    }
    Term {
        base,
        own: !factors.is_empty() && uses.single(id),
        factors,
        negative,
    }
}

/// x s + x t == x (s + t): the terms of one array in the place of the first of them; whether any go.
fn join_multiples(program: &mut Program, terms: &mut Vec<Term>) -> bool {
    let position = (0..terms.len()).find(|&first| {
        let alike = terms[first..]
            .iter()
            .filter(|term| term.base == terms[first].base);
        let (count, own) = alike.fold((0, 0), |(count, own), term| {
            (count + 1, own + usize::from(term.own))
        });
        // One product comes, and a sum for each but one of the terms goes with the products that were theirs alone.
        count > 1 && count + own > 2 && terms[first..].iter().any(|term| !term.factors.is_empty())
    });
    let Some(position) = position else {
        return false;
    };
    let base = terms[position].base;
    let (alike, rest): (Vec<Term>, Vec<Term>) =
        terms.drain(position..).partition(|term| term.base == base);
    let mut factor = None;
    for term in &alike {
        let product = product(program, &term.factors);
        factor = Some(match factor {
            None if term.negative => program.push(Op::Apply(Function::Neg, product)),
            None => product,
            Some(sum) => program.binary(sign(term.negative), sum, product),
        });
    }
    let factor = factor.expect("invariant: at least two terms");
    terms.push(Term {
        base: program.binary(Operator::Mul, base, factor),
        factors: Vec::new(),
        negative: false,
        own: false,
    });
    terms.extend(rest);
    true
}

/// The sum, left to right.
fn total(program: &mut Program, terms: &[Term]) -> ValueId {
    let sum = terms.iter().fold(None, |sum, term| {
        let value = scaled(program, term);
        Some(match sum {
            None if term.negative => program.push(Op::Apply(Function::Neg, value)),
            None => value,
            Some(sum) => program.binary(sign(term.negative), sum, value),
        })
    });
    sum.expect("invariant: a sum has terms")
}

fn sign(negative: bool) -> Operator {
    if negative {
        Operator::Sub
    } else {
        Operator::Add
    }
}

/// Product of scalars, 1 without any.
fn product(program: &mut Program, factors: &[ValueId]) -> ValueId {
    let factors: Vec<ValueId> = factors
        .iter()
        .rev()
        .copied()
        .filter(|&factor| !is_all(program, factor, 1.0))
        .collect();
    factors
        .into_iter()
        .reduce(|product, factor| program.binary(Operator::Mul, product, factor))
        .unwrap_or_else(|| program.scalar(1.0))
}

/// The array of a term with its factors.
fn scaled(program: &mut Program, term: &Term) -> ValueId {
    term.factors.iter().rev().fold(term.base, |array, &factor| {
        program.binary(Operator::Mul, array, factor)
    })
}
