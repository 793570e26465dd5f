//! Rows as comma-separated values, written while the study runs.

use super::plan::Study;
use super::row::{Cell, Columns, Row};
use super::write::field;
use std::collections::BTreeMap;
use std::io::{self, Write};

/// Writes rows in input order as soon as all before them are there.
///
/// The header stands before the first row, so that the study's rows must have the same columns, see
/// [`Study::is_uniform`]. They are known from the first row that has a solution, or at the end; of rows without one
/// that have to wait for it, only the reason is kept.
#[derive(Debug)]
pub struct Stream<'a, W: Write> {
    study: &'a Study,
    writer: csv::Writer<W>,
    columns: Option<Columns>,
    next: usize,
    waiting: BTreeMap<usize, Waiting>,
    failures: usize,
}

/// A row that has to wait for those before it.
#[derive(Debug)]
enum Waiting {
    /// With its solution.
    Solved(Row),
    /// Without one: why.
    Failed(String),
}

impl<'a, W: Write> Stream<'a, W> {
    /// For the rows of a study.
    pub fn new(study: &'a Study, to: W) -> Self {
        let writer = csv::Writer::from_writer(to);
        Self { study, writer, columns: None, next: 0, waiting: BTreeMap::new(), failures: 0 }
    }

    /// How many of the rows so far have no solution.
    pub fn failures(&self) -> usize {
        self.failures
    }

    /// Takes a row, and writes those whose turn has come.
    ///
    /// # Errors
    /// What the writer says: a pipe that nobody reads any more is one.
    pub fn add(&mut self, row: Row) -> io::Result<()> {
        let waiting = match row.failure() {
            Some(reason) => {
                self.failures += 1;
                (row.index, Waiting::Failed(reason.to_owned()))
            }
            None => {
                self.columns.get_or_insert_with(|| row.columns.clone());
                (row.index, Waiting::Solved(row))
            }
        };
        self.waiting.insert(waiting.0, waiting.1);
        if self.columns.is_some() { self.write_ready() } else { Ok(()) }
    }

    /// Writes what is left.
    ///
    /// # Errors
    /// What the writer says.
    pub fn finish(mut self) -> io::Result<()> {
        if self.columns.is_none() {
            // Nothing was solved: the columns of all rows without a solution.
            let mut columns = Columns::new();
            for (index, waiting) in &self.waiting {
                let row = self.row(*index, waiting)?;
                if columns.is_empty() || row.columns.len() > columns.len() {
                    columns = row.columns;
                }
            }
            self.columns = Some(columns);
        }
        self.write_ready()
    }

    fn row(&self, index: usize, waiting: &Waiting) -> io::Result<Row> {
        match waiting {
            Waiting::Solved(row) => Ok(row.clone()),
            Waiting::Failed(reason) => {
                let point = self.study.point(index).map_err(io::Error::other)?;
                Ok(Row::new(index, &point, Err(reason.clone())))
            }
        }
    }

    fn write_ready(&mut self) -> io::Result<()> {
        let begun = self.next;
        while let Some(waiting) = self.waiting.remove(&self.next) {
            let row = self.row(self.next, &waiting)?;
            let columns = self.columns.as_deref().unwrap_or_default();
            if self.next == 0 {
                self.writer.write_record(columns)?;
            }
            let cell = |name: &String| {
                let at = row.columns.iter().position(|other| other == name);
                at.and_then(|at| row.cells.get(at)).unwrap_or(&Cell::Empty)
            };
            self.writer.write_record(columns.iter().map(|name| field(cell(name))))?;
            self.next += 1;
        }
        if self.next > begun { self.writer.flush() } else { Ok(()) }
    }
}
