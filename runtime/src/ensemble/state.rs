//! How far a part of a campaign has come.

use super::shard::{Done, Shard};
use super::tally::Tally;
use super::{Campaign, Summary};
use crate::closed_loop::ClosedLoop;
use crate::statistics::{Corrupt, Decoder, Encoder};

/// The runs of a part that are done, and what they add up to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(super) done: Done,
    pub(super) tally: Tally,
    /// Time spent on them, ns.
    pub(super) spent_ns: u64,
}

impl State {
    /// Nothing is done.
    pub(crate) fn new<L: ClosedLoop>(campaign: &Campaign) -> Self {
        Self {
            done: Done::default(),
            tally: Tally::new::<L>(campaign),
            spent_ns: 0,
        }
    }

    /// Whether a block of the part is done.
    pub(crate) fn has(&self, block: u64) -> bool {
        self.done.contains(block)
    }

    /// Number of runs done.
    pub(crate) fn runs(&self) -> u64 {
        self.tally.runs()
    }

    /// Adds the runs of another part.
    pub(crate) fn merge(&mut self, other: State) {
        self.tally.merge(other.tally);
        self.spent_ns = self.spent_ns.saturating_add(other.spent_ns);
    }

    /// The statistics of the runs done.
    pub(crate) fn summary<L: ClosedLoop>(self) -> Summary {
        self.tally.summary::<L>(self.spent_ns as f64 * 1e-9)
    }

    /// The state as bytes.
    pub(crate) fn encode(&mut self) -> std::vec::Vec<u8> {
        self.tally.settle();
        let mut encoder = Encoder::default();
        encoder.count(self.spent_ns);
        self.done.encode(&mut encoder);
        self.tally.encode(&mut encoder);
        encoder.bytes()
    }

    /// The state of a part from its bytes.
    pub(crate) fn decode<L: ClosedLoop>(
        campaign: &Campaign,
        shard: Shard,
        bytes: &[u8],
    ) -> Result<Self, Corrupt> {
        let mut decoder = Decoder::new(bytes);
        let state = Self {
            spent_ns: decoder.count()?,
            done: Done::decode(shard.blocks(campaign), &mut decoder)?,
            tally: Tally::decode::<L>(campaign, &mut decoder)?,
        };
        decoder.end()?;
        if state.done.runs(shard, campaign) == state.runs() {
            Ok(state)
        } else {
            Err(Corrupt)
        }
    }
}
