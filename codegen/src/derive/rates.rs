//! Rates of the law's quantities along a direction: the chain rule over the table of equations.
//!
//! An equation that is made of sums, products, solves and bases is differentiated here, as arrays. Every other equation is one
//! nonlinear formula of the paper or the specification; CasADi supplies its partials, and the chain rule is completed with the
//! rates of what it depends on. This is (34) written for every quantity: no partial is ever taken of more than one equation.

use std::collections::BTreeMap;

use super::Partials;
use super::error::DeriveError;
use super::formula::Formula;
use super::law::Law;
use super::symbol::{Symbol, Term, name, number, zeros};
use crate::casadi::Job;
use crate::ir::{Function, Operator, Shape};

/// A direction in the space of leaves: the total derivative along a flow, or along a straight line.
#[derive(Clone, Debug)]
pub(crate) struct Direction {
    /// Suffix of the quantities defined: `dot` gives `alpha1_dot`, `alpha1_dot2`, ..
    pub tag: String,
    /// First rate, a quantity, of each quantity at which the chain rule starts. `None` is zero; a leaf that is not here is constant.
    pub starts: BTreeMap<String, Option<String>>,
    /// Whether the direction is a straight line, along which second rates of the starts vanish.
    pub straight: bool,
}

/// Tag of [`Direction::time`].
const TIME: &str = "dot";

impl Direction {
    /// A rate in symbols, for comments: primes along time and the flows, `D` along a line.
    fn rate_text(&self, quantity: &str, order: usize) -> String {
        match (self.straight, self.tag.as_str()) {
            (false, TIME) => format!("{quantity}{}", "'".repeat(order)),
            (false, tag) => format!("{quantity}{} along the {tag}", "'".repeat(order)),
            (true, tag) => format!("D^{order} {quantity} along {}", tag.trim_end_matches('_')),
        }
    }

    /// Whether a quantity is what a straight line points along: it stays the same on the line, although its equation may depend on what
    /// moves (a diffusion that depends on the state: Ito, not Stratonovich).
    fn holds(&self, quantity: &str) -> bool {
        self.straight
            && self
                .starts
                .values()
                .any(|start| start.as_deref() == Some(quantity))
    }

    /// Time alone.
    pub fn time() -> Self {
        Self {
            tag: TIME.into(),
            starts: [("t".to_string(), Some("one".to_string()))].into(),
            straight: false,
        }
    }
}

/// Takes rates of a law's quantities, adds them to the law, and remembers those taken.
pub(crate) struct Rates<'p, 'm> {
    /// The law.
    pub law: Law<'m>,
    partials: &'p mut dyn Partials,
    /// Quantity made here -> quantity, direction and order that it is the rate of.
    made: BTreeMap<String, (String, String, usize)>,
    done: BTreeMap<(String, String, usize), Option<String>>,
}

impl<'p, 'm> Rates<'p, 'm> {
    /// An engine around a law.
    pub fn new(law: Law<'m>, partials: &'p mut dyn Partials) -> Self {
        Self {
            law,
            partials,
            made: BTreeMap::new(),
            done: BTreeMap::new(),
        }
    }

    /// The `order`-th rate of a quantity as a quantity; `None` if it is zero.
    pub fn rate(
        &mut self,
        quantity: &str,
        direction: &Direction,
        order: usize,
    ) -> Result<Option<String>, DeriveError> {
        if let Some((base, _, k)) = self
            .made
            .get(quantity)
            .filter(|(_, tag, _)| *tag == direction.tag)
            .cloned()
        {
            return self.rate(&base, direction, k + order);
        }
        if direction.tag != TIME && self.law.leaves_of(quantity).iter().all(|leaf| leaf == "t") {
            // The same in every flow, and constant along every straight line.
            return if direction.straight {
                Ok(None)
            } else {
                self.rate(quantity, &Direction::time(), order)
            };
        }
        if direction.straight
            && direction
                .starts
                .values()
                .flatten()
                .any(|start| start == quantity)
        {
            // The direction itself does not turn.
            return Ok(None);
        }
        let key = (quantity.to_string(), direction.tag.clone(), order);
        if let Some(done) = self.done.get(&key) {
            return Ok(done.clone());
        }
        let result = self.take(quantity, direction, order)?;
        self.done.insert(key, result.clone());
        Ok(result)
    }

