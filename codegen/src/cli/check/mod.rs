//! `nsv check`: every fault of a specification.

mod fix;
mod sarif;

use std::path::{Path, PathBuf};

use nsv_spec::compose::Composition;
use nsv_spec::diagnostic::{Diagnostic, Diagnostics};
use nsv_spec::model::Model;
use serde_json::{Value, json};

use super::compile::show;
use super::failure::{Exit, Failure};
use super::output::{self, note};
use super::render::{more, records};
use super::settings::Settings;

/// Check specifications: names, units, shapes, ranges; every fault at once, with its place
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specifications to check
    #[arg(required = true, value_name = "SPEC")]
    specs: Vec<PathBuf>,
    #[command(flatten)]
    settings: Settings,
    /// List the defaults that were filled in; JSON always has them
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
    /// The values of a sweep, if it is not the specification itself.
    variant: Option<String>,
    model: Option<Model>,
    faults: Diagnostics,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if args.verbose && args.format == Format::Sarif {
        let failure = Failure::new(
            Exit::Usage,
            "SARIF has no place for the defaults that `--verbose` lists",
        );
        return Err(failure.with_help("leave out `--verbose`, or choose another `--format`"));
    }
    let mut checked: Vec<Checked<'_>> = Vec::new();
    for path in &args.specs {
        checked.extend(match args.fix {
            true => fix::run(path, &args.settings)?,
            false => check(path, &args.settings),
        });
    }
    match args.format {
        Format::Json => {
            output::json(&json!({ "specs": checked.iter().map(document).collect::<Vec<_>>() }))?
        }
        Format::Sarif => output::json(&sarif::log(checked.iter().map(|one| &one.faults)))?,
        format => tell_all(&checked, format, args.verbose)?,
    }
    let passes = |one: &Checked<'_>| {
        one.model.is_some() && (!args.deny_warnings || one.faults.items.is_empty())
    };
    match checked.iter().all(passes) {
        true => Ok(()),
        false => Err(Failure::Reported(Exit::Spec)),
    }
}

/// The specification itself and each variant of its sweep, of which only what was not said before is told.
fn check<'a>(path: &'a Path, settings: &Settings) -> Vec<Checked<'a>> {
    let composition = match Composition::read(path, &settings.values) {
        Ok(composition) => composition,
        Err(faults) => return vec![checked(path, None, Err(faults))],
    };
    let mut all = vec![checked(path, None, composition.base())];
    let mut known = all[0].faults.items.clone();
    for variant in composition.variants() {
        let values = variant.settings().join(", ");
        let mut one = checked(path, Some(values), composition.variant(&variant));
        one.faults.items.retain(|item| !known.contains(item));
        if one.model.is_some() || !one.faults.items.is_empty() {
            known.extend(one.faults.items.iter().cloned());
            all.push(one);
        }
    }
    all
}

fn checked<'a>(
    path: &'a Path,
    variant: Option<String>,
    outcome: Result<(Model, Vec<Diagnostic>), Diagnostics>,
) -> Checked<'a> {
    let (model, faults) = match outcome {
        Ok((model, items)) => {
            let sources = model.sources.clone();
            (Some(model), Diagnostics { sources, items })
        }
        Err(faults) => (None, faults),
    };
    Checked {
        path,
        variant,
        model,
        faults,
    }
}

/// Tells the user of every specification; of a sweep in which all is well in one line.
fn tell_all(checked: &[Checked<'_>], format: Format, verbose: bool) -> Result<(), Failure> {
    let variants = |path: &Path| {
        let variants = checked.iter().filter(|one| one.variant.is_some());
        variants.filter(|one| one.path == path).collect::<Vec<_>>()
    };
    for one in checked {
        let swept = variants(one.path);
        let quiet = (swept.iter()).all(|one| one.model.is_some() && one.faults.items.is_empty());
        if one.variant.is_some() && quiet {
            continue;
        }
        tell(one, format, verbose)?;
        if quiet && !swept.is_empty() {
            let path = one.path.display();
            note(format_args!(
                "{path}: ok with every value of its sweep ({})",
                counted(swept.len(), "combination")
            ));
        }
    }
    let faults = checked.iter().flat_map(|one| &one.faults.items);
    if let Some(line) = more(faults).filter(|_| format == Format::Human) {
        note(line);
    }
    Ok(())
}

fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

fn tell(checked: &Checked<'_>, format: Format, verbose: bool) -> Result<(), Failure> {
    match format {
        Format::Short => note(checked.faults.short().trim_end_matches('\n')),
        _ => show(&checked.faults),
    }
    let path = match &checked.variant {
        Some(variant) => format!("{} with {variant}", checked.path.display()),
        None => checked.path.display().to_string(),
    };
    let Some(model) = &checked.model else {
        let errors = checked
            .faults
            .items
            .iter()
            .filter(|item| item.severity == nsv_spec::diagnostic::Severity::Error)
            .count();
        note(format_args!("{path}: {}", counted(errors, "error")));
        return Ok(());
    };
    note(format_args!("{path}: ok, {}", size(model)));
    if verbose && checked.variant.is_none() {
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
    format!(
        "{} of {}",
        counted(blocks, "block"),
        counted(inputs, "channel")
    )
}

fn document(checked: &Checked<'_>) -> Value {
    let model = checked.model.as_ref();
    json!({
        "path": checked.path.to_string_lossy(),
        "variant": checked.variant,
        "ok": model.is_some(),
        "name": model.map(|model| &model.name),
        "hash": model.map(|model| &model.hash),
        "defaults": model.map(|model| &model.defaults),
        "diagnostics": records(&checked.faults),
    })
}
