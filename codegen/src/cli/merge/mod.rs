//! `nsv merge`: the statistics of a campaign that was flown in parts.

mod header;

use std::path::{Path, PathBuf};

use nsv_codegen::interrupt::Scratch;

use super::compile::{Math, Partials, compile, load};
use super::failure::{Exit, Failure};
use super::files;
use super::runner::{self, Cache, Campaign, Job, Package, Program, Recordings, Replay, Work};
use super::settings::Settings;
use super::simulate::{Files, Flown, Format, nowhere, recording};
use crate::report::Plant;
use header::{Header, expect_whole};

/// Add up the parts of a campaign: the same statistics as flown at once, to the last bit
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Checkpoints of all parts, in any order
    #[arg(value_name = "FILE", required = true)]
    parts: Vec<PathBuf>,
    /// Specification, if it is not where it was
    #[arg(long, value_name = "SPEC")]
    spec: Option<PathBuf>,
    #[command(flatten)]
    settings: Settings,
    /// Write the signals of one run in SI units, as CSV or Parquet by the name's ending
    #[arg(long, value_name = "FILE.csv|.parquet", value_parser = recording)]
    out: Option<PathBuf>,
    /// Write a page with figures; those over all runs need parts flown with --bands
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// The run whose signals are written; default: the first
    #[arg(long, value_name = "K")]
    run: Option<u64>,
    /// How the statistics are written
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    if let (Some(run), None, None) = (args.run, &args.out, &args.report) {
        return Err(nowhere(run));
    }
    let headers: Vec<Header> = args
        .parts
        .iter()
        .map(|path| Header::read(path))
        .collect::<Result<_, _>>()?;
    expect_whole(&headers)?;
    let header = headers.first().expect("invariant: clap demands a file");
    let specification = args.spec.as_ref().unwrap_or(&header.specification);
    let parts = args.parts.iter().map(|path| path.as_path());
    let read: Vec<&Path> = parts.chain([specification.as_path()]).collect();
    files::expect_places(
        &read,
        &[
            ("`--out`", args.out.as_deref()),
            ("`--report`", args.report.as_deref()),
        ],
    )?;
    if !specification.exists() {
        let words = format!(
            "the specification is no longer at `{}`",
            specification.display()
        );
        return Err(Failure::new(Exit::Usage, words).with_help("name its file with `--spec`"));
    }
    let shown = shown(args.run, &header.campaign)?;
    let (plant, math, program) = simulator(specification, &args.settings, header)?;
    let replay = merge(args, specification, header, &program, shown)?;
    let flown = Flown {
        specification,
        settings: &args.settings.values,
        plant: &plant,
        campaign: &header.campaign,
        part: None,
        math,
        shown,
        replay: &replay,
    };
    flown.write(Files {
        out: args.out.as_deref(),
        report: args.report.as_deref(),
    })?;
    flown.tell(args.format)
}

/// The run whose signals are written.
fn shown(wanted: Option<u64>, campaign: &Campaign) -> Result<u64, Failure> {
    let run = wanted.unwrap_or(campaign.first_run);
    let place = run.checked_sub(campaign.first_run);
    match place.filter(|place| *place < campaign.runs) {
        Some(_) => Ok(run),
        None => Err(Failure::new(
            Exit::Usage,
            format_args!(
                "there is no run {run}, the {} runs are counted from {}",
                campaign.runs, campaign.first_run
            ),
        )),
    }
}

/// The simulator that flew the parts, and the arithmetic that it was compiled with.
fn simulator(
    specification: &Path,
    settings: &Settings,
    header: &Header,
) -> Result<(Plant, Math, Program), Failure> {
    let model = load(specification, settings)?;
    let cache = Cache::open()?;
    for math in [Math::Strict, Math::Fast] {
        let compiled = compile(specification, &model, Partials::Cached, math)?;
        let package = Package::new(&compiled.files);
        if runner::key(&cache, &package)? == header.simulator {
            let program = runner::prepare(&cache, &package, || {})?;
            return Ok((Plant::from(&model), math, program));
        }
    }
    let words = format!(
        "`{}` is not what the parts were flown with",
        specification.display()
    );
    Err(Failure::new(Exit::Usage, words).with_help(
        "give the `--set` that they were flown with; else the specification (its name or its text, comments included), nsv or the Rust compiler has changed since, or `--math` was another",
    ))
}

fn merge(
    args: &Args,
    specification: &Path,
    header: &Header,
    program: &Program,
    shown: u64,
) -> Result<Replay, Failure> {
    let job = Job {
        program,
        specification,
        campaign: &header.campaign,
        work: Work::Merge(&args.parts),
        recordings: Recordings {
            trajectory_run: (args.out.is_some() || args.report.is_some()).then_some(shown),
            band: args.report.is_some() && header.band,
            keep_band: header.band,
            run_table: None,
        },
    };
    let scratch =
        Scratch::new().map_err(|error| Failure::io("write in", &std::env::temp_dir(), &error))?;
    runner::perform(&job, scratch.path(), |_| {})
}
