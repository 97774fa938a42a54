//! Guarantees that every output has a reference, and nothing else has.

use super::Context;
use crate::diagnostic::Rule;
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
        let mut entries: Vec<Option<ExprId>> = Vec::new();
        for (channel, state) in output.states.iter().enumerate() {
            let name = &state.name.value;
            let Some(signal) = spec
                .reference
                .value
                .iter()
                .find(|signal| signal.name.value == *name)
            else {
                let message = format!("reference of output `{name}` is missing");
                self.fault(
                    Rule::E0115,
                    spec.reference.span,
                    message,
                    format!("add `{name}: ..`, a function of `t`"),
                );
                entries.push(None);
                continue;
            };
            let dimension = self.states[0]
                .as_ref()
                .map(|states| states[channel].dimension);
            entries.push(
                dimension.and_then(|dimension| self.reference_of(name, &signal.value, dimension)),
            );
        }
        for signal in &spec.reference.value {
            if !output
                .states
                .iter()
                .any(|state| state.name.value == signal.name.value)
            {
                let names: Vec<&str> = output
                    .states
                    .iter()
                    .map(|state| state.name.value.as_str())
                    .collect();
                let message = format!(
                    "reference of `{}`, which is no state of the output block `{}`",
                    signal.name.value, block.value
                );
                self.fault(
                    Rule::E0115,
                    signal.name.span,
                    message,
                    format!("the outputs are `{}`", names.join("`, `")),
                );
            }
        }
        let entries: Option<Vec<ExprId>> = entries.into_iter().collect();
        entries.map(|entries| self.array(entries, Shape::Vector(output.states.len())))
    }

    fn reference_of(
        &mut self,
        name: &str,
        formula: &Formula,
        dimension: Dimension,
    ) -> Option<ExprId> {
        let what = format!("reference of `{name}`");
        let (id, parsed) = self.formula(
            formula,
            &Expected {
                what: &what,
                shape: Shape::Scalar,
                dimensions: &[dimension],
            },
        )?;
        self.check_signal(&parsed, &what);
        Some(id)
    }
}
