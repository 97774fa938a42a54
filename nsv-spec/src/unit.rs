//! Units and physical dimensions.

/// Physical dimension as exponents of the SI base units, in halves (a noise density in m/sqrt(s) has time exponent -1).
/// Angles are dimensionless: rad = 1, deg = pi/180.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension {
    /// Twice the exponent of kg, m, s, A, K, mol, cd.
    pub halves: [i8; 7],
}
