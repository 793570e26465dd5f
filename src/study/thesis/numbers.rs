//! Each number and each statement of chapters 6 and 7 beside what an edition gives.

use super::{Chapters, Family};
use crate::case::Key;
use crate::model::{InternalError, Output};
use crate::study::Table;
use serde::{Deserialize, Serialize};

/// The numbers that the thesis states.
const PUBLISHED: &str = include_str!("../../../data/published.json");

/// One number or statement of the thesis, and ours.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    /// Section of the thesis.
    pub section: String,
    /// What it is about.
    pub what: String,
    /// Unit of the numbers.
    pub unit: String,
    /// As the thesis states it; of a statement, what it asks for.
    pub published: f64,
    /// How far ours may be from it.
    pub tolerance: f64,
    /// Ours.
    pub ours: f64,
    /// Whether ours is within tolerance.
    pub met: bool,
}

#[derive(Debug, Deserialize)]
struct Published {
    base_case: Vec<Number>,
    operating_range: Vec<Number>,
    table_7_1_max_penetration_mm: Vec<Penetration>,
    parameter_studies: Vec<Number>,
}

#[derive(Debug, Deserialize)]
struct Number {
    #[serde(rename = "where")]
    section: String,
    key: Option<String>,
    ratio: Option<f64>,
    #[serde(default)]
    unit: String,
    value: Option<f64>,
    tol: Option<f64>,
}

#[derive(Debug, Deserialize)]
struct Penetration {
    half_angle_deg: f64,
    ratio: f64,
    primary: f64,
    secondary: f64,
    tol: f64,
}

/// A unit of the thesis for one of SI.
fn per_si(unit: &str) -> f64 {
    match unit {
        "deg" => 180.0 / std::f64::consts::PI,
        "mm" => 1e3,
        "%" => 100.0,
        _ => 1.0,
    }
}

/// All numbers and statements of chapters 6 and 7, checked.
///
/// # Errors
/// None, unless this program is broken.
pub fn checks(chapters: &Chapters) -> Result<Vec<Check>, InternalError> {
    // The text is part of the program, and a test reads it.
    let published = serde_json::from_str::<Published>(PUBLISHED);
    let published = published.map_err(|_| InternalError::Json("what the thesis states"))?;
    let mut checks = Vec::new();
    let result = serde_json::to_value(&chapters.base.result).map_err(|_| InternalError::Json("a result"))?;
    for number in &published.base_case {
        let (Some(key), Some(value), Some(tolerance)) = (&number.key, number.value, number.tol) else { continue };
        let found = key.split('.').try_fold(&result, |object, name| object.get(name)).and_then(|found| found.as_f64());
        let ours = found.unwrap_or(f64::NAN) * per_si(&number.unit);
        checks.push(check(&number.section, words(key), &number.unit, value, tolerance, ours));
    }
    for number in &published.operating_range {
        let (Some(key), Some(value), Some(tolerance), Some(ratio)) =
            (&number.key, number.value, number.tol, number.ratio)
        else {
            continue;
        };
        let row = if ratio > 1.0 { 0 } else { chapters.range.rows.len().saturating_sub(1) };
        let ours = chapters.range.number(row, key) * per_si(&number.unit);
        checks.push(check(
            &number.section,
            format!("{} at ratio {ratio}", words(key)),
            &number.unit,
            value,
            tolerance,
            ours,
        ));
    }
    checks.extend(range_statements(&chapters.range));
    for cell in &published.table_7_1_max_penetration_mm {
        for (pulley, value) in [("primary", cell.primary), ("secondary", cell.secondary)] {
            let ours = angle_row(chapters, cell.half_angle_deg, cell.ratio)
                .map_or(f64::NAN, |(table, row)| 1e3 * table.number(row, &format!("{pulley}.max_penetration")));
            let what = format!("{pulley}: max penetration at β = {}°, ratio {}", cell.half_angle_deg, cell.ratio);
            checks.push(check("7.1", what, "mm", value, cell.tol, ours));
        }
    }
    for number in &published.parameter_studies {
        let (Some(value), Some(tolerance), Some(ratio)) = (number.value, number.tol, number.ratio) else { continue };
        let gain = family(chapters, Key::BendingStiffness).map_or(f64::NAN, |family| {
            let at = |curve: usize| at_end(family, curve, ratio > 1.0, Output::EfficiencyOverall);
            100.0 * (at(0) - at(family.curves().len().saturating_sub(1)))
        });
        let what = format!("gain of overall efficiency, EI from 0.5 to 0.025 N·m², ratio {ratio}");
        checks.push(check(&number.section, what, &number.unit, value, tolerance, gain));
    }
    checks.extend(family_statements(chapters));
    Ok(checks)
}

fn words(key: &str) -> String {
    key.replacen('.', ": ", 1).replace('_', " ")
}

fn check(section: &str, what: String, unit: &str, published: f64, tolerance: f64, ours: f64) -> Check {
    // A last digit's rounding in the comparison itself.
    let met = (ours - published).abs() <= tolerance * (1.0 + 1e-9);
    Check { section: section.into(), what, unit: unit.replace('*', "·"), published, tolerance, ours, met }
}

/// A statement: how many of the places at which it is made contradict it.
fn statement(section: &str, what: &str, against: usize) -> Check {
    check(section, what.into(), "contradictions", 0.0, 0.0, against as f64)
}

fn family(chapters: &Chapters, key: Key) -> Option<&Family> {
    chapters.families.iter().find(|family| family.key == key)
}

fn angle_row(chapters: &Chapters, degrees: f64, ratio: f64) -> Option<(&Table, usize)> {
    let family = family(chapters, Key::HalfAngle)?;
    let (_, rows) = family.curves().into_iter().find(|(angle, _)| (angle.to_degrees() - degrees).abs() < 0.5)?;
    Some((&family.table, if ratio > 1.0 { rows.start } else { rows.end - 1 }))
}

