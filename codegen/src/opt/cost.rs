//! Operation counts of a program, as it is emitted: every arm of a selection is computed.

use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter};
use std::iter::Sum;
use std::ops::{Add, Mul};

use crate::ir::FamilyMember;
use crate::ir::build::size;
use crate::ir::eval::{SWEEPS, entries};
use crate::ir::horner::Horner;
use crate::ir::{
    Function, Instruction, Kernel, MonomialBasis, Op, Operator, Program, Shape, TableData,
    TableFamily, TableMember, Type, ValueId,
};

/// How many scalar operations of each kind. Sign changes, absolute values, literals and moves count nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions and subtractions.
    pub additions: u64,
    /// Multiplications.
    pub multiplications: u64,
    /// Divisions.
    pub divisions: u64,
    /// Square roots.
    pub roots: u64,
    /// Calls of other elementary functions.
    pub elementary: u64,
    /// Comparisons and selections.
    pub selections: u64,
}

impl Cost {
    /// The counts by their short names.
    pub fn columns(&self) -> [(&'static str, u64); 6] {
        [
            ("add", self.additions),
            ("mul", self.multiplications),
            ("div", self.divisions),
            ("sqrt", self.roots),
            ("call", self.elementary),
            ("select", self.selections),
        ]
    }

    /// Additions and multiplications.
    pub fn flops(&self) -> u64 {
        self.additions + self.multiplications
    }
}

impl Add for Cost {
    type Output = Cost;

    fn add(self, other: Cost) -> Cost {
        Cost {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            roots: self.roots + other.roots,
            elementary: self.elementary + other.elementary,
            selections: self.selections + other.selections,
        }
    }
}

impl Sum for Cost {
    fn sum<I: Iterator<Item = Cost>>(costs: I) -> Cost {
        costs.fold(NOTHING, Cost::add)
    }
}

impl Mul<Cost> for u64 {
    type Output = Cost;

    fn mul(self, cost: Cost) -> Cost {
        Cost {
            additions: self * cost.additions,
            multiplications: self * cost.multiplications,
            divisions: self * cost.divisions,
            roots: self * cost.roots,
            elementary: self * cost.elementary,
            selections: self * cost.selections,
        }
    }
}

impl Display for Cost {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Cost {
            additions,
            multiplications,
            divisions,
            roots,
            elementary,
            selections,
        } = self;
        write!(
            f,
            "{additions} additions, {multiplications} multiplications, {divisions} divisions, {roots} square roots, "
        )?;
        write!(
            f,
            "{elementary} elementary functions, {selections} comparisons and selections"
        )
    }
}

const NOTHING: Cost = Cost {
    additions: 0,
    multiplications: 0,
    divisions: 0,
    roots: 0,
    elementary: 0,
    selections: 0,
};
const ADDITION: Cost = Cost {
    additions: 1,
    ..NOTHING
};
const MULTIPLICATION: Cost = Cost {
    multiplications: 1,
    ..NOTHING
};
const DIVISION: Cost = Cost {
    divisions: 1,
    ..NOTHING
};
const ROOT: Cost = Cost {
    roots: 1,
    ..NOTHING
};
const ELEMENTARY: Cost = Cost {
    elementary: 1,
    ..NOTHING
};
const SELECTION: Cost = Cost {
    selections: 1,
    ..NOTHING
};

/// The operations of a verified program.
pub fn count(program: &Program) -> Cost {
    program
        .instructions
        .iter()
        .map(|instruction| of(program, instruction))
        .sum()
}

/// The operations of one instruction of a verified program.
pub fn of(program: &Program, instruction: &Instruction) -> Cost {
    operation(program, &instruction.op, instruction.ty)
}

/// The operations of one polynomial of a family.
pub(super) fn member(member: &FamilyMember) -> Cost {
    let (additions, multiplications) = member.operations();
    Cost {
        additions,
        multiplications,
        ..NOTHING
    }
}

