//! The page around verdict, table and figures.

use std::fmt::Write as _;

use super::Report;
use super::figures::{Figure, figures};
use super::html::{escape, number};
use super::plot::{Size, svg};
use super::summary::{table, verdict};

const STYLE: &str = include_str!("style.css");

/// The whole report as HTML text.
pub(crate) fn page(report: &Report<'_>) -> String {
    let plant = report.plant;
    let title = escape(&plant.title);
    let (class, sentence) = verdict(report.outcome);
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"generator\" content=\"nsv {}\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n",
        env!("CARGO_PKG_VERSION")
    );
    let _ = writeln!(
        out,
        "<header>\n<p class=\"kicker\">Closed-loop simulation</p>\n<h1>{title}</h1>"
    );
    let _ = writeln!(out, "{}\n</header>", facts(report));
    let _ = writeln!(
        out,
        "<p class=\"verdict {class}\">{sentence}</p>\n{}",
        table(report)
    );
    let shown = match report.outcome.runs {
        1 => String::new(),
        runs => format!(
            "Figures 1 to 8 show run {} of {runs}. ",
            report.trajectory_run
        ),
    };
    let _ = writeln!(
        out,
        "<p class=\"note\">{shown}Figures are numbered as in the paper; one whose signals this problem lacks is left out.</p>"
    );
    for figure in figures(report) {
        out.push_str(&section(&figure));
    }
    out + "</main>\n</body>\n</html>\n"
}

/// Specification, seed, length and the command that makes the page again.
fn facts(report: &Report<'_>) -> String {
    let plant = report.plant;
    let pairs = [
        (
            "specification",
            format!("<code>{}</code>", escape(&plant.name)),
        ),
        (
            "SHA-256",
            format!("<code class=\"hash\">{}</code>", escape(&plant.hash)),
        ),
        ("seed", report.seed.to_string()),
        ("runs", report.outcome.runs.to_string()),
        ("horizon", format!("{}&nbsp;s", number(report.horizon_s))),
        (
            "command",
            format!("<code>{}</code>", escape(report.command)),
        ),
    ];
    let items = pairs.map(|(name, value)| format!("<div><dt>{name}</dt><dd>{value}</dd></div>"));
    format!("<dl>{}</dl>", items.concat())
}

fn section(figure: &Figure) -> String {
    let Figure {
        number,
        title,
        caption,
        paired,
        plots,
    } = figure;
    let (class, size) = if !paired && plots.len() % 3 == 0 {
        ("plots three", Size::Narrow)
    } else {
        ("plots", Size::Wide)
    };
    let pictures: String = plots
        .iter()
        .map(|plot| {
            svg(plot, size)
                + "
"
        })
        .collect();
    format!(
        "<figure id=\"figure-{number}\">\n<h2><span>Figure {number}</span> {title}</h2>\n<div class=\"{class}\">\n{pictures}</div>\n\
         <figcaption>{}</figcaption>\n</figure>\n",
        escape(caption)
    )
}

#[cfg(test)]
mod tests {
    use super::super::sample::Sample;
    use super::*;

    #[test]
    fn the_page_needs_nothing_from_outside() {
        let page = page(&Sample::full().report());
        for forbidden in ["http", "<script", "<link", "@import", "url(", "src="] {
            assert!(!page.contains(forbidden), "{forbidden}");
        }
    }

    #[test]
    fn no_name_is_taken_for_markup() {
        let mut sample = Sample::full();
        sample.plant.title = "<script>alert(1)</script>".into();
        sample.plant.blocks[0].name = "<b>".into();
        sample.plant.blocks[0].channels[0].unit = "</style>".into();
        let page = page(&sample.report());
        assert!(!page.contains("<script>") && !page.contains("<b>"));
        assert_eq!(page.matches("</style>").count(), 1);
    }

    #[test]
    fn the_page_without_pictures_is_stable_text() {
        let page = page(&Sample::full().report());
        let body = &page[page.find("<body>").unwrap()..];
        let mut text = String::new();
        for (i, piece) in body.split("<svg").enumerate() {
            let rest = if i == 0 {
                piece
            } else {
                piece.split_once("</svg>").unwrap().1
            };
            text.push_str(if i == 0 { "" } else { "(picture)" });
            text.push_str(rest);
        }
        insta::assert_snapshot!(text);
    }

    #[test]
    fn the_same_data_give_the_same_bytes() {
        assert_eq!(
            page(&Sample::full().report()),
            page(&Sample::full().report())
        );
    }

    /// Writes the page for the eye: `NSV_REPORT_SAMPLE=/tmp/sample.html cargo test -p nsv-codegen sample_page`.
    #[test]
    fn sample_page_can_be_looked_at() {
        let page = page(&Sample::full().report());
        assert!(page.len() < 1_000_000, "{} bytes", page.len());
        if let Some(path) = std::env::var_os("NSV_REPORT_SAMPLE") {
            std::fs::write(path, page).unwrap();
        }
    }
}
