//! Tables of studies, handed over without copies through the Arrow PyCapsule interface.

use crate::{convert, file};
use arrow_array::builder::{BooleanBuilder, Int64Builder, StringBuilder};
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{Array, ArrayRef, Float64Array, RecordBatch, RecordBatchIterator};
use arrow_schema::ffi::FFI_ArrowSchema;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use numpy::PyArray1;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use serde_json::Value;
use sheave::study::{self, Cell, Format};
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

/// A finished study: one row a point in input order; the keys that vary, `converged`, every scalar of the result in SI
/// units with dots in its name, and `failure`, the reason why a point has no solution.
///
/// Whatever reads Arrow reads it without a copy: `pyarrow.table(table)`, `polars.DataFrame(table)`,
/// `pandas.DataFrame.from_arrow(table)`. A column of numbers is an array of numpy: `table["efficiency.overall"]`, not a
/// number where a point has no solution.
#[pyclass(frozen, module = "sheave")]
pub struct Table {
    table: study::Table,
    /// What varies: keys and number of points of each axis.
    axes: Vec<(Vec<String>, usize)>,
    arrow: OnceLock<RecordBatch>,
}

impl Table {
    pub fn new(table: study::Table, axes: Vec<(Vec<String>, usize)>) -> Self {
        Self { table, axes, arrow: OnceLock::new() }
    }

    /// Made when it is first asked for.
    fn arrow(&self) -> PyResult<&RecordBatch> {
        if let Some(batch) = self.arrow.get() {
            return Ok(batch);
        }
        let batch = batch(&self.table).map_err(refused)?;
        Ok(self.arrow.get_or_init(|| batch))
    }
}

fn refused(error: ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl Table {
    /// Names of the columns.
    #[getter]
    fn columns(&self) -> Vec<String> {
        self.table.columns.clone()
    }

    /// What varies: for each axis, its keys and its number of points. The last axis is the fastest.
    #[getter]
    fn axes(&self) -> Vec<(Vec<String>, usize)> {
        self.axes.clone()
    }

    /// How many points have no solution.
    #[getter]
    fn failures(&self) -> usize {
        self.table.failures()
    }

    fn __len__(&self) -> usize {
        self.table.rows.len()
    }

    /// A column: an array of numpy for numbers, a list for names and truths.
    fn __getitem__<'py>(slf: &Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let table = &slf.get().table;
        let at = table.column(name).ok_or_else(|| PyKeyError::new_err(format!("no column `{name}`")))?;
        let array = slf.get().arrow()?.column(at);
        if let Some(numbers) = array.as_any().downcast_ref::<Float64Array>() {
            return Ok(convert::borrowed(slf.clone().into_any(), numbers.values())?.into_any());
        }
        let cells = table.rows.iter().map(|row| row.get(at).unwrap_or(&Cell::Empty));
        if *array.data_type() == DataType::Int64 {
            // Counts, as numbers where a point has none.
            let numbers = cells.map(|cell| cell.number().unwrap_or(f64::NAN));
            return Ok(PyArray1::from_iter(slf.py(), numbers).into_any());
        }
        convert::object(slf.py(), &cells.map(Cell::to_json).collect::<Vec<_>>())
    }

    /// Writes the table into a file, as `sheave sweep --out` does: .csv, .parquet or .json. The file appears whole.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let format = Format::of(&path)
            .ok_or_else(|| PyValueError::new_err("expected a file name that ends in .csv, .parquet or .json"))?;
        file::write(py, &path, |to| format.write(&self.table, to))
    }

    /// The Arrow PyCapsule interface: the schema.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(self.arrow()?.schema().as_ref()).map_err(refused)?;
        PyCapsule::new_with_value(py, schema, c"arrow_schema")
    }

    /// The Arrow PyCapsule interface: the table.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // Whoever asks may ask for other types; none are offered, as the interface allows.
        let _ = requested_schema;
        let batch = self.arrow()?.clone();
        let schema = batch.schema();
        let stream = FFI_ArrowArrayStream::new(Box::new(RecordBatchIterator::new([Ok(batch)], schema)));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// As a table of pyarrow, without a copy.
    fn to_arrow<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        tables(slf, "to_arrow")
    }

    /// As a DataFrame of pandas.
    fn to_pandas<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        tables(slf, "to_pandas")
    }

    /// As a DataFrame of polars, without a copy.
    fn to_polars<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        tables(slf, "to_polars")
    }

    /// As a Dataset of xarray: a dimension for each axis, named by its first key, and every column over them.
    fn to_xarray<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        tables(slf, "to_xarray")
    }

    /// Made anew from its cells, with every digit.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (py, this) = (slf.py(), slf.get());
        let rebuild = py.import("sheave._sheave")?.getattr("rebuild_table")?;
        let row = |row: &Vec<Cell>| row.iter().map(Cell::to_json).collect();
        let rows: Vec<Vec<Value>> = this.table.rows.iter().map(row).collect();
        let rows = serde_json::to_string(&rows).map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok((rebuild, (this.columns(), rows, this.axes()).into_pyobject(py)?.into_any()))
    }

    fn __repr__(&self) -> String {
        let axes = self.axes.iter().map(|(keys, points)| format!("{} ({points})", keys.join(" & ")));
        let axes = axes.collect::<Vec<_>>().join(" × ");
        let failures = match self.failures() {
            0 => String::new(),
            some => format!(", {some} without a solution"),
        };
        format!("<sheave.Table: {} points over {axes}{failures}>", self.table.rows.len())
    }
}

