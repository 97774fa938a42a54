//! Work on all cores: each takes blocks of runs, reduces some on its own, and adds the result to what is done.

use std::mem;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use std::vec::Vec;

use super::Campaign;
use super::record::Record;
use super::row::Rows;
use super::shard::Shard;
use super::state::State;
use super::tally::Tally;
use crate::closed_loop::ClosedLoop;
use crate::lanes::Width;

/// Runs that a thread reduces on its own before it shares them, unless they take longer than a while.
const SHARE: u64 = 256;
const WHILE: Duration = Duration::from_millis(500);

/// Time between calls of `tick`.
const TICK: Duration = Duration::from_millis(50);

/// A campaign under way.
pub(crate) struct Flight<'a> {
    campaign: &'a Campaign,
    shard: Shard,
    /// The next block to take.
    next: AtomicU64,
    /// Runs simulated, those of blocks that are not complete among them.
    runs: AtomicU64,
    stopped: AtomicBool,
    state: Mutex<State>,
    /// When the time was last taken.
    since: Mutex<Instant>,
}

impl Flight<'_> {
    /// Number of runs simulated.
    pub(crate) fn runs(&self) -> u64 {
        self.runs.load(Ordering::Relaxed)
    }

    /// A copy of what is done, blocks only as a whole.
    pub(crate) fn snapshot(&self) -> State {
        let mut state = lock(&self.state);
        let mut since = lock(&self.since);
        let now = Instant::now();
        let spent = now.duration_since(*since).as_nanos() as u64;
        state.spent_ns = state.spent_ns.saturating_add(spent);
        *since = now;
        state.clone()
    }

    /// Simulates blocks until none is left.
    fn work<L: ClosedLoop, E>(
        &self,
        done: &State,
        each_block: &(impl Fn(u64, &Rows<'_>) -> Result<(), E> + Sync),
    ) -> Result<(), E> {
        let mut own = Tally::new::<L>(self.campaign);
        let mut blocks = Vec::new();
        let mut shared = Instant::now();
        loop {
            let block = self.next.fetch_add(1, Ordering::Relaxed);
            if block >= self.shard.blocks(self.campaign) {
                break;
            }
            if done.done.contains(block) {
                continue;
            }
            let Some(records) = self.simulate::<L>(block) else {
                break;
            };
            let first = self.shard.runs_of(block, self.campaign).start;
            let first = self.campaign.first_run.wrapping_add(first);
            own.add(first, &records);
            each_block(
                block,
                &Rows {
                    first,
                    records: &records,
                },
            )?;
            blocks.push(block);
            if own.runs() >= SHARE || shared.elapsed() >= WHILE {
                shared = Instant::now();
                self.share(
                    mem::replace(&mut own, Tally::new::<L>(self.campaign)),
                    &mut blocks,
                );
            }
        }
        self.share(own, &mut blocks);
        Ok(())
    }

    /// Adds blocks to what is done.
    fn share(&self, mut own: Tally, blocks: &mut Vec<u64>) {
        own.settle();
        let mut state = lock(&self.state);
        state.tally.merge(own);
        for block in blocks.drain(..) {
            state.done.insert(block);
        }
    }

    /// The runs of a block; `None` if the campaign is broken off.
    fn simulate<L: ClosedLoop>(&self, block: u64) -> Option<Vec<Record>> {
        let runs = self.shard.runs_of(block, self.campaign);
        let width = match self.campaign.width {
            Some(width) if L::WIDTHS.contains(&width) => width,
            _ => Width::widest_of(L::WIDTHS),
        };
        let mut records = Vec::with_capacity((runs.end - runs.start) as usize);
        for first in runs.clone().step_by(width.lanes()) {
            if self.stopped.load(Ordering::Relaxed) {
                return None;
            }
            let count = (runs.end - first).min(width.lanes() as u64);
            let batch = Record::of_batch::<L>(self.campaign, width, first, count as usize);
            records.extend(batch);
            self.runs.fetch_add(count, Ordering::Relaxed);
        }
        Some(records)
    }
}

/// Simulates what is missing in `state`. `each_block` sees the runs of each block, numbered within the part, before it counts as
/// done; `tick` is called on this thread now and then, and once at the end. An error of either ends the campaign.
pub(crate) fn fly<L: ClosedLoop, E: Send>(
    campaign: &Campaign,
    shard: Shard,
    state: State,
    each_block: impl Fn(u64, &Rows<'_>) -> Result<(), E> + Sync,
    mut tick: impl FnMut(&Flight<'_>) -> Result<(), E>,
) -> Result<State, E> {
    let flight = Flight {
        campaign,
        shard,
        next: AtomicU64::new(0),
        runs: AtomicU64::new(state.runs()),
        stopped: AtomicBool::new(false),
        state: Mutex::new(state.clone()),
        since: Mutex::new(Instant::now()),
    };
    let threads = shard.blocks(campaign).min(campaign.threads.max(1) as u64);
    thread::scope(|scope| {
        let (alive, ended) = channel::<E>();
        for _ in 0..threads {
            let (alive, flight, state, each_block) = (alive.clone(), &flight, &state, &each_block);
            scope.spawn(move || {
                if let Err(error) = flight.work::<L, E>(state, each_block) {
                    // The receiver is gone if another failed before.
                    let _ = alive.send(error);
                }
            });
        }
        drop(alive);
        let outcome = loop {
            match ended.recv_timeout(TICK) {
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(error) = tick(&flight) {
                        break Err(error);
                    }
                }
                Err(RecvTimeoutError::Disconnected) => break tick(&flight),
                Ok(error) => break Err(error),
            }
        };
        flight.stopped.store(true, Ordering::Relaxed);
        outcome
    })?;
    Ok(flight.snapshot())
}

/// A poisoned lock is of a thread that panicked, and the panic is passed on when the threads are joined.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
