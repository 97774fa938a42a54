//! Guarantees that every definition has a meaning, and puts them in an order in which each uses only earlier ones.

use super::Context;
use super::constants::text;
use super::formula::Parsed;
use super::scope::{Dependence, Place};
use crate::expr::Symbol;
use crate::expr::arena::{DefinitionId, PolynomialId};
use crate::model::{Definition, Polynomial};

impl Context<'_> {
    /// Takes over polynomial data.
    pub(super) fn check_polynomials(&mut self) {
        let spec = self.spec;
        for group in &spec.polynomials {
            let arguments = group.value.arguments.iter().flatten();
            let arguments: Vec<String> = arguments.map(|name| name.value.clone()).collect();
            for part in &group.value.parts {
                let name = format!("{}.{}", group.name.value, part.name.value);
                let Ok(terms) = &part.value else {
                    self.names.refuse(&name);
                    continue;
                };
                let id = PolynomialId(
                    u32::try_from(self.names.polynomials.len())
                        .expect("invariant: fewer than 2^32 polynomials"),
                );
                self.names.define(
                    &name,
                    Symbol::Polynomial(id, arguments.clone()),
                    Dependence::default(),
                );
                let doc = text(group.value.source.as_ref());
                let polynomial = Polynomial {
                    name,
                    arguments: arguments.clone(),
                    terms: terms.clone(),
                    doc,
                    span: part.name.span,
                };
                self.names.polynomials.push(polynomial);
            }
        }
    }

    /// Elaborates every definition.
    pub(super) fn check_definitions(&mut self) {
        let spec = self.spec;
        let parsed: Vec<Option<Parsed>> = spec
            .definitions
            .iter()
            .map(|definition| self.parse_formula(&definition.value))
            .collect();
        for at in self.sort(&spec.definitions, &self.names_used(&parsed), "definition") {
            let name = &spec.definitions[at].name;
            let Some(parsed) = &parsed[at] else {
                self.names.refuse(&name.value);
                continue;
            };
            let Some(expr) = self.elaborate(parsed, Place::Model) else {
                self.names.refuse(&name.value);
                continue;
            };
            self.note_degrees(&name.value, parsed);
            let dependence = self.dependence(parsed);
            let id = DefinitionId(
                u32::try_from(self.definitions.len())
                    .expect("invariant: fewer than 2^32 definitions"),
            );
            self.names.define(
                &name.value,
                Symbol::Definition(id, self.arena.ty(expr).clone()),
                dependence,
            );
            self.definitions.push(Definition {
                name: name.value.clone(),
                expr,
                span: name.span,
            });
        }
    }

    /// What a formula varies with.
    pub(super) fn dependence(&self, parsed: &Parsed) -> Dependence {
        let names = self.names.used(parsed);
        names.iter().fold(Dependence::default(), |all, (name, _)| {
            all.join(self.names.dependence(name))
        })
    }
}
