//! Calls of polynomial data and lookup tables, and their derivatives.

use std::sync::Arc;

use super::typing;
use super::{Dimension, Elaborator, ExprId, Fault, Node, NodeId, Shape, Span, Symbol, Type};
use crate::diagnostic::{Rule, quoted};
use crate::expr::arena::{PolynomialId, TableId};
use crate::expr::builtin;
use crate::expr::scope::Signature;
use crate::expr::syntax::Name;
use crate::suggest::nearest;

/// Most functions of the specification's own that a message names.
const OWN: usize = 8;

impl Elaborator<'_> {
    /// A call of data.
    pub(super) fn call_data(
        &mut self,
        span: Span,
        name: &Name,
        arguments: &[NodeId],
    ) -> Option<ExprId> {
        let data = self.data(name)?;
        let names = data.arguments();
        self.count(span, &name.text, names.len(), arguments.len())?;
        let none = vec![0; names.len()];
        self.apply_data(&name.text, &data, none, arguments)
    }

    /// `partial(data, argument, at..)`
    pub(super) fn partial(
        &mut self,
        span: Span,
        name: &Name,
        argument: &Name,
        at: &[NodeId],
    ) -> Option<ExprId> {
        let mut data = self.data(name)?;
        let names = data.arguments();
        let index = names.iter().position(|name| *name == argument.text);
        let count = self.count(span, &name.text, names.len(), at.len());
        let Some(index) = index else {
            let noun = data.noun();
            let message = format!("{noun} `{}` has no argument `{}`", name.text, argument.text);
            let meant = nearest(&argument.text, &names);
            let otherwise = || format!("its arguments are {}", names.join(", "));
            let fault = Fault::unknown(Rule::E0306, message, argument, meant, otherwise);
            return self.report(argument.span, fault, &[]);
        };
        count?;
        let mut orders = vec![0; names.len()];
        match &mut data {
            Data::Polynomial(id, _) => *id = self.scope.derivative(*id, index),
            Data::Table(..) => orders[index] = 1,
        }
        self.apply_data(&name.text, &data, orders, at)
    }

    /// The last fault with the place from which an argument of a table has its unit.
    fn show_axis(&mut self, path: &str, axis: &str, found: Dimension, wanted: Dimension) {
        let Some(origin) = self.scope.origin(path) else {
            return;
        };
        if let Some(mut fault) = self.faults.pop() {
            let change = match found.is_dimensionless() {
                true => format!(", or take the unit of axis `{axis}` away"),
                false => format!(", or give axis `{axis}` the unit {found}"),
            };
            fault
                .help
                .iter_mut()
                .for_each(|help| help.push_str(&change));
            let label = format!("axis `{axis}` is {}", wanted.in_words());
            self.faults.push(fault.with_related(origin.span, label));
        }
    }

    /// The data of a name in place of a function.
    fn data(&mut self, name: &Name) -> Option<Data> {
        let text = &name.text;
        let fault = match self.resolve(text) {
            Some(Symbol::Polynomial(id, arguments)) => {
                return Some(Data::Polynomial(id, arguments));
            }
            Some(Symbol::Table(id, signature)) => return Some(Data::Table(id, signature)),
            Some(Symbol::Function(_)) => Fault::new(
                Rule::E0304,
                format!("`{text}` is a function, expected polynomial data or a table"),
                "`partial` differentiates data only; write other derivatives out",
            ),
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
                let callable = |known: &String| {
                    matches!(
                        self.resolve(known),
                        Some(Symbol::Polynomial(..) | Symbol::Function(_) | Symbol::Table(..))
                    )
                };
                let own: Vec<String> = (self.scope.names().into_iter()).filter(callable).collect();
                let known = (builtin::names().map(str::to_owned)).chain(own.iter().cloned());
                let meant = builtin::elsewhere(text).or_else(|| nearest(text, known));
                let message = format!("unknown function {}", quoted(text));
                Fault::unknown(Rule::E0302, message, name, meant, || {
                    let names: Vec<&str> = builtin::names().collect();
                    let own: Vec<&str> = own.iter().take(OWN).map(String::as_str).collect();
                    let names = names.join(", ");
                    match own.is_empty() {
                        true => format!("functions are {names}"),
                        false => format!("functions are {} and {names}", own.join(", ")),
                    }
                })
            }
        };
        self.report(name.span, fault, &[])
    }

    fn apply_data(
        &mut self,
        name: &str,
        data: &Data,
        orders: Vec<u32>,
        arguments: &[NodeId],
    ) -> Option<ExprId> {
        let mut values = Vec::new();
        for (at, &node) in arguments.iter().enumerate() {
            let (argument, wanted) = data.argument(at);
            let what = format!("argument `{argument}` of `{name}`");
            let Some((value, real)) = self.real(node, &what) else {
                continue;
            };
            let checked = match real.shape {
                Shape::Scalar => typing::argument(&what, real.dimensions[0], wanted),
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
                    let path = format!("{name}.{argument}");
                    self.show_axis(&path, argument, real.dimensions[0], wanted);
                }
            }
        }
        if values.len() < arguments.len() {
            return None;
        }
        Some(match data {
            Data::Polynomial(id, _) => self
                .arena
                .intern(Node::Polynomial(*id, values), Type::scalar(Dimension::ONE)),
            Data::Table(id, signature) => {
                let by = signature.arguments.iter().zip(&orders);
                let mut by = by.filter(|(_, order)| **order > 0).map(|((_, by), _)| *by);
                let dimension = by.try_fold(signature.value, Dimension::checked_div);
                let dimension = dimension.expect("invariant: the derivatives were checked");
                self.arena
                    .intern(Node::Table(*id, orders, values), Type::scalar(dimension))
            }
        })
    }
}

/// What `partial` takes and what is called like a function.
enum Data {
    Polynomial(PolynomialId, Vec<String>),
    Table(TableId, Arc<Signature>),
}

impl Data {
    fn noun(&self) -> &'static str {
        match self {
            Data::Polynomial(..) => "polynomial data",
            Data::Table(..) => "table",
        }
    }

    /// Names of the arguments.
    fn arguments(&self) -> Vec<String> {
        match self {
            Data::Polynomial(_, names) => names.clone(),
            Data::Table(_, signature) => {
                let arguments = signature.arguments.iter();
                arguments.map(|(name, _)| name.clone()).collect()
            }
        }
    }

    /// Name and dimension of an argument.
    fn argument(&self, at: usize) -> (&str, Dimension) {
        match self {
            Data::Polynomial(_, names) => (&names[at], Dimension::ONE),
            Data::Table(_, signature) => {
                let (name, dimension) = &signature.arguments[at];
                (name, *dimension)
            }
        }
    }
}
