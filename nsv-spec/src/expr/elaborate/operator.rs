//! Operators.

use super::typing;
use super::{
    Bits, Elaborator, ExprId, Fault, Function, Kind, Node, NodeId, Operator, Real, Shape, Span,
    Type,
};
use crate::diagnostic::Rule;
use crate::expr::arena::Comparison;
use crate::expr::syntax::Infix;
use crate::unit::Dimension;

impl Elaborator<'_> {
    /// `-x`; of a literal, the negative literal.
    pub(super) fn negate(&mut self, operand: NodeId) -> Option<ExprId> {
        let (id, real) = self.real(operand, "the operand of `-`")?;
        if let Node::Number(Bits(bits)) = *self.arena.node(id) {
            // 0 stays as it is: the sign of a zero has no place in a specification.
            let value = 0.0 - f64::from_bits(bits);
            return Some(self.literal(value, real.dimensions[0]));
        }
        Some(
            self.arena
                .intern(Node::Apply(Function::Neg, id), real.into()),
        )
    }

    /// `not c`
    pub(super) fn not(&mut self, operand: NodeId) -> Option<ExprId> {
        let id = self.truth(operand, "the operand of `not`")?;
        Some(self.arena.intern(Node::Not(id), Type::Bool))
    }

    /// `a + b` and so on.
    pub(super) fn infix(
        &mut self,
        span: Span,
        infix: Infix,
        left: NodeId,
        right: NodeId,
    ) -> Option<ExprId> {
        match infix {
            Infix::And => self.logical("and", left, right, Node::And),
            Infix::Or => self.logical("or", left, right, Node::Or),
            Infix::Compare(comparison) => self.compare(span, comparison, left, right),
            Infix::Add => self.sum(span, "+", Operator::Add, left, right),
            Infix::Sub => self.sum(span, "-", Operator::Sub, left, right),
            Infix::Mul => self.multiply(span, left, right),
            Infix::Div => {
                let ((a, x), (b, y)) = self.reals("/", left, right)?;
                self.typed(
                    span,
                    Node::Binary(Operator::Div, a, b),
                    typing::quotient(&x, &y),
                    &[left, right],
                )
            }
            Infix::Pow => self.power(span, left, right),
        }
    }

    fn logical(
        &mut self,
        symbol: &str,
        left: NodeId,
        right: NodeId,
        node: fn(ExprId, ExprId) -> Node,
    ) -> Option<ExprId> {
        let what = format!("an operand of `{symbol}`");
        let (a, b) = (self.truth(left, &what), self.truth(right, &what));
        Some(self.arena.intern(node(a?, b?), Type::Bool))
    }

    fn compare(
        &mut self,
        span: Span,
        comparison: Comparison,
        left: NodeId,
        right: NodeId,
    ) -> Option<ExprId> {
        let symbol = match comparison {
            Comparison::Lt => "<",
            Comparison::Le => "<=",
            Comparison::Gt => ">",
            Comparison::Ge => ">=",
            Comparison::Eq => "==",
            Comparison::Ne => "!=",
        };
        let ((a, x), (b, y)) = self.reals(symbol, left, right)?;
        if let Some(array) = [&x, &y]
            .into_iter()
            .find(|real| real.shape != Shape::Scalar)
        {
            let message = format!(
                "shape mismatch: `{symbol}` on {}, expected scalars",
                array.shape
            );
            return self.report(
                span,
                Fault::new(Rule::E0501, message, "compare entries or norms"),
                &[left, right],
            );
        }
        match typing::agreeing(symbol, &x, &y) {
            Ok(_) => Some(
                self.arena
                    .intern(Node::Compare(comparison, a, b), Type::Bool),
            ),
            Err(fault) => self.report(span, fault, &[left, right]),
        }
    }

    fn sum(
        &mut self,
        span: Span,
        symbol: &str,
        operator: Operator,
        left: NodeId,
        right: NodeId,
    ) -> Option<ExprId> {
        let ((a, x), (b, y)) = self.reals(symbol, left, right)?;
        self.typed(
            span,
            Node::Binary(operator, a, b),
            typing::agreeing(symbol, &x, &y),
            &[left, right],
        )
    }

    fn multiply(&mut self, span: Span, left: NodeId, right: NodeId) -> Option<ExprId> {
        let ((a, x), (b, y)) = self.reals("*", left, right)?;
        let (node, ty) = match (x.shape, y.shape) {
            (Shape::Matrix(..), Shape::Matrix(..) | Shape::Vector(_)) => {
                (Node::MatMul(a, b), typing::matrix_product(&x, &y))
            }
            (Shape::Vector(_), Shape::Matrix(..)) => {
                let message = format!("shape mismatch: product of {} and {}", x.shape, y.shape);
                let fault = Fault::new(
                    Rule::E0501,
                    message,
                    "vectors are columns: write `transpose(M)*v`",
                );
                return self.report(span, fault, &[left, right]);
            }
            _ => (Node::Binary(Operator::Mul, a, b), typing::product(&x, &y)),
        };
        self.typed(span, node, ty, &[left, right])
    }

    /// `x^n`: products for a whole literal, else the real power of pure numbers.
    pub(super) fn power(&mut self, span: Span, base: NodeId, exponent: NodeId) -> Option<ExprId> {
        let ((a, x), (b, y)) = self.reals("^", base, exponent)?;
        let Some(whole) = self.whole_literal(exponent) else {
            return self.typed(
                span,
                Node::Binary(Operator::Pow, a, b),
                typing::real_power(&x, &y),
                &[base],
            );
        };
        let positive = match typing::power(&x, whole.abs()) {
            Ok(ty) => self.products(a, whole.abs(), ty),
            Err(fault) => return self.report(span, fault, &[base]),
        };
        if whole >= 0 {
            return Some(positive);
        }
        let one = self.literal(1.0, Dimension::ONE);
        let denominator = match typing::power(&x, -whole) {
            Ok(ty) => ty,
            Err(fault) => return self.report(span, fault, &[base]),
        };
        let ty = typing::quotient(&Real::scalar(Dimension::ONE), &denominator);
        self.typed(
            span,
            Node::Binary(Operator::Div, one, positive),
            ty,
            &[base],
        )
    }

    /// x^n for n >= 0, without trivial powers.
    fn products(&mut self, base: ExprId, exponent: i32, ty: Real) -> ExprId {
        match exponent {
            0 => self.literal(1.0, Dimension::ONE),
            1 => base,
            _ => self.arena.intern(Node::PowInt(base, exponent), ty.into()),
        }
    }

    /// The value of a node that is written as a whole number, with or without a minus.
    fn whole_literal(&self, node: NodeId) -> Option<i32> {
        let integer = |node: NodeId| match &self.expr.node(node).kind {
            Kind::Number(literal) => literal
                .integer
                .and_then(|integer| i32::try_from(integer).ok()),
            _ => None,
        };
        match &self.expr.node(node).kind {
            Kind::Negate(operand) => integer(*operand).map(|whole| -whole),
            _ => integer(node),
        }
    }

    /// Both operands of an operator on numbers; faults of both are reported.
    pub(super) fn reals(
        &mut self,
        symbol: &str,
        left: NodeId,
        right: NodeId,
    ) -> Option<((ExprId, Real), (ExprId, Real))> {
        let what = format!("an operand of `{symbol}`");
        let (left, right) = (self.real(left, &what), self.real(right, &what));
        Some((left?, right?))
    }
}
