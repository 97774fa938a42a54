//! The grammar of unit expressions.
//!
//! ```text
//! unit   = factor { ("*" | "/") factor }          left to right, no blanks: kg/m/s^2 = kg/(m*s^2)
//! factor = ( name | "1" | "(" unit ")" | "sqrt(" unit ")" ) [ "^" [ "-" ] digits ]
//! ```
//!
//! A unit after a number in an expression ends where what follows cannot be one: in `2 m/s*exp(-x)` before `*exp`, in
//! `2 m/s*t` before `*t` (`t` is the time there, although `5 t` are tonnes), in `2 m * g` at the blank.

use super::dimension::Dimension;
use super::double::Double;
use super::error::{UnitError, UnitFault};
use super::{Unit, table};
use crate::suggest::Meant;

/// Brackets within each other in a unit.
pub(crate) const MAX_DEPTH: usize = 16;
/// Bytes of a name; longer ones are no units and not worth comparing with any.
const MAX_NAME: usize = 64;

/// A unit that fills `text` up to blanks around it.
pub(super) fn whole(text: &str) -> Result<Unit, UnitError> {
    let text = text.trim_end();
    let start = text.len() - text.trim_start().len();
    let mut scanner = Scanner {
        text,
        at: start,
        start,
        depth: 0,
        literal: false,
    };
    let size = scanner.product(true)?;
    if scanner.at < scanner.text.len() {
        return Err(scanner.malformed("`*`, `/` or `^`"));
    }
    scanner.unit(size)
}

/// The unit of a number literal at the start of `text` and the number of bytes it takes; `None` if no unit begins there.
pub(crate) fn scan(text: &str) -> Result<Option<(Unit, usize)>, UnitError> {
    let mut scanner = Scanner {
        text,
        at: 0,
        start: 0,
        depth: 0,
        literal: true,
    };
    let name = scanner.name();
    if name.is_empty() && !text.starts_with("1/")
        || !name.is_empty() && name != "sqrt" && scanner.goes_on_as_quantity()
    {
        return Ok(None);
    }
    scanner.at = 0;
    match scanner.product(false) {
        Ok(_) if &text[..scanner.at] == "1" => Ok(None),
        Ok(size) => scanner.unit(size).map(|unit| Some((unit, scanner.at))),
        Err(_) if name == "sqrt" => Ok(None),
        Err(error) => Err(error),
    }
}

#[derive(Clone, Copy)]
struct Size {
    dimension: Dimension,
    scale: Double,
}

struct Scanner<'a> {
    text: &'a str,
    at: usize,
    start: usize,
    depth: usize,
    /// Whether the unit follows a number in an expression.
    literal: bool,
}

impl<'a> Scanner<'a> {
    /// Factors up to the first thing that continues no unit. That is an error for the caller if `strict`; else what comes
    /// after the unit is not its business, and an operator in front of it is given back.
    fn product(&mut self, strict: bool) -> Result<Size, UnitError> {
        let mut size = self.factor(strict)?;
        while let Some(operator @ (b'*' | b'/')) = self.peek() {
            let before = self.at;
            self.at += 1;
            let factor = self.factor(strict).and_then(|factor| {
                if !strict && self.goes_on_as_quantity() {
                    Err(self.malformed("a unit"))
                } else {
                    Ok(factor)
                }
            });
            match factor {
                Ok(factor) if operator == b'*' => size = self.times(size, factor)?,
                Ok(factor) => size = self.over(size, factor)?,
                Err(error) if strict => return Err(error),
                Err(_) => {
                    self.at = before;
                    break;
                }
            }
        }
        Ok(size)
    }

    fn factor(&mut self, strict: bool) -> Result<Size, UnitError> {
        let size = self.atom()?;
        let before = self.at;
        match self.exponent() {
            Ok(None) => Ok(size),
            Ok(Some(exponent)) => {
                let dimension = size
                    .dimension
                    .checked_powi(exponent)
                    .ok_or_else(|| self.out_of_range())?;
                Ok(Size {
                    dimension,
                    scale: size.scale.powi(exponent),
                })
            }
            Err(error) if strict => Err(error),
            Err(_) => {
                self.at = before;
                Ok(size)
            }
        }
    }

