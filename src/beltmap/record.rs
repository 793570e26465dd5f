//! A point of a map as a row of its journal and of its table.

use super::quantity::{Node, Quantity, Sample};
use crate::case::Key;
use crate::study::{Cell, Row};
use serde_json::Number;

/// The column that says what a point has.
pub(super) const STATUS: &str = "status";

/// Where files of other formats than CSV have what they say of their map.
#[cfg(any(feature = "netcdf", feature = "parquet"))]
pub(super) const ATTRIBUTE: &str = "sheave_belt_map";

/// Names of what a point has, in the order of their numbers: 0 solved, 1 slipping, 2 no solution, 3 no drive.
const SOLVED: &str = "solved";
const SLIPPING: &str = "slipping";
const UNSOLVED: &str = "no_solution";
const NO_DRIVE: &str = "no_drive";

/// The names with their numbers as a NetCDF attribute has them, separated by blanks.
#[cfg(feature = "netcdf")]
pub(super) fn flag_meanings() -> String {
    [SOLVED, SLIPPING, UNSOLVED, NO_DRIVE].join(" ")
}

/// A point with its number and what it has.
pub(super) struct PointRow<'a> {
    pub number: usize,
    pub keys: &'a [Key],
    pub at: &'a [f64],
    pub node: &'a Node,
}

impl Node {
    /// Its name in files.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Solved(_) => SOLVED,
            Self::Slipping => SLIPPING,
            Self::Unsolved => UNSOLVED,
            Self::NoDrive => NO_DRIVE,
        }
    }

    /// Its number in files that have no names.
    #[cfg(feature = "netcdf")]
    pub(super) fn number(&self) -> i8 {
        match self {
            Self::Solved(_) => 0,
            Self::Slipping => 1,
            Self::Unsolved => 2,
            Self::NoDrive => 3,
        }
    }

    /// The point with this name, which has `sample` if it is solved.
    pub(super) fn named(name: &str, sample: Option<Sample>) -> Option<Self> {
        match name {
            SOLVED => sample.map(Self::Solved),
            SLIPPING => Some(Self::Slipping),
            UNSOLVED => Some(Self::Unsolved),
            NO_DRIVE => Some(Self::NoDrive),
            _ => None,
        }
    }
}

/// The column of a derivative.
pub(super) fn slope_name(quantity: Quantity, key: Key) -> String {
    format!("d({})/d({})", quantity.name(), key.path())
}

/// Names of all columns: the axes, what the point has, quantities, efficiencies if wanted, derivatives.
pub(super) fn columns(quantities: &[Quantity], keys: &[Key], derived: &[&str]) -> Vec<String> {
    let axes = keys.iter().map(|key| key.path().to_owned()).chain([STATUS.to_owned()]);
    let values = quantities.iter().map(|quantity| quantity.name().to_owned());
    let derived = derived.iter().map(|name| (*name).to_owned());
    let slopes = quantities.iter().flat_map(|quantity| keys.iter().map(|key| slope_name(*quantity, *key)));
    axes.chain(values).chain(derived).chain(slopes).collect()
}

/// A number that may be missing.
pub(super) fn number(value: f64) -> Cell {
    Number::from_f64(value).map_or(Cell::Empty, Cell::Number)
}

/// The row of a point; `derived` stands between the quantities and their derivatives.
pub(super) fn cells(at: &[f64], node: &Node, quantities: usize, derived: &[f64]) -> Vec<Cell> {
    let mut cells: Vec<Cell> = at.iter().map(|value| number(*value)).collect();
    cells.push(Cell::Text(node.name().into()));
    match node.sample() {
        Some(sample) => {
            let all = sample.values.iter().chain(derived).chain(&sample.slopes);
            cells.extend(all.map(|value| number(*value)));
        }
        None => cells.extend(vec![Cell::Empty; quantities * (1 + at.len()) + derived.len()]),
    }
    cells
}

pub(super) fn write(row: &PointRow<'_>, quantities: &[Quantity]) -> Row {
    let columns = columns(quantities, row.keys, &[]);
    Row { index: row.number, columns, cells: cells(row.at, row.node, quantities.len(), &[]) }
}

/// What a row says; nothing if it is not one of this map.
pub(super) fn read(row: &Row, quantities: &[Quantity], axes: usize) -> Option<Node> {
    let Cell::Text(name) = row.cells.get(axes)? else { return None };
    let numbers: Option<Vec<f64>> = row.cells.get(axes + 1..)?.iter().map(Cell::number).collect();
    let sample = numbers.filter(|numbers| numbers.len() == quantities.len() * (1 + axes)).map(|mut values| {
        let slopes = values.split_off(quantities.len());
        Sample { values, slopes }
    });
    Node::named(name, sample)
}
