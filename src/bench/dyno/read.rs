//! Which files belong together, and how they become points.

use super::format::{StepChannel, header, step_file, without};
use super::lines::{Line, Lines};
use super::stream::Stream;
use super::uniform::{Row, Uniform};
use super::{CHANNELS, Channel, Faults, Format, Options, Sample, SteadyPoint};
use crate::bench::cells;
use crate::bench::error::{BenchError, BenchProblem};
use crate::cancel::is_cancelled;
use crate::text::on_one_line;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A step of a test, or a log: files that share a clock.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// What it is called.
    pub name: String,
    /// Number of the step, for files of one channel each.
    pub step: Option<u64>,
    /// The files; of a log, one, whose header says what it has.
    pub files: Vec<LogFile>,
}

/// A file, and what it has if its name says so.
pub type LogFile = (PathBuf, Option<StepChannel>);

/// A folder and the number of a step.
type Step = (PathBuf, u64);

/// A time window of a log.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Run {
    /// Name of the file, without `.gz`.
    pub file: String,
    /// s.
    pub start: f64,
    /// s.
    pub end: f64,
}

/// What was read of one file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FileReport {
    /// Its path.
    pub file: String,
    /// Rows, good and bad.
    pub rows: u64,
    /// What was wrong with rows.
    pub faults: Faults,
    /// How often the counter of the time wrapped, and was taken on.
    pub time_wraps: u64,
    /// How often time jumped: a pause or a reset.
    pub time_jumps: u64,
    /// Why nothing, or not all of it, could be read.
    pub problem: Option<String>,
}

/// What became of a record.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RecordReport {
    /// What it is called.
    pub record: String,
    /// Its files.
    pub files: Vec<FileReport>,
    /// Uniform samples that came out.
    pub samples: u64,
    /// Gaps that were not bridged.
    pub gaps: u64,
    /// Points that are steady.
    pub steady: u64,
    /// Windows, or steps, that are not.
    pub unsteady: u64,
    /// Samples of windows too short to be averaged.
    pub left_over: u64,
    /// Largest number of samples in memory at once.
    pub resident: usize,
    /// Speeds over time for a figure, thinned: s, rpm of the primary, rpm of the secondary.
    #[serde(skip)]
    pub trace: Vec<(f64, f64, f64)>,
    /// Why the first window, or step, that is not steady is not.
    #[serde(skip)]
    pub reason: Option<String>,
    /// Files with torque in N·m to which a calibration that is given was not applied.
    #[serde(skip)]
    pub uncalibrated: Vec<String>,
    /// Columns that are read in another unit than their header has.
    #[serde(skip)]
    pub units: Vec<String>,
}

/// Files of a folder that are looked at.
const FILES: usize = 1_000_000;
/// Points of a trace.
const TRACE: usize = 2000;
/// Samples that a window has at least.
pub(super) const SAMPLES: usize = 20;
/// Share of a window that a shorter piece must have to be averaged.
const SHORTEST: f64 = 0.3;
/// Hops by which a window moves on where nothing is steady.
const HOPS: usize = 6;

/// Sorts files, and the files of folders, into records: files of one channel by folder and number, every other for
/// itself.
///
/// # Errors
/// A path that does not exist, or nothing that is a log.
pub fn records(paths: &[PathBuf]) -> Result<Vec<Record>, BenchError> {
    let mut steps: BTreeMap<Step, Vec<LogFile>> = BTreeMap::new();
    let mut logs = Vec::new();
    for path in paths {
        let metadata = std::fs::metadata(path).map_err(|error| BenchError::read(path, &error))?;
        let files = if metadata.is_dir() { folder(path)? } else { vec![path.clone()] };
        for file in files {
            let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            match step_file(name) {
                Some((kind, number)) => {
                    let parent = file.parent().map_or_else(PathBuf::new, Path::to_path_buf);
                    steps.entry((parent, number)).or_default().push((file, Some(kind)));
                }
                None => {
                    let name = on_one_line(&file.display().to_string());
                    logs.push(Record { name, step: None, files: vec![(file, None)] });
                }
            }
        }
    }
    let several = steps.keys().map(|(folder, _)| folder).collect::<std::collections::BTreeSet<_>>().len() > 1;
    let step = |((folder, number), mut files): (Step, Vec<LogFile>)| {
        files.sort();
        let shown = || on_one_line(&folder.display().to_string());
        let name = if several { format!("{} step {number}", shown()) } else { format!("step {number}") };
        Record { name, step: Some(number), files }
    };
    let mut records: Vec<Record> = steps.into_iter().map(step).collect();
    records.append(&mut logs);
    if records.is_empty() {
        let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
        let reason =
            "it has neither files such as P_0.csv, S_0.csv, ADC_0.csv, TORQUE_0.csv nor logs (.csv, .log, with or \
                      without .gz)"
                .into();
        return Err(BenchProblem::NoData { path: names.join(", "), reason }.into());
    }
    Ok(records)
}

