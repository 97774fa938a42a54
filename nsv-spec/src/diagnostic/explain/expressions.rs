//! Syntax of expressions.

use super::{Explanation, Twist, plain, twisted, undo};
use crate::diagnostic::Rule;

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0201,
        plain(
            "Expressions are made of numbers, names, the operators `+ - * / ^`, comparisons, `and`, `or`, `not`, functions and brackets. Symbols of other languages are recognised, and the message says what to write for them.",
            &[undo("v: 1 m/s", "v: 1 m/s*2**3")],
        ),
    ),
    (
        Rule::E0202,
        plain(
            "Numbers are written like `12000`, `0.5` or `1.5e-3`, without separators between digits, and fit a 64 bit floating point number.",
            &[undo("K: 1,", "K: 1_000,")],
        ),
    ),
    (
        Rule::E0203,
        plain(
            "An operand is expected where there is none, or the other way round. A `+` in front of a number says nothing and is not allowed.",
            &[undo("v: 1 m/s", "v: +1 m/s")],
        ),
    ),
    (
        Rule::E0204,
        plain(
            "A bracket opens and does not close, or holds a list where one value is expected. Vectors stand in square brackets.",
            &[undo("\"-v/(1 s)\"", "\"-v/(1 s\"")],
        ),
    ),
    (
        Rule::E0205,
        plain(
            "In mathematics `a < b < c` means two comparisons, in most languages it compares a truth value with a number. Here you say which you mean: `a < b and b < c`.",
            &[undo(
                "\"-v/(1 s)\"",
                "\"if(0 m/s < v < 2 m/s, -v, v)/(1 s)\"",
            )],
        ),
    ),
    (
        Rule::E0206,
        twisted(
            "Brackets and operators nest at most 128 deep. What is deeper is made by a program, which can name its parts under `definitions`.",
            &[undo("v: 1 m/s", "v: …1 m/s")],
            Twist::Long("-", 130),
        ),
    ),
    (
        Rule::E0207,
        twisted(
            "An expression has at most 16384 parts and 64 kB. Name its parts under `definitions`: the optimiser shares and inlines them as it likes, so that costs nothing.",
            &[undo("v: 1 m/s", "v: 1 m/s…")],
            Twist::Long(" + 1 m/s", 9_000),
        ),
    ),
    (
        Rule::E0208,
        plain(
            "Two operands stand side by side. Multiplication is always written with `*`, since `2 (x)` and `a b` could be slips for something else.",
            &[undo("\"-v/(1 s)\"", "\"-0.5 (v + v)/(1 s)\"")],
        ),
    ),
    (
        Rule::E0209,
        plain(
            "An index is a whole number from 1 that is known when the specification is read, since it decides which quantity is meant and which unit it has.",
            &[undo("v: 1 m/s", "v: \"[1 m/s, 2 m/s][0]\"")],
        ),
    ),
];
