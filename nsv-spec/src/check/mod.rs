//! Checks a specification and makes the model. Each file is one guarantee; this one lists them in order.

mod angles;
mod arguments;
mod constants;
mod constraint;
mod controller;
mod correlation;
mod counts;
mod csv;
mod cycles;
mod definitions;
mod dispersion;
mod disturbance;
mod environment;
mod features;
mod formula;
mod functions;
mod gains;
mod hardware;
mod initial;
pub(crate) mod limits;
mod linear;
mod names;
mod network;
mod noise;
mod nonfinite;
mod numbers;
mod observer;
mod pairing;
mod parameters;
mod plant;
mod quotients;
mod reference;
mod scenario;
mod scope;
mod states;
mod structure;
mod tables;
mod truth;
mod unused;

use std::collections::BTreeSet;

use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Rule, SourceMap, Span};
use crate::expr::Symbol;
use crate::expr::arena::Arena;
use crate::model::{Block, Constant, Definition, Input, Model, Parameter, State};
use crate::spec::Spec;
pub use names::{RUST_WORDS, is_of_the_law};
use scope::{Dependence, Names};
pub(crate) use tables::{MAX_AXES, MAX_POINTS, MAX_VALUES};

/// Makes the model of a specification, with warnings; or reports everything that is wrong with it, `faults` of reading it among
/// that.
pub(crate) fn check(
    spec: &Spec,
    faults: Vec<Diagnostic>,
    sources: &SourceMap,
    hash: String,
) -> Result<(Model, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut context = Context::new(spec, sources);
    context.faults = faults;
    let model = context.model(hash);
    if let Some(model) = &model
        && context.faults.is_empty()
    {
        context.check_initial(model);
        context.warn_of_unused();
        context.warn_of_unused_arguments();
    }
    match model {
        Some(model) if context.faults.is_empty() => Ok((model, context.warnings)),
        _ => {
            assert!(
                !context.faults.is_empty(),
                "invariant: no model without a fault"
            );
            Err(context.faults)
        }
    }
}

/// What is known of the specification so far. A declaration with a fault is `None`; its users stay silent.
struct Context<'a> {
    spec: &'a Spec,
    sources: &'a SourceMap,
    faults: Vec<Diagnostic>,
    warnings: Vec<Diagnostic>,
    defaults: Vec<String>,
    arena: Arena,
    names: Names,
    /// Every name that an expression uses or calls.
    used: BTreeSet<String>,
    constants: Vec<Option<Constant>>,
    parameters: Vec<Option<Parameter>>,
    definitions: Vec<Definition>,
    /// States of each block.
    states: Vec<Option<Vec<State>>>,
    /// Further states of the flown plant.
    truth_states: Vec<Option<State>>,
    inputs: Option<Vec<Input>>,
    /// Number of states of each block, or of most; `None` where that cannot be told.
    width: Option<usize>,
    /// Whether all blocks and the inputs have as many.
    even: bool,
    /// Definitions that are an angle divided by a degree, with their places.
    in_degrees: BTreeMap<String, Span>,
}

impl<'a> Context<'a> {
    fn new(spec: &'a Spec, sources: &'a SourceMap) -> Self {
        let mut names = Names::default();
        names.complete = spec.complete;
        names.define(
            "t",
            Symbol::Time,
            Dependence {
                time: true,
                ..Dependence::default()
            },
        );
        Context {
            spec,
            sources,
            faults: Vec::new(),
            warnings: Vec::new(),
            defaults: Vec::new(),
            arena: Arena::default(),
            names,
            used: BTreeSet::new(),
            constants: Vec::new(),
            parameters: Vec::new(),
            definitions: Vec::new(),
            states: Vec::new(),
            truth_states: Vec::new(),
            inputs: None,
            width: None,
            even: false,
            in_degrees: BTreeMap::new(),
        }
    }

    /// Every check that needs no numbers of the whole model, in order.
    fn model(&mut self, hash: String) -> Option<Model> {
        self.check_names();
        self.check_polynomials();
        self.check_tables();
        self.check_functions();
        self.check_constants();
        self.check_parameters();
        self.check_states();
        self.inputs = self.check_inputs();
        self.check_definitions();
        let sample_time = self.sample_time();
        let horizon = self.horizon();
        let scenario = self.scenario(sample_time, horizon);
        if let (Some(sample_time), Some(scenario)) = (sample_time, &scenario) {
            self.check_delays(sample_time, scenario);
        }
        let controller = self.controller(sample_time);
        let matched = self.match_blocks();
        self.width = self.check_counts();
        let inputs = self.inputs.clone();
        let reference = self.check_reference();
        let mut blocks = Vec::new();
        for (at, gains) in matched.into_iter().enumerate() {
            let plant = self.check_plant_block(at, inputs.as_deref());
            let gains = gains.map(|gains| &self.spec.controller.blocks[gains]);
            blocks.push(gains.and_then(|gains| self.block(at, gains, plant, horizon)));
        }
        let blocks: Option<Vec<Block>> = blocks.into_iter().collect();
        let truth = self.check_truth();
        let name = self.spec.name.as_ref().ok()?;
        Some(Model {
            name: name.value.clone(),
            title: self.title(&name.value),
            sources: self.sources.clone(),
            hash,
            exprs: self.arena.clone(),
            constants: self.constants.iter().cloned().collect::<Option<_>>()?,
            parameters: self.parameters.iter().cloned().collect::<Option<_>>()?,
            polynomials: self.names.polynomials.clone(),
            tables: self.names.tables.iter().cloned().collect::<Option<_>>()?,
            definitions: self.definitions.clone(),
            blocks: blocks?,
            inputs: inputs?,
            truth: truth?,
            reference: reference?,
            reference_span: self.spec.reference.span,
            controller: controller?,
            scenario: scenario?,
            defaults: self.defaults.clone(),
        })
    }

    fn title(&mut self, name: &str) -> String {
        match &self.spec.title {
            Some(title) => title.value.clone(),
            None => {
                self.default("title".into(), name, "the name");
                name.to_owned()
            }
        }
    }

    fn fault(
        &mut self,
        rule: Rule,
        span: Span,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.faults
            .push(Diagnostic::error(rule, span, message).with_help(help));
    }

    /// Takes back what is missing in the map under a key that has no use at all.
    fn supersede(&mut self, key: Span) {
        let of_it = |fault: &Diagnostic| (fault.rule, fault.span) == (Rule::E0104, Some(key));
        self.faults.retain(|fault| !of_it(fault));
    }

    /// The result of another module, its faults reported here.
    fn accept<T>(&mut self, result: Result<T, Vec<Diagnostic>>) -> Option<T> {
        result.map_err(|faults| self.faults.extend(faults)).ok()
    }

    /// Records a default that was filled in.
    fn default(&mut self, path: String, value: &str, reason: &str) {
        self.defaults.push(format!("{path} = {value} ({reason})"));
    }
}
