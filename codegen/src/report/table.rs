//! Named columns of numbers, and the format in which the runner writes them.

use serde::Deserialize;

/// Columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Table {
    columns: Vec<(String, Vec<f64>)>,
    rows: usize,
}

/// Why bytes are not a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TableError {
    /// The first line is not the JSON header.
    Header,
    /// The data are shorter or longer than the header says.
    Length,
}

impl std::fmt::Display for TableError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            TableError::Header => "its first line is not a table header",
            TableError::Length => "its length does not match its header",
        })
    }
}

#[derive(Deserialize)]
struct Header {
    columns: Vec<String>,
    rows: usize,
}

impl Table {
    /// A table of the given columns, which have one length.
    #[cfg(test)]
    pub(crate) fn new(columns: Vec<(String, Vec<f64>)>) -> Table {
        let rows = columns.first().map_or(0, |(_, values)| values.len());
        assert!(
            columns.iter().all(|(_, values)| values.len() == rows),
            "invariant: columns of one length"
        );
        Table { columns, rows }
    }

    /// Reads `{"columns": [..], "rows": n}`, a line feed, and n x columns `f64` in little-endian byte order, row by row.
    pub(crate) fn parse(bytes: &[u8]) -> Result<Table, TableError> {
        let end = bytes
            .iter()
            .position(|&byte| byte == b'\n')
            .ok_or(TableError::Header)?;
        let header: Header =
            serde_json::from_slice(&bytes[..end]).map_err(|_| TableError::Header)?;
        let (data, width) = (&bytes[end + 1..], header.columns.len());
        let expected = header
            .rows
            .checked_mul(width)
            .and_then(|count| count.checked_mul(8))
            .ok_or(TableError::Length)?;
        if data.len() != expected {
            return Err(TableError::Length);
        }
        let entry = |row: usize, column: usize| {
            let at = 8 * (row * width + column);
            f64::from_le_bytes(data[at..at + 8].try_into().expect("invariant: eight bytes"))
        };
        let columns = header.columns.into_iter().enumerate();
        let columns = columns
            .map(|(c, name)| (name, (0..header.rows).map(|r| entry(r, c)).collect()))
            .collect();
        Ok(Table {
            columns,
            rows: header.rows,
        })
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    /// Names and values, in order.
    pub(crate) fn columns(&self) -> &[(String, Vec<f64>)] {
        &self.columns
    }

    /// The column of that name.
    pub(crate) fn column(&self, name: &str) -> Option<&[f64]> {
        self.columns
            .iter()
            .find(|(other, _)| other == name)
            .map(|(_, values)| values.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn encoded(header: &str, values: &[f64]) -> Vec<u8> {
        let mut bytes = format!("{header}\n").into_bytes();
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        bytes
    }

    #[test]
    fn rows_are_read_into_columns() {
        let bytes = encoded(
            r#"{"columns": ["t", "y"], "rows": 2}"#,
            &[0.0, 1.5, 0.1, f64::NEG_INFINITY],
        );
        let table = Table::parse(&bytes).unwrap();
        assert_eq!(table.rows(), 2);
        assert_eq!(table.column("t"), Some(&[0.0, 0.1][..]));
        assert_eq!(table.column("y"), Some(&[1.5, f64::NEG_INFINITY][..]));
        assert_eq!(table.column("z"), None);
    }

    #[test]
    fn a_cut_file_is_refused() {
        let bytes = encoded(r#"{"columns": ["t"], "rows": 2}"#, &[0.0]);
        assert_eq!(Table::parse(&bytes), Err(TableError::Length));
        assert_eq!(Table::parse(b"no header"), Err(TableError::Header));
        assert_eq!(Table::parse(b"{}\n"), Err(TableError::Header));
        assert_eq!(
            Table::parse(b"{\"columns\": [\"t\"], \"rows\": 4611686018427387904}\n"),
            Err(TableError::Length)
        );
    }
}
