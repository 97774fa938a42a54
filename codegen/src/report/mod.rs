//! The report of a simulation: one HTML page that carries its own style and pictures and needs no network.
//!
//! Everything here is a pure function from data to text. The same specification, seed and options give the same bytes: no clock,
//! no speed and no machine appears on the page.

mod figures;
mod html;
pub(crate) mod number;
mod outcome;
mod page;
mod plant;
mod plot;
#[cfg(test)]
pub(crate) mod sample;
mod summary;
mod table;

pub(crate) use outcome::{Outcome, Quantiles, WorstRun};
pub(crate) use page::page;
pub(crate) use plant::Plant;
#[cfg(test)]
pub(crate) use plant::{Block, Channel, Input};
pub(crate) use table::Table;

/// What the page is made from.
pub(crate) struct Report<'a> {
    /// Names and units of the control problem.
    pub plant: &'a Plant,
    /// The command that makes the page again.
    pub command: &'a str,
    /// Campaign seed.
    pub seed: u64,
    /// Length of a run, s.
    pub horizon_s: f64,
    /// Start of the rms window, s.
    pub settle_s: f64,
    /// Number of the run whose trajectory is shown.
    pub trajectory_run: u64,
    /// Statistics of the campaign.
    pub outcome: &'a Outcome,
    /// Signals of one run.
    pub trajectory: &'a Table,
    /// Pointwise statistics over the runs, if there is more than one.
    pub band: Option<&'a Table>,
}
