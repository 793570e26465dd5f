//! All logs that are named, reduced to points.

use super::read::{SAMPLES, is_of};
use super::{Fault, Options, Record, RecordReport, SteadyPoint, process, records};
use crate::bench::belt::POOR_FIT;
use crate::bench::error::{BenchError, BenchProblem};
use crate::bench::statistics::AboveOne;
use serde::Serialize;
use std::path::PathBuf;

/// Points that are kept: what is held in memory is bounded by them, and by nothing else that grows with the logs.
pub const MOST_POINTS: usize = 100_000;

/// What the logs gave.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Reduced {
    /// The averaged windows, without their samples; the first [`MOST_POINTS`] of them.
    pub points: Vec<SteadyPoint>,
    /// What was read, record by record.
    pub records: Vec<RecordReport>,
    /// The point whose samples are kept, for its spectrum.
    #[serde(skip)]
    pub chosen: Option<SteadyPoint>,
    /// Files that could not be read, and each kind of fault once.
    #[serde(skip)]
    pub warnings: Vec<String>,
}

/// Reduces logs, and folders of them, to points. `spectrum` is the number of the point whose samples are kept; without
/// one it is the first steady point that has a spectrum. `read` is told of the bytes as they are read.
///
/// # Errors
/// [`BenchProblem::Read`], and [`BenchProblem::NoData`] where no sample comes out, or no window is steady; runs whose
/// windows [`Options::runs`] has need not be.
pub fn reduce(
    paths: &[PathBuf],
    options: &Options,
    spectrum: Option<usize>,
    mut read: impl FnMut(u64),
) -> Result<Reduced, BenchError> {
    let files = records(paths)?;
    let (mut points, mut reports, mut chosen) = (Vec::new(), Vec::new(), None);
    let mut beyond = 0_u64;
    for record in &files {
        let take = |mut point: SteadyPoint| {
            let wanted = match spectrum {
                Some(number) => number == points.len(),
                None => chosen.is_none() && point.steady && point.spectrum.is_some(),
            };
            if wanted {
                chosen = Some(point.clone());
            }
            point.forget_samples();
            if points.len() < MOST_POINTS {
                points.push(point);
            } else {
                beyond += 1;
            }
        };
        reports.push(process(record, options, take, &mut read)?);
    }
    if let (Some(number), None) = (spectrum, &chosen) {
        let last = points.len().saturating_sub(1);
        let reason = format!("there is no point {number}: expected a number from 0 to {last}");
        return Err(BenchError::from(BenchProblem::Unusable { path: "spectrum".into(), reason }));
    }
    let mut warnings = faults(&reports);
    let names = || paths.iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(", ");
    if reports.iter().all(|report| report.samples == 0) {
        let reason = no_sample(&reports, options, &warnings);
        return Err(BenchError::from(BenchProblem::NoData { path: names(), reason }));
    }
    if reports.iter().all(|report| report.steady == 0) {
        let reason = none_steady(&reports, options);
        if options.runs.is_empty() {
            return Err(BenchError::from(BenchProblem::NoData { path: names(), reason }));
        }
        warnings.push(reason);
    }
    let without: Vec<&str> =
        reports.iter().filter(|report| report.samples == 0).map(|report| report.record.as_str()).collect();
    if !without.is_empty() {
        warnings.push(format!("no sample came out of {}", listed(&without)));
    }
    warnings.extend(doubts(&files, &reports, options));
    warnings.extend(beyond_the_engine(&points));
    if beyond > 0 {
        warnings.push(format!(
            "{beyond} points behind the first {MOST_POINTS} are counted only: choose a longer window, or fewer logs"
        ));
    }
    Ok(Reduced { points, records: reports, chosen, warnings })
}

/// Steady points at which more power leaves the secondary than the engine's curve gives.
fn beyond_the_engine(points: &[SteadyPoint]) -> Option<String> {
    let steady = points.iter().filter(|point| point.steady).filter_map(|point| point.efficiency);
    let AboveOne { count, of, largest } = AboveOne::among(steady.map(|share| share.value))?;
    Some(format!(
        "at {count} of {of} steady points more power leaves the secondary than the engine's curve gives, up to {:.0} % \
         of it: check the curve, the torque's unit and calibration, --gear and --torque-at",
        100.0 * largest
    ))
}

/// Names in a list, of which no more are written out.
const NAMED: usize = 3;

fn listed(names: &[&str]) -> String {
    let first = names.iter().take(NAMED).copied().collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(NAMED) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}

