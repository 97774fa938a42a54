//! Guarantees strict-feedback structure: the dynamics of a block depend on its own and outer states and not on time; reference,
//! constraints and disturbances depend on time alone.

use super::Context;
use super::formula::Parsed;
use crate::diagnostic::{Rule, Span};

impl Context<'_> {
    /// F, G, H or a network input of a block.
    pub(super) fn check_feedback(&mut self, parsed: &Parsed, what: &str, block: usize) {
        let spec = self.spec;
        let own = &spec.blocks[block].name.value;
        self.check_design(parsed, &format!("{what} of block `{own}`"));
        for (name, span) in self.used(parsed) {
            let dependence = self.names.dependence(&name);
            if dependence.time {
                let message = format!("{what} of block `{own}` depends on time through `{name}`");
                self.fault(Rule::E0702, span, message, "the plant is time-invariant: put functions of time into `disturbance` or `reference`");
            }
            if let Some(inner) = dependence.block.filter(|&inner| inner > block) {
                let inner = &spec.blocks[inner].name.value;
                let message = format!(
                    "{what} of block `{own}` depends on the states of inner block `{inner}` through `{name}`"
                );
                let help = format!(
                    "it may depend on the states of `{own}` and of blocks before it; inner states act through `gain` only"
                );
                self.fault(Rule::E0701, span, message, help);
            }
        }
    }

    /// The controller is designed on the blocks and knows nothing of the further states of the flown plant.
    fn check_design(&mut self, parsed: &Parsed, what: &str) {
        for (name, span) in self.used(parsed) {
            if self.names.dependence(&name).truth {
                let message = format!("{what} depends on the flown plant through `{name}`");
                self.fault(
                    Rule::E0710,
                    span,
                    message,
                    "inputs and states of `truth` may stand in its `rates` only: the controller is designed on the blocks",
                );
            }
        }
    }

    fn used(&self, parsed: &Parsed) -> Vec<(String, Span)> {
        let used = self.names.used(parsed).into_iter();
        used.map(|(name, span)| (name.to_owned(), span)).collect()
    }

    /// A signal given as a function of time.
    pub(super) fn check_signal(&mut self, parsed: &Parsed, what: &str) {
        let spec = self.spec;
        self.check_design(parsed, what);
        for (name, span) in self.used(parsed) {
            if let Some(block) = self.names.dependence(&name).block {
                let block = &spec.blocks[block].name.value;
                let message =
                    format!("{what} depends on the states of block `{block}` through `{name}`");
                self.fault(
                    Rule::E0703,
                    span,
                    message,
                    "it may depend on `t`, constants and parameters only",
                );
            }
        }
    }
}
