//! `nsv simulate`: builds the freshly generated code and flies it.

mod progress;
mod summary;
mod trajectory;

use std::path::PathBuf;

use nsv_codegen::interrupt::Scratch;
use nsv_spec::model::{MAX_STEPS, Model};

use super::compile::{Math, Partials, compile, load};
use super::failure::{Exit, Failure};
use super::files;
use super::output::{self, note};
use super::runner::{self, Cache, Campaign, Package, Recordings, Replay};
use crate::report::{Plant, Report, page};
use progress::Progress;

/// Simulate the closed loop: statistics on standard output, signals and a report on request
#[derive(clap::Args)]
pub(crate) struct Args {
    /// Specification
    #[arg(value_name = "SPEC")]
    spec: PathBuf,
    /// Seed of noise and dispersions; default: the scenario's
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Number of runs; default: the scenario's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    runs: Option<u64>,
    /// Length of a run, s; default: the scenario's
    #[arg(long, value_name = "T", allow_negative_numbers = true, value_parser = seconds)]
    horizon: Option<f64>,
    /// Write the signals of one run in SI units, as CSV or Parquet by the name's ending
    #[arg(long, value_name = "FILE.csv|.parquet", value_parser = recording)]
    out: Option<PathBuf>,
    /// Write a page with figures
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// How the statistics are written
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Leave out all noise
    #[arg(long)]
    no_noise: bool,
    /// Give every plant parameter its nominal value
    #[arg(long)]
    no_dispersion: bool,
    /// Worker threads; default: one for each core. Results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// What optimisation may change
    #[arg(long, value_enum, default_value_t)]
    math: Math,
    /// The run whose signals are written, counted from 0; without --runs it is the only one simulated
    #[arg(long, value_name = "K")]
    run: Option<u64>,
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// A table
    Human,
    /// One JSON document
    Json,
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

fn recording(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match trajectory::Kind::of(&path) {
        Some(_) => Ok(path),
        None => Err("expected a name that ends in .csv or .parquet".to_owned()),
    }
}

/// Runs the verb.
pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let model = load(&args.spec)?;
    // Before the campaign, which may take long.
    for path in [&args.out, &args.report].into_iter().flatten() {
        files::expect_folder(path)?;
    }
    let (campaign, shown) = campaign(args, &model)?;
    let compiled = compile(&args.spec, &model, Partials::Cached, args.math)?;
    let plant = Plant::from(&model);
    let replay = fly(
        &Cache::open()?,
        &Package::new(&compiled.files),
        &campaign,
        shown,
        args,
    )?;
    record(args, &plant, &campaign, shown, &replay)?;
    match args.format {
        Format::Human => output::data(&summary::table(&plant, &campaign, &replay.outcome)),
        Format::Json => output::json(&summary::document(&plant, &campaign, &replay.outcome)),
    }
}

/// What to simulate, and the run to show.
fn campaign(args: &Args, model: &Model) -> Result<(Campaign, u64), Failure> {
    let scenario = &model.scenario;
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

/// Builds the simulator and runs the campaign.
fn fly(
    cache: &Cache,
    package: &Package,
    campaign: &Campaign,
    shown: u64,
    args: &Args,
) -> Result<Replay, Failure> {
    let progress = Progress::new();
    let program = runner::prepare(cache, package, || progress.building())?;
    let recordings = Recordings {
        trajectory_run: (args.out.is_some() || args.report.is_some()).then_some(shown),
        band: args.report.is_some() && campaign.runs > 1,
    };
    let scratch =
        Scratch::new().map_err(|error| Failure::io("write in", &std::env::temp_dir(), &error))?;
    let replay = runner::simulate(&program, campaign, recordings, scratch.path(), |done| {
        progress.runs(done, campaign.runs)
    });
    progress.done();
    replay
}

/// Writes the files that were asked for.
fn record(
    args: &Args,
    plant: &Plant,
    campaign: &Campaign,
    shown: u64,
    replay: &Replay,
) -> Result<(), Failure> {
    let Some(trajectory) = &replay.trajectory else {
        return Ok(());
    };
    if let Some(path) = &args.out {
        let origin = [
            ("nsv.spec", plant.name.clone()),
            ("nsv.hash", plant.hash.clone()),
            ("nsv.seed", campaign.seed.to_string()),
            ("nsv.run", shown.to_string()),
        ];
        trajectory::write(path, trajectory, &origin)?;
    }
    if let Some(path) = &args.report {
        let text = page(&Report {
            plant,
            command: &command(
                std::env::args_os()
                    .skip(1)
                    .map(|word| word.to_string_lossy().into_owned()),
            ),
            seed: campaign.seed,
            horizon_s: campaign.horizon_s,
            settle_s: campaign.settle_s,
            trajectory_run: shown,
            outcome: &replay.outcome,
            trajectory,
            band: replay.band.as_ref(),
        });
        files::replace(&[(path.clone(), &text)], &[])?;
    }
    Ok(())
}

/// The command as it would be typed into a shell.
fn command(words: impl Iterator<Item = String>) -> String {
    let plain = |word: &str| {
        !word.is_empty()
            && word
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || "-_./=+:,@%".contains(c))
    };
    let quoted = words.map(|word| {
        if plain(&word) {
            word
        } else {
            format!("'{}'", word.replace('\'', r"'\''"))
        }
    });
    std::iter::once("nsv".to_owned())
        .chain(quoted)
        .collect::<Vec<_>>()
        .join(" ")
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
                fly(&cache, &package, &campaign, 2, &args).unwrap(),
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

        record(&args, &plant(), &campaign, 2, &replay).unwrap();
        let csv = std::fs::read_to_string(at("run.csv")).unwrap();
        assert!(
            csv.starts_with("t,x1.y,y_r.y,e1.y,k1,ratio1,d1.y,u_sat.u\n0.0,1.0,0.0,1.0,"),
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
    fn the_command_can_be_pasted() {
        let words = ["simulate", "a b.yaml", "--report", "it's.html", ""].map(str::to_owned);
        assert_eq!(
            command(words.into_iter()),
            r"nsv simulate 'a b.yaml' --report 'it'\''s.html' ''"
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