/// Why there is no sample, as far as it is known.
fn no_sample(reports: &[RecordReport], options: &Options, faults: &[String]) -> String {
    let rows: u64 = reports.iter().flat_map(|report| &report.files).map(|file| file.rows).sum();
    let gaps: u64 = reports.iter().map(|report| report.gaps).sum();
    let mut reason = format!("no sample came out of {rows} rows");
    for fault in faults.iter().take(NAMED) {
        reason += &format!("; {fault}");
    }
    if gaps > 0 {
        let longest = options.longest_gap;
        reason +=
            &format!("; {gaps} gaps between samples are longer than {longest} s and are not bridged (--longest-gap)");
    }
    if faults.is_empty() && gaps == 0 && rows > 0 {
        let within = if options.runs.is_empty() { "" } else { " within the windows of the table of runs" };
        reason += &format!("; every channel must have values at the same times as the others{within}");
    }
    reason
}

/// Why nothing is steady, as far as it is known.
fn none_steady(reports: &[RecordReport], options: &Options) -> String {
    let unsteady: u64 = reports.iter().map(|report| report.unsteady).sum();
    let samples: u64 = reports.iter().map(|report| report.samples).sum();
    let left: u64 = reports.iter().map(|report| report.left_over).sum();
    let gaps: u64 = reports.iter().map(|report| report.gaps).sum();
    let window = options.window;
    let mut reason = match unsteady {
        0 => format!("no window of {window} s is filled"),
        _ => format!("none of {unsteady} windows of {window} s is steady"),
    };
    let first = reports.iter().find_map(|report| Some((&report.record, report.reason.as_ref()?)));
    if let Some((record, why)) = first {
        reason += &format!("; in {record} {why}");
    }
    if left > 0 {
        reason += &format!("; {left} of {samples} samples lie in shorter pieces that are not averaged (--window)");
        if gaps > 0 {
            reason += &format!(", between {gaps} gaps longer than {} s (--longest-gap)", options.longest_gap);
        }
    }
    reason
}

/// What was asked for and is not done, or not as it was asked for.
fn doubts(files: &[Record], reports: &[RecordReport], options: &Options) -> Vec<String> {
    let mut doubts = Vec::new();
    let (window, rate) = (options.window, options.rate);
    let samples = (window * rate).round();
    let least = SAMPLES as f64;
    if samples < least {
        doubts.push(format!(
            "a window of {window} s has {samples} samples at {rate} Hz: windows of {SAMPLES} samples, {} s, are \
             averaged (expected --window {} or longer, or --rate {} or more)",
            least / rate,
            least / rate,
            (least / window).ceil()
        ));
    }
    if let Some(line) = options.calibration.filter(|line| line.r_squared < POOR_FIT) {
        doubts.push(format!("the calibration's line describes its data poorly, R² = {:.4}", line.r_squared));
    }
    let uncalibrated: Vec<&str> = reports.iter().flat_map(|report| &report.uncalibrated).map(String::as_str).collect();
    if !uncalibrated.is_empty() {
        doubts.push(format!(
            "the calibration is not applied to torque that is in N·m by its name ({}); a column of raw values is named \
             with --torque",
            listed(&uncalibrated)
        ));
    }
    let mut units: Vec<&str> = reports.iter().flat_map(|report| &report.units).map(String::as_str).collect();
    units.sort_unstable();
    units.dedup();
    if !units.is_empty() {
        doubts.push(format!(
            "the column {}: speeds are read in rpm, torque in N·m (--secondary-factor makes another speed the \
             secondary's)",
            listed(&units)
        ));
    }
    let mut missing: Vec<&str> = Vec::new();
    let logs = || files.iter().flat_map(|record| &record.files).filter(|(_, kind)| kind.is_none());
    for run in &options.runs {
        if !missing.contains(&run.file.as_str()) && !logs().any(|(path, _)| is_of(run, path)) {
            missing.push(&run.file);
        }
    }
    if !missing.is_empty() {
        doubts.push(format!("the table of runs has logs that are not among these files: {}", listed(&missing)));
    }
    doubts
}

/// Of files that could not be read, and of each fault once; that the logger asked faster than sensors answer is none.
fn faults(reports: &[RecordReport]) -> Vec<String> {
    let files = || reports.iter().flat_map(|report| &report.files);
    let mut warnings: Vec<String> =
        files().filter_map(|file| Some(format!("{}: {}", file.file, file.problem.as_ref()?))).collect();
    for fault in Fault::ALL.into_iter().filter(|fault| *fault != Fault::Duplicate) {
        let with: Vec<_> = files().filter(|file| file.faults.count(fault) > 0).collect();
        let count: u64 = with.iter().map(|file| file.faults.count(fault)).sum();
        let first = with.first().and_then(|file| {
            let line = file.faults.all().iter().find(|count| count.fault == fault)?.first_line;
            Some(format!("the first in {}, line {line}", file.file))
        });
        if let Some(first) = first {
            warnings.push(format!("{count} {} in {} files, {first}", fault.words(), with.len()));
        }
    }
    warnings
}
