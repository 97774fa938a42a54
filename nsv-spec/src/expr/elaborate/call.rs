//! Calls of the functions of the language.

use super::typing;
use super::{
    Dimension, Elaborator, ExprId, Fault, Function, Node, NodeId, Operator, Real, Shape, Span,
    Symbol,
};
use crate::diagnostic::Rule;
use crate::expr::builtin::{self, Builtin, Entry};
use crate::expr::syntax::Name;

impl Elaborator<'_> {
    /// `name(arguments)`
    pub(super) fn call(&mut self, span: Span, name: &Name, arguments: &[NodeId]) -> Option<ExprId> {
        if let Some(entry) = builtin::find(&name.text) {
            self.count(span, &name.text, entry.arguments.len(), arguments.len())?;
            return self.builtin(span, entry, arguments);
        }
        if let Some(Symbol::Function(function)) = self.resolve(&name.text) {
            self.count(span, &name.text, function.arguments.len(), arguments.len())?;
            return self.insert(span, &function, arguments);
        }
        self.call_data(span, name, arguments)
    }

    pub(super) fn count(
        &mut self,
        span: Span,
        name: &str,
        expected: usize,
        found: usize,
    ) -> Option<()> {
        if expected == found {
            return Some(());
        }
        let plural = if expected == 1 { "" } else { "s" };
        let message = format!("`{name}` takes {expected} argument{plural}, found {found}");
        let help = match name {
            "min" | "max" if found > 2 => format!("nest it: `{name}(a, {name}(b, c))`"),
            "if" => "write `if(condition, value, otherwise)`".to_owned(),
            "inverse" => "write `solve(M, b)` for the solution of `M*x = b`".to_owned(),
            "solve" if found == 1 => "write `inverse(M)` for the inverse alone".to_owned(),
            "solve" => "put the right side into brackets: `solve(M, [a, b])`".to_owned(),
            _ if expected == 1 => "give it one argument".to_owned(),
            _ => format!("give it {expected} argument{plural}, separated by commas"),
        };
        self.report(span, Fault::new(Rule::E0305, message, help), &[])
    }

    /// A function of the language; the number of arguments is right.
    fn builtin(&mut self, span: Span, entry: &Entry, arguments: &[NodeId]) -> Option<ExprId> {
        let name = entry.name;
        match (entry.builtin, arguments) {
            (Builtin::Apply(function), &[argument]) => {
                let (id, real) = self.real(argument, &format!("argument of `{name}`"))?;
                self.typed(
                    span,
                    Node::Apply(function, id),
                    typing::apply(name, function, &real),
                    arguments,
                )
            }
            (Builtin::Binary(operator), &[left, right]) => {
                let ((a, x), (b, y)) = self.reals(name, left, right)?;
                let ty = if operator == Operator::Atan2 {
                    typing::angle(&x, &y)
                } else {
                    typing::agreeing(name, &x, &y)
                };
                self.typed(span, Node::Binary(operator, a, b), ty, arguments)
            }
            (Builtin::Pow, &[base, exponent]) => self.power(span, base, exponent),
            (Builtin::If, &[condition, yes, no]) => self.choose(span, condition, yes, no),
            (Builtin::Dot, &[left, right]) => {
                let ((a, x), (b, y)) = self.reals(name, left, right)?;
                self.typed(span, Node::Dot(a, b), typing::dot(&x, &y), arguments)
            }
            (Builtin::Cross, &[left, right]) => {
                let ((a, x), (b, y)) = self.reals(name, left, right)?;
                self.typed(span, Node::Cross(a, b), typing::cross(&x, &y), arguments)
            }
            (Builtin::Solve, &[matrix, right]) => {
                let ((a, x), (b, y)) = self.reals(name, matrix, right)?;
                self.typed(span, Node::Solve(a, b), typing::solution(&x, &y), arguments)
            }
            (Builtin::Inverse, &[matrix]) => self.inverse(span, matrix),
            (Builtin::Norm, &[argument]) => self.norm(span, argument),
            (Builtin::Fold(operator), &[argument]) => self.fold(span, name, operator, argument),
            (Builtin::Diagonal, &[argument]) => self.diagonal(span, argument),
            (Builtin::Defined { unit, .. }, arguments) => {
                self.insert_defined(span, entry, unit, arguments)
            }
            (Builtin::Transpose, &[argument]) => {
                let (id, real) = self.real(argument, "argument of `transpose`")?;
                self.typed(
                    span,
                    Node::Transpose(id),
                    typing::transpose(&real),
                    arguments,
                )
            }
            _ => unreachable!("invariant: the arguments were counted"),
        }
    }

    /// `if(condition, yes, no)`
    fn choose(&mut self, span: Span, condition: NodeId, yes: NodeId, no: NodeId) -> Option<ExprId> {
        let condition = self.truth(condition, "the condition of `if`");
        let ((a, x), (b, y)) = self.reals("if", yes, no)?;
        if x.shape != y.shape {
            let message = format!(
                "shape mismatch: the values of `if` are {} and {}",
                x.shape, y.shape
            );
            let fault = Fault::new(Rule::E0501, message, "both values have one shape");
            return self.report(span, fault, &[yes, no]);
        }
        let ty = typing::agreeing("if", &x, &y);
        self.typed(span, Node::If(condition?, a, b), ty, &[yes, no])
    }

    /// norm(v) = sqrt(dot(v, v))
    fn norm(&mut self, span: Span, argument: NodeId) -> Option<ExprId> {
        let (id, real) = self.real(argument, "argument of `norm`")?;
        if !matches!(real.shape, Shape::Vector(_)) {
            let help = if real.shape == Shape::Scalar {
                "use `abs` for a scalar"
            } else {
                "`norm` is the length of a vector"
            };
            let message = format!(
                "shape mismatch: `norm` of {}, expected a vector",
                real.shape
            );
            return self.report(span, Fault::new(Rule::E0501, message, help), &[]);
        }
        let square_type = match typing::dot(&real, &real) {
            Ok(ty) => ty,
            Err(fault) => return self.report(span, fault, &[]),
        };
        let root_type = typing::apply("norm", Function::Sqrt, &square_type);
        let square = self.arena.intern(Node::Dot(id, id), square_type.into());
        self.typed(span, Node::Apply(Function::Sqrt, square), root_type, &[])
    }

    /// All entries of an array joined by an operator.
    fn fold(
        &mut self,
        span: Span,
        name: &str,
        operator: Operator,
        argument: NodeId,
    ) -> Option<ExprId> {
        let (id, real) = self.real(argument, &format!("argument of `{name}`"))?;
        if real.shape == Shape::Scalar {
            let message = format!("shape mismatch: `{name}` of a scalar, expected an array");
            let fault = Fault::new(Rule::E0501, message, "write a vector: `[a, b]`");
            return self.report(span, fault, &[]);
        }
        let cols = real.shape.size().1;
        let mut folded: Option<(ExprId, Real)> = None;
        for (place, &dimension) in real.dimensions.iter().enumerate() {
            let entry = self.entry(id, place / cols, place % cols);
            let one = Real::scalar(dimension);
            folded = Some(match folded {
                None => (entry, one),
                Some((so_far, ty)) => {
                    let ty = typing::agreeing(name, &ty, &one);
                    let node = Node::Binary(operator, so_far, entry);
                    let id = self.typed(span, node, ty, &[])?;
                    self.real_value(span, id, "a sum")?
                }
            });
        }
        folded.map(|(id, _)| id)
    }

    /// inverse(a) = solve(a, I)
    fn inverse(&mut self, span: Span, argument: NodeId) -> Option<ExprId> {
        let (id, real) = self.real(argument, "argument of `inverse`")?;
        let ty = match typing::inverse(&real) {
            Ok(ty) => ty,
            Err(fault) => return self.report(span, fault, &[argument]),
        };
        let one = self.literal(1.0, Dimension::ONE);
        let rows = real.shape.size().0;
        let identity = self.on_diagonal(vec![(one, Dimension::ONE); rows]);
        Some(self.arena.intern(Node::Solve(id, identity), ty.into()))
    }

    /// `diag(v)`
    fn diagonal(&mut self, span: Span, argument: NodeId) -> Option<ExprId> {
        let (id, real) = self.real(argument, "argument of `diag`")?;
        let Shape::Vector(rows) = real.shape else {
            let message = format!(
                "shape mismatch: `diag` of {}, expected a vector",
                real.shape
            );
            let fault = Fault::new(
                Rule::E0501,
                message,
                "write the diagonal as a vector: `[a, b]`",
            );
            return self.report(span, fault, &[]);
        };
        let entries = (0..rows).map(|row| (self.entry(id, row, 0), real.dimensions[row]));
        let entries = entries.collect();
        Some(self.on_diagonal(entries))
    }

    /// The matrix with these entries on its diagonal and zeros elsewhere.
    fn on_diagonal(&mut self, diagonal: Vec<(ExprId, Dimension)>) -> ExprId {
        let zero = (self.literal(0.0, Dimension::ANY), Dimension::ANY);
        let rows = diagonal.len();
        let places = (0..rows * rows).map(|place| (place / rows, place % rows));
        let entry = |(row, col)| if row == col { diagonal[row] } else { zero };
        let (entries, dimensions) = places.map(entry).unzip();
        let shape = Shape::Matrix(rows, rows);
        self.arena
            .intern(Node::Array(entries), Real { shape, dimensions }.into())
    }
}
