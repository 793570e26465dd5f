//! Rows of a table in input order, wherever they are kept.

use super::journal::line::read_row;
use super::row::{Cell, Layouts, Table};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Seek, SeekFrom};
use std::path::PathBuf;

/// Whether a column of this name holds texts, also where all its cells are empty: tables of several parts of a study
/// have the same types then.
pub fn holds_text(column: &str) -> bool {
    matches!(column, "failure" | "edition" | "stop")
}

/// What a table's writers need of it; it can be gone through more than once.
pub trait Rows {
    /// Names of the columns.
    fn columns(&self) -> &[String];

    /// Shows every row in input order, each with as many cells as there are columns.
    ///
    /// # Errors
    /// What `see` says, and what the system says if a row cannot be read.
    fn each(&self, see: &mut dyn FnMut(&[Cell]) -> io::Result<()>) -> io::Result<()>;
}

impl Rows for Table {
    fn columns(&self) -> &[String] {
        &self.columns
    }

    fn each(&self, see: &mut dyn FnMut(&[Cell]) -> io::Result<()>) -> io::Result<()> {
        self.rows.iter().try_for_each(|row| see(row))
    }
}

/// The rows of a journal that is complete, read from its file.
#[derive(Debug)]
pub struct StoredRows {
    path: PathBuf,
    file: File,
    columns: Vec<String>,
    /// By set of names: the column of each name.
    spread: Vec<Vec<Option<usize>>>,
    places: Vec<(u64, u32)>,
    failures: usize,
}

impl StoredRows {
    pub(super) fn new(path: PathBuf, file: File, layouts: Layouts, places: Vec<(u64, u32)>, failures: usize) -> Self {
        let there = places.iter().filter(|(place, _)| *place != 0);
        let (columns, spread) = layouts.joined(there.map(|(_, layout)| *layout as usize));
        Self { path, file, columns, spread, places, failures }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.places.iter().filter(|(place, _)| *place != 0).count()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many points have no solution.
    pub fn failures(&self) -> usize {
        self.failures
    }

    /// Removes the journal's file, when its rows are safe elsewhere.
    ///
    /// # Errors
    /// What the system says.
    pub fn remove(self) -> io::Result<()> {
        // While it is still locked: nobody else's is removed.
        std::fs::remove_file(&self.path)
    }
}

impl Rows for StoredRows {
    fn columns(&self) -> &[String] {
        &self.columns
    }

    fn each(&self, see: &mut dyn FnMut(&[Cell]) -> io::Result<()>) -> io::Result<()> {
        let mut reader = BufReader::new(&self.file);
        reader.seek(SeekFrom::Start(0))?;
        let (mut at, mut line) = (0_u64, Vec::new());
        let mut row = vec![Cell::Empty; self.columns.len()];
        for (place, _) in self.places.iter().filter(|(place, _)| *place != 0) {
            reader.seek_relative((*place).cast_signed().wrapping_sub(at.cast_signed()))?;
            line.clear();
            at = place + reader.read_until(b'\n', &mut line)? as u64;
            let read = line.strip_suffix(b"\n").and_then(read_row);
            let spread = read.and_then(|(layout, cells)| Some((self.spread.get(layout)?, cells)));
            let Some((spread, cells)) = spread else {
                let said = format!("{}: a row was damaged while the sweep ran", self.path.display());
                return Err(io::Error::new(io::ErrorKind::InvalidData, said));
            };
            row.fill(Cell::Empty);
            for (cell, column) in cells.into_iter().zip(spread) {
                if let Some(slot) = column.and_then(|column| row.get_mut(column)) {
                    *slot = cell;
                }
            }
            see(&row)?;
        }
        Ok(())
    }
}
