//! SVG text of a plot. Colours and fonts come from the page's style sheet by class.

use std::fmt::Write as _;

use super::range::{Range, coordinate, ordinate, time};
use super::simplify::{Point, curves};
use super::ticks::{Ticks, linear, logarithmic};
use super::{Mark, Plot, Size};
use crate::report::html::{escape, unit};

const HEIGHT: f64 = 250.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = 10.0;
const BOTTOM: f64 = 36.0;
const TITLE: f64 = 20.0;
const LEGEND_ROW: f64 = 16.0;
/// Width of a letter at the legend's size, on the safe side.
const LETTER: f64 = 6.3;
const SWATCH: f64 = 26.0;

/// The plot as one `svg` element.
pub(crate) fn svg(plot: &Plot, size: Size) -> String {
    let width = size.width();
    let legend = legend_rows(plot, width);
    let top = TITLE + LEGEND_ROW * legend.len() as f64 + 8.0;
    let frame = Frame {
        width,
        x: time(&plot.t),
        y: ordinate(plot),
        top,
    };
    let title = escape(&plot.title);
    let mut out =
        format!(r#"<svg viewBox="0 0 {width} {HEIGHT}" role="img" aria-label="{title}">"#);
    let _ = write!(
        out,
        r#"<text class="title" x="{LEFT}" y="14">{title}</text>"#
    );
    axes(&mut out, plot, &frame);
    for mark in &plot.marks {
        draw(&mut out, plot, &frame, mark);
    }
    for (row, entries) in legend.iter().enumerate() {
        draw_legend(&mut out, entries, TITLE + LEGEND_ROW * row as f64 + 10.0);
    }
    out.push_str("</svg>");
    out
}

/// Maps data to pixels.
struct Frame {
    width: f64,
    x: Range,
    y: Range,
    top: f64,
}

impl Frame {
    fn px(&self, t: f64) -> f64 {
        LEFT + self.x.position(t) * (self.width - LEFT - RIGHT)
    }

    fn py(&self, y: f64) -> f64 {
        HEIGHT - BOTTOM - self.y.position(y) * (HEIGHT - BOTTOM - self.top)
    }

    fn points(&self, plot: &Plot, y: &[f64]) -> Vec<Point> {
        plot.t
            .iter()
            .zip(y)
            .map(|(&t, &y)| (self.px(t), self.py(coordinate(plot, y))))
            .collect()
    }
}

fn axes(out: &mut String, plot: &Plot, frame: &Frame) {
    let bottom = HEIGHT - BOTTOM;
    let ticks = ordinate_ticks(plot, frame);
    for (value, label) in &ticks.marks {
        let y = frame.py(*value);
        let class = if *value == 0.0 && !plot.log {
            "grid zero"
        } else {
            "grid"
        };
        let _ = write!(
            out,
            r#"<path class="{class}" d="M{LEFT} {}H{}"/>"#,
            px(y),
            px(frame.width - RIGHT)
        );
        let _ = write!(
            out,
            r#"<text class="tick" text-anchor="end" x="{}" y="{}">{label}</text>"#,
            px(LEFT - 5.0),
            px(y + 3.5)
        );
    }
    let times = linear(frame.x.low, frame.x.high, (frame.width / 80.0) as u32);
    for (value, label) in &times.marks {
        let x = frame.px(*value);
        let _ = write!(
            out,
            r#"<path class="grid" d="M{} {}V{}"/>"#,
            px(x),
            px(frame.top),
            px(bottom)
        );
        let _ = write!(
            out,
            r#"<text class="tick" text-anchor="middle" x="{}" y="{}">{label}</text>"#,
            px(x),
            px(bottom + 14.0)
        );
    }
    let middle = LEFT + 0.5 * (frame.width - LEFT - RIGHT);
    let time = scaled("time", "s", times.exponent);
    let _ = write!(
        out,
        r#"<text class="axis" text-anchor="middle" x="{}" y="{}">{time}</text>"#,
        px(middle),
        px(HEIGHT - 6.0)
    );
    let (x, y) = (12.0, 0.5 * (frame.top + bottom));
    let label = scaled("", &plot.unit, ticks.exponent);
    let (x, y) = (px(x), px(y));
    let _ = write!(
        out,
        r#"<text class="axis" text-anchor="middle" x="{x}" y="{y}" transform="rotate(-90 {x} {y})">{label}</text>"#
    );
}

fn ordinate_ticks(plot: &Plot, frame: &Frame) -> Ticks {
    match plot.log {
        true => logarithmic(frame.y.low as i32, frame.y.high as i32, 5),
        false => linear(frame.y.low, frame.y.high, 5),
    }
}

/// An axis label such as `time (s)` or `(10^7 N*m)`.
fn scaled(name: &str, unit_text: &str, exponent: i32) -> String {
    let power = match exponent {
        0 => String::new(),
        power => format!(
            r#"10<tspan dy="-4" font-size="8">{power}</tspan><tspan dy="4">&#8201;</tspan>"#
        ),
    };
    match (name, unit_text) {
        (name, "" | "1") if power.is_empty() => name.to_owned(),
        (name, "" | "1") => format!("{name} ({power})"),
        ("", text) if power.is_empty() => unit(text),
        (name, text) => format!("{name} ({power}{})", unit(text))
            .trim_start()
            .to_owned(),
    }
}

fn draw(out: &mut String, plot: &Plot, frame: &Frame, mark: &Mark) {
    let class = mark.ink().class();
    match mark {
        Mark::Line { y, .. } => {
            let data: String = curves(&frame.points(plot, y))
                .iter()
                .map(|curve| path(curve))
                .collect();
            let _ = write!(out, r#"<path class="line {class}" d="{data}"/>"#);
        }
        Mark::Band { low, high, .. } => {
            // A band is the outline of its upper edge and its lower edge backwards; both are simplified as one run each.
            let (upper, mut lower) = (
                curves(&frame.points(plot, high)).concat(),
                curves(&frame.points(plot, low)).concat(),
            );
            lower.reverse();
            let outline = [upper, lower].concat();
            if !outline.is_empty() {
                let _ = write!(
                    out,
                    r#"<path class="band {class}" d="{}Z"/>"#,
                    path(&outline)
                );
            }
        }
    }
}

fn path(curve: &[Point]) -> String {
    let mut out = String::new();
    for (i, (x, y)) in curve.iter().enumerate() {
        let _ = write!(
            out,
            "{}{} {}",
            if i == 0 { 'M' } else { 'L' },
            px(*x),
            px(*y)
        );
    }
    if curve.len() == 1 {
        out.push_str("h0.1"); // a lone sample is a dot
    }
    out
}

/// A coordinate with a tenth of a pixel.
fn px(value: f64) -> String {
    let text = format!("{:.1}", value + 0.0);
    match text.strip_suffix(".0") {
        Some("-0") => "0".to_owned(),
        Some(whole) => whole.to_owned(),
        None => text,
    }
}

type Entry<'a> = (f64, &'a Mark);

/// Legend entries with their abscissa, row by row.
fn legend_rows(plot: &Plot, limit: f64) -> Vec<Vec<Entry<'_>>> {
    let mut rows: Vec<Vec<Entry<'_>>> = Vec::new();
    let mut x = f64::INFINITY;
    for mark in plot.marks.iter().filter(|mark| !mark.label().is_empty()) {
        let width = SWATCH + LETTER * mark.label().chars().count() as f64 + 10.0;
        if x + width > limit - RIGHT {
            rows.push(Vec::new());
            x = LEFT;
        }
        rows.last_mut()
            .expect("invariant: a row was opened")
            .push((x, mark));
        x += width;
    }
    rows
}

