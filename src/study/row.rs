//! Rows of a study, and the table they make.

use super::plan::GridPoint;
use crate::case::Setting;
use crate::model::{InternalError, Output};
use crate::result::Outcome;
use serde::Serialize;
use serde_json::{Number, Value};
use std::collections::HashMap;

/// The one scalar of a result that is a clock's: it stays empty in a study, whose rows depend on its inputs alone.
const CLOCK: &str = "solver.wall_time";

/// The column that says whether a point has a solution.
const CONVERGED: &str = "converged";
/// The column that says why a point has none.
const FAILURE: &str = "failure";

/// One scalar.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing: of a point without a solution, or of an edition that does not have the quantity.
    Empty,
    /// Yes or no.
    Truth(bool),
    /// A number in SI units, or a count.
    Number(Number),
    /// A name or a reason.
    Text(Box<str>),
}

impl Cell {
    /// As a number.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => number.as_f64(),
            _ => None,
        }
    }

    /// As a JSON value.
    pub fn to_json(&self) -> Value {
        match self {
            Self::Empty => Value::Null,
            Self::Truth(truth) => Value::Bool(*truth),
            Self::Number(number) => Value::Number(number.clone()),
            Self::Text(text) => Value::String(text.to_string()),
        }
    }

    /// The value of a key; nothing for one that is no scalar.
    pub(crate) fn of_setting(setting: &Setting) -> Option<Self> {
        match setting {
            Setting::Number(value) => Some(Number::from_f64(*value).map_or(Self::Empty, Self::Number)),
            Setting::Name(name) => Some(Self::Text((*name).into())),
            Setting::List(_) | Setting::Table(_) => None,
        }
    }

    pub(super) fn from_json(value: Value) -> Option<Self> {
        match value {
            Value::Null => Some(Self::Empty),
            Value::Bool(truth) => Some(Self::Truth(truth)),
            Value::Number(number) => Some(Self::Number(number)),
            Value::String(text) => Some(Self::Text(text.into())),
            Value::Array(_) | Value::Object(_) => None,
        }
    }
}

/// Names of columns, in order.
pub type Columns = Vec<String>;

/// What one point of a study gave: the varied keys, `converged`, every scalar of the result with dots, `failure`.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Place of the point in input order.
    pub index: usize,
    /// Names.
    pub columns: Columns,
    /// Values, as many as names.
    pub cells: Vec<Cell>,
}

impl Row {
    /// The row of a point: its result, or why there is none.
    pub fn new(index: usize, point: &GridPoint, outcome: Result<&Outcome, String>) -> Self {
        let mut row = Self { index, columns: Vec::new(), cells: Vec::new() };
        for (key, setting) in &point.varied {
            if let Some(cell) = Cell::of_setting(setting) {
                row.put(key.path().to_owned(), cell);
            }
        }
        let result = outcome.and_then(|outcome| object(&outcome.result, "a result"));
        row.put(CONVERGED.into(), Cell::Truth(result.is_ok()));
        // Of a case that makes no sense there are no inputs.
        let (members, failure) = match (result, &point.case) {
            (Ok(result), _) => (Some(("", result)), None),
            (Err(reason), Err(_)) => (None, Some(reason)),
            (Err(reason), Ok(case)) => match object(case, "a case") {
                Ok(inputs) => (Some(("inputs", inputs)), Some(reason)),
                Err(also) => (None, Some(format!("{reason}; {also}"))),
            },
        };
        if let Some((name, members)) = members {
            let before = row.columns.len();
            row.flatten(&mut name.to_owned(), members, before);
        }
        row.put(FAILURE.into(), failure.map_or(Cell::Empty, |reason| Cell::Text(reason.into())));
        row
    }

    /// Why the point has no solution; nothing if it has one.
    pub fn failure(&self) -> Option<&str> {
        let at = self.columns.iter().position(|name| name == FAILURE)?;
        match self.cells.get(at)? {
            Cell::Text(reason) => Some(reason),
            _ => None,
        }
    }

