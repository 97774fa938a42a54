//! Signals as CSV or Parquet, SI units, one column each.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use crate::cli::failure::{Exit, Failure};
use crate::cli::files;
use crate::report::Table;

/// A file format, by the ending of the name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Csv,
    Parquet,
}

impl Kind {
    /// The format of a path.
    pub(crate) fn of(path: &Path) -> Option<Kind> {
        match path.extension()?.to_str()?.to_lowercase().as_str() {
            "csv" => Some(Kind::Csv),
            "parquet" => Some(Kind::Parquet),
            _ => None,
        }
    }
}

/// Writes `table` to `path`; Parquet also keeps `origin`.
pub(super) fn write(path: &Path, table: &Table, origin: &[(&str, String)]) -> Result<(), Failure> {
    match Kind::of(path) {
        Some(Kind::Csv) => files::write(path, |file| write_csv(file, table)),
        Some(Kind::Parquet) => files::write(path, |file| write_parquet(file, table, origin)),
        None => Err(Failure::new(
            Exit::Usage,
            format_args!("`{}` ends neither in .csv nor in .parquet", path.display()),
        )),
    }
}

/// Numbers in the shortest form that reads back to the same bits.
fn write_csv(file: &mut BufWriter<File>, table: &Table) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer
        .write_record(table.columns().iter().map(|(name, _)| name))
        .map_err(plain)?;
    for row in 0..table.rows() {
        writer
            .write_record(
                table
                    .columns()
                    .iter()
                    .map(|(_, values)| format!("{:?}", values[row])),
            )
            .map_err(plain)?;
    }
    writer.flush()
}

/// The operating system's error behind one of the CSV writer.
pub(super) fn plain(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

fn write_parquet<W: Write + Send>(
    file: W,
    table: &Table,
    origin: &[(&str, String)],
) -> Result<(), ParquetError> {
    let fields = table.columns().iter().map(|(name, _)| {
        let field = Type::primitive_type_builder(name, Physical::DOUBLE)
            .with_repetition(Repetition::REQUIRED);
        field.build().map(Arc::new)
    });
    let schema = Type::group_type_builder("trajectory")
        .with_fields(fields.collect::<Result<_, _>>()?)
        .build()?;
    let pairs = origin
        .iter()
        .map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()));
    let properties = WriterProperties::builder()
        .set_key_value_metadata(Some(pairs.collect()))
        .build();
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    for (_, values) in table.columns() {
        let mut column = group
            .next_column()?
            .expect("invariant: the schema has a column for each signal");
        column
            .typed::<DoubleType>()
            .write_batch(values, None, None)?;
        column.close()?;
    }
    group.close()?;
    writer.close()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use parquet::file::reader::{FileReader as _, SerializedFileReader};
    use parquet::record::RowAccessor as _;

    use super::*;

    fn table() -> Table {
        Table::new(vec![
            ("t".to_owned(), vec![0.0, 0.002, 0.004]),
            ("x1.alpha".to_owned(), vec![1.0 / 3.0, -1e-300, f64::NAN]),
        ])
    }

    #[test]
    fn csv_keeps_every_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        write(&path, &table(), &[]).unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        assert_eq!(
            text,
            "t,x1.alpha\n0.0,0.3333333333333333\n0.002,-1e-300\n0.004,NaN\n"
        );
    }

    #[test]
    fn parquet_keeps_every_bit_and_its_origin() {
        let folder = tempfile::tempdir().unwrap();
        let (path, again) = (
            folder.path().join("run.parquet"),
            folder.path().join("again.parquet"),
        );
        let origin = [("nsv.seed", "7".to_owned())];
        write(&path, &table(), &origin).unwrap();
        write(&again, &table(), &origin).unwrap();
        assert_eq!(
            std::fs::read(&path).unwrap(),
            std::fs::read(&again).unwrap()
        );
        let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
        let metadata = reader.metadata().file_metadata();
        assert_eq!(metadata.num_rows(), 3);
        let seed = metadata
            .key_value_metadata()
            .unwrap()
            .iter()
            .find(|pair| pair.key == "nsv.seed");
        assert_eq!(seed.and_then(|pair| pair.value.as_deref()), Some("7"));
        let rows: Vec<f64> = reader
            .get_row_iter(None)
            .unwrap()
            .map(|row| row.unwrap().get_double(1).unwrap())
            .collect();
        assert_eq!(
            rows.iter().map(|x| x.to_bits()).collect::<Vec<_>>(),
            table()
                .column("x1.alpha")
                .unwrap()
                .iter()
                .map(|x| x.to_bits())
                .collect::<Vec<_>>()
        );
    }

    #[test]
    fn the_ending_decides() {
        assert_eq!(Kind::of(Path::new("a.csv")), Some(Kind::Csv));
        assert_eq!(Kind::of(Path::new("a.b/c.parquet")), Some(Kind::Parquet));
        assert_eq!(Kind::of(Path::new("a.txt")), None);
        assert_eq!(Kind::of(Path::new("csv")), None);
    }
}
