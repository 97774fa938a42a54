//! The U.S. Standard Atmosphere 1976 (NOAA-S/T 76-1562) from -5 km to 86 km, written in the language itself.
//!
//! Geopotential height by (18) with r_0 = 6356766 m, temperature by (23) and table 4, pressure by (33a) and (33b), density by (42), speed of
//! sound by (50), viscosity by (51), gravity by (17). Where the gradient of a layer is 0, T/T_b is 1 and its logarithm 0, so that one formula
//! of the pressure serves every layer: p = p_b exp(-g0 M/R (ln(T/T_b)/L + (H - H_b)/T_b)) with the term that a layer does not have left out.

use super::{Builtin, Entry};

/// Its functions; what users call follows what it is made of.
pub(super) const ATMOSPHERE: &[Entry] = &[
    Entry {
        name: "atmosphere.geopotential",
        arguments: &["h"],
        meaning: "geopotential height of the geometric height `h`, which is held between -5 km and 86 km",
        rule: "a scalar in m",
        example: "atmosphere.geopotential(height)",
        builtin: Builtin::Defined {
            body: "(6356766 m)*clamp(h, -5 km, 86 km)/((6356766 m) + clamp(h, -5 km, 86 km))",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.layer",
        arguments: &["z", "a", "b", "c", "d", "e", "f", "g"],
        meaning: "the value of the layer in which the geopotential height `z` lies; layers begin at sea level and at 11, 20, 32, 47, 51 and 71 km",
        rule: "`z` in m, then seven values of one unit",
        example: "atmosphere.layer(height, 1, 2, 3, 4, 5, 6, 7)",
        builtin: Builtin::Defined {
            body: "if(z < 11 km, a, if(z < 20 km, b, if(z < 32 km, c, if(z < 47 km, d, if(z < 51 km, e, if(z < 71 km, f, g))))))",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.base_height",
        arguments: &["z"],
        meaning: "geopotential height at which the layer of `z` begins",
        rule: "a scalar in m",
        example: "atmosphere.base_height(height)",
        builtin: Builtin::Defined {
            body: "atmosphere.layer(z, 0 m, 11 km, 20 km, 32 km, 47 km, 51 km, 71 km)",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.base_temperature",
        arguments: &["z"],
        meaning: "temperature at which the layer of `z` begins",
        rule: "a scalar in m, the result in K",
        example: "atmosphere.base_temperature(height)",
        builtin: Builtin::Defined {
            body: "atmosphere.layer(z, 288.15 K, 216.65 K, 216.65 K, 228.65 K, 270.65 K, 270.65 K, 214.65 K)",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.base_pressure",
        arguments: &["z"],
        meaning: "pressure at which the layer of `z` begins",
        rule: "a scalar in m, the result in Pa",
        example: "atmosphere.base_pressure(height)",
        builtin: Builtin::Defined {
            body: "atmosphere.layer(z, 101325 Pa, 22632.06397346293 Pa, 5474.88866967778 Pa, 868.0186847552274 Pa, 110.90630555496588 Pa, 66.93887311868727 Pa, 3.9564204280407287 Pa)",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.gradient",
        arguments: &["z"],
        meaning: "change of temperature with height in the layer of `z`",
        rule: "a scalar in m, the result in K/m",
        example: "atmosphere.gradient(height)",
        builtin: Builtin::Defined {
            body: "atmosphere.layer(z, -6.5 K/km, 0 K/km, 1 K/km, 2.8 K/km, 0 K/km, -2.8 K/km, -2 K/km)",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.temperature",
        arguments: &["h"],
        meaning: "molecular-scale temperature at the geometric height `h`: the temperature of the air up to 80 km, at 86 km 0.04 % above it",
        rule: "a scalar in m, the result in K",
        example: "atmosphere.temperature(height)",
        builtin: Builtin::Defined {
            body: "atmosphere.base_temperature(atmosphere.geopotential(h)) + atmosphere.gradient(atmosphere.geopotential(h))*(atmosphere.geopotential(h) - atmosphere.base_height(atmosphere.geopotential(h)))",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.pressure",
        arguments: &["h"],
        meaning: "pressure at the geometric height `h`",
        rule: "a scalar in m, the result in Pa",
        example: "atmosphere.pressure(height)",
        builtin: Builtin::Defined {
            body: "atmosphere.base_pressure(atmosphere.geopotential(h))*exp(-g0*(28.9644 kg/kmol)/(8314.32 J/(kmol*K))*(atmosphere.layer(atmosphere.geopotential(h), 1/(-6.5 K/km), 0, 1/(1 K/km), 1/(2.8 K/km), 0, 1/(-2.8 K/km), 1/(-2 K/km))*ln(atmosphere.temperature(h)/atmosphere.base_temperature(atmosphere.geopotential(h))) + atmosphere.layer(atmosphere.geopotential(h), 0, 1/(216.65 K), 0, 0, 1/(270.65 K), 0, 0)*(atmosphere.geopotential(h) - atmosphere.base_height(atmosphere.geopotential(h)))))",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.density",
        arguments: &["h"],
        meaning: "density of the air at the geometric height `h`",
        rule: "a scalar in m, the result in kg/m^3",
        example: "0.5*atmosphere.density(height)*speed^2",
        builtin: Builtin::Defined {
            body: "atmosphere.pressure(h)*(28.9644 kg/kmol)/((8314.32 J/(kmol*K))*atmosphere.temperature(h))",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.speed_of_sound",
        arguments: &["h"],
        meaning: "speed of sound at the geometric height `h`",
        rule: "a scalar in m, the result in m/s",
        example: "speed/atmosphere.speed_of_sound(height)",
        builtin: Builtin::Defined {
            body: "sqrt(1.4*(8314.32 J/(kmol*K))*atmosphere.temperature(h)/(28.9644 kg/kmol))",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.viscosity",
        arguments: &["h"],
        meaning: "dynamic viscosity of the air at the geometric height `h`",
        rule: "a scalar in m, the result in Pa*s",
        example: "atmosphere.viscosity(height)",
        builtin: Builtin::Defined {
            body: "(1.458e-6 kg/(m*s*sqrt(K)))*atmosphere.temperature(h)*sqrt(atmosphere.temperature(h))/(atmosphere.temperature(h) + 110.4 K)",
            unit: Some("m"),
        },
    },
    Entry {
        name: "atmosphere.gravity",
        arguments: &["h"],
        meaning: "acceleration of free fall at the geometric height `h`",
        rule: "a scalar in m, the result in m/s^2",
        example: "atmosphere.gravity(height)",
        builtin: Builtin::Defined {
            body: "g0*((6356766 m)/((6356766 m) + h))^2",
            unit: Some("m"),
        },
    },
];
