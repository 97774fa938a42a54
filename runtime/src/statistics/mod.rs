//! What many numbers amount to: sums, quantiles, confidence intervals.
//!
//! A campaign is reduced by many threads, processes and machines, so its sums and quantiles are functions of the set of numbers alone:
//! whatever order they came in and however parts were merged, the result is the same to the last bit.

mod binomial;
mod codec;
mod exact_sum;
mod sketch;

pub use binomial::clopper_pearson;
pub(crate) use codec::{Corrupt, Decoder, Encoder};
pub use exact_sum::ExactSum;
pub use sketch::Sketch;

/// Place of the `percent`-th percentile by nearest rank among `count` ordered values, counted from 1: the first value such that at least
/// `percent` % of the values are not above it. The 50th percentile of an even number of values is the lower of the two in the middle.
pub fn rank(count: u64, percent: u32) -> u64 {
    let rank = (u128::from(count) * u128::from(percent)).div_ceil(100);
    rank.max(1) as u64
}

#[cfg(test)]
mod tests {
    use super::rank;

    #[test]
    fn ranks_are_nearest() {
        let of = |count| [0, 5, 50, 51, 95, 100].map(|percent| rank(count, percent));
        assert_eq!(of(4), [1, 1, 2, 3, 4, 4]);
        assert_eq!(of(100), [1, 5, 50, 51, 95, 100]);
        assert_eq!(rank(u64::MAX, 100), u64::MAX);
    }
}
