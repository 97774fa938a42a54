//! The statistics of a campaign as a table and as JSON.

use std::fmt::Write as _;

use serde::{Serialize, Serializer};

use super::Flown;
use crate::cli::runner::{Campaign, Part};
use crate::report::number::{count, percent, short};
use crate::report::{Outcome, Plant, Quantiles, WorstRun};

/// The JSON document.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    spec: &'a str,
    seed: u64,
    runs: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    shard: Option<Part>,
    horizon_s: f64,
    violations: Option<u64>,
    violated: Option<f64>,
    violated_interval95: Option<[f64; 2]>,
    ratio: Option<Quantiles>,
    settled_ratio: Option<Quantiles>,
    worst: &'a [WorstRun],
    replay_worst: Option<String>,
    rms_tracking: ByName<'a>,
    saturated_fraction: ByName<'a>,
    nonfinite: u64,
    wall_s: f64,
    steps_per_s: f64,
}

/// Values by name, in the order of the specification.
struct ByName<'a>(Vec<(&'a str, Option<f64>)>);

impl Serialize for ByName<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

/// The statistics for programs, SI.
pub(super) fn document<'a>(flown: &Flown<'a>) -> Document<'a> {
    let (plant, campaign, outcome) = (flown.plant, flown.campaign, &flown.replay.outcome);
    let outputs = plant
        .blocks
        .first()
        .map_or(&[][..], |block| &block.channels);
    let rms = outputs.iter().map(|channel| {
        (
            channel.name.as_str(),
            outcome.rms_tracking.get(&channel.name).copied().flatten(),
        )
    });
    let inputs = plant.inputs.iter().map(|input| input.channel.name.as_str());
    Document {
        spec: &plant.name,
        seed: campaign.seed,
        runs: outcome.runs,
        shard: flown.part,
        horizon_s: campaign.horizon_s,
        violations: outcome.violations,
        violated: outcome.violated,
        violated_interval95: outcome.violated_interval95,
        ratio: outcome.ratio,
        settled_ratio: outcome.settled_ratio,
        worst: &outcome.worst,
        replay_worst: outcome
            .worst
            .first()
            .map(|worst| flown.replay_command(worst.run)),
        rms_tracking: ByName(rms.collect()),
        saturated_fraction: ByName(
            inputs
                .map(|name| {
                    (
                        name,
                        outcome.saturated_fraction.get(name).copied().flatten(),
                    )
                })
                .collect(),
        ),
        nonfinite: outcome.nonfinite,
        wall_s: outcome.wall_s,
        steps_per_s: outcome.steps_per_s,
    }
}

/// The statistics for people, in display units.
pub(super) fn table(flown: &Flown<'_>) -> String {
    let (plant, campaign, outcome) = (flown.plant, flown.campaign, &flown.replay.outcome);
    let mut rows = vec![
        (
            "specification",
            format!("{} ({})", plain(&plant.title), plant.name),
        ),
        (
            "campaign",
            format!(
                "{}, horizon {} s, seed {}",
                runs(campaign, flown.part, outcome.runs),
                short(campaign.horizon_s),
                campaign.seed
            ),
        ),
        ("constraint", constraint(outcome)),
    ];
    if let Some(ratio) = &outcome.ratio {
        rows.push(("error / bound", quantiles(ratio, outcome.runs)));
    }
    if let Some(ratio) = &outcome.settled_ratio
        && campaign.settle_s > 0.0
    {
        let shown = quantiles(ratio, outcome.runs);
        rows.push((
            "",
            format!("{shown}  (after {} s)", short(campaign.settle_s)),
        ));
    }
    if let (2.., Some(shown)) = (outcome.runs, worst(&outcome.worst)) {
        rows.push(("worst runs", shown));
    }
    rows.push(("rms tracking", rms(plant, campaign, outcome)));
    rows.push(("at the limit", saturated(plant, outcome)));
    if outcome.nonfinite > 0 {
        rows.push((
            "lost",
            match outcome.nonfinite {
                1 => "1 run ended with a non-finite state".to_owned(),
                lost => format!("{} runs ended with a non-finite state", count(lost)),
            },
        ));
    }
    rows.push(("speed", speed(outcome)));
    let mut text = String::new();
    for (name, value) in rows {
        let _ = writeln!(text, "{name:14} {value}");
    }
    text
}

/// The first of the worst runs, and how to see one.
fn worst(worst: &[WorstRun]) -> Option<String> {
    let first = worst.first()?;
    let shown = worst.iter().take(5).map(|worst| match worst.ratio {
        _ if worst.diverged => format!("{} (lost)", worst.run),
        ratio => format!(
            "{} ({})",
            worst.run,
            ratio.map_or("not finite".into(), short)
        ),
    });
    let shown: Vec<String> = shown.collect();
    Some(format!(
        "{}  (fly one again with `--run {}` in place of `--runs`)",
        shown.join(", "),
        first.run
    ))
}

fn rms(plant: &Plant, campaign: &Campaign, outcome: &Outcome) -> String {
    let outputs = plant
        .blocks
        .first()
        .map_or(&[][..], |block| &block.channels);
    let rms = outputs.iter().filter_map(|channel| {
        let rms = outcome
            .rms_tracking
            .get(&channel.name)?
            .map_or("-".to_owned(), |rms| short(rms / channel.factor));
        Some(
            format!("{} {rms} {}", channel.name, unit(&channel.unit))
                .trim_end()
                .to_owned(),
        )
    });
    let until = match outcome.nonfinite {
        0 => "",
        _ => ", of lost runs until they were lost",
    };
    format!(
        "{}  (after {} s{until})",
        rms.collect::<Vec<_>>().join(", "),
        short(campaign.settle_s)
    )
}

