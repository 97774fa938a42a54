//! Guarantees that every output has a reference, and nothing else has.

use super::Context;
use super::pairing::{Pairing, pair};
use super::plant::state_reason;
use crate::diagnostic::{Diagnostic, Rule};
use crate::expr::Expected;
use crate::expr::arena::{ExprId, Shape};
use crate::spec::{Formula, Named};
use crate::unit::Dimension;

impl Context<'_> {
    /// Checks the reference: one function of time for each output.
    pub(super) fn check_reference(&mut self) -> Option<ExprId> {
        let spec = self.spec;
        let Named {
            name: block,
            value: output,
        } = &spec.blocks[0];
        let signals = &spec.reference.value;
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
                let message = format!("reference of output `{name}` is missing");
                let fault = Diagnostic::error(Rule::E0115, spec.reference.span, message)
                    .with_related(
                        output.states[channel].name.span,
                        "the output is declared here",
                    );
                self.faults
                    .push(fault.with_help(format!("add `{name}: ..`, a function of `t`")));
                entries.push(None);
                continue;
            };
            let dimension = self.states[0]
                .as_ref()
                .map(|states| states[channel].dimension);
            entries.push(
                dimension
                    .and_then(|dimension| self.reference_of(channel, &signal.value, dimension)),
            );
        }
        for (at, meant) in strangers {
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

    fn reference_of(
        &mut self,
        channel: usize,
        formula: &Formula,
        dimension: Dimension,
    ) -> Option<ExprId> {
        let state = &self.spec.blocks[0].value.states[channel].name;
        let what = format!("reference of `{}`", state.value);
        self.check_degrees_of((0, channel), &what, formula);
        let (id, parsed) = self.formula(
            formula,
            &Expected {
                what: &what,
                shape: Shape::Scalar,
                dimensions: &[dimension],
                reasons: &[state_reason(state, dimension)],
                columns: &[],
            },
        )?;
        self.check_signal(&parsed, &what);
        Some(id)
    }
}
