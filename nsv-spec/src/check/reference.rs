//! Guarantees that every output has a reference, and nothing else has.

use super::Context;
use super::pairing::{Pairing, pair};
use super::plant::state_reason;
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::arena::{ExprId, Shape};
use crate::expr::{Expected, Symbol};
use crate::spec::{Formula, Named};

impl Context<'_> {
    /// Checks the reference: one function of time for each output.
    pub(super) fn check_reference(&mut self) -> Option<ExprId> {
        let spec = self.spec;
        let signals = &spec.reference;
        let Some(Named {
            name: block,
            value: output,
        }) = spec.blocks.first()
        else {
            for signal in signals {
                self.formula(&signal.value, None);
            }
            return None;
        };
        let given: Vec<&str> = signals
            .iter()
            .map(|signal| signal.name.value.as_str())
            .collect();
        let outputs: Vec<&str> = output
            .states
            .iter()
            .map(|state| state.name.value.as_str())
            .collect();
        let Pairing { matched, strangers } = pair(&outputs, &given);
        let mut entries: Vec<Option<ExprId>> = Vec::new();
        for (channel, name) in outputs.iter().enumerate() {
            let Some(signal) = matched[channel].map(|at| &signals[at]) else {
                entries.push(None);
                if !signals.complete {
                    continue;
                }
                let message = format!("reference of output `{name}` is missing");
                let fault = Diagnostic::error(Rule::E0115, spec.reference.span, message)
                    .with_related(
                        output.states[channel].name.span,
                        "the output is declared here",
                    );
                self.faults
                    .push(fault.with_help(format!("add `{name}: ..`, a function of `t`")));
                continue;
            };
            entries.push(self.reference_of(channel, &signal.value));
        }
        let known = output.states.complete;
        for (at, meant) in strangers.into_iter().filter(|_| known) {
            let name = &signals[at].name;
            let message = format!(
                "reference of `{}`, which is no state of the output block `{}`",
                name.value, block.value
            );
            let fault = Diagnostic::error(Rule::E0115, name.span, message)
                .with_related(block.span, "the output block is the first one");
            let otherwise = || format!("the outputs are `{}`", outputs.join("`, `"));
            self.faults
                .push(fault.did_you_mean(name.span, &name.value, meant, otherwise));
        }
        let entries: Option<Vec<ExprId>> = entries.into_iter().collect();
        entries.map(|entries| self.array(entries, Shape::Vector(output.states.len())))
    }

    fn reference_of(&mut self, channel: usize, formula: &Formula) -> Option<ExprId> {
        let state = &self.spec.blocks[0].value.states[channel].name;
        let dimension = match self.names.symbol(&state.value) {
            Some(&Symbol::State { dimension, .. }) => Some(dimension),
            _ => None,
        };
        let reason = dimension.map(|dimension| state_reason(state, dimension));
        let what = format!("reference of `{}`", state.value);
        let expected = dimension.as_ref().map(|dimension| Expected {
            what: &what,
            shape: Shape::Scalar,
            dimensions: std::slice::from_ref(dimension),
            reasons: reason.as_slice(),
            columns: &[],
        });
        self.check_degrees_of((0, channel), &what, formula);
        let (id, parsed) = self.formula(formula, expected.as_ref())?;
        self.check_signal(&parsed, &what)?;
        Some(id)
    }
}