/// An output at one end of the range.
fn at_end(family: &Family, curve: usize, low_range: bool, output: Output) -> f64 {
    let curves = family.curves();
    let Some((_, rows)) = curves.get(curve) else { return f64::NAN };
    family.table.output(if low_range { rows.start } else { rows.end - 1 }, output)
}

/// Whether a change is one upward; a point without a solution changes nothing.
fn rising(change: f64) -> bool {
    change > 0.0
}

/// How many neighbours do not fall.
fn rises(values: &[f64]) -> usize {
    values.windows(2).filter(|pair| !matches!(pair, [a, b] if b < a)).count()
}

fn range_statements(range: &Table) -> Vec<Check> {
    let column = |output: Output| (0..range.rows.len()).map(|row| range.output(row, output)).collect::<Vec<_>>();
    let (primary, secondary) = (column(Output::PrimaryAxialForce), column(Output::SecondaryAxialForce));
    let smaller = primary.iter().zip(&secondary).filter(|(primary, secondary)| primary <= secondary).count();
    let (first, last) = (0, primary.len().saturating_sub(1));
    let difference = |row: usize| Some(primary.get(row)? - secondary.get(row)?);
    let grows = difference(last).zip(difference(first)).is_some_and(|(last, first)| last > first);
    let negated = |values: Vec<f64>| values.into_iter().map(|value| -value).collect::<Vec<_>>();
    vec![
        statement("6.2.3", "primary axial force falls from low to high range", rises(&primary)),
        statement("6.2.3", "secondary axial force falls from low to high range", rises(&secondary)),
        statement("6.2.3", "the primary's axial force is the larger", smaller),
        statement("6.2.3", "their difference is larger in high range than in low", usize::from(!grows)),
        statement("6.2.4", "torque loss grows from low to high range", rises(&column(Output::EfficiencyTorque))),
        statement("6.2.4", "speed loss falls from low to high range", rises(&negated(column(Output::EfficiencySpeed)))),
    ]
}

fn family_statements(chapters: &Chapters) -> Vec<Check> {
    let mut checks = Vec::new();
    // Overall efficiency of neighbouring curves at every ratio, in the order of the curves.
    let falls = |family: &Family, sign: f64| {
        let curves = family.curves();
        let value =
            |rows: &std::ops::Range<usize>, at: usize| family.table.output(rows.start + at, Output::EfficiencyOverall);
        let pairs = curves.windows(2).filter_map(|pair| if let [a, b] = pair { Some((&a.1, &b.1)) } else { None });
        pairs
            .flat_map(|(a, b)| (0..a.len()).map(move |at| (a, b, at)))
            .filter(|(a, b, at)| !rising(sign * (value(b, *at) - value(a, *at))))
            .count()
    };
    if let Some(angle) = family(chapters, Key::HalfAngle) {
        checks.push(statement("7.1", "overall efficiency rises with the half angle at every ratio", falls(angle, 1.0)));
    }
    if let Some(tension) = family(chapters, Key::SlackTension) {
        checks.push(statement(
            "7.3",
            "overall efficiency falls with the slack tension at every ratio",
            falls(tension, -1.0),
        ));
        for (pulley, force) in [("primary", Output::PrimaryAxialForce), ("secondary", Output::SecondaryAxialForce)] {
            let what = format!("{pulley}: axial force over slack tension, departure from a straight line");
            checks.push(check("7.3", what, "% of its rise", 0.0, 5.0, 100.0 * bend(tension, force)));
        }
        let last = tension.curves().len().saturating_sub(1);
        let speed = |curve: usize, low: bool| at_end(tension, curve, low, Output::EfficiencySpeed);
        let change = |low: bool| speed(last, low) - speed(0, low);
        checks.push(statement(
            "7.3",
            "speed efficiency falls with the slack tension in low range",
            usize::from(!rising(-change(true))),
        ));
        checks.push(statement(
            "7.3",
            "speed efficiency rises with the slack tension in high range",
            usize::from(!rising(change(false))),
        ));
    }
    if let Some(friction) = family(chapters, Key::FrictionCoefficient) {
        let curves = friction.curves();
        let spread = curves.first().zip(curves.last()).map_or(f64::NAN, |((_, a), (_, b))| {
            let value = |row: usize| 100.0 * friction.table.output(row, Output::EfficiencyOverall);
            (0..a.len()).map(|at| (value(b.start + at) - value(a.start + at)).abs()).fold(0.0, f64::max)
        });
        let what = "largest change of overall efficiency, friction coefficient from 0.3 to 0.5".to_owned();
        checks.push(check("7.4", what, "percentage points", 0.0, 1.0, spread));
    }
    checks
}

/// Largest departure of an output from the straight line between the first and last curve, as a share of its rise.
fn bend(family: &Family, output: Output) -> f64 {
    let curves = family.curves();
    let Some(((first, start), (last, end))) = curves.first().zip(curves.last()) else { return f64::NAN };
    let mut largest = 0.0_f64;
    for (value, rows) in &curves {
        let part = (value - first) / (last - first);
        for at in 0..rows.len() {
            let number = |rows: &std::ops::Range<usize>| family.table.output(rows.start + at, output);
            let rise = number(end) - number(start);
            largest = largest.max(((number(rows) - number(start) - part * rise) / rise).abs());
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_numbers_are_read_and_are_those_of_the_tests() {
        let published: Published = serde_json::from_str(PUBLISHED).unwrap();
        assert!(published.base_case.len() >= 18 && published.table_7_1_max_penetration_mm.len() == 6);
        assert_eq!(PUBLISHED, include_str!("../../../tests/data/published.json"));
    }
}
