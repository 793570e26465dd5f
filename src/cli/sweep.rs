//! `sheave sweep`: one case over a grid of its keys.

use super::case::CaseArguments;
use super::keeping;
use super::output;
use super::solve::jobs;
use super::stop::Stop;
use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sheave::drive::{SolveOptions, WORK_LIMIT};
use sheave::study::{Axis, Format, Journal, JournalError, Row, StoredRows, Stream, Study, StudyError};
use std::io::{self, IsTerminal};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Solve a case over a grid of any of its keys
///
/// One row a point, in input order, the last --over fastest: the varied keys, `converged`, every scalar of the result
/// in SI units with dots in its name, `failure`. A point without a solution keeps its row and says why. Rows depend on
/// the grid alone, not on --jobs; `solver.wall_time` stays empty.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Vary a key: KEY=FROM..TO[:N] (11 points if N is not given) or KEY=A,B,C; joined by & keys go together. A section
    /// [sweep] of the case file, over = ["..", ".."], says the same
    #[arg(long, value_name = "KEY=VALUES")]
    over: Vec<String>,
    /// Threads, no more of which are started than there are cores [default: all cores]
    #[arg(long, value_name = "N", value_parser = jobs)]
    jobs: Option<NonZeroUsize>,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = super::solve::tolerance)]
    tol: f64,
    /// Work that each point may take: Newton iterations, each counted once for every mesh interval
    #[arg(long, value_name = "N", default_value_t = WORK_LIMIT, value_parser = super::solve::work_limit)]
    work_limit: usize,
    /// Write the table into this file: .csv, .parquet or .json. Rows are kept as they come in FILE.journal beside it
    /// until the table is whole; an earlier table is kept as FILE.old.1. Without it, CSV goes to standard output as
    /// rows come
    #[arg(long, value_name = "FILE", value_parser = table_path)]
    out: Option<PathBuf>,
    /// Go on with a sweep that was ended: rows in FILE.journal are not solved again
    #[arg(long, requires = "out")]
    resume: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let out = arguments.out.as_deref().map(output::place).transpose()?;
    let study = arguments.study()?;
    let jobs = arguments.jobs.map(NonZeroUsize::get);
    let failures = match out {
        Some(path) => {
            let table = fill(arguments.journal(&path, &study)?, &study, jobs)?;
            deliver(&table, &path)?;
            let failures = table.failures();
            table.remove().map_err(|error| Stop::Write(format!("(remove) {}.journal", path.display()), error))?;
            failures
        }
        None if study.is_uniform() => streamed(&study, jobs)?,
        None => {
            let journal = Journal::nameless(&study).map_err(|error| Stop::Write("a temporary file".into(), error))?;
            let table = fill(journal, &study, jobs)?;
            let written = Format::Csv.write(&table, &mut io::stdout());
            written.map_err(|error| Stop::Write("standard output".into(), error))?;
            table.failures()
        }
    };
    match failures {
        0 => Ok(()),
        all if all == study.points() => {
            Err(Stop::NoSolution(format!("none of the {all} points has a solution; `failure` says why")))
        }
        some => {
            tracing::warn!("{some} of {} points have no solution; see `failure`", study.points());
            Ok(())
        }
    }
}

/// Rows to standard output as they come; gives the number of points without a solution.
fn streamed(study: &Study, jobs: Option<usize>) -> Result<usize, Stop> {
    let progress = progress(study.points(), 0, "");
    let stream = Mutex::new(Stream::new(study, io::stdout()));
    let stopped = |error| match error {
        StudyError::Keep(error) => Stop::Write("standard output".into(), error),
        other => other.into(),
    };
    let keep = |row: Row| {
        stream.lock().unwrap_or_else(PoisonError::into_inner).add(row)?;
        progress.inc(1);
        Ok(())
    };
    sheave::study::run(study, jobs, |_| true, keep).map_err(stopped)?;
    progress.finish_and_clear();
    let stream = stream.into_inner().unwrap_or_else(PoisonError::into_inner);
    let failures = stream.failures();
    stream.finish().map_err(|error| Stop::Write("standard output".into(), error))?;
    Ok(failures)
}

impl Arguments {
    fn study(&self) -> Result<Study, StudyError> {
        let (case, mut axes) = self.case.read_study()?;
        let given = self.over.iter().map(|over| Axis::parse(over)).collect::<Result<Vec<_>, _>>()?;
        // What the command line varies is not varied by the file as well.
        axes.retain(|axis| !given.iter().any(|other| other.keys().iter().any(|key| axis.keys().contains(key))));
        axes.extend(given);
        let (tolerance, work_limit) = (self.tol, self.work_limit);
        Study::new(case, axes, SolveOptions { tolerance, work_limit, ..SolveOptions::default() })
    }

    fn journal(&self, out: &Path, study: &Study) -> Result<Journal, Stop> {
        let mut name = out.as_os_str().to_owned();
        name.push(".journal");
        let path = PathBuf::from(name);
        let begun = if self.resume {
            Journal::resume(&path, study)
        } else {
            Journal::begin(&path, study).map(|(journal, aside)| {
                if let Some(old) = aside {
                    let (path, old) = (path.display(), old.display());
                    tracing::warn!(
                        "{path} of a sweep that was ended before is now {old}; with --resume it would have been \
                        completed"
                    );
                }
                journal
            })
        };
        let journal = begun.map_err(|error| match error {
            JournalError::System { path, error } => Stop::Write(path, error),
            other => Stop::Usage(other.to_string()),
        })?;
        for line in journal.damaged() {
            tracing::warn!("{}, line {line} is damaged and passed over: its point is solved again", path.display());
        }
        Ok(journal)
    }
}

/// Solves what the journal does not have, and gives its rows.
fn fill(journal: Journal, study: &Study, jobs: Option<usize>) -> Result<StoredRows, Stop> {
    let there: Vec<bool> = (0..study.points()).map(|index| journal.has(index)).collect();
    let progress = progress(study.points(), journal.len(), "; Ctrl-C, then --resume");
    let journal = Mutex::new(journal);
    let keep = |row: Row| -> io::Result<()> {
        journal.lock().unwrap_or_else(PoisonError::into_inner).add(row)?;
        progress.inc(1);
        Ok(())
    };
    sheave::study::run(study, jobs, |index| !there.get(index).copied().unwrap_or(false), keep)?;
    progress.finish_and_clear();
    let journal = journal.into_inner().unwrap_or_else(PoisonError::into_inner);
    journal.finish().map_err(|error| Stop::Write("the journal".into(), error))
}

/// Writes the table. One of an earlier sweep that says something else is kept under another name.
fn deliver(table: &StoredRows, path: &Path) -> Result<(), Stop> {
    let format = Format::of(path).unwrap_or(Format::Csv);
    let aside = keeping::deliver(path, |to| format.write(table, to))?;
    aside.iter().for_each(|warning| tracing::warn!("{warning}"));
    Ok(())
}

/// On standard error, and only for people to see.
fn progress(points: usize, done: usize, hint: &str) -> ProgressBar {
    let target = if io::stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
    let bar = ProgressBar::with_draw_target(Some(points as u64), target).with_position(done as u64);
    bar.reset_eta();
    match ProgressStyle::with_template(&format!("{{bar:20}} {{pos}}/{{len}} points, {{per_sec}}, {{eta}} left{hint}")) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

fn table_path(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match Format::of(&path) {
        Some(_) => Ok(path),
        None => Err("expected a file name that ends in .csv, .parquet or .json".into()),
    }
}
