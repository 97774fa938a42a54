//! Optimisation: passes from program to program, one file each, every rewrite under its algebra.

pub mod cost;

mod arrays;
mod dead_code;
mod fold;
mod identities;
mod powers;
mod reciprocals;
mod rewrite;
mod select;
mod structural_zeros;
mod transposes;
mod value_numbering;

use crate::ir::Program;

/// What a pass may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing: outputs keep every bit for all inputs, zeros of either sign, infinities and NaN (of any payload) included.
    Exact,
    /// Roundings; the text states by how much. Applied in [`Arithmetic::Relaxed`] only.
    Reassociating(&'static str),
}

/// A pass.
pub struct Pass {
    /// Name.
    pub name: &'static str,
    /// What it may change.
    pub kind: Kind,
    /// The pass, linear in the size of the program.
    pub run: fn(Program) -> Program,
}

/// All passes, in the order of a round.
pub const PASSES: [Pass; 10] = [
    Pass {
        name: "fold",
        kind: Kind::Exact,
        run: fold::run,
    },
    Pass {
        name: "select",
        kind: Kind::Exact,
        run: select::run,
    },
    Pass {
        name: "identities",
        kind: Kind::Exact,
        run: identities::run,
    },
    Pass {
        name: "structural_zeros",
        kind: Kind::Reassociating("equal for finite values, up to the sign of a zero"),
        run: structural_zeros::run,
    },
    Pass {
        name: "arrays",
        kind: Kind::Exact,
        run: arrays::run,
    },
    Pass {
        name: "transposes",
        kind: Kind::Exact,
        run: transposes::run,
    },
    Pass {
        name: "powers",
        kind: Kind::Exact,
        run: powers::run,
    },
    Pass {
        name: "value_numbering",
        kind: Kind::Exact,
        run: value_numbering::run,
    },
    Pass {
        name: "reciprocals",
        kind: Kind::Reassociating(
            "a quotient a/d is off by at most 1.5 ulp instead of 0.5, while 1/d neither over- nor underflows",
        ),
        run: reciprocals::run,
    },
    Pass {
        name: "dead_code",
        kind: Kind::Exact,
        run: dead_code::run,
    },
];

/// Which passes are applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// The exact ones: the result is the program's, bit for bit.
    Strict,
    /// All.
    Relaxed,
}

/// Rounds are repeated while they change the program, but at most this often: a pass may enable an earlier one, and two or three rounds
/// find nearly all.
const ROUNDS: usize = 6;

/// The program with the same outputs, bit for bit, in fewer operations.
pub fn optimise(program: Program) -> Program {
    optimise_with(program, Arithmetic::Strict)
}

/// The program in fewer operations. Debug builds verify it after each pass.
pub fn optimise_with(mut program: Program, arithmetic: Arithmetic) -> Program {
    if cfg!(debug_assertions) {
        program.assert_sound();
    }
    for _ in 0..ROUNDS {
        let before = program.clone();
        for pass in PASSES
            .iter()
            .filter(|pass| arithmetic == Arithmetic::Relaxed || pass.kind == Kind::Exact)
        {
            program = (pass.run)(program);
            if cfg!(debug_assertions) {
                program.assert_sound();
            }
        }
        if program == before {
            break;
        }
    }
    program
}

#[cfg(test)]
mod tests;