    fn atom(&mut self) -> Result<Size, UnitError> {
        let start = self.at;
        if self.peek() == Some(b'(') {
            return self.brackets();
        }
        if self.peek() == Some(b'1') {
            self.at += 1;
            return Ok(Size {
                dimension: Dimension::ONE,
                scale: Double::ONE,
            });
        }
        let name = self.name();
        if name.is_empty() {
            return Err(self.malformed("a unit"));
        }
        if name == "sqrt" && self.peek() == Some(b'(') {
            let square = self.brackets()?;
            let dimension = square
                .dimension
                .checked_sqrt()
                .ok_or_else(|| self.out_of_range())?;
            return Ok(Size {
                dimension,
                scale: square.scale.sqrt(),
            });
        }
        let is_time = self.literal && name == "t" && start > 0;
        match table::find(name).filter(|_| !is_time) {
            Some((dimension, scale)) => Ok(Size { dimension, scale }),
            None => {
                let suggestion = self.suggestion(name, start);
                let fault = UnitFault::Unknown {
                    name: name.to_owned(),
                    suggestion,
                };
                Err(UnitError {
                    range: start..self.at,
                    fault,
                })
            }
        }
    }

    /// What the name just read, which starts at byte `start`, was meant for: in brackets where an operator beside it would tear a
    /// compound unit apart.
    fn suggestion(&self, name: &str, start: usize) -> Option<Meant> {
        let mut meant = (name.len() <= MAX_NAME).then(|| table::suggest(name))??;
        let torn = self.text[..start].ends_with('/') || self.peek() == Some(b'^');
        if torn && meant.name.contains(['*', '/']) {
            meant.name = format!("({})", meant.name);
        }
        Some(meant)
    }

    fn brackets(&mut self) -> Result<Size, UnitError> {
        if self.depth == MAX_DEPTH {
            return Err(self.malformed("at most 16 nested brackets"));
        }
        self.depth += 1;
        self.at += 1;
        let size = self.product(true)?;
        if self.peek() != Some(b')') {
            return Err(self.malformed("`)`"));
        }
        self.at += 1;
        self.depth -= 1;
        Ok(size)
    }

    /// `^2`, `^-1`; `None` if there is no `^`.
    fn exponent(&mut self) -> Result<Option<i32>, UnitError> {
        if self.peek() != Some(b'^') {
            return Ok(None);
        }
        self.at += 1;
        let start = self.at;
        if self.peek() == Some(b'-') {
            self.at += 1;
        }
        while self.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        let digits = &self.text[start..self.at];
        let ends = !self
            .peek()
            .is_some_and(|byte| byte == b'.' || byte == b'_' || byte.is_ascii_alphanumeric());
        match digits.parse() {
            Ok(exponent) if ends => Ok(Some(exponent)),
            Err(_) if digits.len() > 9 => Err(self.out_of_range()),
            _ => Err(self.malformed("a whole exponent (and `sqrt(..)` for halves)")),
        }
    }

    fn name(&mut self) -> &'a str {
        let rest = &self.text[self.at..];
        let starts = rest.starts_with(|c: char| c == '_' || c.is_ascii_alphabetic());
        let other = |c: char| c != '_' && !c.is_ascii_alphanumeric();
        let length = if starts {
            rest.find(other).unwrap_or(rest.len())
        } else {
            0
        };
        self.at += length;
        &rest[..length]
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Whether the name just read is called, indexed or dotted, as no unit is.
    fn goes_on_as_quantity(&self) -> bool {
        matches!(self.peek(), Some(b'(' | b'[' | b'.'))
    }

    fn times(&self, left: Size, right: Size) -> Result<Size, UnitError> {
        let dimension = left
            .dimension
            .checked_mul(right.dimension)
            .ok_or_else(|| self.out_of_range())?;
        Ok(Size {
            dimension,
            scale: left.scale.mul(right.scale),
        })
    }

    fn over(&self, left: Size, right: Size) -> Result<Size, UnitError> {
        let dimension = left
            .dimension
            .checked_div(right.dimension)
            .ok_or_else(|| self.out_of_range())?;
        Ok(Size {
            dimension,
            scale: left.scale.div(right.scale),
        })
    }

    fn unit(&self, size: Size) -> Result<Unit, UnitError> {
        let Size {
            dimension,
            scale: Double { high, low },
        } = size;
        // Near the ends of the range of f64 the second half of a `Double` underflows or becomes NaN.
        if !(1e-250..=1e250).contains(&high) {
            return Err(self.out_of_range());
        }
        Ok(Unit {
            dimension,
            scale: high,
            text: self.text[self.start..self.at].to_owned(),
            low,
        })
    }

    fn malformed(&self, expected: &'static str) -> UnitError {
        let next = self.text[self.at..].chars().next();
        let found = next.map_or_else(|| "the end".to_owned(), |c| format!("`{c}`"));
        let range = self.at..self.at + next.map_or(0, char::len_utf8);
        UnitError {
            range,
            fault: UnitFault::Malformed { expected, found },
        }
    }

    fn out_of_range(&self) -> UnitError {
        UnitError {
            range: self.start..self.at,
            fault: UnitFault::Range,
        }
    }
}
