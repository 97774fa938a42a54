//! Tables in a file: a column for each axis and one of values, a row for each combination of points, the last axis changing fastest.

use super::super::csv::Sheet;
use super::{Cell, Context, MAX_POINTS, MAX_VALUES, Written, number};
use crate::diagnostic::{Applicability, Diagnostic, Rule, SourceMap, Span, counted, quoted};
use crate::spec::{Table, Word};
use crate::suggest::nearest;
use crate::yaml::excerpt;

/// Most missing cells that a message names.
const MOST_NAMED: usize = 4;

impl<'a> Context<'a> {
    /// The numbers of a table in `file`.
    pub(super) fn table_file(
        &mut self,
        name: &Word,
        declared: &Table,
        file: &Word,
    ) -> Option<Written<'a>> {
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
        let sources: &'a SourceMap = self.sources;
        let id = *sources.data.get(&file.span)?;
        let sheet = Sheet::read(id, sources.source(id));
        let column = match &declared.column {
            Some(column) => column.as_ref().ok()?,
            None => name,
        };
        let wanted: Vec<&Word> = (declared.axes.iter().map(|axis| &axis.name))
            .chain([column])
            .collect();
        self.check_full(&sheet, &wanted, file)?;
        let columns: Vec<Option<usize>> = (0..wanted.len())
            .map(|at| self.column(&sheet, &wanted, at, declared.column.is_some()))
            .collect();
        let columns: Vec<usize> = columns.into_iter().collect::<Option<_>>()?;
        self.check_rows(&sheet, &columns, file)?;
        self.gather(declared, &sheet, &columns, file)
    }

    /// The file names columns and has a row of numbers.
    fn check_full(&mut self, sheet: &Sheet<'_>, wanted: &[&Word], file: &Word) -> Option<()> {
        let names: Vec<&str> = wanted.iter().map(|column| column.value.as_str()).collect();
        let names = names.join(",");
        let (message, help) = match (sheet.header.is_empty(), sheet.rows.is_empty()) {
            (true, _) => (
                "data file is empty",
                format!(
                    "its first line names the columns, here `{names}`; a line of numbers follows for each point"
                ),
            ),
            (false, true) => (
                "data file has no numbers",
                "below the names of the columns, write a line of numbers for each point".to_owned(),
            ),
            (false, false) => return Some(()),
        };
        self.fault(Rule::E0321, file.span, message, help);
        None
    }

    /// The position of the column number `at` of those that are wanted.
    fn column(
        &mut self,
        sheet: &Sheet<'_>,
        wanted: &[&Word],
        at: usize,
        named: bool,
    ) -> Option<usize> {
        let column = wanted[at];
        let mut like = (0..sheet.header.len()).filter(|&at| sheet.header[at].text == column.value);
        let (first, second) = (like.next(), like.next());
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
                let otherwise = match (at + 1 == wanted.len(), named) {
                    (true, false) => "add `column: ",
                    (true, true) => "write `column: ",
                    (false, _) => "name the axis `",
                };
                let fault = missing_column(sheet, wanted, column, otherwise);
                self.faults.push(fault);
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
            if row.len() != sheet.header.len() {
                let fault = uneven_row(row, &sheet.header);
                self.faults.push(fault);
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
                "file has {}, expected {}",
                counted(sheet.rows.len(), "row"),
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

/// The fault of a header without a column. One with nearly its name is probably a slip in the file.
fn missing_column(
    sheet: &Sheet<'_>,
    wanted: &[&Word],
    column: &Word,
    otherwise: &str,
) -> Diagnostic {
    let message = format!("file has no column {}", quoted(&column.value));
    let fault = Diagnostic::error(Rule::E0323, column.span, message);
    let free = |cell: &&Cell<'_>| wanted.iter().all(|other| other.value != cell.text);
    let free: Vec<&Cell<'_>> = sheet.header.iter().filter(free).collect();
    let meant = nearest(&column.value, free.iter().map(|cell| cell.text));
    let meant = meant.and_then(|meant| free.into_iter().find(|cell| cell.text == meant.name));
    if let Some(cell) = meant {
        let wanted = quoted(&column.value);
        return fault
            .with_related(cell.span, "this column has nearly the name")
            .with_help(format!(
                "name the column {wanted} in the file, or {otherwise}{}`",
                excerpt(cell.text)
            ))
            .with_suggestion(cell.span, column.value.as_str(), Applicability::Possible);
    }
    let fault = fault.with_help("the first line of the file names its columns");
    match (sheet.header.first(), sheet.header.last()) {
        (Some(first), Some(last)) => {
            let line = Span {
                end: last.span.end,
                ..first.span
            };
            fault.with_related(line, "the columns are named here")
        }
        _ => fault,
    }
}

/// The fault of a row with more or fewer cells than there are columns.
fn uneven_row(row: &[Cell<'_>], header: &[Cell<'_>]) -> Diagnostic {
    let message = format!(
        "row has {}, expected {}",
        counted(row.len(), "cell"),
        header.len()
    );
    let names = |cells: &[Cell<'_>]| -> String {
        let names: Vec<String> = cells.iter().map(|cell| quoted(cell.text)).collect();
        names.join(" and ")
    };
    let span = match (row.get(header.len()), row.last()) {
        (Some(surplus), Some(last)) => Span {
            end: last.span.end,
            ..surplus.span
        },
        (None, Some(last)) => Span {
            start: last.span.end,
            ..last.span
        },
        _ => header[0].span,
    };
    let fault = Diagnostic::error(Rule::E0321, span, message);
    match header.get(row.len()..) {
        Some(missing @ [_, ..]) if missing.len() <= MOST_NAMED => fault
            .with_label(format!("{} is missing", names(missing)))
            .with_help("every row has a cell for each column"),
        Some([_, ..]) => fault.with_help("every row has a cell for each column"),
        _ => fault.with_help("every row has one cell for each column: remove what is beyond them"),
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
