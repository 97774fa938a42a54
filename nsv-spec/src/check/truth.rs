//! Guarantees that every further state of the flown plant has a rate in its unit, and that rates stand under names of states only.

use super::Context;
use super::plant::{SECOND, rate_reason};
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::expr::Expected;
use crate::expr::arena::{ExprId, Shape};
use crate::model::{self, State};
use crate::spec::{Located, Named, Truth, Word};
use crate::suggest::{beside, nearest};
use crate::unit::Dimension;

impl Context<'_> {
    /// What is flown beyond the blocks; `Some(None)` if nothing is.
    pub(super) fn check_truth(&mut self) -> Option<Option<model::Truth>> {
        let spec = self.spec;
        let Some(Located { value, span }) = &spec.truth else {
            return Some(None);
        };
        self.check_rate_names(value, *span);
        let states: Option<Vec<State>> = self.truth_states.iter().cloned().collect();
        let further: Vec<_> = (0..value.states.len())
            .map(|at| {
                let dimension = self.truth_states[at].as_ref().map(|state| state.dimension);
                self.rate(value, &value.states[at].name, dimension)
            })
            .collect();
        let mut replaced = Vec::new();
        for (at, block) in spec.blocks.iter().enumerate() {
            let mut channels = Vec::new();
            for (channel, state) in block.value.states.iter().enumerate() {
                let known = self.states[at].as_ref();
                let dimension = known.map(|states| states[channel].dimension);
                channels.push(self.rate(value, &state.name, dimension));
            }
            replaced.push(channels);
        }
        Some(Some(model::Truth {
            states: states?,
            rates: further.into_iter().collect::<Option<_>>()?,
            replaced,
            span: *span,
        }))
    }

    /// The rate that is given for a state, if one is and it is right.
    fn rate(&mut self, truth: &Truth, state: &Word, own: Option<Dimension>) -> Option<ExprId> {
        let written = truth
            .rates
            .iter()
            .find(|rate| rate.name.value == state.value)?;
        let rates = own.and_then(|own| self.ratios(&[own], &[SECOND], written.name.span));
        let reasons = own.map(|own| rate_reason(state, own));
        let what = format!("rate of `{}`", state.value);
        let expected = rates.as_deref().map(|dimensions| Expected {
            what: &what,
            shape: Shape::Scalar,
            dimensions,
            reasons: reasons.as_slice(),
            columns: &[],
        });
        let (id, _) = self.formula(&written.value, expected.as_ref())?;
        own.map(|_| id)
    }

    /// Rates of what is no state, and further states without a rate.
    fn check_rate_names(&mut self, truth: &Truth, span: Span) {
        let blocks = self.spec.blocks.iter();
        let own = blocks.flat_map(|block| &block.value.states);
        let states: Vec<&str> = (truth.states.iter().chain(own))
            .map(|state| state.name.value.as_str())
            .collect();
        // A rate that is meant for a state is not missing besides.
        let mut meant: Vec<String> = Vec::new();
        let blocks = self.spec.blocks.iter();
        let all = self.spec.blocks.complete
            && truth.states.complete
            && blocks
                .map(|block| &block.value.states)
                .all(|states| states.complete);
        for Named { name, .. } in &truth.rates {
            if !all || states.contains(&name.value.as_str()) {
                continue;
            }
            let message = format!("rate of `{}`, which is no state", name.value);
            let fault = Diagnostic::error(Rule::E0711, name.span, message);
            let given = |state: &&&str| truth.rates.iter().any(|rate| rate.name.value == **state);
            let open = nearest(&name.value, states.iter().filter(|state| !given(state)));
            meant.extend(open.iter().map(|meant| meant.name.clone()));
            let otherwise = || {
                let declare = "declare it under `states` of the truth, with its initial value";
                beside(&name.value, states.iter().filter(given), declare)
            };
            self.faults
                .push(fault.did_you_mean(name.span, &name.value, open, otherwise));
        }
        for Named { name, value } in &truth.states {
            if value.sensor.is_some() {
                let message = format!("state `{}` of the truth has a sensor", name.value);
                let help = "the controller measures the states of the blocks only: remove `sensor`";
                self.fault(Rule::E0713, name.span, message, help);
            }
            let given = truth.rates.iter().any(|rate| rate.name.value == name.value);
            if !given && truth.rates.complete && !meant.contains(&name.value) {
                let message = format!("state `{}` of the truth has no rate", name.value);
                self.faults.push(
                    Diagnostic::error(Rule::E0712, name.span, message)
                        .with_related(span, "the rates are given here, under `rates`")
                        .with_help(format!("add `{}: ..` to `rates`", name.value)),
                );
            }
        }
    }
}
