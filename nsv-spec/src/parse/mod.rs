//! Reads a tree into a [`Spec`]: every key known, none twice, every value of the right kind. All faults are reported at once.

mod controller;
mod data;
mod dispersion;
mod fields;
mod hardware;
mod plant;
mod table;
mod values;

use crate::diagnostic::{Diagnostic, Rule};
use crate::model::{NoiseModel, Scheme};
use crate::spec::{Scenario, Spec, Unreadable};
use crate::vocabulary::SPECIFICATION;
use crate::yaml::Node;
pub(crate) use data::MAX_EXPONENT;
use fields::Fields;
pub(crate) use fields::Reader;

/// Version of the language.
const VERSION: u64 = 1;

/// Reads a specification, with the faults of what could not be read; `partial` where a file of it is missing.
pub(crate) fn parse(tree: &Node, partial: bool) -> (Spec, Vec<Diagnostic>) {
    let mut reader = Reader::default();
    reader.partial = partial;
    let spec = reader.specification(tree);
    (spec, reader.faults)
}

/// Whether every map that declares names of expressions could be read.
fn declares_all(spec: &Spec) -> bool {
    let truth = spec.truth.iter().map(|truth| &truth.value.states);
    let mut states = (spec.blocks.iter().map(|block| &block.value.states)).chain(truth);
    let mut groups = spec.polynomials.iter();
    spec.constants.complete
        && spec.parameters.complete
        && spec.polynomials.complete
        && groups.all(|group| group.value.parts.complete)
        && spec.tables.complete
        && spec.functions.complete
        && spec.definitions.complete
        && spec.blocks.complete
        && spec.inputs.complete
        && states.all(|states| states.complete)
}

impl Reader {
    fn specification(&mut self, tree: &Node) -> Spec {
        let fields = self.fields(tree, &SPECIFICATION);
        self.version(&fields);
        let plant = self.section(&fields, "plant");
        let mut spec = Spec {
            complete: fields.maps_complete && plant.maps_complete,
            name: self.text(&fields, "name").unwrap_or(Err(Unreadable)),
            title: self.note(&fields, "title"),
            constants: self.map(&fields, "constants", Self::constant),
            parameters: self.map(&fields, "parameters", Self::parameter),
            correlations: self.correlations(&fields),
            polynomials: self.map(&fields, "polynomials", Self::polynomial_group),
            tables: self.map(&fields, "tables", Self::table),
            functions: self.map(&fields, "functions", Self::function),
            definitions: self.map(&fields, "definitions", Self::formula_of),
            blocks: self.blocks(&plant),
            inputs: self.inputs(&plant),
            truth: self.flown(&plant),
            reference: self.map(&fields, "reference", Self::formula_of),
            controller: self.controller(&fields),
            scenario: self.scenario(&fields),
        };
        spec.complete &= declares_all(&spec);
        spec
    }

    fn version(&mut self, fields: &Fields<'_>) {
        let Some(version) = self.count(fields, "nsv") else {
            return;
        };
        if version.value != VERSION {
            let message = format!(
                "language version {} is not known, expected {VERSION}",
                version.value
            );
            self.fault(
                Rule::E0105,
                version.span,
                message,
                format!("write `nsv: {VERSION}`"),
            );
        }
    }

    fn scenario(&mut self, specification: &Fields<'_>) -> Scenario {
        let fields = self.section(specification, "scenario");
        Scenario {
            horizon: self.code(&fields, "horizon"),
            substeps: self.count(&fields, "substeps"),
            scheme: self.choice(
                &fields,
                "scheme",
                &[Scheme::EulerMaruyama, Scheme::Platen, Scheme::RungeKutta4],
            ),
            noise: self.choice(&fields, "noise", &[NoiseModel::Sampled, NoiseModel::Wiener]),
            seed: self.count(&fields, "seed"),
            runs: self.count(&fields, "runs"),
            settle: self.optional_code(&fields, "settle"),
        }
    }
}
