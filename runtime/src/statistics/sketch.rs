//! Quantiles of any number of values in bounded memory.

use std::mem;
use std::vec::Vec;

use super::{Corrupt, Decoder, Encoder, rank};

/// The sign bit of a float.
const SIGN: u64 = 1 << 63;

/// Counts of values in bins that widen as needed: at most `limit` bins are occupied.
///
/// A bin is a range of neighbouring floats that agree but for their last `shift` bits, so bins are as wide as 2^(shift - 52) of what is in them.
/// When more than `limit` are occupied, `shift` grows by one and neighbours join. It is thus the least that is enough for the set of values,
/// whatever their order, and the sketch of a union is the merge of sketches, bin by bin and bit for bit. Up to `limit` distinct values, every bin
/// holds one float and quantiles are exact; the least and the largest value always are.
///
/// Logarithmic bins with exact merges are those of DDSketch (Masson, Rim, Lee 2019), joined uniformly as in UDDSketch (Epicoco et al. 2020).
#[derive(Clone, Debug)]
pub struct Sketch {
    limit: usize,
    shift: u32,
    /// Occupied bins in ascending order, with their counts.
    bins: Vec<(u64, u64)>,
    /// Keys of values that wait to be counted.
    waiting: Vec<u64>,
    /// Values that are minus infinity and infinity.
    infinite: [u64; 2],
    /// Least and largest finite value.
    range: Option<(f64, f64)>,
}

impl PartialEq for Sketch {
    fn eq(&self, other: &Self) -> bool {
        let parts = |sketch: &Sketch| {
            let mut sketch = sketch.clone();
            sketch.settle();
            let range = sketch.range.map(|(low, high)| (key(low), key(high)));
            (
                sketch.limit,
                sketch.shift,
                sketch.bins,
                sketch.infinite,
                range,
            )
        };
        parts(self) == parts(other)
    }
}

impl Sketch {
    /// A sketch of nothing with up to `limit` bins, of 16 bytes each.
    pub fn new(limit: usize) -> Self {
        Self {
            limit,
            shift: 0,
            bins: Vec::new(),
            waiting: Vec::new(),
            infinite: [0; 2],
            range: None,
        }
    }

    /// Makes room for more values.
    pub(crate) fn reserve(&mut self, values: usize) {
        let most = self.limit - self.waiting.len();
        self.waiting.reserve_exact(values.min(most));
    }

    /// Counts a value, which may be infinite; NaN has no place in an order and is left out.
    pub fn push(&mut self, value: f64) {
        if value.is_nan() {
            return;
        }
        if value.is_infinite() {
            self.infinite[usize::from(value > 0.0)] += 1;
            return;
        }
        self.widen(value, value);
        self.waiting.push(key(value));
        if self.waiting.len() >= self.limit {
            self.settle();
        }
    }

    /// Counts the values of another sketch of the same limit.
    pub fn merge(&mut self, mut other: Sketch) {
        debug_assert_eq!(self.limit, other.limit, "invariant: sketches of one kind");
        self.settle();
        other.settle();
        let shift = self.shift.max(other.shift);
        self.join_to(shift);
        other.join_to(shift);
        self.bins = merged(&self.bins, &other.bins);
        self.fit();
        for (count, more) in self.infinite.iter_mut().zip(other.infinite) {
            *count += more;
        }
        if let Some((low, high)) = other.range {
            self.widen(low, high);
        }
    }

    /// Counts the values that wait.
    pub fn settle(&mut self) {
        let mut waiting = mem::take(&mut self.waiting);
        waiting.iter_mut().for_each(|key| *key >>= self.shift);
        waiting.sort_unstable();
        let mut counted: Vec<(u64, u64)> = Vec::with_capacity(waiting.len());
        for key in waiting.drain(..) {
            push_bin(&mut counted, key, 1);
        }
        self.waiting = waiting;
        if self.bins.is_empty() {
            self.bins = counted;
        } else if !counted.is_empty() {
            self.bins = merged(&self.bins, &counted);
        }
        self.fit();
    }

