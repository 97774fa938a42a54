//! What the theory requires, and warnings.

use super::{Explanation, edit, plain, undo};
use crate::diagnostic::Rule;

/// A second block behind the first.
const PLANT: &str = "      gain: \"1/(2 kg)\"\n";
const DRIVE: &str = "      gain: 1 1/s\n    drive:\n      states: {w: 0 m/s}\n      drift: 0\n      gain: \"1/(2 kg)\"\n";
const GAINS: &str = "    motion: {K: 1, kbar: 1, C: 20, filter: 20 ms, eta_2: 1, eta_3: 1}\n    drive: {K: 1, kbar: 1, C: 20}\n";

pub(super) const ALL: &[(Rule, Explanation)] = &[
    (
        Rule::E0701,
        plain(
            "Backstepping needs strict feedback: the dynamics of a block depend on its own states and those of blocks before it. The next block acts through the gain alone, for its state is what the law of this block commands; were it also in the drift, the command would depend on itself.",
            &[
                edit(PLANT, DRIVE, DRIVE),
                edit("    motion: {K: 1, kbar: 1, C: 20}\n", GAINS, GAINS),
                edit("\"-v/(1 s)\"", "\"-(v + w)/(1 s)\"", "\"-v/(1 s)\""),
            ],
        ),
    ),
    (
        Rule::E0702,
        plain(
            "The plant is time-invariant: its derivatives are taken by the states only. What changes with time by itself is a disturbance, and what should change is the reference.",
            &[edit("\"-v/(1 s)\"", "\"-v/(1 s + t)\"", "\"-v/(1 s)\"")],
        ),
    ),
    (
        Rule::E0703,
        plain(
            "References, constraints and disturbances are given in advance as functions of time. One that depends on a state would close another loop around the controller, which the proof of stability knows nothing of.",
            &[undo("v: 1 m/s", "v: 1 m/s - v")],
        ),
    ),
    (
        Rule::E0704,
        plain(
            "The control law inverts the gain of each block. Where it is singular at the initial state, some direction cannot be moved at all: an input has no effect, or two inputs have the same.",
            &[undo("\"1/(2 kg)\"", "\"v/(2 kg*m/s)\"")],
        ),
    ),
    (
        Rule::E0705,
        plain(
            "The barrier keeps the error within its constraint if it starts there. It cannot bring in an error that starts outside.",
            &[edit(
                "C: 20}",
                "C: 20, constraint: 0.5 m/s}",
                "C: 20, constraint: 1.5 m/s}",
            )],
        ),
    ),
    (
        Rule::E0706,
        plain(
            "Drift, gain and reference are evaluated at the initial state and over the horizon. What is infinite or undefined there stops the controller at its first step.",
            &[edit(
                "\"-v/(1 s)\"",
                "\"-(1 m/s)^2/v/(1 s)\"",
                "\"-(1 m/s)^2/(v + 1 m/s)/(1 s)\"",
            )],
        ),
    ),
    (
        Rule::E0707,
        plain(
            "The estimate of an observer converges if its error decays. Against a `bounded` disturbance it decays at the rate `observer` (S in the theory): one positive number, or a matrix whose eigenvalues have positive real parts. Against an exosystem, every eigenvalue of `M - S L` has a negative real part, with `M` and `L` as given under `exosystem` and `observer` for S.",
            &[
                edit(
                    "      gain: \"1/(2 kg)\"\n",
                    "      gain: \"1/(2 kg)\"\n      disturbance: {bounded: 0.1 m/s^2}\n",
                    "      gain: \"1/(2 kg)\"\n      disturbance: {bounded: 0.1 m/s^2}\n",
                ),
                edit(
                    "C: 20}",
                    "C: 20, eta_1: 1, observer: -5}",
                    "C: 20, eta_1: 1, observer: 5}",
                ),
            ],
        ),
    ),
    (
        Rule::E0708,
        plain(
            "The constraint bounds the norm of the error, so it is positive over the whole horizon. One that reaches zero asks for perfect tracking from then on.",
            &[edit(
                "C: 20}",
                "C: 20, constraint: 4 m/s - t*(1 m/s^2)}",
                "C: 20, constraint: 4 m/s*exp(-t/(1 s)) + 0.5 m/s}",
            )],
        ),
    ),
    (
        Rule::W0001,
        plain(
            "`kbar` bounds how fast the constraint shrinks: the proof needs sup sqrt((k'/k)^2 + beta). With less the error may touch the constraint while it shrinks. `kbar: auto` computes the bound.",
            &[edit(
                "kbar: 1, C: 20}",
                "kbar: 0.5, C: 20, constraint: 4 m/s*exp(-t/(1 s)) + 0.5 m/s}",
                "kbar: auto, C: 20, constraint: 4 m/s*exp(-t/(1 s)) + 0.5 m/s}",
            )],
        ),
    ),
    (
        Rule::W0002,
        plain(
            "A constant, parameter, definition, function or table that no expression uses is often one whose use was forgotten, or mistyped into the name of another. Declarations in included files are left alone, for other specifications may use them.",
            &[
                edit(
                    "plant:\n",
                    "constants: {mass: 2 kg}\nplant:\n",
                    "constants: {mass: 2 kg}\nplant:\n",
                ),
                edit("\"1/(2 kg)\"", "\"1/(2 kg)\"", "1/mass"),
            ],
        ),
    ),
    (
        Rule::W0003,
        plain(
            "An argument that the value of its function does not use gives every call a number in vain. Mostly the value names something else than was meant, such as a state, or the argument is left over from an earlier version.",
            &[
                edit(
                    "plant:\n",
                    "functions: {drag: {arguments: [rate, limit], value: -rate/(1 s)}}\nplant:\n",
                    "functions: {drag: {arguments: [rate, limit], value: \"-clamp(rate, -limit, limit)/(1 s)\"}}\nplant:\n",
                ),
                edit("\"-v/(1 s)\"", "\"drag(v, 3 m/s)\"", "\"drag(v, 3 m/s)\""),
            ],
        ),
    ),
];
