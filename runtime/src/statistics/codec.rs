//! Bytes of statistics on disk.

use std::vec::Vec;

/// Bytes that `Encoder` did not write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Corrupt;

/// Appends numbers: counts in groups of 7 bits, low first (LEB128), floats as their 8 bytes.
#[derive(Default)]
pub(crate) struct Encoder {
    bytes: Vec<u8>,
}

impl Encoder {
    /// A count; small ones take few bytes.
    pub(crate) fn count(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.bytes.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.bytes.push(value as u8);
    }

    /// A number with a sign, small magnitudes in few bytes.
    pub(crate) fn signed(&mut self, value: i64) {
        self.count((value << 1 ^ value >> 63) as u64);
    }

    /// The bits of a number.
    pub(crate) fn float(&mut self, value: f64) {
        self.bytes.extend(value.to_le_bytes());
    }

    /// What was written.
    pub(crate) fn bytes(self) -> Vec<u8> {
        self.bytes
    }
}

/// Reads numbers in the order in which they were written.
pub(crate) struct Decoder<'a> {
    rest: &'a [u8],
}

impl<'a> Decoder<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    pub(crate) fn count(&mut self) -> Result<u64, Corrupt> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let (&byte, rest) = self.rest.split_first().ok_or(Corrupt)?;
            self.rest = rest;
            let group = u64::from(byte & 0x7f);
            if group << shift >> shift != group {
                return Err(Corrupt);
            }
            value |= group << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(Corrupt)
    }

    pub(crate) fn signed(&mut self) -> Result<i64, Corrupt> {
        let value = self.count()?;
        Ok((value >> 1) as i64 ^ -((value & 1) as i64))
    }

    pub(crate) fn float(&mut self) -> Result<f64, Corrupt> {
        let (bytes, rest) = self.rest.split_first_chunk().ok_or(Corrupt)?;
        self.rest = rest;
        Ok(f64::from_le_bytes(*bytes))
    }

    /// A count that is known: anything else is not what was written.
    pub(crate) fn expect(&mut self, expected: usize) -> Result<(), Corrupt> {
        if self.count()? == expected as u64 {
            Ok(())
        } else {
            Err(Corrupt)
        }
    }

    /// Nothing may be left.
    pub(crate) fn end(&self) -> Result<(), Corrupt> {
        if self.rest.is_empty() {
            Ok(())
        } else {
            Err(Corrupt)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Corrupt, Decoder, Encoder};

    #[test]
    fn numbers_are_read_as_written() {
        let mut encoder = Encoder::default();
        let counts = [0, 1, 127, 128, 300, u64::MAX >> 1, u64::MAX];
        let signed = [0, -1, 1, i64::MIN, i64::MAX, -64];
        for count in counts {
            encoder.count(count);
        }
        for value in signed {
            encoder.signed(value);
        }
        encoder.float(-1e-300);
        let bytes = encoder.bytes();
        let mut decoder = Decoder::new(&bytes);
        for count in counts {
            assert_eq!(decoder.count(), Ok(count));
        }
        for value in signed {
            assert_eq!(decoder.signed(), Ok(value));
        }
        assert_eq!(decoder.end(), Err(Corrupt));
        assert_eq!(decoder.float(), Ok(-1e-300));
        assert_eq!(decoder.end(), Ok(()));
        assert_eq!(decoder.count(), Err(Corrupt));
    }

    #[test]
    fn a_count_of_more_than_64_bits_is_refused() {
        assert_eq!(Decoder::new(&[0xff; 9]).count(), Err(Corrupt));
        let mut bytes = [0x80; 10];
        bytes[9] = 2;
        assert_eq!(Decoder::new(&bytes).count(), Err(Corrupt));
    }
}
