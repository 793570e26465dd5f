//! Chapters 6 and 7 of the thesis: its studies in any edition, and its numbers beside ours.

mod comparison;
mod figures;
mod numbers;

pub use comparison::comparison;
pub use figures::{figures, number_in_thesis};
pub use numbers::{Check, checks};

use super::Axis;
use super::error::StudyError;
use super::plan::Study;
use super::row::Table;
use super::run::each;
use crate::case::{Case, Edition, Key};
use crate::drive::SolveOptions;
use crate::result::Outcome;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// Of the base case, whose numbers the thesis states to four digits.
const BASE_TOLERANCE: f64 = 1e-6;
/// Of the studies: forces and efficiencies then are right to 2e-4 of themselves, the width of a line in a figure, and
/// far beyond the digits that the thesis states.
const TOLERANCE: f64 = 1e-3;

/// Points of the operating range, both ends among them.
pub const RATIOS: usize = 13;
/// The ends of the operating range (6.2.2): low and high.
const LOW: f64 = 1.74;
const HIGH: f64 = 0.72;

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

/// One belt at both ends of the operating range; nothing where there is no solution.
#[derive(Debug, Clone)]
pub struct Ends {
    /// The belt's bending stiffness, N·m².
    pub bending_stiffness: f64,
    /// In low range, the highest ratio.
    pub low: Option<Outcome>,
    /// In high range, the lowest ratio.
    pub high: Option<Outcome>,
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
    /// The base belt at the ends of the operating range.
    pub ends: Ends,
    /// Half angle (7.1), bending stiffness (7.2), slack tension (7.3), friction coefficient (7.4).
    pub families: Vec<Family>,
    /// The belts of the study of bending stiffness at the ends of the operating range.
    pub belts: Vec<Ends>,
    /// Points without a solution, with their reasons.
    pub failures: Vec<String>,
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
/// The studies of an edition, in order: the base case, the operating range, the families.
const STUDIES: usize = 2 + FAMILIES.len();
const RANGE: usize = 1;
const BELTS: usize = 3;

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

/// Solves chapters 6 and 7 in some editions, with `ratios` points ([`RATIOS`] suit the figures) over the operating
/// range, on `jobs` threads (all cores if none are given); says also how many points were solved. What studies have in
/// common is solved once.
///
/// # Errors
/// See [`ChaptersError`]. A point of a family without a solution is told in [`Chapters::failures`].
pub fn chapters(
    editions: &[Edition],
    ratios: usize,
    jobs: Option<usize>,
) -> Result<(Vec<Chapters>, usize), ChaptersError> {
    let studies = editions.iter().map(|edition| studies(*edition, ratios)).collect::<Result<Vec<_>, _>>()?.concat();
    let found: Mutex<BTreeMap<(usize, usize), Result<Outcome, String>>> = Mutex::default();
    let (tables, points) = each(&studies, jobs, |study, point, _, outcome| {
        let shown = match study % STUDIES {
            0 => true,
            RANGE | BELTS => point % ratios == 0 || (point + 1) % ratios == 0,
            _ => false,
        };
        if shown {
            found.lock().unwrap_or_else(PoisonError::into_inner).insert((study, point), outcome.cloned());
        }
    })?;
    let found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
    let mut tables = tables.into_iter();
    let one = |(number, edition): (usize, &Edition)| {
        let own: Vec<Table> = tables.by_ref().take(STUDIES).collect();
        assembled(*edition, number * STUDIES, ratios, own, &found)
    };
    Ok((editions.iter().enumerate().map(one).collect::<Result<_, _>>()?, points))
}

/// Base case, operating range, families.
fn studies(edition: Edition, ratios: usize) -> Result<Vec<Study>, StudyError> {
    let study = |axes: &[String], tolerance: f64| -> Result<Study, StudyError> {
        let mut case = Case::base();
        case.set(Key::Edition.path(), edition.name())?;
        let axes = axes.iter().map(|axis| Axis::parse(axis)).collect::<Result<Vec<_>, _>>()?;
        Study::new(case, axes, SolveOptions { tolerance, ..SolveOptions::default() })
    };
    let base = study(&["drive.primary_radius = 68.309 mm".to_owned()], BASE_TOLERANCE)?;
    let range = format!("drive.ratio = {LOW}..{HIGH} : {ratios}");
    let families = FAMILIES.iter().map(|(.., axis)| study(&[(*axis).to_owned(), range.clone()], TOLERANCE));
    [Ok(base), study(std::slice::from_ref(&range), TOLERANCE)].into_iter().chain(families).collect()
}

/// The chapters of an edition, whose first study has the number `first`.
fn assembled(
    edition: Edition,
    first: usize,
    ratios: usize,
    tables: Vec<Table>,
    found: &BTreeMap<(usize, usize), Result<Outcome, String>>,
) -> Result<Chapters, ChaptersError> {
    let base = found.get(&(first, 0)).cloned().unwrap_or_else(|| Err(String::new()));
    let base = base.map_err(|reason| ChaptersError::NoSolution { edition: edition.name(), reason })?;
    let failures = tables.iter().flat_map(reasons).collect();
    let outcome = |study: usize, point: usize| found.get(&(first + study, point))?.as_ref().ok().cloned();
    let ends = |study: usize, curve: usize, bending_stiffness: f64| Ends {
        bending_stiffness,
        low: outcome(study, curve * ratios),
        high: outcome(study, (curve + 1) * ratios - 1),
    };
    let mut tables = tables.into_iter().skip(RANGE);
    let range = tables.next().unwrap_or_default();
    let families: Vec<Family> = FAMILIES
        .into_iter()
        .zip(tables)
        .map(|((name, title, key, _), table)| Family { name, title, key, table })
        .collect();
    let belts = families.get(BELTS - 2).map(Family::curves).unwrap_or_default();
    let belts = belts.iter().enumerate().map(|(curve, (stiffness, _))| ends(BELTS, curve, *stiffness)).collect();
    let ends = ends(RANGE, 0, base.result.inputs.belt.bending_stiffness);
    Ok(Chapters { edition, base, range, ends, families, belts, failures })
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
