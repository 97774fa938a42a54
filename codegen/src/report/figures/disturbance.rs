//! Disturbances, what the observers make of them, and the difference.

use super::{Figure, Ink, Mark, Report, line, listed, plot, shown};
use crate::report::plant::{Block, Channel};
use crate::report::plot::Plot;

/// Figure 1: the disturbances that exosystems make.
pub(super) fn exosystem(report: &Report<'_>) -> Option<Figure> {
    let blocks = disturbed(report, true);
    let plots = blocks.iter().flat_map(|&(number, block)| {
        block.channels.iter().filter_map(move |channel| {
            let rate = channel.rate();
            let d = shown(
                report.trajectory,
                &format!("d{number}.{}", channel.name),
                &rate,
            )?;
            plot(
                report.trajectory,
                title(block, channel),
                &rate.unit,
                vec![line("", Ink::Actual, d)],
            )
        })
    });
    let caption = format!(
        "The disturbance that an exosystem of known structure and unknown state, randomly excited if it declares so, \
         applies to each channel of {}.",
        names(&blocks)
    );
    Some(Figure {
        number: 1,
        title: "Disturbance from the exosystem",
        caption,
        paired: false,
        plots: plots.collect(),
    })
}

/// Figure 3 (bounded disturbances) or 4 (exosystems): truth with estimate, and the estimation error, by channel.
pub(super) fn estimates(report: &Report<'_>, exosystem: bool) -> Option<Figure> {
    let blocks = disturbed(report, exosystem);
    let plots: Vec<Plot> = blocks
        .iter()
        .flat_map(|&(number, block)| pairs(report, number, block))
        .collect();
    let (number, title, kind) = match exosystem {
        false => (
            3,
            "Bounded disturbance and its estimate",
            "bounded disturbance",
        ),
        true => (
            4,
            "Exosystem disturbance and its estimate",
            "disturbance from the exosystem",
        ),
    };
    let caption = format!(
        "Each channel of {}. Left of each pair: the {kind} and the observer's estimate, which also holds what a network \
         leaves over. Right: the estimation error, disturbance minus estimate.",
        names(&blocks)
    );
    Some(Figure {
        number,
        title,
        caption,
        paired: true,
        plots,
    })
}

fn pairs(report: &Report<'_>, number: usize, block: &Block) -> Vec<Plot> {
    let table = report.trajectory;
    let channels = block.channels.iter().filter_map(|channel| {
        let rate = channel.rate();
        let d = shown(table, &format!("d{number}.{}", channel.name), &rate)?;
        let estimate = shown(table, &format!("D_hat{number}.{}", channel.name), &rate)?;
        let error: Vec<f64> = d
            .iter()
            .zip(&estimate)
            .map(|(d, estimate)| d - estimate)
            .collect();
        let both: Vec<Mark> = vec![
            line("disturbance", Ink::Actual, d),
            line("estimate", Ink::Estimate, estimate),
        ];
        let error = vec![line("", Ink::Difference, error)];
        let heading = title(block, channel);
        Some([
            plot(table, heading.clone(), &rate.unit, both),
            plot(
                table,
                format!("{heading}: estimation error"),
                &rate.unit,
                error,
            ),
        ])
    });
    channels.flatten().flatten().collect()
}

/// Blocks with a disturbance of the given kind, with their number from 1.
fn disturbed<'a>(report: &Report<'a>, exosystem: bool) -> Vec<(usize, &'a Block)> {
    let blocks = report
        .plant
        .blocks
        .iter()
        .enumerate()
        .map(|(i, block)| (i + 1, block));
    blocks
        .filter(|(_, block)| block.exosystem == exosystem)
        .collect()
}

fn names(blocks: &[(usize, &Block)]) -> String {
    listed(blocks.iter().map(|(_, block)| block.name.as_str()))
}

fn title(block: &Block, channel: &Channel) -> String {
    format!("{}: disturbance of {}", block.name, channel.name)
}
