//! Symbolic array expressions of the law to IR.

use super::{Context, Leaf, Lowering};
use crate::derive::symbol::{Symbol, Term};
use crate::ir::build::size;
use crate::ir::{BasisId, Op, Operator, Shape, ValueId};

impl<C: Context> Lowering<'_, '_, C> {
    /// The value of a symbolic expression.
    pub fn symbol(&mut self, symbol: &Symbol) -> ValueId {
        let op = match symbol.term() {
            Term::Name(quantity) => return self.quantity(quantity),
            Term::Literal(shape, data) => {
                return self.context.literal(&mut self.program, *shape, data);
            }
            Term::Diagonal(values) => return self.context.diagonal(&mut self.program, values),
            Term::Model(expr, side) => return self.expression(*expr, *side),
            Term::Constant(id) => {
                return self.leaf(Leaf::Constant(*id), crate::derive::symbol::Side::Design);
            }
            Term::Parameter(id, side) => return self.leaf(Leaf::Parameter(*id), *side),
            Term::Tape(tape, output) => return self.tape(*tape, output),
            Term::Apply(function, a) => Op::Apply(*function, self.symbol(a)),
            Term::Kernel(kernel, a) => Op::Kernel(*kernel, self.symbol(a)),
            Term::Binary(operator, a, b) => Op::Binary(*operator, self.symbol(a), self.symbol(b)),
            Term::PowInt(a, exponent) => Op::PowInt(self.symbol(a), *exponent),
            Term::Compare(comparison, a, b) => {
                Op::Compare(*comparison, self.symbol(a), self.symbol(b))
            }
            Term::Or(a, b) => Op::Or(self.symbol(a), self.symbol(b)),
            Term::Select(c, a, b) => Op::Select(self.symbol(c), self.symbol(a), self.symbol(b)),
            Term::MatMul(a, b) => Op::MatMul(self.symbol(a), self.symbol(b)),
            Term::Transpose(a) => Op::Transpose(self.symbol(a)),
            Term::Dot(a, b) => Op::Dot(self.symbol(a), self.symbol(b)),
            Term::Outer(a, b) => Op::Outer(self.symbol(a), self.symbol(b)),
            Term::SumSquares(a) => Op::SumSquares(self.symbol(a)),
            Term::Solve(a, b) => Op::Solve(self.symbol(a), self.symbol(b)),
            Term::SingularVector(a) => Op::SingularVector(self.symbol(a)),
            Term::Basis(block, z) => Op::Basis(self.basis(*block), self.symbol(z)),
            Term::BasisRate(block, z, dz) => {
                Op::BasisRate(self.basis(*block), self.symbol(z), self.symbol(dz))
            }
            Term::BasisRate2(block, z, dz, ddz) => Op::BasisRate2(
                self.basis(*block),
                self.symbol(z),
                self.symbol(dz),
                self.symbol(ddz),
            ),
            Term::SpectralSquare(a) => {
                let a = self.symbol(a);
                let direction = self.program.push(Op::SingularVector(a));
                Op::SumSquares(self.program.push(Op::MatMul(a, direction)))
            }
            Term::Column(a, col) => {
                let a = self.symbol(a);
                return self.column(a, *col);
            }
            Term::Slice(a, first, length) => {
                let a = self.symbol(a);
                let items = (0..*length)
                    .map(|at| self.entry(a, first + at, 0))
                    .collect();
                return self.program.array(Shape::Vector(*length), items);
            }
            Term::Stack(items) => {
                let parts: Vec<ValueId> = items.iter().map(|item| self.symbol(item)).collect();
                return self.stack(&parts);
            }
            Term::Trace(a) => {
                let a = self.symbol(a);
                return self.trace(a);
            }
            Term::BlockDiagonal(blocks) => {
                let blocks: Vec<_> = blocks
                    .iter()
                    .map(|(rows, block)| (*rows, block.as_ref().map(|block| self.symbol(block))))
                    .collect();
                return self.block_diagonal(&blocks);
            }
        };
        self.program.push(op)
    }

    fn entry(&mut self, of: ValueId, row: usize, col: usize) -> ValueId {
        match self.program.shape(of) {
            Shape::Scalar => of,
            _ => self.program.push(Op::Element(of, row, col)),
        }
    }

    fn column(&mut self, of: ValueId, col: usize) -> ValueId {
        let Shape::Matrix(rows, _) = self.program.shape(of) else {
            return of;
        };
        let items = (0..rows).map(|row| self.entry(of, row, col)).collect();
        self.program.array(Shape::Vector(rows), items)
    }

    fn stack(&mut self, parts: &[ValueId]) -> ValueId {
        let mut items = Vec::new();
        for &part in parts {
            let length = size(self.program.shape(part));
            items.extend((0..length).map(|row| self.entry(part, row, 0)));
        }
        self.program.array(Shape::Vector(items.len()), items)
    }

    fn trace(&mut self, of: ValueId) -> ValueId {
        let Shape::Matrix(rows, _) = self.program.shape(of) else {
            return of;
        };
        let first = self.entry(of, 0, 0);
        (1..rows).fold(first, |sum, at| {
            let entry = self.entry(of, at, at);
            self.program.binary(Operator::Add, sum, entry)
        })
    }

    fn block_diagonal(&mut self, blocks: &[(usize, Option<ValueId>)]) -> ValueId {
        let shape = |this: &Self, block: Option<ValueId>| {
            block.map_or(0, |block| match this.program.shape(block) {
                Shape::Matrix(_, cols) => cols,
                Shape::Scalar | Shape::Vector(_) => 1,
            })
        };
        let rows: usize = blocks.iter().map(|(rows, _)| rows).sum();
        let cols: usize = blocks.iter().map(|(_, block)| shape(self, *block)).sum();
        let zero = self.program.scalar(0.0);
        let mut items = Vec::with_capacity(rows * cols);
        let mut left = 0;
        for &(rows, block) in blocks {
            let width = shape(self, block);
            for row in 0..rows {
                for col in 0..cols {
                    let inside = block.filter(|_| (left..left + width).contains(&col));
                    items.push(inside.map_or(zero, |block| self.entry(block, row, col - left)));
                }
            }
            left += width;
        }
        self.program.array(Shape::Matrix(rows, cols), items)
    }

    fn basis(&mut self, block: usize) -> BasisId {
        let basis = &self.law.bases[&block];
        let at = self
            .program
            .bases
            .iter()
            .position(|known| known == basis)
            .unwrap_or_else(|| {
                self.program.bases.push(basis.clone());
                self.program.bases.len() - 1
            });
        BasisId(u32::try_from(at).expect("invariant: fewer than 2^32 bases"))
    }
}
