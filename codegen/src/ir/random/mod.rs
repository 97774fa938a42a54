//! Random sound programs with random inputs, for tests of passes and back ends. The same seed gives the same program everywhere.

mod frame;

use super::build::size;
use super::mnemonic::{COMPARISONS, FUNCTIONS, KERNELS, OPERATORS};
use super::{
    BasisId, FamilyId, Function, Op, Operator, PolynomialId, Program, Shape, TableFamilyId,
    TableId, Type, ValueId, Values,
};
use frame::frame;

/// Values at which algebra that is not IEEE arithmetic shows.
const SPECIAL: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    2.0,
    0.5,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    5e-324,
    -1e-310,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::EPSILON,
];

/// Shapes of inputs and literals; few, so that operands that fit each other are common.
const SHAPES: [Shape; 9] = [
    Shape::Scalar,
    Shape::Scalar,
    Shape::Vector(3),
    Shape::Vector(2),
    Shape::Vector(4),
    Shape::Matrix(3, 3),
    Shape::Matrix(2, 3),
    Shape::Matrix(2, 2),
    Shape::Matrix(4, 4),
];

/// A sound program of `length` instructions with every operation, many of them in forms that passes rewrite; fused for odd seeds.
pub fn program(seed: u64, length: usize) -> Program {
    let mut generator = Generator {
        random: Random(seed),
        program: Program {
            fused: seed % 2 == 1,
            ..frame()
        },
    };
    for index in 0..generator.program.inputs.len() {
        generator.program.push(Op::Input(index));
    }
    while generator.program.instructions.len() < length {
        generator.append();
    }
    generator.name_values();
    generator.program
}

/// Inputs for a program; one entry in four is a special value.
pub fn inputs(program: &Program, seed: u64) -> Values {
    let mut random = Random(seed);
    let values = program.inputs.iter().map(|input| {
        (
            input.name.clone(),
            (0..size(input.shape)).map(|_| random.number(4)).collect(),
        )
    });
    values.collect()
}

/// A linear congruential generator (Knuth's MMIX constants), of which the high bits are used.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let high = u32::try_from(self.0 >> 33).expect("invariant: 31 bits");
        high as usize % count
    }

    fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// A small decimal number, or once in `special` times a special value.
    fn number(&mut self, special: usize) -> f64 {
        match self.below(special) {
            0 => self.pick(&SPECIAL),
            _ => self.below(4001) as f64 / 1000.0 - 2.0,
        }
    }

    /// A finite number.
    fn literal(&mut self) -> f64 {
        Some(self.number(2))
            .filter(|value| value.is_finite())
            .unwrap_or(0.0)
    }
}

struct Generator {
    random: Random,
    program: Program,
}

impl Generator {
    /// Appends an operation, unless no operands for it were found.
    fn append(&mut self) {
        match self.random.below(15) {
            0 => self.append_literal(),
            1 => self.append_taken_apart(),
            2 => self.append_again(),
            3 => self.append_sum_of_polynomials(),
            4 => self.append_sum_of_multiples(),
            5 => self.append_tables_at_one_place(),
            _ => {
                if let Some(op) = self
                    .operation()
                    .filter(|op| self.program.type_of(op).is_some())
                {
                    self.program.push(op);
                }
            }
        }
    }

    fn append_literal(&mut self) {
        let shape = self.random.pick(&SHAPES);
        let same = self.random.literal();
        let uniform = self.random.below(2) == 0;
        let data = (0..size(shape))
            .map(|_| if uniform { same } else { self.random.literal() })
            .collect();
        self.program.constant(shape, data);
    }

    /// The entries of an array, and an array of them or of other scalars.
    fn append_taken_apart(&mut self) {
        let Some(array) =
            self.value(|ty| matches!(ty, Type::Real(shape) if shape != Shape::Scalar))
        else {
            return;
        };
        let shape = self.program.shape(array);
        let columns = if let Shape::Matrix(_, columns) = shape {
            columns
        } else {
            1
        };
        let other = self.random.below(3) == 0;
        let items = (0..size(shape)).map(|i| match self.scalar().filter(|_| other) {
            Some(scalar) => scalar,
            None => self
                .program
                .push(Op::Element(array, i / columns, i % columns)),
        });
        let items = items.collect();
        self.program.array(shape, items);
    }

    /// Two polynomials at the same arguments, of a family or not, one of them multiplied by a number, added.
    fn append_sum_of_polynomials(&mut self) {
        let (Some(z), Some(other)) = (self.scalar(), self.scalar()) else {
            return;
        };
        let [first, second] = if self.random.below(2) == 0 {
            let values = self.program.push(Op::Family(FamilyId(0), z));
            [0, 0].map(|_| Op::Element(values, self.random.below(4), 0))
        } else {
            let (one, two) = (PolynomialId(0), PolynomialId(1));
            [
                Op::Polynomial(one, vec![z, other]),
                Op::Polynomial(two, vec![z]),
            ]
        };
        let (first, second) = (self.program.push(first), self.program.push(second));
        let factor = self.random.literal();
        let factor = self.program.scalar(factor);
        let second = self.program.binary(Operator::Mul, second, factor);
        self.program.binary(Operator::Add, first, second);
    }

