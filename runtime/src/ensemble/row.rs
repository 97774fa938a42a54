//! What is told of each run alone.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::record::Record;
use super::tally::largest;
use crate::closed_loop::ClosedLoop;

/// The runs of a block, just simulated.
pub(crate) struct Rows<'a> {
    /// Number of the first.
    pub(super) first: u64,
    pub(super) records: &'a [Record],
}

impl Rows<'_> {
    /// Names of a row's numbers. Three are integers of 64 bits: `run` (its number), `samples`, `diverged` (0 or 1). The others are `f64`: `ratio` (largest `||y - y_r|| / k_1`, infinite if the run diverged, NaN without a
    /// constraint), `settled_ratio` (the same from the settling time on), `rms.OUTPUT` (root mean square of the tracking error from the settling time on, SI, NaN if no sample is so late),
    /// `saturated.INPUT` (fraction of the samples at the limit).
    pub(crate) fn columns<L: ClosedLoop>() -> Vec<String> {
        let fixed =
            ["run", "samples", "diverged", "ratio", "settled_ratio"].map(ToString::to_string);
        let rms = L::OUTPUTS.iter().map(|name| format!("rms.{name}"));
        let saturated = L::INPUTS.iter().map(|name| format!("saturated.{name}"));
        fixed.into_iter().chain(rms).chain(saturated).collect()
    }

    /// Row after row, each number in 8 bytes, little endian.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        for (index, record) in (0..).zip(self.records) {
            let run = self.first.wrapping_add(index);
            for count in [run, record.samples, u64::from(record.diverged)] {
                bytes.extend(count.to_le_bytes());
            }
            let (samples, settled) = (record.samples as f64, record.settled as f64);
            let rms = record
                .squared_error
                .iter()
                .map(|sum| (sum / settled).sqrt());
            let saturated = record.saturated.iter().map(|&count| count as f64 / samples);
            let ratios = [record.ratio, record.settled_ratio];
            let ratios = ratios.map(|ratio| largest(record, ratio).unwrap_or(f64::NAN));
            for value in ratios.into_iter().chain(rms).chain(saturated) {
                bytes.extend(value.to_le_bytes());
            }
        }
        bytes
    }
}