fn operation(program: &Program, op: &Op, ty: Type) -> Cost {
    let entries = entries(ty) as u64;
    match *op {
        Op::Const(_) | Op::Input(_) | Op::Array(_) | Op::Element(..) | Op::Transpose(_) => NOTHING,
        Op::Apply(function, _) => entries * elementary(function),
        Op::Kernel(function, _) => kernel(function),
        Op::Binary(operator, _, _) => entries * binary(operator),
        Op::PowInt(_, n) => entries * u64::from(n.ilog2() + n.count_ones() - 1) * MULTIPLICATION,
        Op::Compare(..) | Op::And(..) | Op::Or(..) | Op::Not(_) => SELECTION,
        Op::Select(..) => entries * SELECTION,
        Op::MulAdd(..) => entries * (MULTIPLICATION + ADDITION),
        Op::MatMul(a, _) => entries * sum_of_products(columns(program, a)),
        Op::Dot(a, _) | Op::SumSquares(a) => sum_of_products(size(program.shape(a)) as u64),
        Op::Outer(..) => entries * MULTIPLICATION,
        Op::Solve(a, _) => match program.ty(a) {
            Type::Ldlt(rows) => substitution(rows as u64, entries),
            _ => solve(columns(program, a), entries),
        },
        Op::Ldlt(a) => factors(columns(program, a)),
        Op::SingularVector(a) => singular_vector(size(program.shape(a)) as u64 / entries, entries),
        Op::Polynomial(id, _) => {
            let (additions, multiplications) =
                Horner::new(&program.polynomials[id.0 as usize]).operations();
            Cost {
                additions,
                multiplications,
                ..NOTHING
            }
        }
        Op::Table(id, ref orders, _) => {
            let table = &program.tables[id.0 as usize];
            places(table, &[orders]) + curves(table, orders)
        }
        Op::TableFamily(id, _) => {
            let family = &program.table_families[id.0 as usize];
            let members = family.members.iter();
            places_of(program, family) + members.map(|of| table_member(program, of)).sum()
        }
        Op::Family(id, _) => {
            let members = &program.families[id.0 as usize].members;
            members.iter().map(member).sum()
        }
        Op::Basis(id, _) => products(&program.bases[id.0 as usize]) * MULTIPLICATION,
        // m and m' of each product
        Op::BasisRate(id, ..) => {
            products(&program.bases[id.0 as usize]) * (3 * MULTIPLICATION + ADDITION)
        }
        // m, m' and m'' of each product
        Op::BasisRate2(id, ..) => {
            products(&program.bases[id.0 as usize]) * (7 * MULTIPLICATION + 3 * ADDITION)
        }
    }
}

/// What the members of a family share.
pub(super) fn places_of(program: &Program, family: &TableFamily) -> Cost {
    let members = family.members.iter();
    let orders: Vec<&[u32]> = members.map(|member| member.orders.as_slice()).collect();
    let first = family.members[0].table;
    places(&program.tables[first.0 as usize], &orders)
}

/// What a member of a family needs beside that.
pub(super) fn table_member(program: &Program, member: &TableMember) -> Cost {
    curves(&program.tables[member.table.0 as usize], &member.orders)
}

/// On each axis two comparisons beside the search, which is not counted, and on all but the last the splines by Horner's scheme, once for
/// each order.
fn places(data: &TableData, orders: &[&[u32]]) -> Cost {
    let degree = data.interpolant.degree.number() as u64;
    let axes = data.arguments.len();
    let leading = (0..axes - 1).flat_map(|axis| {
        let orders: BTreeSet<u32> = orders.iter().map(|orders| orders[axis]).collect();
        orders.into_iter().map(u64::from)
    });
    let splines =
        leading.map(|order| (degree + 1) * (degree - order) * (MULTIPLICATION + ADDITION));
    axes as u64 * (2 * SELECTION + ADDITION) + splines.sum()
}

/// The curves along the last axis by Horner's scheme, and their sums.
fn curves(data: &TableData, orders: &[u32]) -> Cost {
    let degree = data.interpolant.degree.number() as u64;
    let (mut cost, mut curves) = (NOTHING, 1);
    for _ in 1..orders.len() {
        cost = cost + curves * sum_of_products(degree + 1);
        curves *= degree + 1;
    }
    let steps = degree - u64::from(orders[orders.len() - 1]);
    cost + curves * steps * (MULTIPLICATION + ADDITION)
}

