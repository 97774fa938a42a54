//! One right-hand side as a program of its own, every quantity and every number an input: what CasADi differentiates.
//!
//! Inputs are named by position (`q0`, `q1`, .. quantities, `n0`, .. numbers), so that equal formulas of different blocks and
//! specifications ask for the same partials, and a changed number asks for none.

use std::collections::{BTreeMap, BTreeSet};

use nsv_spec::expr::arena::{ConstantId, ExprId, Node, ParameterId};

use super::law::Law;
use super::symbol::{Side, Symbol, Term, name};
use super::truth::TRUTH;
use crate::ir::{Input, Op, Program, Shape, ValueId};
use crate::lower::{Context, Lowering};

/// A formula with what its inputs stand for.
pub(crate) struct Formula {
    /// Program with one output `y`.
    pub program: Program,
    /// Input name and its symbol, numbers and quantities.
    pub bindings: BTreeMap<String, Symbol>,
    /// Input name and quantity, quantities only.
    pub quantities: Vec<(String, String)>,
}

/// Lowering context in which every leaf becomes an input.
struct Abstraction<'l, 'm> {
    law: &'l Law<'m>,
    bindings: BTreeMap<String, Symbol>,
    quantities: Vec<(String, String)>,
    numbers: usize,
}

impl Formula {
    /// The formula of a quantity's right-hand side.
    pub fn of(law: &Law, quantity: &str, rhs: &Symbol) -> Self {
        let context = Abstraction {
            law,
            bindings: BTreeMap::new(),
            quantities: Vec::new(),
            numbers: 0,
        };
        let mut lowering = Lowering::new(law, context);
        let y = lowering.symbol(rhs);
        let (mut program, context) = lowering.finish();
        program.name = quantity.into();
        program.outputs.push(("y".into(), y));
        Self {
            program,
            bindings: context.bindings,
            quantities: context.quantities,
        }
    }
}

impl Abstraction<'_, '_> {
    fn input(
        &mut self,
        program: &mut Program,
        input: String,
        shape: Shape,
        binding: Symbol,
    ) -> ValueId {
        self.bindings.insert(input.clone(), binding);
        program.inputs.push(Input { name: input, shape });
        program.push(Op::Input(program.inputs.len() - 1))
    }

    fn number(&mut self, program: &mut Program, shape: Shape, binding: Symbol) -> ValueId {
        self.numbers += 1;
        self.input(program, format!("n{}", self.numbers - 1), shape, binding)
    }
}

impl Context for Abstraction<'_, '_> {
    fn quantity(&mut self, program: &mut Program, quantity: &str) -> Option<ValueId> {
        let shape = self
            .law
            .shape(quantity)
            .expect("invariant: formulas have real inputs");
        let input = format!("q{}", self.quantities.len());
        self.quantities.push((input.clone(), quantity.to_string()));
        Some(self.input(program, input, shape, name(quantity)))
    }

    fn literal(&mut self, program: &mut Program, shape: Shape, data: &[f64]) -> ValueId {
        self.number(program, shape, Term::Literal(shape, data.to_vec()).into())
    }

    fn diagonal(&mut self, program: &mut Program, values: &[f64]) -> ValueId {
        // Always a vector, so that making a gain differ between channels asks for nothing new.
        let shape = Shape::Vector(values.len());
        self.number(program, shape, Term::Literal(shape, values.to_vec()).into())
    }

    fn spec_number(&mut self, program: &mut Program, value: f64) -> ValueId {
        if value == 0.0 || value.abs() == 1.0 {
            program.scalar(value)
        } else {
            self.literal(program, Shape::Scalar, &[value])
        }
    }

    fn constant(&mut self, program: &mut Program, id: ConstantId) -> ValueId {
        let symbol = Symbol::from(Term::Constant(id));
        let shape = self
            .law
            .shape_of(&symbol)
            .expect("invariant: constants are real");
        self.number(program, shape, symbol)
    }

    fn parameter(&mut self, program: &mut Program, id: ParameterId, side: Side) -> ValueId {
        self.number(program, Shape::Scalar, Term::Parameter(id, side).into())
    }
}

impl Law<'_> {
    /// Leaves and controller states that a quantity depends on.
    pub(crate) fn leaves_of(&self, quantity: &str) -> BTreeSet<String> {
        let (mut leaves, mut seen) = (BTreeSet::new(), BTreeSet::new());
        let mut pending = vec![quantity.to_string()];
        while let Some(quantity) = pending.pop() {
            if !seen.insert(quantity.clone()) {
                continue;
            }
            match self.equation(&quantity) {
                Some(equation) => self.names_in(&equation.rhs, &mut pending),
                None => drop(leaves.insert(quantity)),
            }
        }
        leaves
    }

    /// Quantities and leaves that an expression refers to.
    pub(crate) fn names_in(&self, symbol: &Symbol, names: &mut Vec<String>) {
        match symbol.term() {
            Term::Name(quantity) => names.push(quantity.clone()),
            Term::Model(expr, _) => self.leaves_in(*expr, names),
            Term::Tape(tape, _) => self.tapes[tape.0]
                .bindings
                .values()
                .for_each(|binding| self.names_in(binding, names)),
            _ => symbol
                .operands()
                .iter()
                .for_each(|operand| self.names_in(operand, names)),
        }
    }

    fn leaves_in(&self, expr: ExprId, names: &mut Vec<String>) {
        let mut seen = BTreeSet::new();
        let mut pending = vec![expr];
        while let Some(expr) = pending.pop() {
            if !seen.insert(expr) {
                continue;
            }
            match self.model.exprs.node(expr) {
                Node::State { block, .. } => names.push(format!("x{}", block + 1)),
                Node::Truth(_) => names.push(TRUTH.into()),
                Node::Input(_) => names.push("u_sat".into()),
                Node::Time => names.push("t".into()),
                Node::Definition(id) => pending.push(self.model.definitions[id.0 as usize].expr),
                node => pending.extend(node.operands()),
            }
        }
    }
}
