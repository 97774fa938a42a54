//! Guarantees that the plant is a chain of blocks of equal width with as many inputs.

use super::Context;
use crate::diagnostic::Rule;

/// Most blocks.
pub(super) const MAX_BLOCKS: usize = 16;
/// Most channels of a block.
pub(super) const MAX_WIDTH: usize = 32;

impl Context<'_> {
    /// Width of the blocks: that of the first.
    pub(super) fn width(&self) -> usize {
        self.spec
            .blocks
            .first()
            .map_or(0, |block| block.value.states.len())
    }

    /// Checks the numbers of blocks, states and inputs. Nothing else can be checked if they are wrong.
    pub(super) fn check_counts(&mut self) -> bool {
        let spec = self.spec;
        let before = self.faults.len();
        let Some(first) = spec.blocks.first() else {
            self.fault(
                Rule::E0602,
                spec.reference.span,
                "plant has no blocks, expected at least one",
                "declare the output's block under `plant.blocks`",
            );
            return false;
        };
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
        let width = self.width();
        if width == 0 || width > MAX_WIDTH {
            let message = format!(
                "block `{}` has {width} states, expected 1 to {MAX_WIDTH}",
                first.name.value
            );
            self.fault(
                Rule::E0602,
                first.name.span,
                message,
                "declare its states under `states`",
            );
        }
        for block in spec
            .blocks
            .iter()
            .filter(|block| block.value.states.len() != width)
        {
            let message = format!(
                "block `{}` has {} states, expected {width} as in block `{}`",
                block.name.value,
                block.value.states.len(),
                first.name.value
            );
            self.fault(
                Rule::E0503,
                block.name.span,
                message,
                "all blocks of the chain have the same number of states",
            );
        }
        if spec.inputs.len() != width {
            let span = spec
                .inputs
                .first()
                .map_or(first.name.span, |input| input.name.span);
            let message = format!(
                "plant has {} inputs, expected {width}, one for each state of a block",
                spec.inputs.len()
            );
            self.fault(
                Rule::E0503,
                span,
                message,
                "G of the last block must be square",
            );
        }
        self.faults.len() == before
    }
}