/// One call of a function.
pub(super) fn elementary(function: Function) -> Cost {
    match function {
        Function::Neg | Function::Abs => NOTHING,
        Function::Sign => 2 * SELECTION,
        Function::Sqrt => ROOT,
        _ => ELEMENTARY,
    }
}

fn binary(operator: Operator) -> Cost {
    match operator {
        Operator::Add | Operator::Sub => ADDITION,
        Operator::Mul => MULTIPLICATION,
        Operator::Div => DIVISION,
        Operator::Min | Operator::Max => SELECTION,
        Operator::Pow | Operator::Atan2 => ELEMENTARY,
    }
}

fn kernel(kernel: Kernel) -> Cost {
    // t, w, ten further steps of the polynomial, and the comparison with the limit
    let polynomial = 12 * MULTIPLICATION + 11 * ADDITION + SELECTION;
    match kernel {
        Kernel::SinCosOver => 2 * ELEMENTARY + MULTIPLICATION + DIVISION + SELECTION,
        Kernel::TanOver => ELEMENTARY + DIVISION + SELECTION,
        Kernel::SinCosOverD2 => polynomial,
        Kernel::SinCosOverD1 | Kernel::SinCosOverD3 => polynomial + MULTIPLICATION,
    }
}

fn sum_of_products(count: u64) -> Cost {
    count * MULTIPLICATION + count.saturating_sub(1) * ADDITION
}

/// `n` equations for a number of unknowns that may be those of several right sides.
fn solve(n: u64, unknowns: u64) -> Cost {
    let product_sum = sum_of_products(2);
    let update = MULTIPLICATION + ADDITION;
    match n {
        1 => unknowns * DIVISION,
        2 => product_sum + DIVISION + unknowns * (product_sum + MULTIPLICATION),
        3 => {
            let adjugate = 9 * product_sum + sum_of_products(3) + DIVISION;
            adjugate + unknowns * (sum_of_products(3) + MULTIPLICATION)
        }
        _ => {
            let elimination = (0..n).fold(NOTHING, |sum, below| {
                sum + below * (DIVISION + SELECTION + below * update)
            });
            elimination + (n - 1) * unknowns * update + unknowns * DIVISION
        }
    }
}

/// Factors of `n` rows.
fn factors(n: u64) -> Cost {
    let row =
        |below| below * MULTIPLICATION + below * (below + 1) / 2 * (MULTIPLICATION + ADDITION);
    (0..n).fold(NOTHING, |sum, below| {
        sum + DIVISION + SELECTION + row(below)
    })
}

/// A solution by factors of `n` rows, whose pivots are positive.
fn substitution(n: u64, unknowns: u64) -> Cost {
    unknowns * ((n - 1) * (MULTIPLICATION + ADDITION) + MULTIPLICATION)
}

fn singular_vector(rows: u64, columns: u64) -> Cost {
    let gram = columns * (columns + 1) / 2 * sum_of_products(rows);
    let angle = 7 * ADDITION + 4 * MULTIPLICATION + 3 * DIVISION + 2 * ROOT + 2 * SELECTION;
    let rotation = angle + (2 * columns).saturating_sub(2) * 2 * sum_of_products(2);
    let sweep = columns * (columns - 1) / 2 * rotation;
    gram + SWEEPS as u64 * sweep + 2 * (columns - 1) * SELECTION + SELECTION
}

/// Monomials of degree two or more.
fn products(basis: &MonomialBasis) -> u64 {
    basis
        .exponents
        .iter()
        .filter(|exponents| exponents.iter().sum::<u32>() > 1)
        .count() as u64
}