/// Whether a file of this name in a folder is taken for a log.
pub fn is_log(name: &str) -> bool {
    let name = stem(name);
    let lower = name.to_ascii_lowercase();
    let extra = ["calibration", "engine", "cal_values", "tunes", "operating-points"];
    !extra.iter().any(|word| lower.starts_with(word)) && (lower.ends_with(".csv") || lower.ends_with(".log"))
}

/// The files of a folder that can be logs, in the order of their names.
fn folder(path: &Path) -> Result<Vec<PathBuf>, BenchError> {
    let entries = std::fs::read_dir(path).map_err(|error| BenchError::read(path, &error))?;
    let log = |path: &PathBuf| path.is_file() && path.file_name().and_then(|name| name.to_str()).is_some_and(is_log);
    let mut files: Vec<PathBuf> =
        entries.take(FILES).filter_map(|entry| entry.ok().map(|entry| entry.path())).filter(log).collect();
    files.sort();
    Ok(files)
}

/// Reads time windows of logs: a table with the columns `logfile`, `t_start` and `t_end` in ms, others aside.
///
/// # Errors
/// A file that cannot be read, a header without these columns, a row without them.
pub fn runs(path: &Path) -> Result<Vec<Run>, BenchError> {
    let bytes = std::fs::read(path).map_err(|error| BenchError::read(path, &error))?;
    parse_runs(&path.display().to_string(), &bytes)
}

pub(super) fn parse_runs(path: &str, bytes: &[u8]) -> Result<Vec<Run>, BenchError> {
    let mut places: Option<[usize; 3]> = None;
    let mut runs = Vec::new();
    for (line, text) in (1_u64..).zip(bytes.split(|byte| *byte == b'\n')).take(FILES) {
        let bad =
            |reason: &str| BenchError::from(BenchProblem::Line { path: path.into(), line, reason: reason.into() });
        let text = std::str::from_utf8(text).map_err(|_| bad("this is no text"))?;
        let text = text.trim_start_matches('\u{feff}').trim();
        if text.is_empty() {
            continue;
        }
        let cells = cells::texts(text);
        let Some([file, start, end]) = places else {
            let place = |name: &str| cells.iter().position(|cell| cell == name);
            match (place("logfile"), place("t_start"), place("t_end")) {
                (Some(file), Some(start), Some(end)) => places = Some([file, start, end]),
                _ => return Err(bad("expected a header with the columns logfile, t_start and t_end")),
            }
            continue;
        };
        let number = |at: usize| cells.get(at)?.parse::<f64>().ok().filter(|value| value.is_finite());
        match (cells.get(file), number(start), number(end)) {
            (Some(file), Some(start), Some(end)) if start < end => {
                let (file, start, end) = (stem(file).to_owned(), 1e-3 * start, 1e-3 * end);
                let same = |run: &&Run| run.file == file && start < run.end && run.start < end;
                if let Some(Run { start, end, .. }) = runs.iter().find(same) {
                    return Err(bad(&format!(
                        "this window of `{file}` overlaps that from {:.0} to {:.0} ms: expected windows apart",
                        1e3 * start,
                        1e3 * end
                    )));
                }
                runs.push(Run { file, start, end });
            }
            _ => return Err(bad("expected the name of a log, and its beginning and end in ms")),
        }
    }
    Ok(runs)
}

