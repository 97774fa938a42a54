//! Optimisation: passes from program to program, one file each, every rewrite under its algebra.

pub mod cost;
pub mod dependence;
pub mod explain;
pub mod hoist;
pub mod stage;

mod angles;
mod arrays;
mod blocks;
mod cancel;
mod combine;
mod contract;
pub(crate) mod dead_code;
mod differences;
mod divisors;
mod elementary;
mod factors;
mod families;
mod fold;
mod identities;
mod inverse;
mod kernels;
mod linear;
mod polynomials;
mod powers;
mod reciprocals;
mod rewrite;
mod select;
mod solve;
mod sparse;
mod structural_zeros;
mod symmetric;
mod tables;
mod transposes;
mod value_numbering;

use crate::ir::Program;

/// What a pass may change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing: outputs keep every bit for all inputs, zeros of either sign, infinities and NaN (of any payload) included.
    Exact,
    /// Roundings; the text states by how much. Applied in [`Arithmetic::Fast`] only.
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
pub static PASSES: [Pass; 18] = [
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
        name: "kernels",
        kind: Kind::Exact,
        run: kernels::run,
    },
    Pass {
        name: "identities",
        kind: Kind::Exact,
        run: identities::run,
    },
    Pass {
        name: "structural_zeros",
        kind: Kind::Reassociating(
            "equal for finite values, up to the sign of a zero and the order of sums of eight terms or more; solutions to the roundings of their blocks and inverses",
        ),
        run: structural_zeros::run,
    },
    Pass {
        name: "angles",
        kind: Kind::Reassociating("a tangent is off by at most 3 ulp instead of 1"),
        run: angles::run,
    },
    Pass {
        name: "linear",
        kind: Kind::Reassociating(
            "a sum of n terms c x is off by at most (n + 4) 2^-53 sum |c x|, with the factors of every term as they were",
        ),
        run: linear::run,
    },
    Pass {
        name: "factors",
        kind: Kind::Reassociating(
            "a sum of n multiples of arrays is off by at most (n + 2) 2^-53 of the sum of their magnitudes, before and after",
        ),
        run: factors::run,
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
        name: "polynomials",
        kind: Kind::Exact,
        run: polynomials::run,
    },
    Pass {
        name: "combine",
        kind: Kind::Reassociating(
            "the coefficients of n polynomials that are added are rounded n times, and k times more where a literal argument goes in with the \
             power k, so that the sum at z is off by at most (n + k) 2^-53 sum |c_i| |z|^i more",
        ),
        run: combine::run,
    },
    Pass {
        name: "divisors",
        kind: Kind::Reassociating("a quotient x/c is off by at most 1.5 ulp instead of 0.5"),
        run: divisors::run,
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
    Pass {
        name: "elementary",
        kind: Kind::Exact,
        run: elementary::run,
    },
];

/// The passes after all rounds.
pub static LAST: [Pass; 2] = [
    Pass {
        name: "tables",
        kind: Kind::Exact,
        run: tables::run,
    },
    Pass {
        name: "contract",
        kind: Kind::Reassociating(
            "a product that is added to something is not rounded, which takes at most half of the error of both away; elementary functions by fused products, within 2 places as those by others",
        ),
        run: contract::run,
    },
];

/// Which passes are applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// The exact ones: the result is the program's, bit for bit.
    Strict,
    /// All: results differ from the program's by roundings.
    Fast,
}

/// Rounds are repeated while they change the program, but at most this often: a pass may enable an earlier one, and two or three rounds
/// find nearly all.
const ROUNDS: usize = 6;

/// The program done as on paper: `0 x = 0`, `x + 0 = x`, `x / c = (1/c) x`, `x s + x t = x (s + t)`; a clamped kernel is one quotient;
/// inverses cancel, equations are solved block by block, those of a symmetric matrix by its lower triangle, and what a run does not change
/// is divided by or inverted once. Part of lowering: results are those
/// of the program for all finite values, up to the sign of a zero, a rounding for each quotient, and the roundings of sums and solutions as
/// `factors` and `solve` state them.
pub fn simplify(program: Program) -> Program {
    // Before zeros are taken out of products, and again after matrices fell into blocks.
    let mut program = symmetric::run(program);
    for _ in 0..ROUNDS {
        let before = program.clone();
        let passes = [
            fold::run,
            select::run,
            kernels::run_clamped,
            identities::run,
            differences::run,
            cancel::run,
            factors::run,
            structural_zeros::run,
            divisors::run,
            reciprocals::run,
            arrays::run,
            dead_code::run_for_names,
        ];
        program = passes
            .into_iter()
            .fold(program, |program, pass| pass(program));
        if program == before {
            break;
        }
    }
    symmetric::run(program)
}

/// The program with the same outputs, bit for bit, in fewer operations.
pub fn optimise(program: Program) -> Program {
    optimise_with(program, Arithmetic::Strict)
}

/// The program in fewer operations. Debug builds verify it after each pass.
pub fn optimise_with(program: Program, arithmetic: Arithmetic) -> Program {
    optimise_watched(program, arithmetic, |_, _, _| {})
}

/// As [`optimise_with`]; `watch` sees the program after each pass, with the pass and its round, counted from 1.
pub fn optimise_watched(
    mut program: Program,
    arithmetic: Arithmetic,
    mut watch: impl FnMut(&'static Pass, usize, &Program),
) -> Program {
    if cfg!(debug_assertions) {
        program.assert_sound();
    }
    for round in 1..=ROUNDS {
        let before = program.clone();
        for pass in arithmetic.passes_of_a_round() {
            program = (pass.run)(program);
            if cfg!(debug_assertions) {
                program.assert_sound();
            }
            watch(pass, round, &program);
        }
        if program == before {
            break;
        }
    }
    for pass in arithmetic.last_passes() {
        program = dead_code::run((pass.run)(program));
        if cfg!(debug_assertions) {
            program.assert_sound();
        }
        watch(pass, 1, &program);
    }
    program
}

impl Arithmetic {
    /// The passes of this arithmetic, in their order.
    pub fn passes(self) -> impl Iterator<Item = &'static Pass> {
        self.passes_of_a_round().chain(self.last_passes())
    }

    fn last_passes(self) -> impl Iterator<Item = &'static Pass> {
        LAST.iter().filter(move |pass| self.applies(pass))
    }

    fn passes_of_a_round(self) -> impl Iterator<Item = &'static Pass> {
        PASSES.iter().filter(move |pass| self.applies(pass))
    }

    fn applies(self, pass: &Pass) -> bool {
        self == Arithmetic::Fast || pass.kind == Kind::Exact
    }
}

#[cfg(test)]
mod equations_tests;
#[cfg(test)]
mod structure_tests;
#[cfg(test)]
mod tests;
