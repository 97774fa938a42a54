//! Appending instructions with their types inferred. A shape that does not fit is a compiler bug and panics.

use super::{Instruction, Op, Operator, Program, Shape, Type, ValueId};

impl Program {
    /// Appends an operation whose type follows from its operands.
    pub fn push(&mut self, op: Op) -> ValueId {
        let ty = self.infer(&op);
        self.push_as(op, ty)
    }

    /// Appends a literal array.
    pub fn constant(&mut self, shape: Shape, data: Vec<f64>) -> ValueId {
        assert_eq!(
            data.len(),
            size(shape),
            "invariant: literal fills its shape"
        );
        self.push_as(Op::Const(data), Type::Real(shape))
    }

    /// Appends a scalar literal.
    pub fn scalar(&mut self, value: f64) -> ValueId {
        self.constant(Shape::Scalar, vec![value])
    }

    /// Appends an array of scalars.
    pub fn array(&mut self, shape: Shape, items: Vec<ValueId>) -> ValueId {
        assert_eq!(
            items.len(),
            size(shape),
            "invariant: entries fill the shape"
        );
        self.push_as(Op::Array(items), Type::Real(shape))
    }

    /// Appends an elementwise operator.
    pub fn binary(&mut self, operator: Operator, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Binary(operator, a, b))
    }

    /// The shape of a real value.
    pub fn shape(&self, id: ValueId) -> Shape {
        match self.ty(id) {
            Type::Real(shape) => shape,
            Type::Bool | Type::Ldlt(_) => panic!("invariant: a real value"),
        }
    }

    /// Appends an operation of a known type.
    pub fn push_as(&mut self, op: Op, ty: Type) -> ValueId {
        let id = ValueId(
            u32::try_from(self.instructions.len())
                .expect("invariant: fewer than 2^32 instructions"),
        );
        self.instructions.push(Instruction {
            op,
            ty,
            name: None,
            origin: None,
        });
        id
    }

    /// Type of an operation from its operands; `Const` and `Array` carry theirs.
    pub fn infer(&self, op: &Op) -> Type {
        self.type_of(op).unwrap_or_else(|| {
            let operands: Vec<Type> = op.operands().into_iter().map(|id| self.ty(id)).collect();
            panic!("invariant: operands fit their operation, found {op:?} of {operands:?}")
        })
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
