//! `nsv simulate`: builds the freshly generated code and flies it.

mod progress;
mod result;
mod run_table;
mod summary;
mod sweep;
mod trajectory;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use nsv_codegen::interrupt::Scratch;
use nsv_spec::model::{MAX_RUNS, MAX_STEPS, Model};

use super::compile::{Math, Partials, compile, compose, shown};
use super::failure::{Exit, Failure};
use super::files;
use super::output::note;
use super::runner::{self, Cache, Campaign, Event, Job, Package, Part, Recordings, Replay, Work};
use super::settings::Settings;
use crate::report::Plant;
use crate::report::number::count;
use progress::Progress;

pub(super) use result::{Files, Flown, Format};
use trajectory::Kind;

/// Simulate the closed loop: statistics on standard output, signals and a report on request
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specification
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    #[command(flatten)]
    settings: Settings,
    /// Seed of noise and dispersions; default: the scenario's
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    seed: Option<u64>,
    /// Number of runs; default: the scenario's
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u64).range(1..=MAX_RUNS))]
    runs: Option<u64>,
    /// Length of a run, s; default: the scenario's
    #[arg(long, value_name = "T", allow_negative_numbers = true, value_parser = seconds)]
    horizon: Option<f64>,
    /// Write the signals of one run in SI units, as CSV or Parquet by the name's ending
    #[arg(long, value_name = "FILE.csv|.parquet", value_parser = recording)]
    out: Option<PathBuf>,
    /// Write a row for each run, in their order, as CSV or Parquet by the name's ending
    #[arg(long, value_name = "FILE.csv|.parquet", value_parser = recording)]
    runs_out: Option<PathBuf>,
    /// Write a page with figures
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// Keep what is done in FILE every few seconds; go on from it if it is there
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Simulate the K-th of N parts; `nsv merge` adds their checkpoints up
    #[arg(long, value_name = "K/N", allow_hyphen_values = true, value_parser = part, requires = "checkpoint", conflicts_with = "report")]
    shard: Option<Part>,
    /// Keep in the checkpoint what a later report shows of all runs
    #[arg(long, requires = "checkpoint")]
    bands: bool,
    /// How the statistics are written
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Leave out all noise
    #[arg(long)]
    no_noise: bool,
    /// Leave out what differs from run to run: parameters, initial states and biases of sensors take their nominal values
    #[arg(long)]
    no_dispersion: bool,
    /// Worker threads; default: one for each core. Results do not depend on it
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// What optimisation may change
    #[arg(long, value_enum, default_value_t)]
    math: Math,
    /// The run whose signals are written, counted from 0; without --runs it is the only one simulated
    #[arg(long, value_name = "K", allow_negative_numbers = true, value_parser = clap::value_parser!(u64).range(..MAX_RUNS))]
    run: Option<u64>,
}

fn seconds(text: &str) -> Result<f64, String> {
    let value: f64 = text
        .parse()
        .map_err(|_| "expected a number of seconds".to_owned())?;
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err("expected a positive number of seconds".to_owned())
    }
}

/// A file of numbers.
pub(super) fn recording(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match Kind::of(&path) {
        Some(_) => Ok(path),
        None => Err("expected a name that ends in .csv or .parquet".to_owned()),
    }
}

fn part(text: &str) -> Result<Part, String> {
    Part::parse(text).ok_or_else(|| "expected K/N with K from 1 to N".to_owned())
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let shows = args.out.is_some() || args.report.is_some();
    if let (Some(run), Some(_), false) = (args.run, args.runs, shows) {
        return Err(
            nowhere(run).with_help("name it, or leave out `--runs` to simulate this run alone")
        );
    }
    let composition = compose(&args.spec, &args.settings)?;
    let model = shown(composition.base())?;
    // Before the campaign, which may take long.
    let rows = args.runs_out.as_ref().and(args.checkpoint.as_deref());
    let rows = rows.map(beside);
    let read: Vec<&Path> = model.sources.on_disk().map(Path::new).collect();
    files::expect_places(
        &read,
        &[
            ("`--out`", args.out.as_deref()),
            ("`--runs-out`", args.runs_out.as_deref()),
            ("`--report`", args.report.as_deref()),
            ("`--checkpoint`", args.checkpoint.as_deref()),
            ("the rows beside `--checkpoint`", rows.as_deref()),
        ],
    )?;
    let variants = composition.variants();
    if !variants.is_empty() {
        return sweep::run(args, &composition, &variants);
    }
    let (campaign, run) = campaign(args, &model)?;
    let compiled = compile(&args.spec, &model, Partials::Cached, args.math)?;
    let plant = Plant::from(&model);
    let package = Package::new(&compiled.files);
    let replay = fly(&Cache::open()?, &package, &plant, &campaign, run, args)?;
    let flown = Flown {
        specification: &args.spec,
        settings: &args.settings.values,
        plant: &plant,
        campaign: &campaign,
        part: args.shard,
        math: args.math,
        shown: run,
        replay: &replay,
    };
    flown.write(Files {
        out: args.out.as_deref(),
        report: args.report.as_deref(),
    })?;
    flown.tell(args.format)
}