/// A table from what `Table.__reduce__` gives: for `pickle`.
#[pyfunction]
pub fn rebuild_table(columns: Vec<String>, rows: &str, axes: Vec<(Vec<String>, usize)>) -> PyResult<Table> {
    let rows: Vec<Vec<Value>> =
        serde_json::from_str(rows).map_err(|error| PyValueError::new_err(format!("rows: {error}")))?;
    let cell = |value| match value {
        Value::Bool(truth) => Cell::Truth(truth),
        Value::Number(number) => Cell::Number(number),
        Value::String(text) => Cell::Text(text.into()),
        Value::Null | Value::Array(_) | Value::Object(_) => Cell::Empty,
    };
    let rows = rows.into_iter().map(|row| row.into_iter().map(cell).collect()).collect();
    Ok(Table::new(study::Table { columns, rows }, axes))
}

/// What Python's libraries make of the table is written in Python.
fn tables<'py>(table: &Bound<'py, Table>, function: &str) -> PyResult<Bound<'py, PyAny>> {
    table.py().import("sheave.tables")?.call_method1(function, (table,))
}

/// What a column holds: the narrowest type that takes all its cells; numbers where all are empty.
fn column(table: &study::Table, at: usize) -> (DataType, ArrayRef) {
    let cells = || table.rows.iter().map(move |row| row.get(at).unwrap_or(&Cell::Empty));
    let all = |of: fn(&Cell) -> bool| cells().all(|cell| matches!(cell, Cell::Empty) || of(cell));
    let some = cells().any(|cell| !matches!(cell, Cell::Empty));
    if !some && table.columns.get(at).is_some_and(|name| study::holds_text(name)) {
        let mut builder = StringBuilder::new();
        cells().for_each(|_| builder.append_null());
        return (DataType::Utf8, Arc::new(builder.finish()));
    }
    if some && all(|cell| matches!(cell, Cell::Truth(_))) {
        let mut builder = BooleanBuilder::new();
        cells().for_each(|cell| builder.append_option(if let Cell::Truth(truth) = cell { Some(*truth) } else { None }));
        return (DataType::Boolean, Arc::new(builder.finish()));
    }
    if some && all(|cell| matches!(cell, Cell::Number(number) if number.is_i64())) {
        let mut builder = Int64Builder::new();
        cells().for_each(|cell| {
            builder.append_option(if let Cell::Number(number) = cell { number.as_i64() } else { None })
        });
        return (DataType::Int64, Arc::new(builder.finish()));
    }
    if all(|cell| matches!(cell, Cell::Number(_))) {
        // Where there is no number the buffer has NaN, so that the same memory serves numpy.
        let values: Vec<f64> = cells().map(|cell| cell.number().unwrap_or(f64::NAN)).collect();
        let missing = cells().map(|cell| !matches!(cell, Cell::Empty)).collect::<Vec<_>>();
        let nulls = missing.iter().any(|there| !there).then(|| missing.into());
        return (DataType::Float64, Arc::new(Float64Array::new(values.into(), nulls)));
    }
    let mut builder = StringBuilder::new();
    cells().for_each(|cell| match cell {
        Cell::Empty => builder.append_null(),
        Cell::Text(text) => builder.append_value(text),
        other => builder.append_value(other.to_json().to_string()),
    });
    (DataType::Utf8, Arc::new(builder.finish()))
}

fn batch(table: &study::Table) -> Result<RecordBatch, ArrowError> {
    let columns = table.columns.iter().enumerate().map(|(at, name)| {
        let (kind, array) = column(table, at);
        (Field::new(name, kind, true), array)
    });
    let (fields, arrays): (Vec<Field>, Vec<ArrayRef>) = columns.unzip();
    RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays)
}
