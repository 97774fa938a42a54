//! Names, and what belongs together by name.

use super::{Explanation, edit, plain, undo};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0110,
        plain(
            "Names are written into the generated code, so they are identifiers: a letter, then letters, digits and `_`. The name of the specification becomes a Rust module and has no capital letters.",
            &[undo("name: cart", "name: Cart")],
        ),
    ),
    (
        Rule::E0111,
        plain(
            "A word of Rust cannot name anything in generated code, and a name such as `pi`, `sin` or `t` would hide that of the expression language. A constant that the language has is left out, or gets a name of its own if it has another value.",
            &[
                edit(
                    "plant:\n",
                    "constants: {pi: 3}\nplant:\n",
                    "constants: {rough_pi: 3}\nplant:\n",
                ),
                edit("v: 1 m/s", "v: pi*(1 m/s)", "v: rough_pi*(1 m/s)"),
            ],
        ),
    ),
    (
        Rule::E0112,
        plain(
            "The generated controller has quantities named as in the theory: `x1`, `e2`, `W1`, `u`. A state, parameter or definition of such a name would be taken for one of them by every reader.",
            &[
                edit(
                    "plant:\n",
                    "definitions: {x1: v}\nplant:\n",
                    "definitions: {speed: v}\nplant:\n",
                ),
                edit("\"-v/(1 s)\"", "\"-x1/(1 s)\"", "\"-speed/(1 s)\""),
            ],
        ),
    ),
    (
        Rule::E0113,
        plain(
            "Constants, parameters, states and definitions share one space of names, for an expression does not say which kind it means. An argument of a function has a name that nothing else has, too: it would hide the other within the function. Whoever renames it does so under `arguments` and in `value`; in `value` alone or in `arguments` alone, the function would use the other quantity and leave its argument unused (`W0003`).",
            &[
                edit(
                    "plant:\n",
                    "constants: {v: 3 m/s}\nplant:\n",
                    "constants: {v_max: 3 m/s}\nplant:\n",
                ),
                edit("v: 1 m/s", "v: 1 m/s", "v: v_max/3"),
            ],
        ),
    ),
    (
        Rule::E0114,
        plain(
            "Plant and controller are joined by the names of their blocks. Every block of the plant has its gains, and there are no gains without a block.",
            &[undo("    motion: {K", "    moton: {K")],
        ),
    ),
    (
        Rule::E0115,
        plain(
            "The states of the first block are the outputs that follow the reference: one signal for each of them, and none for any other.",
            &[undo("reference: {v:", "reference: {speed:")],
        ),
    ),
    (
        Rule::E0116,
        plain(
            "`controller.parameters` gives the values with which the controller is designed, where they differ from those of the plant. There must be a parameter of that name under `parameters`.",
            &[
                edit(
                    "plant:\n",
                    "parameters: {mass: 2 kg}\nplant:\n",
                    "parameters: {mass: 2 kg}\nplant:\n",
                ),
                edit("\"1/(2 kg)\"", "1/mass", "1/mass"),
                edit(
                    "  sample_time",
                    "  parameters: {masss: 2.5 kg}\n  sample_time",
                    "  parameters: {mass: 2.5 kg}\n  sample_time",
                ),
            ],
        ),
    ),
    (
        Rule::E0117,
        plain(
            "A declaration is a name for a formula, and formulas cannot contain themselves. Feedback is written through states, which have a past.",
            &[
                edit(
                    "plant:\n",
                    "definitions:\n  a: b/2\n  b: 2*a\nplant:\n",
                    "definitions:\n  a: b/2\n  b: 2*v\nplant:\n",
                ),
                edit("\"-v/(1 s)\"", "\"-a/(1 s)\"", "\"-a/(1 s)\""),
            ],
        ),
    ),
    (
        Rule::E0118,
        plain(
            "A feature of a block needs its gains: a disturbance needs an observer and `eta_1`, noise needs a `noise_bound`, a network without observer an `error_bound`, and every block but the last its `filter`, `eta_2` and `eta_3`.",
            &[
                edit(
                    "      gain: \"1/(2 kg)\"\n",
                    "      gain: \"1/(2 kg)\"\n      disturbance: {bounded: 0.1 m/s^2}\n",
                    "      gain: \"1/(2 kg)\"\n      disturbance: {bounded: 0.1 m/s^2}\n",
                ),
                edit(
                    "C: 20}",
                    "C: 20, observer: 5}",
                    "C: 20, observer: 5, eta_1: 1}",
                ),
            ],
        ),
    ),
    (
        Rule::E0119,
        plain(
            "A gain that no term of the control law reads would be tuned in vain. Take it out, or add the feature that it belongs to.",
            &[undo("C: 20}", "C: 20, eta_1: 1}")],
        ),
    ),
    (
        Rule::E0301,
        plain(
            "Every name in an expression is declared under `constants`, `parameters`, `definitions` or as a state, or belongs to the language: `t`, `pi` and the functions.",
            &[
                edit(
                    "plant:\n",
                    "constants: {length: 2 m}\nplant:\n",
                    "constants: {length: 2 m}\nplant:\n",
                ),
                edit("v: 1 m/s", "v: lenght/(2 s)", "v: length/(2 s)"),
            ],
        ),
    ),
    (
        Rule::E0302,
        plain(
            "A name in front of a bracket is a function of the language or polynomial data.",
            &[undo("v: 1 m/s", "v: 1 m/s*arctan(1)")],
        ),
    ),
    (
        Rule::E0303,
        plain(
            "Gains, limits, sample time and the like are numbers when the code is generated. They may use constants, but not states, parameters or time, which change while the controller runs. No expression of a plant uses an input by its name: inputs act through the gain of the last block, and only rates of `truth` may name them.",
            &[undo("C: 20}", "C: 20*v}")],
        ),
    ),
    (
        Rule::E0304,
        plain(
            "Values are used as they are, functions and polynomial data with arguments in brackets.",
            &[undo("v: 1 m/s", "v: 1 m/s*sin")],
        ),
    ),
    (
        Rule::E0305,
        plain(
            "Every function has a fixed number of arguments. `min` and `max` take two; nest them for more.",
            &[undo("v: 1 m/s", "v: max(1 m/s)")],
        ),
    ),
    (
        Rule::E0306,
        plain(
            "`partial(polynomial, argument, values..)` differentiates polynomial data by one of its arguments, which is given by the name that the data declare.",
            &[
                edit(
                    "plant:\n",
                    "polynomials:\n  C: {arguments: [speed], parts: {drag: [[0.5, 2]]}}\nplant:\n",
                    "polynomials:\n  C: {arguments: [speed], parts: {drag: [[0.5, 2]]}}\nplant:\n",
                ),
                edit(
                    "\"-v/(1 s)\"",
                    "\"-partial(C.drag, v, v/(1 m/s))*(1 m/s^2)\"",
                    "\"-partial(C.drag, speed, v/(1 m/s))*(1 m/s^2)\"",
                ),
            ],
        ),
    ),
];
