//! Rows as they come, kept on disk: whatever ends the program, none is lost.
//!
//! A journal is lines of JSON: first what the study is, then sets of column names (`{"columns": [..]}`) and rows
//! (`[point, set, [cells]]`) as they come. Every line is handed to the system whole; of one that is torn at the
//! end, nothing is believed.

use super::plan::Study;
use super::row::{Cell, Columns, Row, TableBuilder};
use serde_json::Value;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

/// Rows of a study that is under way, on disk and in memory.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    rows: TableBuilder,
}

/// Why a journal cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JournalError {
    /// It belongs to another study.
    #[error("{path} belongs to another study: other axes, case, options or version; without --resume it is begun anew")]
    Other {
        /// The journal.
        path: String,
    },
    /// A line that no journal has.
    #[error("{path}, line {line}: this is not a line of a study's journal")]
    Line {
        /// The journal.
        path: String,
        /// Counted from 1.
        line: usize,
    },
    /// The system's word.
    #[error("{path}: {error}")]
    System {
        /// The journal.
        path: String,
        /// What the system says.
        error: io::Error,
    },
}

impl Journal {
    /// Begins a journal at `path`, in place of one that may be there.
    ///
    /// # Errors
    /// [`JournalError::System`].
    pub fn begin(path: &Path, study: &Study) -> Result<Self, JournalError> {
        let system = |error| JournalError::System { path: path.display().to_string(), error };
        let mut file = File::create(path).map_err(system)?;
        file.write_all(format!("{}\n", study.fingerprint()).as_bytes()).map_err(system)?;
        Ok(Self { path: path.into(), file, rows: TableBuilder::new(study.points()) })
    }

    /// Goes on with the journal at `path`, which must be one of the same study; begins one if there is none.
    ///
    /// # Errors
    /// See [`JournalError`].
    pub fn resume(path: &Path, study: &Study) -> Result<Self, JournalError> {
        let system = |error| JournalError::System { path: path.display().to_string(), error };
        let mut reader = match File::open(path) {
            Ok(file) => BufReader::new(file),
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Self::begin(path, study),
            Err(error) => return Err(system(error)),
        };
        let mut rows = TableBuilder::new(study.points());
        let (mut line, mut length, mut number) = (Vec::new(), 0_u64, 0);
        loop {
            line.clear();
            reader.read_until(b'\n', &mut line).map_err(system)?;
            // Torn, or the end.
            let Some(text) = line.strip_suffix(b"\n") else { break };
            number += 1;
            if number == 1 {
                if text != study.fingerprint().as_bytes() {
                    return Err(JournalError::Other { path: path.display().to_string() });
                }
            } else if read_line(text, &mut rows).is_none() {
                return Err(JournalError::Line { path: path.display().to_string(), line: number });
            }
            length += line.len() as u64;
        }
        if number == 0 {
            return Self::begin(path, study);
        }
        let file = OpenOptions::new().append(true).open(path).map_err(system)?;
        file.set_len(length).map_err(system)?;
        Ok(Self { path: path.into(), file, rows })
    }

    /// The rows there are.
    pub fn rows(&self) -> &TableBuilder {
        &self.rows
    }

    /// Adds a row, and returns when the system has it.
    ///
    /// # Errors
    /// What the system says.
    pub fn add(&mut self, row: Row) -> io::Result<()> {
        if self.rows.has(row.index) {
            return Ok(());
        }
        let mut lines = String::new();
        let (layout, new) = self.rows.layout(row.columns);
        if new && let Some(names) = self.rows.names(layout) {
            lines = serde_json::json!({ "columns": names }).to_string() + "\n";
        }
        let cells: Vec<Value> = row.cells.iter().map(Cell::to_json).collect();
        lines += &serde_json::json!([row.index, layout, cells]).to_string();
        lines.push('\n');
        self.file.write_all(lines.as_bytes())?;
        self.rows.put(row.index, layout, row.cells);
        Ok(())
    }

    /// Ends the journal: gives the rows, and the file to be removed when they are safe elsewhere.
    pub fn finish(self) -> (TableBuilder, PathBuf) {
        (self.rows, self.path)
    }
}

fn read_line(text: &[u8], rows: &mut TableBuilder) -> Option<()> {
    match serde_json::from_slice(text).ok()? {
        Value::Object(mut members) => {
            let Value::Array(names) = members.remove("columns")? else { return None };
            let name = |name: Value| name.as_str().map(str::to_owned);
            rows.layout(names.into_iter().map(name).collect::<Option<Columns>>()?);
        }
        Value::Array(parts) => {
            let [index, layout, Value::Array(cells)] = <[Value; 3]>::try_from(parts).ok()? else { return None };
            let (index, layout) = (usize::try_from(index.as_u64()?).ok()?, usize::try_from(layout.as_u64()?).ok()?);
            let cells = cells.into_iter().map(Cell::from_json).collect::<Option<Vec<Cell>>>()?;
            if rows.names(layout)?.len() != cells.len() {
                return None;
            }
            rows.put(index, layout, cells);
        }
        _ => return None,
    }
    Some(())
}
