//! What is flown and not known to the controller: dispersions, actuators, sensors, further states.

use super::{Explanation, edit, plain};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0611,
        plain(
            "A parameter has one distribution: its own `dispersion`, or its place in one group of `correlations`.",
            &[
                edit(
                    "plant:\n",
                    "parameters: {drag: {value: 1, dispersion: {uniform: [0.9, 1.1]}}, mass: 2 kg}\ncorrelations: [{parameters: [drag, mass], covariance: [[0.01, 0], [0, 0.04 kg^2]]}]\nplant:\n",
                    "parameters: {drag: 1, mass: 2 kg}\ncorrelations: [{parameters: [drag, mass], covariance: [[0.01, 0], [0, 0.04 kg^2]]}]\nplant:\n",
                ),
                edit("\"-v/(1 s)\"", "\"-drag*v/(1 s)\"", "\"-drag*v/(1 s)\""),
                edit("\"1/(2 kg)\"", "1/mass", "1/mass"),
            ],
        ),
    ),
    (
        Rule::E0612,
        plain(
            "A covariance matrix is symmetric, for the covariance of two parameters stands in it twice, and positive semidefinite: no combination of the parameters has a negative variance. Variances stand on the diagonal; a covariance beside it is at most the product of the two standard deviations, their roots.",
            &[
                edit(
                    "plant:\n",
                    "parameters: {drag: 1, mass: 2 kg}\ncorrelations: [{parameters: [drag, mass], covariance: [[0.01, 0.03 kg], [0.03 kg, 0.04 kg^2]]}]\nplant:\n",
                    "parameters: {drag: 1, mass: 2 kg}\ncorrelations: [{parameters: [drag, mass], covariance: [[0.01, 0.01 kg], [0.01 kg, 0.04 kg^2]]}]\nplant:\n",
                ),
                edit("\"-v/(1 s)\"", "\"-drag*v/(1 s)\"", "\"-drag*v/(1 s)\""),
                edit("\"1/(2 kg)\"", "1/mass", "1/mass"),
            ],
        ),
    ),
    (
        Rule::E0613,
        plain(
            "A delay holds back the commands of whole plant steps, whose length is the sample time divided by `substeps`. A delay between two steps would have to be rounded, and you would not know how.",
            &[edit(
                "safe: 0 N}",
                "safe: 0 N, actuator: {delay: 0.7 ms}}",
                "safe: 0 N, actuator: {delay: 1 ms}}",
            )],
        ),
    ),
    (
        Rule::E0710,
        plain(
            "The controller is designed on the blocks. Further states and the inputs belong to the flown plant, `truth`, and may stand in its rates only; a design that used them would know what it cannot measure.",
            &[
                edit(
                    "\"-v/(1 s)\"",
                    "\"-v/(1 s) - wear*v/(1 s)\"",
                    "\"-v/(1 s)\"",
                ),
                edit(
                    "reference:",
                    "  truth:\n    states: {wear: 0}\n    rates: {wear: v/(1 km)}\nreference:",
                    "  truth:\n    states: {wear: 0}\n    rates: {wear: v/(1 km), v: -v/(1 s) - wear*v/(1 s) + force/(2 kg)}\nreference:",
                ),
            ],
        ),
    ),
    (
        Rule::E0711,
        plain(
            "Rates of the flown plant belong to its further states and to the states of the blocks.",
            &[edit(
                "reference:",
                "  truth:\n    states: {wear: 0}\n    rates: {wear: v/(1 km), heat: 1 K/s}\nreference:",
                "  truth:\n    states: {wear: 0, heat: 20 K}\n    rates: {wear: v/(1 km), heat: 1 K/s}\nreference:",
            )],
        ),
    ),
    (
        Rule::E0712,
        plain(
            "A further state of the flown plant needs a rate: nothing else says how it moves. States of the blocks need none, for they move as their block says.",
            &[edit(
                "reference:",
                "  truth:\n    states: {wear: 0, heat: 20 K}\n    rates: {wear: v/(1 km)}\nreference:",
                "  truth:\n    states: {wear: 0, heat: 20 K}\n    rates: {wear: v/(1 km), heat: 1 K/s}\nreference:",
            )],
        ),
    ),
    (
        Rule::E0713,
        plain(
            "The controller measures the states of the blocks and nothing else, so a further state of the flown plant has no sensor.",
            &[edit(
                "reference:",
                "  truth:\n    states: {wear: {initial: 0, sensor: {noise: 0.1}}}\n    rates: {wear: v/(1 km)}\nreference:",
                "  truth:\n    states: {wear: 0}\n    rates: {wear: v/(1 km)}\nreference:",
            )],
        ),
    ),
];
