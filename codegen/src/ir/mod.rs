//! The intermediate representation: one straight-line SSA program per emitted function.
//!
//! Values are truth values, real scalars, or small dense vectors and matrices with their shape in the type. There are no branches
//! (`Select`) and no memory; the only loops are the implicit ones over an array. Operands are earlier instructions.
//! [`eval`] defines the meaning of every operation to the last bit; the emitted code and each exact pass preserve it.

pub mod basis;
pub mod build;
pub mod chain;
pub mod eval;
pub mod horner;
pub(crate) mod mnemonic;
pub mod print;
pub mod random;
pub mod read;
mod tables;
mod typing;
pub mod verify;

use std::collections::BTreeMap;

/// A value: the instruction that makes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueId(pub u32);

/// Index into [`Program::polynomials`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PolynomialId(pub u32);

/// Index into [`Program::tables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableId(pub u32);

/// Index into [`Program::table_families`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TableFamilyId(pub u32);

/// Index into [`Program::bases`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BasisId(pub u32);

/// Index into [`Program::families`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FamilyId(pub u32);

pub use nsv_spec::expr::arena::{Comparison, Function, Operator, Shape};
pub use tables::{TableData, TableFamily, TableMember};

/// Type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Type {
    /// Truth value.
    Bool,
    /// Real scalar or array.
    Real(Shape),
    /// Factors of a symmetric matrix of so many rows; their entries are those of the matrix.
    Ldlt(usize),
}

/// Functions of the barrier Lyapunov function that are smooth at 0 although their usual form is 0/0 there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kernel {
    /// sin(E) cos(E) / E, 1 at 0.
    SinCosOver,
    /// First derivative of [`Kernel::SinCosOver`].
    SinCosOverD1,
    /// Second derivative of [`Kernel::SinCosOver`].
    SinCosOverD2,
    /// Third derivative of [`Kernel::SinCosOver`].
    SinCosOverD3,
    /// tan(E) / E, 1 at 0.
    TanOver,
}

/// One operation. Sums follow one rule: up to seven terms are added left to right; from eight on, term k goes to partial sum k mod 8, and
/// the partial sums are added in halves: first four to last four, first two to last two, first to last.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// Literal, row-major; the shape is in the type.
    Const(Vec<f64>),
    /// Input of the program, by position.
    Input(usize),
    /// Elementwise function.
    Apply(Function, ValueId),
    /// Smooth scalar kernel.
    Kernel(Kernel, ValueId),
    /// Elementwise operator; a scalar operand is broadcast.
    Binary(Operator, ValueId, ValueId),
    /// a b + c with one rounding, elementwise; b may be a scalar.
    MulAdd(ValueId, ValueId, ValueId),
    /// x^n, elementwise, n >= 2, by left-to-right binary powering: products only (1/x^n is a division by this).
    PowInt(ValueId, u32),
    /// Comparison of scalars.
    Compare(Comparison, ValueId, ValueId),
    /// Both.
    And(ValueId, ValueId),
    /// Either.
    Or(ValueId, ValueId),
    /// Negation.
    Not(ValueId),
    /// Condition, value if true, value if false; both are evaluated, no arithmetic mixes them.
    Select(ValueId, ValueId, ValueId),
    /// Array of scalars, row-major.
    Array(Vec<ValueId>),
    /// Entry (row, column).
    Element(ValueId, usize, usize),
    /// Matrix times matrix or vector.
    MatMul(ValueId, ValueId),
    /// Transpose of a matrix.
    Transpose(ValueId),
    /// Inner product of two vectors of one length.
    Dot(ValueId, ValueId),
    /// a b^T of two vectors.
    Outer(ValueId, ValueId),
    /// Sum of the squares of all entries: along each row left to right, then of the rows' sums.
    SumSquares(ValueId),
    /// A^-1 b for a square matrix and a vector or matrix: adjugate times the reciprocal of the determinant for up to three rows, else
    /// elimination with partial pivoting. Of [`Op::Ldlt`], by the factors where their pivots are positive.
    Solve(ValueId, ValueId),
    /// A symmetric matrix with its factors L D L^T, to solve with; the lower triangle is read.
    Ldlt(ValueId),
    /// Unit right singular vector of the largest singular value (cyclic Jacobi on A^T A, a fixed number of sweeps).
    SingularVector(ValueId),
    /// Polynomial data of scalar arguments, by nested Horner schemes.
    Polynomial(PolynomialId, Vec<ValueId>),
    /// Derivative of a lookup table at scalar arguments, so many times by each ([`nsv_spec::interpolation`]).
    Table(TableId, Vec<u32>, Vec<ValueId>),
    /// All members of a family of tables at the same scalar arguments: a vector of the family's length.
    TableFamily(TableFamilyId, Vec<ValueId>),
    /// All polynomials of a family at one scalar argument, each by its own Horner scheme: a vector of the family's length.
    Family(FamilyId, ValueId),
    /// Monomial basis of an input vector: a vector of the basis' length.
    Basis(BasisId, ValueId),
    /// Directional derivative of a monomial basis: input vector, its rate.
    BasisRate(BasisId, ValueId, ValueId),
    /// Second directional derivative along a line: input vector z, its rate z', its second rate z''.
    BasisRate2(BasisId, ValueId, ValueId, ValueId),
}

