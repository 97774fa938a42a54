//! Sums without rounding.

use super::{Corrupt, Decoder, Encoder};

/// Digits of 32 bits: 2098 bits hold every finite `f64`, and 78 are left for the carries of up to 2^64 summands.
const DIGITS: usize = 68;

/// Bits of a digit.
const BITS: u32 = 32;

/// Summands between carries: each adds less than 2^32 to a digit of 63 bits.
const CARRY_AFTER: u32 = 1 << 30;

/// The exact sum of any number of `f64`: a fixed-point number from 2^-1074 up, rounded once when it is asked for its value. Sums of the same
/// numbers are equal whatever the order, and merging sums is adding all their numbers to one.
///
/// Kulisch's long accumulator in the form of Neal, *Fast exact summation using small and large superaccumulators* (2015): digits
/// overlap so that most additions carry nothing.
#[derive(Clone, Debug)]
pub struct ExactSum {
    /// Digit i counts 2^(32 i - 1074); between carries digits are signed and may exceed 32 bits.
    digits: [i64; DIGITS],
    since_carry: u32,
    /// Sum of the summands that are not finite.
    beyond: Option<Beyond>,
}

/// A sum that is not finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Beyond {
    Above,
    Below,
    NotANumber,
}

impl Beyond {
    const ALL: [Beyond; 3] = [Beyond::Above, Beyond::Below, Beyond::NotANumber];

    fn of(value: f64) -> Option<Self> {
        match value {
            _ if value.is_nan() => Some(Beyond::NotANumber),
            f64::INFINITY => Some(Beyond::Above),
            f64::NEG_INFINITY => Some(Beyond::Below),
            _ => None,
        }
    }

    fn value(self) -> f64 {
        match self {
            Beyond::Above => f64::INFINITY,
            Beyond::Below => f64::NEG_INFINITY,
            Beyond::NotANumber => f64::NAN,
        }
    }
}

impl Default for ExactSum {
    fn default() -> Self {
        Self {
            digits: [0; DIGITS],
            since_carry: 0,
            beyond: None,
        }
    }
}

impl PartialEq for ExactSum {
    fn eq(&self, other: &Self) -> bool {
        self.carried() == other.carried() && self.beyond == other.beyond
    }
}

impl ExactSum {
    /// Adds a number.
    pub fn add(&mut self, value: f64) {
        if !value.is_finite() {
            return self.add_beyond(Beyond::of(value));
        }
        let bits = value.to_bits();
        let exponent = (bits >> 52 & 0x7ff) as usize;
        let fraction = bits & ((1 << 52) - 1);
        // value = mantissa * 2^(place - 1074); subnormal numbers have exponent 0 and no leading one.
        let (mantissa, place) = match exponent {
            0 => (fraction, 0),
            _ => (fraction | 1 << 52, exponent - 1),
        };
        let wide = u128::from(mantissa) << (place % BITS as usize);
        let sign = if value.is_sign_negative() { -1 } else { 1 };
        let digits = &mut self.digits[place / BITS as usize..];
        digits[0] += sign * (wide as u32 as i64);
        digits[1] += sign * ((wide >> BITS) as u32 as i64);
        digits[2] += sign * ((wide >> (2 * BITS)) as u32 as i64);
        self.since_carry += 1;
        if self.since_carry == CARRY_AFTER {
            self.carry();
        }
    }

    /// Adds the numbers of another sum.
    pub fn merge(&mut self, other: &ExactSum) {
        self.carry();
        for (digit, more) in self.digits.iter_mut().zip(other.carried()) {
            *digit += more;
        }
        self.carry();
        self.add_beyond(other.beyond);
    }

    /// The sum, rounded to nearest, ties to even; infinite if it is too large.
    pub fn value(&self) -> f64 {
        if let Some(beyond) = self.beyond {
            return beyond.value();
        }
        let mut digits = self.carried();
        let negative = digits[DIGITS - 1] < 0;
        if negative {
            digits = carried(digits.map(|digit| -digit));
        }
        let magnitude = rounded(&digits);
        if negative { -magnitude } else { magnitude }
    }

