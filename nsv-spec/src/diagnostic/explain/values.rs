//! Values that are possible.

use super::{Explanation, edit, plain, undo};
use crate::diagnostic::Rule;

const PARAMETER: &str =
    "parameters:\n  mass: {value: 2 kg, dispersion: {uniform: [1 kg, 3 kg]}}\nplant:\n";

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0601,
        plain(
            "Gains, limits and standard deviations are positive: the proof of stability divides by them or needs them to push towards the reference.",
            &[undo("K: 1,", "K: -1,")],
        ),
    ),
    (
        Rule::E0602,
        plain(
            "The value is a number of the right unit, but no sensible one: a sample time of an hour, a window that starts after the end, a safe output beyond the limit.",
            &[undo("safe: 0 N", "safe: 6 N")],
        ),
    ),
    (
        Rule::E0603,
        plain(
            "Constants are computed when the specification is read. One that divides by zero, takes the root of a negative number or overflows is no number. Lookup tables are fitted then too: one with huge values, or with points that nearly coincide, can overflow between its points.",
            &[
                edit(
                    "plant:\n",
                    "constants: {top: \"1 m/s/(2 - 2)\"}\nplant:\n",
                    "constants: {top: \"1 m/s/(2 - 1)\"}\nplant:\n",
                ),
                edit("v: 1 m/s", "v: top", "v: top"),
            ],
        ),
    ),
    (
        Rule::E0604,
        plain(
            "A quantity is written with its unit, and that must be the one its key asks for. Gains may also be bare numbers in SI. The help shows the number that is written in the SI unit; if it was meant in another one, write that: `0.002 s` is `2 ms`.",
            &[undo("sample_time: 2 ms", "sample_time: 0.002")],
        ),
    ),
    (
        Rule::E0605,
        plain(
            "A gain is one number for all states of a block or one for each; some may be matrices. Other numbers of entries say nothing about how they belong to the states. A covariance has a row and a column for each parameter of its group.",
            &[undo("K: 1,", "K: [1, 2],")],
        ),
    ),
    (
        Rule::E0606,
        plain(
            "Numbers of one constant have one unit, given in one place: with each number, or once under `unit`.",
            &[
                edit(
                    "plant:\n",
                    "constants:\n  top: {value: 1 m/s, unit: m/s}\nplant:\n",
                    "constants:\n  top: {value: 1, unit: m/s}\nplant:\n",
                ),
                edit("v: 1 m/s", "v: top", "v: top"),
            ],
        ),
    ),
    (
        Rule::E0607,
        plain(
            "A uniform dispersion is `[least, largest]`, a normal one is not cut off beyond five deviations from its mean, and the probabilities of a discrete one add up to 1.",
            &[
                edit(
                    "plant:\n",
                    "parameters:\n  mass: {value: 2 kg, dispersion: {uniform: [3 kg, 1 kg]}}\nplant:\n",
                    PARAMETER,
                ),
                edit("\"1/(2 kg)\"", "1/mass", "1/mass"),
            ],
        ),
    ),
    (
        Rule::E0608,
        plain(
            "`C` is the gain of the anti-windup system. Its symmetric part is positive definite, so that the system forgets a saturation once it is over; with a negative eigenvalue it would run away instead.",
            &[undo("C: 20}", "C: -20}")],
        ),
    ),
    (
        Rule::E0609,
        plain(
            "The nodes of a network grow with its order and the number of its inputs: with `basis: pairwise` n inputs of order p make 1 + n p + n (n - 1)/2 p (p - 1)/2 nodes, with `basis: complete` (n + p)!/(n! p!). With 3 inputs of order 3 that is 19 and 20. Order 0 knows a constant only, which an observer estimates better; more than 2000 nodes are slow to run and never learn.",
            &[edit(
                "C: 20}",
                "C: 20, network: {order: 0, inputs: [v], scale: [1 m/s], iota: 1, Gamma: 1, lambda: 1}, error_bound: {iota: 1, b: 1}}",
                "C: 20, network: {order: 2, inputs: [v], scale: [1 m/s], iota: 1, Gamma: 1, lambda: 1}, error_bound: {iota: 1, b: 1}}",
            )],
        ),
    ),
    (
        Rule::E0610,
        plain(
            "Runge-Kutta takes samples within a step, which white noise does not have: the result would be of no order at all. With `noise: wiener` use `euler_maruyama` or `platen`.",
            &[edit(
                "scheme: rk4, noise: sampled",
                "scheme: rk4, noise: wiener",
                "scheme: platen, noise: wiener",
            )],
        ),
    ),
];
