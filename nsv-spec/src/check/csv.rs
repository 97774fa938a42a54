//! Comma-separated numbers: a line of column names, then a line for each row. Blank lines and lines that start with `#` do not count, nor do
//! blanks around a cell; there are no quotes.

use crate::diagnostic::{FileId, Source, Span};

/// A cell and its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cell<'a> {
    pub(super) text: &'a str,
    pub(super) span: Span,
}

/// A file of cells.
#[derive(Debug)]
pub(super) struct Sheet<'a> {
    /// Names of the columns; empty in an empty file.
    pub(super) header: Vec<Cell<'a>>,
    pub(super) rows: Vec<Vec<Cell<'a>>>,
}

impl Sheet<'_> {
    pub(super) fn read(file: FileId, source: &Source) -> Sheet<'_> {
        let mut lines = Vec::new();
        let mut start = 0;
        for line in source.text.split_inclusive('\n') {
            let content = line.trim_end_matches(['\n', '\r']);
            if !content.trim().is_empty() && !content.starts_with('#') {
                lines.push(cells(file, content, start));
            }
            start += line.len();
        }
        let mut lines = lines.into_iter();
        Sheet {
            header: lines.next().unwrap_or_default(),
            rows: lines.collect(),
        }
    }
}

fn cells(file: FileId, line: &str, start: usize) -> Vec<Cell<'_>> {
    let mut at = start;
    let cells = line.split(',').map(|cell| {
        let text = cell.trim();
        let first = at + (cell.len() - cell.trim_start().len());
        at += cell.len() + 1;
        // An empty cell is shown by the place where its content would be.
        let place = |byte: usize| u32::try_from(byte).unwrap_or(u32::MAX);
        let span = Span {
            file,
            start: place(first),
            end: place(first + text.len()),
        };
        Cell { text, span }
    });
    cells.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_know_their_place() {
        let text = "# made up\n a, b\r\n\n1,,-2.5e3 \n3";
        let source = Source {
            name: "data.csv".into(),
            text: text.into(),
            on_disk: true,
        };
        let sheet = Sheet::read(FileId(2), &source);
        let shown = |cells: &[Cell<'_>]| -> Vec<String> {
            let at = |cell: &Cell<'_>| {
                &text[cell.span.start as usize..cell.span.end as usize] == cell.text
            };
            assert!(cells.iter().all(at));
            cells.iter().map(|cell| cell.text.to_owned()).collect()
        };
        assert_eq!(shown(&sheet.header), ["a", "b"]);
        let rows: Vec<_> = sheet.rows.iter().map(|row| shown(row)).collect();
        assert_eq!(rows, [vec!["1", "", "-2.5e3"], vec!["3"]]);
    }
}
