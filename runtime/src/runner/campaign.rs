//! The campaign of a simulator binary: from its checkpoint to its end.

use std::io::Write;
use std::path::Path;
use std::time::{Duration, Instant};
use std::writeln;

use super::arguments::Request;
use super::runs::RunTable;
use super::{Failure, checkpoint};
use crate::closed_loop::ClosedLoop;
use crate::ensemble::{Flight, Rows, Shard, State, fly};

/// Time between checkpoints at first, and at most once a campaign has lasted a while.
const BETWEEN: [Duration; 2] = [Duration::from_millis(100), Duration::from_secs(5)];

/// Part of the time that may be spent on writing checkpoints, one in so many.
const SHARE: u32 = 20;

/// Simulates what is missing.
pub(super) fn simulate<L: ClosedLoop>(
    request: &Request,
    output: &mut impl Write,
) -> Result<State, Failure> {
    let campaign = &request.campaign;
    let (found, _claim) = match &request.checkpoint {
        Some(path) => {
            let claim = checkpoint::Claim::of(path)?;
            let found = checkpoint::read::<L>(path, request)
                .map_err(|refusal| Failure::Refused(path.clone(), refusal))?;
            (found, Some(claim))
        }
        None => (None, None),
    };
    let resumed = found.is_some();
    let start = found.unwrap_or_else(|| State::new::<L>(campaign));
    let table = match &request.run_table {
        Some(path) => Some((
            path.as_path(),
            RunTable::open::<L>(path, request, resumed.then_some(&start))?,
        )),
        None => None,
    };
    if resumed {
        line(output, format_args!("{{\"resumed\": {}}}", start.runs()))?;
    }
    let each_block = |block, rows: &Rows<'_>| match &table {
        Some((path, table)) => table
            .write(block, rows)
            .map_err(|error| Failure::File(path.to_path_buf(), error)),
        None => Ok(()),
    };
    let mut keeper = Keeper::new(start.runs());
    let runs = request.shard.runs(campaign);
    let tick = |flight: &Flight<'_>| {
        let done = flight.runs();
        line(output, format_args!("{{\"progress\": [{done}, {runs}]}}"))?;
        match &request.checkpoint {
            Some(path) if keeper.is_due() => keeper.keep(flight.snapshot(), |state| {
                keep::<L>(path, request, table.as_ref(), state)
            }),
            _ => Ok(()),
        }
    };
    let mut state = fly::<L, _>(campaign, request.shard, start, each_block, tick)?;
    if let Some(path) = &request.checkpoint {
        keep::<L>(path, request, table.as_ref(), &mut state)?;
    }
    Ok(state)
}

/// Adds up the states of all parts.
pub(super) fn merge<L: ClosedLoop>(request: &Request) -> Result<State, Failure> {
    let mut whole = State::new::<L>(&request.campaign);
    for path in &request.merge {
        let part = checkpoint::read_part::<L>(path, request)
            .map_err(|refusal| Failure::Refused(path.clone(), refusal))?;
        whole.merge(part);
    }
    let (found, runs) = (whole.runs(), Shard::WHOLE.runs(&request.campaign));
    if found == runs {
        Ok(whole)
    } else {
        Err(Failure::Parts(found, runs))
    }
}

/// Writes a checkpoint, after the rows of the runs in it.
fn keep<L: ClosedLoop>(
    path: &Path,
    request: &Request,
    table: Option<&(&Path, RunTable)>,
    state: &mut State,
) -> Result<(), Failure> {
    if let Some((path, table)) = table {
        table
            .sync()
            .map_err(|error| Failure::File(path.to_path_buf(), error))?;
    }
    checkpoint::write::<L>(path, request, state)
        .map_err(|error| Failure::File(path.to_path_buf(), error))
}

/// When checkpoints are due: soon at first, then seldom, and the less often the longer they take.
struct Keeper {
    started: Instant,
    last: Instant,
    took: Duration,
    /// Runs in the last one.
    runs: u64,
}

impl Keeper {
    fn new(runs: u64) -> Self {
        let now = Instant::now();
        Self {
            started: now,
            last: now,
            took: Duration::ZERO,
            runs,
        }
    }

    fn is_due(&self) -> bool {
        let [first, later] = BETWEEN;
        let patience = (self.started.elapsed() / 2).clamp(first, later);
        self.last.elapsed() >= patience.max(self.took * SHARE)
    }

    /// Writes the state if it is ahead of the last one.
    fn keep(
        &mut self,
        mut state: State,
        write: impl FnOnce(&mut State) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        if state.runs() == self.runs {
            return Ok(());
        }
        self.runs = state.runs();
        let begun = Instant::now();
        let written = write(&mut state);
        self.last = Instant::now();
        self.took = self.last - begun;
        written
    }
}

fn line(output: &mut impl Write, text: std::fmt::Arguments<'_>) -> Result<(), Failure> {
    writeln!(output, "{text}")
        .and_then(|()| output.flush())
        .map_err(Failure::Output)
}
