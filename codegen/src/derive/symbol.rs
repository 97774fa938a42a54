//! Symbolic array expressions in which the equations of the law are written down.
//!
//! A [`Symbol`] refers to other quantities by name, to the plant's expressions by id, and to gains by value; `+ - * /` are
//! elementwise with scalar broadcast, products of matrices are spelt out ([`Symbol::times`]).

use std::ops::{Add, Div, Mul, Neg, Sub};
use std::rc::Rc;

use nsv_spec::expr::arena::{ConstantId, ExprId, ParameterId};
use nsv_spec::model;

use crate::ir::build::size;
use crate::ir::{Comparison, Function, Kernel, Operator, Shape};

/// Whose parameters a plant expression is evaluated with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// The controller's design values.
    Design,
    /// The true plant's.
    Plant,
}

/// Index into `Law::tapes`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TapeId(pub usize);

/// One term of a symbolic expression.
#[derive(Clone, Debug)]
pub enum Term {
    /// Another quantity of the law, or a leaf.
    Name(String),
    /// Literal, row-major.
    Literal(Shape, Vec<f64>),
    /// Diagonal gain: one value per channel, written as a scalar where all agree.
    Diagonal(Vec<f64>),
    /// Expression of the specification.
    Model(ExprId, Side),
    /// Compile-time constant of the specification.
    Constant(ConstantId),
    /// Run-time parameter of the specification.
    Parameter(ParameterId, Side),
    /// Output of an imported tape of partials.
    Tape(TapeId, String),
    /// Elementwise function.
    Apply(Function, Symbol),
    /// Smooth barrier kernel of a scalar.
    Kernel(Kernel, Symbol),
    /// Elementwise operator.
    Binary(Operator, Symbol, Symbol),
    /// Integer power.
    PowInt(Symbol, u32),
    /// Comparison of scalars.
    Compare(Comparison, Symbol, Symbol),
    /// Choice by a comparison.
    Select(Symbol, Symbol, Symbol),
    /// Either of two truth values.
    Or(Symbol, Symbol),
    /// Column of a matrix as a vector.
    Column(Symbol, usize),
    /// Sum of the diagonal of a square matrix.
    Trace(Symbol),
    /// Vectors stacked into one.
    Stack(Vec<Symbol>),
    /// Matrix with these blocks on its diagonal (rows, and the block; `None` has no columns) and zeros elsewhere.
    BlockDiagonal(Vec<(usize, Option<Symbol>)>),
    /// Consecutive entries of a vector: first, number.
    Slice(Symbol, usize, usize),
    /// Matrix product.
    MatMul(Symbol, Symbol),
    /// Transpose.
    Transpose(Symbol),
    /// Inner product.
    Dot(Symbol, Symbol),
    /// a b^T.
    Outer(Symbol, Symbol),
    /// Sum of squares of all entries.
    SumSquares(Symbol),
    /// A^-1 b.
    Solve(Symbol, Symbol),
    /// Right singular vector of the largest singular value.
    SingularVector(Symbol),
    /// Square of the largest singular value.
    SpectralSquare(Symbol),
    /// MTPN basis of the block with this number (from 1) at an input vector.
    Basis(usize, Symbol),
    /// Its directional derivative: input, rate.
    BasisRate(usize, Symbol, Symbol),
    /// Its second directional derivative: input, rate, second rate.
    BasisRate2(usize, Symbol, Symbol, Symbol),
}

/// A shared symbolic expression.
#[derive(Clone, Debug)]
pub struct Symbol(Rc<Term>);

/// Refers to a quantity by name.
pub fn name(text: impl Into<String>) -> Symbol {
    Term::Name(text.into()).into()
}

/// A scalar number.
pub fn number(value: f64) -> Symbol {
    Term::Literal(Shape::Scalar, vec![value]).into()
}

/// An array of zeros.
pub fn zeros(shape: Shape) -> Symbol {
    Term::Literal(shape, vec![0.0; size(shape)]).into()
}

/// A vector of numbers.
pub fn vector(values: &[f64]) -> Symbol {
    Term::Literal(Shape::Vector(values.len()), values.to_vec()).into()
}

/// A diagonal gain.
pub fn diagonal(values: &[f64]) -> Symbol {
    Term::Diagonal(values.to_vec()).into()
}

/// The inverse of a diagonal gain.
pub fn reciprocal(values: &[f64]) -> Symbol {
    Term::Diagonal(values.iter().map(|value| 1.0 / value).collect()).into()
}

