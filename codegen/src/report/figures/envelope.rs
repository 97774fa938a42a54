//! Tracking errors inside the time-varying constraint.

use super::{Figure, Ink, Mark, Report, line, listed, plot, shown};
use crate::report::plant::Block;
use crate::report::plot::Plot;
use crate::report::table::Table;

/// Figure 6: the norm of each constrained block's error under its bound, and the channels between plus and minus the bound.
pub(super) fn figure(report: &Report<'_>) -> Option<Figure> {
    let blocks = report
        .plant
        .blocks
        .iter()
        .enumerate()
        .map(|(i, block)| (i + 1, block));
    let constrained: Vec<(usize, &Block)> = blocks
        .filter(|(number, _)| report.trajectory.column(&format!("k{number}")).is_some())
        .collect();
    let plots = constrained
        .iter()
        .flat_map(|&(number, block)| panels(report.trajectory, number, block))
        .collect();
    let caption = format!(
        "Error of {}: of the outputs from their reference, of an inner block the error variable e. Left of each pair: its \
         Euclidean norm under the bound k(t). Right: each channel between -k(t) and k(t).",
        listed(constrained.iter().map(|(_, block)| block.name.as_str()))
    );
    Some(Figure {
        number: 6,
        title: "Errors inside the constraint",
        caption,
        paired: true,
        plots,
    })
}

fn panels(table: &Table, number: usize, block: &Block) -> Vec<Plot> {
    // A norm over channels is shown in the unit of the first; a constrained block has channels of one dimension.
    let Some(unit) = block.channels.first() else {
        return Vec::new();
    };
    let Some(bound) = shown(table, &format!("k{number}"), unit) else {
        return Vec::new();
    };
    let error = match number {
        1 => "error".to_owned(),
        _ => format!("e{number}"),
    };
    let errors: Vec<(&str, Vec<f64>)> = block
        .channels
        .iter()
        .filter_map(|channel| {
            Some((
                channel.name.as_str(),
                shown(table, &format!("{error}.{}", channel.name), unit)?,
            ))
        })
        .collect();
    if errors.is_empty() {
        return Vec::new();
    }
    let norm = (0..bound.len())
        .map(|row| {
            errors
                .iter()
                .map(|(_, e)| e[row] * e[row])
                .sum::<f64>()
                .sqrt()
        })
        .collect();
    let norm = vec![
        line("norm of the error", Ink::Actual, norm),
        line("bound k", Ink::Limit, bound.clone()),
    ];
    let below = bound.iter().map(|k| -k).collect();
    let channels = errors
        .into_iter()
        .enumerate()
        .map(|(i, (name, e))| line(name, Ink::Channel(i), e));
    let channels: Vec<Mark> = channels
        .chain([
            line("k and -k", Ink::Limit, bound),
            line("", Ink::Limit, below),
        ])
        .collect();
    let both = [("norm of the error", norm), ("error by channel", channels)];
    both.into_iter()
        .filter_map(|(what, marks)| {
            plot(table, format!("{}: {what}", block.name), &unit.unit, marks)
        })
        .collect()
}
