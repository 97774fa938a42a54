//! Guarantees that the plant is a chain of blocks of equal width with as many inputs.

use super::Context;
use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Rule, counted};
use crate::spec::{Named, PlantBlock};

/// Most blocks.
pub(super) const MAX_BLOCKS: usize = 16;
/// Most channels of a block.
pub(super) const MAX_WIDTH: usize = 32;
/// Most surplus inputs that a message names.
const SHOWN: usize = 4;

impl Context<'_> {
    /// Checks the numbers of blocks, states and inputs. Gives the number of states of each block, where they differ that of most;
    /// `None` if none is right or another fault hides it.
    pub(super) fn check_counts(&mut self) -> Option<usize> {
        let spec = self.spec;
        let before = self.faults.len();
        let Some(first) = spec.blocks.first() else {
            if spec.blocks.complete {
                self.fault(
                    Rule::E0602,
                    spec.blocks.span,
                    "plant has no blocks, expected at least one",
                    "declare the output's block under `plant.blocks`",
                );
            }
            return None;
        };
        if !first.value.states.complete {
            return self.usual_width();
        }
        if spec.blocks.len() > MAX_BLOCKS {
            let message = format!(
                "plant has {} blocks, expected at most {MAX_BLOCKS}",
                spec.blocks.len()
            );
            self.fault(
                Rule::E0602,
                spec.blocks[MAX_BLOCKS].name.span,
                message,
                "control the inner dynamics separately",
            );
        }
        let width = first.value.states.len();
        if width == 0 || width > MAX_WIDTH {
            let message = format!(
                "block `{}` has {}, expected 1 to {MAX_WIDTH}",
                first.name.value,
                counted(width, "state")
            );
            self.fault(
                Rule::E0602,
                first.name.span,
                message,
                "declare its states under `states`",
            );
        }
        let differs = |block: &&Named<PlantBlock>| {
            let states = &block.value.states;
            states.complete && states.len() != width
        };
        for block in spec.blocks.iter().filter(differs) {
            let message = format!(
                "block `{}` has {}, expected {width} as in block `{}`",
                block.name.value,
                counted(block.value.states.len(), "state"),
                first.name.value
            );
            let fault = Diagnostic::error(Rule::E0503, block.name.span, message);
            let label = format!(
                "block `{}` has {}",
                first.name.value,
                counted(width, "state")
            );
            self.faults.push(
                fault
                    .with_related(first.name.span, label)
                    .with_help("all blocks of the chain have the same number of states"),
            );
        }
        if spec.inputs.complete && spec.inputs.len() != width {
            let fault = self.input_count(first, width);
            self.faults.push(fault);
        }
        let mut blocks = spec.blocks.iter();
        let complete = spec.blocks.complete
            && spec.inputs.complete
            && blocks.all(|block| block.value.states.complete);
        self.even = complete && self.faults.len() == before;
        self.usual_width()
    }

    /// The number of channels of most blocks and the inputs, unless another is as frequent.
    fn usual_width(&self) -> Option<usize> {
        let spec = self.spec;
        let blocks = spec.blocks.iter().map(|block| &block.value.states);
        let states = blocks.filter(|states| states.complete);
        let inputs = Some(spec.inputs.len()).filter(|_| spec.inputs.complete);
        let mut frequency: BTreeMap<usize, usize> = BTreeMap::new();
        for width in states.map(|states| states.len()).chain(inputs) {
            *frequency.entry(width).or_default() += 1;
        }
        let most = *frequency.values().max()?;
        let mut usual = frequency.iter().filter(|(_, count)| **count == most);
        match (usual.next(), usual.next()) {
            (Some((&width @ 1..=MAX_WIDTH, _)), None) => Some(width),
            _ => None,
        }
    }

    /// The fault of a plant with more or fewer inputs than its blocks have states.
    fn input_count(&self, first: &Named<PlantBlock>, width: usize) -> Diagnostic {
        let inputs = &self.spec.inputs;
        let each = match self.spec.blocks.len() {
            1 => format!(
                "block `{}` has {}",
                first.name.value,
                counted(width, "state")
            ),
            _ => format!("its blocks have {} each", counted(width, "state")),
        };
        let message = format!("plant has {}, but {each}", counted(inputs.len(), "input"));
        let widen = match inputs.len() {
            1..=MAX_WIDTH => format!(
                ", or give every block {}, with as many entries in its drift, gain and reference",
                counted(inputs.len(), "state")
            ),
            _ => String::new(),
        };
        let surplus = inputs.get(width..).unwrap_or_default();
        let fault = match (surplus, inputs.last()) {
            ([next, others @ ..], _) => {
                let fault = Diagnostic::error(Rule::E0503, next.name.span, message);
                let label = "there is no state left for this input";
                let fault = others.iter().take(SHOWN).fold(fault, |fault, other| {
                    fault.with_related(other.name.span, label)
                });
                let names = surplus
                    .iter()
                    .map(|input| format!("`{}`", input.name.value));
                let names: Vec<String> = names.take(SHOWN).collect();
                let names = match surplus.len() > SHOWN {
                    true => counted(surplus.len(), "input"),
                    false => names.join(" and "),
                };
                fault
                    .with_label(label)
                    .with_help(format!("remove {names}{widen}"))
            }
            ([], Some(last)) => {
                let more = counted(width - inputs.len(), "input");
                Diagnostic::error(Rule::E0503, last.name.span, message)
                    .with_help(format!("declare {more} more under `plant.inputs`{widen}"))
            }
            ([], None) => {
                let more = counted(width, "input");
                Diagnostic::error(Rule::E0503, first.name.span, message)
                    .with_help(format!("declare {more} under `plant.inputs`"))
            }
        };
        let which = match width {
            1 => "the state",
            _ => "the last state",
        };
        match first.value.states.last() {
            Some(state) => fault.with_related(
                state.name.span,
                format!("{which} of block `{}`", first.name.value),
            ),
            None => fault,
        }
    }
}