    fn add_beyond(&mut self, more: Option<Beyond>) {
        self.beyond = match (self.beyond, more) {
            (Some(one), Some(other)) if one != other => Some(Beyond::NotANumber),
            (one, other) => one.or(other),
        };
    }

    fn carry(&mut self) {
        self.digits = self.carried();
        self.since_carry = 0;
    }

    /// The unique form of the sum: digits of 32 bits, but for the last, which has the sign.
    fn carried(&self) -> [i64; DIGITS] {
        carried(self.digits)
    }

    /// Writes the digits that are not zero.
    pub(crate) fn encode(&self, encoder: &mut Encoder) {
        let digits = self.carried();
        let used = |digit: &i64| *digit != 0;
        let first = digits.iter().position(used).unwrap_or(0);
        let end = digits.iter().rposition(used).map_or(first, |last| last + 1);
        let beyond = Beyond::ALL
            .iter()
            .position(|case| Some(*case) == self.beyond);
        encoder.count(beyond.map_or(0, |case| case as u64 + 1));
        encoder.count(first as u64);
        encoder.count((end - first) as u64);
        for digit in &digits[first..end] {
            encoder.signed(*digit);
        }
    }

    /// Reads what `encode` wrote.
    pub(crate) fn decode(decoder: &mut Decoder<'_>) -> Result<Self, Corrupt> {
        let mut sum = ExactSum::default();
        match decoder.count()? {
            0 => {}
            case => sum.beyond = Some(*Beyond::ALL.get(case as usize - 1).ok_or(Corrupt)?),
        }
        let (first, length) = (decoder.count()?, decoder.count()?);
        let end = first
            .checked_add(length)
            .filter(|end| *end <= DIGITS as u64);
        for digit in first..end.ok_or(Corrupt)? {
            sum.digits[digit as usize] = decoder.signed()?;
        }
        // Only the unique form is written, and no sum of 2^64 numbers is near the end of the last digit.
        let (last, rest) = sum.digits.split_last().ok_or(Corrupt)?;
        let carried = rest.iter().all(|digit| *digit >> BITS == 0);
        if carried && (*last >> BITS == 0 || *last >> BITS == -1) {
            Ok(sum)
        } else {
            Err(Corrupt)
        }
    }
}

fn carried(mut digits: [i64; DIGITS]) -> [i64; DIGITS] {
    for low in 0..DIGITS - 1 {
        digits[low + 1] += digits[low] >> BITS;
        digits[low] &= (1 << BITS) - 1;
    }
    digits
}

/// The nearest `f64` of a sum that is not negative.
fn rounded(digits: &[i64; DIGITS]) -> f64 {
    let Some(top) = digits.iter().rposition(|digit| *digit != 0) else {
        return 0.0;
    };
    let highest = BITS as usize * top + digits[top].ilog2() as usize;
    let lowest = highest.saturating_sub(52);
    let mantissa = bits_from(digits, lowest) & ((1 << 53) - 1);
    if lowest == 0 {
        // Below 2^-1021 the number is its own bit pattern.
        return f64::from_bits(mantissa);
    }
    let half = bits_from(digits, lowest - 1) & 1 == 1;
    let (whole, part) = ((lowest - 1) / BITS as usize, (lowest - 1) % BITS as usize);
    let rest = digits[whole] & ((1 << part) - 1) != 0 || digits[..whole].iter().any(|d| *d != 0);
    let up = half && (rest || mantissa & 1 == 1);
    // A carry out of the mantissa raises the exponent, as it should; at the end of the range it gives the pattern of infinity.
    let pattern = ((lowest as u64 + 1) << 52) + (mantissa - (1 << 52)) + u64::from(up);
    f64::from_bits(pattern.min(f64::INFINITY.to_bits()))
}