/// The name of a file without the ending of a compressed one.
fn stem(name: &str) -> &str {
    without(name, ".gz").unwrap_or(name)
}

/// Whether a file is the one that a table of runs names.
pub(super) fn is_of(run: &Run, path: &Path) -> bool {
    path.file_name().and_then(|name| name.to_str()).is_some_and(|name| stem(name) == stem(&run.file))
}

/// Reads a record and hands on every point: steady ones, and of steps every one. `progress` hears of bytes that were
/// read.
///
/// What is wrong with a file stands in the report, and loses nothing else.
///
/// # Errors
/// [`BenchProblem::Cancelled`].
pub fn process(
    record: &Record,
    options: &Options,
    mut take: impl FnMut(SteadyPoint),
    mut progress: impl FnMut(u64),
) -> Result<RecordReport, BenchError> {
    let mut report = RecordReport {
        record: record.name.clone(),
        files: Vec::new(),
        samples: 0,
        gaps: 0,
        steady: 0,
        unsteady: 0,
        left_over: 0,
        resident: 0,
        trace: Vec::new(),
        reason: None,
        uncalibrated: Vec::new(),
        units: Vec::new(),
    };
    let has = |channel: StepChannel| record.files.iter().any(|(_, kind)| *kind == Some(channel));
    let mut streams: Vec<(String, Stream)> = Vec::new();
    for (path, kind) in &record.files {
        let skip = match kind {
            // One of the two torques: the raw one with a calibration, the converted one without.
            Some(StepChannel::Converter) => options.calibration.is_none() && has(StepChannel::Torque),
            Some(StepChannel::Torque) => options.calibration.is_some() && has(StepChannel::Converter),
            Some(StepChannel::Primary | StepChannel::Secondary) | None => false,
        };
        if skip {
            continue;
        }
        match open(path, *kind, options) {
            Ok(stream) => {
                let torque = stream.channels().any(|channel| channel == Channel::Torque);
                if options.calibration.is_some() && torque && !stream.raw() {
                    report.uncalibrated.push(path.display().to_string());
                }
                // A factor says what the column of the secondary has.
                let told = options.secondary_factor != 1.0;
                let units = stream.units().iter().filter(|(channel, _)| *channel != Channel::Secondary || !told);
                report.units.extend(units.map(|(_, words)| words.clone()));
                streams.push((path.display().to_string(), stream));
            }
            Err(problem) => report.files.push(FileReport {
                file: path.display().to_string(),
                rows: 0,
                faults: Faults::default(),
                time_wraps: 0,
                time_jumps: 0,
                problem: Some(problem),
            }),
        }
    }
    merge(record, &mut streams, options, &mut report, &mut take, &mut progress)?;
    for (file, stream) in streams {
        let (time_wraps, time_jumps) = stream.turns();
        let problem = stream.broken().map(str::to_owned);
        let (rows, faults) = (stream.rows(), stream.faults().clone());
        report.files.push(FileReport { file, rows, faults, time_wraps, time_jumps, problem });
    }
    Ok(report)
}

fn open(path: &Path, kind: Option<StepChannel>, options: &Options) -> Result<Stream, String> {
    let said = |error: std::io::Error| error.to_string();
    let mut lines = Lines::open(path).map_err(said)?;
    let format: Format = match kind {
        Some(kind) => kind.format(),
        None => match lines.next_line().map_err(said)? {
            Some(Line::Text(_, text)) => header(text, &options.names, options.calibration.is_some())?,
            Some(Line::TooLong(_)) => return Err("its first line is longer than any header".into()),
            None => return Err("it is empty".into()),
        },
    };
    if format.columns.iter().any(|column| column.raw) && options.calibration.is_none() {
        return Err("its torque is raw: a calibration is needed (--calibration)".into());
    }
    if options.runs.is_empty() || kind.is_some() {
        return Ok(Stream::new(lines, format, (f64::NEG_INFINITY, f64::INFINITY)));
    }
    let windows: Vec<_> = options.runs.iter().filter(|run| is_of(run, path)).map(|run| (run.start, run.end)).collect();
    if windows.is_empty() {
        return Err("it is not in the table of runs".into());
    }
    Ok(Stream::over(lines, format, windows))
}

