//! Measured operating points: the table that `sheave dyno` writes, or one like it.

use crate::bench::cells;
use crate::bench::dyno::Criteria;
use crate::bench::engine::EngineCurve;
use crate::bench::error::{BenchError, BenchProblem};
use crate::bench::statistics::{BATCHES, student};
use crate::quantity::Unit;
use crate::text::quoted;
use serde::Serialize;
use std::collections::HashSet;
use std::path::Path;

/// Rows that a table may have.
const ROWS: usize = 100_000;

/// A measured operating point, SI.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Measured {
    /// What the table calls the run.
    pub run: String,
    /// Number of the step.
    pub step: Option<f64>,
    /// ω_P, rad/s.
    pub primary_speed: f64,
    /// ω_S, rad/s.
    pub secondary_speed: f64,
    /// Torque out of the secondary, N·m.
    pub secondary_torque: f64,
    /// Torque into the primary, N·m: measured, or the engine's curve at ω_P; not a number without either.
    pub primary_torque: f64,
    /// Whether it is the engine's.
    pub of_engine: bool,
    /// Output over input power; not a number where the input is not known.
    pub efficiency: f64,
    /// Standard error of the efficiency, if the table has what it follows from.
    pub efficiency_error: Option<f64>,
    /// Interval of 95 % confidence that follows from the error and from how many samples or parts it is of.
    pub efficiency_interval: Option<(f64, f64)>,
    /// Why the point is not used, if it is not.
    pub reason: Option<String>,
}

/// A row that is no operating point.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BadRow {
    /// Counted from 1.
    pub line: u64,
    /// Why.
    pub reason: String,
}

/// A table as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Points in the order of the table.
    pub points: Vec<Measured>,
    /// Rows that are none.
    pub bad: Vec<BadRow>,
    /// Lines of points whose cells are those of an earlier one.
    pub repeated: Vec<u64>,
}

/// Columns that are known, with what else they may be called.
const COLUMNS: [(&str, &[&str]); 14] = [
    ("run", &[]),
    ("step", &[]),
    ("primary_rpm", &["engine_rpm"]),
    ("primary_rpm_sd", &[]),
    ("secondary_rpm", &[]),
    ("secondary_rpm_sd", &[]),
    ("secondary_torque_Nm", &["secondary_torque"]),
    ("secondary_torque_sd", &["secondary_torque_Nm_sd"]),
    ("n_torque", &[]),
    ("primary_torque_Nm", &["primary_torque"]),
    ("primary_rpm_se", &[]),
    ("secondary_rpm_se", &[]),
    ("secondary_torque_se", &[]),
    ("n_parts", &[]),
];

/// Reads a table; input power is that of the column `primary_torque_Nm`, else of the engine's curve.
///
/// # Errors
/// A file that cannot be read, a header without speeds and torque, no row that is an operating point.
pub fn read(path: &Path, engine: Option<&EngineCurve>) -> Result<Table, BenchError> {
    let bytes = std::fs::read(path).map_err(|error| BenchError::read(path, &error))?;
    parse(&path.display().to_string(), &bytes, engine)
}

/// As [`read`], from the bytes of a file.
///
/// # Errors
/// As [`read`].
pub fn parse(name: &str, bytes: &[u8], engine: Option<&EngineCurve>) -> Result<Table, BenchError> {
    cells::check_encoding(name, bytes)?;
    let mut places: Option<[Option<usize>; COLUMNS.len()]> = None;
    let mut width = 0;
    let (mut points, mut bad, mut repeated) = (Vec::new(), Vec::new(), Vec::new());
    let mut seen: HashSet<Vec<String>> = HashSet::new();
    for (line, text) in (1_u64..).zip(bytes.split(|byte| *byte == b'\n')) {
        let Ok(text) = std::str::from_utf8(text) else {
            bad.push(BadRow { line, reason: "it is no text".into() });
            continue;
        };
        let text = text.trim_start_matches('\u{feff}').trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let cells = cells::texts(text);
        let cells: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
        let Some(places) = &places else {
            places = Some(header(name, line, &cells, engine.is_some())?);
            width = cells.len();
            continue;
        };
        if let Some(filled) = cells::filled(&cells).filter(|filled| *filled > width) {
            let reason = format!(
                "it has {filled} cells, and the header {width} columns: numbers have decimal points, not commas"
            );
            bad.push(BadRow { line, reason });
            continue;
        }
        match point(places, &cells, engine) {
            Ok(point) if points.len() < ROWS => {
                points.push(point);
                let all = cells.get(..cells::filled(&cells).unwrap_or(0)).unwrap_or_default();
                if !seen.insert(all.iter().map(|cell| (*cell).to_owned()).collect()) {
                    repeated.push(line);
                }
            }
            Ok(_) => bad.push(BadRow { line, reason: format!("there are more than {ROWS} rows") }),
            Err(reason) => bad.push(BadRow { line, reason }),
        }
        if bad.len() > ROWS {
            break;
        }
    }
    if points.is_empty() {
        let reason = match bad.first() {
            Some(BadRow { line, reason }) => format!("no row is an operating point; line {line}: {reason}"),
            None => "it has no rows".into(),
        };
        return Err(BenchProblem::NoData { path: name.into(), reason }.into());
    }
    Ok(Table { points, bad, repeated })
}

