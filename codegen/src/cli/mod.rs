//! The command line: one verb per file or folder.
//!
//! Data goes to standard output, everything else to standard error. Exit codes: 0 ok, 1 the specification has errors, 2 usage,
//! 3 environment, 4 a check failed, 130 interrupted.

mod check;
mod child;
mod compile;
mod doctor;
mod eval;
mod explain;
mod failure;
mod files;
mod fmt;
mod generate;
mod merge;
mod new;
mod output;
mod render;
mod runner;
mod schema;
mod settings;
mod simulate;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Compiles a specification of a control problem to specialised Rust: controller, observers, plant simulator, Lyapunov monitor.
#[derive(Parser)]
#[command(
    name = "nsv",
    version,
    max_term_width = 100,
    arg_required_else_help = true
)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    Check(check::Args),
    Explain(explain::Args),
    Generate(generate::Args),
    Simulate(simulate::Args),
    Merge(merge::Args),
    Eval(eval::Args),
    Fmt(fmt::Args),
    New(new::Args),
    Schema(schema::Args),
    Doctor(doctor::Args),
}

/// Reads the command line, runs the verb, and says in the exit code how it went.
pub(crate) fn main() -> ExitCode {
    let cli = Cli::parse();
    nsv_codegen::interrupt::install();
    let done = match &cli.verb {
        Verb::Check(args) => check::run(args),
        Verb::Explain(args) => explain::run(args),
        Verb::Generate(args) => generate::run(args),
        Verb::Simulate(args) => simulate::run(args),
        Verb::Merge(args) => merge::run(args),
        Verb::Eval(args) => eval::run(args),
        Verb::Fmt(args) => fmt::run(args),
        Verb::New(args) => new::run(args),
        Verb::Schema(args) => schema::run(args),
        Verb::Doctor(args) => doctor::run(args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    #[test]
    fn the_command_line_is_well_formed() {
        super::Cli::command().debug_assert();
    }
}
