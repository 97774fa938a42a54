//! What is told of each run alone.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::record::Record;
use super::tally::largest_ratio;
use crate::closed_loop::ClosedLoop;

/// The runs of a block, just simulated.
pub(crate) struct Rows<'a> {
    pub(super) records: &'a [Record],
}

impl Rows<'_> {
    /// Names of a row's numbers: `samples`, `diverged` (0 or 1), `ratio` (largest `||e_1|| / k_1`, infinite if the run diverged, NaN without a
    /// constraint), `rms.OUTPUT` (root mean square of the tracking error from the settling time on, SI, NaN if no sample is so late),
    /// `saturated.INPUT` (fraction of the samples at the limit).
    pub(crate) fn columns<L: ClosedLoop>() -> Vec<String> {
        let fixed = ["samples", "diverged", "ratio"].map(ToString::to_string);
        let rms = L::OUTPUTS.iter().map(|name| format!("rms.{name}"));
        let saturated = L::INPUTS.iter().map(|name| format!("saturated.{name}"));
        fixed.into_iter().chain(rms).chain(saturated).collect()
    }

    /// Row after row.
    pub(crate) fn values(&self) -> Vec<f64> {
        let mut values = Vec::new();
        for record in self.records {
            let (samples, settled) = (record.samples as f64, record.settled as f64);
            values.extend([samples, f64::from(u8::from(record.diverged))]);
            values.push(largest_ratio(record).unwrap_or(f64::NAN));
            values.extend(
                record
                    .squared_error
                    .iter()
                    .map(|sum| (sum / settled).sqrt()),
            );
            values.extend(record.saturated.iter().map(|&count| count as f64 / samples));
        }
        values
    }
}
