//! `cargo run --release --bin SPEC -- POINTS SEED [EVERY]`: the bits of emitted scalar code, emitted lanes of each width and the evaluator; the
//! evaluator at one in EVERY points. `--bin fast -- SPEC POINTS SEED`: what `--math fast` changes, in units of the last place.

use std::env;
use std::process::ExitCode;

use crate::emitted::Module;
use crate::layout::{Layout, compiled};
use crate::points::Points;

mod draw;
pub mod emitted;
mod evaluated;
mod fast;
mod flight;
mod lanes;
mod layout;
mod points;
mod strict;
mod work;

/// The command line that compares the bits of a module.
pub fn strict<M: Module>() -> ExitCode {
    let number = |at: usize| env::args().nth(at).and_then(|text| text.parse::<u64>().ok());
    let (Some(count), Some(seed)) = (number(1), number(2)) else {
        eprintln!("POINTS SEED [EVERY]");
        return ExitCode::FAILURE;
    };
    let (model, programs) = compiled(M::NAME);
    let points = Points::new::<M>(&model, &programs, Layout::new::<M>(&model, &programs), seed);
    let same = strict::run::<M>(&points, &programs, count, number(3).unwrap_or(1));
    ExitCode::from(u8::from(!same))
}

/// Compares fast with strict arithmetic of a module.
pub fn fast<M: Module>(count: u64, seed: u64) {
    let (model, programs) = compiled(M::NAME);
    let points = Points::new::<M>(&model, &programs, Layout::new::<M>(&model, &programs), seed);
    fast::run::<M>(&points, &programs, count);
}
