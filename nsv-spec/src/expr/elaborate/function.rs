//! Calls of functions that stand for an expression, and loops: both insert an expression with names bound in it.

use std::collections::{BTreeMap, BTreeSet};

use super::{Dimension, Elaborator, ExprId, Fault, NodeId, Real, Shape, Span, Symbol};
use crate::diagnostic::{Diagnostic, Rule, a};
use crate::expr::builtin::{self, Entry};
use crate::expr::parser::INDEX;
use crate::expr::scope::Defined;
use crate::expr::syntax::{Expr, Index, Name};
use crate::unit::parse_unit;

/// Most calls and loops that lie in each other.
pub(crate) const MAX_CALLS: usize = 32;
/// Code of the fault that there are too many of them.
const TOO_LARGE: Rule = Rule::E0211;

impl Elaborator<'_> {
    /// The meaning of a name: what is bound to it, a constant of the language, or what the scope says.
    pub(super) fn resolve(&self, name: &str) -> Option<Symbol> {
        if let Some(bound) = self.bound.get(name) {
            return Some(bound.clone());
        }
        let Some(constant) = builtin::constant(name) else {
            return self.scope.resolve(name);
        };
        Some(Symbol::Number(constant.value, constant.dimension()))
    }

    /// Every name that can be used here, for suggestions.
    pub(super) fn known_names(&self) -> Vec<String> {
        let constants = builtin::CONSTANTS
            .iter()
            .map(|constant| constant.name.to_owned());
        let bound = self.bound.keys().cloned();
        self.scope
            .names()
            .into_iter()
            .chain(constants)
            .chain(bound)
            .collect()
    }

    /// A call of a function of the specification: its body with the arguments in place of their names.
    pub(super) fn insert(
        &mut self,
        span: Span,
        function: &Defined,
        arguments: &[NodeId],
    ) -> Option<ExprId> {
        let bound = self.arguments(function, arguments)?;
        let faults = match self.inserted(span, &function.body, bound)? {
            Ok(id) => return Some(id),
            Err(faults) => faults,
        };
        if faults.iter().any(|fault| fault.rule == TOO_LARGE) {
            return self.too_large(span);
        }
        let label = format!("`{}` is called here", function.name);
        let labelled = faults
            .into_iter()
            .map(|fault| fault.with_related(span, label.as_str()));
        self.faults.extend(labelled);
        None
    }

    /// A call of a function that the language defines in itself; a fault in what it stands for is one of the call.
    pub(super) fn insert_defined(
        &mut self,
        span: Span,
        entry: &Entry,
        unit: Option<&str>,
        arguments: &[NodeId],
    ) -> Option<ExprId> {
        if let Some(unit) = unit {
            self.check_first(entry, unit, arguments[0])?;
        }
        let function = builtin::defined(entry.name)
            .expect("invariant: the function is defined in the language");
        let bound = self.arguments(&function, arguments)?;
        let faults = match self.inserted(span, &function.body, bound)? {
            Ok(id) => return Some(id),
            Err(faults) => faults,
        };
        let fault = faults.into_iter().next()?;
        let body = entry.definition().unwrap_or_default();
        let help = format!(
            "`{}` stands for `{body}`; {}",
            entry.signature(),
            entry.rule
        );
        let message = format!("in `{}`: {}", entry.name, fault.message);
        self.report(span, Fault::new(fault.rule, message, help), arguments)
    }

    /// The first argument must be a scalar of that unit.
    fn check_first(&mut self, entry: &Entry, unit: &str, argument: NodeId) -> Option<()> {
        let what = format!("argument `{}` of `{}`", entry.arguments[0], entry.name);
        let (_, real) = self.real(argument, &what)?;
        let wanted = parse_unit(unit)
            .expect("invariant: units of arguments are units")
            .dimension;
        let span = self.span_of(argument);
        if real.shape != Shape::Scalar {
            let message = format!(
                "shape mismatch: {what} is {}, expected a scalar",
                real.shape
            );
            let fault = Fault::new(Rule::E0501, message, "take one entry of the array");
            return self.report(span, fault, &[]);
        }
        if real.dimensions[0].agree(wanted).is_none() {
            let found = real.dimensions[0].in_words();
            let message = format!("unit mismatch: {what} is {found}, expected {unit}");
            let fault = Fault::new(Rule::E0404, message, format!("give it in {unit}"));
            return self.report(span, fault, &[]);
        }
        Some(())
    }

    fn arguments(
        &mut self,
        function: &Defined,
        arguments: &[NodeId],
    ) -> Option<BTreeMap<String, Symbol>> {
        let values = arguments.iter().map(|&node| self.values[node.0 as usize]);
        let bound = function.arguments.iter().zip(values);
        bound
            .map(|(name, value)| Some((name.clone(), Symbol::Value(value?))))
            .collect()
    }

    /// An expression with names bound in it; `None` after too much has been inserted, which is reported at `span`.
    fn inserted(
        &mut self,
        span: Span,
        body: &Expr,
        bound: BTreeMap<String, Symbol>,
    ) -> Option<Result<ExprId, Vec<Diagnostic>>> {
        if self.depth == MAX_CALLS || !self.scope.insert(body.nodes().len()) {
            return self.too_large(span);
        }
        let mut inner = Elaborator {
            expr: body,
            scope: &mut *self.scope,
            arena: &mut *self.arena,
            bound,
            depth: self.depth + 1,
            unit_until: None,
            values: Vec::new(),
            faults: Vec::new(),
            unknown: BTreeSet::new(),
        };
        let root = inner.root();
        let faults = inner.faults;
        Some(root.filter(|_| faults.is_empty()).ok_or(faults))
    }

    /// Reported once, at the outermost call.
    fn too_large<T>(&mut self, span: Span) -> Option<T> {
        let message = format!(
            "calls and loops make the specification too large, or lie more than {MAX_CALLS} deep in each other"
        );
        let help = "name what is used often in `definitions`";
        self.report(span, Fault::new(TOO_LARGE, message, help), &[])
    }

    /// `each(i, first, last, body)`
    pub(super) fn each(
        &mut self,
        span: Span,
        counter: &Name,
        (first, last): (u32, u32),
        body: &Expr,
    ) -> Option<ExprId> {
        let text = &counter.text;
        if self.resolve(text).is_some() || builtin::is_reserved(text) || text.contains('.') {
            let origin = self.scope.origin(text);
            let noun = origin
                .as_ref()
                .map_or("something else".to_owned(), |one| a(one.noun));
            let message = format!("counter `{text}` has the name of {noun}");
            let help = "choose a name that means nothing here";
            let fault = Diagnostic::error(Rule::E0307, counter.span, message).with_help(help);
            self.faults.push(match origin {
                Some(one) => {
                    fault.with_related(one.span, format!("the {} is declared here", one.noun))
                }
                None => fault,
            });
            return None;
        }
        let mut items: Vec<(ExprId, Real)> = Vec::new();
        for round in first..=last {
            let mut bound = self.bound.clone();
            bound.insert(text.clone(), Symbol::Counter(round));
            let id = match self.inserted(span, body, bound)? {
                Ok(id) => id,
                Err(faults) if round == first => {
                    self.faults.extend(faults);
                    return None;
                }
                Err(faults) => {
                    let label = format!("with `{text}` = {round}");
                    let label =
                        |fault: Diagnostic| fault.with_related(counter.span, label.as_str());
                    self.faults.extend(faults.into_iter().map(label));
                    return None;
                }
            };
            items.push(self.real_value(body.span(), id, "an entry of an array")?);
        }
        self.stack(span, items)
    }

    /// The number of an index.
    pub(super) fn whole_index(&mut self, index: &Index) -> Option<usize> {
        let from = match index
            .counter
            .as_ref()
            .map(|name| (name, self.resolve(&name.text)))
        {
            None => 0,
            Some((_, Some(Symbol::Counter(counted)))) => i64::from(counted),
            Some((_, Some(Symbol::Faulty))) => return None,
            Some((name, _)) => {
                let message = format!("found `{}`, expected an index", name.text);
                return self.report(name.span, Fault::new(Rule::E0209, message, INDEX), &[]);
            }
        };
        let place = from + index.offset;
        if place < 1 {
            let fault = Fault::new(
                Rule::E0503,
                format!("index {place} out of range"),
                "indices start at 1",
            );
            return self.report(index.span, fault, &[]);
        }
        usize::try_from(place).ok()
    }

    /// A number of a counter as a value.
    pub(super) fn counted(&mut self, counter: u32) -> ExprId {
        self.literal(f64::from(counter), Dimension::ONE)
    }
}
