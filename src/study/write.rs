//! A finished study as a file.

use super::row::Cell;
use super::rows::Rows;
use serde_json::Value;
use std::io::{self, Write};
use std::path::Path;

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values, a header line first.
    Csv,
    /// An array of objects, one a row.
    Json,
    /// Apache Parquet.
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Format {
    /// The format that a file's name asks for.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" => Some(Self::Csv),
            "json" => Some(Self::Json),
            #[cfg(feature = "parquet")]
            "parquet" => Some(Self::Parquet),
            _ => None,
        }
    }

    /// Writes a table.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write(self, table: &dyn Rows, to: &mut (dyn Write + Send + '_)) -> io::Result<()> {
        match self {
            Self::Csv => write_csv(table, to),
            Self::Json => write_json(table, to),
            #[cfg(feature = "parquet")]
            Self::Parquet => super::write_parquet(table, to),
        }
    }
}

/// Writes a header and one line a row; an empty cell is an empty field. Numbers are the shortest that read back the
/// same.
///
/// # Errors
/// What the writer says.
pub fn write_csv(table: &dyn Rows, to: &mut (dyn Write + '_)) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(to);
    writer.write_record(table.columns())?;
    table.each(&mut |row| Ok(writer.write_record(row.iter().map(field))?))?;
    writer.flush()
}

/// A cell as a field of a line.
pub(super) fn field(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Truth(truth) => truth.to_string(),
        Cell::Number(number) => number.to_string(),
        Cell::Text(text) => text.to_string(),
    }
}

/// Writes an array of objects, one a line; an empty cell is `null`.
///
/// # Errors
/// What the writer says.
pub fn write_json(table: &dyn Rows, to: &mut (dyn Write + '_)) -> io::Result<()> {
    to.write_all(b"[")?;
    let mut begun = false;
    table.each(&mut |row| {
        to.write_all(if begun { b",\n" } else { b"\n" })?;
        begun = true;
        let members = table.columns().iter().cloned().zip(row.iter().map(Cell::to_json));
        to.write_all(Value::Object(members.collect()).to_string().as_bytes())
    })?;
    to.write_all(b"\n]\n")
}
