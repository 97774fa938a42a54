//! One operation on the entries of its operands.

use nsv_spec::linear::{solve, solve_symmetric};

use crate::ir::basis::Monomial;
use crate::ir::horner::Horner;
use crate::ir::{BasisId, Op, Operator, Program, Shape, Type, ValueId};

use super::{kernel, linear, scalar};

/// How the polynomials and bases of a program are computed.
pub(crate) struct Tables {
    polynomials: Vec<Horner>,
    bases: Vec<Vec<Monomial>>,
}

impl Tables {
    /// The tables of a verified program.
    pub(crate) fn of(program: &Program) -> Tables {
        Tables {
            polynomials: program.polynomials.iter().map(Horner::new).collect(),
            bases: program
                .bases
                .iter()
                .map(|basis| {
                    basis
                        .recipe()
                        .expect("invariant: a verified basis has a recipe")
                })
                .collect(),
        }
    }

    /// Writes the entries of `op` to `out`; `value` gives those of its operands.
    pub(crate) fn apply<'a>(
        &self,
        program: &Program,
        op: &Op,
        value: impl Fn(ValueId) -> &'a [f64],
        out: &mut [f64],
    ) {
        let first = |id: ValueId| value(id)[0];
        let holds = |id: ValueId| first(id) != 0.0;
        match *op {
            Op::Input(_) => panic!("invariant: inputs are given, not computed"),
            Op::Const(ref data) => out.copy_from_slice(data),
            Op::Apply(function, a) => map(value(a), out, |x| {
                scalar::function(function, x, program.fused)
            }),
            Op::PowInt(a, n) => map(value(a), out, |x| scalar::power(x, n)),
            Op::Kernel(function, a) => out[0] = kernel::kernel(function, first(a)),
            Op::Binary(operator, a, b) => binary(operator, value(a), value(b), program.fused, out),
            Op::Compare(comparison, a, b) => {
                out[0] = truth(scalar::comparison(comparison, first(a), first(b)))
            }
            Op::And(a, b) => out[0] = truth(holds(a) && holds(b)),
            Op::Or(a, b) => out[0] = truth(holds(a) || holds(b)),
            Op::Not(a) => out[0] = truth(!holds(a)),
            Op::MulAdd(a, b, c) => mul_add(value(a), value(b), value(c), out),
            Op::Select(c, a, b) => out.copy_from_slice(value(if holds(c) { a } else { b })),
            Op::Array(ref items) => {
                for (entry, &item) in out.iter_mut().zip(items) {
                    *entry = first(item);
                }
            }
            Op::Element(a, row, column) => {
                out[0] = value(a)[row * columns(program.shape(a)) + column]
            }
            Op::MatMul(a, b) => linear::product(
                value(a),
                value(b),
                columns(program.shape(a)),
                columns(program.shape(b)),
                program.fused,
                out,
            ),
            Op::Transpose(a) => {
                let (source, width) = (value(a), columns(program.shape(a)));
                let height = source.len() / width;
                for (index, entry) in out.iter_mut().enumerate() {
                    *entry = source[index % height * width + index / height];
                }
            }
            Op::Dot(a, b) => {
                let pairs = value(a).iter().copied().zip(value(b).iter().copied());
                out[0] = linear::sum_of_products(pairs, program.fused)
            }
            Op::Outer(a, b) => linear::product(value(a), value(b), 1, value(b).len(), false, out),
            Op::SumSquares(a) => {
                out[0] = linear::sum_of_squares(value(a), columns(program.shape(a)), program.fused)
            }
            Op::Solve(a, b) => {
                out.copy_from_slice(value(b));
                let solution = match program.ty(a) {
                    Type::Ldlt(_) => solve_symmetric,
                    _ => solve,
                };
                solution(value(a), columns(program.shape(b)), out)
            }
            Op::Ldlt(a) => out.copy_from_slice(value(a)),
            Op::SingularVector(a) => {
                linear::singular_vector(value(a), columns(program.shape(a)), out)
            }
            Op::Polynomial(id, ref arguments) => {
                let arguments: Vec<f64> =
                    arguments.iter().map(|&argument| first(argument)).collect();
                out[0] = self.polynomials[id.0 as usize].eval(&arguments, program.fused);
            }
            Op::Table(id, ref orders, ref arguments) => {
                let arguments: Vec<f64> =
                    arguments.iter().map(|&argument| first(argument)).collect();
                let table = &program.tables[id.0 as usize].interpolant;
                out[0] = table.value(&arguments, orders);
            }
            Op::TableFamily(id, ref arguments) => {
                let arguments: Vec<f64> =
                    arguments.iter().map(|&argument| first(argument)).collect();
                let members = &program.table_families[id.0 as usize].members;
                for (entry, member) in out.iter_mut().zip(members) {
                    let table = &program.tables[member.table.0 as usize].interpolant;
                    *entry = table.value(&arguments, &member.orders);
                }
            }
            Op::Family(id, z) => {
                let (members, z) = (&program.families[id.0 as usize].members, first(z));
                for (entry, member) in out.iter_mut().zip(members) {
                    *entry = member.eval(z, program.fused);
                }
            }
            Op::Basis(id, z) => self.monomials(id, [value(z); 3], 0, out),
            Op::BasisRate(id, z, z1) => {
                self.monomials(id, [value(z), value(z1), value(z1)], 1, out)
            }
            Op::BasisRate2(id, z, z1, z2) => {
                self.monomials(id, [value(z), value(z1), value(z2)], 2, out)
            }
        }
    }

    /// The monomials of a basis (`order` 0) or their first or second rates, from the inputs and their rates.
    fn monomials(&self, id: BasisId, [z, z1, z2]: [&[f64]; 3], order: usize, out: &mut [f64]) {
        let recipe = &self.bases[id.0 as usize];
        let mut made: Vec<[f64; 3]> = Vec::with_capacity(recipe.len());
        for monomial in recipe {
            made.push(match *monomial {
                Monomial::One => [1.0, 0.0, 0.0],
                Monomial::Input(i) => [z[i], z1[i], z2[i]],
                Monomial::Product { of, input: i } => {
                    let [p, p1, p2] = made[of];
                    [
                        p * z[i],
                        p1 * z[i] + p * z1[i],
                        p2 * z[i] + 2.0 * p1 * z1[i] + p * z2[i],
                    ]
                }
            });
        }
        for (entry, rates) in out.iter_mut().zip(made) {
            *entry = rates[order];
        }
    }
}

