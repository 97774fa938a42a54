//! How many scalar operations a program makes, for the heads of emitted files and functions.

use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};

use crate::emit::plan::live;
use crate::ir::basis::Monomial;
use crate::ir::build::size;
use crate::ir::horner::Horner;
use crate::ir::{Function, MonomialBasis, Op, Operator, Program, Shape, Type};

/// Scalar operations by kind; a kernel counts as one elementary function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    by_kind: BTreeMap<Kind, u64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Addition,
    Multiplication,
    Division,
    Root,
    Elementary,
    Choice,
    Solve,
    SingularVector,
}

impl Counts {
    /// The counts of what a program's outputs depend on.
    pub fn of(program: &Program) -> Counts {
        let mut counts = Counts::default();
        let live = live(program);
        for (instruction, _) in program
            .instructions
            .iter()
            .zip(live)
            .filter(|(_, live)| *live)
        {
            let entries = match instruction.ty {
                Type::Bool => 1,
                Type::Real(shape) => size(shape) as u64,
            };
            counts.add_op(program, &instruction.op, entries);
        }
        counts
    }

    fn add(&mut self, kind: Kind, count: u64) {
        if count > 0 {
            *self.by_kind.entry(kind).or_default() += count;
        }
    }

    fn add_op(&mut self, program: &Program, op: &Op, entries: u64) {
        match op {
            Op::Const(_) | Op::Input(_) | Op::Array(_) | Op::Element(..) | Op::Transpose(_) => {}
            Op::Apply(function, _) => match function {
                Function::Neg | Function::Abs => {}
                Function::Sign => self.add(Kind::Choice, 2 * entries),
                Function::Sqrt => self.add(Kind::Root, entries),
                _ => self.add(Kind::Elementary, entries),
            },
            Op::Kernel(..) => self.add(Kind::Elementary, entries),
            Op::Binary(operator, ..) => self.add(kind_of(*operator), entries),
            Op::PowInt(_, n) => self.add(
                Kind::Multiplication,
                u64::from(n.ilog2() + n.count_ones() - 1) * entries,
            ),
            Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_) | Op::Select(..) => {
                self.add(Kind::Choice, entries)
            }
            Op::MatMul(a, _) => match program.shape(*a) {
                Shape::Matrix(_, inner) => self.add_inner_products(entries, inner as u64),
                _ => self.add_inner_products(entries, 1),
            },
            Op::Dot(a, _) | Op::SumSquares(a) => {
                self.add_inner_products(1, size(program.shape(*a)) as u64)
            }
            Op::Outer(..) => self.add(Kind::Multiplication, entries),
            Op::Solve(..) => self.add(Kind::Solve, 1),
            Op::SingularVector(_) => self.add(Kind::SingularVector, 1),
            Op::Polynomial(polynomial, _) => {
                let (additions, multiplications) =
                    Horner::new(&program.polynomials[polynomial.0 as usize]).operations();
                self.add(Kind::Addition, additions);
                self.add(Kind::Multiplication, multiplications);
            }
            Op::Basis(basis, _) => self.add(
                Kind::Multiplication,
                products(&program.bases[basis.0 as usize]),
            ),
            Op::BasisRate(basis, ..) => {
                let products = products(&program.bases[basis.0 as usize]);
                self.add(Kind::Addition, products);
                self.add(Kind::Multiplication, 3 * products);
            }
            Op::BasisRate2(basis, ..) => {
                let products = products(&program.bases[basis.0 as usize]);
                self.add(Kind::Addition, 3 * products);
                self.add(Kind::Multiplication, 7 * products);
            }
        }
    }

    fn add_inner_products(&mut self, count: u64, length: u64) {
        self.add(Kind::Addition, count * length.saturating_sub(1));
        self.add(Kind::Multiplication, count * length);
    }
}

fn kind_of(operator: Operator) -> Kind {
    match operator {
        Operator::Add | Operator::Sub => Kind::Addition,
        Operator::Mul => Kind::Multiplication,
        Operator::Div => Kind::Division,
        Operator::Pow | Operator::Atan2 => Kind::Elementary,
        Operator::Min | Operator::Max => Kind::Choice,
    }
}

fn products(basis: &MonomialBasis) -> u64 {
    let recipe = basis
        .recipe()
        .expect("invariant: a verified basis has a recipe");
    recipe
        .iter()
        .filter(|monomial| matches!(monomial, Monomial::Product { .. }))
        .count() as u64
}

impl Display for Counts {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.by_kind.is_empty() {
            return f.write_str("none");
        }
        for (position, (kind, count)) in self.by_kind.iter().enumerate() {
            let separator = if position == 0 { "" } else { ", " };
            let (one, many) = match kind {
                Kind::Addition => ("addition", "additions"),
                Kind::Multiplication => ("multiplication", "multiplications"),
                Kind::Division => ("division", "divisions"),
                Kind::Root => ("square root", "square roots"),
                Kind::Elementary => ("elementary function", "elementary functions"),
                Kind::Choice => ("comparison or selection", "comparisons and selections"),
                Kind::Solve => ("linear solve", "linear solves"),
                Kind::SingularVector => ("singular vector", "singular vectors"),
            };
            write!(
                f,
                "{separator}{count} {}",
                if *count == 1 { one } else { many }
            )?;
        }
        Ok(())
    }
}
