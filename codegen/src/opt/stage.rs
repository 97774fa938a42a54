//! A program on its way through the optimiser.

use super::{Arithmetic, optimise_watched};
use crate::ir::Program;

/// The program that optimisation starts from.
pub const LOWERED: &str = "lowered";

/// The program that is emitted.
pub const OPTIMISED: &str = "optimised";

/// Names of the stages in their order: before all passes, after each pass of the first round, after all rounds.
pub fn names(arithmetic: Arithmetic) -> Vec<&'static str> {
    let passes = arithmetic.passes().map(|pass| pass.name);
    std::iter::once(LOWERED)
        .chain(passes)
        .chain([OPTIMISED])
        .collect()
}

/// The program at a stage, or `None` if there is no stage of that name.
pub fn at(program: Program, arithmetic: Arithmetic, stage: &str) -> Option<Program> {
    if stage == LOWERED {
        return Some(program);
    }
    let mut found = None;
    let optimised = optimise_watched(program, arithmetic, |pass, round, program| {
        if round == 1 && pass.name == stage {
            found = Some(program.clone());
        }
    });
    found.or_else(|| (stage == OPTIMISED).then_some(optimised))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::random;
    use crate::opt::optimise;

    #[test]
    fn every_stage_has_a_program_that_reads_back() {
        let program = random::program(3, 200);
        for arithmetic in [Arithmetic::Strict, Arithmetic::Fast] {
            for name in names(arithmetic) {
                let staged = at(program.clone(), arithmetic, name).expect(name);
                assert_eq!(staged.to_string().parse(), Ok(staged), "{name}");
            }
        }
    }

    #[test]
    fn the_first_stage_is_the_program_and_the_last_is_optimised() {
        let program = random::program(4, 200);
        let staged = |name| at(program.clone(), Arithmetic::Strict, name);
        assert_eq!(staged(LOWERED), Some(program.clone()));
        assert_eq!(staged(OPTIMISED), Some(optimise(program.clone())));
        assert_eq!(staged("no such pass"), None);
    }
}