/// Where a value comes from: an equation of the paper and a line of doc, printed above the emitted statement.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// Group heading, such as `virtual control of block 1 (31)`; statements of one group are emitted together.
    pub group: String,
    /// The equation in words and symbols, such as `e_1 = x_1 - y_r - zeta_1  (14)`.
    pub equation: String,
}

/// One instruction.
#[derive(Clone, Debug, PartialEq)]
pub struct Instruction {
    /// What is computed.
    pub op: Op,
    /// Type of the result.
    pub ty: Type,
    /// Name of the signal, unique in the program; `None` for intermediate values.
    pub name: Option<String>,
    /// Index into [`Program::origins`]; only named values need one.
    pub origin: Option<usize>,
}

/// An input of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Name, such as `x1` or `params.mass`.
    pub name: String,
    /// Shape.
    pub shape: Shape,
}

/// Polynomial data: sum of c * z_1^a_1 ... z_v^a_v.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialData {
    /// Name, a Rust identifier in snake case, such as `cl_alpha` or `cl_alpha_d1` (derivative by the first argument).
    pub name: String,
    /// Argument names.
    pub arguments: Vec<String>,
    /// Coefficient and exponents.
    pub terms: Vec<(f64, Vec<u32>)>,
}

/// Polynomials of one argument that are evaluated together.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialFamily {
    /// Name, such as `at_alpha_deg`.
    pub name: String,
    /// Argument name.
    pub argument: String,
    /// The polynomials, those of higher degree first.
    pub members: Vec<FamilyMember>,
}

/// A polynomial of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilyMember {
    /// Name, such as `CL_alpha`; unique in the family.
    pub name: String,
    /// From the highest power down to the constant: `r = c_n`, then `r = r*z + c` for each that follows. A power without a term has -0,
    /// which adds nothing to any number; one with 0 adds that.
    pub coefficients: Vec<f64>,
}

/// Monomials of a network, in canonical order (total degree ascending, then exponent of z_1 descending, z_2, ...).
#[derive(Clone, Debug, PartialEq)]
pub struct MonomialBasis {
    /// Name, such as `basis1`.
    pub name: String,
    /// Input names.
    pub inputs: Vec<String>,
    /// Exponents of each monomial.
    pub exponents: Vec<Vec<u32>>,
}

/// A straight-line function.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// Name, a Rust identifier.
    pub name: String,
    /// Whether a product that an inner product, a product of matrices, a sum of squares or a family's scheme adds to a sum is not rounded;
    /// of a matrix' squares those along a row. Elementary functions are then those of `nsv_math` whose name ends in `_fused`; kernels are not.
    pub fused: bool,
    /// Inputs.
    pub inputs: Vec<Input>,
    /// Instructions; operands are earlier ones.
    pub instructions: Vec<Instruction>,
    /// Results, by name.
    pub outputs: Vec<(String, ValueId)>,
    /// Polynomial data used.
    pub polynomials: Vec<PolynomialData>,
    /// Lookup tables used.
    pub tables: Vec<TableData>,
    /// Families of lookup tables used.
    pub table_families: Vec<TableFamily>,
    /// Polynomial families used.
    pub families: Vec<PolynomialFamily>,
    /// Bases used.
    pub bases: Vec<MonomialBasis>,
    /// Origins used.
    pub origins: Vec<Origin>,
}

/// Values by name: inputs and outputs of [`eval`]; row-major entries.
pub type Values = BTreeMap<String, Vec<f64>>;

