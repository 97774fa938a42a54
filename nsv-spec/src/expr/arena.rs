//! Typed, dimension-checked, hash-consed expressions: what the phases after the check work on. Every number is in SI.

use std::collections::HashMap;
use std::fmt;

use crate::unit::Dimension;

/// An expression in an [`Arena`]. Equal expressions have equal ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExprId(pub u32);

/// Index into `Model::constants`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ConstantId(pub u32);
/// Index into `Model::parameters`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ParameterId(pub u32);
/// Index into `Model::definitions`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DefinitionId(pub u32);
/// Index into `Model::polynomials`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PolynomialId(pub u32);

/// Index into `Model::tables`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableId(pub u32);

/// Shape of a value. Vectors are columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shape {
    /// One number.
    Scalar,
    /// Column vector of that many rows (at least 1).
    Vector(usize),
    /// Rows by columns.
    Matrix(usize, usize),
}

impl Shape {
    /// Number of entries.
    pub fn entries(self) -> usize {
        match self {
            Shape::Scalar => 1,
            Shape::Vector(rows) => rows,
            Shape::Matrix(rows, cols) => rows * cols,
        }
    }

    /// Rows and columns; a scalar has one of each, a vector one column.
    pub fn size(self) -> (usize, usize) {
        match self {
            Shape::Scalar => (1, 1),
            Shape::Vector(rows) => (rows, 1),
            Shape::Matrix(rows, cols) => (rows, cols),
        }
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Shape::Scalar => f.write_str("a scalar"),
            Shape::Vector(1) => f.write_str("a vector of one entry"),
            Shape::Vector(rows) => write!(f, "a vector of {rows}"),
            Shape::Matrix(rows, cols) => write!(f, "a {rows} x {cols} matrix"),
        }
    }
}

/// A finite `f64` compared by bits, so that expressions can be hashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bits(pub u64);

/// Elementwise functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the function of that name")]
pub enum Function {
    Neg,
    Abs,
    Sign,
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
}

/// Operators of two arguments; elementwise, a scalar operand is broadcast.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the operator of that name")]
pub enum Operator {
    Add,
    Sub,
    Mul,
    Div,
    Pow,
    Min,
    Max,
    Atan2,
}

/// Comparisons of scalars.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the comparison of that name")]
pub enum Comparison {
    Lt,
    Le,
    Gt,
    Ge,
    Eq,
    Ne,
}

/// One expression node; operands are earlier nodes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// Literal in SI.
    Number(Bits),
    /// Named compile-time constant.
    Constant(ConstantId),
    /// Named run-time parameter.
    Parameter(ParameterId),
    /// Channel (0-based) of the state of a block (0-based).
    State {
        /// Block.
        block: usize,
        /// Channel.
        channel: usize,
    },
    /// Further state (0-based) of the flown plant.
    Truth(usize),
    /// Control input (0-based) as it reaches the flown plant.
    Input(usize),
    /// Time since start, s.
    Time,
    /// Named definition; its expression is `Model::definitions[id].expr`.
    Definition(DefinitionId),
    /// Elementwise function.
    Apply(Function, ExprId),
    /// Elementwise operator with scalar broadcast.
    Binary(Operator, ExprId, ExprId),
    /// Integer power of a scalar, at least 2, by multiplication; x^-n is 1 / x^n.
    PowInt(ExprId, i32),
    /// Comparison of scalars.
    Compare(Comparison, ExprId, ExprId),
    /// Both.
    And(ExprId, ExprId),
    /// Either.
    Or(ExprId, ExprId),
    /// Negation of a truth value.
    Not(ExprId),
    /// Condition, value if true, value if false; both of one shape.
    If(ExprId, ExprId, ExprId),
    /// Array of scalar entries in row-major order; the shape is in the type.
    Array(Vec<ExprId>),
    /// Entry (row, column), 0-based; column 0 for vectors.
    Element(ExprId, usize, usize),
    /// Matrix product (matrix * matrix or matrix * vector).
    MatMul(ExprId, ExprId),
    /// Transpose.
    Transpose(ExprId),
    /// Inner product of two vectors.
    Dot(ExprId, ExprId),
    /// Cross product of two 3-vectors.
    Cross(ExprId, ExprId),
    /// Solution x of A x = b, for a square matrix A and a vector or matrix b.
    Solve(ExprId, ExprId),
    /// Polynomial data block applied to scalar arguments.
    Polynomial(PolynomialId, Vec<ExprId>),
    /// Derivative of a lookup table, so many times by each argument, at scalar arguments.
    Table(TableId, Vec<u32>, Vec<ExprId>),
}

