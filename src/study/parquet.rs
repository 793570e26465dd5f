//! A finished study as Apache Parquet: one optional column a quantity, row groups that fit in memory.

use super::row::Cell;
use super::rows::{Rows, holds_text};
use parquet::basic::{ConvertedType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::{self, Write};
use std::sync::Arc;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ColumnKind {
    Truth,
    Count,
    Number,
    Text,
}

/// Rows that are in memory at once.
const GROUP: usize = 8192;

impl ColumnKind {
    /// The narrowest that takes a cell; nothing for an empty one.
    fn of(cell: &Cell) -> Option<Self> {
        match cell {
            Cell::Empty => None,
            Cell::Truth(_) => Some(Self::Truth),
            Cell::Number(number) if number.is_i64() => Some(Self::Count),
            Cell::Number(_) => Some(Self::Number),
            Cell::Text(_) => Some(Self::Text),
        }
    }

    /// The narrowest that takes what two take.
    fn with(self, other: Self) -> Self {
        match (self, other) {
            (a, b) if a == b => a,
            (Self::Count | Self::Number, Self::Count | Self::Number) => Self::Number,
            _ => Self::Text,
        }
    }

    /// Of each column; where all cells are empty, numbers, or texts by its name.
    fn of_columns(table: &dyn Rows) -> io::Result<Vec<Self>> {
        let mut kinds: Vec<Option<Self>> = vec![None; table.columns().len()];
        table.each(&mut |row| {
            for (kind, cell) in kinds.iter_mut().zip(row) {
                let other = Self::of(cell);
                *kind = kind.map_or(other, |kind| Some(other.map_or(kind, |other| kind.with(other))));
            }
            Ok(())
        })?;
        let unseen = |name: &String| if holds_text(name) { Self::Text } else { Self::Number };
        Ok(kinds.into_iter().zip(table.columns()).map(|(kind, name)| kind.unwrap_or_else(|| unseen(name))).collect())
    }

    fn column(self, name: &str) -> Result<Type, ParquetError> {
        let (physical, converted) = match self {
            Self::Truth => (Physical::BOOLEAN, ConvertedType::NONE),
            Self::Count => (Physical::INT64, ConvertedType::NONE),
            Self::Number => (Physical::DOUBLE, ConvertedType::NONE),
            Self::Text => (Physical::BYTE_ARRAY, ConvertedType::UTF8),
        };
        let builder = Type::primitive_type_builder(name, physical);
        builder.with_repetition(Repetition::OPTIONAL).with_converted_type(converted).build()
    }
}

/// Writes a table; an empty cell is null.
///
/// # Errors
/// What the writer says.
pub fn write_parquet(table: &dyn Rows, to: &mut (dyn Write + Send + '_)) -> io::Result<()> {
    write_parquet_with(table, &[], to)
}

/// As [`write_parquet`], with metadata: keys and their values.
///
/// # Errors
/// What the writer says.
pub fn write_parquet_with(
    table: &dyn Rows,
    metadata: &[(String, String)],
    to: &mut (dyn Write + Send + '_),
) -> io::Result<()> {
    let kinds = ColumnKind::of_columns(table)?;
    let fields = table.columns().iter().zip(&kinds).map(|(name, kind)| kind.column(name).map(Arc::new));
    let fields = fields.collect::<Result<_, _>>().map_err(io::Error::other)?;
    let schema = Type::group_type_builder("sweep").with_fields(fields).build().map_err(io::Error::other)?;
    let pair = |(key, value): &(String, String)| KeyValue::new(key.clone(), value.clone());
    let metadata = Some(metadata.iter().map(pair).collect::<Vec<_>>()).filter(|pairs| !pairs.is_empty());
    let properties = WriterProperties::builder().set_key_value_metadata(metadata);
    let properties = properties.set_created_by(concat!("sheave ", env!("CARGO_PKG_VERSION")).into());
    let writer = SerializedFileWriter::new(to, Arc::new(schema), Arc::new(properties.build()));
    let mut writer = writer.map_err(io::Error::other)?;
    let mut columns: Vec<Vec<Cell>> = vec![Vec::new(); kinds.len()];
    let mut rows = 0;
    table.each(&mut |row| {
        columns.iter_mut().zip(row).for_each(|(column, cell)| column.push(cell.clone()));
        rows += 1;
        if rows == GROUP {
            rows = 0;
            write_group(&mut writer, &mut columns).map_err(io::Error::other)?;
        }
        Ok(())
    })?;
    if rows > 0 {
        write_group(&mut writer, &mut columns).map_err(io::Error::other)?;
    }
    writer.close().map(|_| ()).map_err(io::Error::other)
}

/// Writes a row group of these columns, and empties them.
fn write_group<W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    columns: &mut [Vec<Cell>],
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    for cells in columns {
        let Some(mut open) = group.next_column()? else { break };
        let levels: Vec<i16> = cells.iter().map(|cell| i16::from(!matches!(cell, Cell::Empty))).collect();
        match open.untyped() {
            ColumnWriter::BoolColumnWriter(typed) => {
                let values: Vec<bool> = cells.iter().filter_map(truth).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            ColumnWriter::Int64ColumnWriter(typed) => {
                let values: Vec<i64> = cells.iter().filter_map(count).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            ColumnWriter::DoubleColumnWriter(typed) => {
                let values: Vec<f64> = cells.iter().filter_map(Cell::number).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            ColumnWriter::ByteArrayColumnWriter(typed) => {
                let values: Vec<ByteArray> = cells.iter().filter_map(text).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            _ => return Err(ParquetError::General("a column of another type".into())),
        }
        open.close()?;
        cells.clear();
    }
    group.close().map(|_| ())
}

fn truth(cell: &Cell) -> Option<bool> {
    if let Cell::Truth(truth) = cell { Some(*truth) } else { None }
}

fn count(cell: &Cell) -> Option<i64> {
    if let Cell::Number(number) = cell { number.as_i64() } else { None }
}

fn text(cell: &Cell) -> Option<ByteArray> {
    match cell {
        Cell::Empty => None,
        Cell::Text(text) => Some(ByteArray::from(text.as_bytes().to_vec())),
        other => Some(ByteArray::from(other.to_json().to_string().into_bytes())),
    }
}
