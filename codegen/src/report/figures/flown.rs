//! What the flown plant has beyond the blocks.

use super::{Figure, Ink, Report, line, plot, shown};

/// Figure 10: each further state of the flown plant.
pub(super) fn figure(report: &Report<'_>) -> Option<Figure> {
    let table = report.trajectory;
    let plots = report.plant.further.iter().filter_map(|channel| {
        let state = shown(table, &format!("truth.{}", channel.name), channel)?;
        let marks = vec![line(&channel.name, Ink::Actual, state)];
        plot(table, channel.name.clone(), &channel.unit, marks)
    });
    Some(Figure {
        number: 10,
        title: "Flown plant",
        caption: "States of the flown plant that the controller does not know of.".to_owned(),
        paired: false,
        plots: plots.collect(),
    })
}
