//! Appending instructions with their types inferred. A shape that does not fit is a compiler bug and panics.

use super::{Instruction, Op, Operator, Program, Shape, Type, ValueId};

impl Program {
    /// Appends an operation whose type follows from its operands.
    pub fn push(&mut self, op: Op) -> ValueId {
        let ty = self.infer(&op);
        self.push_typed(op, ty)
    }

    /// Appends a literal array.
    pub fn constant(&mut self, shape: Shape, data: Vec<f64>) -> ValueId {
        assert_eq!(data.len(), size(shape), "invariant: literal fills its shape");
        self.push_typed(Op::Const(data), Type::Real(shape))
    }

    /// Appends a scalar literal.
    pub fn scalar(&mut self, value: f64) -> ValueId {
        self.constant(Shape::Scalar, vec![value])
    }

    /// Appends an array of scalars.
    pub fn array(&mut self, shape: Shape, items: Vec<ValueId>) -> ValueId {
        assert_eq!(items.len(), size(shape), "invariant: entries fill the shape");
        self.push_typed(Op::Array(items), Type::Real(shape))
    }

    /// Appends an elementwise operator.
    pub fn binary(&mut self, operator: Operator, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Binary(operator, a, b))
    }

    /// The shape of a real value.
    pub fn shape(&self, id: ValueId) -> Shape {
        match self.ty(id) {
            Type::Real(shape) => shape,
            Type::Bool => panic!("invariant: a real value"),
        }
    }

    fn push_typed(&mut self, op: Op, ty: Type) -> ValueId {
        let id = ValueId(u32::try_from(self.instructions.len()).expect("invariant: fewer than 2^32 instructions"));
        self.instructions.push(Instruction { op, ty, name: None, origin: None });
        id
    }

    /// Type of an operation from its operands; `Const` and `Array` carry theirs.
    pub fn infer(&self, op: &Op) -> Type {
        let real = Type::Real;
        match op {
            Op::Const(_) | Op::Array(_) => panic!("invariant: literals and arrays are appended with their shape"),
            Op::Input(index) => real(self.inputs[*index].shape),
            Op::Apply(_, a) | Op::Kernel(_, a) | Op::PowInt(a, _) => self.ty(*a),
            Op::Binary(_, a, b) => real(broadcast(self.shape(*a), self.shape(*b))),
            Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_) => Type::Bool,
            Op::Select(_, a, b) => {
                assert_eq!(self.ty(*a), self.ty(*b), "invariant: both arms of a select have one type");
                self.ty(*a)
            }
            Op::Element(..) | Op::Dot(..) | Op::SumSquares(_) | Op::Polynomial(..) => real(Shape::Scalar),
            Op::MatMul(a, b) => match (self.shape(*a), self.shape(*b)) {
                (Shape::Matrix(r, k), Shape::Vector(l)) if k == l => real(Shape::Vector(r)),
                (Shape::Matrix(r, k), Shape::Matrix(l, c)) if k == l => real(Shape::Matrix(r, c)),
                (a, b) => panic!("invariant: product of {a:?} and {b:?}"),
            },
            Op::Transpose(a) => match self.shape(*a) {
                Shape::Matrix(r, c) => real(Shape::Matrix(c, r)),
                other => panic!("invariant: transpose of {other:?}"),
            },
            Op::Outer(a, b) => match (self.shape(*a), self.shape(*b)) {
                (Shape::Vector(r), Shape::Vector(c)) => real(Shape::Matrix(r, c)),
                (a, b) => panic!("invariant: outer product of {a:?} and {b:?}"),
            },
            Op::Solve(a, b) => match (self.shape(*a), self.shape(*b)) {
                (Shape::Matrix(r, c), Shape::Vector(l)) if r == c && c == l => real(Shape::Vector(r)),
                (a, b) => panic!("invariant: solve {a:?} for {b:?}"),
            },
            Op::SingularVector(a) => match self.shape(*a) {
                Shape::Matrix(_, c) => real(Shape::Vector(c)),
                other => panic!("invariant: singular vector of {other:?}"),
            },
            Op::Basis(basis, _) | Op::BasisRate(basis, _, _) | Op::BasisRate2(basis, _, _, _) => {
                real(Shape::Vector(self.bases[basis.0 as usize].exponents.len()))
            }
        }
    }
}

/// Number of entries.
pub fn size(shape: Shape) -> usize {
    match shape {
        Shape::Scalar => 1,
        Shape::Vector(n) => n,
        Shape::Matrix(r, c) => r * c,
    }
}

fn broadcast(a: Shape, b: Shape) -> Shape {
    match (a, b) {
        (Shape::Scalar, other) | (other, Shape::Scalar) => other,
        (a, b) if a == b => a,
        (a, b) => panic!("invariant: elementwise {a:?} with {b:?}"),
    }
}
