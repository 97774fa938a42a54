//! Typed, dimension-checked, hash-consed expressions: what the phases after the check work on. Every number is in SI.

use std::collections::HashMap;

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

/// A finite `f64` compared by bits, so that expressions can be hashed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bits(pub u64);

/// Elementwise functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the function of that name")]
pub enum Function {
    Neg, Abs, Sign, Sqrt, Exp, Ln, Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh,
}

/// Operators of two arguments; elementwise, a scalar operand is broadcast.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the operator of that name")]
pub enum Operator {
    Add, Sub, Mul, Div, Pow, Min, Max, Atan2,
}

/// Comparisons of scalars.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each is the comparison of that name")]
pub enum Comparison {
    Lt, Le, Gt, Ge, Eq, Ne,
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
    /// Time since start, s.
    Time,
    /// Named definition; its expression is `Model::definitions[id].expr`.
    Definition(DefinitionId),
    /// Elementwise function.
    Apply(Function, ExprId),
    /// Elementwise operator with scalar broadcast.
    Binary(Operator, ExprId, ExprId),
    /// Integer power of a scalar, by multiplication.
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
    /// Polynomial data block applied to scalar arguments.
    Polynomial(PolynomialId, Vec<ExprId>),
}

/// Type of an expression: a truth value, or real entries in row-major order, each with its own physical dimension.
#[derive(Clone, Debug, PartialEq, Eq)]
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

/// All expressions of a model, each stored once.
#[derive(Clone, Debug, Default)]
pub struct Arena {
    nodes: Vec<Node>,
    types: Vec<Type>,
    index: HashMap<Node, ExprId>, // looked up only, never iterated
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
        if let Some(&id) = self.index.get(&node) {
            return id;
        }
        let id = ExprId(u32::try_from(self.nodes.len()).expect("invariant: fewer than 2^32 expressions"));
        self.index.insert(node.clone(), id);
        self.nodes.push(node);
        self.types.push(ty);
        id
    }
}