impl Program {
    /// The instruction of a value.
    pub fn instruction(&self, id: ValueId) -> &Instruction {
        &self.instructions[id.0 as usize]
    }

    /// The type of a value.
    pub fn ty(&self, id: ValueId) -> Type {
        self.instruction(id).ty
    }
}

impl Op {
    /// Whether it gives the values of a family, which have names.
    pub(crate) fn is_family(&self) -> bool {
        matches!(self, Op::Family(..) | Op::TableFamily(..))
    }

    /// Operands, in order.
    pub fn operands(&self) -> Vec<ValueId> {
        match self {
            Op::Const(_) | Op::Input(_) => Vec::new(),
            Op::Apply(_, a)
            | Op::Kernel(_, a)
            | Op::PowInt(a, _)
            | Op::Not(a)
            | Op::Element(a, _, _)
            | Op::Transpose(a)
            | Op::SumSquares(a)
            | Op::SingularVector(a)
            | Op::Ldlt(a)
            | Op::Family(_, a)
            | Op::Basis(_, a) => vec![*a],
            Op::Binary(_, a, b)
            | Op::Compare(_, a, b)
            | Op::And(a, b)
            | Op::Or(a, b)
            | Op::MatMul(a, b)
            | Op::Dot(a, b)
            | Op::Outer(a, b)
            | Op::Solve(a, b)
            | Op::BasisRate(_, a, b) => vec![*a, *b],
            Op::Select(a, b, c) | Op::MulAdd(a, b, c) | Op::BasisRate2(_, a, b, c) => {
                vec![*a, *b, *c]
            }
            Op::Array(items)
            | Op::Polynomial(_, items)
            | Op::Table(_, _, items)
            | Op::TableFamily(_, items) => items.clone(),
        }
    }

    /// The same operation on other operands, each replaced by `f` of it.
    pub fn map_operands(&self, mut f: impl FnMut(ValueId) -> ValueId) -> Op {
        match *self {
            Op::Const(_) | Op::Input(_) => self.clone(),
            Op::Apply(function, a) => Op::Apply(function, f(a)),
            Op::Kernel(kernel, a) => Op::Kernel(kernel, f(a)),
            Op::Binary(operator, a, b) => Op::Binary(operator, f(a), f(b)),
            Op::PowInt(a, n) => Op::PowInt(f(a), n),
            Op::Compare(comparison, a, b) => Op::Compare(comparison, f(a), f(b)),
            Op::And(a, b) => Op::And(f(a), f(b)),
            Op::Or(a, b) => Op::Or(f(a), f(b)),
            Op::Not(a) => Op::Not(f(a)),
            Op::Select(a, b, c) => Op::Select(f(a), f(b), f(c)),
            Op::MulAdd(a, b, c) => Op::MulAdd(f(a), f(b), f(c)),
            Op::Array(ref items) => Op::Array(items.iter().map(|&item| f(item)).collect()),
            Op::Element(a, row, column) => Op::Element(f(a), row, column),
            Op::MatMul(a, b) => Op::MatMul(f(a), f(b)),
            Op::Transpose(a) => Op::Transpose(f(a)),
            Op::Dot(a, b) => Op::Dot(f(a), f(b)),
            Op::Outer(a, b) => Op::Outer(f(a), f(b)),
            Op::SumSquares(a) => Op::SumSquares(f(a)),
            Op::Solve(a, b) => Op::Solve(f(a), f(b)),
            Op::Ldlt(a) => Op::Ldlt(f(a)),
            Op::SingularVector(a) => Op::SingularVector(f(a)),
            Op::Polynomial(id, ref items) => {
                Op::Polynomial(id, items.iter().map(|&item| f(item)).collect())
            }
            Op::Table(id, ref orders, ref items) => Op::Table(
                id,
                orders.clone(),
                items.iter().map(|&item| f(item)).collect(),
            ),
            Op::TableFamily(id, ref items) => {
                Op::TableFamily(id, items.iter().map(|&item| f(item)).collect())
            }
            Op::Family(id, a) => Op::Family(id, f(a)),
            Op::Basis(id, a) => Op::Basis(id, f(a)),
            Op::BasisRate(id, a, b) => Op::BasisRate(id, f(a), f(b)),
            Op::BasisRate2(id, a, b, c) => Op::BasisRate2(id, f(a), f(b), f(c)),
        }
    }
}