    fn take(
        &mut self,
        quantity: &str,
        direction: &Direction,
        order: usize,
    ) -> Result<Option<String>, DeriveError> {
        if direction.holds(quantity) {
            return Ok(None);
        }
        if let Some(start) = direction.starts.get(quantity) {
            let further = order > 1 && direction.straight;
            let Some(start) = start.clone().filter(|_| !further) else {
                return Ok(None);
            };
            return if order == 1 {
                Ok(Some(start))
            } else {
                self.rate(&start, direction, order - 1)
            };
        }
        let Some(equation) = self.law.equation(quantity) else {
            return Ok(None);
        };
        let rhs = equation.rhs.clone();
        if !is_structural(&rhs) {
            return self.chain(quantity, &rhs, direction, order);
        }
        let mut differentiated = rhs;
        if order > 1 {
            // Go on from the rate one order lower: it is structural again, or the rate of something simpler.
            let Some(previous) = self.rate(quantity, direction, order - 1)? else {
                return Ok(None);
            };
            let own = (quantity.to_string(), direction.tag.clone(), order - 1);
            if self.made.get(&previous) != Some(&own) {
                return self.rate(&previous, direction, 1);
            }
            differentiated = self
                .law
                .equation(&previous)
                .expect("invariant: a rate is an equation")
                .rhs
                .clone();
        }
        let Some(rate) = self.differentiate(&differentiated, direction)? else {
            return Ok(None);
        };
        Ok(Some(self.named(quantity, direction, order, rate)))
    }

    /// Rate of a nonlinear formula by its partials.
    fn chain(
        &mut self,
        quantity: &str,
        rhs: &Symbol,
        direction: &Direction,
        order: usize,
    ) -> Result<Option<String>, DeriveError> {
        let formula = Formula::of(&self.law, quantity, rhs);
        let mut bindings = formula.bindings.clone();
        let mut varying = Vec::new();
        for (input, of) in &formula.quantities {
            let mut moves = false;
            for k in 1..=order {
                let rate = self.rate(of, direction, k)?;
                moves |= rate.is_some();
                let shape = self
                    .law
                    .shape(of)
                    .expect("invariant: formulas have real inputs");
                bindings.insert(
                    format!("{input}.rate{k}"),
                    rate.map_or_else(|| zeros(shape), name),
                );
            }
            if moves {
                varying.push(input.clone());
            }
        }
        if varying.is_empty() {
            return Ok(None);
        }
        let program = self
            .partials
            .partials(&formula.program, &Job::Rates { order, varying })?;
        let tape = self.law.import(program, bindings);
        let output = format!("y.rate{order}");
        Ok(Some(self.named(
            quantity,
            direction,
            order,
            Term::Tape(tape, output).into(),
        )))
    }

    fn named(
        &mut self,
        quantity: &str,
        direction: &Direction,
        order: usize,
        rate: Symbol,
    ) -> String {
        if let Term::Name(existing) = rate.term() {
            return existing.clone();
        }
        let suffix = if order == 1 {
            String::new()
        } else {
            order.to_string()
        };
        let result = format!("{quantity}_{}{suffix}", direction.tag);
        self.law
            .define(result.clone(), direction.rate_text(quantity, order), rate);
        self.made.insert(
            result.clone(),
            (quantity.to_string(), direction.tag.clone(), order),
        );
        result
    }

    /// Derivative of a structural expression; `None` if it is zero.
    fn differentiate(
        &mut self,
        symbol: &Symbol,
        direction: &Direction,
    ) -> Result<Option<Symbol>, DeriveError> {
        let shape = self.law.shape_of(symbol);
        let mut d = |symbol: &Symbol| self.differentiate(symbol, direction);
        Ok(match symbol.term() {
            Term::Name(quantity) => self.rate(&quantity.clone(), direction, 1)?.map(name),
            Term::Literal(..) | Term::Diagonal(_) | Term::Constant(_) | Term::Parameter(..) => None,
            Term::SpectralSquare(a) => d(a)?.map(|da| spectral_square_rate(a, da)),
            Term::SingularVector(a) => d(a)?.map(|da| singular_vector_rate(a, da, shape)),
            Term::Apply(Function::Neg, a) => d(a)?.map(|a| -a),
            Term::Binary(Operator::Add, a, b) => sum(d(a)?, d(b)?),
            Term::Binary(Operator::Sub, a, b) => sum(d(a)?, d(b)?.map(|b| -b)),
            Term::Binary(Operator::Mul, a, b) => sum(
                d(a)?.map(|da| da * b.clone()),
                d(b)?.map(|db| a.clone() * db),
            ),
            Term::Binary(Operator::Div, a, b) => d(a)?.map(|da| da / b.clone()),
            Term::MatMul(a, b) => sum(
                d(a)?.map(|da| da.times(b.clone())),
                d(b)?.map(|db| a.clone().times(db)),
            ),
            Term::Outer(a, b) => sum(
                d(a)?.map(|da| da.outer(b.clone())),
                d(b)?.map(|db| a.clone().outer(db)),
            ),
            Term::Dot(a, b) => sum(
                d(a)?.map(|da| da.dot(b.clone())),
                d(b)?.map(|db| a.clone().dot(db)),
            ),
            Term::Transpose(a) => d(a)?.map(Symbol::transpose),
            Term::Trace(a) => d(a)?.map(|a| Term::Trace(a).into()),
            Term::Column(a, col) => d(a)?.map(|a| Term::Column(a, *col).into()),
            Term::Slice(a, first, length) => d(a)?.map(|a| Term::Slice(a, *first, *length).into()),
            // A x = b: x' = A^-1 (b' - A' x)
            Term::Solve(a, b) => {
                let moved = d(a)?.map(|da| -da.times(symbol.clone()));
                sum(d(b)?, moved).map(|rhs| a.clone().solve(rhs))
            }
            Term::Basis(block, z) => d(z)?.map(|dz| Term::BasisRate(*block, z.clone(), dz).into()),
            Term::BasisRate(block, z, dz) => {
                let ddz = self.differentiate(dz, direction)?;
                let still = || zeros(Shape::Vector(self.law.bases[block].inputs.len()));
                Some(
                    Term::BasisRate2(*block, z.clone(), dz.clone(), ddz.unwrap_or_else(still))
                        .into(),
                )
            }
            Term::BasisRate2(..) => return Err(DeriveError::NetworkOrder),
            Term::Stack(items) => {
                let mut rates = Vec::new();
                for item in items {
                    rates.push((item.clone(), self.differentiate(item, direction)?));
                }
                if rates.iter().all(|(_, rate)| rate.is_none()) {
                    return Ok(None);
                }
                let filled = rates.into_iter().map(|(item, rate)| {
                    let shape = self
                        .law
                        .shape_of(&item)
                        .expect("invariant: stacked values are real");
                    rate.unwrap_or_else(|| zeros(shape))
                });
                Some(Term::Stack(filled.collect()).into())
            }
            other => unreachable!("invariant: {other:?} is not structural"),
        })
    }
}

