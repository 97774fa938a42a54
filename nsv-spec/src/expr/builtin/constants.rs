//! Constants that every specification knows.

use crate::unit::{Dimension, parse_unit};

/// A constant of the language.
#[derive(Debug)]
pub(crate) struct StandardConstant {
    /// Its name.
    pub(crate) name: &'static str,
    /// SI value.
    pub(crate) value: f64,
    /// Its unit; empty for a pure number.
    pub(crate) unit: &'static str,
    /// What it is, and where its value comes from.
    pub(crate) meaning: &'static str,
}

impl StandardConstant {
    /// Its dimension.
    pub(crate) fn dimension(&self) -> Dimension {
        match self.unit {
            "" => Dimension::ONE,
            unit => {
                parse_unit(unit)
                    .expect("invariant: units of constants are units")
                    .dimension
            }
        }
    }
}

/// Every constant.
pub(crate) const CONSTANTS: &[StandardConstant] = &[
    StandardConstant {
        name: "pi",
        value: std::f64::consts::PI,
        unit: "",
        meaning: "circumference of a circle over its diameter",
    },
    StandardConstant {
        name: "g0",
        value: 9.80665,
        unit: "m/s^2",
        meaning: "standard acceleration of free fall, exact (3rd CGPM 1901; ISO 80000-3)",
    },
    StandardConstant {
        name: "earth.mu",
        value: 3.986_004_418e14,
        unit: "m^3/s^2",
        meaning: "gravitational constant times mass of the Earth with its atmosphere (WGS 84)",
    },
    StandardConstant {
        name: "earth.radius",
        value: 6_378_137.0,
        unit: "m",
        meaning: "equatorial radius of the Earth's ellipsoid, exact (WGS 84)",
    },
    StandardConstant {
        name: "earth.rate",
        value: 7.292_115e-5,
        unit: "rad/s",
        meaning: "angular velocity of the Earth (WGS 84)",
    },
];