/// Samples of all files in the order of time, made uniform and cut into windows.
fn merge(
    record: &Record,
    streams: &mut [(String, Stream)],
    options: &Options,
    report: &mut RecordReport,
    take: &mut impl FnMut(SteadyPoint),
    progress: &mut impl FnMut(u64),
) -> Result<(), BenchError> {
    let mut heads: Vec<Option<Sample>> = streams.iter_mut().map(|(_, stream)| stream.next_sample()).collect();
    same_turn(streams, &mut heads);
    let mut present = [false; CHANNELS];
    // What a log has is known from the first of its rows that have anything.
    for (_, stream) in streams.iter() {
        for channel in stream.channels() {
            present.iter_mut().skip(channel as usize).take(1).for_each(|there| *there = true);
        }
    }
    let mut uniform = Uniform::new(present, options.rate, options.longest_gap);
    let mut windows = Windows::new(record, options, present);
    let (mut rows, mut count, mut told) = (Vec::new(), 0_u64, 0_u64);
    loop {
        let first = heads.iter().enumerate().filter_map(|(at, head)| Some((at, (*head)?.time)));
        let Some((at, _)) = first.min_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        let Some((_, stream)) = streams.get_mut(at) else { break };
        let Some(sample) = heads.get_mut(at).and_then(|head| std::mem::replace(head, stream.next_sample())) else {
            break;
        };
        uniform.push(calibrated(sample, stream, options), &mut rows);
        for row in rows.drain(..) {
            windows.push(row, report, take);
        }
        count += 1;
        if count.is_multiple_of(4096) {
            let bytes = streams.iter().map(|(_, stream)| stream.bytes()).sum::<u64>();
            progress(bytes - told);
            told = bytes;
        }
        let resident = streams.iter().map(|(_, stream)| stream.resident()).sum::<usize>();
        report.resident = report.resident.max(resident + uniform.resident + windows.resident());
    }
    if is_cancelled() {
        return Err(BenchProblem::Cancelled.into());
    }
    windows.end(report, take);
    report.gaps = uniform.gaps;
    report.trace = windows.trace;
    progress(streams.iter().map(|(_, stream)| stream.bytes()).sum::<u64>() - told);
    Ok(())
}

/// Counters of several files that share a clock may begin on both sides of its wrap.
fn same_turn(streams: &mut [(String, Stream)], heads: &mut [Option<Sample>]) {
    let latest = heads.iter().flatten().map(|head| head.time).fold(f64::NEG_INFINITY, f64::max);
    for ((_, stream), head) in streams.iter_mut().zip(heads) {
        if let Some(sample) = head
            && latest - sample.time > 0.5 * stream.period()
        {
            stream.shift = stream.period();
            sample.time += stream.shift;
        }
    }
}

fn calibrated(sample: Sample, stream: &Stream, options: &Options) -> Sample {
    match options.calibration {
        Some(line) if sample.channel == Channel::Torque && stream.raw() => {
            Sample { value: line.inverse(sample.value), ..sample }
        }
        _ => sample,
    }
}

/// Cuts uniform samples into windows.
struct Windows<'a> {
    record: &'a Record,
    options: &'a Options,
    present: [bool; CHANNELS],
    start: f64,
    samples: [Vec<f64>; CHANNELS],
    /// How many samples each channel had measured for each of the uniform ones.
    measured: Vec<[usize; CHANNELS]>,
    length: usize,
    trace: Vec<(f64, f64, f64)>,
    stride: u64,
}

impl<'a> Windows<'a> {
    fn new(record: &'a Record, options: &'a Options, present: [bool; CHANNELS]) -> Self {
        let length = ((options.window * options.rate).round() as usize).max(SAMPLES);
        let (samples, measured, trace) = (Default::default(), Vec::new(), Vec::new());
        Self { record, options, present, start: 0.0, samples, measured, length, trace, stride: 1 }
    }

