//! Keys and kinds of values.

use super::{Explanation, edit, plain, undo};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0101,
        plain(
            "A key that nothing reads is most often a misspelt one whose default was then used in silence. So every key must be known. If it is meant for one that is missing, the two are reported as one fault.",
            &[undo("substeps", "substep")],
        ),
    ),
    (
        Rule::E0102,
        plain(
            "YAML readers disagree about which of two equal keys wins. Here neither does.",
            &[undo("{K: 1,", "{K: 1, K: 2,")],
        ),
    ),
    (
        Rule::E0103,
        plain(
            "Every key expects one kind of value: a word of a list, a whole number, an expression, a list or a map.",
            &[undo("scheme: rk4", "scheme: rk45")],
        ),
    ),
    (
        Rule::E0104,
        plain(
            "Some keys have no default, because no value of theirs fits every plant.",
            &[undo("{K: 1, kbar", "{kbar")],
        ),
    ),
    (
        Rule::E0105,
        plain(
            "`nsv:` gives the version of the language in which the specification is written, so that a later compiler can go on reading it as it was meant. This compiler knows version 1.",
            &[undo("nsv: 1", "nsv: 2")],
        ),
    ),
    (
        Rule::E0106,
        plain(
            "A disturbance is either a bounded function of time or the output of an exosystem, and a dispersion is either uniform or normal: exactly one of the two keys is given.",
            &[undo(
                "      gain: \"1/(2 kg)\"\n",
                "      gain: \"1/(2 kg)\"\n      disturbance: {}\n",
            )],
        ),
    ),
    (
        Rule::E0107,
        plain(
            "A term of polynomial data is its coefficient, then the exponent of each argument. Exponents are whole numbers from 0 to 32, so that the polynomial and its derivatives are products and sums.",
            &[
                edit(
                    "plant:\n",
                    "polynomials:\n  C: {arguments: [a], parts: {drag: [[0.5, -1]]}}\nplant:\n",
                    "polynomials:\n  C: {arguments: [a], parts: {drag: [[0.5, 1]]}}\nplant:\n",
                ),
                edit(
                    "\"-v/(1 s)\"",
                    "\"-C.drag(v/(1 m/s))*(1 m/s^2)\"",
                    "\"-C.drag(v/(1 m/s))*(1 m/s^2)\"",
                ),
            ],
        ),
    ),
];
