//! Which runs of a campaign are whose, and which are done.

use std::collections::BTreeSet;
use std::ops::Range;

use super::Campaign;
use crate::statistics::{Corrupt, Decoder, Encoder};

/// A part of a campaign: every `of`-th block of its runs from block `index` on, so that parts are of equal size to within a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shard {
    /// Number of the part, from 0.
    pub(crate) index: u64,
    /// Number of parts.
    pub(crate) of: u64,
}

impl Shard {
    /// The whole campaign.
    pub(crate) const WHOLE: Shard = Shard { index: 0, of: 1 };

    /// Number of blocks.
    pub(crate) fn blocks(self, campaign: &Campaign) -> u64 {
        let all = campaign.runs.div_ceil(block_size(campaign));
        all.saturating_sub(self.index).div_ceil(self.of)
    }

    /// Runs of a block of the part, counted from the campaign's first.
    pub(crate) fn runs_of(self, block: u64, campaign: &Campaign) -> Range<u64> {
        let size = block_size(campaign);
        let first = (block * self.of + self.index) * size;
        first..campaign.runs.min(first.saturating_add(size))
    }

    /// Number of runs.
    pub(crate) fn runs(self, campaign: &Campaign) -> u64 {
        self.runs_in(0..self.blocks(campaign), campaign)
    }

    /// Number of runs in consecutive blocks of the part.
    fn runs_in(self, blocks: Range<u64>, campaign: &Campaign) -> u64 {
        // Only the last block of a campaign may be short.
        match blocks.end.checked_sub(1) {
            Some(last) if blocks.start <= last => {
                let runs = self.runs_of(last, campaign);
                (last - blocks.start) * block_size(campaign) + (runs.end - runs.start)
            }
            _ => 0,
        }
    }
}

/// Runs in a block, the unit in which work is handed out and remembered: few enough that the last blocks keep all cores busy, and whole batches.
pub(crate) fn block_size(campaign: &Campaign) -> u64 {
    (campaign.runs / 256).next_power_of_two().clamp(8, 256)
}

/// Which blocks of a part are done. Blocks are begun in order, so that only a few are done beyond the first that is not.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Done {
    /// All blocks before this one.
    before: u64,
    /// Later ones.
    beyond: BTreeSet<u64>,
}

impl Done {
    /// Whether a block is done.
    pub(crate) fn contains(&self, block: u64) -> bool {
        block < self.before || self.beyond.contains(&block)
    }

    /// A block is done.
    pub(crate) fn insert(&mut self, block: u64) {
        self.beyond.insert(block);
        while self.beyond.remove(&self.before) {
            self.before += 1;
        }
    }

    /// Number of runs in the blocks that are done.
    pub(crate) fn runs(&self, shard: Shard, campaign: &Campaign) -> u64 {
        let beyond = self.beyond.iter().map(|&block| block..block + 1);
        beyond
            .chain(std::iter::once(0..self.before))
            .map(|blocks| shard.runs_in(blocks, campaign))
            .sum()
    }

    pub(crate) fn encode(&self, encoder: &mut Encoder) {
        encoder.count(self.before);
        encoder.count(self.beyond.len() as u64);
        for &block in &self.beyond {
            encoder.count(block);
        }
    }

    /// Reads what `encode` wrote of a part with so many blocks.
    pub(crate) fn decode(blocks: u64, decoder: &mut Decoder<'_>) -> Result<Self, Corrupt> {
        let mut done = Done {
            before: decoder.count()?,
            beyond: BTreeSet::new(),
        };
        for _ in 0..decoder.count()? {
            let block = decoder.count()?;
            if block <= done.before || block >= blocks || !done.beyond.insert(block) {
                return Err(Corrupt);
            }
        }
        if done.before > blocks {
            return Err(Corrupt);
        }
        Ok(done)
    }
}

#[cfg(test)]
mod tests {
    use std::vec;

    use super::super::tests::campaign;
    use super::{Campaign, Done, Shard, block_size};

    fn of(runs: u64) -> Campaign {
        Campaign { runs, ..campaign() }
    }

    #[test]
    fn parts_share_all_runs_out() {
        for runs in [1, 8, 9, 60, 5000, 100_001] {
            let campaign = of(runs);
            for of in [1, 2, 7, 64] {
                let mut seen = vec![false; runs as usize];
                let mut total = 0;
                for shard in (0..of).map(|index| Shard { index, of }) {
                    total += shard.runs(&campaign);
                    for block in 0..shard.blocks(&campaign) {
                        for run in shard.runs_of(block, &campaign) {
                            assert!(!seen[run as usize], "run {run} is done twice");
                            seen[run as usize] = true;
                        }
                    }
                }
                assert!(seen.iter().all(|&seen| seen) && total == runs);
            }
        }
    }

    #[test]
    fn blocks_are_whole_batches() {
        for runs in [1, 100, 4096, 70_000, 1_000_000, u64::MAX] {
            let size = block_size(&of(runs));
            assert!(size.is_multiple_of(8) && size <= 256);
        }
    }

    #[test]
    fn done_blocks_are_remembered_in_a_few_numbers() {
        let campaign = of(1004);
        let mut done = Done::default();
        for block in [0, 3, 1, 125, 2] {
            assert!(!done.contains(block));
            done.insert(block);
            assert!(done.contains(block));
        }
        assert_eq!((done.before, done.beyond.len()), (4, 1));
        // The last of 126 blocks of 8 has 4 runs.
        assert_eq!(done.runs(Shard::WHOLE, &campaign), 4 * 8 + 4);
    }
}
