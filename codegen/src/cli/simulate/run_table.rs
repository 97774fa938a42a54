//! A row for each run as CSV or Parquet, converted piece by piece from the simulator's file, so that memory does not grow with the runs.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::{BoolType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{Type, TypePtr};
use serde::Deserialize;

use super::trajectory::{Kind, plain};
use crate::cli::failure::{Exit, Failure};
use crate::cli::files;

/// Rows in memory at a time, and in a row group.
const PIECE: usize = 1 << 16;

/// The first columns are whole numbers of 64 bits: the number of the run, its samples, and whether it diverged.
const RUN: usize = 0;
const DIVERGED: usize = 2;
const WHOLE: usize = 3;

/// Writes the simulator's rows in `table` to `path`; Parquet also keeps `origin`.
pub(super) fn convert(table: &Path, path: &Path, origin: &[(&str, String)]) -> Result<(), Failure> {
    let unreadable = |error: &io::Error| Failure::io("read", table, error);
    let mut rows = Rows::open(table).map_err(|error| unreadable(&error))?;
    match Kind::of(path) {
        Some(Kind::Csv) => files::write(path, |file| write_csv(file, &mut rows)),
        Some(Kind::Parquet) => files::write(path, |file| write_parquet(file, &mut rows, origin)),
        None => Err(Failure::new(
            Exit::Usage,
            format_args!("`{}` ends neither in .csv nor in .parquet", path.display()),
        )),
    }
}

#[derive(Deserialize)]
struct Header {
    columns: Vec<String>,
    rows: usize,
}

/// Rows of numbers of 8 bytes behind a line that names them.
struct Rows<R> {
    header: Header,
    read: usize,
    source: R,
}

impl Rows<BufReader<File>> {
    fn open(path: &Path) -> io::Result<Self> {
        Rows::new(BufReader::new(File::open(path)?))
    }
}

impl<R: io::BufRead> Rows<R> {
    fn new(mut source: R) -> io::Result<Self> {
        let mut line = Vec::new();
        source.read_until(b'\n', &mut line)?;
        let header: Header = serde_json::from_slice(&line)?;
        if header.columns.len() < WHOLE {
            return Err(io::Error::other("it has too few columns"));
        }
        Ok(Rows {
            header,
            read: 0,
            source,
        })
    }

    /// The bits of the next rows, row after row, at most so many; none at the end.
    fn next(&mut self, most: usize) -> io::Result<Vec<u64>> {
        let rows = most.min(self.header.rows - self.read);
        self.read += rows;
        let mut bytes = vec![0; 8 * rows * self.header.columns.len()];
        self.source.read_exact(&mut bytes)?;
        let number = |chunk: &[u8]| {
            u64::from_le_bytes(chunk.try_into().expect("invariant: chunks of eight bytes"))
        };
        Ok(bytes.chunks_exact(8).map(number).collect())
    }
}

/// Numbers in the shortest form that reads back to the same bits.
fn write_csv<R: io::BufRead>(file: &mut BufWriter<File>, rows: &mut Rows<R>) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record(&rows.header.columns).map_err(plain)?;
    let width = rows.header.columns.len();
    loop {
        let piece = rows.next(PIECE)?;
        if piece.is_empty() {
            return writer.flush();
        }
        for row in piece.chunks_exact(width) {
            let fields = row.iter().enumerate().map(|(column, &bits)| match column {
                DIVERGED => (bits != 0).to_string(),
                RUN..WHOLE => bits.to_string(),
                _ => format!("{:?}", f64::from_bits(bits)),
            });
            writer.write_record(fields).map_err(plain)?;
        }
    }
}

