//! Physical dimensions: exponents of the SI base units, with arithmetic that refuses to overflow.

use std::fmt;

/// Physical dimension as exponents of the SI base units, in halves (a noise density in m/sqrt(s) has time exponent -1).
/// Angles are dimensionless: rad = 1, deg = pi/180.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension {
    /// Twice the exponent of kg, m, s, A, K, mol, cd.
    pub halves: [i8; 7],
}

/// Largest whole exponent: half of the largest number of halves.
pub(crate) const LARGEST: i16 = 63;

const SYMBOLS: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

impl Dimension {
    /// A pure number.
    pub const ONE: Self = Self { halves: [0; 7] };

    /// The dimension of a literal 0, which is zero metres as well as zero seconds: it agrees with every dimension, and
    /// products with it keep it. The arithmetic never reaches an exponent of `i8::MIN` otherwise.
    pub const ANY: Self = Self {
        halves: [i8::MIN; 7],
    };

    /// Dimension with whole exponents of kg, m, s and A.
    pub const fn new(mass: i8, length: i8, time: i8, current: i8) -> Self {
        Self {
            halves: [2 * mass, 2 * length, 2 * time, 2 * current, 0, 0, 0],
        }
    }

    /// The base unit of that index in the order of [`Dimension::halves`].
    pub(super) const fn base(index: usize) -> Self {
        let mut halves = [0; 7];
        halves[index] = 2;
        Self { halves }
    }

    /// Whether a quantity of this dimension can be used as a pure number.
    pub fn is_dimensionless(self) -> bool {
        self == Self::ONE || self == Self::ANY
    }

    /// What a quantity of it is, in words: `in m/s`, or `a pure number`.
    pub fn in_words(self) -> String {
        match self.is_dimensionless() {
            true => "a pure number".to_owned(),
            false => format!("in {self}"),
        }
    }

    /// The dimension to declare a quantity with: a literal 0 without a unit declares a pure number.
    pub fn or_one(self) -> Self {
        if self == Self::ANY { Self::ONE } else { self }
    }

    /// The dimension of a sum of both, `None` if they cannot be added.
    pub fn agree(self, other: Self) -> Option<Self> {
        if self == Self::ANY {
            Some(other)
        } else {
            (self == other || other == Self::ANY).then_some(self)
        }
    }

    /// Dimension of a product; `None` if an exponent leaves the range of -63 to 63.
    pub fn checked_mul(self, other: Self) -> Option<Self> {
        self.combine(other, i8::checked_add)
    }

    /// Dimension of a quotient; `None` if an exponent leaves the range of -63 to 63.
    pub fn checked_div(self, other: Self) -> Option<Self> {
        self.combine(other, i8::checked_sub)
    }

    /// Dimension of an integer power; `None` if an exponent leaves the range of -63 to 63.
    pub fn checked_powi(self, exponent: i32) -> Option<Self> {
        if self == Self::ANY {
            return Some(self);
        }
        let mut halves = self.halves;
        for half in &mut halves {
            let product = i64::from(*half) * i64::from(exponent);
            *half = i8::try_from(product).ok().filter(|&half| half != i8::MIN)?;
        }
        Some(Self { halves })
    }

    /// Dimension of a square root; `None` if an exponent would be a quarter.
    pub fn checked_sqrt(self) -> Option<Self> {
        if self == Self::ANY {
            return Some(self);
        }
        let even = self.halves.iter().all(|half| half % 2 == 0);
        even.then(|| Self {
            halves: self.halves.map(|half| half / 2),
        })
    }

    fn combine(self, other: Self, rule: fn(i8, i8) -> Option<i8>) -> Option<Self> {
        if self == Self::ANY || other == Self::ANY {
            return Some(Self::ANY);
        }
        let mut halves = self.halves;
        for (half, &right) in halves.iter_mut().zip(&other.halves) {
            *half = rule(*half, right).filter(|&half| half != i8::MIN)?;
        }
        Some(Self { halves })
    }
}

