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

impl NodeId {
    /// Its index among the nodes of its expression.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

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
    /// `v[1]`, `M[i, i + 1]`, 1-based
    Index(NodeId, Vec<Index>),
    /// `each(i, 1, 3, body)`
    Each {
        /// `i`
        counter: Name,
        /// First and last value of the counter.
        range: (u32, u32),
        /// What each entry is.
        body: Box<Expr>,
    },
}

impl Kind {
    /// The nodes that it is made of; the body of an `each` is an expression of its own.
    pub fn operands(&self) -> Vec<NodeId> {
        match self {
            Kind::Number(_) | Kind::Name(_) | Kind::Each { .. } => Vec::new(),
            Kind::Negate(operand) | Kind::Not(operand) | Kind::Index(operand, _) => vec![*operand],
            Kind::Infix(_, left, right) => vec![*left, *right],
            Kind::Call(_, operands) | Kind::Array(operands) => operands.clone(),
            Kind::Partial { at, .. } => at.clone(),
        }
    }
}

/// One index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Index {
    /// The counter of a loop, if it is relative to one.
    pub counter: Option<Name>,
    /// The index, or what is added to the counter.
    pub offset: i64,
    /// Where.
    pub span: Span,
}

impl Expr {
    /// Every node, operands before operators.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The part of it that ends with the node of that index, as an expression of its own.
    pub fn part(&self, at: usize) -> Expr {
        Expr {
            nodes: self.nodes[..=at].to_vec(),
        }
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

    /// Names used as values, with their places; functions and data that are called are not among them, nor are counters where they
    /// count.
    pub fn free_names(&self) -> Vec<(&str, Span)> {
        self.collect(&|kind| match kind {
            Kind::Name(name) => Some(name),
            _ => None,
        })
    }

    /// Names of functions and data that are called, with the places of the calls.
    pub fn called_names(&self) -> Vec<(&str, Span)> {
        self.collect(&|kind| match kind {
            Kind::Call(name, _) => Some(&name.text),
            Kind::Partial { polynomial, .. } => Some(&polynomial.text),
            _ => None,
        })
    }

    fn collect(&self, of: &dyn Fn(&Kind) -> Option<&String>) -> Vec<(&str, Span)> {
        let mut names = Vec::new();
        for node in &self.nodes {
            // Bodies are nested no deeper than brackets may be.
            if let Kind::Each { counter, body, .. } = &node.kind {
                let inner = body.collect(of).into_iter();
                names.extend(inner.filter(|(name, _)| *name != counter.text));
            }
            names.extend(of(&node.kind).map(|name| (name.as_str(), node.span)));
        }
        names
    }
}
