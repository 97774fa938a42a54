//! Calls of functions and of polynomial data.

use super::typing;
use super::{
    Dimension, Elaborator, ExprId, Fault, Function, Node, NodeId, Operator, Shape, Span, Type,
};
use crate::diagnostic::{Rule, quoted};
use crate::expr::arena::PolynomialId;
use crate::expr::builtin::{self, Builtin};
use crate::expr::scope::Symbol;
use crate::expr::syntax::Name;
use crate::suggest::nearest;

impl Elaborator<'_> {
    /// `name(arguments)`
    pub(super) fn call(&mut self, span: Span, name: &Name, arguments: &[NodeId]) -> Option<ExprId> {
        if let Some(builtin) = builtin::find(&name.text) {
            self.count(span, &name.text, builtin.arity(), arguments.len())?;
            return self.builtin(span, &name.text, builtin, arguments);
        }
        let (polynomial, names) = self.polynomial(name)?;
        self.count(span, &name.text, names.len(), arguments.len())?;
        self.apply_polynomial(&name.text, polynomial, &names, arguments)
    }

    /// `partial(polynomial, argument, at..)`
    pub(super) fn partial(
        &mut self,
        span: Span,
        polynomial: &Name,
        argument: &Name,
        at: &[NodeId],
    ) -> Option<ExprId> {
        let (id, names) = self.polynomial(polynomial)?;
        let index = names.iter().position(|name| *name == argument.text);
        let count = self.count(span, &polynomial.text, names.len(), at.len());
        let Some(index) = index else {
            let message = format!(
                "polynomial data `{}` has no argument `{}`",
                polynomial.text, argument.text
            );
            let meant = nearest(&argument.text, &names);
            let otherwise = || format!("its arguments are {}", names.join(", "));
            let fault = Fault::unknown(Rule::E0306, message, argument, meant, otherwise);
            return self.report(argument.span, fault, &[]);
        };
        count?;
        let derivative = self.scope.derivative(id, index);
        self.apply_polynomial(&polynomial.text, derivative, &names, at)
    }

    /// The polynomial data of a name in place of a function.
    fn polynomial(&mut self, name: &Name) -> Option<(PolynomialId, Vec<String>)> {
        let text = &name.text;
        let fault = match self.scope.resolve(text) {
            Some(Symbol::Polynomial(id, arguments)) => return Some((id, arguments)),
            Some(Symbol::Faulty) => return None,
            None if builtin::find(text).is_some() => Fault::new(
                Rule::E0304,
                format!("`{text}` is a function of the language, expected polynomial data"),
                "`partial` differentiates polynomial data only; write other derivatives out",
            ),
            Some(Symbol::Unavailable(why)) => {
                self.unavailable(name.span, text, why);
                return None;
            }
            Some(_) => Fault::new(
                Rule::E0304,
                format!("`{text}` is a value, expected a function"),
                format!("write `*` to multiply: `{text}*(..)`"),
            ),
            None => {
                let data = self.scope.names().into_iter();
                let data = data.filter(|known| {
                    matches!(self.scope.resolve(known), Some(Symbol::Polynomial(..)))
                });
                let known = builtin::names().map(str::to_owned).chain(data);
                let meant = builtin::elsewhere(text).or_else(|| nearest(text, known));
                let message = format!("unknown function {}", quoted(text));
                Fault::unknown(Rule::E0302, message, name, meant, || {
                    let names: Vec<&str> = builtin::names().collect();
                    format!("functions are {}", names.join(", "))
                })
            }
        };
        self.report(name.span, fault, &[])
    }

    fn count(&mut self, span: Span, name: &str, expected: usize, found: usize) -> Option<()> {
        if expected == found {
            return Some(());
        }
        let plural = if expected == 1 { "" } else { "s" };
        let message = format!("`{name}` takes {expected} argument{plural}, found {found}");
        let help = match name {
            "min" | "max" if found > 2 => format!("nest it: `{name}(a, {name}(b, c))`"),
            "if" => "write `if(condition, value, otherwise)`".to_owned(),
            _ => format!("give it {expected} argument{plural}, separated by commas"),
        };
        self.report(span, Fault::new(Rule::E0305, message, help), &[])
    }

    fn apply_polynomial(
        &mut self,
        name: &str,
        id: PolynomialId,
        names: &[String],
        arguments: &[NodeId],
    ) -> Option<ExprId> {
        let mut values = Vec::new();
        for (argument, &node) in names.iter().zip(arguments) {
            let what = format!("argument `{argument}` of `{name}`");
            let Some((value, real)) = self.real(node, &what) else {
                continue;
            };
            let checked = match real.shape {
                Shape::Scalar => typing::dimensionless(&what, real.dimensions[0]),
                array => {
                    let message = format!("shape mismatch: {what} is {array}, expected a scalar");
                    Err(Fault::new(
                        Rule::E0501,
                        message,
                        "take one entry of the array",
                    ))
                }
            };
            match checked {
                Ok(()) => values.push(value),
                Err(fault) => {
                    let span = self.span_of(node);
                    self.report::<()>(span, fault, &[]);
                }
            }
        }
        let complete = values.len() == arguments.len();
        complete.then(|| {
            self.arena
                .intern(Node::Polynomial(id, values), Type::scalar(Dimension::ONE))
        })
    }

    /// A function of the language; the number of arguments is right.
    fn builtin(
        &mut self,
        span: Span,
        name: &str,
        builtin: Builtin,
        arguments: &[NodeId],
    ) -> Option<ExprId> {
        match (builtin, arguments) {
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
            (Builtin::Norm, &[argument]) => self.norm(span, argument),
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
}