    fn count(&self) -> usize {
        self.samples.iter().map(Vec::len).max().unwrap_or(0)
    }

    fn resident(&self) -> usize {
        self.samples.iter().map(Vec::len).sum()
    }

    fn push(&mut self, row: Row, report: &mut RecordReport, take: &mut impl FnMut(SteadyPoint)) {
        match row {
            Row::Values(time, values, measured) => {
                if self.count() == 0 {
                    self.start = time;
                }
                for ((samples, value), present) in self.samples.iter_mut().zip(values).zip(self.present) {
                    if present {
                        samples.push(value);
                    }
                }
                self.measured.push(measured);
                self.draw(time, values, report.samples);
                report.samples += 1;
                if self.count() >= self.length {
                    self.full(report, take);
                }
            }
            Row::Gap if self.record.step.is_some() => {} // a step is one point, whatever of it is missing
            Row::Gap => self.end(report, take),
        }
    }

    fn draw(&mut self, time: f64, [primary, secondary, _]: [f64; CHANNELS], number: u64) {
        if !number.is_multiple_of(self.stride) {
            return;
        }
        self.trace.push((time, primary, secondary * self.options.secondary_factor));
        if self.trace.len() > 2 * TRACE {
            let mut at = 0;
            self.trace.retain(|_| {
                at += 1;
                at % 2 == 1
            });
            self.stride *= 2;
        }
    }

    fn point(&self) -> SteadyPoint {
        let mut measured = [0; CHANNELS];
        for of_row in &self.measured {
            measured.iter_mut().zip(of_row).for_each(|(sum, count)| *sum += count);
        }
        SteadyPoint::of(&self.record.name, self.record.step, self.start, (&self.samples, measured), self.options)
    }

    fn full(&mut self, report: &mut RecordReport, take: &mut impl FnMut(SteadyPoint)) {
        let point = self.point();
        if point.steady || self.record.step.is_some() {
            self.hand_on(point, report, take);
            return;
        }
        let hop = (self.length / HOPS).max(1);
        report.unsteady += 1;
        report.reason = report.reason.take().or(point.reason);
        self.samples.iter_mut().for_each(|samples| {
            samples.drain(..hop.min(samples.len()));
        });
        self.measured.drain(..hop.min(self.measured.len()));
        self.start += hop as f64 / self.options.rate;
    }

    fn hand_on(&mut self, point: SteadyPoint, report: &mut RecordReport, take: &mut impl FnMut(SteadyPoint)) {
        *(if point.steady { &mut report.steady } else { &mut report.unsteady }) += 1;
        if !point.steady {
            report.reason = report.reason.take().or_else(|| point.reason.clone());
        }
        take(point);
        self.clear();
    }

    fn clear(&mut self) {
        self.samples.iter_mut().for_each(Vec::clear);
        self.measured.clear();
    }

    /// What is left at a gap, or at the end.
    fn end(&mut self, report: &mut RecordReport, take: &mut impl FnMut(SteadyPoint)) {
        let least = ((SHORTEST * self.length as f64).ceil() as usize).max(SAMPLES);
        if self.count() >= least {
            let point = self.point();
            if point.steady || self.record.step.is_some() {
                self.hand_on(point, report, take);
                return;
            }
            report.reason = report.reason.take().or(point.reason);
        } else if self.record.step.is_some() && self.count() > 0 && report.steady + report.unsteady == 0 {
            // All that there is of a step: it is told, with what it lacks.
            let seconds = |samples: usize| samples as f64 / self.options.rate;
            let reason = format!(
                "it is too short: {} samples, {:.2} s, and a window of {} s takes {least} samples, {:.2} s, at least \
                 (--window)",
                self.count(),
                seconds(self.count()),
                self.options.window,
                seconds(least)
            );
            let point = SteadyPoint { steady: false, reason: Some(reason), ..self.point() };
            self.hand_on(point, report, take);
            return;
        }
        report.left_over += self.count() as u64;
        self.clear();
    }
}
