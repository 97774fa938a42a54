//! Units and shapes.

use super::{Explanation, edit, plain, undo};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0401,
        plain(
            "Units are the symbols of SI with their prefixes, and a few others such as `deg`, `ft` and `kn`. Capital letters matter: `mW` and `MW` are a factor of a billion apart.",
            &[undo("limit: 5 N", "limit: 5 KN")],
        ),
    ),
    (
        Rule::E0402,
        plain(
            "A unit is a product of symbols, without blanks: `kg*m/s^2`. Exponents are whole; halves are written with `sqrt`, as in `m/sqrt(s)`.",
            &[edit(
                "states: {v: 0 m/s}",
                "states: {v: {initial: 0, unit: m s}}",
                "states: {v: {initial: 0, unit: m/s}}",
            )],
        ),
    ),
    (
        Rule::E0403,
        plain(
            "What is added, subtracted or compared must have one unit: a speed plus a time is no quantity. The labels say what each side is, and where the names in it are declared; follow them to the one that is not what you thought.",
            &[
                edit(
                    "plant:\n",
                    "constants: {mass: 2 kg, push: 4 N}\nplant:\n",
                    "constants: {mass: 2 kg, push: 4 N}\nplant:\n",
                ),
                edit("\"-v/(1 s)\"", "push - v/(1 s)", "push/mass - v/(1 s)"),
            ],
        ),
    ),
    (
        Rule::E0404,
        plain(
            "`sin`, `exp` and the other functions of pure numbers, exponents, and the arguments of polynomial data have no unit: the sine of a length depends on whether you measure in metres or feet. Divide by a quantity of the same unit that means something in your plant. The arguments of a lookup table have the units of its axes; what has another unit is divided or multiplied by a quantity, or the axis is given its unit.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-sin(v)*(1 m/s^2)\"",
                "\"-sin(v/(2 m/s))*(1 m/s^2)\"",
            )],
        ),
    ),
    (
        Rule::E0405,
        plain(
            "The unit of `x^p` depends on the value of `p`, so `p` must be a whole number written out, unless `x` is a pure number.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-v^1.5*(1 1/s)\"",
                "\"-(v/(1 m/s))^1.5*(1 m/s^2)\"",
            )],
        ),
    ),
    (
        Rule::E0406,
        plain(
            "Exponents of units go in halves from -63 to 63. A root of a root, or a power beyond that, has no unit here.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-sqrt(sqrt(v))*(1 m/s^2)\"",
                "\"-sqrt(sqrt(v/(1 m/s)))*(1 m/s^2)\"",
            )],
        ),
    ),
    (
        Rule::E0407,
        plain(
            "The theory fixes the unit of every part of the model: a drift is a state per second, a gain turns the next state or input into that, a reference is in the unit of its output. The labels show which state asks for the unit, and where the names in your formula get theirs.",
            &[undo("\"-v/(1 s)\"", "\"-v\"")],
        ),
    ),
    (
        Rule::E0408,
        plain(
            "A literal 0 fits every unit, so that `max(x, 0)` can be written. As a divisor it is always wrong.",
            &[undo("v: 1 m/s", "v: 1 m/s/0")],
        ),
    ),
    (
        Rule::E0501,
        plain(
            "Operators work entry by entry on arrays of one shape, or on an array and a scalar; `*` with a matrix is the matrix product. Functions of scalars take one entry.",
            &[edit(
                "v: 1 m/s",
                "v: \"([1, 2] + [1, 2, 3])[1]*(1 m/s)\"",
                "v: \"([1, 2] + [1, 2])[1]*(1 m/s)\"",
            )],
        ),
    ),
    (
        Rule::E0502,
        plain(
            "Comparisons give truth values, which are no numbers. `if(condition, a, b)` chooses between two numbers.",
            &[edit(
                "v: 1 m/s",
                "v: (t > 1 s)*(1 m/s)",
                "v: \"if(t > 1 s, 1 m/s, 0 m/s)\"",
            )],
        ),
    ),
    (
        Rule::E0503,
        plain(
            "All blocks of a plant have the same number of states, and the plant has as many inputs, for the controller solves each block's `gain` (G in the theory) for the states of the next block or for the inputs: it is square. A disturbance of exosystems has one for each state. An index lies within its array.",
            &[undo(
                "    force: {limit: 5 N, safe: 0 N}\n",
                "    force: {limit: 5 N, safe: 0 N}\n    brake: {limit: 5 N, safe: 0 N}\n",
            )],
        ),
    ),
    (
        Rule::E0504,
        plain(
            "A drift has one entry for each state of its block, a gain as many rows and columns.",
            &[undo("\"-v/(1 s)\"", "[\"-v/(1 s)\", 0]")],
        ),
    ),
    (
        Rule::E0505,
        plain(
            "An array holds scalars, or rows of one length.",
            &[edit(
                "v: 1 m/s",
                "v: \"[[1, 2], [3]][1, 1]*(1 m/s)\"",
                "v: \"[[1, 2], [3, 4]][1, 1]*(1 m/s)\"",
            )],
        ),
    ),
    (
        Rule::W0010,
        plain(
            "Angles are in radians inside nsv, and an angle in degrees is written with its unit. `alpha/(1 deg)` is the number of degrees, right where a polynomial was fitted to it; the sine of that number, or of 45, is another sine than was meant.",
            &[edit("-v/(1 s)", "-sin(45)*v/(1 s)", "-sin(45 deg)*v/(1 s)")],
        ),
    ),
    (
        Rule::W0011,
        plain(
            "A number without a unit is in radians where an angle is expected. Where the state itself is declared in degrees, that is seldom meant.",
            &[
                edit("v: 0 m/s", "v: 0 deg", "v: 0 deg"),
                edit("1/(2 kg)", "1/(2 N*s)", "1/(2 N*s)"),
                edit("v: 1 m/s", "v: 4", "v: 4 deg"),
            ],
        ),
    ),
    (
        Rule::W0012,
        plain(
            "`+`, `-`, `/` work entry by entry, so that `1/M` is not the inverse of a matrix but its reciprocals. `inverse(M)` is the inverse, and `solve(M, b)` is `inverse(M)*b`.",
            &[edit(
                "-v/(1 s)",
                "-(1/[[2, 1], [1, 2]])[1, 1]*v/(1 s)",
                "-inverse([[2, 1], [1, 2]])[1, 1]*v/(1 s)",
            )],
        ),
    ),
];
