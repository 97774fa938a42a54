//! Guarantees strict-feedback structure: the dynamics of a block depend on its own and outer states and not on time; reference,
//! constraints and disturbances depend on time alone.

use super::Context;
use super::formula::Parsed;
use super::scope::Dependence;
use crate::diagnostic::{Diagnostic, Rule, Span};
use crate::spec::{Named, PlantBlock};

/// Most definitions that are shown on the way to what they depend on.
const MOST: usize = 4;

impl Context<'_> {
    /// F, G, H or a network input of a block.
    pub(super) fn check_feedback(&mut self, parsed: &Parsed, what: &str, block: usize) {
        let own = &self.spec.blocks[block].name.value;
        let what = format!("{what} of block `{own}`");
        self.check_design(parsed, &what);
        for (name, span) in self.used(parsed) {
            let dependence = self.names.dependence(&name);
            if dependence.time {
                let message = match name.as_str() {
                    "t" => format!("{what} depends on time"),
                    _ => format!("{what} depends on time through `{name}`"),
                };
                let fault = Diagnostic::error(Rule::E0702, span, message).with_help("the plant is time-invariant: put functions of time into `disturbance` or `reference`");
                let fault = self.traced(fault, &name, |dependence| dependence.time);
                self.faults.push(fault);
            }
            if let Some(inner) = dependence.block.filter(|&inner| inner > block) {
                let fault = self.inner_state(&what, block, &name, inner, span);
                self.faults.push(fault);
            }
        }
    }

    /// The fault of dynamics that depend on the states of a later block.
    fn inner_state(
        &self,
        what: &str,
        block: usize,
        name: &str,
        inner: usize,
        span: Span,
    ) -> Diagnostic {
        let blocks = &self.spec.blocks;
        let block_name = |at: usize| &blocks[at].name.value;
        let message = match self.is_state(name) {
            true => format!(
                "{what} depends on the state `{name}` of inner block `{}`",
                block_name(inner)
            ),
            false => format!(
                "{what} depends on the states of inner block `{}` through `{name}`",
                block_name(inner)
            ),
        };
        let own = match block {
            0 => format!("the states of `{}`", block_name(block)),
            _ => format!(
                "the states of `{}` and of blocks before it",
                block_name(block)
            ),
        };
        let rest = match what.starts_with("drift") {
            true => ", and write 0 if nothing is left",
            false => "",
        };
        let acts = match self.is_state(name) {
            true => "it acts",
            false => "inner states act",
        };
        let help = format!(
            "take the terms with `{name}` out{rest}: {acts} through `gain` of block `{}`, which multiplies it already; only {own} may stand here",
            block_name(inner - 1)
        );
        let fault = Diagnostic::error(Rule::E0701, span, message).with_help(help);
        self.traced(fault, name, |dependence| {
            dependence.block.is_some_and(|at| at > block)
        })
    }

    /// The controller is designed on the blocks and knows nothing of the further states of the flown plant.
    fn check_design(&mut self, parsed: &Parsed, what: &str) {
        for (name, span) in self.used(parsed) {
            if self.names.dependence(&name).truth {
                let message = format!("{what} depends on the flown plant through `{name}`");
                let fault = Diagnostic::error(Rule::E0710, span, message).with_help(
                    "inputs and states of `truth` may stand in its `rates` only: the controller is designed on the blocks",
                );
                let fault = self.traced(fault, &name, |dependence| dependence.truth);
                self.faults.push(fault);
            }
        }
    }

    fn used(&self, parsed: &Parsed) -> Vec<(String, Span)> {
        let used = self.names.used(parsed).into_iter();
        used.map(|(name, span)| (name.to_owned(), span)).collect()
    }

    /// A signal given as a function of time.
    pub(super) fn check_signal(&mut self, parsed: &Parsed, what: &str) -> Option<()> {
        let before = self.faults.len();
        self.check_design(parsed, what);
        for (name, span) in self.used(parsed) {
            let Some(block) = self.names.dependence(&name).block else {
                continue;
            };
            let message = match self.is_state(&name) {
                true => format!("{what} depends on the state `{name}`"),
                false => {
                    let block = &self.spec.blocks[block].name.value;
                    format!("{what} depends on the states of block `{block}` through `{name}`")
                }
            };
            let fault = Diagnostic::error(Rule::E0703, span, message)
                .with_help("it may depend on `t`, constants and parameters only");
            let fault = self.traced(fault, &name, |dependence| dependence.block.is_some());
            self.faults.push(fault);
        }
        (self.faults.len() == before).then_some(())
    }

    fn is_state(&self, name: &str) -> bool {
        let origin = self.names.origin_of(name);
        origin.is_some_and(|origin| origin.noun == "state")
    }

    /// The fault with the declaration of a name, and of what its definition takes the dependence from, one after the other.
    fn traced(
        &self,
        mut fault: Diagnostic,
        name: &str,
        depends: impl Fn(Dependence) -> bool,
    ) -> Diagnostic {
        let mut name = name.to_owned();
        for _ in 0..MOST {
            let Some(origin) = self.names.origin_of(&name) else {
                break;
            };
            let next = (origin.uses.iter()).find(|used| depends(self.names.dependence(used)));
            let label = match (next, self.block_of(&name)) {
                (Some(next), _) => format!("{} `{name}` uses `{next}`", origin.noun),
                (None, Some(block)) => format!("`{name}` is a state of block `{block}`"),
                (None, None) => format!("{} `{name}` is declared here", origin.noun),
            };
            fault = fault.with_related(origin.span, label);
            match next {
                Some(next) => name = next.clone(),
                None => break,
            }
        }
        fault
    }

    /// The block that has a state.
    fn block_of(&self, name: &str) -> Option<&str> {
        let has = |block: &&Named<PlantBlock>| {
            let mut states = block.value.states.iter();
            states.any(|state| state.name.value == name)
        };
        let block = self.spec.blocks.iter().find(has)?;
        Some(&block.name.value)
    }
}