/// Whether an expression is made only of operations with their own rate rule.
fn is_structural(symbol: &Symbol) -> bool {
    let own = match symbol.term() {
        Term::Name(_)
        | Term::Literal(..)
        | Term::Diagonal(_)
        | Term::Constant(_)
        | Term::Parameter(..)
        | Term::SingularVector(_)
        | Term::SpectralSquare(_)
        | Term::Apply(Function::Neg, _)
        | Term::Binary(Operator::Add | Operator::Sub | Operator::Mul, ..)
        | Term::MatMul(..)
        | Term::Outer(..)
        | Term::Dot(..)
        | Term::Transpose(_)
        | Term::Trace(_)
        | Term::Column(..)
        | Term::Slice(..)
        | Term::Solve(..)
        | Term::Basis(..)
        | Term::BasisRate(..)
        | Term::BasisRate2(..)
        | Term::Stack(_) => true,
        Term::Binary(Operator::Div, _, b) => is_constant(b),
        _ => false,
    };
    own && symbol.operands().iter().all(is_structural)
}

fn is_constant(symbol: &Symbol) -> bool {
    matches!(
        symbol.term(),
        Term::Literal(..) | Term::Diagonal(_) | Term::Constant(_)
    ) || (!symbol.operands().is_empty() && symbol.operands().iter().all(is_constant))
}

fn sum(a: Option<Symbol>, b: Option<Symbol>) -> Option<Symbol> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a + b),
        (a, b) => a.or(b),
    }
}

/// Rate of lambda = ||A||^2 = v^T A^T A v with v of unit length: 2 (A v)^T A' v. The rate of v drops out.
fn spectral_square_rate(a: &Symbol, rate: Symbol) -> Symbol {
    let direction = Symbol::from(Term::SingularVector(a.clone()));
    number(2.0)
        * a.clone()
            .times(direction.clone())
            .dot(rate.times(direction))
}

/// Rate of v, the eigenvector of B = A^T A to its largest eigenvalue lambda: R v' = B' v - (v^T B' v) v with
/// R = lambda (I + v v^T) - B. Where another eigenvalue meets lambda, R is singular and the norm has a kink; there v' is taken
/// as 0 by solving (R R + d^2 I) v' = R (..), d = 1e-7 lambda, which costs a relative error of (d/gap)^2 elsewhere.
fn singular_vector_rate(a: &Symbol, rate: Symbol, size: Option<Shape>) -> Symbol {
    let Some(Shape::Vector(size)) = size else {
        unreachable!("invariant: a singular vector is a vector")
    };
    let v = Symbol::from(Term::SingularVector(a.clone()));
    let lambda = Symbol::from(Term::SpectralSquare(a.clone()));
    let squared = a.clone().transpose().times(a.clone());
    let squared_rate =
        rate.clone().transpose().times(a.clone()) + a.clone().transpose().times(rate);
    let turned = squared_rate.times(v.clone());
    let across = turned.clone() - v.clone().dot(turned) * v.clone();
    let diagonal = |at: usize| f64::from(u8::from(at.is_multiple_of(size + 1)));
    let identity = (0..size * size).map(diagonal).collect();
    let identity = Symbol::from(Term::Literal(Shape::Matrix(size, size), identity));
    let gap = lambda.clone() * (identity.clone() + v.clone().outer(v)) - squared;
    let floor = (number(1e-7) * lambda).pow(2) * identity;
    (gap.clone().times(gap.clone()) + floor).solve(gap.times(across))
}