    /// Number of values.
    pub fn count(&self) -> u64 {
        let binned: u64 = self.bins.iter().map(|(_, count)| count).sum();
        self.infinite[0] + binned + self.waiting.len() as u64 + self.infinite[1]
    }

    /// The `percent`-th percentile by nearest rank (see [`rank`]): exact if [`Sketch::accuracy`] is 0, otherwise within that of it, with
    /// the values of a bin taken to lie evenly in it. `None` without values.
    pub fn percentile(&self, percent: u32) -> Option<f64> {
        debug_assert!(self.waiting.is_empty(), "invariant: the sketch is settled");
        let count = self.count();
        (count > 0).then(|| self.value_at(rank(count, percent), count))
    }

    /// The largest relative distance between a percentile and the value that it stands for.
    pub fn accuracy(&self) -> f64 {
        match self.shift {
            0 => 0.0,
            shift => f64::from_bits(u64::from(1023 + shift - 52) << 52),
        }
    }

    fn value_at(&self, place: u64, count: u64) -> f64 {
        let Some((least, largest)) = self.range else {
            return if place <= self.infinite[0] {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
        };
        let mut before = self.infinite[0];
        if place <= before {
            return f64::NEG_INFINITY;
        }
        if place > count - self.infinite[1] {
            return f64::INFINITY;
        }
        if place == count - self.infinite[1] {
            return largest;
        }
        if place == before + 1 {
            return least;
        }
        for &(bin, inside) in &self.bins {
            if place <= before + inside {
                let within = (place - before) as f64 - 0.5;
                let (low, high) = self.ends(bin);
                return (low + (high - low) * (within / inside as f64)).clamp(least, largest);
            }
            before += inside;
        }
        largest
    }

    /// The first and the last float of a bin.
    fn ends(&self, bin: u64) -> (f64, f64) {
        let first = bin << self.shift;
        let last = first | ((1 << self.shift) - 1);
        let (lowest, highest) = (key(-f64::MAX), key(f64::MAX));
        (
            value(first.clamp(lowest, highest)),
            value(last.clamp(lowest, highest)),
        )
    }

    fn widen(&mut self, low: f64, high: f64) {
        // By key, so that the two zeros have an order too.
        self.range = Some(self.range.map_or((low, high), |(least, largest)| {
            (
                if key(low) < key(least) { low } else { least },
                if key(high) > key(largest) {
                    high
                } else {
                    largest
                },
            )
        }));
    }

    /// Joins neighbouring bins until no more than the limit are occupied.
    fn fit(&mut self) {
        while self.bins.len() > self.limit {
            self.join_to(self.shift + 1);
        }
    }

    fn join_to(&mut self, shift: u32) {
        let by = shift - self.shift;
        if by == 0 {
            return;
        }
        self.shift = shift;
        let mut joined = Vec::with_capacity(self.bins.len());
        for &(bin, count) in &self.bins {
            push_bin(&mut joined, bin >> by, count);
        }
        self.bins = joined;
    }

    /// Writes the sketch, bins by their distance from the one before.
    pub(crate) fn encode(&self, encoder: &mut Encoder) {
        debug_assert!(self.waiting.is_empty(), "invariant: the sketch is settled");
        encoder.count(self.limit as u64);
        encoder.count(u64::from(self.shift));
        encoder.count(self.bins.len() as u64);
        let mut before = 0;
        for &(bin, count) in &self.bins {
            encoder.count(bin - before);
            encoder.count(count);
            before = bin;
        }
        encoder.count(self.infinite[0]);
        encoder.count(self.infinite[1]);
        if let Some((least, largest)) = self.range {
            encoder.float(least);
            encoder.float(largest);
        }
    }

    /// Reads what `encode` wrote of a sketch with that limit.
    pub(crate) fn decode(limit: usize, decoder: &mut Decoder<'_>) -> Result<Self, Corrupt> {
        decoder.expect(limit)?;
        let mut sketch = Sketch::new(limit);
        sketch.shift = u32::try_from(decoder.count()?).map_err(|_| Corrupt)?;
        let bins = decoder.count()?;
        if sketch.shift >= u64::BITS || bins > limit as u64 {
            return Err(Corrupt);
        }
        let (mut bin, mut count) = (0_u64, 0_u64);
        for index in 0..bins {
            let step = decoder.count()?;
            if step == 0 && index > 0 {
                return Err(Corrupt);
            }
            bin = bin.checked_add(step).ok_or(Corrupt)?;
            let inside = decoder.count()?;
            if inside == 0 || bin > u64::MAX >> sketch.shift {
                return Err(Corrupt);
            }
            count = count.checked_add(inside).ok_or(Corrupt)?;
            sketch.bins.push((bin, inside));
        }
        sketch.infinite = [decoder.count()?, decoder.count()?];
        let infinite = sketch.infinite[0].checked_add(sketch.infinite[1]);
        let all = infinite.and_then(|infinite| count.checked_add(infinite));
        if all.is_none() {
            return Err(Corrupt);
        }
        if bins > 0 {
            let (least, largest) = (decoder.float()?, decoder.float()?);
            let place = |value: f64| key(value) >> sketch.shift;
            let ends = [sketch.bins.first(), sketch.bins.last()].map(|bin| bin.map(|bin| bin.0));
            // In the first and the last bin, hence in order but for a bin of both.
            if !(least.is_finite() && largest.is_finite())
                || key(least) > key(largest)
                || ends != [Some(place(least)), Some(place(largest))]
            {
                return Err(Corrupt);
            }
            sketch.range = Some((least, largest));
        }
        Ok(sketch)
    }
}

/// A float's place in the order of floats.
fn key(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits & SIGN == 0 { bits | SIGN } else { !bits }
}

/// The float at a place.
fn value(key: u64) -> f64 {
    f64::from_bits(if key & SIGN == 0 { !key } else { key ^ SIGN })
}

/// Appends to bins in ascending order.
fn push_bin(bins: &mut Vec<(u64, u64)>, bin: u64, count: u64) {
    match bins.last_mut() {
        Some((last, counted)) if *last == bin => *counted += count,
        _ => bins.push((bin, count)),
    }
}

/// Both lists of bins as one.
fn merged(one: &[(u64, u64)], other: &[(u64, u64)]) -> Vec<(u64, u64)> {
    let mut all = Vec::with_capacity(one.len() + other.len());
    let (mut i, mut j) = (0, 0);
    while i < one.len() && j < other.len() {
        let from = if one[i].0 <= other[j].0 {
            i += 1;
            one[i - 1]
        } else {
            j += 1;
            other[j - 1]
        };
        push_bin(&mut all, from.0, from.1);
    }
    for &(bin, count) in one[i..].iter().chain(&other[j..]) {
        push_bin(&mut all, bin, count);
    }
    all
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::super::{Decoder, Encoder, rank};
    use super::Sketch;
    use crate::noise::Noise;

    fn sketch(limit: usize, values: impl IntoIterator<Item = f64>) -> Sketch {
        let mut sketch = Sketch::new(limit);
        for value in values {
            sketch.push(value);
        }
        sketch.settle();
        sketch
    }

    /// Values of both signs over many magnitudes, some of them infinite or equal.
    fn values(count: u64) -> Vec<f64> {
        let noise = Noise::<f64>::process(3, 0);
        let value = |k| match k % 50 {
            7 => f64::INFINITY,
            8 => 0.25,
            _ => noise.normal(k, 0) * (4.0 * noise.normal(k, 1)).exp(),
        };
        (0..count).map(value).collect()
    }

    #[test]
    fn few_values_have_exact_percentiles() {
        let mut values = values(300);
        let sketch = sketch(300, values.iter().copied());
        values.sort_by(f64::total_cmp);
        for percent in 0..=100 {
            let expected = values[rank(300, percent) as usize - 1];
            assert_eq!(sketch.percentile(percent), Some(expected), "{percent} %");
        }
        assert_eq!((sketch.accuracy(), sketch.count()), (0.0, 300));
    }

    #[test]
    fn many_values_have_percentiles_of_the_accuracy_stated() {
        let mut values = values(20_000);
        let sketch = sketch(256, values.iter().copied());
        assert!(sketch.bins.len() <= 256 && sketch.accuracy() > 0.0);
        values.sort_by(f64::total_cmp);
        for percent in 0..=100 {
            let expected = values[rank(20_000, percent) as usize - 1];
            let found = sketch.percentile(percent).expect("there are values");
            assert!(
                found == expected || (found - expected).abs() <= sketch.accuracy() * expected.abs(),
                "{percent} %: {found}, expected {expected} to {}",
                sketch.accuracy()
            );
        }
        assert_eq!(sketch.percentile(100), Some(f64::INFINITY));
        assert_eq!(sketch.percentile(0), values.first().copied());
    }

    #[test]
    fn a_narrow_spread_is_resolved_in_spite_of_outliers() {
        let noise = Noise::<f64>::process(4, 0);
        let narrow = (0..50_000).map(|k| 1e6 + noise.uniform(k, 0));
        let sketch = sketch(256, narrow.chain([1e300, -1e-300, 0.0]));
        let median = sketch.percentile(50).expect("there are values");
        assert!((median - 1e6 - 0.5).abs() < 0.02, "{median}");
    }

    #[test]
    fn order_and_parts_do_not_matter() {
        let values = values(3000);
        for limit in [16, 256] {
            let all = sketch(limit, values.iter().copied());
            assert_eq!(sketch(limit, values.iter().rev().copied()), all);
            for parts in [2, 5, 64] {
                let mut merged = Sketch::new(limit);
                for part in (0..parts).rev() {
                    merged.merge(sketch(
                        limit,
                        values.iter().copied().skip(part).step_by(parts),
                    ));
                }
                assert_eq!(merged, all, "{parts} parts");
            }
        }
    }

    #[test]
    fn the_size_is_bounded() {
        let mut sketch = Sketch::new(64);
        for value in values(10_000) {
            sketch.push(value);
            assert!(sketch.bins.len() <= 64 && sketch.waiting.capacity() <= 64);
        }
    }

    #[test]
    fn nothing_has_no_percentile() {
        assert_eq!(Sketch::new(8).percentile(50), None);
        let mut infinite = sketch(8, [f64::INFINITY, f64::NEG_INFINITY, f64::NAN]);
        assert_eq!(infinite.percentile(50), Some(f64::NEG_INFINITY));
        assert_eq!(infinite.percentile(51), Some(f64::INFINITY));
        infinite.push(-0.0);
        infinite.settle();
        assert_eq!(infinite.percentile(50), Some(0.0));
    }

    #[test]
    fn a_sketch_is_written_and_read() {
        for values in [Vec::new(), values(5), values(5000), [f64::INFINITY].into()] {
            let written = sketch(64, values);
            let mut encoder = Encoder::default();
            written.encode(&mut encoder);
            let bytes = encoder.bytes();
            let mut decoder = Decoder::new(&bytes);
            assert_eq!(Sketch::decode(64, &mut decoder), Ok(written));
            assert_eq!(decoder.end(), Ok(()));
            for cut in 0..bytes.len() {
                assert!(Sketch::decode(64, &mut Decoder::new(&bytes[..cut])).is_err());
            }
            assert!(Sketch::decode(65, &mut Decoder::new(&bytes)).is_err());
        }
    }

    #[test]
    fn a_sketch_that_cannot_be_is_refused() {
        let read = |change: fn(&mut Sketch)| {
            let mut changed = sketch(64, [-1.0, 2.0, f64::INFINITY]);
            change(&mut changed);
            let mut encoder = Encoder::default();
            changed.encode(&mut encoder);
            Sketch::decode(64, &mut Decoder::new(&encoder.bytes())).is_ok()
        };
        assert!(read(|_| ()));
        assert!(!read(|sketch| sketch.range = Some((2.0, -1.0))));
        assert!(!read(|sketch| sketch.range = Some((-1.0, 3.0))));
        assert!(!read(|sketch| sketch.range = Some((f64::NAN, 2.0))));
        assert!(!read(|sketch| sketch.shift = 1));
        assert!(!read(|sketch| sketch.bins[0].1 = 0));
        assert!(!read(|sketch| sketch.bins[0].1 = u64::MAX));
        assert!(!read(|sketch| sketch.infinite[0] = u64::MAX - 2));
    }
}