/// 64 bits of the sum from a place on.
fn bits_from(digits: &[i64; DIGITS], place: usize) -> u64 {
    let digit = |index: usize| digits.get(index).map_or(0, |digit| *digit as u128);
    let first = place / BITS as usize;
    let wide = digit(first) | digit(first + 1) << BITS | digit(first + 2) << (2 * BITS);
    (wide >> (place % BITS as usize)) as u64
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::super::{Decoder, Encoder};
    use super::ExactSum;
    use crate::noise::Noise;

    fn sum(values: &[f64]) -> ExactSum {
        let mut sum = ExactSum::default();
        for &value in values {
            sum.add(value);
        }
        sum
    }

    fn check(values: &[f64], expected: f64) {
        let found = sum(values).value();
        assert_eq!(
            found.to_bits(),
            expected.to_bits(),
            "{values:?}: {found:?}, expected {expected:?}"
        );
        let negated: Vec<f64> = values.iter().map(|value| -value).collect();
        assert_eq!(sum(&negated).value(), -expected);
    }

    #[test]
    fn nothing_is_lost() {
        check(&[1e308, 1.0, -1e308], 1.0);
        check(&[1e16, 1.0, 1.0, -1e16], 2.0);
        check(&[f64::MAX, f64::MAX, -f64::MAX], f64::MAX);
        check(&[f64::MAX, 5e-324, -f64::MAX], 5e-324);
        check(&[2.2250738585072014e-308, -5e-324], 2.225073858507201e-308);
        check(&[0.1; 10], 1.0);
    }

    #[test]
    fn the_value_is_the_nearest() {
        let half_ulp = f64::EPSILON / 2.0;
        check(&[1.0, half_ulp], 1.0);
        check(&[1.0, half_ulp, 5e-324], 1.0 + f64::EPSILON);
        check(&[1.0 + f64::EPSILON, half_ulp], 1.0 + 2.0 * f64::EPSILON);
        check(&[f64::MAX, f64::MAX], f64::INFINITY);
        check(&[f64::MAX, 2.0_f64.powi(970)], f64::INFINITY);
        check(&[f64::MAX, 2.0_f64.powi(969)], f64::MAX);
        check(&[2.0_f64.powi(53), 1.0], 2.0_f64.powi(53));
    }

    #[test]
    fn a_single_number_is_itself() {
        let noise = Noise::<f64>::process(1, 0);
        for draw in 0..2000 {
            let scale = 2.0_f64.powi(((noise.uniform(draw, 0) - 0.5) * 2000.0) as i32);
            check(
                &[noise.uniform(draw, 1) * scale],
                noise.uniform(draw, 1) * scale,
            );
        }
        check(&[0.0, -0.0], 0.0);
    }

    #[test]
    fn what_is_not_finite_shows() {
        assert_eq!(sum(&[1.0, f64::INFINITY, 2.0]).value(), f64::INFINITY);
        assert_eq!(sum(&[f64::NEG_INFINITY]).value(), f64::NEG_INFINITY);
        assert!(sum(&[f64::INFINITY, f64::NEG_INFINITY]).value().is_nan());
        assert!(sum(&[f64::NAN, 1.0]).value().is_nan());
    }

    #[test]
    fn order_and_parts_do_not_matter() {
        let noise = Noise::<f64>::process(7, 0);
        let values: Vec<f64> = (0..1000)
            .map(|k| noise.normal(k, 0) * 10.0_f64.powi((40.0 * noise.uniform(k, 1)) as i32 - 20))
            .collect();
        let all = sum(&values);
        let backwards: Vec<f64> = values.iter().rev().copied().collect();
        assert_eq!(sum(&backwards), all);
        for parts in [2, 7, 100] {
            let mut merged = ExactSum::default();
            for part in (0..parts).rev() {
                let of_part: Vec<f64> = values.iter().copied().skip(part).step_by(parts).collect();
                merged.merge(&sum(&of_part));
            }
            assert_eq!(merged, all);
            assert_eq!(merged.value().to_bits(), all.value().to_bits());
        }
    }

    #[test]
    fn a_sum_is_written_and_read() {
        for values in [
            &[][..],
            &[1.0, -1e-300],
            &[-2.5, 1e300],
            &[f64::INFINITY],
            &[-5e-324],
        ] {
            let mut encoder = Encoder::default();
            sum(values).encode(&mut encoder);
            let bytes = encoder.bytes();
            let mut decoder = Decoder::new(&bytes);
            assert_eq!(ExactSum::decode(&mut decoder), Ok(sum(values)));
            assert_eq!(decoder.end(), Ok(()));
            assert!(ExactSum::decode(&mut Decoder::new(&bytes[..bytes.len() - 1])).is_err());
        }
    }
}
