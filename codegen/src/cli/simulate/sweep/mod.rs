//! A campaign for each variant of a sweep, and one table of them all.

mod table;

use nsv_codegen::interrupt::Scratch;
use nsv_spec::compose::{Composition, Variant};
use nsv_spec::model::Model;
use serde::Serialize;

use super::progress::Progress;
use super::summary::{Document, document};
use super::{Args, Flown, Format, campaign};
use crate::cli::compile::{Partials, compile, shown};
use crate::cli::failure::{Exit, Failure};
use crate::cli::files;
use crate::cli::output::{self, note};
use crate::cli::runner::{self, Cache, Campaign, Event, Job, Package, Recordings, Replay, Work};
use crate::report::Plant;

/// A variant and what came of it.
struct Row<'a> {
    variant: &'a Variant,
    /// Values that were set, those of the variant last.
    settings: Vec<String>,
    plant: Plant,
    campaign: Campaign,
    replay: Replay,
}

/// Checks every variant, flies one after the other, and writes the table.
pub(super) fn run(
    args: &Args,
    composition: &Composition,
    variants: &[Variant],
) -> Result<(), Failure> {
    expect_statistics_only(args)?;
    let checked = variants
        .iter()
        .map(|variant| shown(composition.variant(variant)));
    let models: Vec<Model> = checked.collect::<Result<_, _>>()?;
    let cache = Cache::open()?;
    let mut rows = Vec::new();
    for (at, (variant, model)) in (1..).zip(variants.iter().zip(&models)) {
        note(format_args!(
            "variant {at} of {}: {}",
            variants.len(),
            variant.settings().join(", ")
        ));
        rows.push(fly(args, &cache, variant, model)?);
    }
    if let Some(path) = &args.out {
        files::replace(&[(path.clone(), &table::csv(&rows)?)], &[])?;
    }
    match args.format {
        Format::Human => output::data(&table::human(&rows)),
        Format::Json => output::json(&Sweep {
            variants: rows.iter().map(|row| entry(args, row)).collect(),
        }),
    }
}

/// Options that are about one campaign have no meaning for many.
fn expect_statistics_only(args: &Args) -> Result<(), Failure> {
    let given = [
        ("--runs-out", args.runs_out.is_some()),
        ("--report", args.report.is_some()),
        ("--checkpoint", args.checkpoint.is_some()),
        ("--run", args.run.is_some()),
    ];
    let one = "choose a variant with `--set` for each swept key, or fly without: `--set scenario.sweep=~`";
    if let Some((name, _)) = given.iter().find(|(_, given)| *given) {
        let message = format!("`{name}` is for one variant, but the specification has a sweep");
        return Err(Failure::new(Exit::Usage, message).with_help(one));
    }
    match args.out.as_ref().and_then(|path| path.extension()) {
        Some(ending) if ending.eq_ignore_ascii_case("parquet") => {
            let message = "`--out` of a sweep is a table of its variants, written as CSV only";
            Err(Failure::new(Exit::Usage, message).with_help("give a name that ends in .csv"))
        }
        _ => Ok(()),
    }
}

fn fly<'a>(
    args: &Args,
    cache: &Cache,
    variant: &'a Variant,
    model: &Model,
) -> Result<Row<'a>, Failure> {
    let (campaign, _) = campaign(args, model)?;
    let compiled = compile(&args.spec, model, Partials::Cached, args.math)?;
    let package = Package::new(&compiled.files);
    let mut progress = Progress::new();
    let program = runner::prepare(cache, &package, || progress.building())?;
    let scratch =
        Scratch::new().map_err(|error| Failure::io("write in", &std::env::temp_dir(), &error))?;
    let job = Job {
        program: &program,
        specification: &args.spec,
        campaign: &campaign,
        work: Work::Fly {
            part: None,
            checkpoint: None,
        },
        recordings: Recordings::default(),
    };
    let replay = runner::perform(&job, scratch.path(), |event| {
        if let Event::Progress(done, runs) = event {
            progress.runs(done, runs);
        }
    });
    progress.done();
    let mut settings = args.settings.values.clone();
    settings.extend(variant.settings());
    Ok(Row {
        variant,
        settings,
        plant: Plant::from(model),
        campaign,
        replay: replay?,
    })
}

/// The JSON document.
#[derive(Serialize)]
struct Sweep<'a> {
    variants: Vec<Entry<'a>>,
}

#[derive(Serialize)]
struct Entry<'a> {
    values: serde_json::Map<String, serde_json::Value>,
    #[serde(flatten)]
    statistics: Document<'a>,
}

fn entry<'a>(args: &'a Args, row: &'a Row<'_>) -> Entry<'a> {
    let values = row.variant.values.iter();
    let flown = Flown {
        specification: &args.spec,
        settings: &row.settings,
        plant: &row.plant,
        campaign: &row.campaign,
        part: None,
        math: args.math,
        shown: row.campaign.first_run,
        replay: &row.replay,
    };
    Entry {
        values: values
            .map(|(path, value)| (path.clone(), value.as_str().into()))
            .collect(),
        statistics: document(&flown),
    }
}