fn header(name: &str, line: u64, cells: &[&str], engine: bool) -> Result<[Option<usize>; COLUMNS.len()], BenchError> {
    let refused = |reason: String| BenchError::from(BenchProblem::Line { path: name.into(), line, reason });
    if let Some(fault) = cells::separator_fault(cells) {
        return Err(refused(fault.into()));
    }
    let twice = cells.iter().enumerate().find(|(at, cell)| {
        let before = cells.get(..*at).unwrap_or_default();
        !cell.is_empty() && before.iter().any(|other| other.eq_ignore_ascii_case(cell))
    });
    if let Some((_, twice)) = twice {
        return Err(refused(format!("two columns are called `{}`: expected a name for each", quoted(twice))));
    }
    let place = |known: &str| cells.iter().position(|cell| cell.eq_ignore_ascii_case(known));
    let places = COLUMNS.map(|(known, others)| place(known).or_else(|| others.iter().find_map(|other| place(other))));
    for required in ["primary_rpm", "secondary_rpm", "secondary_torque_Nm"] {
        let at = COLUMNS.iter().position(|(known, _)| *known == required);
        if at.and_then(|at| places.get(at).copied().flatten()).is_none() {
            return Err(refused(format!("there is no column `{required}`: the header has {}", cells.join(", "))));
        }
    }
    let own = COLUMNS.iter().position(|(known, _)| *known == "primary_torque_Nm");
    if !engine && own.and_then(|at| places.get(at).copied().flatten()).is_none() {
        let error = refused(
            "nothing says what the engine gives: neither a column `primary_torque_Nm` nor an engine's curve".into(),
        );
        return Err(error.advise("give the engine's curve with --engine"));
    }
    Ok(places)
}

fn point(
    places: &[Option<usize>; COLUMNS.len()],
    cells: &[&str],
    engine: Option<&EngineCurve>,
) -> Result<Measured, String> {
    let text = |column: &str| {
        let at = COLUMNS.iter().position(|(known, _)| *known == column)?;
        cells.get(places.get(at).copied().flatten()?).copied()
    };
    let number = |column: &str| match text(column) {
        None | Some("") => Ok(None),
        Some(cell) => match cell.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Some(value)),
            _ => Err(format!("`{}` is no finite number ({column})", quoted(cell))),
        },
    };
    let need = |column: &str| number(column)?.ok_or_else(|| format!("there is no {column}"));
    let rpm = Unit::RPM.in_si();
    let (primary, secondary, torque) = (need("primary_rpm")?, need("secondary_rpm")?, need("secondary_torque_Nm")?);
    let (primary_speed, secondary_speed) = (primary * rpm, secondary * rpm);
    let mut reason = None;
    let mut unsteady = |name: &str, deviation: Option<f64>, mean: f64, limit: f64| {
        if let Some(deviation) = deviation.filter(|deviation| *deviation > limit * mean.abs()) {
            let share = 100.0 * deviation / mean.abs();
            reason.get_or_insert(format!("not steady: {name} has a standard deviation of {share:.1} % of its mean"));
        }
    };
    let deviations = (number("primary_rpm_sd")?, number("secondary_rpm_sd")?, number("secondary_torque_sd")?);
    let criteria = Criteria::default();
    unsteady("the primary's speed", deviations.0, primary, criteria.speed_deviation);
    unsteady("the secondary's speed", deviations.1, secondary, criteria.speed_deviation);
    unsteady("the torque", deviations.2, torque, criteria.torque_deviation);
    if !(primary > 0.0 && secondary > 0.0 && torque > 0.0) {
        reason.get_or_insert("it does not transmit power from the primary to the secondary".into());
    }
    let input = number("primary_torque_Nm")?;
    let primary_torque = match (input, engine) {
        (Some(torque), _) => torque,
        (None, Some(engine)) => match engine.power(primary_speed) {
            Some((power, _)) => power / primary_speed,
            None => {
                let (low, high) = engine.range();
                reason.get_or_insert(format!("the engine's curve covers {low:.0} to {high:.0} rpm only"));
                f64::NAN
            }
        },
        (None, None) => return Err("there is no primary_torque_Nm".into()),
    };
    let efficiency = torque * secondary_speed / (primary_torque * primary_speed);
    if !(efficiency > 0.0 && efficiency.is_finite()) {
        reason.get_or_insert("it has no efficiency: no input power".into());
    }
    // Where the table has no standard errors of means, samples count as independent.
    let count = number("n_torque")?.filter(|count| *count >= 1.0);
    let own = number("secondary_torque_se")?;
    let standard = |error: Option<f64>, deviation: Option<f64>| error.or_else(|| Some(deviation? / count?.sqrt()));
    let torque_error = standard(own, deviations.2);
    let speed_error = standard(number("secondary_rpm_se")?, deviations.1).unwrap_or(0.0) / secondary;
    // The engine's curve gives a power, in which the primary's speed hardly counts.
    let primary_error = standard(number("primary_rpm_se")?, deviations.0).filter(|_| input.is_some());
    let speed_error = speed_error.hypot(primary_error.unwrap_or(0.0) / primary);
    let efficiency_error =
        torque_error.map(|error| efficiency * (error / torque).hypot(speed_error)).filter(|error| error.is_finite());
    // A standard error of the table is that of the means of so many parts, ten where the table does not say; one of
    // samples has a degree less than these.
    let parts = number("n_parts")?.filter(|parts| *parts >= 1.0).unwrap_or(BATCHES as f64);
    let samples = count.filter(|_| own.is_none()).unwrap_or(parts).min(ROWS as f64) as usize;
    let half = student(samples.saturating_sub(1));
    let interval = |error: f64| (efficiency - half * error, efficiency + half * error);
    let efficiency_interval = efficiency_error.map(interval).filter(|(low, high)| low.is_finite() && high.is_finite());
    Ok(Measured {
        run: text("run").unwrap_or_default().to_owned(),
        step: number("step")?,
        primary_speed,
        secondary_speed,
        secondary_torque: torque,
        primary_torque,
        of_engine: input.is_none(),
        efficiency,
        efficiency_error,
        efficiency_interval,
        reason,
    })
}
