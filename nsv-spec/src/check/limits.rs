//! The limits of the checks, for the page that lists them all.

use super::{counts, disturbance, hardware, names, network, numbers, scenario, tables};

pub(crate) const NAME: usize = names::MAX_LENGTH;
pub(crate) const AXES: usize = tables::MAX_AXES;
pub(crate) const POINTS: usize = tables::MAX_POINTS;
pub(crate) const VALUES: usize = tables::MAX_VALUES;
pub(crate) const BLOCKS: usize = counts::MAX_BLOCKS;
pub(crate) const WIDTH: usize = counts::MAX_WIDTH;
pub(crate) const EXOSYSTEM: usize = disturbance::MAX_EXOSYSTEM;
pub(crate) const NUMBER: f64 = numbers::LARGEST;
pub(crate) const NETWORK: usize = network::MAX_NODES as usize;
pub(crate) const SUBSTEPS: usize = scenario::MAX_SUBSTEPS as usize;
pub(crate) const RUNS: usize = crate::model::MAX_RUNS as usize;
pub(crate) const DELAY: usize = hardware::MAX_DELAY as usize;