fn write_parquet<W: Write + Send, R: io::BufRead>(
    file: W,
    rows: &mut Rows<R>,
    origin: &[(&str, String)],
) -> Result<(), ParquetError> {
    let pairs = origin
        .iter()
        .map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()));
    let properties = WriterProperties::builder()
        .set_key_value_metadata(Some(pairs.collect()))
        .build();
    let schema = schema(&rows.header.columns)?;
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties))?;
    let width = rows.header.columns.len();
    loop {
        let piece = rows.next(PIECE)?;
        if piece.is_empty() {
            writer.close()?;
            return Ok(());
        }
        let mut group = writer.next_row_group()?;
        for column in 0..width {
            let bits = piece.iter().skip(column).step_by(width);
            let mut writer = group
                .next_column()?
                .expect("invariant: the schema has every column");
            match column {
                DIVERGED => {
                    let values: Vec<bool> = bits.map(|bits| *bits != 0).collect();
                    writer
                        .typed::<BoolType>()
                        .write_batch(&values, None, None)?
                }
                RUN..WHOLE => {
                    let values: Vec<i64> = bits.map(|bits| bits.cast_signed()).collect();
                    writer
                        .typed::<Int64Type>()
                        .write_batch(&values, None, None)?
                }
                _ => {
                    let values: Vec<f64> = bits.map(|bits| f64::from_bits(*bits)).collect();
                    writer
                        .typed::<DoubleType>()
                        .write_batch(&values, None, None)?
                }
            };
            writer.close()?;
        }
        group.close()?;
    }
}

/// The types of the columns.
fn schema(columns: &[String]) -> Result<TypePtr, ParquetError> {
    let field = |(column, name): (usize, &String)| {
        let physical = match column {
            DIVERGED => Physical::BOOLEAN,
            RUN..WHOLE => Physical::INT64,
            _ => Physical::DOUBLE,
        };
        let field = Type::primitive_type_builder(name, physical);
        let field = field.with_repetition(Repetition::REQUIRED).build();
        field.map(Arc::new)
    };
    let fields: Result<Vec<TypePtr>, ParquetError> =
        columns.iter().enumerate().map(field).collect();
    let group = Type::group_type_builder("runs").with_fields(fields?);
    group.build().map(Arc::new)
}

#[cfg(test)]
mod tests {
    use parquet::file::reader::{FileReader as _, SerializedFileReader};
    use parquet::record::RowAccessor as _;

    use super::*;

    /// A file of so many rows.
    fn table(path: &Path, rows: u64) {
        let mut bytes = format!(
            "{{\"columns\": [\"run\", \"samples\", \"diverged\", \"ratio\"], \"rows\": {rows}}}\n"
        )
        .into_bytes();
        for run in 0..rows {
            for bits in [7 + run, 100, run % 2, (0.1 * run as f64).to_bits()] {
                bytes.extend(bits.to_le_bytes());
            }
        }
        std::fs::write(path, bytes).unwrap();
    }

    #[test]
    fn rows_become_csv() {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (folder.path().join("runs"), folder.path().join("runs.csv"));
        table(&from, 3);
        convert(&from, &to, &[]).unwrap();
        assert_eq!(
            std::fs::read_to_string(to).unwrap(),
            "run,samples,diverged,ratio\n7,100,false,0.0\n8,100,true,0.1\n9,100,false,0.2\n"
        );
    }

    #[test]
    fn rows_become_parquet_piece_by_piece() {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (
            folder.path().join("runs"),
            folder.path().join("runs.parquet"),
        );
        let rows = PIECE as u64 + 10;
        table(&from, rows);
        convert(&from, &to, &[("nsv.seed", "7".to_owned())]).unwrap();
        let reader = SerializedFileReader::new(File::open(to).unwrap()).unwrap();
        assert_eq!(reader.metadata().num_row_groups(), 2);
        assert_eq!(reader.metadata().file_metadata().num_rows() as u64, rows);
        let last = reader.get_row_iter(None).unwrap().last().unwrap().unwrap();
        assert_eq!(last.get_long(0).unwrap() as u64, 7 + rows - 1);
        assert_eq!(last.get_bool(2).unwrap(), (rows - 1) % 2 == 1);
        assert_eq!(last.get_double(3).unwrap(), 0.1 * (rows - 1) as f64);
    }

    #[test]
    fn a_cut_file_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (folder.path().join("runs"), folder.path().join("runs.csv"));
        table(&from, 3);
        let bytes = std::fs::read(&from).unwrap();
        std::fs::write(&from, &bytes[..bytes.len() - 1]).unwrap();
        assert!(convert(&from, &to, &[]).is_err());
        assert!(!to.exists());
    }
}
