//! A shift curve as a table, and beside measured points.

use std::io;

use serde::Serialize;
use serde_json::{Map, Value};

use super::curve::{ShiftBranch, ShiftPoint};
use super::phase::Direction;
use super::report::DriveReport;
use crate::model::InternalError;
use crate::quantity::Unit;
use crate::study::{Cell, Row, Table, TableBuilder};

/// The points of a shift curve as a table: SI units, one row a point; a point without an equilibrium says why.
pub fn shift_table(branches: &[ShiftBranch]) -> Table {
    let points: Vec<&ShiftPoint> = branches.iter().flat_map(|branch| &branch.points).collect();
    let mut table = TableBuilder::new(points.len());
    for (index, point) in points.into_iter().enumerate() {
        table.insert(row(index, point));
    }
    table.finish()
}

fn row(index: usize, point: &ShiftPoint) -> Row {
    let told = match &point.report {
        Ok(report) => members(report).map_err(|error| error.to_string()),
        Err(reason) => Err(reason.clone()),
    };
    let mut cells: Vec<(String, Value)> = vec![
        ("direction".into(), point.direction.name().into()),
        ("secondary_speed".into(), point.secondary_speed.into()),
        ("converged".into(), told.is_ok().into()),
    ];
    let failure = match told {
        Ok(members) => {
            let known = |name: &str| matches!(name, "drive" | "parts" | "direction" | "secondary_speed");
            cells.extend(members.into_iter().filter(|(name, _)| !known(name)));
            Value::Null
        }
        Err(reason) => Value::from(reason),
    };
    cells.push(("failure".into(), failure));
    let cell = |value: Value| match value {
        Value::Bool(truth) => Cell::Truth(truth),
        Value::Number(number) => Cell::Number(number),
        Value::String(text) => Cell::Text(text.into()),
        Value::Null | Value::Array(_) | Value::Object(_) => Cell::Empty,
    };
    let (columns, cells) = cells.into_iter().map(|(name, value)| (name, cell(value))).unzip();
    Row { index, columns, cells }
}

fn members(report: &DriveReport) -> Result<Map<String, Value>, InternalError> {
    match serde_json::to_value(report) {
        Ok(Value::Object(members)) => Ok(members),
        Ok(_) | Err(_) => Err(InternalError::Json("an equilibrium")),
    }
}

/// Measured speeds, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Speed of the secondary.
    pub secondary_speed: f64,
    /// Speed of the primary.
    pub primary_speed: f64,
    /// Which way the drive shifted, if the data say so.
    pub direction: Option<Direction>,
}

/// Why measured speeds cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum DataError {
    /// The file cannot be read, or is no CSV.
    #[error("cannot be read: {0}")]
    Read(#[from] csv::Error),
    /// A column is missing.
    #[error(
        "has no column `{0}_rpm` or `{0}_speed`: expected a header with secondary_rpm and primary_rpm, or \
         secondary_speed and primary_speed in rad/s, and if there are both ways a column `direction` with up and back"
    )]
    Column(&'static str),
    /// A number is none.
    #[error("line {line}: `{text}` is no speed")]
    Number {
        /// Which line of the file.
        line: u64,
        /// What stands there.
        text: String,
    },
    /// A direction that is none.
    #[error("line {line}: direction `{text}`: expected up, back, or nothing where it is not known")]
    Direction {
        /// Which line of the file.
        line: u64,
        /// What stands there.
        text: String,
    },
    /// Nothing but a header.
    #[error("has no points")]
    Empty,
}