/// The value that all entries of a diagonal gain share.
pub fn uniform(values: &[f64]) -> Option<f64> {
    let (first, rest) = values.split_first()?;
    rest.iter().all(|value| value == first).then_some(*first)
}

/// The diagonal of a square matrix that has nothing else.
pub fn diagonal_of(value: &model::Matrix) -> Option<Vec<f64>> {
    let off_diagonal = |at: usize| !at.is_multiple_of(value.cols + 1) && value.data[at] != 0.0;
    let diagonal = value.rows == value.cols && !(0..value.data.len()).any(off_diagonal);
    diagonal.then(|| value.data.iter().copied().step_by(value.cols + 1).collect())
}

/// A matrix of numbers.
pub fn matrix(value: &model::Matrix) -> Symbol {
    Term::Literal(Shape::Matrix(value.rows, value.cols), value.data.clone()).into()
}

impl From<Term> for Symbol {
    fn from(term: Term) -> Self {
        Self(Rc::new(term))
    }
}

impl Symbol {
    /// The outermost term.
    pub fn term(&self) -> &Term {
        &self.0
    }

    /// Matrix product.
    pub fn times(self, other: Symbol) -> Symbol {
        Term::MatMul(self, other).into()
    }

    /// Transpose.
    pub fn transpose(self) -> Symbol {
        Term::Transpose(self).into()
    }

    /// Inner product.
    pub fn dot(self, other: Symbol) -> Symbol {
        Term::Dot(self, other).into()
    }

    /// Outer product.
    pub fn outer(self, other: Symbol) -> Symbol {
        Term::Outer(self, other).into()
    }

    /// Sum of squares of all entries.
    pub fn sum_squares(self) -> Symbol {
        Term::SumSquares(self).into()
    }

    /// Self^-1 times a vector.
    pub fn solve(self, rhs: Symbol) -> Symbol {
        Term::Solve(self, rhs).into()
    }

    /// Integer power of at least 2.
    pub fn pow(self, exponent: u32) -> Symbol {
        Term::PowInt(self, exponent).into()
    }

    /// Elementwise function.
    pub fn apply(self, function: Function) -> Symbol {
        Term::Apply(function, self).into()
    }

    /// Smaller of two, elementwise.
    pub fn min(self, other: Symbol) -> Symbol {
        Term::Binary(Operator::Min, self, other).into()
    }

    /// Larger of two, elementwise.
    pub fn max(self, other: Symbol) -> Symbol {
        Term::Binary(Operator::Max, self, other).into()
    }

    /// Whether self >= other.
    pub fn at_least(self, other: Symbol) -> Symbol {
        Term::Compare(Comparison::Ge, self, other).into()
    }

    /// First where self is true, else second.
    pub fn select(self, first: Symbol, second: Symbol) -> Symbol {
        Term::Select(self, first, second).into()
    }

    /// The expressions directly below this one.
    pub fn operands(&self) -> Vec<Symbol> {
        match self.term() {
            Term::Name(_)
            | Term::Literal(..)
            | Term::Diagonal(_)
            | Term::Model(..)
            | Term::Constant(_)
            | Term::Parameter(..)
            | Term::Tape(..) => Vec::new(),
            Term::Apply(_, a)
            | Term::Kernel(_, a)
            | Term::PowInt(a, _)
            | Term::Column(a, _)
            | Term::Trace(a)
            | Term::Slice(a, _, _)
            | Term::Transpose(a)
            | Term::SumSquares(a)
            | Term::SingularVector(a)
            | Term::SpectralSquare(a)
            | Term::Basis(_, a) => vec![a.clone()],
            Term::Binary(_, a, b)
            | Term::Compare(_, a, b)
            | Term::Or(a, b)
            | Term::MatMul(a, b)
            | Term::Dot(a, b)
            | Term::Outer(a, b)
            | Term::Solve(a, b)
            | Term::BasisRate(_, a, b) => vec![a.clone(), b.clone()],
            Term::Select(a, b, c) | Term::BasisRate2(_, a, b, c) => {
                vec![a.clone(), b.clone(), c.clone()]
            }
            Term::Stack(items) => items.clone(),
            Term::BlockDiagonal(blocks) => blocks
                .iter()
                .filter_map(|(_, block)| block.clone())
                .collect(),
        }
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Symbol {
            type Output = Symbol;
            fn $method(self, other: Symbol) -> Symbol {
                Term::Binary(Operator::$trait, self, other).into()
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Symbol {
    type Output = Symbol;
    fn neg(self) -> Symbol {
        self.apply(Function::Neg)
    }
}
