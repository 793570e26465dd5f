//! Chapters 6 and 7 of the thesis: its studies in any edition, and its numbers beside ours.

mod figures;
mod numbers;

pub use figures::figures;
pub use numbers::{Check, checks};

use super::Axis;
use super::error::StudyError;
use super::plan::Study;
use super::row::Table;
use super::run::{outcomes, table};
use crate::case::{Case, Edition, Key};
use crate::drive::SolveOptions;
use crate::result::Outcome;

/// Accurate far beyond the digits that the thesis states, and the width of a line in its figures.
const TOLERANCE: f64 = 1e-4;

/// A family of curves over the operating range.
#[derive(Debug, Clone)]
pub struct Family {
    /// Name in files.
    pub name: &'static str,
    /// What varies, with its symbol.
    pub title: &'static str,
    /// The key that tells the curves apart.
    pub key: Key,
    /// One row a point, curve by curve, each from low to high range.
    pub table: Table,
}

/// All studies of chapters 6 and 7 in one edition.
#[derive(Debug, Clone)]
pub struct Chapters {
    /// The edition.
    pub edition: Edition,
    /// The base case (6.1).
    pub base: Outcome,
    /// The operating range (6.2), low range first.
    pub range: Table,
    /// Half angle (7.1), bending stiffness (7.2), slack tension (7.3), friction coefficient (7.4).
    pub families: Vec<Family>,
    /// The ends of the operating range, for belts of EI 0.025, 0.2602 and 0.5 N·m²; low range first.
    pub ends: Vec<[Option<Outcome>; 2]>,
    /// Points without a solution, with their reasons.
    pub failures: Vec<String>,
    /// Points solved.
    pub points: usize,
}

/// The families: name, title, key, axis.
const FAMILIES: [(&str, &str, Key, &str); 4] = [
    (
        "sheave_angle",
        "half angle β of the groove",
        Key::HalfAngle,
        "sheave.half_angle = 8,12,16 deg & belt.radial_stiffness = 12.37,18.71,25.24 MPa",
    ),
    (
        "bending_stiffness",
        "bending stiffness EI",
        Key::BendingStiffness,
        "belt.bending_stiffness = 0.025,0.2,0.5 N*m^2",
    ),
    ("slack_tension", "slack tension T_slack", Key::SlackTension, "operating_point.slack_tension = 100,250,500,750 N"),
    ("friction", "friction coefficient μ_k", Key::FrictionCoefficient, "sheave.friction_coefficient = 0.3,0.4,0.5"),
];

/// Why the chapters could not be computed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ChaptersError {
    /// A study that could not be begun.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// A base case without which there is nothing to show.
    #[error("edition {edition}: the base case has no solution: {reason}")]
    NoSolution {
        /// The edition.
        edition: &'static str,
        /// Why.
        reason: String,
    },
}

/// Solves chapters 6 and 7 in an edition, on `jobs` threads (all cores if none are given).
///
/// # Errors
/// See [`ChaptersError`]. A point of a family without a solution is told in [`Chapters::failures`].
pub fn chapters(edition: Edition, jobs: Option<usize>) -> Result<Chapters, ChaptersError> {
    let options = SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() };
    let study = |axes: &[&str]| -> Result<Study, StudyError> {
        let mut case = Case::base();
        case.set(Key::Edition.path(), edition.name())?;
        let axes = axes.iter().map(|axis| Axis::parse(axis)).collect::<Result<Vec<_>, _>>()?;
        Study::new(case, axes, options)
    };
    let kept = |study: &Study| outcomes(study, jobs, |_, outcome| outcome.cloned());
    let base = kept(&study(&["drive.primary_radius = 68.309 mm"])?)?.into_iter().next();
    let base = base.unwrap_or_else(|| Err(String::new()));
    let base = base.map_err(|reason| ChaptersError::NoSolution { edition: edition.name(), reason })?;
    let ends = kept(&study(&["belt.bending_stiffness = 0.025,0.2602,0.5 N*m^2", "drive.ratio = 1.74,0.72"])?)?;
    let mut ends = ends.into_iter().map(Result::ok);
    let ends = std::iter::from_fn(|| Some([ends.next()?, ends.next()?])).collect();
    let range = table(&study(&["drive.ratio = 1.74..0.72 : 21"])?, jobs)?;
    let mut families = Vec::new();
    for (name, title, key, axis) in FAMILIES {
        let table = table(&study(&[axis, "drive.ratio = 1.74..0.72 : 13"])?, jobs)?;
        families.push(Family { name, title, key, table });
    }
    let tables = || families.iter().map(|family| &family.table).chain([&range]);
    let failures = tables().flat_map(reasons).collect();
    let points = 7 + tables().map(|table| table.rows.len()).sum::<usize>();
    Ok(Chapters { edition, base, range, families, ends, failures, points })
}

fn reasons(table: &Table) -> Vec<String> {
    let Some(at) = table.column("failure") else { return Vec::new() };
    let text = |row: &Vec<super::Cell>| match row.get(at) {
        Some(super::Cell::Text(text)) => Some(text.to_string()),
        _ => None,
    };
    table.rows.iter().filter_map(text).collect()
}

impl Family {
    /// The curves: what tells each apart, and its rows, low range first.
    pub fn curves(&self) -> Vec<(f64, std::ops::Range<usize>)> {
        let value = |row: usize| self.table.number(row, self.key.path());
        let mut curves: Vec<(f64, std::ops::Range<usize>)> = Vec::new();
        for row in 0..self.table.rows.len() {
            match curves.last_mut() {
                Some((last, rows)) if *last == value(row) => rows.end = row + 1,
                _ => curves.push((value(row), row..row + 1)),
            }
        }
        curves
    }
}