/// Reads measured speeds from CSV with a header; lines that begin with # are skipped.
///
/// # Errors
/// See [`DataError`].
pub fn read_measured(from: impl io::Read) -> Result<Vec<Measured>, DataError> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(from);
    let header = reader.headers()?.clone();
    let column = |name: &'static str| {
        let place = |wanted: String| header.iter().position(|other| other == wanted);
        let rpm = place(format!("{name}_rpm")).map(|at| (at, Unit::RPM.in_si()));
        rpm.or_else(|| place(format!("{name}_speed")).map(|at| (at, 1.0))).ok_or(DataError::Column(name))
    };
    let (secondary, primary) = (column("secondary")?, column("primary")?);
    let direction = header.iter().position(|name| name == "direction");
    let mut points = Vec::new();
    for record in reader.records() {
        let record = record?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |(at, unit): (usize, f64)| {
            let text = record.get(at).unwrap_or_default();
            let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
            value.map(|value| value * unit).ok_or_else(|| DataError::Number { line, text: text.to_owned() })
        };
        points.push(Measured {
            secondary_speed: number(secondary)?,
            primary_speed: number(primary)?,
            direction: match direction.and_then(|at| record.get(at)).unwrap_or_default() {
                "" => None,
                text => match text.parse() {
                    Ok(Direction::Frictionless) | Err(_) => {
                        return Err(DataError::Direction { line, text: text.to_owned() });
                    }
                    Ok(direction) => Some(direction),
                },
            },
        });
    }
    if points.is_empty() { Err(DataError::Empty) } else { Ok(points) }
}

/// Measured points beside a curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Deviation {
    /// Which branch of the curve.
    pub direction: Direction,
    /// Measured points between the ends of the branch.
    pub points: usize,
    /// Root of the mean square of curve less measured speed of the primary, rad/s.
    pub rms: f64,
    /// Mean of curve less measured, rad/s.
    pub mean: f64,
    /// About how much of it is owed to the lines between the curve's points: a third of the root of the mean square of
    /// what every other point left out would change, rad/s. More points make it smaller.
    pub interpolation: f64,
}

/// How far a branch lies from the points that were measured in its direction, or without saying in which; nothing where
/// no point lies between its ends. Between its own points a branch is interpolated linearly.
pub fn deviation(branch: &ShiftBranch, measured: &[Measured]) -> Option<Deviation> {
    let solved: Vec<(f64, f64)> = branch
        .points
        .iter()
        .filter_map(|point| Some((point.secondary_speed, point.report.as_ref().ok()?.primary_speed)))
        .collect();
    // Through every other point, and both ends.
    let last = solved.len().saturating_sub(1);
    let coarse: Vec<(f64, f64)> =
        solved.iter().enumerate().filter(|(at, _)| at % 2 == 0 || *at == last).map(|(_, point)| *point).collect();
    let same = |point: &&Measured| point.direction.is_none_or(|direction| direction == branch.direction);
    let (mut misses, mut moved) = (Vec::new(), Vec::new());
    for point in measured.iter().filter(same) {
        let Some(speed) = interpolated(&solved, point.secondary_speed) else { continue };
        misses.push(speed - point.primary_speed);
        moved.extend(interpolated(&coarse, point.secondary_speed).map(|coarse| speed - coarse));
    }
    if misses.is_empty() {
        return None;
    }
    let rms = |of: &[f64]| (of.iter().map(|miss| miss * miss).sum::<f64>() / of.len().max(1) as f64).sqrt();
    Some(Deviation {
        direction: branch.direction,
        points: misses.len(),
        rms: rms(&misses),
        mean: misses.iter().sum::<f64>() / misses.len() as f64,
        interpolation: rms(&moved) / COARSER,
    })
}

/// What leaving out every other point changes, over what linear interpolation misses with all: that grows with the
/// square of the distance.
const COARSER: f64 = 3.0;

/// The value at a place between two points of a curve, on the line between them.
fn interpolated(curve: &[(f64, f64)], place: f64) -> Option<f64> {
    let pair = curve.windows(2).find(|pair| pair[0].0 <= place && place <= pair[1].0)?;
    let share = (place - pair[0].0) / (pair[1].0 - pair[0].0);
    Some(pair[0].1 + share * (pair[1].1 - pair[0].1))
}
