//! Calls of polynomial data.

use super::typing;
use super::{Dimension, Elaborator, ExprId, Fault, Node, NodeId, Shape, Span, Symbol, Type};
use crate::diagnostic::quoted;
use crate::expr::arena::PolynomialId;
use crate::expr::builtin;
use crate::expr::syntax::Name;
use crate::suggest::nearest;

impl Elaborator<'_> {
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
            let help = match nearest(&argument.text, &names) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("its arguments are {}", names.join(", ")),
            };
            let message = format!(
                "polynomial data `{}` has no argument `{}`",
                polynomial.text, argument.text
            );
            return self.report(argument.span, Fault::new("E0306", message, help), &[]);
        };
        count?;
        let derivative = self.scope.derivative(id, index);
        self.apply_polynomial(&polynomial.text, derivative, &names, at)
    }

    /// The polynomial data of a name in place of a function.
    pub(super) fn polynomial(&mut self, name: &Name) -> Option<(PolynomialId, Vec<String>)> {
        let text = &name.text;
        let fault = match self.resolve(text) {
            Some(Symbol::Polynomial(id, arguments)) => return Some((id, arguments)),
            Some(Symbol::Faulty) => return None,
            None if builtin::find(text).is_some() => Fault::new(
                "E0304",
                format!("`{text}` is a function of the language, expected polynomial data"),
                "`partial` differentiates polynomial data only; write other derivatives out",
            ),
            Some(Symbol::Unavailable(why)) => {
                self.unavailable(name.span, text, why);
                return None;
            }
            Some(_) => Fault::new(
                "E0304",
                format!("`{text}` is a value, expected a function"),
                format!("write `*` to multiply: `{text}*(..)`"),
            ),
            None => {
                let data = self.scope.names().into_iter();
                let data = data
                    .filter(|known| matches!(self.resolve(known), Some(Symbol::Polynomial(..))));
                let help = match nearest(text, builtin::names().map(str::to_owned).chain(data)) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => format!(
                        "functions are {}",
                        builtin::names().collect::<Vec<_>>().join(", ")
                    ),
                };
                Fault::new("E0302", format!("unknown function {}", quoted(text)), help)
            }
        };
        self.report(name.span, fault, &[])
    }

    pub(super) fn apply_polynomial(
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
                    Err(Fault::new("E0501", message, "take one entry of the array"))
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
}
