//! Functions of the specification, loops and lookup tables.

use super::{Explanation, edit, plain, undo, with_files};
use crate::diagnostic::Rule;

/// A damping that a table gives.
const TABLE: &str = "tables:\n  damping:\n    axes: {speed: {values: [0, 1, 2], unit: m/s}}\n    values: [1, 1.5, 3]\n    interpolation: linear\n    extrapolation: clamp\nplant:\n";

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0210,
        plain(
            "`each(i, from, to, body)` makes a vector of the body's values while the counter goes from the first number to the last. Both are whole numbers that are known when the specification is read, and the last is not less than the first.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-sum(each(i, 3, 1, i*v))/(6 s)\"",
                "\"-sum(each(i, 1, 3, i*v))/(6 s)\"",
            )],
        ),
    ),
    (
        Rule::E0211,
        plain(
            "Calls of functions and rounds of loops are written out where they stand. A few functions that call each other twice stand for millions of operations, so what they may add to a specification is limited.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-sum(each(i, 1, 64, sum(each(j, 1, 64, sum(each(k, 1, 64, v))))))/(1 s)\"",
                "\"-sum(each(i, 1, 64, v))/(1 s)\"",
            )],
        ),
    ),
    (
        Rule::E0307,
        plain(
            "A counter that had the name of a state, a constant or a function would hide it within the loop, and a reader would have to know which of the two is meant.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-sum(each(v, 1, 3, v))*(1 m/s^2)\"",
                "\"-sum(each(i, 1, 3, i*v))/(6 s)\"",
            )],
        ),
    ),
    (
        Rule::E0320,
        plain(
            "The values of an axis increase from one to the next, so that every argument lies between two of them.",
            &[
                edit(
                    "plant:\n",
                    "tables:\n  damping:\n    axes: {speed: {values: [0, 2, 1], unit: m/s}}\n    values: [1, 1.5, 3]\n    interpolation: linear\n    extrapolation: clamp\nplant:\n",
                    TABLE,
                ),
                edit(
                    "\"-v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                ),
            ],
        ),
    ),
    (
        Rule::E0321,
        plain(
            "A table has one value at every combination of its axes' values, and its values come from one place: listed in the specification, or in a file.",
            &[
                edit(
                    "plant:\n",
                    "tables:\n  damping:\n    axes: {speed: {values: [0, 1, 2], unit: m/s}}\n    values: [1, 1.5]\n    interpolation: linear\n    extrapolation: clamp\nplant:\n",
                    TABLE,
                ),
                edit(
                    "\"-v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                ),
            ],
        ),
    ),
    (
        Rule::E0322,
        plain(
            "Tables hold plain numbers. The unit of an axis or of the values stands once, under `unit`.",
            &[
                edit(
                    "plant:\n",
                    "tables:\n  damping:\n    axes: {speed: {values: [0, 1, 2], unit: m/s}}\n    values: [1, much, 3]\n    interpolation: linear\n    extrapolation: clamp\nplant:\n",
                    TABLE,
                ),
                edit(
                    "\"-v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                ),
            ],
        ),
    ),
    (
        Rule::E0323,
        with_files(
            "The first line of a data file names its columns: one for each axis, and one with the name of the table or the one that `column` names.",
            &[
                edit(
                    "plant:\n",
                    "tables:\n  damping:\n    axes: {speed: m/s}\n    file: damping.csv\n    interpolation: linear\n    extrapolation: clamp\nplant:\n",
                    "tables:\n  damping:\n    axes: {speed: m/s}\n    file: damping.csv\n    interpolation: linear\n    extrapolation: clamp\nplant:\n",
                ),
                edit(
                    "\"-v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                    "\"-damping(v)*v/(1 s)\"",
                ),
            ],
            &[(
                "damping.csv",
                "velocity,damping\n0,1\n1,1.5\n2,3\n",
                "speed,damping\n0,1\n1,1.5\n2,3\n",
            )],
        ),
    ),
    (
        Rule::E0324,
        plain(
            "A table has one to three axes, and its points are limited: they are numbers in the emitted code. Data of more arguments are better fitted by polynomials.",
            &[undo(
                "plant:\n",
                "tables:\n  damping:\n    axes: {a: [0, 1], b: [0, 1], c: [0, 1], d: [0, 1]}\n    values: [1]\n    interpolation: linear\n    extrapolation: clamp\nplant:\n",
            )],
        ),
    ),
];