fn draw_legend(out: &mut String, entries: &[Entry<'_>], y: f64) {
    for (x, mark) in entries {
        let class = mark.ink().class();
        let _ = match mark {
            Mark::Line { .. } => write!(
                out,
                r#"<path class="line {class}" d="M{} {}h20"/>"#,
                px(*x),
                px(y)
            ),
            Mark::Band { .. } => write!(
                out,
                r#"<path class="band {class}" d="M{} {}h20v8h-20Z"/>"#,
                px(*x),
                px(y - 4.0)
            ),
        };
        let _ = write!(
            out,
            r#"<text class="legend" x="{}" y="{}">{}</text>"#,
            px(x + SWATCH),
            px(y + 3.5),
            escape(mark.label())
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::plot::Ink;

    fn ramp() -> Plot {
        let t: Vec<f64> = (0..=10_000).map(|i| f64::from(i) * 1e-3).collect();
        let low = t.iter().map(|t| t - 1.0).collect();
        let high = t.iter().map(|t| t + 1.0).collect();
        let marks = vec![
            Mark::Band {
                label: "5-95 %".into(),
                ink: Ink::Inner,
                low,
                high,
            },
            Mark::Line {
                label: "ramp <1>".into(),
                ink: Ink::Actual,
                y: t.clone(),
            },
            Mark::Line {
                label: String::new(),
                ink: Ink::Limit,
                y: vec![8.0; t.len()],
            },
        ];
        Plot {
            title: "a & b".into(),
            unit: "kN*m/s^2".into(),
            log: false,
            t,
            marks,
        }
    }

    #[test]
    fn a_plot_is_small_and_stable_text() {
        insta::assert_snapshot!(svg(&ramp(), Size::Wide).replace("><", ">\n<"));
    }

    #[test]
    fn ten_thousand_noisy_samples_stay_under_forty_kilobytes() {
        let mut state = 1u32;
        let mut plot = ramp();
        let noise = plot.t.iter().map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state)
        });
        plot.marks = vec![Mark::Line {
            label: String::new(),
            ink: Ink::Actual,
            y: noise.collect(),
        }];
        assert!(
            svg(&plot, Size::Narrow).len() < 40_000,
            "{}",
            svg(&plot, Size::Narrow).len()
        );
    }

    #[test]
    fn no_coordinate_is_nan() {
        let mut plot = ramp();
        plot.marks.push(Mark::Line {
            label: "n".into(),
            ink: Ink::Estimate,
            y: vec![f64::NAN; plot.t.len()],
        });
        plot.marks.push(Mark::Line {
            label: "i".into(),
            ink: Ink::Estimate,
            y: vec![f64::INFINITY; plot.t.len()],
        });
        for log in [false, true] {
            plot.log = log;
            let text = svg(&plot, Size::Narrow);
            assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        }
    }
}
