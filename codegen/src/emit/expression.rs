//! One value as a Rust expression, parenthesised where the precedence of Rust's operators asks for it and nowhere else.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::emit::family::FamilyNames;
use crate::emit::methods::{comparison_name, function_name, kernel_name, operator_name};
use crate::emit::names::ident;
use crate::emit::table::Tables;
use crate::emit::types::{constant, index};
use crate::ir::{Function, Op, Operator, Program, Shape, Type, ValueId};

/// Fewest entries of a matrix that is written by those that are not zeros.
const SPARSE: usize = 64;

/// How tightly the outermost operator of an expression binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    /// `a + b`, `a - b`.
    Sum,
    /// `a * b`, `a / b`.
    Product,
    /// `-a`.
    Unary,
    /// Names, calls, methods, fields, entries.
    Postfix,
}

/// An expression with its binding strength.
#[derive(Clone, Debug)]
pub(crate) struct Fragment {
    /// The expression.
    pub(crate) tokens: TokenStream,
    /// Its outermost operator.
    pub(crate) level: Level,
}

impl Fragment {
    /// A name, call or the like.
    pub(crate) fn postfix(tokens: TokenStream) -> Fragment {
        Fragment {
            tokens,
            level: Level::Postfix,
        }
    }

    /// The expression where an operand of at least `level` is expected.
    pub(crate) fn at(self, level: Level) -> TokenStream {
        let Fragment { tokens, level: own } = self;
        if own < level {
            quote!((#tokens))
        } else {
            tokens
        }
    }
}

/// Names of everything a function's expressions refer to.
pub(crate) struct Names<'a> {
    /// The program.
    pub(crate) program: &'a Program,
    /// Expression of each input, by position.
    pub(crate) inputs: Vec<TokenStream>,
    /// Variable of each bound value.
    pub(crate) variables: Vec<Option<Ident>>,
    /// Variables of values that are entries of a pack.
    pub(crate) packs: BTreeMap<ValueId, Vec<TokenStream>>,
    /// Function of each polynomial, by position.
    pub(crate) polynomials: Vec<TokenStream>,
    /// Functions of the tables.
    pub(crate) tables: &'a Tables,
    /// Each family of polynomials, by position.
    pub(crate) families: Vec<Option<FamilyNames>>,
    /// Each family of tables, by position.
    pub(crate) table_families: Vec<Option<FamilyNames>>,
    /// Functions of each basis, by position: value, rate, second rate.
    pub(crate) bases: Vec<[TokenStream; 3]>,
}

impl Names<'_> {
    /// The value where it is used: its variable, or the formula.
    pub(crate) fn operand(&self, id: ValueId) -> Fragment {
        match &self.variables[id.0 as usize] {
            Some(variable) => Fragment::postfix(match self.family(id) {
                Some(family) => {
                    let fields = &family.fields;
                    quote!(Vector([#(#variable.#fields),*]))
                }
                None => quote!(#variable),
            }),
            None => self.formula(id),
        }
    }

    /// The formula of a value.
    pub(crate) fn formula(&self, id: ValueId) -> Fragment {
        let ty = self.program.ty(id);
        Fragment::postfix(match &self.program.instruction(id).op {
            Op::Const(data) => constant(ty, data),
            Op::Input(index) => self.inputs[*index].clone(),
            Op::Apply(Function::Neg, a) => {
                let a = self.at(*a, Level::Postfix);
                return Fragment {
                    tokens: quote!(-#a),
                    level: Level::Unary,
                };
            }
            Op::Apply(function, a) => {
                self.method(*a, function_name(*function, self.program.fused), &[])
            }
            Op::Kernel(kernel, a) => {
                let name = ident(kernel_name(*kernel));
                self.call(&quote!(kernel::#name), &[*a])
            }
            Op::Binary(operator, a, b) => return self.binary(*operator, *a, *b),
            Op::PowInt(a, n) => {
                let (base, n) = (self.at(*a, Level::Postfix), Literal::u32_unsuffixed(*n));
                quote!(#base.powi(#n))
            }
            Op::Compare(comparison, a, b) => self.method(*a, comparison_name(*comparison), &[*b]),
            Op::And(a, b) => self.method(*a, "and", &[*b]),
            Op::Or(a, b) => self.method(*a, "or", &[*b]),
            Op::Not(a) => self.method(*a, "not", &[]),
            Op::MulAdd(a, b, c) => {
                let scaled = self.program.shape(*a) != self.program.shape(*b);
                let name = if scaled { "scale_add" } else { "mul_add" };
                self.method(*a, name, &[*b, *c])
            }
            Op::Select(condition, a, b) => self.select(ty, *condition, *a, *b),
            Op::Array(items) => self.array(ty, items),
            Op::Element(a, row, column) => self.element(*a, *row, *column),
            Op::MatMul(a, b) => match self.transposed(*a) {
                Some(a) if matches!(self.program.shape(*b), Shape::Vector(_)) => {
                    self.method(a, self.fused("transpose_mul"), &[*b])
                }
                _ if self.program.fused => {
                    let vector = matches!(self.program.shape(*b), Shape::Vector(_));
                    let name = if vector { "mul_fused" } else { "matmul_fused" };
                    self.method(*a, name, &[*b])
                }
                _ => return self.infix(Level::Product, *a, &quote!(*), *b),
            },
            Op::Transpose(a) => self.method(*a, "transpose", &[]),
            Op::Dot(a, b) => self.method(*a, self.fused("dot"), &[*b]),
            Op::Outer(a, b) => self.method(*a, "outer", &[*b]),
            Op::SumSquares(a) if is_scalar(self.program.ty(*a)) => {
                let a = self.at(*a, Level::Postfix);
                quote!(#a.powi(2))
            }
            Op::SumSquares(a) => self.method(*a, self.fused("sum_squares"), &[]),
            Op::Solve(a, b) => match self.program.shape(*b) {
                Shape::Matrix(..) => self.method(*a, "solve_columns", &[*b]),
                _ => self.method(*a, "solve", &[*b]),
            },
            Op::Ldlt(a) => self.method(*a, "ldlt", &[]),
            Op::SingularVector(a) => self.method(*a, "singular_vector", &[]),
            Op::Polynomial(polynomial, arguments) => {
                self.call(&self.polynomials[polynomial.0 as usize], arguments)
            }
            Op::Table(_, _, arguments) => {
                let function = self
                    .tables
                    .path(self.program, &self.program.instruction(id).op);
                self.call(&function, arguments)
            }
            op @ (Op::Family(..) | Op::TableFamily(..)) => {
                let family = self.family(id).expect("invariant: the value of a family");
                self.call(&family.path(), &op.operands())
            }
            Op::Basis(basis, z) => self.call(&self.bases[basis.0 as usize][0], &[*z]),
            Op::BasisRate(basis, z, rate) => {
                self.call(&self.bases[basis.0 as usize][1], &[*z, *rate])
            }
            Op::BasisRate2(basis, z, rate, rate2) => {
                self.call(&self.bases[basis.0 as usize][2], &[*z, *rate, *rate2])
            }
        })
    }

    /// The method of that name, or where the program is fused its fused form.
    fn fused(&self, name: &'static str) -> &'static str {
        match name {
            _ if !self.program.fused => name,
            "dot" => "dot_fused",
            "sum_squares" => "sum_squares_fused",
            _ => "transpose_mul_fused",
        }
    }

    /// The names of the family whose values these are.
    pub(crate) fn family(&self, id: ValueId) -> Option<&FamilyNames> {
        match self.program.instruction(id).op {
            Op::Family(family, _) => self.families[family.0 as usize].as_ref(),
            Op::TableFamily(family, _) => self.table_families[family.0 as usize].as_ref(),
            _ => None,
        }
    }

    fn element(&self, array: ValueId, row: usize, column: usize) -> TokenStream {
        if let Some(family) = self.family(array) {
            let (values, field) = (&self.variables[array.0 as usize], &family.fields[row]);
            return quote!(#values.#field);
        }
        if let Some(entries) = self.packs.get(&array) {
            return entries[row].clone();
        }
        let matrix = matches!(self.program.shape(array), Shape::Matrix(..));
        let (array, row, column) = (self.at(array, Level::Postfix), index(row), index(column));
        if matrix {
            quote!(#array[(#row, #column)])
        } else {
            quote!(#array[#row])
        }
    }

    /// A, for A^T that has no variable.
    fn transposed(&self, id: ValueId) -> Option<ValueId> {
        match (
            &self.variables[id.0 as usize],
            &self.program.instruction(id).op,
        ) {
            (None, Op::Transpose(a)) => Some(*a),
            _ => None,
        }
    }

    fn at(&self, id: ValueId, level: Level) -> TokenStream {
        self.operand(id).at(level)
    }

    fn call(&self, function: &TokenStream, arguments: &[ValueId]) -> TokenStream {
        let arguments = arguments.iter().map(|&id| self.at(id, Level::Sum));
        quote!(#function(#(#arguments),*))
    }

    fn method(&self, receiver: ValueId, name: &str, arguments: &[ValueId]) -> TokenStream {
        let (receiver, name) = (self.at(receiver, Level::Postfix), ident(name));
        let arguments = arguments.iter().map(|&id| self.at(id, Level::Sum));
        quote!(#receiver.#name(#(#arguments),*))
    }

    fn infix(&self, level: Level, a: ValueId, operator: &TokenStream, b: ValueId) -> Fragment {
        let tighter = if level == Level::Sum {
            Level::Product
        } else {
            Level::Unary
        };
        let (a, b) = (self.at(a, level), self.at(b, tighter));
        Fragment {
            tokens: quote!(#a #operator #b),
            level,
        }
    }

    fn select(&self, ty: Type, condition: ValueId, a: ValueId, b: ValueId) -> TokenStream {
        match ty {
            Type::Bool => {
                let condition = self.at(condition, Level::Postfix);
                let (a, b) = (self.at(a, Level::Sum), self.at(b, Level::Sum));
                quote!(#condition.and(#a).or(#condition.not().and(#b)))
            }
            Type::Real(Shape::Scalar) => self.call(&quote!(T::select), &[condition, a, b]),
            Type::Real(Shape::Vector(_)) => self.call(&quote!(Vector::select), &[condition, a, b]),
            Type::Real(Shape::Matrix(..)) => self.call(&quote!(Matrix::select), &[condition, a, b]),
            Type::Ldlt(_) => panic!("invariant: matrices are chosen before they are factorised"),
        }
    }

    fn array(&self, ty: Type, ids: &[ValueId]) -> TokenStream {
        let items: Vec<TokenStream> = ids.iter().map(|&id| self.at(id, Level::Sum)).collect();
        match ty {
            Type::Real(shape @ Shape::Matrix(..)) if self.is_sparse(ids) => {
                self.sparse(shape, ids, &items)
            }
            Type::Real(Shape::Matrix(_, columns)) => {
                let rows = items.chunks(columns).map(|row| quote!([#(#row),*]));
                quote!(Matrix::rows([#(#rows),*]))
            }
            _ => quote!(Vector([#(#items),*])),
        }
    }

    /// Whether a scalar is the literal 0.
    fn is_zero(&self, id: ValueId) -> bool {
        matches!(&self.program.instruction(id).op, Op::Const(data) if data[0].to_bits() == 0)
    }

    /// Whether an array is large and at least half of its entries are zeros.
    fn is_sparse(&self, items: &[ValueId]) -> bool {
        let zeros = items.iter().filter(|&&id| self.is_zero(id)).count();
        items.len() >= SPARSE && 2 * zeros >= items.len()
    }

    /// Zeros, and then the other entries: places that rustc knows, where the rows of a large matrix are copied in a loop.
    fn sparse(&self, shape: Shape, ids: &[ValueId], items: &[TokenStream]) -> TokenStream {
        let Shape::Matrix(rows, columns) = shape else {
            panic!("invariant: only matrices are sparse")
        };
        let entries = (0..).zip(ids).zip(items);
        let entries = entries.filter(|((_, id), _)| !self.is_zero(**id));
        let entries = entries.map(|((at, _), item): ((usize, _), _)| {
            let (row, column) = (index(at / columns), index(at % columns));
            quote!(sparse[(#row, #column)] = #item;)
        });
        let (rows, columns) = (index(rows), index(columns));
        quote!({
            let mut sparse = Matrix::<T, #rows, #columns>::zero();
            #(#entries)*
            sparse
        })
    }

    fn binary(&self, operator: Operator, a: ValueId, b: ValueId) -> Fragment {
        match (self.program.shape(a), self.program.shape(b)) {
            (Shape::Scalar, Shape::Scalar) => match operator {
                Operator::Add => self.infix(Level::Sum, a, &quote!(+), b),
                Operator::Sub => self.infix(Level::Sum, a, &quote!(-), b),
                Operator::Mul => self.infix(Level::Product, a, &quote!(*), b),
                Operator::Div => self.infix(Level::Product, a, &quote!(/), b),
                other => Fragment::postfix(self.method(
                    a,
                    operator_name(other, self.program.fused),
                    &[b],
                )),
            },
            (_, Shape::Scalar) => self.array_with_scalar(operator, a, b),
            (Shape::Scalar, _) => self.scalar_with_array(operator, a, b),
            _ => self.array_with_array(operator, a, b),
        }
    }

    fn array_with_array(&self, operator: Operator, a: ValueId, b: ValueId) -> Fragment {
        Fragment::postfix(match operator {
            Operator::Add => return self.infix(Level::Sum, a, &quote!(+), b),
            Operator::Sub => return self.infix(Level::Sum, a, &quote!(-), b),
            Operator::Mul => self.method(a, "hadamard", &[b]),
            Operator::Div => self.method(a, "quotient", &[b]),
            other => self.method(a, operator_name(other, self.program.fused), &[b]),
        })
    }

    fn array_with_scalar(&self, operator: Operator, array: ValueId, scalar: ValueId) -> Fragment {
        Fragment::postfix(match operator {
            Operator::Add => self.method(array, "add_scalar", &[scalar]),
            Operator::Sub => {
                // a - s == a + -s (exact)
                let (array, scalar) = (
                    self.at(array, Level::Postfix),
                    self.at(scalar, Level::Postfix),
                );
                quote!(#array.add_scalar(-#scalar))
            }
            Operator::Mul => return self.infix(Level::Product, array, &quote!(*), scalar),
            Operator::Div => return self.infix(Level::Product, array, &quote!(/), scalar),
            other => {
                let (scalar, array_name) = (
                    self.splat(array, scalar),
                    operator_name(other, self.program.fused),
                );
                let (array, name) = (self.at(array, Level::Postfix), ident(array_name));
                quote!(#array.#name(#scalar))
            }
        })
    }

    fn scalar_with_array(&self, operator: Operator, scalar: ValueId, array: ValueId) -> Fragment {
        Fragment::postfix(match operator {
            // s + a == a + s (exact)
            Operator::Add => self.method(array, "add_scalar", &[scalar]),
            Operator::Sub => {
                // s - a == -a + s (exact)
                let (array, scalar) = (self.at(array, Level::Postfix), self.at(scalar, Level::Sum));
                quote!((-#array).add_scalar(#scalar))
            }
            // s * a == a * s (exact)
            Operator::Mul => return self.infix(Level::Product, array, &quote!(*), scalar),
            other => {
                let name = match other {
                    Operator::Div => "quotient",
                    other => operator_name(other, self.program.fused),
                };
                let (splat, name) = (self.splat(array, scalar), ident(name));
                let array = self.at(array, Level::Sum);
                quote!(#splat.#name(#array))
            }
        })
    }

    /// The scalar in every entry of an array shaped like `array`.
    fn splat(&self, array: ValueId, scalar: ValueId) -> TokenStream {
        let scalar = self.at(scalar, Level::Sum);
        match self.program.shape(array) {
            Shape::Matrix(..) => quote!(Matrix::splat(#scalar)),
            _ => quote!(Vector::splat(#scalar)),
        }
    }
}

fn is_scalar(ty: Type) -> bool {
    ty == Type::Real(Shape::Scalar)
}

#[cfg(test)]
mod tests {
    use crate::emit::standalone;
    use crate::ir::Program;

    /// The last `let` of a program of these instructions on `a, b: real`, `v: vec2` and `m: mat2x2`.
    fn check(instructions: &str, expected: &str) {
        let frame = "input a: real\ninput b: real\ninput v: vec2\ninput m: mat2x2\n\
                     %0: real = input a\n%1: real = input b\n%2: vec2 = input v\n%3: mat2x2 = input m\n";
        let lines = instructions.split("; ").enumerate();
        let lines: String = lines
            .map(|(index, line)| format!("%{}: {line}\n", index + 4))
            .collect();
        let last = instructions.split("; ").count() + 3;
        let program: Program = format!("{frame}{lines}output y = %{last}")
            .parse()
            .expect("a program");
        program.assert_sound();
        let text = standalone(&program);
        let line = text
            .lines()
            .rfind(|line| line.trim_start().starts_with("let y"));
        assert_eq!(line.map(str::trim), Some(expected), "{text}");
    }

    #[test]
    fn parentheses_keep_the_order_of_operations() {
        check(
            "real = add %0, %1; real = add %0, %4",
            "let y = a + (a + b);",
        );
        check("real = add %0, %1; real = add %4, %0", "let y = a + b + a;");
        check(
            "real = div %0, %1; real = mul %0, %4",
            "let y = a * (a / b);",
        );
        check(
            "real = sub %0, %1; real = mul %4, %0",
            "let y = (a - b) * a;",
        );
        check(
            "real = add %0, %1; real = neg %4; real = sin %5",
            "let y = (-(a + b)).sin();",
        );
        check(
            "real = mul %0, %1; real = neg %4; real = neg %5",
            "let y = -(-(a * b));",
        );
        check(
            "real = neg %0; real = mul %4, %1; real = sub %0, %5",
            "let y = a - -a * b;",
        );
        check(
            "real = add %0, %1; real = powi %4, 3",
            "let y = (a + b).powi(3);",
        );
    }

    #[test]
    fn arrays_use_operators_where_there_are_some() {
        check(
            "vec2 = matmul %3, %2; vec2 = mul %0, %4",
            "let y = m * v * a;",
        );
        check(
            "vec2 = mul %2, %2; vec2 = div %4, %2",
            "let y = v.hadamard(v).quotient(v);",
        );
        check("vec2 = sub %0, %2", "let y = (-v).add_scalar(a);");
        check("vec2 = sub %2, %0", "let y = v.add_scalar(-a);");
        check("vec2 = div %0, %2", "let y = Vector::splat(a).quotient(v);");
        check("vec2 = min %2, %0", "let y = v.min(Vector::splat(a));");
        check(
            "vec2 = atan2 %2, %2; vec2 = tanh %4",
            "let y = v.atan2(v).tanh();",
        );
        check(
            "real = element %3, 1, 0; real = element %2, 1, 0; real = mul %4, %5",
            "let y = m[(1, 0)] * v[1];",
        );
    }

    #[test]
    fn truth_values_use_masks() {
        check(
            "bool = lt %0, %1; bool = not %4; real = select %5, %0, %1",
            "let y = T::select(a.lt(b).not(), a, b);",
        );
        check(
            "bool = lt %0, %1; bool = and %4, %4; vec2 = select %5, %2, %2",
            "let y = Vector::select(t1.and(t1), v, v);",
        );
    }
}
