//! Prints every program of a specification as text, before any optimisation: what `tests/reference/casadi_values.py` evaluates.
//!
//! `cargo run --package nsv-tests --example programs -- specs/pendulum.yaml`

use std::env;
use std::path::Path;
use std::process::ExitCode;

use nsv_tests::specification::compiled;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [path] = arguments.as_slice() else {
        eprintln!("usage: programs SPEC");
        return ExitCode::from(2);
    };
    let (_, programs) = compiled(Path::new(path));
    let programs = [
        programs.initial,
        programs.control,
        programs.plant,
        programs.lyapunov,
        programs.quantities,
    ];
    for program in programs {
        print!("{program}");
    }
    ExitCode::SUCCESS
}