/// One run is chosen, but nothing shows it.
pub(super) fn nowhere(run: u64) -> Failure {
    let message = format!(
        "`--run {run}` chooses the run whose signals are written, but there is no `--out` or `--report` to write them to"
    );
    Failure::new(Exit::Usage, message)
}

/// What to simulate, and the run to show.
fn campaign(args: &Args, model: &Model) -> Result<(Campaign, u64), Failure> {
    let scenario = &model.scenario;
    if args.shard.is_some() && args.run.is_some() && args.runs.is_none() {
        let words = "`--shard` is a part of a campaign, and `--run` without `--runs` is one run";
        return Err(Failure::new(Exit::Usage, words).with_help("give the campaign's `--runs`"));
    }
    let (first_run, runs) = match (args.runs, args.run) {
        (None, Some(run)) => (run, 1),
        (runs, _) => (0, runs.unwrap_or(scenario.runs)),
    };
    let shown = args.run.unwrap_or(first_run);
    if shown - first_run >= runs {
        return Err(Failure::new(
            Exit::Usage,
            format_args!("there is no run {shown}, the {runs} runs are counted from 0"),
        ));
    }
    let horizon_s = args.horizon.unwrap_or(scenario.horizon);
    let steps = horizon_s / model.controller.sample_time * f64::from(scenario.substeps);
    if steps > MAX_STEPS {
        return Err(Failure::new(
            Exit::Usage,
            format_args!("a run has {steps:.1e} steps, expected at most {MAX_STEPS:.0e}"),
        )
        .with_help("shorten `--horizon`"));
    }
    let campaign = Campaign {
        seed: args.seed.unwrap_or(scenario.seed),
        first_run,
        runs,
        horizon_s,
        settle_s: scenario.settle,
        threads: usize::from(args.threads.unwrap_or(0)),
        noise: !args.no_noise,
        dispersion: !args.no_dispersion,
    };
    if campaign.settle_s >= campaign.horizon_s {
        let (settle, horizon) = (campaign.settle_s, campaign.horizon_s);
        note(format_args!(
            "warning: no tracking errors, since they count after {settle} s and a run lasts {horizon} s"
        ));
    }
    Ok((campaign, shown))
}

/// Builds the simulator, runs the campaign, and writes a row for each run if they are wanted.
fn fly(
    cache: &Cache,
    package: &Package,
    plant: &Plant,
    campaign: &Campaign,
    shown: u64,
    args: &Args,
) -> Result<Replay, Failure> {
    let mut progress = Progress::new();
    let program = runner::prepare(cache, package, || progress.building())?;
    let scratch = scratch(args.runs_out.as_deref())?;
    let table = args.runs_out.as_ref().map(|_| match &args.checkpoint {
        Some(checkpoint) => beside(checkpoint),
        None => scratch.path().join("runs"),
    });
    let recordings = Recordings {
        trajectory_run: (args.out.is_some() || args.report.is_some()).then_some(shown),
        band: args.report.is_some() && campaign.runs > 1,
        keep_band: args.bands,
        run_table: table.as_deref(),
    };
    let job = Job {
        program: &program,
        specification: &args.spec,
        campaign,
        work: Work::Fly {
            part: args.shard,
            checkpoint: args.checkpoint.as_deref(),
        },
        recordings,
    };
    let replay = runner::perform(&job, scratch.path(), |event| match event {
        Event::Resumed(runs) => resumed(runs, args.checkpoint.as_deref()),
        Event::Progress(done, runs) => progress.runs(done, runs),
    });
    progress.done();
    let replay = replay?;
    if let (Some(path), Some(table)) = (&args.runs_out, &table) {
        run_table::convert(table, path, &origin(plant, campaign))?;
    }
    Ok(replay)
}

/// A folder for what the simulator writes; rows of all runs, which may be many, go to the disk that they stay on.
fn scratch(runs_out: Option<&Path>) -> Result<Scratch, Failure> {
    let folder = runs_out.and_then(Path::parent);
    match folder.filter(|folder| !folder.as_os_str().is_empty()) {
        Some(folder) => {
            Scratch::new_in(folder).map_err(|error| Failure::io("write in", folder, &error))
        }
        None if runs_out.is_some() => Scratch::new_in(Path::new("."))
            .map_err(|error| Failure::io("write in", Path::new("."), &error)),
        None => {
            Scratch::new().map_err(|error| Failure::io("write in", &std::env::temp_dir(), &error))
        }
    }
}

/// The rows that belong to a checkpoint.
fn beside(checkpoint: &Path) -> PathBuf {
    let mut name = OsString::from(checkpoint);
    name.push(".runs");
    name.into()
}

