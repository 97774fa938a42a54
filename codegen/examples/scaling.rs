//! Time per instruction of the compiler's phases on programs of growing size: a chain of coupled arms and random operations.
//!
//! `cargo run --release --package nsv-codegen --example scaling`

use std::time::Instant;

use nsv_codegen::emit::standalone;
use nsv_codegen::ir::{Program, chain, random};
use nsv_codegen::opt::{Arithmetic, optimise_with};

/// Nanoseconds per instruction, the least of three.
fn time<T>(program: &Program, phase: impl Fn(Program) -> T) -> f64 {
    let once = || {
        let program = program.clone();
        let start = Instant::now();
        let result = phase(program);
        let elapsed = start.elapsed();
        drop(result);
        elapsed.as_nanos() as f64
    };
    let least = (0..3).map(|_| once()).fold(f64::INFINITY, f64::min);
    least / program.instructions.len() as f64
}

fn main() {
    println!("nanoseconds per instruction\n");
    println!(
        "{:<12}{:>14}{:>10}{:>10}{:>10}",
        "program", "instructions", "strict", "fast", "emit"
    );
    for length in [1_000, 10_000, 100_000] {
        let programs = [
            ("chain", chain::arms(length / 28)),
            ("random", random::program(7, length)),
        ];
        for (name, program) in programs {
            let strict = time(&program, |program| {
                optimise_with(program, Arithmetic::Strict)
            });
            let fast = time(&program, |program| optimise_with(program, Arithmetic::Fast));
            let optimised = optimise_with(program.clone(), Arithmetic::Strict);
            let emit = time(&optimised, |program| standalone(&program));
            let length = program.instructions.len();
            println!("{name:<12}{length:>14}{strict:>10.0}{fast:>10.0}{emit:>10.0}");
        }
    }
}
