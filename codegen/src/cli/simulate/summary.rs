//! The statistics of a campaign as a table and as JSON.

use std::fmt::Write as _;

use serde::{Serialize, Serializer};

use crate::cli::runner::Campaign;
use crate::report::number::{count, percent, short};
use crate::report::{Outcome, Plant, Quantiles};

/// The JSON document.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    spec: &'a str,
    seed: u64,
    runs: u64,
    horizon_s: f64,
    violated: Option<f64>,
    violated_interval95: Option<[f64; 2]>,
    ratio: Option<Quantiles>,
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
pub(super) fn document<'a>(
    plant: &'a Plant,
    campaign: &Campaign,
    outcome: &'a Outcome,
) -> Document<'a> {
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
        horizon_s: campaign.horizon_s,
        violated: outcome.violated,
        violated_interval95: outcome.violated_interval95,
        ratio: outcome.ratio,
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
pub(super) fn table(plant: &Plant, campaign: &Campaign, outcome: &Outcome) -> String {
    let mut rows = vec![(
        "specification",
        format!("{} ({})", plain(&plant.title), plant.name),
    )];
    rows.push((
        "campaign",
        format!(
            "{}, horizon {} s, seed {}",
            runs(campaign),
            short(campaign.horizon_s),
            campaign.seed
        ),
    ));
    rows.push(("constraint", constraint(outcome)));
    if let Some(ratio) = &outcome.ratio {
        rows.push(("error / bound", quantiles(ratio, outcome.runs)));
    }
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
    rows.push((
        "rms tracking",
        format!(
            "{}  (after {} s)",
            rms.collect::<Vec<_>>().join(", "),
            short(campaign.settle_s)
        ),
    ));
    let saturated = plant.inputs.iter().filter_map(|input| {
        let fraction = outcome
            .saturated_fraction
            .get(&input.channel.name)?
            .map_or("-".to_owned(), percent);
        Some(format!("{} {fraction}", input.channel.name))
    });
    rows.push((
        "at the limit",
        format!(
            "{}  (of the time)",
            saturated.collect::<Vec<_>>().join(", ")
        ),
    ));
    if outcome.nonfinite > 0 {
        rows.push((
            "lost",
            format!(
                "{} runs ended with a non-finite state",
                count(outcome.nonfinite)
            ),
        ));
    }
    let speed = format!(
        "{} control steps in {} s, {} per second",
        count(outcome.samples),
        short(outcome.wall_s),
        count(outcome.steps_per_s as u64)
    );
    rows.push(("speed", speed));
    let mut text = String::new();
    for (name, value) in rows {
        let _ = writeln!(text, "{name:14} {value}");
    }
    text
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

fn runs(campaign: &Campaign) -> String {
    let what = match (campaign.noise, campaign.dispersion) {
        (true, true) => "",
        (false, true) => " without noise",
        (true, false) => " without dispersion",
        (false, false) => " without noise and dispersion",
    };
    match campaign.runs {
        1 => format!("run {}{what}", campaign.first_run),
        runs => format!("{} runs{what}", count(runs)),
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
    use super::*;
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

    #[test]
    fn a_campaign_as_a_table() {
        let sample = Sample::full();
        insta::assert_snapshot!(table(&sample.plant, &CAMPAIGN, &sample.outcome));
    }

    #[test]
    fn one_run_as_a_table() {
        let sample = Sample::plain();
        let campaign = Campaign {
            runs: 1,
            first_run: 7,
            noise: false,
            ..CAMPAIGN
        };
        insta::assert_snapshot!(table(&sample.plant, &campaign, &sample.outcome));
    }

    #[test]
    fn a_campaign_as_json() {
        let sample = Sample::full();
        let text =
            serde_json::to_string_pretty(&document(&sample.plant, &CAMPAIGN, &sample.outcome))
                .unwrap();
        insta::assert_snapshot!(text);
    }
}
