//! Monte Carlo bands.

use super::{Figure, Ink, Mark, Report, Table, line, plot};
use crate::report::plant::Channel;
use crate::report::plot::Plot;

/// Figure 9: pointwise bands over the runs.
pub(super) fn figure(report: &Report<'_>, band: &Table) -> Option<Figure> {
    let mut plots = Vec::new();
    let ratio = Channel {
        name: "ratio".into(),
        unit: String::new(),
        factor: 1.0,
    };
    let bound = |rows| line("bound", Ink::Limit, vec![1.0; rows]);
    plots.extend(panel(
        band,
        "ratio1",
        "norm of the tracking error over its bound".into(),
        &ratio,
        vec![bound(band.rows())],
    ));
    let output = report.plant.blocks.first()?;
    for channel in &output.channels {
        plots.extend(panel(
            band,
            &format!("error.{}", channel.name),
            format!("tracking error of {}", channel.name),
            channel,
            Vec::new(),
        ));
    }
    for (number, block) in report
        .plant
        .blocks
        .iter()
        .enumerate()
        .map(|(i, block)| (i + 1, block))
    {
        // A bounded disturbance is the same in every run.
        for channel in block.channels.iter().filter(|_| block.exosystem) {
            let title = format!("{}: disturbance of {}", block.name, channel.name);
            plots.extend(panel(
                band,
                &format!("d{number}.{}", channel.name),
                title,
                &channel.rate(),
                Vec::new(),
            ));
        }
    }
    for input in &report.plant.inputs {
        let level = |label, sign: f64| {
            line(
                label,
                Ink::Limit,
                vec![sign * input.limit / input.channel.factor; band.rows()],
            )
        };
        let title = format!("input {}", input.channel.name);
        plots.extend(panel(
            band,
            &format!("u_sat.{}", input.channel.name),
            title,
            &input.channel,
            vec![level("limits", 1.0), level("", -1.0)],
        ));
    }
    let caption = format!(
        "Over {} runs at each instant: the whole range, the middle nine tenths, and the median.",
        report.outcome.runs
    );
    Some(Figure {
        number: 9,
        title: "Monte Carlo",
        caption,
        paired: false,
        plots,
    })
}

/// The bands of one signal, with further marks in front.
fn panel(
    band: &Table,
    signal: &str,
    title: String,
    channel: &Channel,
    marks: Vec<Mark>,
) -> Option<Plot> {
    let shown = |statistic: &str| super::shown(band, &format!("{signal}:{statistic}"), channel);
    let whole = Mark::Band {
        label: "range".into(),
        ink: Ink::Outer,
        low: shown("min")?,
        high: shown("max")?,
    };
    let middle = Mark::Band {
        label: "5-95 %".into(),
        ink: Ink::Inner,
        low: shown("p05")?,
        high: shown("p95")?,
    };
    let median = line("median", Ink::Actual, shown("p50")?);
    plot(
        band,
        title,
        &channel.unit,
        [whole, middle, median].into_iter().chain(marks).collect(),
    )
}
