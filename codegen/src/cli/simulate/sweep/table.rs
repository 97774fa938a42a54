//! The variants of a sweep as rows, for people and for programs.

use super::Row;
use crate::cli::failure::{Exit, Failure};
use crate::report::number::{count, percent, short};
use crate::report::{Outcome, Quantiles};

type Value = Box<dyn Fn(&Outcome) -> Option<f64>>;

/// One number of each variant.
struct Column {
    /// Its head for people and for programs.
    heads: [String; 2],
    /// The number, SI.
    value: Value,
    /// How people see it.
    shown: Box<dyn Fn(f64) -> String>,
}

impl Column {
    fn new(
        heads: [&str; 2],
        value: impl Fn(&Outcome) -> Option<f64> + 'static,
        shown: impl Fn(f64) -> String + 'static,
    ) -> Column {
        Column {
            heads: heads.map(str::to_owned),
            value: Box::new(value),
            shown: Box::new(shown),
        }
    }

    fn ratio(heads: [&str; 2], quantile: fn(&Quantiles) -> Option<f64>) -> Column {
        let value = move |outcome: &Outcome| outcome.ratio.as_ref().and_then(quantile);
        Column::new(heads, value, short)
    }
}

/// The columns behind the swept keys; outputs and inputs are those of the first variant.
fn columns(rows: &[Row<'_>]) -> Vec<Column> {
    let whole = |value: f64| count(value as u64);
    let mut columns = vec![
        Column::new(["runs", "runs"], |outcome| Some(outcome.runs as f64), whole),
        Column::new(
            ["violated", "violated"],
            |outcome| outcome.violated,
            percent,
        ),
        Column::ratio(["error/bound median", "ratio.median"], |ratio| ratio.median),
        Column::ratio(["99 %", "ratio.p99"], |ratio| ratio.p99),
        Column::ratio(["largest", "ratio.max"], |ratio| ratio.max),
        Column::new(
            ["settled", "settled_ratio.max"],
            |outcome| outcome.settled_ratio.as_ref()?.max,
            short,
        ),
    ];
    let Some(plant) = rows.first().map(|row| &row.plant) else {
        return columns;
    };
    for channel in plant
        .blocks
        .first()
        .map_or(&[][..], |block| &block.channels)
    {
        let (name, factor) = (channel.name.clone(), channel.factor);
        let unit = if channel.unit == "1" {
            ""
        } else {
            &*channel.unit
        };
        let head = format!("rms {name} {unit}");
        let heads = [head.trim_end(), &format!("rms.{name}")];
        let value = move |outcome: &Outcome| outcome.rms_tracking.get(&name).copied().flatten();
        columns.push(Column::new(heads, value, move |rms| short(rms / factor)));
    }
    for input in &plant.inputs {
        let name = input.channel.name.clone();
        let heads = [&*format!("{name} at limit"), &format!("saturated.{name}")];
        let value =
            move |outcome: &Outcome| outcome.saturated_fraction.get(&name).copied().flatten();
        columns.push(Column::new(heads, value, percent));
    }
    let lost = |outcome: &Outcome| Some(outcome.nonfinite as f64);
    columns.push(Column::new(["lost", "nonfinite"], lost, whole));
    columns
}

/// A head and a line for each variant: its values, then what `cell` makes of each column.
fn lines(
    rows: &[Row<'_>],
    head: usize,
    cell: impl Fn(&Column, Option<f64>) -> String,
) -> Vec<Vec<String>> {
    let columns = columns(rows);
    let swept = rows.first().map_or(&[][..], |row| &row.variant.values);
    let paths = swept.iter().map(|(path, _)| path.clone());
    let heads = columns.iter().map(|column| column.heads[head].clone());
    let mut lines = vec![paths.chain(heads).collect()];
    for row in rows {
        let values = row.variant.values.iter().map(|(_, value)| value.clone());
        let numbers = columns
            .iter()
            .map(|column| cell(column, (column.value)(&row.replay.outcome)));
        lines.push(values.chain(numbers).collect());
    }
    lines
}

/// The table for people, in display units.
pub(super) fn human(rows: &[Row<'_>]) -> String {
    let cell = |column: &Column, value: Option<f64>| value.map_or("-".into(), &*column.shown);
    aligned(&lines(rows, 0, cell))
}

/// Columns, each as wide as its widest entry.
fn aligned(lines: &[Vec<String>]) -> String {
    let length = |entry: &String| entry.chars().count();
    let columns = lines.first().map_or(0, Vec::len);
    let widest = |column: usize| lines.iter().map(|line| length(&line[column])).max();
    let widths: Vec<usize> = (0..columns).filter_map(widest).collect();
    let mut text = String::new();
    for line in lines {
        let entries = line.iter().zip(&widths);
        let entries: Vec<String> = entries
            .map(|(entry, width)| format!("{entry:width$}"))
            .collect();
        text.push_str(entries.join("  ").trim_end());
        text.push('\n');
    }
    text
}

/// The table for programs, SI, as CSV.
pub(super) fn csv(rows: &[Row<'_>]) -> Result<String, Failure> {
    // Counts are floats on the way here, and are no larger than such hold exactly.
    let number = |value: f64| match value.fract() == 0.0 && value.abs() < 1e15 {
        true => format!("{value:.0}"),
        false => format!("{value:?}"),
    };
    let cell = |_: &Column, value: Option<f64>| value.map_or_else(String::new, number);
    let mut writer = csv::Writer::from_writer(Vec::new());
    for line in lines(rows, 1, cell) {
        writer.write_record(&line).map_err(|error| {
            Failure::new(
                Exit::Environment,
                format_args!("cannot write the table: {error}"),
            )
        })?;
    }
    let bytes = writer
        .into_inner()
        .expect("invariant: writing to memory does not fail");
    Ok(String::from_utf8(bytes).expect("invariant: every field is text"))
}

#[cfg(test)]
mod tests {
    use super::aligned;

    #[test]
    fn columns_are_as_wide_as_their_widest_entry() {
        let line = |entries: [&str; 3]| entries.map(str::to_owned).to_vec();
        let lines = [line(["a", "rms \u{3b8}", "c"]), line(["1.5 m", "2", ""])];
        assert_eq!(aligned(&lines), "a      rms \u{3b8}  c\n1.5 m  2\n");
    }
}
