//! Lowering: from the symbolic law to SSA programs.
//!
//! One walk serves the emitted programs and the formulas sent to CasADi; a [`Context`] decides what a leaf becomes.

mod expression;
mod frame;
mod programs;
mod symbol;
mod tape;

use std::collections::{BTreeMap, BTreeSet};

use nsv_spec::expr::arena::{ConstantId, ExprId, ParameterId};

pub use frame::{Frame, program};
pub use programs::Programs;

use crate::derive::law::Law;
use crate::derive::symbol::{Side, Symbol, TapeId};
use crate::ir::{Op, Origin, Program, Shape, ValueId};

/// What becomes of a leaf.
pub(crate) trait Context {
    /// A quantity that is not to be lowered from its equation; `None` lowers the equation.
    fn quantity(&mut self, program: &mut Program, quantity: &str) -> Option<ValueId>;
    /// A gain or a number of the law.
    fn literal(&mut self, program: &mut Program, shape: Shape, data: &[f64]) -> ValueId;
    /// A diagonal gain.
    fn diagonal(&mut self, program: &mut Program, values: &[f64]) -> ValueId;
    /// A number in an expression of the specification.
    fn spec_number(&mut self, program: &mut Program, value: f64) -> ValueId;
    /// A constant of the specification.
    fn constant(&mut self, program: &mut Program, id: ConstantId) -> ValueId;
    /// A parameter of the specification.
    fn parameter(&mut self, program: &mut Program, id: ParameterId, side: Side) -> ValueId;
}

/// A walk over the law that appends to one program; each quantity, expression and tape is lowered once.
pub(crate) struct Lowering<'l, 'm, C> {
    law: &'l Law<'m>,
    program: Program,
    context: C,
    quantities: BTreeMap<String, ValueId>,
    expressions: BTreeMap<(ExprId, Side), ValueId>,
    leaves: BTreeMap<(Leaf, Side), ValueId>,
    tapes: BTreeMap<TapeId, BTreeMap<String, ValueId>>,
    origins: BTreeMap<(String, String), usize>,
    names: BTreeSet<String>,
    replaced: BTreeMap<String, Symbol>,
}

/// Constants and parameters, lowered once each.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Leaf {
    Constant(ConstantId),
    Parameter(ParameterId),
}

impl<'l, 'm, C: Context> Lowering<'l, 'm, C> {
    /// A walk that starts with an empty program.
    pub fn new(law: &'l Law<'m>, context: C) -> Self {
        Self {
            law,
            program: Program::default(),
            context,
            quantities: BTreeMap::new(),
            expressions: BTreeMap::new(),
            leaves: BTreeMap::new(),
            tapes: BTreeMap::new(),
            origins: BTreeMap::new(),
            names: BTreeSet::new(),
            replaced: BTreeMap::new(),
        }
    }

    /// The program and the context.
    pub fn finish(self) -> (Program, C) {
        (self.program, self.context)
    }

    /// The value of a quantity, from the context or from its equation.
    pub fn quantity(&mut self, quantity: &str) -> ValueId {
        if let Some(&value) = self.quantities.get(quantity) {
            return value;
        }
        let value = match self.context.quantity(&mut self.program, quantity) {
            Some(value) => value,
            None => {
                let law = self.law;
                let equation = law.equation(quantity);
                let replaced = self.replaced.get(quantity).cloned();
                let rhs = replaced.or_else(|| equation.map(|equation| equation.rhs.clone()));
                let rhs =
                    rhs.unwrap_or_else(|| panic!("invariant: `{quantity}` is defined or an input"));
                let value = self.symbol(&rhs);
                let given = || Origin {
                    group: "given".into(),
                    equation: String::new(),
                };
                let origin = equation.map_or_else(given, |equation| equation.origin.clone());
                self.label(value, quantity, &origin);
                value
            }
        };
        self.quantities.insert(quantity.to_string(), value);
        value
    }

    /// Names a value after its signal, unless the value has a name or the name is taken (the same definition with the parameters
    /// of the other side, or a state called `x` as the packed states are).
    fn label(&mut self, value: ValueId, name: &str, origin: &Origin) {
        let instruction = &self.program.instructions[value.0 as usize];
        let anonymous = instruction.name.is_none() && !matches!(instruction.op, Op::Input(_));
        let taken = self.program.inputs.iter().any(|input| input.name == name);
        if !anonymous || taken || !self.names.insert(name.to_string()) {
            return;
        }
        let key = (origin.group.clone(), origin.equation.clone());
        let next = self.program.origins.len();
        let at = *self.origins.entry(key).or_insert(next);
        if at == next {
            self.program.origins.push(origin.clone());
        }
        let instruction = &mut self.program.instructions[value.0 as usize];
        instruction.name = Some(name.to_string());
        instruction.origin = Some(at);
    }
}
