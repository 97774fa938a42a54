//! The surface syntax of one expression: what was written, with its places, before names and types.
//!
//! Nodes lie in one vector, operands before operators and the whole expression last, so that walks are loops and neither a
//! deep expression nor its destruction can exhaust the stack.

use super::arena::Comparison;
use crate::diagnostic::Span;
use crate::unit::Unit;

/// A node of an [`Expr`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub(super) u32);

/// A parsed expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    pub(super) nodes: Vec<Node>,
}

/// What was written at one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Where.
    pub span: Span,
    /// What.
    pub kind: Kind,
}

/// A number as written, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Literal {
    /// SI value, finite.
    pub value: f64,
    /// Its unit, if one was written.
    pub unit: Option<Unit>,
    /// The value of a literal written as plain digits, as exponents and indices must be.
    pub integer: Option<u32>,
}

/// Operators between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is the operator of that name")]
pub enum Infix {
    Or,
    And,
    Compare(Comparison),
    Add,
    Sub,
    Mul,
    Div,
    Pow,
}

/// A name at its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The name, with its dots.
    pub text: String,
    /// Where.
    pub span: Span,
}

/// Kinds of nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// `0.5 deg`
    Number(Literal),
    /// `alpha`
    Name(String),
    /// `-x`
    Negate(NodeId),
    /// `not c`
    Not(NodeId),
    /// `a + b`
    Infix(Infix, NodeId, NodeId),
    /// `sin(x)`, `if(c, a, b)`, `CL.alpha(x, y, z)`
    Call(Name, Vec<NodeId>),
    /// `partial(CL.RE, deflection_deg, x, y, z)`
    Partial {
        /// `CL.RE`
        polynomial: Name,
        /// `deflection_deg`
        argument: Name,
        /// Where the derivative is taken.
        at: Vec<NodeId>,
    },
    /// `[a, b]`
    Array(Vec<NodeId>),
    /// `v[1]`, `M[1, 2]`, 1-based
    Index(NodeId, Vec<u32>),
}

impl Expr {
    /// Every node, operands before operators.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// One node.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The whole expression.
    pub fn root(&self) -> &Node {
        self.nodes
            .last()
            .expect("invariant: the parser makes at least one node")
    }

    /// Place of the whole expression.
    pub fn span(&self) -> Span {
        self.root().span
    }

    /// SI value and unit of an expression that is but one number with or without a minus.
    pub fn as_literal(&self) -> Option<(f64, Option<&Unit>)> {
        match self.nodes.as_slice() {
            [
                Node {
                    kind: Kind::Number(literal),
                    ..
                },
            ] => Some((literal.value, literal.unit.as_ref())),
            [
                Node {
                    kind: Kind::Number(literal),
                    ..
                },
                Node {
                    kind: Kind::Negate(_),
                    ..
                },
            ] => Some((0.0 - literal.value, literal.unit.as_ref())),
            _ => None,
        }
    }

    /// Names used as values, with their places; functions and polynomial data that are called are not among them.
    pub fn free_names(&self) -> impl Iterator<Item = (&str, Span)> {
        self.nodes.iter().filter_map(|node| match &node.kind {
            Kind::Name(name) => Some((name.as_str(), node.span)),
            _ => None,
        })
    }
}
