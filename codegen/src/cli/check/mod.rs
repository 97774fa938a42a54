//! `nsv check`: every fault of a specification.

mod fix;
mod sarif;

use std::path::{Path, PathBuf};

use nsv_spec::diagnostic::Diagnostics;
use nsv_spec::model::Model;
use serde_json::{Value, json};

use super::compile::show;
use super::failure::{Exit, Failure};
use super::output::{self, note};
use super::render::records;

/// Check specifications: names, units, shapes, ranges; every fault at once, with its place
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specifications to check
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<PathBuf>,
    /// List the defaults that were filled in
    #[arg(short, long)]
    verbose: bool,
    /// Apply the changes that are certain to mend a fault, and show what is left
    #[arg(long)]
    fix: bool,
    /// Fail if there are warnings
    #[arg(long)]
    deny_warnings: bool,
    /// How faults are shown
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// Pictures of the source
    Human,
    /// One line for each place
    Short,
    /// One JSON document on standard output
    Json,
    /// SARIF 2.1.0 on standard output, for code hosts and editors
    Sarif,
}

struct Checked<'a> {
    path: &'a Path,
    model: Option<Model>,
    faults: Diagnostics,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let mut checked: Vec<Checked<'_>> = Vec::new();
    for path in &args.specs {
        checked.push(if args.fix {
            fix::run(path)?
        } else {
            check(path)
        });
    }
    match args.format {
        Format::Json => {
            output::json(&json!({ "specs": checked.iter().map(document).collect::<Vec<_>>() }))?
        }
        Format::Sarif => output::json(&sarif::log(checked.iter().map(|one| &one.faults)))?,
        format => checked
            .iter()
            .try_for_each(|one| tell(one, format, args.verbose))?,
    }
    let passes = |one: &Checked<'_>| {
        one.model.is_some() && (!args.deny_warnings || one.faults.items.is_empty())
    };
    match checked.iter().all(passes) {
        true => Ok(()),
        false => Err(Failure::Reported(Exit::Spec)),
    }
}

fn check(path: &Path) -> Checked<'_> {
    match nsv_spec::load(path) {
        Ok((model, warnings)) => {
            let faults = Diagnostics {
                sources: model.sources.clone(),
                items: warnings,
            };
            Checked {
                path,
                model: Some(model),
                faults,
            }
        }
        Err(faults) => Checked {
            path,
            model: None,
            faults,
        },
    }
}

fn tell(checked: &Checked<'_>, format: Format, verbose: bool) -> Result<(), Failure> {
    match format {
        Format::Short => note(checked.faults.short().trim_end_matches('\n')),
        _ => show(&checked.faults),
    }
    let path = checked.path.display();
    let Some(model) = &checked.model else {
        let errors = checked
            .faults
            .items
            .iter()
            .filter(|item| item.severity == nsv_spec::diagnostic::Severity::Error)
            .count();
        note(format_args!(
            "{path}: {errors} {}",
            if errors == 1 { "error" } else { "errors" }
        ));
        return Ok(());
    };
    note(format_args!("{path}: ok, {}", size(model)));
    if verbose {
        let lines: String = model
            .defaults
            .iter()
            .map(|line| format!("{line}\n"))
            .collect();
        output::data(&lines)?;
    }
    Ok(())
}

fn size(model: &Model) -> String {
    let (blocks, inputs) = (model.blocks.len(), model.inputs.len());
    let plural = |count| if count == 1 { "" } else { "s" };
    format!(
        "{blocks} block{} of {inputs} channel{}",
        plural(blocks),
        plural(inputs)
    )
}

fn document(checked: &Checked<'_>) -> Value {
    let model = checked.model.as_ref();
    json!({
        "path": checked.path.to_string_lossy(),
        "ok": model.is_some(),
        "name": model.map(|model| &model.name),
        "hash": model.map(|model| &model.hash),
        "defaults": model.map(|model| &model.defaults),
        "diagnostics": records(&checked.faults),
    })
}