/// Length of a row of a matrix.
fn columns(program: &Program, matrix: ValueId) -> u64 {
    match program.shape(matrix) {
        Shape::Matrix(_, columns) => columns as u64,
        Shape::Scalar | Shape::Vector(_) => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(lines: &str, expected: &str) {
        let text: String = lines
            .lines()
            .enumerate()
            .map(|(i, line)| format!("%{i}: {}\n", line.trim()))
            .collect();
        let program: Program =
            format!("polynomial f(a) = 1.0 [0], 2.0 [3]\nbasis b(p) = [0], [1], [2]\n{text}")
                .parse()
                .unwrap();
        program.assert_sound();
        let Cost {
            additions,
            multiplications,
            divisions,
            roots,
            elementary,
            selections,
        } = count(&program);
        let counts = [
            (additions, "add"),
            (multiplications, "mul"),
            (divisions, "div"),
            (roots, "sqrt"),
            (elementary, "fn"),
            (selections, "sel"),
        ];
        let counts: Vec<String> = counts
            .iter()
            .filter(|(n, _)| *n > 0)
            .map(|(n, word)| format!("{n} {word}"))
            .collect();
        assert_eq!(counts.join(" "), expected, "{lines}");
    }

    #[test]
    fn counts_follow_the_shapes() {
        let (vector, matrix) = (
            "vec3 = const [1.0, 2.0, 3.0]",
            "mat2x3 = const [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]",
        );
        check(
            &format!("{vector}\nvec3 = sin %0\nvec3 = sqrt %1\nvec3 = neg %2"),
            "3 sqrt 3 fn",
        );
        check(
            &format!("{vector}\n{matrix}\nvec2 = matmul %1, %0"),
            "4 add 6 mul",
        );
        check(
            &format!("{vector}\nreal = dot %0, %0\nvec3 = div %0, %1"),
            "2 add 3 mul 3 div",
        );
        check("real = const 2.0\nreal = polynomial f, %0", "1 add 3 mul");
        check("real = const 2.0\nreal = powi %0, 7", "4 mul");
        check(
            "vec1 = const [2.0]\nvec3 = basis_rate b, %0, %0",
            "1 add 3 mul",
        );
    }

    #[test]
    fn tables_at_one_place_count_it_once() {
        // The place: two comparisons and a difference on each axis. Splines: four of three steps. The value: four
        // curves of three steps, and the sum of four products.
        let (place, splines, value) = ([2, 0, 4], [12, 12, 0], [15, 16, 0]);
        // Derivatives have a step less.
        let (splines_d1, value_d1) = ([8, 8, 0], [11, 12, 0]);
        let check = |calls: &str, parts: &[[u64; 3]]| {
            let numbers = vec![1.0; 20];
            let text = format!(
                "input x: vec2\ntable f(a, b) = breaks [0.0, 1.0, 2.0], breaks [0.0, 1.0], cubic clamp {numbers:?}\n\
                 tables at(a, b) = f [0, 0], f [1, 0], f [0, 1]\n%0: vec2 = input x\n%1: real = element %0, 0, 0\n\
                 %2: real = element %0, 1, 0\n%3: {calls}, %1, %2\noutput y = %3"
            );
            let program: Program = text.parse().unwrap();
            program.assert_sound();
            let sum = |at: usize| parts.iter().map(|part| part[at]).sum::<u64>();
            let cost = count(&program);
            let counts = [cost.additions, cost.multiplications, cost.selections];
            assert_eq!(counts, [0, 1, 2].map(sum), "{calls}");
        };
        check("real = table f 0 0", &[place, splines, value]);
        check("real = table f 1 0", &[place, splines_d1, value]);
        let together = [place, splines, splines_d1, value, value, value_d1];
        check("vec3 = tables at", &together);
    }

    #[test]
    fn solving_counts_its_method() {
        let given = |n: usize| {
            let (a, b) = (
                format!("{:?}", vec![1.0; n * n]),
                format!("{:?}", vec![1.0; n]),
            );
            format!("mat{n}x{n} = const {a}\nvec{n} = const {b}")
        };
        let of = |n: usize| format!("{}\nvec{n} = solve %0, %1", given(n));
        check(&of(2), "3 add 8 mul 1 div");
        check(&of(3), "17 add 33 mul 1 div");
        check(&of(4), "26 add 26 mul 10 div 6 sel");
        // The elimination once, the substitution for each column.
        let columns = format!("{}\nmat4x4 = solve %0, %0", given(4));
        check(&columns, "62 add 62 mul 22 div 6 sel");
        let symmetric = format!("{}\nldlt4 = ldlt %0\nvec4 = solve %2, %1", given(4));
        check(&symmetric, "22 add 32 mul 4 div 4 sel");
    }
}
