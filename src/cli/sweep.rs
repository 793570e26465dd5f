//! `sheave sweep`: one case over a grid of its keys.

use super::case::CaseArguments;
use super::output;
use super::stop::Stop;
use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use sheave::drive::SolveOptions;
use sheave::study::{Axis, Format, Journal, JournalError, Row, Study, StudyError, Table};
use std::io::{self, IsTerminal};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Solve a case over a grid of any of its keys
///
/// One row a point, in input order, the last --over fastest: the varied keys, `converged`, every scalar of the result in
/// SI units with dots in its name, `failure`. A point without a solution keeps its row and says why. Rows depend on the
/// grid alone, not on --jobs; `solver.wall_time` stays empty.
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Vary a key: KEY=FROM..TO[:N] (11 points if N is not given) or KEY=A,B,C; joined by & keys go together. A section
    /// [sweep] of the case file, over = ["..", ".."], says the same
    #[arg(long, value_name = "KEY=VALUES")]
    over: Vec<String>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-6", value_parser = super::solve::tolerance)]
    tol: f64,
    /// Write the table into this file: .csv, .parquet or .json. Rows are kept as they come in FILE.journal beside it
    /// until the table is whole. Without it, CSV goes to standard output
    #[arg(long, value_name = "FILE", value_parser = table_path)]
    out: Option<PathBuf>,
    /// Go on with a sweep that was ended: rows in FILE.journal are not solved again
    #[arg(long, requires = "out")]
    resume: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let study = arguments.study()?;
    let jobs = arguments.jobs.map(NonZeroUsize::get);
    match &arguments.out {
        None => {
            let progress = progress(study.points(), 0, "");
            let rows = Mutex::new(sheave::study::TableBuilder::new(study.points()));
            sheave::study::run(
                &study,
                jobs,
                |_| true,
                |row| {
                    rows.lock().unwrap_or_else(PoisonError::into_inner).insert(row);
                    progress.inc(1);
                    Ok(())
                },
            )?;
            progress.finish_and_clear();
            deliver(&rows.into_inner().unwrap_or_else(PoisonError::into_inner).finish(), None)
        }
        Some(path) => {
            let journal = arguments.journal(path, &study)?;
            let (table, used) = fill(journal, &study, jobs)?;
            deliver(&table, Some(path))?;
            std::fs::remove_file(&used).map_err(|error| Stop::Write(used.display().to_string(), error))
        }
    }
}

impl Arguments {
    fn study(&self) -> Result<Study, StudyError> {
        let (case, mut axes) = self.case.read_study()?;
        let given = self.over.iter().map(|over| Axis::parse(over)).collect::<Result<Vec<_>, _>>()?;
        // What the command line varies is not varied by the file as well.
        axes.retain(|axis| !given.iter().any(|other| other.keys().iter().any(|key| axis.keys().contains(key))));
        axes.extend(given);
        Study::new(case, axes, SolveOptions { tolerance: self.tol, ..SolveOptions::default() })
    }

    fn journal(&self, out: &Path, study: &Study) -> Result<Journal, Stop> {
        let mut name = out.as_os_str().to_owned();
        name.push(".journal");
        let path = PathBuf::from(name);
        let journal = if self.resume {
            Journal::resume(&path, study)
        } else {
            set_aside(&path)?;
            Journal::begin(&path, study)
        };
        journal.map_err(|error| match error {
            JournalError::System { path, error } => Stop::Write(path, error),
            other => Stop::Usage(other.to_string()),
        })
    }
}

/// Keeps the journal of a sweep that was ended before, which would be overwritten.
fn set_aside(path: &Path) -> Result<(), Stop> {
    let mut old = path.as_os_str().to_owned();
    old.push(".old");
    match std::fs::rename(path, &old) {
        Ok(()) => {
            let (path, old) = (path.display(), Path::new(&old).display());
            tracing::warn!("{path} of a sweep that was ended before is now {old}; --resume completes such a one");
            Ok(())
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(Stop::Write(path.display().to_string(), error)),
    }
}

/// Solves what the journal does not have; gives the table and the journal that is no longer needed.
fn fill(journal: Journal, study: &Study, jobs: Option<usize>) -> Result<(Table, PathBuf), Stop> {
    let there: Vec<bool> = (0..study.points()).map(|index| journal.rows().has(index)).collect();
    let progress = progress(study.points(), journal.rows().len(), "; Ctrl-C, then --resume");
    let journal = Mutex::new(journal);
    let keep = |row: Row| -> io::Result<()> {
        journal.lock().unwrap_or_else(PoisonError::into_inner).add(row)?;
        progress.inc(1);
        Ok(())
    };
    sheave::study::run(study, jobs, |index| !there.get(index).copied().unwrap_or(false), keep)?;
    progress.finish_and_clear();
    let (rows, path) = journal.into_inner().unwrap_or_else(PoisonError::into_inner).finish();
    Ok((rows.finish(), path))
}

fn deliver(table: &Table, out: Option<&Path>) -> Result<(), Stop> {
    match table.failures() {
        0 => {}
        failures => tracing::warn!("{failures} of {} points have no solution; see `failure`", table.rows.len()),
    }
    let Some(path) = out else {
        let mut text = Vec::new();
        let written = Format::Csv.write(table, &mut text);
        written.map_err(|error| Stop::Write("CSV".into(), error))?;
        return output::print(&String::from_utf8_lossy(&text));
    };
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let format = Format::of(path).unwrap_or(Format::Csv);
    output::write_file(folder, &name, |to| format.write(table, to))
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
