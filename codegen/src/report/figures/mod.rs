//! The figures of the page, numbered as in the paper; a figure whose signals a problem does not have is left out.

mod campaign;
mod control;
mod disturbance;
mod envelope;
mod flown;
mod lyapunov;
mod tracking;

use super::plant::Channel;
use super::plot::{Ink, Mark, Plot};
use super::{Report, Table};

/// A numbered group of plots with its caption.
pub(super) struct Figure {
    /// Number in the paper; those from 8 on are ours.
    pub number: u32,
    /// Heading.
    pub title: &'static str,
    /// What is seen, in words.
    pub caption: String,
    /// Whether plots belong together two by two.
    pub paired: bool,
    /// Small multiples.
    pub plots: Vec<Plot>,
}

/// Every figure that the data can fill, by number.
pub(super) fn figures(report: &Report<'_>) -> Vec<Figure> {
    let trajectory = [
        disturbance::exosystem(report),
        disturbance::estimates(report, false),
        disturbance::estimates(report, true),
        tracking::figure(report),
        envelope::figure(report),
        control::figure(report),
        lyapunov::figure(report),
    ];
    let campaign = report.band.and_then(|band| campaign::figure(report, band));
    let flown = flown::figure(report);
    let figures = trajectory
        .into_iter()
        .flatten()
        .chain(campaign)
        .chain(flown);
    figures.filter(|figure| !figure.plots.is_empty()).collect()
}

/// A column in the unit of `channel`.
fn shown(table: &Table, name: &str, channel: &Channel) -> Option<Vec<f64>> {
    Some(
        table
            .column(name)?
            .iter()
            .map(|value| value / channel.factor)
            .collect(),
    )
}

fn line(label: &str, ink: Ink, y: Vec<f64>) -> Mark {
    Mark::Line {
        label: label.to_owned(),
        ink,
        y,
    }
}

fn plot(table: &Table, title: String, unit: &str, marks: Vec<Mark>) -> Option<Plot> {
    let t = table.column("t")?.to_vec();
    (!marks.is_empty()).then(|| Plot {
        title,
        unit: unit.to_owned(),
        log: false,
        t,
        marks,
    })
}

/// `a`, `a and b`, `a, b and c`.
fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.into_iter().collect();
    match names.as_slice() {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;

    #[test]
    fn a_plain_problem_has_fewer_figures() {
        let full = sample::Sample::full();
        assert_eq!(
            figures(&full.report())
                .iter()
                .map(|f| f.number)
                .collect::<Vec<_>>(),
            [1, 3, 4, 5, 6, 7, 8, 9]
        );
        let plain = sample::Sample::plain();
        assert_eq!(
            figures(&plain.report())
                .iter()
                .map(|f| f.number)
                .collect::<Vec<_>>(),
            [5, 7]
        );
    }

    #[test]
    fn lists_read_as_english() {
        assert_eq!(listed(["a"]), "a");
        assert_eq!(listed(["a", "b", "c"]), "a, b and c");
    }
}
