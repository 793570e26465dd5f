//! All logs that are named, reduced to points.

use super::{Fault, Options, RecordReport, SteadyPoint, process, records};
use crate::bench::error::{BenchError, BenchProblem};
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
/// [`BenchProblem::Read`], and [`BenchProblem::NoData`] where no sample comes out.
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
        reports.push(process(record, options, take, &mut read));
    }
    if let (Some(number), None) = (spectrum, &chosen) {
        let last = points.len().saturating_sub(1);
        let reason = format!("there is no point {number}: expected a number from 0 to {last}");
        return Err(BenchError::from(BenchProblem::Unusable { path: "spectrum".into(), reason }));
    }
    let mut warnings = warnings(&reports);
    if beyond > 0 {
        warnings.push(format!(
            "{beyond} points behind the first {MOST_POINTS} are counted only: choose a longer window, or fewer logs"
        ));
    }
    if reports.iter().all(|report| report.samples == 0) {
        let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
        let reason = match warnings.first() {
            Some(first) => format!("no sample came out; {first}"),
            None => "no sample came out".into(),
        };
        return Err(BenchError::from(BenchProblem::NoData { path: names.join(", "), reason }));
    }
    Ok(Reduced { points, records: reports, chosen, warnings })
}

/// Of files that could not be read, and of each fault once; that the logger asked faster than sensors answer is none.
fn warnings(reports: &[RecordReport]) -> Vec<String> {
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