    /// Adds the scalars of a value under `name` with dots; `name` is the same afterwards. A name that is there already
    /// keeps its first value: it can only be among the first `before`, for the members of an object differ.
    fn flatten(&mut self, name: &mut String, value: Value, before: usize) {
        match value {
            Value::Object(members) => {
                let len = name.len();
                for (member, value) in members {
                    if len > 0 {
                        name.push('.');
                    }
                    name.push_str(&member);
                    self.flatten(name, value, before);
                    name.truncate(len);
                }
            }
            Value::Array(_) => {}
            _ if name.is_empty() => {}
            value => {
                let value = if name == CLOCK { Value::Null } else { value };
                if let Some(cell) = Cell::from_json(value)
                    && !self.columns.iter().take(before).any(|column| column == name)
                {
                    self.columns.push(name.clone());
                    self.cells.push(cell);
                }
            }
        }
    }

    /// Adds a cell; a name that is there already keeps its first value.
    fn put(&mut self, name: String, cell: Cell) {
        if !self.columns.contains(&name) {
            self.columns.push(name);
            self.cells.push(cell);
        }
    }
}

/// What can be written as JSON, which everything of this program can; else why not.
fn object(of: &impl Serialize, what: &'static str) -> Result<Value, String> {
    serde_json::to_value(of).map_err(|_| InternalError::Json(what).to_string())
}

/// A finished study: one row a point, in input order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// Names of the columns: the varied keys, `converged`, the result's scalars, `failure`.
    pub columns: Columns,
    /// Rows, each with as many cells as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Place of a column.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// A number of a row; NaN where there is none.
    pub fn number(&self, row: usize, column: &str) -> f64 {
        let cell = self.column(column).and_then(|at| self.rows.get(row)?.get(at));
        cell.and_then(Cell::number).unwrap_or(f64::NAN)
    }

    /// An output in a row; NaN where there is none.
    pub fn output(&self, row: usize, output: Output) -> f64 {
        self.number(row, output.name())
    }

    /// How many points have no solution.
    pub fn failures(&self) -> usize {
        let Some(at) = self.column(CONVERGED) else { return 0 };
        self.rows.iter().filter(|row| row.get(at) != Some(&Cell::Truth(true))).count()
    }
}

/// The sets of column names that rows have, each kept once and numbered.
#[derive(Debug, Default)]
pub(super) struct Layouts {
    /// By number; none where a journal lost it.
    names: Vec<Option<Columns>>,
    known: HashMap<Columns, usize>,
}

impl Layouts {
    /// Number of a set of names, and whether it is new.
    pub(super) fn number(&mut self, columns: Columns) -> (usize, bool) {
        if let Some(&known) = self.known.get(&columns) {
            return (known, false);
        }
        self.names.push(Some(columns.clone()));
        self.known.insert(columns, self.names.len() - 1);
        (self.names.len() - 1, true)
    }

    /// Takes in a set of names under its number; nothing if that cannot be.
    pub(super) fn put(&mut self, number: usize, columns: Columns) -> Option<()> {
        /// Far more sets than any study has.
        const MOST: usize = 1 << 16;
        if number >= MOST {
            return None;
        }
        if self.names.len() <= number {
            self.names.resize(number + 1, None);
        }
        self.known.insert(columns.clone(), number);
        *self.names.get_mut(number)? = Some(columns);
        Some(())
    }

    /// Names of a set; none of one that is not known.
    pub(super) fn names(&self, number: usize) -> Option<&Columns> {
        self.names.get(number)?.as_ref()
    }

    /// Whether a row of a set says that its point has a solution.
    pub(super) fn is_solved(&self, number: usize, cells: &[Cell]) -> bool {
        let at = self.names(number).and_then(|names| names.iter().position(|name| name == CONVERGED));
        at.and_then(|at| cells.get(at)) == Some(&Cell::Truth(true))
    }

