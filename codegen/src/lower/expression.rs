//! Expressions of the specification to IR.

use nsv_spec::expr::arena::{ExprId, Node, Type as ExprType};

use super::{Context, Leaf, Lowering};
use crate::derive::symbol::Side;
use crate::derive::truth::TRUTH;
use crate::ir::{
    Op, Operator, Origin, PolynomialData, PolynomialId, Program, TableData, TableId, Type, ValueId,
};

impl<C: Context> Lowering<'_, '_, C> {
    /// The value of an expression with the parameters of one side.
    pub fn expression(&mut self, expr: ExprId, side: Side) -> ValueId {
        if let Some(&value) = self.expressions.get(&(expr, side)) {
            return value;
        }
        let value = self.node(expr, side);
        self.expressions.insert((expr, side), value);
        value
    }

    fn node(&mut self, expr: ExprId, side: Side) -> ValueId {
        let model = self.law.model;
        let mut lower = |operand: &ExprId| self.expression(*operand, side);
        let op = match model.exprs.node(expr) {
            Node::Number(bits) => {
                return self
                    .context
                    .spec_number(&mut self.program, f64::from_bits(bits.0));
            }
            Node::Constant(id) => return self.leaf(Leaf::Constant(*id), side),
            Node::Parameter(id) => return self.leaf(Leaf::Parameter(*id), side),
            Node::State { block, channel } => {
                let state = self.quantity(&format!("x{}", block + 1));
                let value = self.program.push(Op::Element(state, *channel, 0));
                let channel = &model.blocks[*block].states[*channel];
                return self.named(value, &channel.name);
            }
            Node::Truth(at) => {
                let states = self.quantity(TRUTH);
                let value = self.program.push(Op::Element(states, *at, 0));
                let states = model.truth.as_ref().map(|truth| &truth.states[*at]);
                let state = states.expect("invariant: a further state belongs to a truth");
                return self.named(value, &state.name);
            }
            Node::Input(at) => {
                let inputs = self.quantity("u_sat");
                let value = self.program.push(Op::Element(inputs, *at, 0));
                return self.named(value, &model.inputs[*at].name);
            }
            Node::Time => return self.quantity("t"),
            Node::Definition(id) => {
                let definition = &model.definitions[id.0 as usize];
                let value = self.expression(definition.expr, side);
                return self.named(value, &definition.name);
            }
            Node::Apply(function, a) => Op::Apply(*function, lower(a)),
            Node::Binary(operator, a, b) => Op::Binary(*operator, lower(a), lower(b)),
            Node::PowInt(a, exponent) => {
                let base = lower(a);
                return self.power(base, *exponent);
            }
            Node::Compare(comparison, a, b) => Op::Compare(*comparison, lower(a), lower(b)),
            Node::And(a, b) => Op::And(lower(a), lower(b)),
            Node::Or(a, b) => Op::Or(lower(a), lower(b)),
            Node::Not(a) => Op::Not(lower(a)),
            Node::If(c, a, b) => Op::Select(lower(c), lower(a), lower(b)),
            Node::Array(items) => {
                let items = items.iter().map(lower).collect();
                let ExprType::Real { shape, .. } = model.exprs.ty(expr) else {
                    unreachable!("invariant: arrays are real")
                };
                return self.program.array(*shape, items);
            }
            Node::Element(a, row, col) => Op::Element(lower(a), *row, *col),
            Node::MatMul(a, b) => Op::MatMul(lower(a), lower(b)),
            Node::Transpose(a) => Op::Transpose(lower(a)),
            Node::Dot(a, b) => Op::Dot(lower(a), lower(b)),
            Node::Solve(a, b) => Op::Solve(lower(a), lower(b)),
            Node::Cross(a, b) => {
                let (a, b) = (lower(a), lower(b));
                return self.cross(a, b);
            }
            Node::Polynomial(id, arguments) => {
                let arguments = arguments.iter().map(lower).collect();
                let data = &model.polynomials[id.0 as usize];
                let data = PolynomialData {
                    name: data.name.replace('.', "_"),
                    arguments: data.arguments.clone(),
                    terms: data.terms.clone(),
                };
                Op::Polynomial(intern(&mut self.program, data), arguments)
            }
            Node::Table(id, orders, arguments) => {
                let arguments = arguments.iter().map(lower).collect();
                let table = &model.tables[id.0 as usize];
                let data = TableData {
                    name: table.name.clone(),
                    arguments: table
                        .arguments
                        .iter()
                        .map(|(name, _)| name.clone())
                        .collect(),
                    interpolant: table.interpolant.clone(),
                };
                let id = intern_table(&mut self.program, &data);
                Op::Table(id, orders.clone(), arguments)
            }
        };
        self.program.push(op)
    }

    /// A constant or parameter.
    pub(super) fn leaf(&mut self, leaf: Leaf, side: Side) -> ValueId {
        let side = if matches!(leaf, Leaf::Constant(_)) {
            Side::Design
        } else {
            side
        };
        if let Some(&value) = self.leaves.get(&(leaf, side)) {
            return value;
        }
        let value = match leaf {
            Leaf::Constant(id) => self.context.constant(&mut self.program, id),
            Leaf::Parameter(id) => self.context.parameter(&mut self.program, id, side),
        };
        self.leaves.insert((leaf, side), value);
        value
    }

    /// Names a value of the plant model.
    fn named(&mut self, value: ValueId, name: &str) -> ValueId {
        self.label(
            value,
            name,
            &Origin {
                group: "plant model".into(),
                equation: String::new(),
            },
        );
        value
    }

    /// Integer power; negative ones divide 1 by the positive power.
    fn power(&mut self, base: ValueId, exponent: i32) -> ValueId {
        let positive = match exponent.unsigned_abs() {
            0 => self.program.scalar(1.0),
            1 => base,
            n => self.program.push(Op::PowInt(base, n)),
        };
        if exponent >= 0 {
            return positive;
        }
        let one = self.program.scalar(1.0);
        self.program.binary(Operator::Div, one, positive)
    }

    fn cross(&mut self, a: ValueId, b: ValueId) -> ValueId {
        let entry =
            |this: &mut Self, v: ValueId, at: usize| this.program.push(Op::Element(v, at, 0));
        let mut items = Vec::new();
        for (first, second) in [(1, 2), (2, 0), (0, 1)] {
            let (a1, b2) = (entry(self, a, first), entry(self, b, second));
            let (a2, b1) = (entry(self, a, second), entry(self, b, first));
            let left = self.program.binary(Operator::Mul, a1, b2);
            let right = self.program.binary(Operator::Mul, a2, b1);
            items.push(self.program.binary(Operator::Sub, left, right));
        }
        let Type::Real(shape) = self.program.ty(a) else {
            unreachable!("invariant: cross products are real")
        };
        self.program.array(shape, items)
    }
}

/// Adds polynomial data to a program unless it is there.
pub(super) fn intern(program: &mut Program, data: PolynomialData) -> PolynomialId {
    let known = program.polynomials.iter().position(|known| *known == data);
    let at = known.unwrap_or_else(|| {
        program.polynomials.push(data);
        program.polynomials.len() - 1
    });
    PolynomialId(u32::try_from(at).expect("invariant: fewer than 2^32 polynomials"))
}

/// Adds a table to a program unless it is there.
pub(super) fn intern_table(program: &mut Program, data: &TableData) -> TableId {
    let known = program.tables.iter().position(|known| known == data);
    let at = known.unwrap_or_else(|| {
        program.tables.push(data.clone());
        program.tables.len() - 1
    });
    TableId(u32::try_from(at).expect("invariant: fewer than 2^32 tables"))
}
