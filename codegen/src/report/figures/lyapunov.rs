//! The Lyapunov function along the trajectory.

use super::{Figure, Ink, Report, line, plot};

/// Figure 8: V on a logarithmic axis and its Ito generator LV.
pub(super) fn figure(report: &Report<'_>) -> Option<Figure> {
    let table = report.trajectory;
    let v = table.column("V").and_then(|v| {
        plot(
            table,
            "Lyapunov function V".into(),
            "",
            vec![line("", Ink::Actual, v.to_vec())],
        )
    });
    let v = v.map(|plot| super::Plot { log: true, ..plot });
    let lv = table.column("LV").and_then(|lv| {
        plot(
            table,
            "generator LV".into(),
            "",
            vec![line("", Ink::Actual, lv.to_vec())],
        )
    });
    let caption = "The Lyapunov function of the whole loop on a logarithmic axis, and its Ito generator: the expected rate of change \
                   of V. The theorem bounds LV by a positive constant minus a multiple of V, so that V may rise only while it is small."
        .to_owned();
    Some(Figure {
        number: 8,
        title: "Lyapunov function",
        caption,
        paired: false,
        plots: v.into_iter().chain(lv).collect(),
    })
}
