//! Control inputs at the actuators.

use super::{Figure, Ink, Report, line, plot, shown};

/// Figure 7: each saturated input between its limits.
pub(super) fn figure(report: &Report<'_>) -> Option<Figure> {
    let table = report.trajectory;
    let plots = report.plant.inputs.iter().filter_map(|input| {
        let channel = &input.channel;
        let u = shown(table, &format!("u_sat.{}", channel.name), channel)?;
        let limit = input.limit / channel.factor;
        let level = |label, value| line(label, Ink::Limit, vec![value; u.len()]);
        let mut marks = vec![level("limits", limit), level("", -limit)];
        match shown(table, &format!("u_act.{}", channel.name), channel) {
            None => marks.push(line(&channel.name, Ink::Actual, u.clone())),
            Some(felt) => {
                marks.push(line("command", Ink::Reference, u.clone()));
                marks.push(line(&channel.name, Ink::Actual, felt));
            }
        }
        plot(
            table,
            format!("input {}", channel.name),
            &channel.unit,
            marks,
        )
    });
    let caption =
        "Each control input as the plant receives it, after saturation and what its actuator makes of it, between its limits."
            .to_owned();
    Some(Figure {
        number: 7,
        title: "Control inputs",
        caption,
        paired: false,
        plots: plots.collect(),
    })
}
