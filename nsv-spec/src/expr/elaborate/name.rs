//! Names in place of values.

use super::{Bits, Dimension, Elaborator, ExprId, Fault, Node, Span, Symbol, Type};
use crate::diagnostic::{Rule, a, quoted};
use crate::expr::builtin;
use crate::expr::syntax::{self, Kind, Name};
use crate::suggest::nearest;
use crate::unit::{self, parse_unit};

impl Elaborator<'_> {
    /// The value that a name stands for.
    pub(super) fn name(&mut self, span: Span, name: &str) -> Option<ExprId> {
        let (node, ty) = match self.resolve(name) {
            Some(Symbol::Constant(id, ty)) => (Node::Constant(id), ty),
            Some(Symbol::Parameter(id, ty)) => (Node::Parameter(id), ty),
            Some(Symbol::State {
                block,
                channel,
                dimension,
            }) => (Node::State { block, channel }, Type::scalar(dimension)),
            Some(Symbol::Truth(at, dimension)) => (Node::Truth(at), Type::scalar(dimension)),
            Some(Symbol::Input(at, dimension)) => (Node::Input(at), Type::scalar(dimension)),
            Some(Symbol::Time) => (Node::Time, Type::scalar(Dimension::new(0, 0, 1, 0))),
            Some(Symbol::Number(value, dimension)) => {
                (Node::Number(Bits(value.to_bits())), Type::scalar(dimension))
            }
            Some(Symbol::Value(id)) => return Some(id),
            Some(Symbol::Counter(counter)) => return Some(self.counted(counter)),
            Some(Symbol::Function(_)) => return self.function_as_value(span, name),
            Some(Symbol::Definition(id, ty)) => (Node::Definition(id), ty),
            Some(Symbol::Polynomial(_, arguments)) => {
                let help = format!(
                    "apply it to its arguments: `{name}({})`",
                    arguments.join(", ")
                );
                return self.report(
                    span,
                    Fault::new(
                        Rule::E0304,
                        format!("`{name}` is polynomial data, expected a value"),
                        help,
                    ),
                    &[],
                );
            }
            Some(Symbol::Table(_, signature)) => {
                let arguments = signature.arguments.iter();
                let arguments: Vec<&str> = arguments.map(|(name, _)| name.as_str()).collect();
                let help = format!(
                    "apply it to its arguments: `{name}({})`",
                    arguments.join(", ")
                );
                let message = format!("`{name}` is a table, expected a value");
                return self.report(span, Fault::new(Rule::E0304, message, help), &[]);
            }
            Some(Symbol::Unavailable(why)) => return self.unavailable(span, name, why),
            Some(Symbol::Faulty) => return None,
            None => return self.unknown_name(span, name),
        };
        Some(self.arena.intern(node, ty))
    }

    pub(super) fn unavailable(&mut self, span: Span, name: &str, why: String) -> Option<ExprId> {
        let origin = self.scope.origin(name);
        let message = match &origin {
            Some(origin) => format!("{} `{name}` cannot be used here", origin.noun),
            None => format!("`{name}` cannot be used here"),
        };
        self.report::<()>(span, Fault::new(Rule::E0303, message, why), &[]);
        if let Some(origin) = origin
            && let Some(fault) = self.faults.pop()
        {
            let label = format!("it is {}, declared here", a(origin.noun));
            self.faults.push(fault.with_related(origin.span, label));
        }
        None
    }

    fn function_as_value(&mut self, span: Span, name: &str) -> Option<ExprId> {
        let fault = Fault::new(
            Rule::E0304,
            format!("`{name}` is a function, expected a value"),
            format!("apply it: `{name}(..)`"),
        );
        self.report(span, fault, &[])
    }

    fn unknown_name(&mut self, span: Span, name: &str) -> Option<ExprId> {
        if !self.unknown.insert(name.to_owned()) {
            return None;
        }
        if builtin::names().any(|function| function == name) {
            return self.function_as_value(span, name);
        }
        let written = Name {
            text: name.to_owned(),
            span,
        };
        if self.follows_unit(span) {
            return self.unknown_unit(&written);
        }
        let meant = nearest(name, self.known_names());
        let message = format!("unknown name {}", quoted(name));
        let fault = Fault::unknown(Rule::E0301, message, &written, meant, || {
            match parse_unit(name).is_ok() {
                true => format!("a unit follows its number directly: `1 {name}`"),
                false => "declare it: under `constants` with its value and unit, under `parameters` if that is uncertain, or under `definitions` \
                          as a formula"
                    .to_owned(),
            }
        });
        self.report(span, fault, &[])
    }

    /// Whether a name stands behind a unit and one operator without blanks, as `sec` in `3 m/sec`, or behind such a name.
    fn follows_unit(&self, span: Span) -> bool {
        let touches = |end: u32| end + 1 == span.start;
        let literal = |node: &syntax::Node| match &node.kind {
            Kind::Number(literal) => literal.unit.is_some() && touches(node.span.end),
            _ => false,
        };
        self.unit_until.is_some_and(touches) || self.expr.nodes().iter().any(literal)
    }

    /// A name that was meant for a unit. What continues the unit is passed over.
    fn unknown_unit(&mut self, name: &Name) -> Option<ExprId> {
        let continues = self.unit_until.is_some();
        let meant = unit::meant(&name.text);
        if meant.is_none() && !(continues && parse_unit(&name.text).is_ok()) {
            let message = format!("unknown name {}", quoted(&name.text));
            let near = nearest(&name.text, self.scope.names());
            let fault = Fault::unknown(Rule::E0301, message, name, near, || {
                "it is neither a unit nor declared as a name".to_owned()
            });
            return self.report(name.span, fault, &[]);
        }
        self.unit_until = Some(name.span.end);
        if let (Some(meant), false) = (meant, continues) {
            let message = format!("unknown unit {}", quoted(&name.text));
            let fault = Fault::unknown(Rule::E0401, message, name, Some(meant), String::new);
            return self.report(name.span, fault, &[]);
        }
        None
    }
}