impl fmt::Display for Dimension {
    /// As a unit expression that [`super::parse_unit`] reads back: `kg*m^2/s^2`, `1/s`, `m/sqrt(s)`, `1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::ANY {
            return f.write_str("any");
        }
        let factors = |sign: i16| -> Vec<String> {
            let exponents = self.halves.iter().map(|&half| i16::from(half) * sign);
            let present = SYMBOLS
                .iter()
                .zip(exponents)
                .filter(|(_, halves)| *halves > 0);
            present
                .flat_map(|(symbol, halves)| power(symbol, halves))
                .collect()
        };
        let (above, below) = (factors(1), factors(-1));
        f.write_str(if above.is_empty() { "1" } else { "" })?;
        f.write_str(&above.join("*"))?;
        match below.as_slice() {
            [] => Ok(()),
            [only] => write!(f, "/{only}"),
            several => write!(f, "/({})", several.join("*")),
        }
    }
}

/// The factors of a base unit to a positive power given in halves.
fn power(symbol: &str, halves: i16) -> Vec<String> {
    let whole = |exponent: i16| match exponent {
        1 => symbol.to_owned(),
        _ => format!("{symbol}^{exponent}"),
    };
    match halves {
        even if even % 2 == 0 => vec![whole(even / 2)],
        // The power under the root has to be a dimension, too.
        large if large > LARGEST => vec![whole(large / 2), format!("sqrt({symbol})")],
        odd => vec![format!("sqrt({})", whole(odd))],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const JOULE: Dimension = Dimension::new(1, 2, -2, 0);

    #[test]
    fn dimensions_print_as_unit_expressions() {
        let root_time = Dimension::new(0, 0, 1, 0).checked_sqrt().unwrap();
        let density = Dimension::new(0, 1, 0, 0).checked_div(root_time).unwrap();
        let cubed = density.checked_powi(3).unwrap();
        let printed = [
            Dimension::ONE,
            JOULE,
            Dimension::new(1, -1, -2, 0),
            Dimension::new(0, 0, -1, 0),
            density,
            cubed,
        ];
        assert_eq!(
            printed.map(|dimension| dimension.to_string()),
            [
                "1",
                "kg*m^2/s^2",
                "kg/(m*s^2)",
                "1/s",
                "m/sqrt(s)",
                "m^3/sqrt(s^3)"
            ]
        );
        let root = Dimension::new(0, 3, -3, 0).checked_sqrt().unwrap();
        let large = root.checked_powi(33).unwrap();
        assert_eq!(large.to_string(), "m^49*sqrt(m)/(s^49*sqrt(s))");
    }

    #[test]
    fn arithmetic_refuses_to_overflow() {
        let large = Dimension::new(0, 60, 0, 0);
        assert_eq!(large.checked_mul(large), None);
        assert_eq!(Dimension::new(0, -60, 0, 0).checked_div(large), None);
        assert_eq!(JOULE.checked_powi(i32::MIN), None);
        assert_eq!(JOULE.checked_powi(-2), Some(Dimension::new(-2, -4, 4, 0)));
        assert_eq!(
            Dimension {
                halves: [1, 0, 0, 0, 0, 0, 0]
            }
            .checked_sqrt(),
            None
        );
        let lowest = Dimension {
            halves: [-127, 0, 0, 0, 0, 0, 0],
        };
        assert_eq!(
            lowest.checked_mul(Dimension {
                halves: [-1, 0, 0, 0, 0, 0, 0]
            }),
            None
        );
    }

    #[test]
    fn zero_agrees_with_every_dimension_and_survives_products() {
        assert_eq!(Dimension::ANY.agree(JOULE), Some(JOULE));
        assert_eq!(JOULE.agree(Dimension::ANY), Some(JOULE));
        assert_eq!(JOULE.agree(Dimension::ONE), None);
        assert_eq!(Dimension::ANY.checked_mul(JOULE), Some(Dimension::ANY));
        assert_eq!(Dimension::ANY.or_one(), Dimension::ONE);
    }
}
