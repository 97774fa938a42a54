//! The typing rules: which operands an operation takes and what it makes of them.

use super::{BasisId, Op, Program, Shape, Type, ValueId};

const SCALAR: Type = Type::Real(Shape::Scalar);

impl Program {
    /// Type of an operation, or `None` where its operands do not fit; also `None` for literals and arrays, which carry their type.
    pub(crate) fn type_of(&self, op: &Op) -> Option<Type> {
        match *op {
            Op::Const(_) | Op::Array(_) => None,
            Op::Input(index) => Some(Type::Real(self.inputs.get(index)?.shape)),
            Op::Apply(_, a) => self.real(a).map(Type::Real),
            Op::PowInt(a, n) => self.real(a).filter(|_| n >= 2).map(Type::Real),
            Op::Kernel(_, a) => self.all_scalar(&[a]).then_some(SCALAR),
            Op::Binary(_, a, b) => broadcast(self.real(a)?, self.real(b)?).map(Type::Real),
            Op::Compare(_, a, b) => self.all_scalar(&[a, b]).then_some(Type::Bool),
            Op::And(a, b) | Op::Or(a, b) => self.all_bool(&[a, b]).then_some(Type::Bool),
            Op::Not(a) => self.all_bool(&[a]).then_some(Type::Bool),
            Op::MulAdd(a, b, c) => {
                let (a, b, c) = (self.real(a)?, self.real(b)?, self.real(c)?);
                (a == c && (b == a || b == Shape::Scalar)).then_some(Type::Real(a))
            }
            Op::Select(c, a, b) => {
                let factors = matches!(self.ty(a), Type::Ldlt(_));
                (self.all_bool(&[c]) && self.ty(a) == self.ty(b) && !factors).then(|| self.ty(a))
            }
            Op::Element(a, row, column) => match self.real(a)? {
                Shape::Vector(n) => row < n && column == 0,
                Shape::Matrix(r, c) => row < r && column < c,
                Shape::Scalar => false,
            }
            .then_some(SCALAR),
            Op::SumSquares(a) => self.real(a).map(|_| SCALAR),
            Op::Polynomial(id, ref arguments) => {
                let data = self.polynomials.get(id.0 as usize)?;
                (arguments.len() == data.arguments.len() && self.all_scalar(arguments))
                    .then_some(SCALAR)
            }
            Op::Table(id, ref orders, ref arguments) => {
                let table = self.tables.get(id.0 as usize)?;
                (arguments.len() == table.arguments.len()
                    && table.is_differentiable(orders)
                    && self.all_scalar(arguments))
                .then_some(SCALAR)
            }
            Op::TableFamily(id, ref arguments) => {
                let family = self.table_families.get(id.0 as usize)?;
                (arguments.len() == family.arguments.len() && self.all_scalar(arguments))
                    .then_some(Type::Real(Shape::Vector(family.members.len())))
            }
            Op::Family(id, z) => {
                let family = self.families.get(id.0 as usize)?;
                (self.all_scalar(&[z])).then_some(Type::Real(Shape::Vector(family.members.len())))
            }
            Op::Basis(id, z) => self.basis_type(id, &[z]),
            Op::BasisRate(id, z, z1) => self.basis_type(id, &[z, z1]),
            Op::BasisRate2(id, z, z1, z2) => self.basis_type(id, &[z, z1, z2]),
            Op::Ldlt(a) => match self.real(a)? {
                Shape::Matrix(rows, columns) if rows == columns => Some(Type::Ldlt(rows)),
                _ => None,
            },
            Op::MatMul(..)
            | Op::Transpose(_)
            | Op::Dot(..)
            | Op::Outer(..)
            | Op::Solve(..)
            | Op::SingularVector(_) => self.linear(op).map(Type::Real),
        }
    }

    fn linear(&self, op: &Op) -> Option<Shape> {
        use Shape::{Matrix, Scalar, Vector};
        match *op {
            Op::MatMul(a, b) => match (self.real(a)?, self.real(b)?) {
                (Matrix(r, k), Vector(l)) if k == l => Some(Vector(r)),
                (Matrix(r, k), Matrix(l, c)) if k == l => Some(Matrix(r, c)),
                _ => None,
            },
            Op::Transpose(a) => match self.real(a)? {
                Matrix(r, c) => Some(Matrix(c, r)),
                _ => None,
            },
            Op::Dot(a, b) => match (self.real(a)?, self.real(b)?) {
                (Vector(n), Vector(m)) if n == m => Some(Scalar),
                _ => None,
            },
            Op::Outer(a, b) => match (self.real(a)?, self.real(b)?) {
                (Vector(r), Vector(c)) => Some(Matrix(r, c)),
                _ => None,
            },
            Op::Solve(a, b) => {
                let unknowns = match self.ty(a) {
                    Type::Real(Matrix(rows, columns)) if rows == columns => rows,
                    Type::Ldlt(rows) => rows,
                    _ => return None,
                };
                let (Vector(rows) | Matrix(rows, _)) = self.real(b)? else {
                    return None;
                };
                (rows == unknowns).then_some(self.real(b)?)
            }
            Op::SingularVector(a) => match self.real(a)? {
                Matrix(_, c) => Some(Vector(c)),
                _ => None,
            },
            _ => None,
        }
    }

    fn basis_type(&self, id: BasisId, operands: &[ValueId]) -> Option<Type> {
        let basis = self.bases.get(id.0 as usize)?;
        let input = Type::Real(Shape::Vector(basis.inputs.len()));
        let fit = operands.iter().all(|&operand| self.ty(operand) == input);
        fit.then_some(Type::Real(Shape::Vector(basis.exponents.len())))
    }

    fn real(&self, id: ValueId) -> Option<Shape> {
        match self.ty(id) {
            Type::Real(shape) => Some(shape),
            Type::Bool | Type::Ldlt(_) => None,
        }
    }

    fn all_scalar(&self, ids: &[ValueId]) -> bool {
        ids.iter().all(|&id| self.ty(id) == SCALAR)
    }

    fn all_bool(&self, ids: &[ValueId]) -> bool {
        ids.iter().all(|&id| self.ty(id) == Type::Bool)
    }
}

fn broadcast(a: Shape, b: Shape) -> Option<Shape> {
    match (a, b) {
        (Shape::Scalar, other) | (other, Shape::Scalar) => Some(other),
        (a, b) => (a == b).then_some(a),
    }
}
