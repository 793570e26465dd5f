//! A finished study as Apache Parquet: one optional column a quantity, one row group.

use super::row::{Cell, Table};
use parquet::basic::{ConvertedType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::io::{self, Write};
use std::sync::Arc;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Truth,
    Count,
    Number,
    Text,
}

impl Kind {
    /// The narrowest that takes all cells; numbers if there are none.
    fn of<'a>(cells: impl Iterator<Item = &'a Cell>) -> Self {
        let kinds = cells.filter_map(|cell| match cell {
            Cell::Empty => None,
            Cell::Truth(_) => Some(Self::Truth),
            Cell::Number(number) if number.is_i64() => Some(Self::Count),
            Cell::Number(_) => Some(Self::Number),
            Cell::Text(_) => Some(Self::Text),
        });
        kinds
            .reduce(|a, b| match (a, b) {
                (a, b) if a == b => a,
                (Self::Count | Self::Number, Self::Count | Self::Number) => Self::Number,
                _ => Self::Text,
            })
            .unwrap_or(Self::Number)
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
pub fn write_parquet(table: &Table, to: &mut (dyn Write + '_)) -> io::Result<()> {
    // The format's writer is sent to threads, ours is not: the file goes through memory.
    let bytes = encode(table).map_err(io::Error::other)?;
    to.write_all(&bytes)
}

fn encode(table: &Table) -> Result<Vec<u8>, ParquetError> {
    let column = |at: usize| table.rows.iter().map(move |row| row.get(at).unwrap_or(&Cell::Empty));
    let kinds: Vec<Kind> = (0..table.columns.len()).map(|at| Kind::of(column(at))).collect();
    let fields = table.columns.iter().zip(&kinds).map(|(name, kind)| kind.column(name).map(Arc::new));
    let schema = Type::group_type_builder("sweep").with_fields(fields.collect::<Result<_, _>>()?).build()?;
    let properties = WriterProperties::builder().set_created_by(concat!("sheave ", env!("CARGO_PKG_VERSION")).into());
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties.build()))?;
    let mut group = writer.next_row_group()?;
    let mut at = 0;
    while let Some(mut open) = group.next_column()? {
        let cells: Vec<&Cell> = column(at).collect();
        let levels: Vec<i16> = cells.iter().map(|cell| i16::from(!matches!(cell, Cell::Empty))).collect();
        match open.untyped() {
            ColumnWriter::BoolColumnWriter(typed) => {
                let values: Vec<bool> = cells.iter().filter_map(|cell| truth(cell)).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            ColumnWriter::Int64ColumnWriter(typed) => {
                let values: Vec<i64> = cells.iter().filter_map(|cell| count(cell)).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            ColumnWriter::DoubleColumnWriter(typed) => {
                let values: Vec<f64> = cells.iter().filter_map(|cell| cell.number()).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            ColumnWriter::ByteArrayColumnWriter(typed) => {
                let values: Vec<ByteArray> = cells.iter().filter_map(|cell| text(cell)).collect();
                typed.write_batch(&values, Some(&levels), None)?;
            }
            _ => return Err(ParquetError::General("a column of another type".into())),
        }
        open.close()?;
        at += 1;
    }
    group.close()?;
    writer.into_inner()
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
