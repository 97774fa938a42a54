//! The verdict and the table at the head of the page.

use std::fmt::Write as _;

use super::html::{escape, number, percent, unit};
use super::{Outcome, Quantiles, Report};

/// One sentence: was the constraint held?
pub(super) fn verdict(outcome: &Outcome) -> (&'static str, String) {
    let runs = match outcome.runs {
        1 => "the run".to_owned(),
        runs => format!("all {runs} runs"),
    };
    let interval = match outcome.violated_interval95 {
        Some([low, high]) if outcome.runs > 1 => format!(
            " (95&nbsp;% interval {} to {})",
            percent(low),
            percent(high)
        ),
        _ => String::new(),
    };
    match outcome.violated {
        None if outcome.nonfinite > 0 => (
            "bad",
            format!(
                "{} of {} runs lost: the state became non-finite.",
                outcome.nonfinite, outcome.runs
            ),
        ),
        None => (
            "good",
            "Every run stayed finite; the specification declares no output constraint.".to_owned(),
        ),
        Some(0.0) => (
            "good",
            format!("The output constraint was held in {runs}{interval}."),
        ),
        Some(_) if outcome.runs == 1 => ("bad", "The output constraint was violated.".to_owned()),
        Some(violated) => (
            "bad",
            format!(
                "The output constraint was violated in {} of {} runs{interval}.",
                percent(violated),
                outcome.runs
            ),
        ),
    }
}

fn quantiles(ratio: &Quantiles, runs: u64) -> String {
    let all = [
        ("median", ratio.median),
        ("90 %", ratio.p90),
        ("99 %", ratio.p99),
        ("max", ratio.max),
    ];
    match runs {
        1 => value(ratio.max),
        _ => all
            .map(|(name, quantile)| format!("{name}&nbsp;{}", value(quantile)))
            .join(", "),
    }
}

/// The table of statistics.
pub(super) fn table(report: &Report<'_>) -> String {
    let outcome = report.outcome;
    let mut rows: Vec<(String, String)> = Vec::new();
    if let Some(ratio) = &outcome.ratio {
        let shown = quantiles(ratio, outcome.runs);
        rows.push(("largest ratio of error norm to bound".into(), shown));
    }
    let settle = report.settle_s;
    if let Some(ratio) = outcome.settled_ratio.as_ref().filter(|_| settle > 0.0) {
        let name = format!("the same after {}&nbsp;s", number(settle));
        rows.push((name, quantiles(ratio, outcome.runs)));
    }
    if outcome.runs > 1 && !outcome.worst.is_empty() {
        let worst = outcome.worst.iter().map(|worst| match worst.ratio {
            _ if worst.diverged => format!("{}&nbsp;(lost)", worst.run),
            ratio => format!("{}&nbsp;({})", worst.run, value(ratio)),
        });
        let shown = worst.collect::<Vec<_>>().join(", ");
        rows.push(("worst runs, with their ratio".into(), shown));
    }
    for channel in report
        .plant
        .blocks
        .first()
        .map_or(&[][..], |block| &block.channels)
    {
        if let Some(rms) = outcome.rms_tracking.get(&channel.name) {
            let shown = rms.map(|rms| rms / channel.factor);
            let label = format!(
                "rms tracking error of {} after {}&nbsp;s",
                escape(&channel.name),
                number(report.settle_s)
            );
            rows.push((label, format!("{} {}", value(shown), unit(&channel.unit))));
        }
    }
    for input in &report.plant.inputs {
        if let Some(Some(fraction)) = outcome.saturated_fraction.get(&input.channel.name) {
            let limit = format!(
                "{} {}",
                number(input.limit / input.channel.factor),
                unit(&input.channel.unit)
            );
            let label = format!(
                "time of {} at its limit of {limit}",
                escape(&input.channel.name)
            );
            rows.push((label, percent(*fraction)));
        }
    }
    if outcome.nonfinite > 0 {
        rows.push((
            "runs with a non-finite state".into(),
            outcome.nonfinite.to_string(),
        ));
    }
    let mut out = "<table>".to_owned();
    for (label, shown) in rows {
        let _ = write!(
            out,
            "<tr><th scope=\"row\">{label}</th><td>{shown}</td></tr>"
        );
    }
    out + "</table>"
}

fn value(quantity: Option<f64>) -> String {
    number(quantity.unwrap_or(f64::NAN))
}
