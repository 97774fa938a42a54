//! Outputs with their references.

use super::{Figure, Ink, Report, line, plot, shown};

/// Figure 5: each output follows its reference.
pub(super) fn figure(report: &Report<'_>) -> Option<Figure> {
    let table = report.trajectory;
    let output = report.plant.blocks.first()?;
    let plots = output.channels.iter().filter_map(|channel| {
        let y = shown(table, &format!("x1.{}", channel.name), channel)?;
        let reference = shown(table, &format!("y_r.{}", channel.name), channel);
        let reference = reference.map(|reference| line("reference", Ink::Reference, reference));
        let measured = shown(table, &format!("y.{}", channel.name), channel);
        let measured = measured.map(|measured| line("measured", Ink::Estimate, measured));
        let marks = measured
            .into_iter()
            .chain([line(&channel.name, Ink::Actual, y)])
            .chain(reference)
            .collect();
        plot(
            table,
            format!("{}: tracking of {}", output.name, channel.name),
            &channel.unit,
            marks,
        )
    });
    let caption = "Each output and the reference that it is to follow.".to_owned();
    Some(Figure {
        number: 5,
        title: "Tracking",
        caption,
        paired: false,
        plots: plots.collect(),
    })
}