fn saturated(plant: &Plant, outcome: &Outcome) -> String {
    let saturated = plant.inputs.iter().filter_map(|input| {
        let fraction = outcome
            .saturated_fraction
            .get(&input.channel.name)?
            .map_or("-".to_owned(), percent);
        Some(format!("{} {fraction}", input.channel.name))
    });
    format!(
        "{}  (of the time)",
        saturated.collect::<Vec<_>>().join(", ")
    )
}

fn speed(outcome: &Outcome) -> String {
    format!(
        "{} control steps in {} s, {} per second",
        count(outcome.samples),
        short(outcome.wall_s),
        count(outcome.steps_per_s as u64)
    )
}

/// A title on one line of a terminal: what would move the cursor or turn the writing direction is left out.
fn plain(title: &str) -> String {
    let shown = |c: char| !matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}');
    let text = title
        .replace(char::is_control, " ")
        .replace(|c| !shown(c), " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The unit of a pure number is not shown.
fn unit(unit: &str) -> &str {
    if unit == "1" { "" } else { unit }
}

fn runs(campaign: &Campaign, part: Option<Part>, done: u64) -> String {
    let what = match (campaign.noise, campaign.dispersion) {
        (true, true) => "",
        (false, true) => " without noise",
        (true, false) => " without dispersion",
        (false, false) => " without noise and dispersion",
    };
    match (campaign.runs, part) {
        (1, _) => format!("run {}{what}", campaign.first_run),
        (runs, None) => format!("{} runs{what}", count(runs)),
        (runs, Some(Part { part, of })) => format!(
            "part {part} of {of}, {} of {} runs{what}",
            count(done),
            count(runs)
        ),
    }
}

fn constraint(outcome: &Outcome) -> String {
    let interval = match outcome.violated_interval95 {
        Some([low, high]) if outcome.runs > 1 => {
            format!(" (95 % interval {} to {})", percent(low), percent(high))
        }
        _ => String::new(),
    };
    match (outcome.violated, outcome.runs) {
        (_, 0) => "no run in this part".to_owned(),
        (None, _) => "none declared".to_owned(),
        (Some(0.0), 1) => "held".to_owned(),
        (Some(_), 1) => "violated".to_owned(),
        (Some(0.0), runs) => format!("held in all {} runs{interval}", count(runs)),
        (Some(violated), _) => format!("violated in {} of the runs{interval}", percent(violated)),
    }
}

fn quantiles(ratio: &Quantiles, runs: u64) -> String {
    let shown = |quantile: Option<f64>| quantile.map_or("not finite".to_owned(), short);
    match runs {
        1 => format!("{} at its largest", shown(ratio.max)),
        _ => {
            let all = [
                ("median", ratio.median),
                ("90 %", ratio.p90),
                ("99 %", ratio.p99),
                ("max", ratio.max),
            ];
            all.map(|(name, quantile)| format!("{name} {}", shown(quantile)))
                .join(", ")
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::cli::compile::Math;
    use crate::cli::runner::Replay;
    use crate::report::sample::Sample;

    const CAMPAIGN: Campaign = Campaign {
        seed: 1,
        first_run: 0,
        runs: 500,
        horizon_s: 20.0,
        settle_s: 4.5,
        threads: 0,
        noise: true,
        dispersion: true,
    };

    #[test]
    fn a_title_cannot_command_the_terminal() {
        let title = "\u{1b}]0;a\u{7}\nb\r\u{202e}c\u{9b}31m  d";
        assert_eq!(plain(title), "]0;a b c 31m d");
    }

    /// What `shown` makes of a sample.
    fn shown<T>(
        sample: &Sample,
        campaign: &Campaign,
        part: Option<Part>,
        shown: impl Fn(&Flown<'_>) -> T,
    ) -> T {
        let replay = Replay {
            outcome: sample.outcome.clone(),
            trajectory: None,
            band: None,
        };
        shown(&Flown {
            specification: Path::new("specs/sample.yaml"),
            settings: &["controller.norm=spectral".to_owned()],
            plant: &sample.plant,
            campaign,
            part,
            math: Math::Strict,
            shown: 0,
            replay: &replay,
        })
    }

    #[test]
    fn a_campaign_as_a_table() {
        insta::assert_snapshot!(shown(&Sample::full(), &CAMPAIGN, None, table));
    }

    #[test]
    fn one_run_as_a_table() {
        let campaign = Campaign {
            runs: 1,
            first_run: 7,
            noise: false,
            ..CAMPAIGN
        };
        insta::assert_snapshot!(shown(&Sample::plain(), &campaign, None, table));
    }

    #[test]
    fn a_part_says_what_it_is_part_of() {
        let mut sample = Sample::full();
        sample.outcome.worst[0] = WorstRun {
            run: 3,
            ratio: None,
            diverged: true,
        };
        let campaign = Campaign {
            runs: 1_000_000,
            ..CAMPAIGN
        };
        let text = shown(&sample, &campaign, Part::parse("2/8"), table);
        assert!(
            text.contains("part 2 of 8, 500 of 1 000 000 runs, horizon"),
            "{text}"
        );
        assert!(text.contains("3 (lost), 12 (1.9), 401 (1.31)"), "{text}");
    }

    #[test]
    fn a_campaign_as_json() {
        let json = |flown: &Flown<'_>| serde_json::to_string_pretty(&document(flown)).unwrap();
        insta::assert_snapshot!(shown(&Sample::full(), &CAMPAIGN, None, json));
    }
}
