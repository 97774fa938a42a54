//! Tables in a file: a column for each axis and one of values, a row for each combination of points, the last axis changing fastest.

use super::super::csv::Sheet;
use super::{Cell, Context, MAX_POINTS, MAX_VALUES, Written, number};
use crate::diagnostic::{Diagnostic, Rule, SourceMap, Span, quoted};
use crate::spec::{Table, Word};
use crate::suggest::nearest;

impl Context<'_> {
    /// The numbers of a table in `file`.
    pub(super) fn table_file<'s>(
        &mut self,
        name: &Word,
        declared: &Table,
        file: &Word,
        sources: &'s SourceMap,
    ) -> Option<Written<'s>> {
        for axis in &declared.axes {
            if axis.value.values.is_some() {
                let message = format!("axis `{}` has values beside `file`", axis.name.value);
                self.table_shape(
                    axis.name.span,
                    message,
                    "give its unit only: the file has the values",
                );
                return None;
            }
        }
        let id = *sources.data.get(&file.span)?;
        let sheet = Sheet::read(id, sources.source(id));
        let columns: Vec<Option<usize>> = declared
            .axes
            .iter()
            .map(|axis| &axis.name)
            .chain([declared.column.as_ref().unwrap_or(name)])
            .map(|column| self.column(&sheet, column, file))
            .collect();
        let columns: Vec<usize> = columns.into_iter().collect::<Option<_>>()?;
        self.check_rows(&sheet, &columns, file)?;
        self.gather(declared, &sheet, &columns, file)
    }

    /// The position of a column.
    fn column(&mut self, sheet: &Sheet<'_>, column: &Word, file: &Word) -> Option<usize> {
        let mut named = (0..sheet.header.len()).filter(|&at| sheet.header[at].text == column.value);
        let (first, second) = (named.next(), named.next());
        let header = |at: usize| sheet.header[at].span;
        match (first, second) {
            (Some(at), None) => Some(at),
            (Some(first), Some(second)) => {
                let message = format!("column {} is there twice", quoted(&column.value));
                let fault = Diagnostic::error(Rule::E0323, header(second), message);
                let fault = fault.with_related(header(first), "first here");
                self.faults.push(fault.with_help("rename one of them"));
                None
            }
            (None, _) => {
                let names = sheet.header.iter().map(|cell| cell.text);
                let meant = nearest(&column.value, names);
                let message = format!("file has no column {}", quoted(&column.value));
                let fault = Diagnostic::error(Rule::E0323, column.span, message);
                let fault = match (sheet.header.first(), sheet.header.last()) {
                    (Some(first), Some(last)) => {
                        let line = Span {
                            end: last.span.end,
                            ..first.span
                        };
                        fault.with_related(line, "the columns are named here")
                    }
                    _ => fault.with_related(file.span, "the file is empty"),
                };
                let otherwise = || "the first line of the file names its columns".to_owned();
                self.faults
                    .push(fault.did_you_mean(column.span, &column.value, meant, otherwise));
                None
            }
        }
    }

    /// Every row has as many cells as the header, and numbers where they are needed.
    fn check_rows(&mut self, sheet: &Sheet<'_>, columns: &[usize], file: &Word) -> Option<()> {
        if sheet.rows.len() > MAX_VALUES {
            let message = format!("table has more than {MAX_VALUES} values");
            self.fault(Rule::E0324, file.span, message, "leave out points");
            return None;
        }
        for row in &sheet.rows {
            let (found, expected) = (row.len(), sheet.header.len());
            if let Some(last) = row.last().filter(|_| found != expected) {
                let span = Span {
                    end: last.span.end,
                    ..row[0].span
                };
                let message = format!("row has {found} cells, expected {expected}");
                self.table_shape(span, message, "every row has a cell for each column");
                return None;
            }
            let cells = columns.iter().map(|&column| &row[column]);
            if let Some(cell) = cells
                .into_iter()
                .find(|cell| number(cell.text, None).is_none())
            {
                self.no_number(cell);
                return None;
            }
        }
        Some(())
    }

    /// Points and values of rows that are a full grid in order.
    fn gather<'s>(
        &mut self,
        declared: &Table,
        sheet: &Sheet<'s>,
        columns: &[usize],
        file: &Word,
    ) -> Option<Written<'s>> {
        let (value, axes) = columns.split_last()?;
        // How long the column keeps its value, and after how many values it starts again, gives the grid; the rows are then held against it.
        let mut points: Vec<Vec<Cell<'s>>> = Vec::new();
        let mut stride = 1;
        for &column in axes.iter().rev() {
            let cells = sheet.rows.iter().step_by(stride).map(|row| row[column]);
            let axis = axis_points(cells);
            stride = stride.saturating_mul(axis.len().max(1));
            points.push(axis);
        }
        points.reverse();
        let mut strides = Vec::new();
        for axis in &points {
            stride /= axis.len().max(1);
            strides.push(stride);
        }
        for (at, row) in sheet.rows.iter().enumerate() {
            for (axis, &column) in axes.iter().enumerate() {
                let expected = points[axis][at / strides[axis] % points[axis].len()];
                if number(row[column].text, None) != number(expected.text, None) {
                    let name = &declared.axes[axis].name.value;
                    let message = format!(
                        "`{name}` is {}, expected {}",
                        row[column].text, expected.text
                    );
                    let help = "there is a row for each combination of points, the last axis changing fastest";
                    self.table_shape(row[column].span, message, help);
                    return None;
                }
            }
        }
        let count: usize = points.iter().map(Vec::len).product();
        if count != sheet.rows.len() {
            let lengths: Vec<String> = points.iter().map(|axis| axis.len().to_string()).collect();
            let message = format!(
                "file has {} rows, expected {}",
                sheet.rows.len(),
                lengths.join(" x ")
            );
            self.table_shape(
                file.span,
                message,
                "there is a row for each combination of points",
            );
            return None;
        }
        let values = sheet.rows.iter().map(|row| row[*value]).collect();
        Some(Written { points, values })
    }
}

/// The values of a column until the first comes again.
fn axis_points<'s>(cells: impl Iterator<Item = Cell<'s>>) -> Vec<Cell<'s>> {
    let mut points: Vec<Cell<'s>> = Vec::new();
    for cell in cells.take(MAX_POINTS + 1) {
        let value = number(cell.text, None);
        if points
            .first()
            .is_some_and(|first| number(first.text, None) == value)
        {
            break;
        }
        points.push(cell);
    }
    points
}
