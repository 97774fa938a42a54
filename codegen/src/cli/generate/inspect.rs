//! Looking into the compiler instead of writing code: the IR of a program at a stage, the operations of each pass and equation.

use std::path::PathBuf;

use nsv_codegen::ir::Program;
use nsv_codegen::lower::Programs;
use nsv_codegen::opt::stage;

use super::explain;
use crate::cli::compile::{Math, Partials, load, lower};
use crate::cli::failure::{Exit, Failure};
use crate::cli::output;
use crate::cli::settings::Settings;

/// What to show on standard output; no file is written then.
#[derive(clap::Args)]
#[group(id = "inspect", multiple = true)]
pub(super) struct Args {
    /// Show a program as text instead of writing code
    #[arg(long, value_enum, value_name = "FORM", conflicts_with_all = ["check", "out"])]
    emit: Option<Form>,
    /// Stage of the shown program: `lowered`, a pass (as its first round left it), or `optimised`
    #[arg(long, value_name = "STAGE", requires = "emit", conflicts_with_all = ["explain_cost", "check", "out"], default_value = stage::OPTIMISED)]
    stage: String,
    /// The program to show
    #[arg(long, value_enum, requires = "emit", conflicts_with_all = ["explain_cost", "check", "out"], default_value_t = Which::Control)]
    program: Which,
    /// Show the operations of each program, before and after each pass and for each equation
    #[arg(long, conflicts_with_all = ["emit", "check", "out"])]
    explain_cost: bool,
    /// How the operations are shown
    #[arg(long, value_enum, requires = "explain_cost", conflicts_with_all = ["emit", "check", "out"], default_value_t = Format::Human)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// A table
    Human,
    /// One JSON document
    Json,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Form {
    /// The intermediate representation
    Ir,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Which {
    /// One sample of the law
    Control,
    /// Drift and diffusion of the plant
    Plant,
    /// Controller states at the first sample
    Initial,
    /// Lyapunov function and its generator
    Lyapunov,
    /// Every quantity of the law, V and LV
    Quantities,
}

impl Which {
    fn of(self, programs: Programs) -> Program {
        match self {
            Which::Control => programs.control,
            Which::Plant => programs.plant,
            Which::Initial => programs.initial,
            Which::Lyapunov => programs.lyapunov,
            Which::Quantities => programs.quantities,
        }
    }
}

impl Args {
    /// Whether something is to be shown.
    pub(super) fn wanted(&self) -> bool {
        self.emit.is_some() || self.explain_cost
    }
}

/// Shows what was asked for.
pub(super) fn run(
    args: &Args,
    specs: &[PathBuf],
    settings: &Settings,
    math: Math,
) -> Result<(), Failure> {
    let stages = stage::names(math.into());
    if !stages.contains(&args.stage.as_str()) {
        let message = format!("there is no stage `{}` in this arithmetic", args.stage);
        return Err(Failure::new(Exit::Usage, message)
            .with_help(format_args!("the stages are {}", stages.join(", "))));
    }
    let [spec] = specs else {
        let message = "expected one specification to show";
        return Err(Failure::new(Exit::Usage, message)
            .with_help("`--emit` and `--explain-cost` show one at a time"));
    };
    let model = load(spec, settings)?;
    let programs = lower(spec, &model, Partials::Cached)?;
    if args.explain_cost {
        let explanations = explain::explanations(&programs, math);
        return match args.format {
            Format::Human => output::data(&explain::table(&model, &explanations)),
            Format::Json => output::json(&explain::document(&model, math, &explanations)),
        };
    }
    let program = stage::at(args.program.of(programs), math.into(), &args.stage);
    output::data(&program.expect("invariant: the stage exists").to_string())
}
