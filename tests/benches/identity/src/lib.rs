//! `cargo run --release --bin SPEC -- strict POINTS SEED [EVERY]`: the bits of emitted scalar code, emitted lanes of each width and the
//! evaluator; the evaluator at one in EVERY points. `-- fast POINTS SEED`: what `--math fast` changes, in units of the last place.

use std::env;
use std::process::ExitCode;

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

/// The command line for a module.
pub fn run<M: emitted::Module>() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let number = |at: usize| arguments.get(at).and_then(|text| text.parse::<u64>().ok());
    let (Some(mode), Some(count), Some(seed)) = (arguments.first(), number(1), number(2)) else {
        eprintln!("strict POINTS SEED [EVERY] | fast POINTS SEED");
        return ExitCode::FAILURE;
    };
    let (model, programs) = compiled(M::NAME);
    let layout = Layout::new::<M>(&model, &programs);
    let points = Points::new::<M>(&model, &programs, layout, seed);
    let passed = match mode.as_str() {
        "strict" => strict::run::<M>(&points, &programs, count, number(3).unwrap_or(1)),
        _ => {
            fast::run::<M>(&points, &programs, count);
            true
        }
    };
    ExitCode::from(u8::from(!passed))
}