/// Length of a row; a vector is a column.
fn columns(shape: Shape) -> usize {
    match shape {
        Shape::Matrix(_, columns) => columns,
        Shape::Scalar | Shape::Vector(_) => 1,
    }
}

fn truth(value: bool) -> f64 {
    if value { 1.0 } else { 0.0 }
}

/// b is a scalar or as long as a.
fn mul_add(a: &[f64], b: &[f64], c: &[f64], out: &mut [f64]) {
    let factor = |i: usize| if b.len() == 1 { b[0] } else { b[i] };
    for (i, entry) in out.iter_mut().enumerate() {
        *entry = f64::mul_add(a[i], factor(i), c[i]);
    }
}

fn map(a: &[f64], out: &mut [f64], f: impl Fn(f64) -> f64) {
    for (entry, &x) in out.iter_mut().zip(a) {
        *entry = f(x);
    }
}

/// Elementwise; an operand of one entry is broadcast.
fn binary(operator: Operator, a: &[f64], b: &[f64], fused: bool, out: &mut [f64]) {
    for (i, entry) in out.iter_mut().enumerate() {
        let (x, y) = (
            a[if a.len() == 1 { 0 } else { i }],
            b[if b.len() == 1 { 0 } else { i }],
        );
        *entry = scalar::operator(operator, x, y, fused);
    }
}