impl Node {
    /// Operands, in order.
    pub fn operands(&self) -> Vec<ExprId> {
        match self {
            Node::Number(_)
            | Node::Constant(_)
            | Node::Parameter(_)
            | Node::State { .. }
            | Node::Truth(_)
            | Node::Input(_)
            | Node::Time
            | Node::Definition(_) => Vec::new(),
            Node::Apply(_, a)
            | Node::PowInt(a, _)
            | Node::Not(a)
            | Node::Element(a, _, _)
            | Node::Transpose(a) => vec![*a],
            Node::Binary(_, a, b)
            | Node::Compare(_, a, b)
            | Node::And(a, b)
            | Node::Or(a, b)
            | Node::MatMul(a, b)
            | Node::Dot(a, b)
            | Node::Cross(a, b)
            | Node::Solve(a, b) => vec![*a, *b],
            Node::If(a, b, c) => vec![*a, *b, *c],
            Node::Array(items) | Node::Polynomial(_, items) | Node::Table(_, _, items) => {
                items.clone()
            }
        }
    }
}

/// Type of an expression: a truth value, or real entries in row-major order, each with its own physical dimension
/// ([`Dimension::ANY`] for an entry that is 0 by its form).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// Truth value of a comparison.
    Bool,
    /// Real scalar or array.
    Real {
        /// Shape.
        shape: Shape,
        /// Dimension of each entry, row-major.
        dimensions: Vec<Dimension>,
    },
}

impl Type {
    /// A scalar of that dimension.
    pub fn scalar(dimension: Dimension) -> Self {
        Type::Real {
            shape: Shape::Scalar,
            dimensions: vec![dimension],
        }
    }

    /// An array whose entries all have one dimension.
    pub fn uniform(shape: Shape, dimension: Dimension) -> Self {
        Type::Real {
            shape,
            dimensions: vec![dimension; shape.entries()],
        }
    }

    /// The dimension that all entries share, [`Dimension::ANY`] if all are 0; `None` if they differ or for a truth value.
    pub fn dimension(&self) -> Option<Dimension> {
        match self {
            Type::Bool => None,
            Type::Real { dimensions, .. } => dimensions
                .iter()
                .try_fold(Dimension::ANY, |all, &one| all.agree(one)),
        }
    }
}

/// All expressions of a model, each stored once.
#[derive(Clone, Debug, Default)]
pub struct Arena {
    nodes: Vec<Node>,
    types: Vec<Type>,
    // By node and type, since `0` and `0 m` are one number and two arrays of the same entries can differ in shape.
    // Looked up only, never iterated.
    index: HashMap<(Node, Type), ExprId>,
}

impl Arena {
    /// The node of an expression.
    pub fn node(&self, id: ExprId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The type of an expression.
    pub fn ty(&self, id: ExprId) -> &Type {
        &self.types[id.0 as usize]
    }

    /// The shape of an expression; `None` for a truth value.
    pub fn shape(&self, id: ExprId) -> Option<Shape> {
        match self.ty(id) {
            Type::Bool => None,
            Type::Real { shape, .. } => Some(*shape),
        }
    }

    /// Number of expressions; ids are 0 up to it.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no expression.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The id of `node`, which is stored if it is new. The caller has checked its type.
    pub(crate) fn intern(&mut self, node: Node, ty: Type) -> ExprId {
        let key = (node, ty);
        if let Some(&id) = self.index.get(&key) {
            return id;
        }
        let id = ExprId(
            u32::try_from(self.nodes.len()).expect("invariant: fewer than 2^32 expressions"),
        );
        self.nodes.push(key.0.clone());
        self.types.push(key.1.clone());
        self.index.insert(key, id);
        id
    }
}