    /// Derivatives of two tables, which may be the same one, at the same arguments as far as they have as many.
    fn append_tables_at_one_place(&mut self) {
        let Some(arguments) = (0..3).map(|_| self.scalar()).collect::<Option<Vec<_>>>() else {
            return;
        };
        for _ in 0..2 {
            let (id, orders) = self.derivative();
            let arguments = arguments[..orders.len()].to_vec();
            self.program.push(Op::Table(id, orders, arguments));
        }
    }

    /// Two multiples of one array, added.
    fn append_sum_of_multiples(&mut self) {
        let array = self.value(|ty| matches!(ty, Type::Real(shape) if shape != Shape::Scalar));
        let (Some(array), Some(first), Some(second)) = (array, self.scalar(), self.scalar()) else {
            return;
        };
        let first = self.program.binary(Operator::Mul, array, first);
        let second = self.program.binary(Operator::Mul, array, second);
        self.program.binary(Operator::Add, first, second);
    }

    /// An earlier operation once more, its first two operands exchanged if they may be.
    fn append_again(&mut self) {
        let Some(id) = self.value(|_| true) else {
            return;
        };
        let instruction = self.program.instruction(id).clone();
        let operands = instruction.op.operands();
        let mut exchanged = operands.iter().rev();
        let op = instruction
            .op
            .map_operands(|_| *exchanged.next().expect("invariant: as many operands"));
        let op = if self.program.type_of(&op) == Some(instruction.ty) {
            op
        } else {
            instruction.op.clone()
        };
        self.program
            .instructions
            .push(super::Instruction { op, ..instruction });
    }

    fn operation(&mut self) -> Option<Op> {
        Some(match self.random.below(29) {
            0 | 1 => Op::Apply(Function::Neg, self.real()?),
            2 | 3 => Op::Apply(self.random.pick(&FUNCTIONS).0, self.real()?),
            4 => Op::Kernel(self.random.pick(&KERNELS).0, self.scalar()?),
            5..=9 => {
                let operators = if self.random.below(4) == 0 {
                    &OPERATORS[..]
                } else {
                    &OPERATORS[..4]
                };
                let (operator, a) = (self.random.pick(operators).0, self.real()?);
                let ty = self.program.ty(a);
                let b = self.value(|other| other == ty || other == Type::Real(Shape::Scalar))?;
                if self.random.below(2) == 0 {
                    Op::Binary(operator, a, b)
                } else {
                    Op::Binary(operator, b, a)
                }
            }
            10 => Op::PowInt(
                self.real()?,
                2 + u32::try_from(self.random.below(20)).expect("invariant: below 20"),
            ),
            11 | 12 => Op::Compare(
                self.random.pick(&COMPARISONS).0,
                self.scalar()?,
                self.scalar()?,
            ),
            13 => Op::And(self.truth()?, self.truth()?),
            14 => Op::Or(self.truth()?, self.truth()?),
            15 => Op::Not(self.truth()?),
            16 | 17 => {
                let a = self.value(|_| true)?;
                let ty = self.program.ty(a);
                Op::Select(self.truth()?, a, self.value(|other| other == ty)?)
            }
            18 => Op::Element(self.real()?, self.random.below(3), self.random.below(3)),
            19 => {
                let a = self.matrix()?;
                Op::MatMul(
                    a,
                    self.value(|ty| matches!(ty, Type::Real(shape) if shape != Shape::Scalar))?,
                )
            }
            20 => Op::Transpose(self.matrix()?),
            21 => {
                let a = self.vector()?;
                let ty = self.program.ty(a);
                Op::Dot(a, self.value(|other| other == ty)?)
            }
            22 => Op::Outer(self.vector()?, self.vector()?),
            23 if self.random.below(2) == 0 => {
                let a = self.real()?;
                let ty = self.program.ty(a);
                let factor = self.value(|other| other == ty || other == Type::Real(Shape::Scalar));
                Op::MulAdd(a, factor?, self.value(|other| other == ty)?)
            }
            23 => Op::SumSquares(self.real()?),
            24 if self.random.below(3) == 0 => Op::Ldlt(self.matrix()?),
            24 => {
                let a =
                    self.value(|ty| matches!(ty, Type::Real(Shape::Matrix(..)) | Type::Ldlt(_)))?;
                Op::Solve(a, self.real()?)
            }
            25 => Op::SingularVector(self.matrix()?),
            26 if self.random.below(2) == 0 => {
                Op::Polynomial(PolynomialId(0), vec![self.scalar()?, self.scalar()?])
            }
            26 => Op::Polynomial(PolynomialId(1), vec![self.scalar()?]),
            28 if self.random.below(2) == 0 => self.table()?,
            27 => Op::Family(FamilyId(0), self.scalar()?),
            _ => {
                let (basis, inputs) = self.random.pick(&[(BasisId(0), 3), (BasisId(1), 2)]);
                let mut input = || self.value(|ty| ty == Type::Real(Shape::Vector(inputs)));
                let (z, z1, z2) = (input()?, input()?, input()?);
                match self.random.below(3) {
                    0 => Op::Basis(basis, z),
                    1 => Op::BasisRate(basis, z, z1),
                    _ => Op::BasisRate2(basis, z, z1, z2),
                }
            }
        })
    }

