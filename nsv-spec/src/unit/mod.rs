//! Units and physical dimensions.

mod dimension;
mod double;
mod error;
mod grammar;
mod reference;
mod table;

use crate::suggest::Meant;
pub use dimension::Dimension;
pub(crate) use dimension::LARGEST;
use double::Double;
pub use error::UnitError;
pub(crate) use error::UnitFault;
pub(crate) use grammar::{MAX_DEPTH, scan};
pub use reference::units_reference;

/// A unit as written, with the factor that turns a number in it into SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// Dimension.
    pub dimension: Dimension,
    /// SI value of one of it, correctly rounded.
    pub scale: f64,
    /// As written: `kN*m`.
    pub text: String,
    /// What rounding to `scale` left off.
    low: f64,
}

impl Unit {
    /// SI value of the decimal number `digits` (such as `2.54e-2`) in this unit, rounded once.
    /// `None` if it is no finite number.
    pub fn si(&self, digits: &str) -> Option<f64> {
        let scale = Double {
            high: self.scale,
            low: self.low,
        };
        let value = match decimal(digits) {
            Some(exact) => exact,
            None => Double {
                high: digits.parse().ok()?,
                low: 0.0,
            },
        };
        let product = value.mul(scale).high;
        // The residual of an overflowing or very small product is meaningless, the plain product is not.
        let product = if product.is_nan() {
            value.high * scale.high
        } else {
            product
        };
        product.is_finite().then_some(product)
    }

    /// Names of the simple units in [`Unit::text`], in order.
    pub(crate) fn symbols(&self) -> impl Iterator<Item = &str> {
        self.text
            .split(|c: char| !c.is_ascii_alphabetic())
            .filter(|name| !name.is_empty())
    }
}

/// The unit for which a name in place of one was meant, if there is little doubt: `s` for `sec`, `s^2` for `s2`.
pub(crate) fn meant(name: &str) -> Option<Meant> {
    let near = name.len() <= 16 && name.is_ascii();
    near.then(|| table::suggest(name))?
        .filter(|meant| meant.sure)
}

/// Reads a unit expression such as `kN*m`, `rad/s`, `1/s`, `kg/(m*s^2)` or `m/sqrt(s)`.
pub fn parse_unit(text: &str) -> Result<Unit, UnitError> {
    grammar::whole(text)
}

/// The value of up to 19 significant digits with a moderate exponent, exactly; `None` for other numbers.
fn decimal(text: &str) -> Option<Double> {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: u64 = format!("{whole}{fraction}").parse().ok()?;
    let exponent: i32 = exponent.parse().ok()?;
    let exponent = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    (-40..=40)
        .contains(&exponent)
        .then(|| Double::integer(digits).mul(Double::ten(exponent)))
}

#[cfg(test)]
mod tests;
