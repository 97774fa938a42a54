//! Guarantees that every function uses names that exist and does not call itself, in whatever order functions are declared.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::Context;
use super::formula::Parsed;
use super::scope::Dependence;
use crate::diagnostic::{Diagnostic, Rule, quoted};
use crate::expr::syntax::Expr;
use crate::expr::{CONSTANTS, Defined, Symbol, entries};
use crate::spec::{Function, Named};
use crate::suggest::nearest;

impl Context<'_> {
    /// Takes over every function. What a call makes of its arguments is checked at each call.
    pub(super) fn check_functions(&mut self) {
        let spec = self.spec;
        let bodies: Vec<Option<Expr>> = spec
            .functions
            .iter()
            .map(|function| match self.parse(&function.value.value)? {
                Parsed::Expr(expr) => Some(expr),
                Parsed::List(..) => None,
            })
            .collect();
        let called = |body: &Option<Expr>| {
            let called = body.iter().flat_map(Expr::called_names);
            called.map(|(name, _)| name.to_owned()).collect()
        };
        let called: Vec<Vec<String>> = bodies.iter().map(called).collect();
        let known = if spec.functions.is_empty() {
            Known::default()
        } else {
            self.known()
        };
        for at in self.sort(&spec.functions, &called, "function") {
            let Named { name, value } = &spec.functions[at];
            let sound = bodies[at]
                .clone()
                .filter(|body| self.knows(body, value, &known));
            let (Some(body), Ok(arguments)) = (sound, &value.arguments) else {
                self.names.refuse(&name.value);
                continue;
            };
            let arguments = arguments.iter().map(|name| name.value.clone());
            let arguments: Vec<String> = arguments.collect();
            let own = body
                .free_names()
                .into_iter()
                .map(|(name, _)| name.to_owned());
            let inner = called[at]
                .iter()
                .flat_map(|name| self.names.uses(name).cloned());
            let mut uses: BTreeSet<String> = own.chain(inner).collect();
            uses.retain(|used| !arguments.contains(used));
            let name = name.value.clone();
            self.names.define_uses(&name, uses);
            let defined = Defined {
                name: name.clone(),
                arguments,
                body,
            };
            self.names.define(
                &name,
                Symbol::Function(Arc::new(defined)),
                Dependence::default(),
            );
        }
    }

    /// Whether every name in a body means something; those that do not are reported.
    fn knows(&mut self, body: &Expr, function: &Function, known: &Known) -> bool {
        let Ok(arguments) = &function.arguments else {
            return false;
        };
        if !self.spec.complete {
            return true;
        }
        let before = self.faults.len();
        let argument = |name: &str| arguments.iter().any(|known| known.value == name);
        for (name, span) in body.free_names() {
            if !argument(name) && !known.values.contains(name) {
                let own = arguments.iter().map(|name| name.value.clone());
                let meant = nearest(name, known.values.iter().cloned().chain(own));
                let message = format!("unknown name {}", quoted(name));
                let fault = Diagnostic::error(Rule::E0301, span, message);
                let mut inputs = self.spec.inputs.iter();
                let input = inputs.any(|input| input.name.value == name);
                let otherwise = || {
                    match input {
                    true => "it is an input: inputs act through `gain` of the last block, and no function uses them by name".to_owned(),
                    false => "add it to the arguments of the function".to_owned(),
                }
                };
                self.faults
                    .push(fault.did_you_mean(span, name, meant, otherwise));
            }
        }
        for (name, span) in body.called_names() {
            if !known.functions.contains(name) && !known.values.contains(name) {
                let meant = nearest(name, &known.functions);
                let message = format!("unknown function {}", quoted(name));
                let fault = Diagnostic::error(Rule::E0302, span, message);
                let otherwise = || "declare it under `functions`".to_owned();
                self.faults
                    .push(fault.did_you_mean(span, name, meant, otherwise));
            }
        }
        self.faults.len() == before
    }

    fn known(&self) -> Known {
        let spec = self.spec;
        let mut known = Known::default();
        let states = spec.blocks.iter().flat_map(|block| &block.value.states);
        known
            .values
            .extend(spec.constants.iter().map(|item| item.name.value.clone()));
        known
            .values
            .extend(spec.parameters.iter().map(|item| item.name.value.clone()));
        known
            .values
            .extend(spec.definitions.iter().map(|item| item.name.value.clone()));
        known
            .values
            .extend(states.map(|item| item.name.value.clone()));
        known
            .values
            .extend(CONSTANTS.iter().map(|constant| constant.name.to_owned()));
        known.values.insert("t".to_owned());
        known
            .functions
            .extend(entries().map(|entry| entry.name.to_owned()));
        known
            .functions
            .extend(spec.functions.iter().map(|item| item.name.value.clone()));
        let tables = spec.tables.iter().map(|item| item.name.value.clone());
        known.functions.extend(tables);
        for group in &spec.polynomials {
            let parts = group.value.parts.iter();
            let dotted = parts.map(|part| format!("{}.{}", group.name.value, part.name.value));
            known.functions.extend(dotted);
        }
        known
    }
}

/// Everything that has a name.
#[derive(Default)]
struct Known {
    values: BTreeSet<String>,
    functions: BTreeSet<String>,
}