    /// A derivative of a table at some arguments, or a family of them.
    fn table(&mut self) -> Option<Op> {
        if self.random.below(4) == 0 {
            let arguments = vec![self.scalar()?, self.scalar()?];
            return Some(Op::TableFamily(TableFamilyId(0), arguments));
        }
        let (id, orders) = self.derivative();
        let arguments = orders.iter().map(|_| self.scalar());
        let arguments = arguments.collect::<Option<_>>()?;
        Some(Op::Table(id, orders, arguments))
    }

    /// A table and how often by each argument.
    fn derivative(&mut self) -> (TableId, Vec<u32>) {
        let id = self.random.below(self.program.tables.len());
        let (count, degree) = {
            let table = &self.program.tables[id];
            (table.arguments.len(), table.interpolant.degree.number())
        };
        let order = |random: &mut Random| match random.below(2) {
            0 => 0,
            _ => u32::try_from(random.below(degree + 1)).expect("invariant: at most 3"),
        };
        let orders = (0..count).map(|_| order(&mut self.random)).collect();
        let id = TableId(u32::try_from(id).expect("invariant: few tables"));
        (id, orders)
    }

    /// A value of a type that is accepted, if one is found in a few draws, most likely a recent one.
    fn value(&mut self, accept: impl Fn(Type) -> bool) -> Option<ValueId> {
        for _ in 0..40 {
            let count = self.program.instructions.len();
            let reach = if self.random.below(2) == 0 {
                count
            } else {
                count.min(16)
            };
            let index = count - 1 - self.random.below(reach);
            let id =
                ValueId(u32::try_from(index).expect("invariant: fewer than 2^32 instructions"));
            if accept(self.program.ty(id)) {
                return Some(id);
            }
        }
        None
    }

    fn real(&mut self) -> Option<ValueId> {
        self.value(|ty| matches!(ty, Type::Real(_)))
    }

    fn truth(&mut self) -> Option<ValueId> {
        self.value(|ty| ty == Type::Bool)
    }

    fn scalar(&mut self) -> Option<ValueId> {
        self.value(|ty| ty == Type::Real(Shape::Scalar))
    }

    fn vector(&mut self) -> Option<ValueId> {
        self.value(|ty| matches!(ty, Type::Real(Shape::Vector(_))))
    }

    fn matrix(&mut self) -> Option<ValueId> {
        self.value(|ty| matches!(ty, Type::Real(Shape::Matrix(..))))
    }

    /// Names every seventh value on average, and makes every third of those, and the last value, outputs.
    fn name_values(&mut self) {
        let count = u32::try_from(self.program.instructions.len())
            .expect("invariant: fewer than 2^32 instructions");
        for value in (0..count).map(ValueId) {
            let instruction = &mut self.program.instructions[value.0 as usize];
            let numbers = !matches!(instruction.op, Op::Input(_) | Op::Ldlt(_));
            if !numbers || self.random.below(7) > 0 {
                continue;
            }
            let name = format!("v{}", value.0);
            instruction.name = Some(name.clone());
            instruction.origin = Some(0);
            if self.random.below(3) == 0 {
                self.program.outputs.push((name, value));
            }
        }
        let last = (0..count).rev().map(ValueId);
        let mut outputs = last.filter(|&id| !matches!(self.program.ty(id), Type::Ldlt(_)));
        let last = outputs.next().expect("invariant: a program has inputs");
        self.program.outputs.push(("last".into(), last));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::verify::verify;

    #[test]
    fn programs_are_sound() {
        for seed in 0..50 {
            assert_eq!(verify(&program(seed, 200)), []);
        }
    }

    #[test]
    fn programs_use_every_operation() {
        let text: String = (0..20).map(|seed| program(seed, 300).to_string()).collect();
        let words = FUNCTIONS
            .map(|(_, word)| word)
            .into_iter()
            .chain(OPERATORS.map(|(_, word)| word));
        let words = words
            .chain(COMPARISONS.map(|(_, word)| word))
            .chain(KERNELS.map(|(_, word)| word));
        let others = "const powi and or not select array element matmul transpose dot outer sum_squares solve singular_vector polynomial table tables family \
                      basis basis_rate basis_rate2";
        for word in words.chain(others.split(' ')) {
            assert!(text.contains(&format!("= {word} ")), "{word}");
        }
    }
}