    /// The columns of a table whose rows have these sets, in the order in which the rows bring them, a row's own
    /// between those it shares; and by set the column of each of its names.
    pub(super) fn joined(&self, rows: impl Iterator<Item = usize>) -> (Columns, Vec<Vec<Option<usize>>>) {
        let mut order: Vec<usize> = Vec::new();
        for layout in rows {
            if !order.contains(&layout) {
                order.push(layout);
            }
        }
        let mut columns = Columns::new();
        for layout in order {
            merge(&mut columns, self.names(layout).map_or(&[], Vec::as_slice));
        }
        let place: HashMap<&String, usize> = columns.iter().enumerate().map(|(at, name)| (name, at)).collect();
        let places = |names: &Option<Columns>| names.iter().flatten().map(|name| place.get(name).copied()).collect();
        let spread = self.names.iter().map(places).collect();
        (columns, spread)
    }
}

/// Collects rows in any order.
#[derive(Debug, Default)]
pub struct TableBuilder {
    layouts: Layouts,
    /// By point: its set of names and its cells.
    rows: Vec<Option<(usize, Vec<Cell>)>>,
}

impl TableBuilder {
    /// For a study of so many points.
    pub fn new(points: usize) -> Self {
        Self { rows: vec![None; points], ..Self::default() }
    }

    /// Whether the point has its row.
    pub fn has(&self, index: usize) -> bool {
        self.rows.get(index).is_some_and(Option::is_some)
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.rows.iter().flatten().count()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.iter().flatten().next().is_none()
    }

    /// Keeps a row. One that is there already stays: a point's row is a function of the study.
    pub fn insert(&mut self, row: Row) {
        let (layout, _) = self.layouts.number(row.columns);
        if let Some(place) = self.rows.get_mut(row.index) {
            place.get_or_insert((layout, row.cells));
        }
    }

    /// The table: columns in the order in which the rows bring them, a row's own between those it shares; `failure`
    /// last. Points without a row are left out.
    pub fn finish(self) -> Table {
        let (columns, places) = self.layouts.joined(self.rows.iter().flatten().map(|(layout, _)| *layout));
        let width = columns.len();
        let spread = |(layout, cells): (usize, Vec<Cell>)| {
            let mut row = vec![Cell::Empty; width];
            for (cell, place) in cells.into_iter().zip(places.get(layout).into_iter().flatten()) {
                if let Some(slot) = place.and_then(|place| row.get_mut(place)) {
                    *slot = cell;
                }
            }
            row
        };
        let rows = self.rows.into_iter().flatten().map(spread).collect();
        Table { columns, rows }
    }
}

/// Adds names that are missing, each behind the one it follows.
fn merge(columns: &mut Columns, names: &[String]) {
    let mut next = 0;
    for name in names {
        match columns.iter().position(|column| column == name) {
            Some(at) => next = at + 1,
            None => {
                columns.insert(next, name.clone());
                next += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_unlike_columns_make_one_table() {
        let row = |index, names: &[&str]| Row {
            index,
            columns: names.iter().map(|name| (*name).to_owned()).collect(),
            cells: names.iter().map(|name| Cell::Text((*name).into())).collect(),
        };
        let mut builder = TableBuilder::new(4);
        builder.insert(row(2, &["key", "a", "b", "failure"]));
        builder.insert(row(0, &["key", "b", "failure"]));
        builder.insert(row(1, &["key", "b", "c", "failure"]));
        builder.insert(row(1, &["nothing"]));
        assert!(builder.has(2) && !builder.has(3));
        assert_eq!(builder.len(), 3);
        let table = builder.finish();
        assert_eq!(table.columns, ["key", "a", "b", "c", "failure"]);
        let text = |row: usize, column: usize| table.rows[row][column].to_json().to_string();
        assert_eq!(
            (text(0, 1), text(0, 2), text(1, 3), text(2, 1)),
            ("null".into(), "\"b\"".into(), "\"c\"".into(), "\"a\"".into())
        );
    }
}
