//! The page on units, its lists written from the table that the compiler uses.

use std::fmt::Write;

use super::table;

const RULES: &str = "\
# Units

Every number in a specification is turned into SI when it is read, and everything behind the reader is in SI. This page is written by
`NSV_UPDATE_DOCS=1 cargo test -p nsv-spec --test units` from the table that the compiler uses; the same test reads every example.

## Writing a unit

A unit follows a number, after one blank or none: `9.81 m/s^2`, `5 deg`, `0.05 rad/sqrt(s)`. Units are joined by `*` and `/` from left to
right, take whole exponents (`s^-1`) and roots (`sqrt(Hz)`), and have no blanks inside. `1/s` is a unit too. In `2 m*g` the `g` is the gram;
with blanks around the operator, `2 m * g`, it is a name. After an operator `t` is the time, not the tonne.

Dimensions have exponents in steps of a half from -63 to 63, and their arithmetic is exact: what noise needs, `m/sqrt(s)` and
`m/s^2/sqrt(Hz)`, is there, and a quarter (`sqrt(sqrt(m))`) or a third is refused (`E0406`, `E0402`).

A conversion is done in about 106 bits and rounded once: `2.54 cm` is the number that `0.0254 m` is. `tests/reference/units.py` has 3000 random
units and quantities converted by pint with exact fractions; nsv gives the nearest number for every one (`cargo test -p nsv-spec --test pint`).

Temperatures are differences: there are kelvins but no degrees Celsius, which would need an offset.

## Numbers without a unit

- In an expression a number without a unit is a pure number. It does not fit a length; a literal `0` fits every unit.
- A *quantity* must have its unit: `sample_time`, `horizon`, `settle`, delays and times of faults. `sample_time: 2` is an error (`E0604`).
- A *gain* may have its unit, or be a bare number in SI: `K: 1.5` is `K: 1.5 1/s`. A gain in another unit is an error (`E0604`).
- The initial value of a state declares its unit: `states: {x: 0 m}`. A bare number declares a pure number, which an angle in radians is.
- A data table (`polynomials`, `tables`) holds plain numbers; `unit` beside them says what they count.

| where | unit |
|---|---|
| `drift`, `disturbance: {bounded: ..}` | that of the state, per second |
| `gain` | that of the state per second, per unit of the next state or input |
| `noise.effectiveness` times `noise.intensity` | with `noise: wiener` that of the state per `sqrt(s)`: a Wiener process has unit `sqrt(s)`; with `noise: sampled` that of the state per second |
| `M`, `N`, `L`, `initial` of an exosystem, its observer | bare numbers in SI |
| `K`, `kbar`, `C`, observer of a bounded disturbance, `error_bound.iota`, `phi.kappa` | `1/s` or bare |
| `filter` | `s` or bare |
| `eta_1` to `eta_3`, `eta_noise`, `network.iota`, `Gamma`, `lambda`, `tau`, `varsigma`, `phi.initial`, `phi.min` | bare |
| `constraint` | that of the states of the block; where they differ, a pure number that bounds their SI values |
| `error_bound.b`, `phi.threshold` | the same, or bare |
| `network.scale` | that of the input that it divides, or bare |
| `limit`, `safe` | `limit` declares the unit of the input |

## Angles

A radian is 1 and a degree is pi/180, as in SI: an angle is a pure number, and `sin` of a length is an error (`E0404`). Dimensions cannot tell
radians from degrees, so two warnings look for the slips that people make:

- `W0010`: `sin(alpha/(1 deg))`, also through a definition, and `sin(45)`. `alpha/(1 deg)` alone is right where a polynomial was fitted in degrees.
- `W0011`: a bare number as reference or constraint of a state whose initial value is written in degrees.
";

/// The page in Markdown.
pub fn units_reference() -> String {
    let mut page = RULES.to_owned();
    page.push_str("\n## Units\n\nThose marked + take prefixes.\n\n| unit | + | SI value of one | dimension |\n|---|---|---|---|\n");
    for (name, prefixed, dimension, size) in table::units() {
        let mark = if prefixed { "+" } else { "" };
        let size = if (1e-3..1e9).contains(&size) {
            format!("{size}")
        } else {
            format!("{size:e}")
        };
        _ = writeln!(page, "| `{name}` | {mark} | {size} | `{dimension}` |");
    }
    page.push_str("\n## Prefixes\n\nA unit's own name comes first: `min` is the minute, `Pa` the pascal, `cd` the candela.\n\n| prefix | power of ten |\n|---|---|\n");
    for (prefix, exponent) in table::prefixes() {
        _ = writeln!(page, "| `{prefix}` | {exponent} |");
    }
    page
}