fn resumed(runs: u64, checkpoint: Option<&Path>) {
    if let (1.., Some(path)) = (runs, checkpoint) {
        note(format_args!(
            "going on after {} runs in `{}`",
            count(runs),
            path.display()
        ));
    }
}

/// What a file of numbers says about where they come from.
fn origin(plant: &Plant, campaign: &Campaign) -> [(&'static str, String); 4] {
    [
        ("nsv.spec", plant.name.clone()),
        ("nsv.hash", plant.hash.clone()),
        ("nsv.seed", campaign.seed.to_string()),
        ("nsv.horizon_s", format!("{:?}", campaign.horizon_s)),
    ]
}

#[cfg(test)]
mod tests {
    use clap::Parser as _;

    use super::*;
    use crate::report::{Block, Channel, Input};

    #[derive(clap::Parser)]
    struct Line {
        #[command(flatten)]
        args: Args,
    }

    fn plant() -> Plant {
        let channel = |name: &str| Channel {
            name: name.into(),
            unit: "m".into(),
            factor: 1.0,
        };
        let block = Block {
            name: "body".into(),
            channels: vec![channel("y")],
            exosystem: false,
        };
        let input = Input {
            channel: channel("u"),
            limit: 2.0,
        };
        Plant {
            further: Vec::new(),
            name: "fixture".into(),
            title: "Fixture".into(),
            hash: "0".repeat(64),
            blocks: vec![block],
            inputs: vec![input],
        }
    }

    #[test]
    fn code_is_built_flown_and_recorded() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
        let words = [
            "simulate",
            "x.yaml",
            "--out",
            &at("run.csv"),
            "--report",
            &at("run.html"),
            "--runs-out",
            &at("runs.csv"),
        ];
        let args = Line::parse_from(words).args;
        let generated = [
            ("mod.rs".to_owned(), "pub mod simulator;\n".to_owned()),
            (
                "simulator.rs".to_owned(),
                include_str!("../../../tests/fixtures/simulator.rs").to_owned(),
            ),
        ];
        let package = Package::new(&generated.into());
        let cache = Cache::at(folder.path().join("cache")).unwrap();
        let fly = |threads| {
            let campaign = Campaign {
                seed: 3,
                first_run: 0,
                runs: 40,
                horizon_s: 5.0,
                settle_s: 1.0,
                threads,
                noise: true,
                dispersion: true,
            };
            (
                campaign,
                fly(&cache, &package, &plant(), &campaign, 2, &args).unwrap(),
            )
        };
        let (campaign, replay) = fly(2);
        assert_eq!(
            (
                replay.outcome.runs,
                replay.outcome.samples,
                replay.outcome.nonfinite
            ),
            (40, 40 * 501, 0)
        );
        let rms = replay.outcome.rms_tracking["y"].unwrap();
        assert!(
            (0.15..0.35).contains(&rms),
            "first-order lag of a sine by a gain of 4 leaves about 1/4/sqrt(2): {rms}"
        );
        assert!(replay.outcome.ratio.unwrap().max.unwrap() > 0.0);

        let flown = Flown {
            specification: Path::new("x.yaml"),
            settings: &[],
            plant: &plant(),
            campaign: &campaign,
            part: None,
            math: Math::Strict,
            shown: 2,
            replay: &replay,
        };
        let files = Files {
            out: args.out.as_deref(),
            report: args.report.as_deref(),
        };
        flown.write(files).unwrap();
        let rows = std::fs::read_to_string(at("runs.csv")).unwrap();
        assert_eq!(rows.lines().count(), 41);
        assert_eq!(
            rows.lines().next(),
            Some("run,samples,diverged,ratio,settled_ratio,rms.y,saturated.u")
        );
        assert!(rows.contains("\n39,501,false,"), "{rows}");
        let csv = std::fs::read_to_string(at("run.csv")).unwrap();
        assert!(
            csv.starts_with("t,x1.y,y_r.y,error.y,k1,ratio1,d1.y,u_sat.u\n0.0,1.0,0.0,1.0,"),
            "{}",
            &csv[..80]
        );
        let page = std::fs::read_to_string(at("run.html")).unwrap();
        for number in [5, 6, 7, 9] {
            assert!(
                page.contains(&format!("id=\"figure-{number}\"")),
                "figure {number}"
            );
        }

        let (_, alone) = fly(1);
        assert_eq!(alone.trajectory, replay.trajectory);
        assert_eq!(
            (alone.outcome.ratio, alone.outcome.rms_tracking),
            (replay.outcome.ratio, replay.outcome.rms_tracking)
        );
    }

    #[test]
    fn a_horizon_is_positive_and_finite() {
        assert_eq!(seconds("2.5"), Ok(2.5));
        for text in ["0", "-1", "inf", "nan", "2 s"] {
            assert!(seconds(text).is_err(), "{text}");
        }
    }
}
